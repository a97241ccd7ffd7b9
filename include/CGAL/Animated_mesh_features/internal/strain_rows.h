// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_STRAIN_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_STRAIN_ROWS_H

#include <CGAL/Animated_mesh_features/Animation_report.h>
#include <CGAL/Animated_mesh_features/internal/Flat_animation.h>
#include <CGAL/Animated_mesh_features/internal/Frame_block.h>

#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A rest triangle in its own plane: the edges from its first corner are (length, 0) and (shift, height) there. Kept in
// the form in which the inverse of that 2 x 2 matrix is applied.
struct Rest_triangle
{
  double inverse_length, shift, inverse_height;
};

inline Rest_triangle rest_triangle(const Rest_shape& shape, std::size_t t)
{
  const Rest_shape::Triangle& c = shape.triangles()[t];
  const Rest_shape::Point e = shape.points()[c[1]] - shape.points()[c[0]];
  const Rest_shape::Point g = shape.points()[c[2]] - shape.points()[c[0]];
  const double length = e.norm();
  return {1 / length, e.dot(g) / length, length / (2 * shape.areas()[t])};
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

template <class Array, class Measure>
Array strain_of_stretches(const Measure& measure, const Array& lambda_1, const Array& lambda_2)
{
  if constexpr (Is_vectorized<Measure>::value) {
    return measure(lambda_1, lambda_2);
  } else {
    Array strain;
    for (int i = 0; i < strain.size(); ++i) strain[i] = measure(lambda_1[i], lambda_2[i]);
    return strain;
  }
}

// The strain of triangle t in the frames of a block. J = [j1 j2] maps the plane of the rest triangle into space,
// C = J^T J = [a b; b c]; its eigenvalues are the squared principal stretches. (a - c) / 2 and det C = |j1 x j2|^2 keep
// their digits near the rest shape and for slivers, where trace^2 / 4 - det has none left.
template <class FT, class Measure>
typename Frame_block<FT>::Array strain_block(const Flat_animation<FT>& animation,
                                             const Rest_triangle& rest,
                                             std::size_t t,
                                             std::size_t block,
                                             const Measure& measure)
{
  typedef typename Frame_block<FT>::Array Array;
  const Rest_shape::Triangle& corners = animation.rest.triangles()[t];
  const Vector_block<FT> j1 = difference(animation, corners[0], corners[1], block, FT(rest.inverse_length));
  const Vector_block<FT> g = difference(animation, corners[0], corners[2], block, FT(1));
  const FT s = FT(rest.shift), i = FT(rest.inverse_height);
  const Vector_block<FT> j2 = {(g.x - s * j1.x) * i, (g.y - s * j1.y) * i, (g.z - s * j1.z) * i};
  const Array a = j1.dot(j1), b = j1.dot(j2), c = j2.dot(j2);
  const Vector_block<FT> n = j1.cross(j2);
  const Array half_difference = (a - c) * FT(0.5);
  const FT least = FT(smallest_squared_stretch);
  const Array lambda_1 =
      ((a + c) * FT(0.5) + (half_difference * half_difference + b * b).sqrt()).max(least);
  const Array lambda_2 = (n.dot(n) / lambda_1).max(least);
  return strain_of_stretches<Array>(measure, lambda_1, lambda_2);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_STRAIN_ROWS_H
