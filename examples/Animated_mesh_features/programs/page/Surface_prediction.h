// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_SURFACE_PREDICTION_H
#define PROGRAMS_PAGE_SURFACE_PREDICTION_H

#include "scenes/surface_shapes.h"

#include <cstddef>
#include <vector>

namespace Programs {

// Turns whole numbers on the vertices of a moving surface into small ones, which compress well.
//
// A number is predicted to change from one frame to the next as much as that of a neighbouring vertex did: a surface
// moves almost rigidly from place to place. The neighbour is the closest one before in the order of vertices; whoever
// decodes finds it in the triangles, goes through the vertices in order, and has it already. Before the first frame all
// numbers are 0, and a vertex without an earlier neighbour takes the vertex before it.
class Surface_prediction
{
public:
  Surface_prediction(std::size_t number_of_vertices, const Triangles& triangles);

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
  std::vector<std::size_t> m_parents;
};

} // namespace Programs

#endif // PROGRAMS_PAGE_SURFACE_PREDICTION_H
