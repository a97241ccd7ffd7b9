// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/write_matrix.h"

#include "drawing/Canvas.h"
#include "plots/Axis.h"
#include "rendering/Palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace Compare_animations {

namespace {

using namespace Programs;

class Matrix_drawing
{
public:
  Matrix_drawing(const Distance_matrix& m, Drawing_format format)
    : m_matrix(m)
    , m_cell((std::max)(3., (std::min)(22., 560. / double(m.size()))))
    , m_text_size((std::max)(5., (std::min)(12., m_cell)))
    , m_left(margin + longest_name(m) * m_text_size * 0.56 + 10)
    , m_side(m_cell * double(m.size()))
    , m_plane((std::max)(m_side, 420.))
    , m_canvas(format, m_left + m_side + gap + m_plane + 190, top + (std::max)(m_side, m_plane) + 70,
               "Distances of animations")
  {
    m_canvas.text(margin, 38, "Distances of animations", m_style.heading());
    m_canvas.text(margin, 60, std::to_string(m.size()) + " animations, columns as rows", m_style.dim_text());
    for (double x : m.distances) m_largest = (std::max)(m_largest, x);
    draw_cells();
    draw_key();
    draw_plane();
  }

  std::string file() { return m_canvas.file(); }

private:
  static constexpr double margin = 24, top = 84, gap = 60;

  static double longest_name(const Distance_matrix& m)
  {
    std::size_t n = 0;
    for (const std::string& name : m.names) n = (std::max)(n, name.size());
    return double(n);
  }

  Rendering::Srgb8 colour(double distance) const
  {
    return Rendering::encoded(Rendering::field_colours()(m_largest > 0 ? 1 - distance / m_largest : 1));
  }

  void draw_cells()
  {
    Text_style style = m_style.text(1);
    style.size = m_text_size;
    for (std::size_t i = 0; i < m_matrix.size(); ++i) {
      const double y = top + double(i) * m_cell;
      m_canvas.text(m_left - 6, y + m_cell / 2 + capital_height * style.size / 2, m_matrix.names[i], style);
      for (std::size_t j = 0; j < m_matrix.size(); ++j)
        m_canvas.rectangle(m_left + double(j) * m_cell, y, m_cell + 0.3, m_cell + 0.3, colour(m_matrix(i, j)));
    }
  }

  void draw_key()
  {
    const double y = top + m_side + 18, width = 160;
    const int steps = 40;
    for (int k = 0; k < steps; ++k)
      m_canvas.rectangle(m_left + width * k / steps, y, width / steps + 0.3, 12, colour(m_largest * k / steps));
    m_canvas.text(m_left, y + 28, "0", m_style.dim_text());
    m_canvas.text(m_left + width, y + 28, shortened(m_largest), m_style.dim_text(1));
    m_canvas.text(m_left + width + 12, y + 11, "distance", m_style.text());
  }

  static std::string shortened(double x)
  {
    const std::string text = std::to_string(x);
    return text.substr(0, 4);
  }

  // What has the same name up to the first "__" or "/", a body or a character, has the same colour.
  static std::string group_of(const std::string& name)
  {
    return name.substr(0, (std::min)(name.find("__"), name.find('/')));
  }

  static std::string short_name(const std::string& name)
  {
    const std::string group = group_of(name);
    return group.size() < name.size() ? name.substr(group.size() + 1 + (name[group.size()] == '_')) : name;
  }

  struct Box
  {
    double left, top, right, bottom;

    bool overlaps(const Box& b) const { return left < b.right && b.left < right && top < b.bottom && b.top < bottom; }
    bool contains(const Box& b) const
    {
      return left <= b.left && b.right <= right && top <= b.top && b.bottom <= bottom;
    }
  };

  // A name beside its circle where it lies on nothing else. returns whether there is room; the matrix has all names.
  bool draw_name(const std::array<double, 2>& centre, const std::string& name, const Text_style& style,
                 const Box& plane)
  {
    const double width = m_canvas.text_width(name, style), height = capital_height * style.size, distance = 7;
    const double sides[8][2] = {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}};
    for (const auto& side : sides) {
      const double shift = side[0] != 0 && side[1] != 0 ? 0.6 * distance : distance;
      const double x = centre[0] + side[0] * (shift + width / 2) - width / 2;
      const double y = centre[1] + side[1] * (shift + height / 2) - height / 2;
      const Box box = {x - 1, y - 1, x + width + 1, y + height + 2}; // letters go below the base line, too
      const bool is_free = std::none_of(m_taken.begin(), m_taken.end(), [&](const Box& b) { return b.overlaps(box); });
      if (!is_free || !plane.contains(box)) continue;
      m_taken.push_back(box);
      m_canvas.text(x, y + height, name, style);
      return true;
    }
    return false;
  }

