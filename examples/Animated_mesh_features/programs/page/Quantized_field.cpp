// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Quantized_field.h"

#include <algorithm>

namespace Programs {

Quantized_field::Quantized_field(const Shown_values& field, const std::vector<std::size_t>& vertices,
                                 const std::vector<std::size_t>& frames)
  : m_field(&field)
  , m_vertices(&vertices)
{
  const double shown = 0.995;
  std::vector<double> values;
  values.reserve(vertices.size() * frames.size());
  for (const std::size_t v : vertices)
    for (const std::size_t f : frames) values.push_back(field(v, f));
  if (values.empty()) return;
  const auto ends = std::minmax_element(values.begin(), values.end());
  m_min = *ends.first;
  m_largest = *ends.second;
  const auto top = values.begin() + std::ptrdiff_t(shown * double(values.size() - 1));
  std::nth_element(values.begin(), top, values.end());
  m_max = *top;
  if (!(m_max > m_min)) m_max = m_largest; // nearly constant
}

void Quantized_field::get_frame(std::size_t frame, std::vector<std::uint8_t>& numbers) const
{
  const double top = top_level, last = 255;
  const double scale = m_max > m_min ? top / (m_max - m_min) : 0;
  const double rest_scale = m_largest > m_max ? (last - top) / (m_largest - m_max) : 0;
  numbers.resize(m_vertices->size());
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const double x = (*m_field)((*m_vertices)[v], frame);
    const double level = x <= m_max ? (x - m_min) * scale : top + (x - m_max) * rest_scale;
    numbers[v] = static_cast<std::uint8_t>((std::min)(level, last) + 0.5);
  }
}

} // namespace Programs
