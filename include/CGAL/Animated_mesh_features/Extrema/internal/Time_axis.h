// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TIME_AXIS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TIME_AXIS_H

#include <CGAL/Animated_mesh_features/Scale_space/is_periodic.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The frames of an animation, which of them are neighbours, and which have two of them: an extremum has a frame before and
// one after it.
class Time_axis
{
public:
  Time_axis(std::size_t number_of_frames, bool is_cyclic)
    : m_frames(number_of_frames)
    , m_is_cyclic(is_cyclic)
  {}

  // Of what a temporal filter has smoothed.
  template <class TemporalFilter>
  Time_axis(std::size_t number_of_frames, const TemporalFilter& filter)
    : Time_axis(number_of_frames, is_periodic(filter))
  {}

  std::size_t number_of_frames() const { return m_frames; }
  bool is_cyclic() const { return m_is_cyclic; }

  // Of frames that have both.
  std::size_t before(std::size_t f) const { return f > 0 ? f - 1 : m_frames - 1; }
  std::size_t after(std::size_t f) const { return f + 1 < m_frames ? f + 1 : 0; }

  // How many frames a row takes on at either end, so that each of its own has a neighbour there: a cyclic one the last frame
  // before the first, and the first after the last.
  std::size_t margin() const { return m_is_cyclic ? 1 : 0; }

  // Fills them in, of a row that begins `margin()` frames after `row`.
  template <class T>
  void join_ends(T* row) const
  {
    if (!m_is_cyclic) return;
    row[0] = row[m_frames];
    row[m_frames + 1] = row[1];
  }

  // A position between frames that may lie up to a frame beyond the ends.
  double wrapped(double frame) const
  {
    if (!m_is_cyclic) return frame;
    const double period = double(m_frames), result = frame < 0 ? frame + period : frame;
    return result < period ? result : result - period; // also where a tiny number is lost beside the period
  }

private:
  std::size_t m_frames;
  bool m_is_cyclic;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TIME_AXIS_H
