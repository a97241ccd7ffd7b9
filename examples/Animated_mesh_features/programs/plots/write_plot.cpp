// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plots/write_plot.h"

#include "drawing/Canvas.h"
#include "drawing/decimal.h"
#include "plots/Axis.h"
#include "plots/ticks.h"
#include "rendering/Palette.h"
#include "scenes/colour_scales.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace Programs {

namespace {

// The drawing, from top to bottom: title, features over time with the key at the right, curves if there is a field, histograms.
class Feature_plot
{
  static constexpr double width = 960;
  static constexpr double left = 76, right = 760, top = 84, bottom = 440; // features over time
  static constexpr double key = 800;                                      // its left side
  static constexpr double curves_top = 512, curves_bottom = 672;          // the deformation over time, if it is there
  static constexpr double room_of_curves = 232;                           // what is below them is as much lower
  static constexpr double histogram_top = 536, histogram_height = 160, histogram_gap = 96, histogram_margin = 64;
  static constexpr double largest_circle = 22, smallest_circle = 2; // radii

public:
  Feature_plot(const Shown_scene& scene, Drawing_format format)
    : m_scene(scene)
    , m_features(scene.features)
    , m_places(relative_taus(scene.features))
    , m_curves(scene.features.empty() ? nullptr : scene.field("deformation"))
    , m_histogram_top(histogram_top + (m_curves != nullptr ? room_of_curves : 0))
    , m_canvas(format, width, m_histogram_top + histogram_height + histogram_margin,
               scene.title + ": spatio-temporal features over time")
  {
    for (const Shown_feature& f : m_features) {
      m_most_sigma = (std::max)(m_most_sigma, f.sigma);
      m_most_strength = (std::max)(m_most_strength, f.strength);
    }
    draw_heading();
    draw_features();
    draw_key();
    if (m_curves != nullptr) draw_curves();
    const double middle = (left + width - 32) / 2;
    std::vector<double> sigmas, taus;
    for (const Shown_feature& f : m_features) {
      sigmas.push_back(f.sigma);
      taus.push_back(f.tau);
    }
    draw_histogram(sigmas, left, middle - histogram_gap / 2, "\xcf\x83, the size (unit of length of the mesh)", false);
    draw_histogram(taus, middle + histogram_gap / 2, width - 32, "\xcf\x84, the duration (s)", true);
  }

  std::string file() { return m_canvas.file(); }

private:
  void draw_heading()
  {
    const std::size_t n = m_features.size(), frames = m_scene.sequence.number_of_frames();
    m_canvas.text(left, 38, m_scene.title, m_style.heading());
    m_canvas.text(left, 60,
                  std::to_string(n) + (n == 1 ? " feature in " : " features in ") + std::to_string(frames) +
                      " frames, " + rounded(duration()) + " s",
                  m_style.dim_text());
  }

  double duration() const
  {
    // of a cyclic animation, to where it begins again
    const std::size_t frames = m_scene.sequence.number_of_frames();
    return double(m_scene.is_cyclic ? frames : frames - 1) * m_scene.sequence.frame_duration();
  }

  // The colour of a duration: see relative_taus().
  static Rendering::Srgb8 colour(double place) { return Rendering::encoded(Rendering::duration_colours()(place)); }

  double radius(double sigma) const
  {
    return m_most_sigma > 0 ? (std::max)(smallest_circle, sigma / m_most_sigma * largest_circle) : smallest_circle;
  }

  void draw_features()
  {
    // The strongest and the largest circle stay within.
    const Axis time = {0, duration(), left, right};
    const Axis strength = {0, m_most_strength > 0 ? 1.08 * m_most_strength : 1, bottom, top};
    draw_y_axis(m_canvas, strength, linear_ticks(strength.min, strength.max, 6), left, right, "strength", m_style);
    draw_x_axis(m_canvas, time, linear_ticks(time.min, time.max, 8), bottom, "time (s)", m_style);
    if (m_features.empty()) m_canvas.text((left + right) / 2, (top + bottom) / 2, "no features", m_style.dim_text(0.5));

    // Large ones first, so that they do not hide small ones.
    std::vector<std::size_t> order(m_features.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return m_features[a].sigma > m_features[b].sigma; });
    for (std::size_t i : order) {
      const Shown_feature& f = m_features[i];
      const Rendering::Srgb8 c = colour(m_places[i]);
      const double x = time(f.time), y = strength(f.strength);
      const auto inside = [&](double t) { return time((std::min)(time.max, (std::max)(time.min, t))); };
      m_canvas.line(inside(f.time - f.tau / 2), y, inside(f.time + f.tau / 2), y, {c, 2.5, true});
      m_canvas.circle(x, y, radius(f.sigma), {c, 1.5}, c, 0.35);
    }
    if (m_curves == nullptr) return;
    for (std::size_t i : strongest_of_places()) {
      const double off = std::sqrt(0.5) * radius(m_features[i].sigma);
      m_canvas.text(time(m_features[i].time) + off + 3, strength(m_features[i].strength) - off - 2,
                    std::to_string(i + 1), m_style.text());
    }
  }

