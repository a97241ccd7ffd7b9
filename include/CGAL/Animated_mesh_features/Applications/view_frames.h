// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_FRAMES_H

#include <CGAL/Animated_mesh_features/Applications/internal/feature_presence.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses frames, evenly spread over the clip: the middles of so many equal parts, ascending, without repetitions.
\throw Option_error if `most` is 0.
*/
inline std::vector<std::size_t> even_frames(std::size_t number_of_frames, std::size_t most)
{
  if (most == 0) throw Option_error("at least one frame has to be looked at");
  std::vector<std::size_t> frames;
  const std::size_t n = (std::min)(most, number_of_frames);
  for (std::size_t i = 0; i < n; ++i) frames.push_back((2 * i + 1) * number_of_frames / (2 * n));
  return frames;
}

/*!
\ingroup PkgAnimatedMeshFeaturesViews

chooses the frames in which there is something to be seen: those that divide the features' amplitude, spread over the
frames in which they live, in equal parts. Ascending, without repetitions: fewer than `most` if all happens in few frames.
Without features, `even_frames()`.

\param features a range of `Feature_point`.
\param number_of_frames of the animation, `F`.
\param frame_duration the time between two frames (s).
\param most how many.
\param is_cyclic whether the last frame is followed by the first: a feature near one end lives on at the other.
\throw Option_error if `most` is 0; Input_error if a feature is in a frame that is not there.
*/
template <class FeatureRange>
std::vector<std::size_t> view_frames(const FeatureRange& features, std::size_t number_of_frames, double frame_duration,
                                     std::size_t most, bool is_cyclic = false)
{
  if (most >= number_of_frames || features.begin() == features.end()) return even_frames(number_of_frames, most);
  if (most == 0) throw Option_error("at least one frame has to be looked at");
  std::vector<double> amplitude(number_of_frames, 0);
  double sum = 0;
  for (const Feature_point& f : features) {
    if (f.frame >= number_of_frames)
      throw Input_error("a feature is in frame " + std::to_string(f.frame) + ", the animation has " +
                        std::to_string(number_of_frames));
    const double a = internal::worth(f);
    sum += a;
    for (const auto& m : internal::feature_presence(f, number_of_frames, frame_duration, is_cyclic))
      amplitude[m.first] += a * m.second;
  }
  if (!(sum > 0)) return even_frames(number_of_frames, most);
  std::vector<std::size_t> frames;
  double reached = 0;
  std::size_t next = 0;
  for (std::size_t m = 0; m < number_of_frames; ++m) {
    reached += amplitude[m];
    bool is_chosen = false;
    for (; next < most && (double(next) + 0.5) * sum <= reached * double(most); ++next) is_chosen = true;
    if (is_chosen) frames.push_back(m);
  }
  return frames;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VIEW_FRAMES_H
