// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plots/write_curves.h"

#include "drawing/Canvas.h"
#include "plots/Axis.h"
#include "plots/ticks.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace Programs {

namespace {

// Colours that people with any kind of colour vision tell apart, from dark to light.
Rendering::Srgb8 colour(std::size_t i)
{
  const std::array<Rendering::Srgb8, 6> colours = {
      {{{20, 60, 120}}, {{200, 80, 20}}, {{30, 130, 90}}, {{150, 60, 140}}, {{90, 160, 215}}, {{205, 160, 30}}}};
  return colours[i % colours.size()];
}

class Curve_plot
{
  static constexpr double width = 960, height = 560;
  static constexpr double left = 76, right = 620, top = 84, bottom = 480;
  static constexpr double key = 656; // its left side

public:
  Curve_plot(const Curves& curves, Drawing_format format)
    : m_canvas(format, width, height, curves.title)
  {
    m_canvas.text(left, 38, curves.title, m_style.heading());
    m_canvas.text(left, 60, curves.subtitle, m_style.dim_text());
    double min = 0, max = 0;
    for (const Curve& c : curves.curves)
      for (double x : c.x) {
        min = (std::min)(min, x);
        max = (std::max)(max, x);
      }
    const Axis x = {min, max > min ? max : min + 1, left, right}, y = {0, curves.y_max > 0 ? curves.y_max : 1, bottom, top};
    draw_y_axis(m_canvas, y, linear_ticks(0, y.max, 5), left, right, curves.y_name, m_style);
    draw_x_axis(m_canvas, x, linear_ticks(x.min, x.max, 8), bottom, curves.x_name, m_style);
    std::size_t i = 0;
    double row = top + 8;
    for (const Curve& c : curves.curves) {
      if (!c.is_chance) ++i;
      const Pen pen = {colour(i == 0 ? 0 : i - 1), c.is_chance ? 1. : 2.5, true};
      for (std::size_t k = 1; k < c.x.size(); ++k)
        m_canvas.line(x(c.x[k - 1]), y(c.y[k - 1]), x(c.x[k]), y(c.y[k]), pen);
      m_canvas.line(key, row, key + 24, row, pen);
      m_canvas.text(key + 34, row + capital_height * m_style.text_size / 2, c.name,
                    c.is_chance ? m_style.dim_text() : m_style.text());
      row += 24;
    }
  }

  std::string file() { return m_canvas.file(); }

private:
  const Plot_style m_style;
  Canvas m_canvas;
};

} // namespace

void write_curves(std::ostream& os, const Curves& curves, Drawing_format format)
{
  const std::string file = Curve_plot(curves, format).file();
  os.write(file.data(), std::streamsize(file.size()));
}

} // namespace Programs
