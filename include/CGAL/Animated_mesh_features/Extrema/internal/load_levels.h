// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LOAD_LEVELS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LOAD_LEVELS_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The rows of one vertex at the space levels of a batch, as a pack for each frame: space level first_level() + i is
// entry i, those after the last are zero. What acts on time then acts on all levels at once, without a shift within a
// register. `packs` is empty, or has another vertex of the same batch.
template <class Level_pack>
void load_levels(const Level_batch& batch, std::size_t v, std::size_t number_of_frames, std::vector<Level_pack>& packs)
{
  typedef typename Level_pack::Scalar T;
  if (packs.size() != number_of_frames) packs.assign(number_of_frames, Level_pack::all(0));
  T* const numbers = reinterpret_cast<T*>(packs.data());
  const std::size_t first = batch.first_level(), levels = batch.last_level() - first;
  for (std::size_t i = 0; i < levels; ++i) {
    const double* const row = batch.row(first + i, v);
    for (std::size_t f = 0; f < number_of_frames; ++f) numbers[f * Level_pack::size + i] = T(row[f]);
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LOAD_LEVELS_H
