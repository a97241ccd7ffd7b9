// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CLIP_READER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CLIP_READER_H

#include <CGAL/Animated_mesh_features/IO/Keyframe_track.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_accessor_reader.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>

#include <tiny_gltf.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Reads the animations of a glTF file: which node's what is moved by which keys.
class Gltf_clip_reader
{
public:
  Gltf_clip_reader(const tinygltf::Model& gltf, const Gltf_accessor_reader& accessors, const Gltf_check& check)
    : m_gltf(gltf)
    , m_accessors(accessors)
    , m_check(check)
  {}

  Keyframed_model::Clip read(std::size_t a) const
  {
    const tinygltf::Animation& from = m_gltf.animations[a];
    Keyframed_model::Clip clip;
    clip.name = from.name;
    for (std::size_t c = 0; c < from.channels.size(); ++c) {
      const std::string name = "animation " + std::to_string(a) + " (" + from.name + "), channel " + std::to_string(c);
      const tinygltf::AnimationChannel& channel = from.channels[c];
      if (channel.target_node < 0) continue; // to be ignored, says the specification
      Keyframed_model::Channel result;
      result.node = m_check.index(channel.target_node, m_gltf.nodes.size(), name + ": node");
      if (!set_path(channel.target_path, result)) continue;
      const std::size_t sampler = m_check.index(channel.sampler, from.samplers.size(), name + ": sampler");
      read_track(from.samplers[sampler], name, result);
      clip.channels.push_back(std::move(result));
    }
    return clip;
  }

private:
  // false for what extensions move
  static bool set_path(const std::string& path, Keyframed_model::Channel& channel)
  {
    typedef Keyframed_model::Path Path;
    const std::map<std::string, Path> paths = {{"translation", Path::TRANSLATION},
                                               {"rotation", Path::ROTATION},
                                               {"scale", Path::SCALE},
                                               {"weights", Path::WEIGHTS}};
    const auto found = paths.find(path);
    if (found == paths.end()) return false;
    channel.path = found->second;
    channel.track.is_rotation = channel.path == Path::ROTATION;
    return true;
  }

  void read_track(const tinygltf::AnimationSampler& sampler, const std::string& name,
                  Keyframed_model::Channel& channel) const
  {
    typedef Keyframe_track::Interpolation Interpolation;
    Keyframe_track& track = channel.track;
    std::size_t values_per_key = 1;
    if (sampler.interpolation == "STEP") {
      track.interpolation = Interpolation::STEP;
    } else if (sampler.interpolation == "CUBICSPLINE") {
      track.interpolation = Interpolation::CUBICSPLINE;
      values_per_key = 3;
    } else if (sampler.interpolation != "LINEAR") {
      m_check.fail(name + ": unknown interpolation " + sampler.interpolation);
    }
    track.times = m_accessors.read(sampler.input, 1, name + ", times");
    if (track.times.empty()) m_check.fail(name + " has no keys");
    for (std::size_t k = 1; k < track.times.size(); ++k)
      if (!(track.times[k] > track.times[k - 1]))
        m_check.fail(name + ": the time of key " + std::to_string(k) + " does not ascend");
    if (channel.path == Keyframed_model::Path::WEIGHTS) {
      track.values = m_accessors.read(sampler.output, 1, name + ", values");
      track.width = track.values.size() / (values_per_key * track.times.size());
    } else {
      track.width = track.is_rotation ? 4 : 3;
      track.values = m_accessors.read(sampler.output, track.width, name + ", values");
    }
    if (!track.is_complete())
      m_check.fail(name + " has " + std::to_string(track.values.size()) + " numbers for " +
                   std::to_string(track.times.size()) + " keys");
  }

  const tinygltf::Model& m_gltf;
  const Gltf_accessor_reader& m_accessors;
  const Gltf_check& m_check;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_CLIP_READER_H
