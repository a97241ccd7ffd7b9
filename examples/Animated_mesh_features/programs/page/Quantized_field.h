// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_QUANTIZED_FIELD_H
#define PROGRAMS_PAGE_QUANTIZED_FIELD_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A field as 8-bit numbers: 0 is its minimum, 255 the value that 99.5 % of it do not exceed, and all above. A few
// vertices at which the surface is torn would otherwise leave one colour for all the rest.
template <class FT>
class Quantized_field
{
public:
  Quantized_field(const Spatio_temporal_field<FT>& field, const std::vector<std::size_t>& frames)
    : m_field(&field)
  {
    const double shown = 0.995;
    std::vector<FT> values;
    values.reserve(field.number_of_rows() * frames.size());
    for (std::size_t v = 0; v < field.number_of_rows(); ++v)
      for (const std::size_t f : frames) values.push_back(field(v, f));
    if (values.empty()) return;
    const auto ends = std::minmax_element(values.begin(), values.end());
    m_min = double(*ends.first);
    m_largest = double(*ends.second);
    const auto top = values.begin() + std::ptrdiff_t(shown * double(values.size() - 1));
    std::nth_element(values.begin(), top, values.end());
    m_max = double(*top);
    if (!(m_max > m_min)) m_max = m_largest; // nearly constant
  }

  double min() const { return m_min; }
  double max() const { return m_max; }
  double largest() const { return m_largest; }

  void get_frame(std::size_t frame, std::vector<std::uint8_t>& numbers) const
  {
    const double levels = 255, scale = m_max > m_min ? levels / (m_max - m_min) : 0;
    numbers.resize(m_field->number_of_rows());
    for (std::size_t v = 0; v < numbers.size(); ++v) {
      const double level = (double((*m_field)(v, frame)) - m_min) * scale;
      numbers[v] = static_cast<std::uint8_t>((std::min)(level, levels) + 0.5);
    }
  }

private:
  const Spatio_temporal_field<FT>* m_field;
  double m_min = 0, m_max = 0, m_largest = 0;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PAGE_QUANTIZED_FIELD_H
