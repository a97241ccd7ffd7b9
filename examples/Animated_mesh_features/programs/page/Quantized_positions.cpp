// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Quantized_positions.h"

#include "running/Interruption.h"
#include "scenes/Shown_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Programs {

Quantized_positions::Quantized_positions(const Trajectories& animation,
                                         const CGAL::Animated_mesh_features::Rest_shape& shape,
                                         const std::vector<std::size_t>& vertices)
  : m_animation(&animation)
  , m_shape(&shape)
  , m_vertices(&vertices)
  , m_corners(animation.number_of_frames())
{
  const double infinity = std::numeric_limits<double>::infinity();
  m_origin.fill(infinity);
  double longest = 0;
  for (std::size_t f = 0; f < m_corners.size(); ++f) {
    Interruption::check();
    for (std::size_t c = 0; c < 3; ++c) {
      double min = infinity, max = -infinity;
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double x = coordinate(c, v, f);
        min = (std::min)(min, x);
        max = (std::max)(max, x);
      }
      m_corners[f][c] = min;
      longest = (std::max)(longest, max - min);
      m_origin[c] = (std::min)(m_origin[c], min);
    }
  }
  // Rounding both ends can add a step.
  const double most_steps = 65534;
  m_step = longest > 0 ? longest / most_steps : 1;
}

double Quantized_positions::largest_error() const
{
  return std::sqrt(3.) / 2 * m_step;
}

void Quantized_positions::get_frame(std::size_t c, std::size_t frame, std::vector<std::uint16_t>& numbers) const
{
  const std::int64_t first = corner(c, frame);
  numbers.resize(m_vertices->size());
  for (std::size_t v = 0; v < numbers.size(); ++v)
    numbers[v] = static_cast<std::uint16_t>(steps(c, coordinate(c, v, frame)) - first);
}

double Quantized_positions::coordinate(std::size_t c, std::size_t i, std::size_t f) const
{
  const std::size_t v = shown_vertex(*m_shape, (*m_vertices)[i]);
  return c == 0 ? m_animation->x(v, f) : c == 1 ? m_animation->y(v, f) : m_animation->z(v, f);
}

std::int64_t Quantized_positions::steps(std::size_t c, double x) const
{
  return std::llround((x - m_origin[c]) / m_step);
}

} // namespace Programs
