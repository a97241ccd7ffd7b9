// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_SURFACE_PREDICTION_H
#define PROGRAMS_PAGE_SURFACE_PREDICTION_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Turns whole numbers on the vertices of a moving surface into small ones, which compress well.
//
// A number is predicted to change from one frame to the next as much as that of a neighbouring vertex did: a surface
// moves almost rigidly from place to place. The neighbour is the closest one before in the order of vertices; whoever
// decodes finds it in the triangles, goes through the vertices in order, and has it already. Before the first frame all
// numbers are 0, and a vertex without an earlier neighbour takes the vertex before it.
class Surface_prediction
{
public:
  template <class TriangleRange>
  Surface_prediction(std::size_t number_of_vertices, const TriangleRange& triangles)
    : m_parents(number_of_vertices, none)
  {
    for (const auto& t : triangles)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          const std::size_t v = t[i], w = t[j];
          if (w < v && (m_parents[v] == none || w > m_parents[v])) m_parents[v] = w;
        }
    for (std::size_t v = 1; v < number_of_vertices; ++v)
      if (m_parents[v] == none) m_parents[v] = v - 1;
  }

  // Appends what is left of the numbers of a frame after the prediction from the frame before, one for each vertex:
  // modulo 2^bits of `Number` (8 or 16), signs folded so that small ones are small (0, -1, 1, -2, ...).
  template <class Number>
  void append_residuals(std::vector<Number>& residuals, const std::vector<Number>& before,
                        const std::vector<Number>& now) const
  {
    const unsigned sign = 8 * sizeof(Number) - 1;
    for (std::size_t v = 0; v < m_parents.size(); ++v) {
      unsigned difference = unsigned(now[v]) - unsigned(before[v]);
      if (v > 0) difference -= unsigned(now[m_parents[v]]) - unsigned(before[m_parents[v]]);
      const unsigned number = Number(difference);
      const bool is_negative = (number >> sign) != 0;
      residuals.push_back(Number((number << 1) ^ (is_negative ? ~0u : 0u)));
    }
  }

private:
  static constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> m_parents;
};

// The least significant byte of all numbers, then the next one of all, and so on: the upper bytes of small numbers are
// a long run of zeros.
template <class Number>
std::string byte_planes(const std::vector<Number>& numbers)
{
  std::string planes;
  planes.reserve(numbers.size() * sizeof(Number));
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    for (const Number n : numbers) planes += static_cast<char>(static_cast<unsigned char>(n >> (8 * i)));
  return planes;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PAGE_SURFACE_PREDICTION_H
