// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `CurvatureMeasure` describes the curvature of a surface around a vertex as a quotient of two sums over the
edges and triangles of a geodesic ball.
\f[ \kappa = c\, \frac{\sum_e w_e\, p(\beta_e, |e|)}{\sum_e w_e\, q(\beta_e, |e|) + \sum_t w_t\, g(A_t)} , \f]
\f$\beta_e\f$ is the signed dihedral angle of an edge (radians; \f$\pi\f$ minus the interior angle, positive where the surface
is convex), \f$|e|\f$ its length and \f$A_t\f$ the area of a triangle in the unit of the mesh, all of them those of the frame.
Border edges do not count. Where the denominator is not positive, the curvature is 0.

The three functions are called with Eigen arrays, `Array` being `Eigen::Array<FT, N, 1>` with the `FT` of the animation
and `N = 64 / sizeof(FT)`: an edge or a triangle in several frames, in vector registers. Behind the last frame arrays
are filled up with values whose results are not used. A function template that takes any type serves for both `FT`.

A model is copy-constructible. Its functions are called from several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Mean_curvature_density}
\cgalHasModels{CGAL::Animated_mesh_features::Mean_dihedral_angle}
\cgalHasModelsEnd
*/
class CurvatureMeasure
{
public:
  /// the weights \f$w\f$: whether edges and triangles of which some corners are outside of the ball count in part, or
  /// not at all.
  static constexpr CGAL::Animated_mesh_features::Ball_membership membership;

  /// \f$c\f$; called with the rest shape.
  FT factor(const CGAL::Animated_mesh_features::Rest_shape& shape) const;

  /// \f$p\f$
  Array edge_numerator(const Array& angle, const Array& length) const;

  /// \f$q\f$
  Array edge_denominator(const Array& angle, const Array& length) const;

  /// \f$g\f$
  Array triangle_denominator(const Array& area) const;
};
