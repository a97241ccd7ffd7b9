// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_PLANAR_NORMALIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_PLANAR_NORMALIZATION_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesNormalizations

The response as it is, which is right where the surface is two-dimensional at the scale of the feature; a model of
`ScaleNormalization`. Costs nothing.

\cgalModels{ScaleNormalization}

\sa `Heat_kernel_normalization`
*/
class Planar_normalization
{
public:
  /// an empty table: all factors are 1.
  template <class Loop>
  std::vector<float> operator()(const Rest_shape&, const std::vector<double>&, const Loop&) const
  {
    return {};
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_PLANAR_NORMALIZATION_H
