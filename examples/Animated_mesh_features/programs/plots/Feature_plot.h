// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_FEATURE_PLOT_H
#define PROGRAMS_PLOTS_FEATURE_PLOT_H

#include "scenes/Scene.h"
#include "plots/Plot_axis.h"
#include "plots/Svg_output.h"
#include "scenes/colour_scales.h"
#include "rendering/Palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The drawing of `write_plot()`, from top to bottom: title, features over time with the key at the right, histograms.
// Lengths are in pixels.
template <class Sequence, class Feature>
class Feature_plot
{
  static constexpr double width = 960, height = 760;
  static constexpr double left = 76, right = 760, top = 84, bottom = 440; // features over time
  static constexpr double key = 800;                                      // its left side
  static constexpr double histogram_top = 536, histogram_bottom = 696, histogram_gap = 96;
  static constexpr double largest_circle = 22, smallest_circle = 2; // radii

public:
  explicit Feature_plot(const Scene<Sequence, Feature>& scene)
    : m_scene(scene)
    , m_features(scene.features)
    , m_places(relative_taus(scene.features))
  {
    for (const Feature& f : m_features) {
      m_most_sigma = (std::max)(m_most_sigma, f.sigma);
      m_most_strength = (std::max)(m_most_strength, f.strength());
    }
    begin();
    draw_features();
    draw_key();
    const double middle = (left + width - 32) / 2;
    std::vector<double> sigmas, taus;
    for (const Feature& f : m_features) {
      sigmas.push_back(f.sigma);
      taus.push_back(f.tau);
    }
    m_out.raw("<g id=\"sigmas\">\n");
    draw_histogram(sigmas, left, middle - histogram_gap / 2, "\xcf\x83, the size (unit of length of the mesh)", false);
    m_out.raw("</g>\n<g id=\"taus\">\n");
    draw_histogram(taus, middle + histogram_gap / 2, width - 32, "\xcf\x84, the duration (s)", true);
    m_out.raw("</g>\n</svg>\n");
  }

  const std::string& svg() const { return m_out.svg(); }

private:
  void begin()
  {
    m_out.raw("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + pixels(width) + "\" height=\"" + pixels(height) +
              "\" viewBox=\"0 0 " + pixels(width) + " " + pixels(height) + "\" role=\"img\">\n");
    const std::size_t n = m_features.size(), frames = m_scene.sequence.number_of_frames();
    m_out.title(m_scene.title + ": spatio-temporal features over time");
    m_out.raw(
        "<style>\n"
        "  svg { --paper: #ffffff; --ink: #1f2328; --dim: #59636e; --line: #d1d9e0; --bar: #6f7f8f }\n"
        "  @media (prefers-color-scheme: dark) {\n"
        "    svg { --paper: #0d1117; --ink: #f0f6fc; --dim: #9198a1; --line: #3d444d; --bar: #8b9bab }\n"
        "  }\n"
        "  text { font: 13px system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif; fill: var(--ink) }\n"
        "  .heading { font-size: 20px; font-weight: 600 }\n"
        "  .dim { fill: var(--dim) }\n"
        "  .middle { text-anchor: middle }\n"
        "  .end { text-anchor: end }\n"
        "  .grid { stroke: var(--line) }\n"
        "  .axis { stroke: var(--dim) }\n"
        "  .count { fill: var(--bar) }\n"
        "  .paper { fill: var(--paper) }\n"
        "  .feature circle { fill-opacity: 0.35; stroke-width: 1.5 }\n"
        "  .feature line { stroke-width: 2.5; stroke-linecap: round }\n"
        "  .sample { fill: none; stroke: var(--ink); stroke-width: 1.5 }\n"
        "</style>\n");
    m_out.rectangle(0, 0, width, height, "class=\"paper\"");
    m_out.text(left, 38, m_scene.title, "heading");
    m_out.text(left, 60,
               std::to_string(n) + (n == 1 ? " feature in " : " features in ") + std::to_string(frames) + " frames, " +
                   rounded(duration()) + " s",
               "dim");
  }

  double duration() const
  {
    return double(m_scene.sequence.number_of_frames() - 1) * m_scene.sequence.frame_duration();
  }

  void draw_x_axis(const Plot_axis& axis, const std::vector<Plot_tick>& ticks, double y, const std::string& name)
  {
    const double tick_length = 5;
    m_out.line(axis.begin, y, axis.end, y, "axis");
    for (const Plot_tick& t : ticks) {
      m_out.line(axis(t.value), y, axis(t.value), y + tick_length, "axis");
      m_out.text(axis(t.value), y + 20, t.text, "middle dim");
    }
    m_out.text((axis.begin + axis.end) / 2, y + 42, name, "middle");
  }

  // With lines through the plot, from `begin` to `end`.
  void draw_y_axis(const Plot_axis& axis, const std::vector<Plot_tick>& ticks, double begin, double end,
                   const std::string& name)
  {
    for (const Plot_tick& t : ticks) {
      if (t.value > axis.min) m_out.line(begin, axis(t.value), end, axis(t.value), "grid");
      m_out.text(begin - 8, axis(t.value) + 4, t.text, "end dim");
    }
    const double x = begin - 52, y = (axis.begin + axis.end) / 2;
    m_out.text(x, y, name, "middle", (" transform=\"rotate(-90 " + pixels(x) + " " + pixels(y) + ")\"").c_str());
  }

  // The colour of a duration: see relative_taus().
  static std::string css_colour(double place)
  {
    using namespace Animated_mesh_features::Rendering;
    return hexadecimal(encoded(duration_colours()(place)));
  }

