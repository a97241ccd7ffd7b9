// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_DIHEDRAL_ANGLE_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_DIHEDRAL_ANGLE_ROWS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/Position_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/pack_math.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// atan2(y, x), but 0 for y = 0, where an edge is flat, or folded completely and the angle has no sign. No branches, so
// that it runs in vector registers: the octant first, then, beyond half of it, atan(t) = pi/4 + atan((t - 1) / (t + 1)),
// with one division for both.
template <class L>
CGAL_ANIMATED_MESH_FEATURES_INLINE L signed_angle(const L& y, const L& x)
{
  typedef typename L::Scalar FT;
  const FT tiny = sizeof(FT) == sizeof(float) ? FT(1e-15) : FT(1e-100), pi = FT(3.14159265358979323846);
  const FT tangent = FT(0.41421356237309505); // of pi/8
  const L zero = L::all(0), height = absolute(y), width = absolute(x);
  const L p = where_greater(height, width, width, height), q = maximum(height, width), half = q * tangent;
  const L t = where_greater(p, half, p - q, p) / (where_greater(p, half, p + q, q) + tiny);
  const L s = t * t * FT(-1);
  // tan(pi/8)^(2 n) / (2 n + 1) is below the rounding at n = 8 for float, n = 19 for double
  constexpr int terms = sizeof(FT) == sizeof(float) ? 8 : 19;
  L sum = L::all(FT(1) / FT(2 * terms - 1));
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (int i = 0; i < terms - 1; ++i) sum = s * sum + FT(1) / FT(2 * (terms - 2 - i) + 1);
  L angle = t * sum + where_greater(p, half, L::all(pi / 4), zero);
  angle = where_greater(height, width, L::all(pi / 2) - angle, angle);
  angle = where_greater(zero, x, L::all(pi) - angle, angle);
  return where_greater(y, zero, angle, where_greater(zero, y, zero - angle, zero));
}

template <class L>
struct Edge_pack
{
  L angle, length;
};

// Signed dihedral angle (positive where convex; 0 at a border) and length of an edge. `scale` makes edges about 1 long,
// so that products of four lengths stay within the range of float.
//
// With e from source to target and the triangles' normals n1 = e x u and n2 = w x e:
// |n1| |n2| sin(beta) = -|e| (n1 . w), |n1| |n2| cos(beta) = n1 . n2.
template <class L, class FT>
CGAL_ANIMATED_MESH_FEATURES_INLINE Edge_pack<L> measured_edge(const Position_rows<FT>& positions,
                                                               const Rest_shape::Edge& edge, FT scale)
{
  typedef Packed_vector<L> Vector;
  const Vector origin = Vector::load(positions, edge.source);
  const Vector e = (Vector::load(positions, edge.target) - origin) * scale;
  const L length = sqrt(e.dot(e));
  if (edge.is_border()) return {L::all(0), length * (FT(1) / scale)};
  const Vector u = (Vector::load(positions, edge.left) - origin) * scale;
  const Vector w = (Vector::load(positions, edge.right) - origin) * scale;
  const Vector n1 = e.cross(u), n2 = w.cross(e);
  const L y = length * n1.dot(w) * FT(-1), x = n1.dot(n2);
  return {signed_angle(y, x), length * (FT(1) / scale)};
}

template <class L, class FT>
CGAL_ANIMATED_MESH_FEATURES_INLINE L measured_area(const Position_rows<FT>& positions,
                                                   const Rest_shape::Triangle& corners, FT scale)
{
  typedef Packed_vector<L> Vector;
  const Vector origin = Vector::load(positions, corners[0]);
  const Vector n = ((Vector::load(positions, corners[1]) - origin) * scale)
                       .cross((Vector::load(positions, corners[2]) - origin) * scale);
  return sqrt(n.dot(n)) * (FT(0.5) / (scale * scale));
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_DIHEDRAL_ANGLE_ROWS_H
