// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Quantized_field.h"

#include <algorithm>

namespace Programs {

Quantized_field::Quantized_field(const Shown_values& field, const std::vector<std::size_t>& frames)
  : m_field(&field)
{
  const double shown = 0.995;
  std::vector<double> values;
  values.reserve(field.number_of_rows() * frames.size());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
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
  const double levels = 255, scale = m_max > m_min ? levels / (m_max - m_min) : 0;
  numbers.resize(m_field->number_of_rows());
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const double level = ((*m_field)(v, frame) - m_min) * scale;
    numbers[v] = static_cast<std::uint8_t>((std::min)(level, levels) + 0.5);
  }
}

} // namespace Programs
