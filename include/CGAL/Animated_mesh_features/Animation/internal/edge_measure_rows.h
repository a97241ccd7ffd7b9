// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURE_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURE_ROWS_H

#include <CGAL/Animated_mesh_features/Animation/internal/Edge_measures.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Packed_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/pack_math.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The measures of single edges in all frames, which are contiguous in memory: a pack of them at a time.
template <class FT>
class Edge_measure_rows
{
public:
  static constexpr std::size_t pack_size = 8; // a cache line of double; rows of float are padded to twice as many

  Edge_measure_rows(const Rest_shape& shape, const Triangle_adjacency& adjacency,
                    const Vertex_trajectories<FT>& trajectories)
    : m_shape(shape)
    , m_adjacency(adjacency)
    , m_trajectories(trajectories)
    , m_size((trajectories.number_of_frames() + pack_size - 1) / pack_size * pack_size)
    , m_values(3 * m_size)
  {}

  // Measures an edge. What is in the padding after the last frame is nothing's.
  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void measure(std::size_t e)
  {
    typedef Pack<double, pack_size, register_bytes> L;
    const Rest_shape::Edge& edge = m_shape.edges()[e];
    if (!m_adjacency.is_interior(e)) {
      for (std::size_t f = 0; f < m_size; f += pack_size) {
        const Packed_vector<L> d = difference<L>(edge.source, edge.target, f);
        sqrt(d.dot(d)).store(lengths() + f);
        L::all(0).store(cosines() + f);
        L::all(0).store(sines() + f);
      }
      return;
    }
    // of the triangles' squared heights, compared with the squares of their longest sides
    double least[pack_size];
    std::fill_n(least, pack_size, (std::numeric_limits<double>::max)());
    for (std::size_t f = 0; f < m_size; f += pack_size) {
      const L excess = measure_angle<L>(edge, f);
      double values[pack_size];
      excess.store(values);
      const std::size_t frames = (std::min)(pack_size, m_trajectories.number_of_frames() - f);
      // false for what is not a number, too
      for (std::size_t i = 0; i < frames; ++i) least[i] = values[i] > 0 ? least[i] : 0;
    }
    if (!(*std::min_element(least, least + pack_size) > 0)) measure_flat(e);
  }

  double* lengths() { return m_values.data(); }
  double* cosines() { return m_values.data() + m_size; } // of the angle, as in Edge_measures
  double* sines() { return m_values.data() + 2 * m_size; }

private:
  struct Rows
  {
    const FT *x, *y, *z;
    std::size_t stride;
  };

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE Packed_vector<L> difference(std::size_t from, std::size_t to, std::size_t f) const
  {
    const Rows rows = {m_trajectories.x.row(0) + f, m_trajectories.y.row(0) + f, m_trajectories.z.row(0) + f,
                       m_trajectories.x.stride()};
    return Packed_vector<L>::load(rows, to) - Packed_vector<L>::load(rows, from);
  }

  // With d from source to target and the triangles' normals l = d x u and r = w x d:
  // |l| |r| sin = -|d| (l . w), |l| |r| cos = l . r.
  // Returns what is positive where both triangles have height.
  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE L measure_angle(const Rest_shape::Edge& edge, std::size_t f)
  {
    const Packed_vector<L> d = difference<L>(edge.source, edge.target, f), u = difference<L>(edge.source, edge.left, f),
                           w = difference<L>(edge.source, edge.right, f), l = d.cross(u), r = w.cross(d), du = u - d,
                           dw = w - d;
    const L dd = d.dot(d), ll = l.dot(l), rr = r.dot(r), length = sqrt(dd);
    const L left = maximum(maximum(u.dot(u), du.dot(du)), dd), right = maximum(maximum(w.dot(w), dw.dot(dw)), dd);
    const L scale = L::all(1) / (sqrt(ll) * sqrt(rr));
    length.store(lengths() + f);
    (l.dot(r) * scale).store(cosines() + f);
    (l.dot(w) * length * scale * -1.).store(sines() + f);
    const double flat = std::numeric_limits<double>::epsilon(); // the square of the least height
    const L left_excess = ll - left * left * flat, right_excess = rr - right * right * flat;
    return where_greater(right_excess, left_excess, left_excess, right_excess);
  }

  // One frame after the other, for the sake of those in which a triangle has no height.
  CGAL_ANIMATED_MESH_FEATURES_NO_INLINE void measure_flat(std::size_t e)
  {
    for (std::size_t f = 0; f < m_trajectories.number_of_frames(); ++f) {
      const Eigen::Vector2d angle = Surface_frame<FT>(m_shape, m_adjacency, m_trajectories, f).angle(e);
      cosines()[f] = angle.x();
      sines()[f] = angle.y();
    }
  }

  const Rest_shape& m_shape;
  const Triangle_adjacency& m_adjacency;
  const Vertex_trajectories<FT>& m_trajectories;
  std::size_t m_size;
  Aligned_vector<double> m_values;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_EDGE_MEASURE_ROWS_H
