// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Pair_page.h"

#include "output/Viewer_page.h"
#include "page/Html_options.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#ifdef DETECT_FEATURES_WITH_VIEWER
  #include "page/write_html.h"

  #include <sstream>
#endif

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

void check_pair_page()
{
  const std::string reason = missing_viewer();
  if (!reason.empty()) throw AMF::Option_error("--html: this program was built without the viewer: " + reason);
}

void check_pair_page(std::size_t number_of_vertices, std::size_t number_of_frames)
{
  try {
    html_sampling(number_of_vertices, number_of_frames, half_of_page(Html_options()));
  } catch (const AMF::Option_error&) {
    throw AMF::Option_error("--html: " + std::to_string(number_of_vertices) + " vertices in " +
                            std::to_string(number_of_frames) +
                            " frames are too many for a page of two animations; simplify_animation makes them fewer, "
                            "--frames takes a part of them");
  }
}

std::string pair_page([[maybe_unused]] const Shown_scene& a, [[maybe_unused]] const Shown_scene& b,
                      [[maybe_unused]] const nlohmann::ordered_json& comparison)
{
  check_pair_page();
#ifdef DETECT_FEATURES_WITH_VIEWER
  std::ostringstream os;
  write_html_pair(os, a, b, comparison, viewer_page());
  return os.str();
#else
  return std::string();
#endif
}

} // namespace Programs
