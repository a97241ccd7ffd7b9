// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_QUANTIZED_FIELD_H
#define PROGRAMS_PAGE_QUANTIZED_FIELD_H

#include "scenes/Shown_scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Programs {

// A field as 8-bit numbers: 0 is its minimum, `top_level` the value that 99.5 % of it do not exceed, linear between them,
// and from there to 255, in coarser steps, its maximum. A few vertices at which the surface is torn would otherwise leave
// one colour for all the rest; curves over time show them nevertheless.
class Quantized_field
{
public:
  // Of some vertices, in that order. Refers to field and vertices; its extent is that of the vertices in `frames`.
  Quantized_field(const Shown_values& field, const std::vector<std::size_t>& vertices,
                  const std::vector<std::size_t>& frames);

  static constexpr std::uint8_t top_level = 223;

  double min() const { return m_min; }
  double max() const { return m_max; }
  double largest() const { return m_largest; }

  void get_frame(std::size_t frame, std::vector<std::uint8_t>& numbers) const;

private:
  const Shown_values* m_field;
  const std::vector<std::size_t>* m_vertices;
  double m_min = 0, m_max = 0, m_largest = 0;
};

} // namespace Programs

#endif // PROGRAMS_PAGE_QUANTIZED_FIELD_H
