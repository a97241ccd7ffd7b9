// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plots/write_view_map.h"

#include "drawing/Canvas.h"
#include "drawing/decimal.h"
#include "plots/Axis.h"
#include "plots/ticks.h"
#include "rendering/Palette.h"
#include "views/Scene_views.h"
#include "views/View_choice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

// Scores between directions: linear on the triangles of the sphere.
class Score_map
{
public:
  Score_map(const Shown_scene& scene, const Scene_views& views)
    : m_sphere(3)
    , m_scores(scores_around(scene, views, 3))
  {}

  double operator()(const Eigen::Vector3d& d)
  {
    // neighbouring places lie in the same triangle, or one that is not far
    for (std::size_t i = 0; i < m_sphere.triangles().size(); ++i) {
      const std::size_t t = (m_last + i) % m_sphere.triangles().size();
      const auto& corners = m_sphere.triangles()[t];
      const auto& p = m_sphere.directions();
      const Eigen::Vector3d &a = p[corners[0]], &b = p[corners[1]], &c = p[corners[2]];
      const double u = d.dot(b.cross(c)), v = d.dot(c.cross(a)), w = d.dot(a.cross(b)), slack = -1e-9;
      if (!(u >= slack && v >= slack && w >= slack && u + v + w > 0)) continue;
      m_last = t;
      return (u * m_scores.score(corners[0]) + v * m_scores.score(corners[1]) + w * m_scores.score(corners[2])) /
             (u + v + w);
    }
    return 0;
  }

private:
  AMF::View_sphere m_sphere;
  AMF::View_scores m_scores;
  std::size_t m_last = 0;
};

class View_map
{
  static constexpr double width = 960, height = 560;
  static constexpr double left = 76, right = 916, top = 84, bottom = 440;
  static constexpr int columns = 120, rows = 60; // three degrees each

public:
  View_map(const Shown_scene& scene, const Scene_views& views, Drawing_format format)
    : m_canvas(format, width, height, scene.title + ": what views show")
  {
    m_canvas.text(left, 38, scene.title, m_style.heading());
    m_canvas.text(left, 60,
                  scene.features.empty()
                      ? "no features: the entropy of views from all sides"
                      : "what views from all sides show of the features, per cent of their amplitude",
                  m_style.dim_text());
    const Axis azimuth = {-180, 180, left, right}, elevation = {-90, 90, bottom, top};
    Score_map map(scene, views);
    std::vector<double> values;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        values.push_back(map(AMF::view_direction({-180 + 360 * (column + 0.5) / columns, 90 - 180 * (row + 0.5) / rows},
                                                 views.selection.up)));
    const auto range = std::minmax_element(values.begin(), values.end());
    const double low = *range.first, high = *range.second > low ? *range.second : low + 1;
    const double w = (right - left) / columns, h = (bottom - top) / rows, overlap = 0.4; // no light lines between
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        m_canvas.rectangle(left + column * w, top + row * h, w + (column + 1 < columns ? overlap : 0),
                           h + (row + 1 < rows ? overlap : 0),
                           Rendering::encoded(Rendering::field_colours()(
                               (values[std::size_t(row * columns + column)] - low) / (high - low))));
    draw_axes(azimuth, elevation, views.up_axis);
    for (double e : {Scene_views::lowest_elevation, Scene_views::highest_elevation})
      for (double x = left; x < right; x += 12) m_canvas.line(x, elevation(e), x + 6, elevation(e), {m_style.ink, 1});
    for (std::size_t i = views.selection.views.size(); i-- > 0;)
      draw_view(azimuth, elevation, views.selection.views[i].angles, i + 1);
    draw_key(low, high, views);
  }

  std::string file() { return m_canvas.file(); }

private:
  void draw_axes(const Axis& azimuth, const Axis& elevation, int up_axis)
  {
    const double capitals = capital_height * m_style.text_size;
    for (int a = -180; a <= 180; a += 45) {
      m_canvas.line(azimuth(a), bottom, azimuth(a), bottom + 5, {m_style.dim, 1});
      m_canvas.text(azimuth(a), bottom + 10 + capitals, std::to_string(a) + "\xc2\xb0", m_style.text(0.5));
    }
    for (int e = -90; e <= 90; e += 30) {
      m_canvas.line(left - 5, elevation(e), left, elevation(e), {m_style.dim, 1});
      m_canvas.text(left - 9, elevation(e) + capitals / 2, std::to_string(e) + "\xc2\xb0", m_style.text(1));
    }
    for (View_kind kind : {View_kind::FRONT, View_kind::BACK, View_kind::LEFT, View_kind::RIGHT}) {
      View_choice choice;
      choice.kind = kind;
      const double a = std::remainder(told_angles(choice, up_axis).azimuth, 360);
      m_canvas.text(azimuth(a), bottom + 28 + capitals, name(kind), m_style.dim_text(0.5));
      // at both ends, where the map is cut
      if (std::abs(a) == 180) m_canvas.text(azimuth(-a), bottom + 28 + capitals, name(kind), m_style.dim_text(0.5));
    }
  }

  void draw_view(const Axis& azimuth, const Axis& elevation, const AMF::View_angles& angles, std::size_t rank)
  {
    const double x = azimuth(angles.azimuth), y = elevation(angles.elevation), radius = 11;
    m_canvas.circle(x, y, radius, {m_style.ink, 1.5}, Rendering::Srgb8{{255, 255, 255}}, 0.9);
    m_canvas.text(x, y + capital_height * m_style.text_size / 2, std::to_string(rank), m_style.text(0.5));
  }

  void draw_key(double low, double high, const Scene_views& views)
  {
    const double y = 508, length = 220;
    m_canvas.colour_bar(left, y, length, 12, Rendering::field_colours());
    m_canvas.text(left, y + 28, rounded(100 * low, 2) + " %", m_style.text());
    m_canvas.text(left + length, y + 28, rounded(100 * high, 2) + " %", m_style.text(1));
    std::string text;
    for (std::size_t i = 0; i < views.selection.views.size(); ++i) {
      const AMF::Selected_view& v = views.selection.views[i];
      text += (i == 0 ? "" : "     ") + std::to_string(i + 1) + ": " + rounded(100 * v.score, 2) + " %" +
              (i == 0 ? "" : ", together " + rounded(100 * v.covered, 2) + " %");
    }
    m_canvas.text(left + length + 40, y + 11, "chosen views, between the dashed lines", m_style.dim_text());
    m_canvas.text(left + length + 40, y + 31, text, m_style.text());
  }

  const Plot_style m_style;
  Canvas m_canvas;
};

} // namespace

void write_view_map(std::ostream& os, const Shown_scene& scene, Drawing_format format)
{
  check_scene(scene);
  std::optional<Scene_views> own;
  if (scene.views == nullptr) own = scene_views(scene, std::nullopt);
  const std::string file = View_map(scene, own ? *own : *scene.views, format).file();
  os.write(file.data(), std::streamsize(file.size()));
}

} // namespace Programs
