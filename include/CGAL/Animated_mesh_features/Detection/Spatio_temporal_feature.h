// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_SPATIO_TEMPORAL_FEATURE_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_SPATIO_TEMPORAL_FEATURE_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

A spatio-temporal feature point of an animated mesh: a `Feature_point` with the mesh's own vertex.

\tparam VertexDescriptor `boost::graph_traits<TriangleMesh>::%vertex_descriptor` of the animated mesh.
*/
template <class VertexDescriptor>
struct Spatio_temporal_feature : Feature_point
{
  /// the vertex at which the response is minimal.
  VertexDescriptor vertex = VertexDescriptor();

  /// a feature at no vertex yet.
  Spatio_temporal_feature() = default;

  /// the feature `point` at `vertex`.
  Spatio_temporal_feature(const Feature_point& point, const VertexDescriptor& vertex)
    : Feature_point(point)
    , vertex(vertex)
  {
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_SPATIO_TEMPORAL_FEATURE_H
