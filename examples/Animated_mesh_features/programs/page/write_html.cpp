// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/write_html.h"

#include "page/Html_scene.h"
#include "page/write_json_script.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <nlohmann/json.hpp>

namespace Programs {

namespace {

// Where the viewer's page has its scene.
constexpr std::string_view scene_marker = "<!--scene-->";

// Writes the page with, in the place of its scene, what `write_scenes(stream)` writes.
template <class Write_scenes>
void write_page(std::ostream& os, std::string_view page, const Write_scenes& write_scenes)
{
  const std::size_t place = page.find(scene_marker);
  if (place == std::string_view::npos)
    throw CGAL::Animated_mesh_features::Option_error("the page has no place for a scene: it is not the viewer");
  os.write(page.data(), static_cast<std::streamsize>(place));
  write_scenes(os);
  page.remove_prefix(place + scene_marker.size());
  os.write(page.data(), static_cast<std::streamsize>(page.size()));
}

// A scene as it goes into a page.
struct Page_scene
{
  Page_scene(const Shown_scene& scene, const Html_options& options)
    : sampling(html_sampling(scene.sequence.number_of_vertices(), scene.sequence.number_of_frames(), options))
    , html(scene, sampling, options)
  {}

  Html_report report() const { return {html.number_of_vertices(), sampling.frame_step, html.largest_error()}; }

  const Html_sampling sampling;
  const Html_scene html;
};

} // namespace

Html_report write_html(std::ostream& os, const Shown_scene& scene, std::string_view page, const Html_options& options)
{
  check_scene(scene);
  const Page_scene one(scene, options);
  write_page(os, page, [&](std::ostream& to) { one.html.write(to); });
  return one.report();
}

std::array<Html_report, 2> write_html_pair(std::ostream& os, const Shown_scene& a, const Shown_scene& b,
                                           const nlohmann::ordered_json& comparison, std::string_view page,
                                           const Html_options& options)
{
  check_scene(a);
  check_scene(b);
  const Page_scene first(a, half_of_page(options)), second(b, half_of_page(options));
  write_page(os, page, [&](std::ostream& to) {
    first.html.write(to);
    second.html.write(to, "scene-b");
    write_json_script(to, "comparison", comparison);
  });
  return {{first.report(), second.report()}};
}

} // namespace Programs
