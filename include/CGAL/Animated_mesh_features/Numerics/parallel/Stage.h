// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_STAGE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_STAGE_H

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesTasks

The stages of a detection. A detection begins with `GEODESIC_BALLS`, `STRAIN` and `CURVATURE` - in this order, if nobody
asks for one of the fields before -, each of them once and only if it is needed; what follows is told at
`Default_visitor::begin()`.
*/
enum class Stage
{
  GEODESIC_BALLS, ///< the balls of the curvature measure, on the rest shape
  STRAIN,         ///< strain, all vertices and frames
  CURVATURE,      ///< change of curvature, all vertices and frames
  SCALE_SPACE,    ///< smoothing in space
  EXTREMA,        ///< smoothing in time, response, extremum search
  REST_SHAPE,     ///< the canonical shape, where it is asked for
  DENOISING,      ///< frames without their noise, where they are asked for
  VIEWS           ///< directions to look from, where they are asked for
};

/*!
\ingroup PkgAnimatedMeshFeaturesTasks

the name of a stage, for messages.
*/
inline const char* name(Stage stage)
{
  switch (stage) {
  case Stage::GEODESIC_BALLS: return "geodesic balls";
  case Stage::STRAIN: return "strain";
  case Stage::CURVATURE: return "curvature";
  case Stage::SCALE_SPACE: return "scale space";
  case Stage::EXTREMA: return "extrema";
  case Stage::REST_SHAPE: return "rest shape";
  case Stage::DENOISING: return "denoising";
  case Stage::VIEWS: return "views";
  }
  return "";
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_STAGE_H
