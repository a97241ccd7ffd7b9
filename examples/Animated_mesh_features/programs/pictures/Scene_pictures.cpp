// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Scene_pictures.h"

#include "drawing/decimal.h"
#include "rendering/Palette.h"
#include "scenes/colour_scales.h"
#include "scenes/feature_in_frame.h"

#include <CGAL/Animated_mesh_features/Animation/outer_sides.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace Programs {

Scene_pictures::Scene_pictures(const Shown_scene& scene)
  : m_scene(scene)
  , m_places(relative_taus(scene.features))
{
  for (const auto& t : scene.sequence.rest_shape().triangles())
    m_triangles.push_back({{std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])}});
  std::vector<Eigen::Vector3d> rest;
  for (std::size_t i = 0; i < scene.sequence.number_of_vertices(); ++i)
    rest.push_back(scene.sequence.rest_shape().points()[shown_vertex(scene.sequence.rest_shape(), i)]);
  m_outer_sides = CGAL::Animated_mesh_features::outer_sides(rest, m_triangles);
  find_range_of_field();
  for (const Shown_feature& f : scene.features) {
    if (!(f.tau > 0)) continue;
    m_shortest = m_shortest > 0 ? (std::min)(m_shortest, f.tau) : f.tau;
    m_longest = (std::max)(m_longest, f.tau);
  }
}

Rendering::Surface Scene_pictures::surface(std::size_t frame) const
{
  Rendering::Surface s;
  const auto& animation = m_scene.sequence.trajectories();
  for (std::size_t i = 0; i < m_scene.sequence.number_of_vertices(); ++i) {
    const std::size_t v = shown_vertex(m_scene.sequence.rest_shape(), i);
    s.points.emplace_back(animation.x(v, frame), animation.y(v, frame), animation.z(v, frame));
  }
  s.triangles = m_triangles;
  s.outer_sides = m_outer_sides;
  s.normals = Rendering::vertex_normals(s.points, s.triangles);
  if (has_field())
    for (std::size_t v = 0; v < s.points.size(); ++v)
      s.values.push_back(float(((*m_scene.fields.front().values)(v, frame) - m_low) / (m_high - m_low)));
  return s;
}

std::vector<Rendering::Sphere> Scene_pictures::spheres(std::size_t frame) const
{
  const double step = m_scene.sequence.frame_duration();
  // What is inside of larger ones should be seen.
  const double largest_filled = 0.08 * m_scene.sequence.rest_shape().bounding_box_diagonal();
  std::vector<Rendering::Sphere> result;
  for (std::size_t i = 0; i < m_scene.features.size(); ++i) {
    const Shown_feature& f = m_scene.features[i];
    if (!lives_in_frame(f, frame, step, period(m_scene))) continue;
    const std::array<double, 3> p = position_in_frame(m_scene.sequence, f, frame);
    Rendering::Sphere s;
    s.centre = Eigen::Vector3d(p[0], p[1], p[2]);
    s.radius = f.radius();
    s.opacity = float(opacity_in_frame(f, frame, step, period(m_scene)));
    s.filling = float((std::min)(1., largest_filled / s.radius));
    s.colour = Rendering::duration_colours()(m_places[i]);
    s.is_dashed = f.at_scale_limit;
    s.rank = i + 1;
    result.push_back(s);
  }
  return result;
}

std::vector<Legend_bar> Scene_pictures::legend() const
{
  std::vector<Legend_bar> bars;
  if (has_field())
    bars.push_back({m_scene.fields.front().name, rounded(m_low, 2),
                    (m_is_cut ? "\xe2\x89\xa5 " : "") + rounded(m_high, 2), &Rendering::field_colours()});
  if (m_longest > 0)
    bars.push_back({"duration \xcf\x84", rounded(m_shortest, 2) + " s", rounded(m_longest, 2) + " s",
                    &Rendering::duration_colours()});
  return bars;
}

std::string Scene_pictures::label(std::size_t frame) const
{
  const long long hundredths = std::llround(100 * double(frame) * m_scene.sequence.frame_duration());
  const std::string places = std::to_string(100 + hundredths % 100).substr(1);
  return "frame " + std::to_string(frame) + "   " + std::to_string(hundredths / 100) + "." + places + " s";
}

double Scene_pictures::lowest(int axis) const
{
  const auto& animation = m_scene.sequence.trajectories();
  const auto& c = axis == 0 ? animation.x : axis == 1 ? animation.y : animation.z;
  double result = (std::numeric_limits<double>::max)();
  for (std::size_t i = 0; i < c.number_of_rows(); ++i) {
    const std::size_t v = shown_vertex(m_scene.sequence.rest_shape(), i);
    result = (std::min)(result, *std::min_element(c.row(v), c.row(v) + c.number_of_frames()));
  }
  return result;
}

// From 0, or the least value, to a round number that few values exceed: those of the whole animation, so that pictures
// of different frames can be compared.
void Scene_pictures::find_range_of_field()
{
  if (m_scene.fields.empty()) return;
  const double shown = 0.995;         // of the values
  const std::size_t enough = 1000003; // values to estimate that; prime, against regular meshes
  const auto& field = *m_scene.fields.front().values;
  const std::size_t frames = field.number_of_frames(), n = field.number_of_rows() * frames;
  const std::size_t step = n / enough + 1;
  std::vector<double> values;
  for (std::size_t i = 0; i < n; i += step) values.push_back(field(i / frames, i % frames));
  if (values.empty()) return;
  const auto at = values.begin() + std::ptrdiff_t(shown * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  const double high = *at;
  m_low = (std::min)(0., *std::min_element(values.begin(), values.end()));
  const double most = *std::max_element(values.begin(), values.end());
  if (!(high > m_low)) return;
  const double unit = std::pow(10., std::floor(std::log10(high - m_low)) - 1); // two digits
  m_high = m_low + std::ceil((high - m_low) / unit - 1e-9) * unit;
  m_is_cut = most > m_high;
}

} // namespace Programs
