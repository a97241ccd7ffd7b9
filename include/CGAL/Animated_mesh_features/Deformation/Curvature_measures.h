// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_CURVATURE_MEASURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_CURVATURE_MEASURES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

How much of an edge or a triangle lies in a geodesic ball, which is known by its vertices.
*/
enum class Ball_membership
{
  FRACTION, ///< the fraction of its corners that are in the ball
  WHOLE     ///< 1 if all corners are in the ball, otherwise 0
};

/*!
\addtogroup PkgAnimatedMeshFeaturesCurvatureMeasures

Models of `CurvatureMeasure`: quotients of two sums over the edges and triangles of a geodesic ball.
\f[ \kappa = c\, \frac{\sum_e w_e\, p(\beta_e, |e|)}{\sum_e w_e\, q(\beta_e, |e|) + \sum_t w_t\, g(A_t)} , \f]
\f$\beta_e\f$ is the signed dihedral angle of an edge (radians; \f$\pi\f$ minus the interior angle, positive where the
surface is convex), lengths and areas are those of the frame, weights \f$w\f$ go by `membership`. `p`, `q` and `g` take
Eigen arrays, with one entry for each of several frames.
*/

/*!
\ingroup PkgAnimatedMeshFeaturesCurvatureMeasures

The density of mean curvature, \f$H = \sum_e w_e \beta_e |e| \,/\, (2 \sum_t w_t A_t)\f$, made dimensionless by a length
\f$\ell\f$ that is a fraction of the diameter of the rest shape. The default.

Counting half of an edge of which one end is in the ball, and likewise for triangles, makes it converge under
refinement: on a sphere of curvature 1 it is 1.002, 1.000, 1.000 at edge lengths h, h/2, h/4, without these weights
0.74, 0.86, 0.93.

\cgalModels{CurvatureMeasure}
*/
struct Mean_curvature_density
{
  /// what lies in the ball in part counts in part.
  static constexpr Ball_membership membership = Ball_membership::FRACTION;

  /// \f$\ell\f$ as a fraction of the diameter. 0.6 % puts curvature changes in the range of the strains that go with
  /// them, so that the paper's weight \f$\alpha = 7\f$ keeps its meaning.
  double length_over_diameter = 0.006;

  /// \f$c = \ell\f$ (length).
  double factor(const Rest_shape& shape) const { return length_over_diameter * shape.diameter(); }

  /// \f$p = \beta\,|e|\f$
  template <class T>
  T edge_numerator(const T& angle, const T& length) const
  {
    return angle * length;
  }

  /// \f$q = 0\f$
  template <class T>
  T edge_denominator(const T& angle, const T&) const
  {
    return angle * internal::Constant<T>::of(0);
  }

  /// \f$g = 2A\f$
  template <class T>
  T triangle_denominator(const T& area) const
  {
    return area + area;
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesCurvatureMeasures

The mean of the dihedral angles (radians) of the edges in the ball, as Mykhalchuk, Seo and Cordier
\cgalCite{mykhalchuk2014} have it. It does not depend on the unit, but halves with every refinement of the mesh.

\cgalModels{CurvatureMeasure}
*/
struct Mean_dihedral_angle
{
  /// an edge counts if both of its ends are in the ball.
  static constexpr Ball_membership membership = Ball_membership::WHOLE;

  /// \f$c = 1\f$
  double factor(const Rest_shape&) const { return 1; }

  /// \f$p = \beta\f$
  template <class T>
  T edge_numerator(const T& angle, const T&) const
  {
    return angle;
  }

  /// \f$q = 1\f$
  template <class T>
  T edge_denominator(const T&, const T&) const
  {
    return internal::Constant<T>::of(1);
  }

  /// \f$g = 0\f$
  template <class T>
  T triangle_denominator(const T& area) const
  {
    return area * internal::Constant<T>::of(0);
  }
};

namespace internal {

template <>
struct Takes_packs<Mean_curvature_density> : std::true_type
{
};
template <>
struct Takes_packs<Mean_dihedral_angle> : std::true_type
{
};

// Which denominators are not always zero, hence have to be kept and added.
template <class Measure>
struct Denominators
{
  static constexpr bool of_edges = true, of_triangles = true;
};
template <>
struct Denominators<Mean_curvature_density>
{
  static constexpr bool of_edges = false, of_triangles = true;
};
template <>
struct Denominators<Mean_dihedral_angle>
{
  static constexpr bool of_edges = true, of_triangles = false;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_CURVATURE_MEASURES_H
