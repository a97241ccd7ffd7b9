// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_BATCH_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_BATCH_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The space levels that are in memory, and the range of those at which extrema are searched for.
struct Level_batch
{
  typedef Spatio_temporal_field<double> Field;

  std::vector<std::shared_ptr<Field>> levels; // by level; those of the batch exist
  std::size_t first, last;                    // extrema in [first, last)
  std::size_t below, above;                   // reach of a response's differences

  // the levels from which the responses in [first - 1, last + 1) are made
  std::size_t first_level() const { return first - 1 - below; }
  std::size_t last_level() const { return last + 1 + above; }

  const double* row(std::size_t k, std::size_t v) const { return levels[k]->row(v); }

  // the same for fewer extrema
  Level_batch part(std::size_t part_first, std::size_t part_last) const
  {
    return {levels, part_first, part_last, below, above};
  }
};

// A sample that may be an extremum.
struct Candidate
{
  std::uint32_t vertex, frame, k, l;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_BATCH_H
