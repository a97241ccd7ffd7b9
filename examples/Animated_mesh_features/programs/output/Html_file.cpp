// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Html_file.h"

#include "output/Viewer_page.h"
#include "page/Html_options.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#ifdef DETECT_FEATURES_WITH_VIEWER
  #include "page/write_html.h"
#endif

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

Html_options html_options(const Output_options& o)
{
  Html_options options;
  options.frame_step = o.html_frame_step;
  options.view = o.picture.view;
  options.up_axis = o.picture.up_axis;
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
  Html_file(const std::string& path, const Output_options& o)
    : m_file(path, o.sync())
    , m_options(html_options(o))
  {}

  void write(const Shown_scene& scene) override
  {
    write_html(m_file.stream(), scene, viewer_page(), m_options);
    m_file.stream().flush();
    m_file.check();
  }
  void commit() override { m_file.commit(); }

private:
  AMF::IO::Output_file m_file;
  Html_options m_options;
};
#endif

} // namespace

std::string html_notice(const Output_options& o, std::size_t number_of_vertices, std::size_t number_of_frames)
{
  if (!o.has_scene(Scene_format::HTML)) return std::string();
  check_viewer();
  Html_sampling sampling;
  try {
    sampling = html_sampling(number_of_vertices, number_of_frames, html_options(o));
  } catch (const AMF::Option_error& e) {
    throw AMF::Option_error("--html: " + std::string(e.what()) +
                            ": --html-every N takes every N-th frame, 1 all of them");
  }
  const bool has_all_vertices = sampling.vertices >= number_of_vertices;
  if (o.html_frame_step != 0 || (has_all_vertices && sampling.frame_step <= 1)) return std::string();
  std::string text = "--html: the page has ";
  if (!has_all_vertices)
    text += std::to_string(sampling.vertices) + " of " + std::to_string(number_of_vertices) + " vertices";
  if (!has_all_vertices && sampling.frame_step > 1) text += " and ";
  if (sampling.frame_step > 1) text += "1 of " + std::to_string(sampling.frame_step) + " frames";
  return text + ", so that it stays small enough for a browser; --html-every 1 takes all of them\n";
}

std::unique_ptr<Scene_file> open_html_file(const std::string& path, const Output_options& o)
{
  check_viewer();
#ifdef DETECT_FEATURES_WITH_VIEWER
  return std::make_unique<Html_file>(path, o);
#else
  (void)path;
  (void)o;
  return nullptr;
#endif
}

} // namespace Programs