  void draw_plane()
  {
    const double left = m_left + m_side + gap;
    double low[2] = {0, 0}, high[2] = {0, 0};
    for (const auto& p : m_matrix.places)
      for (int k = 0; k < 2; ++k) {
        low[k] = (std::min)(low[k], p[std::size_t(k)]);
        high[k] = (std::max)(high[k], p[std::size_t(k)]);
      }
    const double extent = (std::max)({high[0] - low[0], high[1] - low[1], 1e-12});
    for (int k = 0; k < 2; ++k) low[k] -= (extent - (high[k] - low[k])) / 2; // in the middle
    m_canvas.text(left, top - 8, "in the plane, by classical scaling", m_style.dim_text());
    std::vector<std::string> groups;
    std::vector<std::array<double, 2>> centres;
    for (std::size_t i = 0; i < m_matrix.size(); ++i) {
      const std::string group = group_of(m_matrix.names[i]);
      std::size_t g = std::size_t(std::find(groups.begin(), groups.end(), group) - groups.begin());
      if (g == groups.size()) groups.push_back(group);
      const double x = left + 8 + (m_matrix.places[i][0] - low[0]) / extent * (m_plane - 16);
      const double y = top + m_plane - 8 - (m_matrix.places[i][1] - low[1]) / extent * (m_plane - 16);
      m_canvas.circle(x, y, 4, {group_colour(g), 1, false}, group_colour(g), 0.85);
      centres.push_back({{x, y}});
      m_taken.push_back({x - 4, y - 4, x + 4, y + 4});
    }
    Text_style style = m_style.text();
    style.size = (std::max)(8., (std::min)(11., m_text_size));
    const Box plane = {left - gap + 6, top, left + m_plane + 180, top + m_plane + 6};
    std::size_t unnamed = 0;
    for (std::size_t i = 0; i < m_matrix.size(); ++i)
      unnamed += draw_name(centres[i], short_name(m_matrix.names[i]), style, plane) ? 0 : 1;
    if (unnamed > 0)
      m_canvas.text(left + m_plane + 160, top - 8, std::to_string(unnamed) + " of the names have no room",
                    m_style.dim_text(1));
    double y = top + m_plane + 22, x = left;
    if (groups.size() > 1 && groups.size() < m_matrix.size())
      for (std::size_t g = 0; g < groups.size(); ++g) {
        const double width = m_canvas.text_width(groups[g], m_style.text()) + 34;
        if (x + width > left + m_plane + 160) {
          x = left;
          y += 18;
        }
        m_canvas.circle(x + 4, y - 4, 4, {group_colour(g), 1, false}, group_colour(g), 0.85);
        m_canvas.text(x + 13, y, groups[g], m_style.text());
        x += width;
      }
  }

  static Rendering::Srgb8 group_colour(std::size_t i)
  {
    const std::array<Rendering::Srgb8, 8> colours = {{{{20, 60, 120}},
                                                      {{200, 80, 20}},
                                                      {{30, 130, 90}},
                                                      {{150, 60, 140}},
                                                      {{90, 160, 215}},
                                                      {{205, 160, 30}},
                                                      {{110, 110, 110}},
                                                      {{120, 20, 30}}}};
    return colours[i % colours.size()];
  }

  const Plot_style m_style;
  const Distance_matrix& m_matrix;
  double m_cell, m_text_size, m_left, m_side, m_plane, m_largest = 0;
  std::vector<Box> m_taken; // in the plane
  Canvas m_canvas;
};

} // namespace

void write_matrix(std::ostream& os, const Distance_matrix& matrix, Programs::Drawing_format format)
{
  const std::string file = Matrix_drawing(matrix, format).file();
  os.write(file.data(), std::streamsize(file.size()));
}

} // namespace Compare_animations
