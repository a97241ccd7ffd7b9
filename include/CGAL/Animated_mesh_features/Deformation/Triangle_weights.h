// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_TRIANGLE_WEIGHTS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_TRIANGLE_WEIGHTS_H

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

How the strains of the triangles around a vertex are averaged.
*/
enum class Triangle_weights
{
  REST_AREA, ///< by area at rest: the value does not depend on how finely one side of the vertex is meshed; the default
  UNIFORM    ///< the plain mean, as in the paper
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_TRIANGLE_WEIGHTS_H
