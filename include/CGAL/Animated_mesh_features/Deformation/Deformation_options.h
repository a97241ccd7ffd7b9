// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_OPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_OPTIONS_H

#include <CGAL/Animated_mesh_features/Deformation/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/Triangle_weights.h>
#include <CGAL/Animated_mesh_features/Deformation/deformation.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

What the measurement of a deformation can be told: a policy for each step, and numbers.

\tparam StrainMeasure_ a model of `StrainMeasure`.
\tparam CurvatureMeasure_ a model of `CurvatureMeasure`.
\tparam GeodesicBalls_ a model of `GeodesicBalls`.
\sa `Deformation_measurement`
*/
template <class StrainMeasure_ = Hencky_strain,
          class CurvatureMeasure_ = Mean_curvature_density,
          class GeodesicBalls_ = Heat_method_geodesic_balls>
struct Deformation_options
{
  typedef StrainMeasure_ StrainMeasure;       ///< a model of the concept of this name
  typedef CurvatureMeasure_ CurvatureMeasure; ///< a model of the concept of this name
  typedef GeodesicBalls_ GeodesicBalls;       ///< a model of the concept of this name

  StrainMeasure strain = StrainMeasure();          ///< the measure of the strain of a triangle
  CurvatureMeasure curvature = CurvatureMeasure(); ///< the measure of the curvature around a vertex
  GeodesicBalls balls = GeodesicBalls();           ///< the neighbourhoods in which curvature is measured

  /// how the strains of triangles are averaged at a vertex.
  Triangle_weights triangle_weights = Triangle_weights::REST_AREA;

  /// the radius of the geodesic balls (length); 0: `default_ball_radius()`.
  double ball_radius = 0;

  /// \f$\alpha\f$, the weight of the change of curvature against strain.
  double alpha = default_curvature_weight;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_OPTIONS_H
