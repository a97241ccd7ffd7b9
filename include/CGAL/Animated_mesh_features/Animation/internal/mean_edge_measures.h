// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_MEAN_EDGE_MEASURES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_MEAN_EDGE_MEASURES_H

#include <CGAL/Animated_mesh_features/Animation/internal/edge_measure_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/run_in_chunks.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// In an order that does not depend on the width of registers.
template <class L>
CGAL_ANIMATED_MESH_FEATURES_INLINE double sum_of_row(const double* row, std::size_t n)
{
  L sums = L::all(0);
  std::size_t f = 0;
  for (; f + L::size <= n; f += L::size) sums = sums + L::load(row + f);
  double values[L::size], sum = 0;
  sums.store(values);
  for (double value : values) sum += value;
  for (; f < n; ++f) sum += row[f];
  return sum;
}

template <class FT>
struct Mean_measures_loop
{
  Edge_measure_rows<FT>& rows;
  const Triangle_adjacency& adjacency;
  std::size_t frames;
  Edge_measures& mean;
  std::size_t first, last;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<double, Edge_measure_rows<FT>::pack_size, register_bytes> L;
    // Angles whose unit vectors cancel, as those of a hinge that is bent by 90 degrees to either side, have no circular
    // mean; the flat hinge is the middle between them.
    const double cancelled = 1e-6;
    for (std::size_t e = first; e < last; ++e) {
      rows.template measure<register_bytes>(e);
      mean.lengths[e] = sum_of_row<L>(rows.lengths(), frames) / double(frames);
      if (!adjacency.is_interior(e)) continue;
      const double x = sum_of_row<L>(rows.cosines(), frames), y = sum_of_row<L>(rows.sines(), frames);
      const double resultant = std::sqrt(x * x + y * y);
      mean.angles[e] = resultant > cancelled * double(frames) ? Eigen::Vector2d(x / resultant, y / resultant)
                                                              : Eigen::Vector2d(1, 0);
    }
  }
};

// Fourth powers of lengths must be numbers, as squares of areas are computed.
inline void check_range(const std::vector<double>& lengths)
{
  const double largest_usable = 1e70, smallest_usable = 1e-70;
  double largest = 0;
  for (double length : lengths) {
    if (!(length <= largest_usable))
      throw Numerical_error("the canonical shape: edges are too long to compute with: another unit of length is needed");
    largest = (std::max)(largest, length);
  }
  if (largest > 0 && largest < smallest_usable)
    throw Numerical_error("the canonical shape: edges are too short to compute with: another unit of length is needed");
}

// The mean over all frames: of lengths the arithmetic mean, which keeps the triangle inequality; of angles the circular
// mean (K. V. Mardia, P. E. Jupp, Directional Statistics, 2000, sect. 2.2). Complexity: O(F N).
template <class FT, class Loop>
Edge_measures mean_edge_measures(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                 const Triangle_adjacency& adjacency, const Loop& loop)
{
  const std::size_t n = shape.edges().size();
  Edge_measures mean;
  mean.lengths.assign(n, 0);
  mean.angles.assign(n, Eigen::Vector2d::Zero());
  const Instruction_set instructions = widest_instruction_set();
  run_in_chunks(n, loop, [&](std::size_t first, std::size_t last) {
    Edge_measure_rows<FT> rows(shape, adjacency, trajectories);
    Mean_measures_loop<FT> vector_loop{rows, adjacency, trajectories.number_of_frames(), mean, first, last};
    run_reproducibly<double>(instructions, vector_loop);
  });
  check_range(mean.lengths);
  return mean;
}

// The squared distances of some edges from the mean, added for each frame.
template <class FT>
struct Frame_distances_loop
{
  Edge_measure_rows<FT>& rows;
  std::size_t frames;
  const Edge_measures& mean;
  const Rest_shape::Index* edges;
  std::size_t number_of_edges;
  double* distances; // whole packs

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<double, Edge_measure_rows<FT>::pack_size, register_bytes> L;
    for (std::size_t i = 0; i < number_of_edges; ++i) {
      const std::size_t e = edges[i];
      rows.template measure<register_bytes>(e);
      const double length = mean.lengths[e];
      const L l = L::all(length), mean_x = L::all(mean.angles[e].x()), mean_y = L::all(mean.angles[e].y());
      for (std::size_t f = 0; f < frames; f += L::size) {
        const L stretch = L::load(rows.lengths() + f) - l;
        const L x = L::load(rows.cosines() + f) - mean_x, y = L::load(rows.sines() + f) - mean_y;
        (L::load(distances + f) + (stretch * stretch + (x * x + y * y) * (length * length))).store(distances + f);
      }
    }
  }
};

// For each component the frame whose lengths and angles are closest to the mean, the first one of equals.
// Complexity: O(F N) time, a few more numbers than there are coordinates.
template <class FT, class Loop>
std::vector<std::size_t> closest_frames(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                        const Triangle_adjacency& adjacency,
                                        const std::vector<Surface_component>& components, const Edge_measures& mean,
                                        const Loop& loop)
{
  constexpr std::size_t pack_size = Edge_measure_rows<FT>::pack_size;
  const std::size_t frames = trajectories.number_of_frames();
  const std::size_t stride = (frames + pack_size - 1) / pack_size * pack_size;
  struct Part // some edges of a component; sums of its parts are added in their order
  {
    std::size_t component, first, last;
  };
  constexpr std::size_t part_size = 512;
  std::vector<Part> parts;
  for (std::size_t c = 0; c < components.size(); ++c)
    for (std::size_t first = 0, n = components[c].edges.size(); first < n; first += part_size)
      parts.push_back({c, first, (std::min)(n, first + part_size)});
  Aligned_vector<double> distances(parts.size() * stride);
  const Instruction_set instructions = widest_instruction_set();
  loop(parts.size(), [&](std::size_t i) {
    const Part& part = parts[i];
    Edge_measure_rows<FT> rows(shape, adjacency, trajectories);
    Frame_distances_loop<FT> vector_loop{rows,
                                         frames,
                                         mean,
                                         components[part.component].edges.data() + part.first,
                                         part.last - part.first,
                                         distances.data() + i * stride};
    run_reproducibly<double>(instructions, vector_loop);
  });

  std::vector<std::size_t> closest(components.size(), 0);
  std::vector<double> sums(frames);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].first == 0) std::fill(sums.begin(), sums.end(), 0.);
    for (std::size_t f = 0; f < frames; ++f) sums[f] += distances[i * stride + f];
    closest[parts[i].component] = std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin());
  }
  return closest;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_MEAN_EDGE_MEASURES_H
