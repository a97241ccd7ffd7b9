// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_STRAIN_H
#define CGAL_ANIMATED_MESH_FEATURES_STRAIN_H

#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Visitor.h>
#include <CGAL/Animated_mesh_features/internal/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/internal/Animation_access.h>
#include <CGAL/Animated_mesh_features/internal/parallel_for.h>
#include <CGAL/Animated_mesh_features/internal/run_in_chunks.h>
#include <CGAL/Animated_mesh_features/internal/run_vectorized.h>
#include <CGAL/Animated_mesh_features/internal/strain_rows.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesMeasures

How the strains of the triangles around a vertex are averaged.
*/
enum class Triangle_weights
{
  REST_AREA, ///< by area at rest: the value does not depend on how finely one side of the vertex is meshed; the default
  UNIFORM    ///< the plain mean, as in the paper
};

namespace internal {

// The strains of all triangles in the frames of one block; `strains` is that of triangle 0, others follow by `stride`.
template <class FT, class Measure, class Loop>
void triangle_strains(const Flat_animation<FT>& animation,
                      const std::vector<Rest_triangle>& rest,
                      std::size_t block,
                      const Measure& measure,
                      Instruction_set instructions,
                      const Loop& loop,
                      FT* strains,
                      std::size_t stride)
{
  run_in_chunks(rest.size(), loop, [&](std::size_t first, std::size_t last) {
    Strain_kernel<FT, Measure> kernel{animation.rest, rest,   measure, Position_rows<FT>(animation, block),
                                      strains,        stride, first,   last};
    run_reproducibly<FT>(instructions, kernel);
  });
}

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> triangle_strain_rows(const Flat_animation<FT>& animation,
                                               const Measure& measure,
                                               const Loop& loop,
                                               Instruction_set instructions = widest_instruction_set())
{
  typedef Frame_lanes<FT> Block;
  const std::vector<Rest_triangle> rest = rest_triangles(animation.rest);
  Spatio_temporal_field<FT> field(rest.size(), animation.number_of_frames());
  const std::size_t blocks = Block::number_of_blocks(animation.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b)
    triangle_strains(animation, rest, b, measure, instructions, loop.part(b, blocks), field.row(0) + b * Block::size,
                     field.stride());
  return field;
}

// Memory besides the field: a cache line for each triangle.
template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> vertex_strain_rows(const Flat_animation<FT>& animation,
                                             const Measure& measure,
                                             Triangle_weights weights,
                                             const Loop& loop,
                                             Instruction_set instructions = widest_instruction_set())
{
  typedef Frame_lanes<FT> Block;
  const Rest_shape& shape = animation.rest;
  const std::vector<Rest_triangle> rest = rest_triangles(shape);
  // relative to the mean, as areas may be beyond the range of float
  double mean_area = 0;
  for (Rest_shape::Index t : shape.ordered_triangles()) mean_area += shape.areas()[t] / double(rest.size());
  std::vector<FT> weight(rest.size(), FT(0));
  for (std::size_t t = 0; t < rest.size(); ++t)
    if (rest[t].inverse_height > 0)
      weight[t] = weights == Triangle_weights::UNIFORM ? FT(1) : FT(shape.areas()[t] / mean_area);
  Spatio_temporal_field<FT> field(animation.number_of_vertices(), animation.number_of_frames());
  Aligned_vector<FT> strains(rest.size() * Block::size);
  const std::size_t blocks = Block::number_of_blocks(animation.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b) {
    triangle_strains(animation, rest, b, measure, instructions, loop.part(2 * b, 2 * blocks), strains.data(),
                     Block::size);
    run_in_chunks(field.number_of_rows(), loop.part(2 * b + 1, 2 * blocks), [&](std::size_t first, std::size_t last) {
      Strain_mean_kernel<FT> kernel{shape, weight, strains.data(), field, b, first, last};
      run_reproducibly<FT>(instructions, kernel);
    });
  }
  return field;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesMeasures

computes the strain of every triangle in every frame with respect to the rest shape.

Linear in triangles x frames.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is the same, bit for bit.
\tparam Animation a model of `MeshAnimation`.
\tparam StrainMeasure a model of `StrainMeasure`.
\param animation the animation.
\param measure what the principal stretches become.
\returns a field of `number of triangles x F` strains without unit, rows in the order of `faces(mesh)`. Rows of
  triangles that are degenerate at rest are zero.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class Animation, class StrainMeasure = Hencky_strain>
Spatio_temporal_field<typename Animation::FT> triangle_strain(const Animation& animation,
                                                              const StrainMeasure& measure = StrainMeasure())
{
  const internal::Animation_access<Animation> access(animation);
  Default_visitor visitor;
  return internal::triangle_strain_rows(access->flat_animation(), measure,
                                        internal::Task_loop<ConcurrencyTag, Default_visitor>(visitor, Stage::STRAIN));
}

/*!
\ingroup PkgAnimatedMeshFeaturesMeasures

computes the strain at every vertex in every frame: the weighted mean of the strains of the triangles around it.
Triangles that are degenerate at rest are left out; a vertex without others has strain 0. Linear in triangles x frames.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is the same, bit for bit.
\tparam Animation a model of `MeshAnimation`.
\tparam StrainMeasure a model of `StrainMeasure`.
\param animation the animation.
\param measure what the principal stretches become.
\param weights of the triangles in the mean.
\returns a field of `N x F` strains without unit, rows in the order of `vertices(mesh)`.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag, class Animation, class StrainMeasure = Hencky_strain>
Spatio_temporal_field<typename Animation::FT> strain(const Animation& animation,
                                                     const StrainMeasure& measure = StrainMeasure(),
                                                     Triangle_weights weights = Triangle_weights::REST_AREA)
{
  const internal::Animation_access<Animation> access(animation);
  Default_visitor visitor;
  return internal::vertex_strain_rows(access->flat_animation(), measure, weights,
                                      internal::Task_loop<ConcurrencyTag, Default_visitor>(visitor, Stage::STRAIN));
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_STRAIN_H
