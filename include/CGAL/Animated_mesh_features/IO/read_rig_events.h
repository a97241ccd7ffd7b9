// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_RIG_EVENTS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_RIG_EVENTS_H

#include <CGAL/Animated_mesh_features/IO/Rig_file_data.h>
#include <CGAL/Animated_mesh_features/IO/internal/Json_value.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_json.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <istream>
#include <iterator>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

inline double non_negative_number(const Json_value& value)
{
  const double x = value.number();
  if (!(x >= 0)) value.fail("is negative");
  return x;
}

inline Rig_file_data::Joint read_joint(const Json_value& joint, std::size_t number_of_vertices)
{
  Rig_file_data::Joint result;
  result.name = joint["name"].text();
  const Json_value region = joint["region"], maxima = joint["maxima"];
  for (std::size_t i = 0; i < region.size(); ++i)
    result.region.push_back(region[i].index(number_of_vertices, "vertex"));
  for (std::size_t i = 0; i < maxima.size(); ++i) {
    const Json_value maximum = maxima[i];
    result.maxima.push_back({non_negative_number(maximum["time"]), non_negative_number(maximum["angle_deg"]),
                             non_negative_number(maximum["prominence_deg"])});
  }
  return result;
}

inline Rig_file_data read_rig_text(const std::string& text, const std::string& name)
{
  const nlohmann::json json = parse_json(text, name);
  const Json_value file(json, name);
  const std::string format = "animated-mesh-features-rig-events";
  if (!file.has("format") || file["format"].json() != format)
    file.fail("holds no events of a rig: it has no \"format\": \"" + format + "\"");
  const std::size_t known_version = 1, version = file["version"].count();
  if (version != known_version)
    file.fail("has version " + std::to_string(version) + " of the format; known is version " +
              std::to_string(known_version) + " only");
  Rig_file_data data;
  const Json_value animation = file["animation"];
  data.vertices = animation["vertices"].count();
  data.frames = animation["frames"].count();
  data.frame_duration = animation["frame_duration"].number();
  if (!(data.frame_duration > 0)) animation["frame_duration"].fail("is not positive");
  const Json_value joints = file["joints"];
  for (std::size_t i = 0; i < joints.size(); ++i) data.joints.push_back(read_joint(joints[i], data.vertices));
  return data;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads the events of a rig, a JSON file that is bound to no format of models:

\code{.json}
{"format": "animated-mesh-features-rig-events", "version": 1,
 "animation": {"vertices": 9000, "frames": 48, "frame_duration": 0.0333333},
 "joints": [
  {"name": "left knee", "region": [17, 18, 40],
   "maxima": [{"time": 0.2333, "angle_deg": 61.2, "prominence_deg": 40.5}]}]}
\endcode

`region` are the vertices that both sides of the joint move, counted from 0, such as those whose weights on the joint and
what hangs on it sum to between 0.1 and 0.9; angles are against the pose at rest. Members that are not known are ignored.

\param is a stream; read to its end.
\param name the file for messages.

\throws Input_error if the stream cannot be read; it is no JSON, or no such file; its version is not known; a member is
missing or of another type, a number is negative or not finite, a vertex is not in the animation; it is nested more than 64
times. The message names the file and the member, as `joints[3].maxima[0].time`.

Linear in the size of the file, which is held in memory.

Needs nlohmann-json 3.9 or newer.
*/
inline Rig_file_data read_rig_events(std::istream& is, const std::string& name)
{
  const std::string text{std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()};
  if (!is) throw Input_error(name + ": cannot read");
  return internal::read_rig_text(text, name);
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the same from the file at `path`.
*/
inline Rig_file_data read_rig_events(const std::string& path)
{
  std::string text;
  internal::read_content(path, text);
  return internal::read_rig_text(text, path);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_RIG_EVENTS_H
