// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Html_file.h"

#include "page/Html_options.h"
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#ifdef DETECT_FEATURES_WITH_VIEWER
  #include "page/write_html.h"
#endif

#include <algorithm>
#include <iostream>
#include <string_view>

namespace AMF = CGAL::Animated_mesh_features;

namespace Detect_features {

#ifdef DETECT_FEATURES_WITH_VIEWER
// The viewer's page, from viewer_page.cpp, which the build makes; or why there is none.
extern const unsigned char viewer_page_bytes[];
extern const std::size_t viewer_page_size;
extern const char* const viewer_page_missing;
#endif

std::string missing_viewer()
{
#ifdef DETECT_FEATURES_WITH_VIEWER
  return viewer_page_missing;
#else
  return "zlib was missing, or the viewer switched off";
#endif
}

namespace {

Programs::Html_options html_options(std::size_t frame_step)
{
  Programs::Html_options options;
  options.frame_step = frame_step;
  return options;
}

void check_viewer()
{
  const std::string reason = missing_viewer();
  if (!reason.empty()) throw AMF::Option_error("--html: this program was built without the viewer: " + reason);
}

#ifdef DETECT_FEATURES_WITH_VIEWER
class Html_file : public Scene_file
{
public:
  Html_file(const std::string& path, std::size_t frame_step)
    : m_file(path)
    , m_frame_step(frame_step)
  {}

  void write(const Shown_scene& scene) override
  {
    const std::string_view page(reinterpret_cast<const char*>(viewer_page_bytes), viewer_page_size);
    Programs::write_html(m_file.stream(), scene, page, html_options(m_frame_step));
    m_file.stream().flush();
    m_file.check();
  }
  void commit() override { m_file.commit(); }

private:
  AMF::IO::Output_file m_file;
  std::size_t m_frame_step;
};
#endif

} // namespace

void check_html(const Command_line& c, std::size_t number_of_vertices, std::size_t number_of_frames)
{
  const bool is_wanted =
      std::any_of(c.scenes.begin(), c.scenes.end(), [](const auto& s) { return s.kind == Scene_format::HTML; });
  if (!is_wanted) return;
  check_viewer();
  std::size_t step = 0;
  try {
    step = Programs::html_frame_step(number_of_vertices, number_of_frames, html_options(c.html_frame_step));
  } catch (const AMF::Option_error& e) {
    throw AMF::Option_error("--html: " + std::string(e.what()) +
                            ": --html-every N takes every N-th frame, 1 all of them");
  }
  if (step > 1 && c.html_frame_step == 0 && !c.quiet)
    std::cerr << "--html: the page has 1 of " << step
              << " frames, so that it stays small enough for a browser; --html-every 1 takes all of them" << std::endl;
}

std::unique_ptr<Scene_file> open_html_file(const std::string& path, std::size_t frame_step)
{
  check_viewer();
#ifdef DETECT_FEATURES_WITH_VIEWER
  return std::make_unique<Html_file>(path, frame_step);
#else
  (void)path;
  (void)frame_step;
  return nullptr;
#endif
}

} // namespace Detect_features
