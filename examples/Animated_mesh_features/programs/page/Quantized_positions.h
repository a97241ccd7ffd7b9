// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_QUANTIZED_POSITIONS_H
#define PROGRAMS_PAGE_QUANTIZED_POSITIONS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Positions as 16-bit numbers on one grid for all frames, counted from the corner of each frame's own bounding box: as
// fine for a body that walks far as for one that stays.
//
//   position = origin + step * (corner(frame) + number)
template <class Trajectories>
class Quantized_positions
{
public:
  explicit Quantized_positions(const Trajectories& animation)
    : m_animation(&animation)
    , m_boxes(animation.number_of_frames())
  {
    const double infinity = std::numeric_limits<double>::infinity();
    m_origin.fill(infinity);
    double longest = 0;
    for (std::size_t f = 0; f < m_boxes.size(); ++f) {
      Box& box = m_boxes[f];
      for (std::size_t c = 0; c < 3; ++c) {
        box.min[c] = infinity;
        double max = -infinity;
        for (std::size_t v = 0; v < animation.number_of_vertices(); ++v) {
          const double x = coordinate(c, v, f);
          box.min[c] = (std::min)(box.min[c], x);
          max = (std::max)(max, x);
        }
        longest = (std::max)(longest, max - box.min[c]);
        m_origin[c] = (std::min)(m_origin[c], box.min[c]);
      }
    }
    // Rounding both ends can add a step.
    const double most_steps = 65534;
    m_step = longest > 0 ? longest / most_steps : 1;
  }

  const std::array<double, 3>& origin() const { return m_origin; }
  double step() const { return m_step; }

  // In steps from the origin.
  std::int64_t corner(std::size_t c, std::size_t frame) const { return steps(c, m_boxes[frame].min[c]); }

  // No vertex is farther from where it was.
  double largest_error() const { return std::sqrt(3.) / 2 * m_step; }

  void get_frame(std::size_t c, std::size_t frame, std::vector<std::uint16_t>& numbers) const
  {
    const std::int64_t first = corner(c, frame);
    numbers.resize(m_animation->number_of_vertices());
    for (std::size_t v = 0; v < numbers.size(); ++v)
      numbers[v] = static_cast<std::uint16_t>(steps(c, coordinate(c, v, frame)) - first);
  }

private:
  struct Box
  {
    std::array<double, 3> min;
  };

  double coordinate(std::size_t c, std::size_t v, std::size_t f) const
  {
    return double(c == 0 ? m_animation->x(v, f) : c == 1 ? m_animation->y(v, f) : m_animation->z(v, f));
  }

  std::int64_t steps(std::size_t c, double x) const { return std::llround((x - m_origin[c]) / m_step); }

  const Trajectories* m_animation;
  std::vector<Box> m_boxes;
  std::array<double, 3> m_origin;
  double m_step = 1;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PAGE_QUANTIZED_POSITIONS_H
