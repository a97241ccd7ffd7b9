// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_QUANTIZED_POSITIONS_H
#define PROGRAMS_PAGE_QUANTIZED_POSITIONS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Programs {

// Positions as 16-bit numbers on one grid for all frames, counted from the corner of each frame's own bounding box: as
// fine for a body that walks far as for one that stays.
//
//   position = origin + step * (corner(frame) + number)
class Quantized_positions
{
public:
  typedef CGAL::Animated_mesh_features::Vertex_trajectories<double> Trajectories;

  // Of some vertices of the animation, in that order. All are referred to.
  Quantized_positions(const Trajectories& animation, const CGAL::Animated_mesh_features::Rest_shape& shape,
                      const std::vector<std::size_t>& vertices);

  const std::array<double, 3>& origin() const { return m_origin; }
  double step() const { return m_step; }

  // In steps from the origin.
  std::int64_t corner(std::size_t c, std::size_t frame) const { return steps(c, m_corners[frame][c]); }

  // No vertex is farther from where it was.
  double largest_error() const;

  void get_frame(std::size_t c, std::size_t frame, std::vector<std::uint16_t>& numbers) const;

private:
  double coordinate(std::size_t c, std::size_t v, std::size_t f) const;
  std::int64_t steps(std::size_t c, double x) const;

  const Trajectories* m_animation;
  const CGAL::Animated_mesh_features::Rest_shape* m_shape;
  const std::vector<std::size_t>* m_vertices;
  std::vector<std::array<double, 3>> m_corners; // of each frame's bounding box
  std::array<double, 3> m_origin;
  double m_step = 1;
};

} // namespace Programs

#endif // PROGRAMS_PAGE_QUANTIZED_POSITIONS_H
