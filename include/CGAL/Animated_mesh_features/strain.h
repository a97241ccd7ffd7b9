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
#include <CGAL/Animated_mesh_features/internal/Animation_access.h>
#include <CGAL/Animated_mesh_features/internal/parallel_for.h>
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

// The strain of every triangle in the frames of one block. Degenerate rest triangles: 0; their weight is 0 as well.
template <class FT, class Measure, class Loop>
void triangle_strains(const Flat_animation<FT>& animation,
                      const std::vector<Rest_triangle>& rest,
                      std::size_t block,
                      const Measure& measure,
                      const Loop& loop,
                      std::vector<typename Frame_block<FT>::Array>& strains)
{
  loop(rest.size(), [&](std::size_t t) {
    if (rest[t].inverse_height > 0)
      strains[t] = strain_block(animation, rest[t], t, block, measure);
    else
      strains[t].setZero();
  });
}

// inverse_height = 0 marks a degenerate triangle
inline std::vector<Rest_triangle> rest_triangles(const Rest_shape& shape)
{
  std::vector<Rest_triangle> rest(shape.triangles().size(), Rest_triangle{0, 0, 0});
  for (std::size_t t = 0; t < rest.size(); ++t)
    if (!is_degenerate(shape, t)) rest[t] = rest_triangle(shape, t);
  return rest;
}

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> triangle_strain_rows(const Flat_animation<FT>& animation,
                                               const Measure& measure,
                                               const Loop& loop)
{
  typedef Frame_block<FT> Block;
  const std::vector<Rest_triangle> rest = rest_triangles(animation.rest);
  Spatio_temporal_field<FT> field(rest.size(), animation.number_of_frames());
  std::vector<typename Block::Array> strains(rest.size());
  const std::size_t blocks = Block::number_of_blocks(animation.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b) {
    triangle_strains(animation, rest, b, measure, loop.part(b, blocks), strains);
    for (std::size_t t = 0; t < rest.size(); ++t) Block::at(field, t, b) = strains[t];
  }
  return field;
}

template <class FT, class Measure, class Loop>
Spatio_temporal_field<FT> vertex_strain_rows(const Flat_animation<FT>& animation,
                                             const Measure& measure,
                                             Triangle_weights weights,
                                             const Loop& loop)
{
  typedef Frame_block<FT> Block;
  const Rest_shape& shape = animation.rest;
  const std::vector<Rest_triangle> rest = rest_triangles(shape);
  const auto weight = [&](std::size_t t) {
    if (!(rest[t].inverse_height > 0)) return 0.;
    return weights == Triangle_weights::UNIFORM ? 1. : shape.areas()[t];
  };
  Spatio_temporal_field<FT> field(animation.number_of_vertices(), animation.number_of_frames());
  std::vector<typename Block::Array> strains(rest.size());
  const std::size_t blocks = Block::number_of_blocks(animation.number_of_frames());
  for (std::size_t b = 0; b < blocks; ++b) {
    triangle_strains(animation, rest, b, measure, loop.part(2 * b, 2 * blocks), strains);
    loop.part(2 * b + 1, 2 * blocks)(field.number_of_rows(), [&](std::size_t v) {
      typename Block::Array sum = Block::Array::Zero();
      double total = 0;
      for (Rest_shape::Index t : shape.incident_triangles()[v]) {
        sum += strains[t] * FT(weight(t));
        total += weight(t);
      }
      if (total > 0) Block::at(field, v, b) = sum * FT(1 / total);
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
\returns a field of `number of triangles x F` strains without unit, rows in the order of `faces(mesh)`. Rows of
triangles that
  are degenerate at rest are zero.
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
Triangles that are degenerate at rest are left out; a vertex without others has strain 0.

\tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is the same, bit for bit.
\tparam Animation a model of `MeshAnimation`.
\tparam StrainMeasure a model of `StrainMeasure`.
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
