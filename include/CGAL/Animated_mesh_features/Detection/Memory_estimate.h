// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_MEMORY_ESTIMATE_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_MEMORY_ESTIMATE_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/default_ball_radius.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/available_memory.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/number_of_threads.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

What a detection with the package's own policies needs, in bytes. An estimate from above for default ball radii on
meshes of moderate valence: not exceeded, and not more than about twice what is taken at last.

Fields can be elsewhere, see `Scratch_field_memory`; `fixed` cannot.
*/
struct Memory_estimate
{
  /// mesh, rest shape, geodesic balls, factors of the heat diffusion, temporal weights, and what each thread has of a
  /// vertex or a cluster of vertices.
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

namespace internal {

// Without the balls.
inline Memory_estimate memory_without_balls(std::size_t number_of_vertices, std::size_t number_of_frames,
                                            std::size_t scalar_size, std::size_t number_of_threads)
{
  const double n = double(number_of_vertices), frames = double(number_of_frames);
  const auto field = [&](std::size_t size) {
    const std::size_t line = 64 / size; // rows are whole cache lines
    return n * double((number_of_frames + line - 1) / line * line * size);
  };
  constexpr double mesh = 600; // CGAL's mesh, the rest shape, what reading and renumbering take
  // entries of a Cholesky factor, which grow with the logarithm of N; index and value, of two levels at a time
  const double factor = 2 * 12 * (std::max)(30., 4 * std::log2(n + 1) - 16);
  // The levels of a row in time, of which `published` has most by default: matrices of F x F up to 64 MB for short
  // rows, weights by distance for long ones, once on one side and once on both.
  constexpr double levels = 56, largest_matrices = 1 << 26, longest_with_matrices = 1024;
  const double weights = frames <= longest_with_matrices ? (std::min)(largest_matrices, levels * frames * frames * 8)
                                                         : levels * 3 * frames * 8;
  // Of a vertex, for each frame: a dozen packs of the search in single precision and as many in double precision, each
  // a cache line or three, and the rows of weights.
  constexpr double packs = 2600;
  Memory_estimate estimate;
  estimate.fixed = (std::size_t(1) << 25) +
                   std::size_t(n * (mesh + factor) + weights + double(number_of_threads) * packs * frames);
  estimate.fields = std::size_t(4 * field(scalar_size));
  estimate.level = std::size_t(field(sizeof(double)));
  return estimate;
}

// How many vertices the default ball of a vertex has.
struct Ball_sizes
{
  double mean = 0, largest = 0;
};

// By shortest paths from some vertices, all over the shape.
inline Ball_sizes sampled_ball_sizes(const Rest_shape& shape)
{
  constexpr std::size_t most_samples = 256;
  constexpr double reach = 1.1; // paths along edges are longer than geodesics by that
  const std::size_t n = shape.number_of_vertices(), samples = (std::min)(n, most_samples);
  const double radius = reach * default_ball_radius(shape);
  Bounded_dijkstra dijkstra(shape);
  Ball_sizes result;
  for (std::size_t i = 0; i < samples; ++i) {
    const std::array<Rest_shape::Index, 1> centre = {{Rest_shape::Index(i * n / samples)}};
    const double size = double(dijkstra.run(centre, radius).size());
    result.mean += size / double(samples);
    result.largest = (std::max)(result.largest, size);
  }
  return result;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

estimates the memory of a detection, in constant time, before anything is read. Geodesic balls are taken as those of a
mesh with edges of about one length.

\param number_of_vertices `N`.
\param number_of_frames `F`.
\param scalar_size `sizeof` of the animation's scalar.
\param number_of_threads each has rows of a vertex of its own; by default as many as loops run on.
*/
inline Memory_estimate estimated_memory(std::size_t number_of_vertices, std::size_t number_of_frames,
                                        std::size_t scalar_size,
                                        std::size_t number_of_threads = internal::number_of_threads())
{
  Memory_estimate estimate =
      internal::memory_without_balls(number_of_vertices, number_of_frames, scalar_size, number_of_threads);
  // radius of 8 edge lengths; 4 bytes, twice while they are made
  constexpr std::size_t ball_entries = 240, ball_entry = 8;
  estimate.fixed += number_of_vertices * ball_entries * ball_entry;
  return estimate;
}

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

the same for a shape that is known: geodesic balls are counted, at some vertices. In a part of the mesh that is denser
than the whole they have many more vertices than elsewhere.

\param shape the rest shape.
\param number_of_frames `F`.
\param scalar_size `sizeof` of the animation's scalar.
\param number_of_threads each has a patch of the shape and rows of a vertex of its own; by default as many as loops
run on.
*/
inline Memory_estimate estimated_memory(const Rest_shape& shape, std::size_t number_of_frames, std::size_t scalar_size,
                                        std::size_t number_of_threads = internal::number_of_threads())
{
  const double n = double(shape.number_of_vertices());
  Memory_estimate estimate =
      internal::memory_without_balls(shape.number_of_vertices(), number_of_frames, scalar_size, number_of_threads);
  const internal::Ball_sizes balls = internal::sampled_ball_sizes(shape);
  // a patch for a cluster of balls has a multiple of the largest ball's vertices, each with its part of two factors
  constexpr double ball_entry = 6, patch_over_ball = 7, patch_vertex = 1500;
  const double patch = (std::min)(n, patch_over_ball * balls.largest) * patch_vertex;
  estimate.fixed += std::size_t(n * balls.mean * ball_entry + double(number_of_threads) * patch);
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