  // The strongest features of the strongest places.
  std::vector<std::size_t> strongest_of_places() const
  {
    const std::size_t most = 6;
    std::vector<std::size_t> ranks;
    for (std::size_t i = 0; i < m_features.size() && ranks.size() < most; ++i)
      if (std::none_of(ranks.begin(), ranks.end(),
                       [&](std::size_t k) { return m_features[k].place == m_features[i].place; }))
        ranks.push_back(i);
    return ranks;
  }

  // The value at a time that may be between two frames.
  double deformation(std::size_t v, double time) const
  {
    const double at = time / m_scene.sequence.frame_duration(), last = double(m_curves->number_of_frames() - 1);
    const double frame = std::floor((std::min)(last, (std::max)(0., at)));
    const std::size_t f = std::size_t(frame), next = (std::min)(f + 1, m_curves->number_of_frames() - 1);
    const double part = (std::min)(1., (std::max)(0., at - frame));
    return (1 - part) * (*m_curves)(v, f) + part * (*m_curves)(v, next);
  }

  // How the surface deforms where it does most, over the same time as above; dots are the features of that place.
  void draw_curves()
  {
    const std::vector<std::size_t> shown = strongest_of_places();
    double most = 0, least = 0;
    for (std::size_t i : shown)
      for (std::size_t f = 0; f < m_curves->number_of_frames(); ++f) {
        most = (std::max)(most, double((*m_curves)(m_features[i].vertex_index, f)));
        least = (std::min)(least, double((*m_curves)(m_features[i].vertex_index, f)));
      }
    const Axis time = {0, duration(), left, right};
    const Axis value = {least, most > least ? least + 1.08 * (most - least) : least + 1, curves_bottom, curves_top};
    draw_y_axis(m_canvas, value, linear_ticks(value.min, value.max, 4), left, right, "deformation", m_style);
    draw_x_axis(m_canvas, time, linear_ticks(time.min, time.max, 8), curves_bottom, "time (s)", m_style);
    m_canvas.text(key, curves_top + 8, "where it is strongest:", m_style.dim_text());
    m_canvas.text(key, curves_top + 26, "rank, vertex", m_style.dim_text());
    double row = curves_top + 50;
    for (std::size_t i : shown) {
      const Shown_feature& f = m_features[i];
      const Rendering::Srgb8 c = colour(m_places[i]);
      std::vector<std::pair<double, double>> points;
      for (std::size_t frame = 0; frame < m_curves->number_of_frames(); ++frame)
        points.emplace_back(time(double(frame) * m_scene.sequence.frame_duration()),
                            value((*m_curves)(f.vertex_index, frame)));
      m_canvas.polyline(points, {c, 1.8, true});
      m_canvas.line(key, row, key + 24, row, {c, 1.8, true});
      m_canvas.text(key + 34, row + capital_height * m_style.text_size / 2,
                    std::to_string(i + 1) + ", " + std::to_string(f.vertex_index), m_style.text());
      row += 20;
    }
    // above all curves
    for (std::size_t i : shown)
      for (std::size_t k = m_features.size(); k-- > 0;) {
        const Shown_feature& f = m_features[k];
        if (f.place != m_features[i].place) continue;
        const double x = time((std::min)(time.max, (std::max)(time.min, f.time)));
        const double y = value(deformation(m_features[i].vertex_index, f.time));
        m_canvas.circle(x, y, k == i ? 4 : 2.5, {{{255, 255, 255}}, 1}, colour(m_places[k]));
        if (k == i) m_canvas.text(x + 7, y - 5, std::to_string(i + 1), m_style.text());
      }
  }

