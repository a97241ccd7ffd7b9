// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_FIELDS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_FIELDS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Deformation/Triangle_weights.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/strain_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/run_in_chunks.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// The strains of all triangles in the frames of one block; `strains` is that of triangle 0, others follow by `stride`.
template <class FT, class Measure, class Loop>
void triangle_strains(const Rest_shape& shape,
                      const Vertex_trajectories<FT>& trajectories,
                      const std::vector<Rest_triangle>& rest,
                      std::size_t block,
                      const Measure& measure,
                      Instruction_set instructions,
                      const Loop& loop,
                      FT* strains,
                      std::size_t stride)
{
  run_in_chunks(rest.size(), loop, [&](std::size_t first, std::size_t last) {
    Strain_loop<FT, Measure> vector_loop{shape, rest, measure, Position_rows<FT>(trajectories, block),
                                      strains,        stride, first,   last};
    run_reproducibly<FT>(instructions, vector_loop);
  });
}

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> triangle_strain_rows(const Rest_shape& shape,
                                               const Vertex_trajectories<FT>& trajectories,
                                               const Measure& measure,
                                               const Loop& loop,
                                               Instruction_set instructions = widest_instruction_set())
{
  typedef Frame_pack<FT> Block;
  const std::vector<Rest_triangle> rest = rest_triangles(shape);
  Spatio_temporal_field<FT> field(rest.size(), trajectories.number_of_frames(), trajectories.memory());
  const std::size_t blocks = Block::number_of_blocks(trajectories.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b)
    triangle_strains(shape, trajectories, rest, b, measure, instructions, loop.part(b, blocks), field.row(0) + b * Block::size,
                     field.stride());
  return field;
}

// Memory besides the field: a cache line for each triangle.
template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> vertex_strain_rows(const Rest_shape& shape,
                                               const Vertex_trajectories<FT>& trajectories,
                                             const Measure& measure,
                                             Triangle_weights weights,
                                             const Loop& loop,
                                             Instruction_set instructions = widest_instruction_set())
{
  typedef Frame_pack<FT> Block;
  const std::vector<Rest_triangle> rest = rest_triangles(shape);
  // relative to the mean, as areas may be beyond the range of float
  double mean_area = 0;
  for (Rest_shape::Index t : shape.ordered_triangles()) mean_area += shape.areas()[t] / double(rest.size());
  std::vector<FT> weight(rest.size(), FT(0));
  for (std::size_t t = 0; t < rest.size(); ++t)
    if (rest[t].inverse_height > 0)
      weight[t] = weights == Triangle_weights::UNIFORM ? FT(1) : FT(shape.areas()[t] / mean_area);
  Spatio_temporal_field<FT> field(trajectories.number_of_vertices(), trajectories.number_of_frames(), trajectories.memory());
  Aligned_vector<FT> strains(rest.size() * Block::size);
  const std::size_t blocks = Block::number_of_blocks(trajectories.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b) {
    triangle_strains(shape, trajectories, rest, b, measure, instructions, loop.part(2 * b, 2 * blocks), strains.data(),
                     Block::size);
    run_in_chunks(field.number_of_rows(), loop.part(2 * b + 1, 2 * blocks), [&](std::size_t first, std::size_t last) {
      Strain_mean_loop<FT> vector_loop{shape, weight, strains.data(), field, b, first, last};
      run_reproducibly<FT>(instructions, vector_loop);
    });
  }
  return field;
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#ifdef CGAL_ANIMATED_MESH_FEATURES_COMPILED
  #include <CGAL/Animated_mesh_features/Deformation/internal/strain_instances.inl>
#endif

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_FIELDS_H
