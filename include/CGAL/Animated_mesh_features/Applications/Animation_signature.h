// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_SIGNATURE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_SIGNATURE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Applications/Activity.h>
#include <CGAL/Animated_mesh_features/Applications/animation_activity.h>
#include <CGAL/Animated_mesh_features/Descriptors/Described_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/Surface_landmarks.h>
#include <CGAL/Animated_mesh_features/Descriptors/describe_features.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

All of an animation that it takes to compare it with others: some kilobytes, without its mesh.
*/
struct Animation_signature
{
  std::size_t vertices = 0;  ///< `N`
  std::size_t frames = 0;    ///< `F`
  double frame_duration = 0; ///< seconds
  double diagonal = 0;       ///< of the bounding box of the rest shape (length)
  Described_features events; ///< the features, for `match_features()` and `align_events()`
  Activity activity;         ///< for `align_animations()` and `animation_distance()`
};

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

makes the signature of an animation. The cost is that of `describe_features()`, `Surface_landmarks`,
`described_features()` and `animation_activity()`; all of it linear in the number of vertices.

\tparam FT `float` or `double`, the scalar of the field.
\tparam Descriptor a model of `FeatureDescriptor`.
\tparam Loop a model of `TaskLoop`.
\param shape the surface at rest.
\param field the deformation, in which the features were found, `N x F`.
\param frame_duration the time between two frames (s).
\param features what was found.
\param options times of the activity.
\param descriptor how features are described.
\param loop runs the tasks, one for each feature: first those that describe it, then those that measure how far it is from
  the others.
\throw Input_error if a feature does not belong to the shape, or the animation is too short or too long for the options;
  Option_error if the field does not belong to the shape, or an option is out of its range.
*/
template <class FT, class Descriptor, class Loop>
Animation_signature animation_signature(const Rest_shape& shape, const Spatio_temporal_field<FT>& field,
                                        double frame_duration, const std::vector<Feature_point>& features,
                                        const Activity_options& options, const Descriptor& descriptor, const Loop& loop)
{
  Animation_signature result;
  result.vertices = shape.number_of_vertices();
  result.frames = field.number_of_frames();
  result.frame_duration = frame_duration;
  result.diagonal = shape.bounding_box_diagonal();
  const Surface_landmarks landmarks(shape);
  result.events = described_features(
      shape, landmarks, features,
      describe_features(shape, field, frame_duration, features, descriptor, loop, options.is_cyclic), loop);
  if (options.is_cyclic) result.events.loop = double(result.frames) * frame_duration;
  std::vector<double> eccentricities;
  for (std::size_t v = 0; v < result.vertices; ++v) eccentricities.push_back(landmarks.eccentricity(v));
  result.activity = animation_activity(field, landmarks.areas(), eccentricities, frame_duration, options);
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

the same on all threads, without progress, by default with `Rotation_free_gradient_histogram`.
*/
template <class FT, class Descriptor = Rotation_free_gradient_histogram>
Animation_signature animation_signature(const Rest_shape& shape, const Spatio_temporal_field<FT>& field,
                                        double frame_duration, const std::vector<Feature_point>& features,
                                        const Activity_options& options = Activity_options(),
                                        const Descriptor& descriptor = Descriptor())
{
  return animation_signature(
      shape, field, frame_duration, features, options, descriptor,
      [](std::size_t n, const auto& task) { parallel_for<CGAL::Parallel_if_available_tag>(0, n, task); });
}

/*!
\ingroup PkgAnimatedMeshFeaturesApplications

makes the signature of an animation of which only features are known, as a file has them: with less to compare, without
descriptors and places; see `activity_of_features()`.

\param features what was found.
\param vertices, frames of the animation.
\param frame_duration the time between two frames (s).
\param diagonal of the bounding box of its rest shape (length).
\param options times of the activity.
\throw Input_error, Option_error as above.
*/
inline Animation_signature animation_signature(const std::vector<Feature_point>& features, std::size_t vertices,
                                               std::size_t frames, double frame_duration, double diagonal,
                                               const Activity_options& options = Activity_options())
{
  Animation_signature result;
  result.vertices = vertices;
  result.frames = frames;
  result.frame_duration = frame_duration;
  result.diagonal = diagonal;
  result.events = described_features(features, diagonal);
  if (options.is_cyclic) result.events.loop = double(frames) * frame_duration;
  result.activity = activity_of_features(features, frames, frame_duration, options);
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_SIGNATURE_H
