// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Rig.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  #include <CGAL/Animated_mesh_features/Evaluation/prominent_maxima.h>
  #include <CGAL/Animated_mesh_features/IO/Clip_sampling.h>
  #include <CGAL/Animated_mesh_features/IO/Keyframed_model_evaluator.h>
  #include <CGAL/Animated_mesh_features/IO/joint_angles.h>
  #include <CGAL/Animated_mesh_features/IO/read_gltf.h>
#endif

#include <cmath>

namespace AMF = CGAL::Animated_mesh_features;

namespace Evaluate_features {

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF

namespace {

namespace IO = AMF::IO;

// When the frames of the features' animation were, in the clip.
std::vector<double> times_of(const IO::Keyframed_model::Clip& clip, const Rig_source& source,
                             const Feature_file& features)
{
  IO::Clip_sampling sampling;
  sampling.there_and_back = source.there_and_back;
  sampling.frames = source.there_and_back ? (features.frames() + 1) / 2 : features.frames();
  std::vector<double> times = IO::frame_times(clip, sampling, source.model);
  const double tolerance = 1e-3;
  if (!(std::abs(times[1] - times[0] - features.frame_duration()) <= tolerance * features.frame_duration())) {
    // at a rate of one's own, what is left after the last whole frame was left out
    sampling.frames.reset();
    sampling.frames_per_second = 1 / features.frame_duration();
    times = IO::frame_times(clip, sampling, source.model);
  }
  if (times.size() != features.frames())
    throw AMF::Input_error(source.model + ": clip \"" + clip.name + "\" has " + std::to_string(times.size()) +
                           " frames of " + std::to_string(features.frame_duration()) + " s, " + features.path +
                           " is about " + std::to_string(features.frames()) +
                           "; was it another clip, or --there-and-back?");
  return times;
}

IO::Rig_file_data::Joint with_maxima(const IO::Joint_angles& joint, double frame_duration)
{
  IO::Rig_file_data::Joint result = {joint.name, joint.region, {}};
  for (const AMF::Prominent_maximum& m : AMF::prominent_maxima(joint.angles, 0))
    result.maxima.push_back({double(m.place) * frame_duration, m.value, m.prominence});
  return result;
}

} // namespace

Rig read_model_rig(const Rig_source& source, const Feature_file& features)
{
  const IO::Keyframed_model model = IO::read_gltf(source.model);
  const std::vector<std::string> names = IO::clip_names(model);
  const std::vector<std::size_t> clips = IO::find_clips(names, source.clip, source.model);
  const IO::Keyframed_model::Clip clip = IO::joined_clip(model, clips, source.model);
  const IO::Keyframed_model::Clip nothing_moves;
  const IO::Keyframed_model_evaluator checked(model, clip, source.model), at_rest(model, nothing_moves, source.model);

  Rig rig;
  rig.data.vertices = model.number_of_vertices();
  rig.data.frames = features.frames();
  rig.data.frame_duration = features.frame_duration();
  for (const IO::Joint_angles& joint : IO::joint_angles(model, clip, times_of(clip, source, features)))
    rig.data.joints.push_back(with_maxima(joint, features.frame_duration()));
  IO::Keyframed_model_evaluator::Points points;
  at_rest(0, points);
  for (const auto& p : points) rig.points.emplace_back(p[0], p[1], p[2]);

  // Features count vertices that were welded; regions count those of the file.
  const auto& file_vertices = features.data.file_vertices;
  for (std::size_t i = 0; i < features.features().size(); ++i) {
    const std::size_t vertex = file_vertices.empty()      ? features.features()[i].vertex_index
                               : file_vertices[i].empty() ? rig.points.size()
                                                          : file_vertices[i].front();
    if (vertex >= rig.points.size())
      throw AMF::Input_error(features.path + ": features[" + std::to_string(i) + "]: is at no vertex of the " +
                             std::to_string(rig.points.size()) + " of " + source.model);
  }
  return rig;
}

#else

Rig read_model_rig(const Rig_source& source, const Feature_file&)
{
  throw AMF::Option_error(
      "--model " + source.model +
      ": this program was built without what reads glTF; --events takes the events of a rig in a file");
}

#endif

} // namespace Evaluate_features
