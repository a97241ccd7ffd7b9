// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_PLACE_ON_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_PLACE_ON_ANIMATION_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

places a feature that was found over a rest shape on the animation that this is the rest shape of: the same feature with
the mesh's own vertex, and with its position on the moving surface, linear between the frames before and after. After the
last frame comes the first, which only a feature of a cyclic animation may need.

\param feature of a `Feature_detector`.
\param animation whose rest shape and frames the feature belongs to.
*/
template <class TriangleMesh, class FT>
Spatio_temporal_feature<typename Frame_sequence<TriangleMesh, FT>::vertex_descriptor>
place_on_animation(const Feature_point& feature, const Frame_sequence<TriangleMesh, FT>& animation)
{
  Spatio_temporal_feature<typename Frame_sequence<TriangleMesh, FT>::vertex_descriptor> placed(
      feature, animation.vertex_descriptors()[feature.vertex_index]);
  // an extremum is neither in the first nor in the last frame, and its offset at most half a frame; if ends are joined, it
  // is before the period is over
  const std::size_t before = std::size_t(feature.refined_frame), frames = animation.number_of_frames();
  const std::size_t after = before + 1 < frames ? before + 1 : 0;
  const double weight_after = feature.refined_frame - double(before);
  Rest_shape::Point now = Rest_shape::Point::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t v = feature.triangle[i];
    now += feature.barycentric_coordinates[i] * ((1 - weight_after) * animation.trajectories().point(v, before) +
                                                 weight_after * animation.trajectories().point(v, after));
  }
  for (std::size_t i = 0; i < 3; ++i) placed.position[i] = now[Eigen::Index(i)];
  return placed;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_PLACE_ON_ANIMATION_H