  double radius(double sigma) const
  {
    return m_most_sigma > 0 ? (std::max)(smallest_circle, sigma / m_most_sigma * largest_circle) : smallest_circle;
  }

  void draw_features()
  {
    // The strongest and the largest circle stay within.
    const Plot_axis time = {0, duration(), left, right};
    const Plot_axis strength = {0, m_most_strength > 0 ? 1.08 * m_most_strength : 1, bottom, top};
    m_out.raw("<g id=\"strength\">\n");
    draw_y_axis(strength, linear_ticks(strength.min, strength.max, 6), left, right, "strength");
    m_out.raw("</g>\n<g id=\"time\">\n");
    draw_x_axis(time, linear_ticks(time.min, time.max, 8), bottom, "time (s)");
    m_out.raw("</g>\n");
    if (m_features.empty()) m_out.text((left + right) / 2, (top + bottom) / 2, "no features", "middle dim");

    // Large ones first, so that they do not hide small ones.
    std::vector<std::size_t> order(m_features.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return m_features[a].sigma > m_features[b].sigma; });
    for (std::size_t i : order) {
      const Feature& f = m_features[i];
      const std::string colour = css_colour(m_places[i]);
      const double x = time(f.time), y = strength(f.strength());
      const auto inside = [&](double t) { return time((std::min)(time.max, (std::max)(time.min, t))); };
      m_out.raw("<g class=\"feature\" fill=\"" + colour + "\" stroke=\"" + colour + "\">");
      m_out.title("feature " + std::to_string(i) + ": vertex " + std::to_string(f.vertex_index) + ", time " +
                  rounded(f.time) + " s, strength " + rounded(f.strength()) + ", \xcf\x83 " + rounded(f.sigma) +
                  ", \xcf\x84 " + rounded(f.tau) + " s");
      m_out.line(inside(f.time - f.tau / 2), y, inside(f.time + f.tau / 2), y, "tau");
      m_out.circle(x, y, radius(f.sigma), "class=\"sigma\"");
      m_out.raw("</g>\n");
    }
  }

  void draw_key()
  {
    if (m_features.empty()) return;
    double y = top + 8;
    m_out.text(key, y, "radius of the circle: \xcf\x83", "dim");
    for (double part : {1., 0.5, 0.25}) {
      const double sigma = part * m_most_sigma, r = radius(sigma);
      y += r + 10;
      m_out.circle(key + largest_circle + 4, y, r, "class=\"sample\"");
      m_out.text(key + 2 * largest_circle + 20, y + 4, rounded(sigma, 2), "");
      y += r + 4;
    }
    y += 36;
    m_out.text(key, y, "length of the bar: \xcf\x84", "dim");
    y += 22;
    m_out.text(key, y, "colour: \xcf\x84 (s)", "dim");
    y += 12;
    const int stops = 8;
    m_out.raw("<linearGradient id=\"scale-of-tau\">");
    for (int i = 0; i <= stops; ++i)
      m_out.raw("<stop offset=\"" + decimal(std::lround(1000. * i / stops), -3) + "\" stop-color=\"" +
                css_colour(double(i) / stops) + "\"/>");
    m_out.raw("</linearGradient>\n");
    const auto taus = std::minmax_element(m_features.begin(), m_features.end(),
                                          [](const Feature& a, const Feature& b) { return a.tau < b.tau; });
    m_out.rectangle(key, y, 128, 10, "fill=\"url(#scale-of-tau)\" rx=\"2\"");
    m_out.text(key, y + 28, rounded(taus.first->tau, 2), "");
    m_out.text(key + 128, y + 28, rounded(taus.second->tau, 2), "end");
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
    const Plot_axis x = {min, max, begin, end, true};
    const std::size_t bins = std::size_t((std::min)(16., (std::max)(6., std::round(std::sqrt(double(values.size()))))));
    std::vector<std::size_t> counts(bins, 0);
    const auto position = [&](double value) { return std::log(value / min) / std::log(max / min); };
    for (double value : values)
      ++counts[(std::min)(bins - 1, std::size_t((std::max)(0., position(value) * double(bins))))];
    const double most = double(*std::max_element(counts.begin(), counts.end()));
    const Plot_axis y = {0, 1.08 * most, histogram_bottom, histogram_top};
    draw_y_axis(y, linear_ticks(0, y.max, 5, true), begin, end, "features");
    for (std::size_t i = 0; i < bins; ++i) {
      if (counts[i] == 0) continue;
      const double from = begin + (end - begin) * double(i) / double(bins),
                   to = begin + (end - begin) * double(i + 1) / double(bins), gap = 1;
      // the scale of colours is by ratio as well
      const std::string attributes = by_tau && *range.second > *range.first
                                         ? "fill=\"" + css_colour((double(i) + 0.5) / double(bins)) + "\" class=\"tau\""
                                         : "class=\"count\"";
      m_out.raw("<g>");
      m_out.title(rounded(min * std::pow(max / min, double(i) / double(bins))) + " to " +
                  rounded(min * std::pow(max / min, double(i + 1) / double(bins))) + ": " + std::to_string(counts[i]));
      m_out.rectangle(from + gap, y(double(counts[i])), to - from - 2 * gap, histogram_bottom - y(double(counts[i])),
                      attributes);
      m_out.raw("</g>\n");
    }
    draw_x_axis(x, logarithmic_ticks(min, max), histogram_bottom, name);
  }

  const Scene<Sequence, Feature>& m_scene;
  const std::vector<Feature>& m_features;
  std::vector<double> m_places; // of tau, on the scale of colours
  double m_most_sigma = 0, m_most_strength = 0;
  Svg_output m_out;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PLOTS_FEATURE_PLOT_H
