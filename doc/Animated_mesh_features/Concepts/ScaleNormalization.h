// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `ScaleNormalization` describes by what the response is multiplied at each vertex and level in space, besides
the powers of \f$\sigma\f$ and \f$\tau\f$ that are right for a plane, so that scales and strengths can be compared where
the surface is not like a plane at this scale.

A model is copy-constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Heat_kernel_normalization}
\cgalHasModels{CGAL::Animated_mesh_features::Planar_normalization}
\cgalHasModelsEnd

\sa `SpatialFilter`
\sa `SpaceTimeResponse`
*/
class ScaleNormalization
{
public:
  /*!
  computes the factors of all vertices and levels.

  For the result not to depend on threads, each value has to be computed by the same operations in the same order,
  whoever computes it.

  \param shape the rest shape, of `N` vertices.
  \param variances for each of `K` levels the variance per axis \f$\sigma^2\f$ of the smoothing in space; ascending;
    squared length. The first may be 0, a level that is not smoothed.
  \param loop runs tasks.
  \tparam Loop a model of `TaskLoop`.

  \returns `N x K` factors, those of a vertex next to one another; positive. Or none at all, if all of them are 1.
  */
  template <class Loop>
  std::vector<float> operator()(const CGAL::Animated_mesh_features::Rest_shape& shape,
                                const std::vector<double>& variances,
                                const Loop& loop) const;
};
