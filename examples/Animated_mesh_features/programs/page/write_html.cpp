// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/write_html.h"

#include "page/Html_scene.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

namespace Programs {

namespace {

// Where the viewer's page has its scene.
constexpr std::string_view scene_marker = "<!--scene-->";

} // namespace

Html_report write_html(std::ostream& os, const Shown_scene& scene, std::string_view page, const Html_options& options)
{
  check_scene(scene);
  const std::size_t place = page.find(scene_marker);
  if (place == std::string_view::npos)
    throw CGAL::Animated_mesh_features::Option_error("the page has no place for a scene: it is not the viewer");
  Html_report report;
  const Html_sampling sampling =
      html_sampling(scene.sequence.number_of_vertices(), scene.sequence.number_of_frames(), options);
  const Html_scene html(scene, sampling, options);
  report.vertices = html.number_of_vertices();
  report.frame_step = sampling.frame_step;
  report.largest_error = html.largest_error();
  os.write(page.data(), static_cast<std::streamsize>(place));
  html.write(os);
  page.remove_prefix(place + scene_marker.size());
  os.write(page.data(), static_cast<std::streamsize>(page.size()));
  return report;
}

} // namespace Programs
