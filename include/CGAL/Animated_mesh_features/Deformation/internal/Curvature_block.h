// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_CURVATURE_BLOCK_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_CURVATURE_BLOCK_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Deformation/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/dihedral_angle_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/run_in_chunks.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The two sums of a curvature measure over each ball, one block of frames at a time: what is kept of a block is, at most,
// a cache line for each triangle and two for each edge and vertex.
template <class FT, class Measure>
class Curvature_block
{
  static constexpr std::size_t pack_size = Frame_pack<FT>::size;
  static constexpr bool is_fraction = Measure::membership == Ball_membership::FRACTION;
  typedef Denominators<Measure> Terms;
  static constexpr std::size_t edge_size = Terms::of_edges ? 2 * pack_size : pack_size; // numerators, then denominators

public:
  Curvature_block(const Rest_shape& shape, const Compressed_rows& balls, const Measure& measure,
                  Instruction_set instructions)
    : m_shape(shape)
    , m_balls(balls)
    , m_measure(measure)
    , m_instructions(instructions)
    , m_factor(FT(measure.factor(m_shape)))
    , m_scale(FT(1 / m_shape.mean_edge_length()))
    , m_edges(edge_size * m_shape.edges().size())
    , m_triangles(Terms::of_triangles ? pack_size * m_shape.triangles().size() : 0)
    , m_vertices(is_fraction ? 2 * pack_size * m_shape.number_of_vertices() : 0)
  {
    if (!is_fraction) find_first_simplices();
  }

  // write(v, curvatures), a pack that is to be stored as that of v, for each vertex; 0 where a ball has nothing to sum.
  template <class Loop, class Write>
  void run(const Position_rows<FT>& positions, const Loop& loop, const Write& write)
  {
    run_in_chunks(m_shape.edges().size(), loop.part(0, 4), [&](std::size_t first, std::size_t last) {
      run_range(
          [&](auto type, std::size_t e)
              CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA { measure_edge<typename decltype(type)::Pack>(positions, e); },
          first, last);
    });
    if (Terms::of_triangles)
      run_in_chunks(m_shape.triangles().size(), loop.part(1, 4), [&](std::size_t first, std::size_t last) {
        run_range(
            [&](auto type, std::size_t t) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
              measure_triangle<typename decltype(type)::Pack>(positions, t);
            },
            first, last);
      });
    if (is_fraction)
      run_in_chunks(m_shape.number_of_vertices(), loop.part(2, 4), [&](std::size_t first, std::size_t last) {
        run_range([&](auto type, std::size_t v)
                       CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA { share_out<typename decltype(type)::Pack>(v); },
                   first, last);
      });
    run_in_chunks(m_balls.size(), loop.part(3, 4), [&](std::size_t first, std::size_t last) {
      run_range(
          [&](auto type, std::size_t v) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
            typedef typename decltype(type)::Pack L;
            if constexpr (is_fraction)
              write(v, sum_over_vertices<L>(v));
            else
              write(v, sum_over_whole<L>(v));
          },
          first, last);
    });
  }

