// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `StrainMeasure` describes how the deformation of a triangle within its plane becomes a scalar.

A model is copy-constructible. Its operator is called from several threads at the same time.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Hencky_strain}
\cgalHasModels{CGAL::Animated_mesh_features::Green_lagrange_strain}
\cgalHasModels{CGAL::Animated_mesh_features::Principal_stretch_strain}
\cgalHasModels{CGAL::Animated_mesh_features::Largest_eigenvalue_strain}
\cgalHasModelsEnd
*/
class StrainMeasure
{
public:
  /*!
  whether the operator takes Eigen arrays in place of scalars; then it is called with `Eigen::Array<FT, N, 1>` for two
  arguments and the result, and computes the strains of a triangle in `N = 64 / sizeof(FT)` frames at a time, in vector
  registers. Optional: without this member it is called with scalars.
  */
  static constexpr bool vectorized;

  /*!
  the strain of a triangle in a frame, of which the squared principal stretches are \f$\lambda_1 \ge \lambda_2 > 0\f$
  (up to rounding): both 1 at rest, 4 where lengths are doubled. They are at least \f$10^{-12}\f$; so small are also
  those of frames that do not exist, with which the last block of a row is filled up, and of which the result is not
  used.

  `FT` is that of the animation. A larger strain is a stronger deformation; it may be zero or not at rest.
  */
  FT operator()(FT lambda_1, FT lambda_2) const;
};
