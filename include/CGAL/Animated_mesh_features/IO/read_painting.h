// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_PAINTING_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_PAINTING_H

#include <CGAL/Animated_mesh_features/IO/Painting_file_data.h>
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

inline Painting_file_data::Stroke read_stroke(const Json_value& stroke, const Painting_file_data& data)
{
  Painting_file_data::Stroke result;
  const Json_value frames = stroke["frames"];
  if (frames.size() != 2) frames.fail("the first and the last frame are expected");
  result.first_frame = frames[0].index(data.frames, "frame");
  result.last_frame = frames[1].index(data.frames, "frame");
  if (result.last_frame < result.first_frame) frames.fail("the last frame is before the first one");
  const Json_value vertices = stroke["vertices"];
  result.vertices.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    result.vertices.push_back(vertices[i].index(data.vertices, "vertex"));
  if (stroke.has("frame")) {
    const std::size_t frame = stroke["frame"].index(data.frames, "frame");
    if (frame < result.first_frame || frame > result.last_frame) stroke["frame"].fail("is not within frames");
  }
  return result;
}

inline Painting_file_data read_painting_text(const std::string& text, const std::string& name)
{
  const nlohmann::json json = parse_json(text, name);
  const Json_value file(json, name);
  const std::string format = "animated-mesh-features-painting";
  if (!file.has("format") || file["format"].json() != format)
    file.fail("is no painting: it has no \"format\": \"" + format + "\"");
  const std::size_t known_version = 1, version = file["version"].count();
  if (version != known_version)
    file.fail("has version " + std::to_string(version) + " of the format; known is version " +
              std::to_string(known_version) + " only");
  Painting_file_data data;
  const Json_value animation = file["animation"];
  data.vertices = animation["vertices"].count();
  data.frames = animation["frames"].count();
  data.frame_duration = animation["frame_duration"].number();
  if (!(data.frame_duration > 0)) animation["frame_duration"].fail("is not positive");
  data.painter = file["painter"].text();
  const Json_value strokes = file["strokes"];
  for (std::size_t i = 0; i < strokes.size(); ++i) data.strokes.push_back(read_stroke(strokes[i], data));
  return data;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads what somebody painted on an animation, a JSON file:

\code{.json}
{"format": "animated-mesh-features-painting", "version": 1,
 "animation": {"vertices": 8431, "frames": 48, "frame_duration": 0.0333333},
 "painter": "A",
 "strokes": [
  {"frame": 12, "frames": [10, 15], "vertices": [17, 18, 40]}]}
\endcode

A stroke holds the vertices that are painted, counted from 0 in the order of the animation that was painted on, from the
first to the last of `frames`; `frame`, in which it was painted, may be missing. Members that are not known are ignored.

\param is a stream; read to its end.
\param name the file for messages.

\throws Input_error if the stream cannot be read; it is no JSON, or no painting; its version is not known; a member is missing
or of another type; a vertex or a frame is not in the animation, frames are in the wrong order, or `frame` is not within
them; it is nested more than 64 times. The message names the file and the member, as `strokes[3].vertices[0]`.

Linear in the size of the file, which is held in memory.

Needs nlohmann-json 3.9 or newer.
*/
inline Painting_file_data read_painting(std::istream& is, const std::string& name)
{
  const std::string text{std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()};
  if (!is) throw Input_error(name + ": cannot read");
  return internal::read_painting_text(text, name);
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the same from the file at `path`.
*/
inline Painting_file_data read_painting(const std::string& path)
{
  std::string text;
  internal::read_content(path, text);
  return internal::read_painting_text(text, path);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_PAINTING_H
