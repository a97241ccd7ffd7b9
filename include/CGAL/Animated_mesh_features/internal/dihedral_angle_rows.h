// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_DIHEDRAL_ANGLE_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_DIHEDRAL_ANGLE_ROWS_H

#include <CGAL/Animated_mesh_features/internal/Flat_animation.h>
#include <CGAL/Animated_mesh_features/internal/Frame_block.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// 2 atan(y / (r + x)) with r = |(x, y)|, which is atan2(y, x): odd in y, exactly 0 for y = 0. No branches, so that it
// runs in vector registers. Three half-angle steps, atan(t) = 2 atan(t / (1 + sqrt(1 + t^2))), bring the tangent below
// tan(pi/16), where the power series needs as many terms as half of the digits. The error is that of the scalar type
// over the distance from an edge that is folded completely (angle pi); there the angle no longer has a sign, and is 0.
template <class Array>
Array signed_angle(const Array& y, const Array& x)
{
  typedef typename Array::Scalar FT;
  const FT tiny = sizeof(FT) == sizeof(float) ? FT(1e-15) : FT(1e-100);
  const Array r = (x * x + y * y).sqrt();
  Array t = y / ((r + x).max(FT(0)) + r * std::numeric_limits<FT>::epsilon() / 4 + tiny);
  for (int i = 0; i < 3; ++i) t = t / ((t * t + FT(1)).sqrt() + FT(1));
  const Array s = t * t;
  // tan(pi/16)^(2 n + 1) / (2 n + 1) is below the rounding at n = 5 for float, n = 11 for double
  constexpr int terms = sizeof(FT) == sizeof(float) ? 5 : 11;
  Array sum = Array::Constant(FT(1) / FT(2 * terms - 1));
  for (int n = terms - 2; n >= 0; --n) sum = FT(1) / FT(2 * n + 1) - s * sum;
  return t * sum * FT(16);
}

template <class FT>
struct Edge_block
{
  typename Frame_block<FT>::Array angle, length;
};

// Signed dihedral angle (positive where convex; 0 at a border) and length of an edge in the frames of a block. `scale`
// makes edges about 1 long, so that products of four lengths stay within the range of float.
//
// With e from source to target and the triangles' normals n1 = e x u and n2 = w x e:
// |n1| |n2| sin(beta) = -|e| (n1 . w), |n1| |n2| cos(beta) = n1 . n2.
template <class FT>
Edge_block<FT> edge_block(const Flat_animation<FT>& animation, const Rest_shape::Edge& edge, std::size_t block,
                          FT scale)
{
  typedef typename Frame_block<FT>::Array Array;
  const Vector_block<FT> e = difference(animation, edge.source, edge.target, block, scale);
  const Array length = e.dot(e).sqrt();
  if (edge.is_border()) return {Array::Zero(), length * (FT(1) / scale)};
  const Vector_block<FT> u = difference(animation, edge.source, edge.left, block, scale);
  const Vector_block<FT> w = difference(animation, edge.source, edge.right, block, scale);
  const Vector_block<FT> n1 = e.cross(u), n2 = w.cross(e);
  const Array y = -(length * n1.dot(w)), x = n1.dot(n2);
  return {signed_angle<Array>(y, x), length * (FT(1) / scale)};
}

template <class FT>
typename Frame_block<FT>::Array area_block(const Flat_animation<FT>& animation,
                                           const Rest_shape::Triangle& corners,
                                           std::size_t block,
                                           FT scale)
{
  const Vector_block<FT> n = difference(animation, corners[0], corners[1], block, scale)
                                 .cross(difference(animation, corners[0], corners[2], block, scale));
  return n.dot(n).sqrt() * (FT(0.5) / (scale * scale));
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_DIHEDRAL_ANGLE_ROWS_H
