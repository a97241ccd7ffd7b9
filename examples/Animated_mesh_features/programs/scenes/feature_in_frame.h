// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_FEATURE_IN_FRAME_H
#define PROGRAMS_SCENES_FEATURE_IN_FRAME_H

#include <array>
#include <cmath>
#include <cstddef>

// How a feature is shown in a frame: the same in all files and pictures.

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/// \ingroup PkgAnimatedMeshFeaturesWriting
/// how long a feature is shown before and after its time, in units of \f$\tau\f$: there, it has faded to 14 %.
constexpr double feature_life = 2;

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

whether a feature is shown in frame `f`: at most `feature_life` times \f$\tau\f$ from its time, and in any case in its own
frame, so that there is no feature that is never seen.

\param feature a `Spatio_temporal_feature`.
\param f from 0.
\param frame_duration seconds.
*/
template <class Feature>
bool lives_in_frame(const Feature& feature, std::size_t f, double frame_duration)
{
  return f == feature.frame || std::abs(double(f) * frame_duration - feature.time) <= feature_life * feature.tau;
}

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

how much of a feature is seen in frame `f`, from 0 to 1: \f$\exp(-(t - t_0)^2 / (2 \tau^2))\f$ with the time \f$t\f$ of the
frame and \f$t_0\f$ of the feature; 0 in frames in which it does not live.
*/
template <class Feature>
double opacity_in_frame(const Feature& feature, std::size_t f, double frame_duration)
{
  if (!lives_in_frame(feature, f, frame_duration)) return 0;
  if (!(feature.tau > 0)) return 1; // then it lives in one frame only
  const double distance = (double(f) * frame_duration - feature.time) / feature.tau;
  return std::exp(-distance * distance / 2);
}

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

the place of a feature on the surface in frame `f`: it moves with the triangle on which it was found.

\tparam Sequence a `Frame_sequence`
*/
template <class Sequence, class Feature>
std::array<double, 3> position_in_frame(const Sequence& sequence, const Feature& feature, std::size_t f)
{
  const auto& animation = sequence.trajectories();
  std::array<double, 3> position = {{0, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t v = feature.triangle[i];
    const double b = feature.barycentric_coordinates[i];
    position[0] += b * double(animation.x(v, f));
    position[1] += b * double(animation.y(v, f));
    position[2] += b * double(animation.z(v, f));
  }
  return position;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_FEATURE_IN_FRAME_H
