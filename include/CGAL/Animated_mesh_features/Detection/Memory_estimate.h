// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_MEMORY_ESTIMATE_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_MEMORY_ESTIMATE_H

#include <CGAL/Animated_mesh_features/Numerics/memory/available_memory.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

What a detection with the package's own policies needs, in bytes, before anything is computed or read. An estimate from
above for default ball radii on meshes of moderate valence.

Fields can be elsewhere, see `Scratch_field_memory`; `fixed` cannot.
*/
struct Memory_estimate
{
  /// mesh, rest shape, geodesic balls, factors of the heat diffusion.
  std::size_t fixed;

  /// coordinates, and the deformation.
  std::size_t fields;

  /// one space level.
  std::size_t level;

  /// \name Space levels that are in memory at a time
  /// See `Extremum_options::level_memory`.
  /// @{
  static constexpr std::size_t least_levels = 5; ///< at least
  static constexpr std::size_t most_levels = 18; ///< at most
  /// @}

  /// the bytes without which a detection cannot be.
  std::size_t least() const { return fixed + fields + least_levels * level; }

  /// the bytes beyond which more memory does not help.
  std::size_t most() const { return fixed + fields + most_levels * level; }

  /// what is left of `memory` for levels.
  std::size_t for_levels(std::size_t memory) const
  {
    const std::size_t rest = memory > fixed + fields ? memory - fixed - fields : 0;
    return (std::max)(rest, least_levels * level);
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

estimates the memory of a detection, in constant time.

\param number_of_vertices `N`.
\param number_of_frames `F`.
\param scalar_size `sizeof` of the animation's scalar.
*/
inline Memory_estimate
estimated_memory(std::size_t number_of_vertices, std::size_t number_of_frames, std::size_t scalar_size)
{
  const double n = double(number_of_vertices);
  const auto field = [&](std::size_t size) {
    const std::size_t line = 64 / size; // rows are whole cache lines
    return n * double((number_of_frames + line - 1) / line * line * size);
  };
  constexpr double mesh = 600;                         // CGAL's mesh, the rest shape, what reading and renumbering take
  constexpr double ball_entries = 240, ball_entry = 8; // radius of 8 edge lengths; 4 bytes, twice while they are made
  // entries of a Cholesky factor, which grow with the logarithm of N; index and value, of two levels at a time
  const double factor = 2 * 12 * (std::max)(30., 4 * std::log2(n + 1) - 16);
  Memory_estimate estimate;
  estimate.fixed = (std::size_t(1) << 25) + std::size_t(n * (mesh + ball_entries * ball_entry + factor));
  estimate.fields = std::size_t(4 * field(scalar_size));
  estimate.level = std::size_t(field(sizeof(double)));
  return estimate;
}

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

the memory that this process can take without the system having to swap, in bytes; within the limits of a container, if
it runs in one. The largest number where the system does not tell.
*/
inline std::size_t available_memory() { return internal::available_memory(); }

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_MEMORY_ESTIMATE_H
