// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_CURVATURE_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_CURVATURE_ROWS_H

#include <CGAL/Animated_mesh_features/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/internal/Thread_local.h>
#include <CGAL/Animated_mesh_features/internal/dihedral_angle_rows.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The two sums of a curvature measure over each ball, one block of frames at a time: all intermediate values of a
// block (a cache line for each edge and vertex) stay in the caches.
template <class FT, class Measure>
class Curvature_block
{
  typedef typename Frame_block<FT>::Array Array;

public:
  Curvature_block(const Flat_animation<FT>& animation, const Compressed_rows& balls, const Measure& measure)
    : m_animation(animation)
    , m_shape(animation.rest)
    , m_balls(balls)
    , m_measure(measure)
    , m_factor(FT(measure.factor(m_shape)))
    , m_scale(FT(1 / m_shape.mean_edge_length()))
    , m_numerators(m_shape.edges().size())
    , m_edge_denominators(m_shape.edges().size())
    , m_triangle_denominators(m_shape.triangles().size())
    , m_vertex_numerators(m_shape.number_of_vertices())
    , m_vertex_denominators(m_shape.number_of_vertices())
  {
  }

  // write(v, curvatures of v in the frames of the block) for each vertex; 0 where a ball has nothing to sum.
  template <class Loop, class Write>
  void run(std::size_t block, const Loop& loop, const Write& write)
  {
    loop.part(0, 4)(m_shape.edges().size(), [&](std::size_t e) {
      const Edge_block<FT> edge = edge_block(m_animation, m_shape.edges()[e], block, m_scale);
      m_numerators[e] = m_measure.edge_numerator(edge.angle, edge.length);
      m_edge_denominators[e] = m_measure.edge_denominator(edge.angle, edge.length);
      // the angle at a border edge is not zero but unknown: the edge does not count
      if (m_shape.edges()[e].is_border()) m_numerators[e].setZero(), m_edge_denominators[e].setZero();
    });
    loop.part(1, 4)(m_shape.triangles().size(), [&](std::size_t t) {
      m_triangle_denominators[t] =
          m_measure.triangle_denominator(area_block(m_animation, m_shape.triangles()[t], block, m_scale));
    });
    if (Measure::membership == Ball_membership::FRACTION) {
      share_out(loop.part(2, 4));
      loop.part(3, 4)(m_balls.size(), [&](std::size_t v) {
        Array numerator = Array::Zero(), denominator = Array::Zero();
        for (Compressed_rows::Index w : m_balls[v]) {
          numerator += m_vertex_numerators[w];
          denominator += m_vertex_denominators[w];
        }
        write(v, quotient(numerator, denominator));
      });
    } else {
      loop.part(3, 4)(m_balls.size(), [&](std::size_t v) { write(v, whole(v)); });
    }
  }

private:
  // With weights that are fractions of corners, the sum over a ball's edges and triangles is the sum over its vertices
  // of half of their edges and a third of their triangles.
  template <class Loop>
  void share_out(const Loop& loop)
  {
    loop(m_shape.number_of_vertices(), [&](std::size_t v) {
      Array numerator = Array::Zero(), denominator = Array::Zero();
      for (Rest_shape::Index e : m_shape.incident_edges()[v]) {
        numerator += m_numerators[e];
        denominator += m_edge_denominators[e];
      }
      Array thirds = Array::Zero();
      for (Rest_shape::Index t : m_shape.incident_triangles()[v]) thirds += m_triangle_denominators[t];
      m_vertex_numerators[v] = numerator * FT(1. / 2);
      m_vertex_denominators[v] = denominator * FT(1. / 2) + thirds * FT(1. / 3);
    });
  }

  // Edges and triangles with all corners in the ball, each met at its smallest vertex.
  Array whole(std::size_t centre)
  {
    const Compressed_rows::Row ball = m_balls[centre];
    // marks[w] is the last ball on this thread that contained w
    std::vector<Rest_shape::Index>& marks = m_marks.get([this] {
      return std::make_unique<std::vector<Rest_shape::Index>>(m_shape.number_of_vertices(), Rest_shape::none);
    });
    for (Rest_shape::Index w : ball) marks[w] = Rest_shape::Index(centre);
    const auto inside = [&](Rest_shape::Index w) { return marks[w] == centre; };
    Array numerator = Array::Zero(), denominator = Array::Zero();
    for (Rest_shape::Index v : ball) {
      for (Rest_shape::Index e : m_shape.incident_edges()[v])
        if (m_shape.edges()[e].source == v && inside(m_shape.edges()[e].target)) {
          numerator += m_numerators[e];
          denominator += m_edge_denominators[e];
        }
      for (Rest_shape::Index t : m_shape.incident_triangles()[v]) {
        const Rest_shape::Triangle& c = m_shape.triangles()[t];
        if (c[0] == v && inside(c[1]) && inside(c[2])) denominator += m_triangle_denominators[t];
      }
    }
    return quotient(numerator, denominator);
  }

  Array quotient(const Array& numerator, const Array& denominator) const
  {
    Array result;
    for (int i = 0; i < result.size(); ++i)
      result[i] = denominator[i] > 0 ? m_factor * numerator[i] / denominator[i] : FT(0);
    return result;
  }

  const Flat_animation<FT>& m_animation;
  const Rest_shape& m_shape;
  const Compressed_rows& m_balls;
  Measure m_measure;
  FT m_factor, m_scale;
  std::vector<Array> m_numerators, m_edge_denominators, m_triangle_denominators;
  std::vector<Array> m_vertex_numerators, m_vertex_denominators;
  Thread_local<std::vector<Rest_shape::Index>> m_marks;
};

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> curvature_rows(const Flat_animation<FT>& animation,
                                         const Compressed_rows& balls,
                                         const Measure& measure,
                                         const Loop& loop)
{
  typedef Frame_block<FT> Block;
  Spatio_temporal_field<FT> field(animation.number_of_vertices(), animation.number_of_frames());
  Curvature_block<FT, Measure> sums(animation, balls, measure);
  const std::size_t blocks = Block::number_of_blocks(animation.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b)
    sums.run(b, loop.part(b, blocks),
             [&](std::size_t v, const typename Block::Array& k) { Block::at(field, v, b) = k; });
  return field;
}

// The rest shape as an animation of one frame, so that its curvature is computed by the very same operations: a
// frame that equals the rest shape has a change of curvature of exactly zero.
template <class FT>
Flat_animation<FT> rest_as_animation(const Rest_shape& shape)
{
  Flat_animation<FT> rest;
  rest.rest = shape;
  rest.resize(shape.number_of_vertices(), 1);
  for (std::size_t v = 0; v < shape.number_of_vertices(); ++v) {
    rest.x(v, 0) = FT(shape.points()[v][0]);
    rest.y(v, 0) = FT(shape.points()[v][1]);
    rest.z(v, 0) = FT(shape.points()[v][2]);
  }
  return rest;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_CURVATURE_ROWS_H