  void draw_key()
  {
    if (m_features.empty()) return;
    double y = top + 8;
    m_canvas.text(key, y, "radius of the circle: \xcf\x83", m_style.dim_text());
    for (double part : {1., 0.5, 0.25}) {
      const double sigma = part * m_most_sigma, r = radius(sigma);
      y += r + 10;
      m_canvas.circle(key + largest_circle + 4, y, r, {m_style.ink, 1.5});
      m_canvas.text(key + 2 * largest_circle + 20, y + capital_height * m_style.text_size / 2, rounded(sigma, 2),
                    m_style.text());
      y += r + 4;
    }
    y += 36;
    m_canvas.text(key, y, "length of the bar: \xcf\x84", m_style.dim_text());
    y += 22;
    m_canvas.text(key, y, "colour: \xcf\x84 (s)", m_style.dim_text());
    y += 12;
    const auto taus = std::minmax_element(m_features.begin(), m_features.end(),
                                          [](const Shown_feature& a, const Shown_feature& b) { return a.tau < b.tau; });
    const double length = width - 32 - key;
    m_canvas.colour_bar(key, y, length, 10, Rendering::duration_colours());
    m_canvas.text(key, y + 28, rounded(taus.first->tau, 2), m_style.text());
    m_canvas.text(key + length, y + 28, rounded(taus.second->tau, 2), m_style.text(1));
  }

  // How many values lie in which range. The ranges have the same ratio of end to begin, as scales have.
  void draw_histogram(const std::vector<double>& values, double begin, double end, const std::string& name, bool by_tau)
  {
    const auto range = std::minmax_element(values.begin(), values.end());
    if (values.empty() || !(*range.first > 0)) return;
    double min = *range.first, max = *range.second;
    const double least_ratio = 1.2;
    const double widening = std::sqrt((std::max)(1., least_ratio / (max / min)));
    min /= widening;
    max *= widening;
    const Axis x = {min, max, begin, end, true};
    const std::size_t bins = std::size_t((std::min)(16., (std::max)(6., std::round(std::sqrt(double(values.size()))))));
    std::vector<std::size_t> counts(bins, 0);
    const auto position = [&](double value) { return std::log(value / min) / std::log(max / min); };
    for (double value : values)
      ++counts[(std::min)(bins - 1, std::size_t((std::max)(0., position(value) * double(bins))))];
    const double most = double(*std::max_element(counts.begin(), counts.end()));
    const double bottom_of_columns = m_histogram_top + histogram_height;
    const Axis y = {0, 1.08 * most, bottom_of_columns, m_histogram_top};
    draw_y_axis(m_canvas, y, linear_ticks(0, y.max, 5, true), begin, end, "features", m_style);
    for (std::size_t i = 0; i < bins; ++i) {
      if (counts[i] == 0) continue;
      const double from = begin + (end - begin) * double(i) / double(bins),
                   to = begin + (end - begin) * double(i + 1) / double(bins), gap = 1;
      // the scale of colours is by ratio as well
      m_canvas.rectangle(from + gap, y(double(counts[i])), to - from - 2 * gap,
                         bottom_of_columns - y(double(counts[i])),
                         by_tau && *range.second > *range.first ? colour((double(i) + 0.5) / double(bins)) : m_column);
    }
    draw_x_axis(m_canvas, x, logarithmic_ticks(min, max), bottom_of_columns, name, m_style);
  }

  const Shown_scene& m_scene;
  const std::vector<Shown_feature>& m_features;
  const std::vector<double> m_places; // of tau, on the scale of colours
  const Plot_style m_style;
  const Rendering::Srgb8 m_column = {{111, 127, 143}};
  const Shown_values* const m_curves; // null: none are drawn
  const double m_histogram_top;
  double m_most_sigma = 0, m_most_strength = 0;
  Canvas m_canvas;
};

} // namespace

void write_plot(std::ostream& os, const Shown_scene& scene, Drawing_format format)
{
  check_scene(scene);
  const std::string file = Feature_plot(scene, format).file();
  os.write(file.data(), std::streamsize(file.size()));
}

} // namespace Programs
