// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Surface_prediction.h"

namespace Programs {

Surface_prediction::Surface_prediction(std::size_t number_of_vertices, const Triangles& triangles)
  : m_parents(number_of_vertices, number_of_vertices)
{
  const std::size_t none = number_of_vertices;
  for (const auto& t : triangles)
    for (const std::size_t v : t)
      for (const std::size_t w : t)
        if (w < v && (m_parents[v] == none || w > m_parents[v])) m_parents[v] = w;
  for (std::size_t v = 1; v < number_of_vertices; ++v)
    if (m_parents[v] == none) m_parents[v] = v - 1;
}

} // namespace Programs
