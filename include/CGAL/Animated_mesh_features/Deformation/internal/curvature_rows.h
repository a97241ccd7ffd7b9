// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_CURVATURE_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_CURVATURE_ROWS_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/Curvature_block.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> curvature_rows(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                         const Compressed_rows& balls, const Measure& measure, const Loop& loop,
                                         Instruction_set instructions = widest_instruction_set())
{
  typedef Frame_pack<FT> Block;
  Spatio_temporal_field<FT> field(trajectories.number_of_vertices(), trajectories.number_of_frames(),
                                  trajectories.memory());
  Curvature_block<FT, Measure> sums(shape, balls, measure, instructions);
  const std::size_t blocks = Block::number_of_blocks(trajectories.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b)
    sums.run(Position_rows<FT>(trajectories, b), loop.part(b, blocks),
             [&](std::size_t v, const auto& k)
                 CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA { k.store(field.row(v) + b * Block::size); });
  return field;
}

// field += weight |curvature - curvature at rest|. The rest shape goes through the very same operations as a block of
// frames: a frame that equals it has a change of exactly zero. Memory besides the field: see Curvature_block, and four
// cache lines for each vertex.
template <class FT, class Measure, class Loop>
void add_curvature_change(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                          const Compressed_rows& balls, const Measure& measure, double weight, const Loop& loop,
                          Spatio_temporal_field<FT>& field,
                          Instruction_set instructions = widest_instruction_set())
{
  typedef Frame_pack<FT> Block;
  const std::size_t n = shape.number_of_vertices();
  const std::size_t blocks = Block::number_of_blocks(trajectories.number_of_frames());
  Curvature_block<FT, Measure> sums(shape, balls, measure, instructions);
  Aligned_vector<FT> rest(Block::size * n);
  {
    Aligned_vector<FT> points(3 * Block::size * n);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t i = 0; i < 3; ++i)
        std::fill_n(points.data() + (i * n + v) * Block::size, Block::size, FT(shape.points()[v][Eigen::Index(i)]));
    const FT* x = points.data();
    sums.run(Position_rows<FT>(x, x + n * Block::size, x + 2 * n * Block::size, Block::size), loop.part(0, blocks + 1),
             [&](std::size_t v, const auto& k)
                 CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA { k.store(rest.data() + v * Block::size); });
  }
  for (std::size_t b = 0; b < blocks; ++b)
    sums.run(Position_rows<FT>(trajectories, b), loop.part(b + 1, blocks + 1),
             [&](std::size_t v, const auto& k) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
               typedef std::decay_t<decltype(k)> L;
               FT* to = field.row(v) + b * Block::size;
               (L::load(to) + absolute(k - L::load(rest.data() + v * Block::size)) * FT(weight)).store(to);
             });
}

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> curvature_change_rows(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                                const Compressed_rows& balls, const Measure& measure,
                                                const Loop& loop,
                                                Instruction_set instructions = widest_instruction_set())
{
  Spatio_temporal_field<FT> field(trajectories.number_of_vertices(), trajectories.number_of_frames(),
                                  trajectories.memory());
  add_curvature_change(shape, trajectories, balls, measure, 1., loop, field, instructions);
  return field;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#ifdef CGAL_ANIMATED_MESH_FEATURES_COMPILED
  #include <CGAL/Animated_mesh_features/Deformation/internal/curvature_instances.inl>
#endif

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_CURVATURE_ROWS_H
