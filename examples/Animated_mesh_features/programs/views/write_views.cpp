// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "views/write_views.h"

#include "views/Scene_views.h"

#include <CGAL/Animated_mesh_features/Applications/camera_path.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
typedef nlohmann::ordered_json Json;

namespace Programs {

namespace {

double rounded_to(double x, double digits)
{
  return std::round(x * digits) / digits + 0.; // no negative zeros
}

std::array<double, 3> coordinates(const Eigen::Vector3d& d)
{
  return {{rounded_to(d[0], 1e6), rounded_to(d[1], 1e6), rounded_to(d[2], 1e6)}};
}

Json camera(const Shown_scene& scene, const Scene_views& views)
{
  const auto& sequence = scene.sequence;
  const std::size_t n = sequence.number_of_frames(), most_frames = 32;
  const AMF::View_sphere sphere(2);
  std::vector<Eigen::Vector3d> directions;
  for (const Eigen::Vector3d& d : sphere.directions()) {
    const double elevation = AMF::view_angles(d, views.selection.up).elevation;
    if (elevation >= Scene_views::lowest_elevation && elevation <= Scene_views::highest_elevation)
      directions.push_back(d);
  }
  const std::vector<std::size_t> frames = AMF::even_frames(n, most_frames);
  const double step = sequence.frame_duration();
  const AMF::View_scores scores = AMF::score_views(
      sequence, frames, directions,
      AMF::Feature_view_score(sequence.rest_shape(), frames, n, step, scene.features, 0.5, scene.is_cyclic));
  AMF::Camera_path_options options;
  options.is_cyclic = scene.is_cyclic;
  const AMF::Camera_path path = AMF::camera_path(scores, sphere.longest_edge(), n, step, options);
  Json keys = Json::array();
  for (std::size_t i = 0; i < path.directions().size(); ++i) {
    const AMF::View_angles a = AMF::view_angles(path.directions()[i], views.selection.up);
    keys.push_back({{"time", rounded_to(double(i) * path.interval(), 1e6)},
                    {"azimuth", rounded_to(a.azimuth, 100)},
                    {"elevation", rounded_to(a.elevation, 100)},
                    {"direction", coordinates(path.directions()[i])}});
  }
  const double still = scores.score(scores.best([](const Eigen::Vector3d&) { return true; }));
  return {{"interval", rounded_to(path.interval(), 1e6)},
          {"score", rounded_to(path.score(), 1e4)},
          {"still", rounded_to(still, 1e4)},
          {"keys", std::move(keys)}};
}

} // namespace

void write_views(std::ostream& os, const Shown_scene& scene)
{
  std::optional<Scene_views> own;
  if (scene.views == nullptr) own = scene_views(scene, std::nullopt);
  const Scene_views& views = own ? *own : *scene.views;
  const double visible = views.selection.scores.covered_by_all();
  Json chosen = Json::array();
  for (const AMF::Selected_view& v : views.selection.views)
    chosen.push_back({{"rank", chosen.size() + 1},
                      {"azimuth", rounded_to(v.angles.azimuth, 100)},
                      {"elevation", rounded_to(v.angles.elevation, 100)},
                      {"direction", coordinates(v.direction)},
                      {"score", rounded_to(v.score, 1e4)},
                      {"covered", rounded_to(v.covered, 1e4)},
                      {"covered_of_visible", rounded_to(visible > 0 ? v.covered / visible : 0, 1e4)}});
  Json result = {{"format", "animated-mesh-features-views"},
                 {"version", 1},
                 {"up", coordinates(views.selection.up)},
                 {"score", scene.features.empty() ? "entropy" : "features"},
                 {"frames", views.selection.scores.frames()},
                 {"visible", rounded_to(visible, 1e4)},
                 {"views", std::move(chosen)}};
  if (!scene.features.empty()) result["camera"] = camera(scene, views);
  os << result.dump(2) << '\n';
}

} // namespace Programs