private:
  // Edges are sorted by their smaller vertex, ordered triangles by their smallest.
  void find_first_simplices()
  {
    const std::size_t n = m_shape.number_of_vertices();
    m_first_edge.assign(n + 1, 0);
    m_first_triangle.assign(n + 1, 0);
    for (const Rest_shape::Edge& e : m_shape.edges()) ++m_first_edge[e.source + 1];
    for (const Rest_shape::Triangle& t : m_shape.triangles()) ++m_first_triangle[t[0] + 1];
    for (std::size_t v = 0; v < n; ++v) {
      m_first_edge[v + 1] += m_first_edge[v];
      m_first_triangle[v + 1] += m_first_triangle[v];
    }
  }

  // Tells a function for which type of pack it is called.
  template <class L>
  struct Type
  {
    typedef L Pack;
  };

  // function(type, i) for i in [first, last), with the instructions that were asked for
  template <class Function>
  struct Range_loop
  {
    const Function& function;
    std::size_t first, last;

    template <std::size_t register_bytes>
    CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
    {
      for (std::size_t i = first; i < last; ++i) function(Type<Pack<FT, pack_size, register_bytes>>(), i);
    }
  };

  template <class Function>
  void run_range(const Function& function, std::size_t first, std::size_t last) const
  {
    Range_loop<Function> range_loop{function, first, last};
    run_reproducibly<FT>(m_instructions, range_loop);
  }

  template <class L, class Function, class... Arguments>
  static CGAL_ANIMATED_MESH_FEATURES_INLINE L call(const Function& function, const Arguments&... arguments)
  {
    if constexpr (Takes_packs<Measure>::value)
      return function(arguments...);
    else
      return call_with_arrays<L>(function, arguments...);
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void measure_edge(const Position_rows<FT>& positions, std::size_t e)
  {
    FT* to = m_edges.data() + edge_size * e;
    if (m_shape.edges()[e].is_border()) { // the angle is not zero but unknown: the edge does not count
      std::fill_n(to, edge_size, FT(0));
      return;
    }
    const Edge_pack<L> edge = measured_edge<L>(positions, m_shape.edges()[e], m_scale);
    const auto numerator = [this](const auto& angle, const auto& length) {
      return m_measure.edge_numerator(angle, length);
    };
    const auto denominator = [this](const auto& angle, const auto& length) {
      return m_measure.edge_denominator(angle, length);
    };
    call<L>(numerator, edge.angle, edge.length).store(to);
    if constexpr (Terms::of_edges) call<L>(denominator, edge.angle, edge.length).store(to + pack_size);
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void measure_triangle(const Position_rows<FT>& positions, std::size_t t)
  {
    const L area = measured_area<L>(positions, m_shape.triangles()[t], m_scale);
    const auto denominator = [this](const auto& a) { return m_measure.triangle_denominator(a); };
    call<L>(denominator, area).store(m_triangles.data() + pack_size * t);
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void add_edge(std::size_t e, L& numerator, L& denominator) const
  {
    const FT* from = m_edges.data() + edge_size * e;
    numerator = numerator + L::load(from);
    if constexpr (Terms::of_edges) denominator = denominator + L::load(from + pack_size);
  }

  // With weights that are fractions of corners, the sum over a ball's edges and triangles is the sum over its vertices
  // of half of their edges and a third of their triangles.
  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void share_out(std::size_t v)
  {
    L numerator = L::all(0), denominator = L::all(0), thirds = L::all(0);
    for (Rest_shape::Index e : m_shape.incident_edges()[v]) add_edge(e, numerator, denominator);
    if constexpr (Terms::of_triangles)
      for (Rest_shape::Index t : m_shape.incident_triangles()[v])
        thirds = thirds + L::load(m_triangles.data() + pack_size * t);
    FT* to = m_vertices.data() + 2 * pack_size * v;
    (numerator * FT(1. / 2)).store(to);
    (denominator * FT(1. / 2) + thirds * FT(1. / 3)).store(to + pack_size);
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE L sum_over_vertices(std::size_t centre) const
  {
    L numerator = L::all(0), denominator = L::all(0);
    for (Compressed_rows::Index w : m_balls[centre]) {
      const FT* from = m_vertices.data() + 2 * pack_size * w;
      numerator = numerator + L::load(from);
      denominator = denominator + L::load(from + pack_size);
    }
    return quotient(numerator, denominator);
  }

  // Edges and triangles with all corners in the ball, each met at its smallest vertex.
  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE L sum_over_whole(std::size_t centre)
  {
    const Compressed_rows::Row ball = m_balls[centre];
    // marks[w] is the last ball on this thread that contained w
    std::vector<Rest_shape::Index>& marks = m_marks.get([this] {
      return std::make_unique<std::vector<Rest_shape::Index>>(m_shape.number_of_vertices(), Rest_shape::none);
    });
    for (Rest_shape::Index w : ball) marks[w] = Rest_shape::Index(centre);
    const auto inside = [&](Rest_shape::Index w) { return marks[w] == centre; };
    L numerator = L::all(0), denominator = L::all(0);
    for (Rest_shape::Index v : ball) {
      for (std::size_t e = m_first_edge[v]; e < m_first_edge[v + 1]; ++e)
        if (inside(m_shape.edges()[e].target)) add_edge(e, numerator, denominator);
      if constexpr (Terms::of_triangles)
        for (std::size_t i = m_first_triangle[v]; i < m_first_triangle[v + 1]; ++i) {
          const Rest_shape::Index t = m_shape.ordered_triangles()[i];
          const Rest_shape::Triangle& c = m_shape.triangles()[t];
          if (inside(c[1]) && inside(c[2])) denominator = denominator + L::load(m_triangles.data() + pack_size * t);
        }
    }
    return quotient(numerator, denominator);
  }

  template <class L>
  CGAL_ANIMATED_MESH_FEATURES_INLINE L quotient(const L& numerator, const L& denominator) const
  {
    const L zero = L::all(0);
    return where_greater(denominator, zero, numerator * m_factor / denominator, zero);
  }

  const Rest_shape& m_shape;
  const Compressed_rows& m_balls;
  Measure m_measure;
  Instruction_set m_instructions;
  FT m_factor, m_scale;
  Aligned_vector<FT> m_edges, m_triangles, m_vertices;
  std::vector<Rest_shape::Index> m_first_edge, m_first_triangle; // of each vertex, as the smallest one
  Thread_local<std::vector<Rest_shape::Index>> m_marks;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_CURVATURE_BLOCK_H
