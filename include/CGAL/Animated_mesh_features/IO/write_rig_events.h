// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_RIG_EVENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_RIG_EVENTS_H

#include <CGAL/Animated_mesh_features/IO/Rig_file_data.h>

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes the events of a rig as JSON, a joint in a line, as `read_rig_events()` reads it: the same numbers, bit for bit.

Errors are left in the state of the stream; `Output_file` reports them.

Needs nlohmann-json 3.9 or newer.
*/
inline void write_rig_events(std::ostream& os, const Rig_file_data& data)
{
  typedef nlohmann::ordered_json Json;
  const auto text = [](const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); };
  const Json animation = {
      {"vertices", data.vertices}, {"frames", data.frames}, {"frame_duration", data.frame_duration}};
  os << "{\"format\": \"animated-mesh-features-rig-events\", \"version\": 1,\n \"animation\": " + text(animation) +
            ",\n \"joints\": [";
  const char* separator = "\n  ";
  for (const Rig_file_data::Joint& joint : data.joints) {
    Json maxima = Json::array();
    for (const Rig_file_data::Maximum& m : joint.maxima)
      maxima.push_back({{"time", m.time}, {"angle_deg", m.angle}, {"prominence_deg", m.prominence}});
    os << separator + text({{"name", joint.name}, {"region", joint.region}, {"maxima", maxima}});
    separator = ",\n  ";
  }
  os << "]}\n";
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_RIG_EVENTS_H
