// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_ROWS_H

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/Position_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/pack_math.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A rest triangle in its own plane: the edges from its first corner are (length, 0) and (shift, height) there. Kept in
// the form in which the inverse of that 2 x 2 matrix is applied. inverse_height = 0 marks a degenerate triangle.
struct Rest_triangle
{
  double inverse_length, shift, inverse_height;
};

inline std::vector<Rest_triangle> rest_triangles(const Rest_shape& shape)
{
  std::vector<Rest_triangle> rest(shape.triangles().size(), Rest_triangle{0, 0, 0});
  for (std::size_t t = 0; t < rest.size(); ++t) {
    if (is_degenerate(shape, t)) continue;
    const Rest_shape::Triangle& c = shape.triangles()[t];
    const Rest_shape::Point e = shape.points()[c[1]] - shape.points()[c[0]];
    const Rest_shape::Point g = shape.points()[c[2]] - shape.points()[c[0]];
    const double length = e.norm();
    rest[t] = {1 / length, e.dot(g) / length, length / (2 * shape.areas()[t])};
  }
  return rest;
}

// lambda is clamped from below, so that a triangle that collapses in a frame has a large strain, not an infinite one
constexpr double smallest_squared_stretch = 1e-12;

template <class Measure, class = void>
struct Is_vectorized : std::false_type
{
};
template <class Measure>
struct Is_vectorized<Measure, std::enable_if_t<Measure::vectorized>> : std::true_type
{
};

template <class L, class Measure>
CGAL_ANIMATED_MESH_FEATURES_INLINE L strain_of_stretches(const Measure& measure, const L& lambda_1, const L& lambda_2)
{
  if constexpr (Takes_packs<Measure>::value) {
    return measure(lambda_1, lambda_2);
  } else if constexpr (Is_vectorized<Measure>::value) {
    return call_with_arrays<L>(measure, lambda_1, lambda_2);
  } else {
    typename L::Scalar a[L::size], b[L::size];
    lambda_1.store(a);
    lambda_2.store(b);
    for (std::size_t i = 0; i < L::size; ++i) a[i] = measure(a[i], b[i]);
    return L::load(a);
  }
}

// The strains of triangles [first, last) in the frames of a block, for run_reproducibly(). J = [j1 j2] maps the plane of
// the rest triangle into space, C = J^T J = [a b; b c]; its eigenvalues are the squared principal stretches. (a - c) / 2
// and det C = |j1 x j2|^2 keep their digits near the rest shape and for slivers, where trace^2 / 4 - det has none left.
template <class FT, class Measure>
struct Strain_loop
{
  const Rest_shape& shape;
  const std::vector<Rest_triangle>& rest;
  const Measure& measure;
  Position_rows<FT> positions;
  FT* strains;        // of triangle 0
  std::size_t stride; // from a triangle to the next
  std::size_t first, last;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<FT, Frame_pack<FT>::size, register_bytes> L;
    typedef Packed_vector<L> Vector;
    const L least = L::all(FT(smallest_squared_stretch));
    for (std::size_t t = first; t < last; ++t) {
      FT* to = strains + t * stride;
      if (!(rest[t].inverse_height > 0)) {
        std::fill_n(to, L::size, FT(0)); // its weight is 0 as well
        continue;
      }
      const Rest_shape::Triangle& corners = shape.triangles()[t];
      const Vector origin = Vector::load(positions, corners[0]);
      const Vector j1 = (Vector::load(positions, corners[1]) - origin) * FT(rest[t].inverse_length);
      const Vector g = Vector::load(positions, corners[2]) - origin;
      const Vector j2 = (g - j1 * FT(rest[t].shift)) * FT(rest[t].inverse_height);
      const L a = j1.dot(j1), b = j1.dot(j2), c = j2.dot(j2);
      const Vector n = j1.cross(j2);
      const L half_difference = (a - c) * FT(0.5);
      const L lambda_1 = maximum((a + c) * FT(0.5) + sqrt(half_difference * half_difference + b * b), least);
      const L lambda_2 = maximum(n.dot(n) / lambda_1, least);
      strain_of_stretches(measure, lambda_1, lambda_2).store(to);
    }
  }
};

// The weighted means of the strains around vertices [first, last) in the frames of a block, for run_reproducibly().
template <class FT>
struct Strain_mean_loop
{
  const Rest_shape& shape;
  const std::vector<FT>& weights; // of triangles
  const FT* strains;              // a cache line for each triangle
  Spatio_temporal_field<FT>& field;
  std::size_t block;
  std::size_t first, last;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<FT, Frame_pack<FT>::size, register_bytes> L;
    for (std::size_t v = first; v < last; ++v) {
      L sum = L::all(0);
      FT total = 0;
      for (Rest_shape::Index t : shape.incident_triangles()[v]) {
        sum = sum + L::load(strains + t * L::size) * weights[t];
        total += weights[t];
      }
      if (total > 0) (sum * (1 / total)).store(field.row(v) + block * L::size);
    }
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_ROWS_H
