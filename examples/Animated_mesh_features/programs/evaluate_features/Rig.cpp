// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Rig.h"

#include <CGAL/Animated_mesh_features/IO/read_rig_events.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>

namespace AMF = CGAL::Animated_mesh_features;

namespace Evaluate_features {

std::vector<std::vector<AMF::Rest_shape::Index>> Rig::regions() const
{
  std::vector<std::vector<AMF::Rest_shape::Index>> result;
  for (const AMF::IO::Rig_file_data::Joint& joint : data.joints)
    result.emplace_back(joint.region.begin(), joint.region.end());
  return result;
}

std::vector<AMF::Joint_event> Rig::events() const
{
  std::vector<AMF::Joint_event> result;
  for (std::size_t j = 0; j < data.joints.size(); ++j)
    for (const AMF::IO::Rig_file_data::Maximum& m : data.joints[j].maxima)
      result.push_back({j, m.time, m.angle, m.prominence});
  return result;
}

Rig read_rig(const Rig_source& source, const Feature_file& features)
{
  if (!source.model.empty()) return read_model_rig(source, features);
  Rig rig;
  rig.data = AMF::IO::read_rig_events(source.events);
  const auto& d = features.data.description;
  const double tolerance = 1e-3; // files may have rounded the time between two frames
  if (rig.data.vertices != d.vertices || rig.data.frames != d.frames ||
      !(std::abs(rig.data.frame_duration - d.frame_duration) <= tolerance * d.frame_duration))
    throw AMF::Input_error(source.events + ": is about " + std::to_string(rig.data.vertices) + " vertices in " +
                           std::to_string(rig.data.frames) + " frames of " + std::to_string(rig.data.frame_duration) +
                           " s, the features of " + features.path + " about " + std::to_string(d.vertices) + " in " +
                           std::to_string(d.frames) + " of " + std::to_string(d.frame_duration) + " s");
  rig.points = read_points(source.rest, features);
  return rig;
}

} // namespace Evaluate_features
