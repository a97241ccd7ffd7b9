// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_JSON_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_JSON_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/IO/Feature_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Result_description.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

makes a JSON object of a feature, with the members that `IO::write_json()` writes but for the rank, which only a range
tells; `nlohmann::ordered_json` keeps their order. nlohmann-json finds this function by itself, for ranges of features, too:
\code
nlohmann::ordered_json json = {{"strongest", features.front()}, {"all", features}};
\endcode

\tparam Json an instance of `nlohmann::basic_json`
*/
template <class Json>
void to_json(Json& json, const Feature_point& feature)
{
  json = Json::object({{"vertex", feature.vertex_index},
                       {"frame", feature.frame},
                       {"time", feature.time},
                       {"position", feature.position},
                       {"sigma", feature.sigma},
                       {"tau", feature.tau},
                       {"radius", feature.radius()},
                       {"response", feature.response},
                       {"amplitude", feature.amplitude},
                       {"fit", feature.fit},
                       {"strength", feature.strength},
                       {"place", feature.place + 1},
                       {"parent", feature.parent == Feature_point::none ? Json(nullptr) : Json(feature.parent + 1)},
                       {"rest_position", feature.rest_position},
                       {"triangle", feature.triangle},
                       {"barycentric_coordinates", feature.barycentric_coordinates},
                       {"at_scale_limit", feature.at_scale_limit}});
}

namespace IO {

namespace internal {

typedef nlohmann::ordered_json Json;

// In one line. JSON has no infinity and no NaN, they become `null`; and file names may be any bytes, JSON is UTF-8: what
// is not becomes U+FFFD.
inline std::string json_text(const Json& json)
{
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

inline Json json_of(const Result_description::Value& value)
{
  return std::visit(
      [](const auto& v) -> Json {
        if constexpr (std::is_same<std::decay_t<decltype(v)>, std::monostate>::value)
          return nullptr;
        else
          return v;
      },
      value);
}

inline Json json_of_animation(const Result_description& d)
{
  Json json = {{"vertices", d.vertices},
               {"faces", d.faces},
               {"frames", d.frames},
               {"frame_duration", d.frame_duration},
               {"bounding_box_diagonal", d.bounding_box_diagonal},
               {"mean_edge_length", d.mean_edge_length}};
  for (const Vertex_origins::Part& part : d.origins.parts)
    json["parts"].push_back({{"name", part.name}, {"first_vertex", part.first_vertex}, {"vertices", part.vertices}});
  return json;
}

// `file_vertices`: of each feature, or of none.
template <class FeatureRange>
void write_json(std::ostream& os, const FeatureRange& features, const Result_description& description,
                const std::vector<std::vector<std::size_t>>& file_vertices)
{
  std::string text = "{\"format\": \"animated-mesh-features\", \"version\": 1,\n";
  text += " \"animation\": " + json_text(json_of_animation(description)) + ",\n \"parameters\": {";
  const char* separator = "\n  ";
  for (const auto& parameter : description.parameters) {
    text += separator + json_text(parameter.first) + ": " + json_text(json_of(parameter.second));
    separator = ",\n  ";
  }
  text += "},\n \"features\": [";
  separator = "\n  ";
  std::size_t i = 0;
  for (const Feature_point& feature : features) {
    Json json = {{"rank", i + 1}};
    json.update(Json(feature));
    if (i < file_vertices.size()) json["file_vertices"] = file_vertices[i];
    ++i;
    text += separator + json_text(json);
    separator = ",\n  ";
    os.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  }
  text += "]}\n";
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes features as JSON, one per line and in the order of the range; a detector's are sorted by strength, strongest
first.

\code{.json}
{"format": "animated-mesh-features", "version": 1,
 "animation": {"vertices":8431,"faces":16843,"frames":48,"frame_duration":0.0333333,"bounding_box_diagonal":2.54,
               "mean_edge_length":0.0212},
 "parameters": {
  "preset": "calibrated"},
 "features": [
  {"rank":1,"vertex":12,"frame":7,"time":0.2371,"position":[0.0,0.0,0.0],"sigma":0.06,"tau":0.1,"radius":0.085,
   "response":-0.31,"amplitude":0.7,"fit":0.9,"strength":0.63,"place":1,"parent":null,
   "rest_position":[0.0,0.0,0.0],"triangle":[12,13,20],"barycentric_coordinates":[1.0,0.0,0.0],"at_scale_limit":false}]}
\endcode

If vertices are not those of the file (`Result_description::origins`), a feature has `"file_vertices": [12, 907]` too,
the vertices of the file of which its vertex is made, counted from 0 through all of the file's parts, and the animation
has `"parts": [{"name": "node 3, mesh 0, primitive 0", "first_vertex": 0, "vertices": 1425}]`.

Vertices and frames are counted from 0, vertices in the order of the input file; ranks, places and parents, which are
ranks, from 1. Times are in seconds, lengths in the input's unit. Numbers
have as many digits as it takes to read the same number back, what is not finite is `null`; strings are UTF-8, with
U+FFFD for bytes that are not. Independent of any locale. `read_json()` reads it all back.

\tparam FeatureRange a range of `Feature_point`, or of `Spatio_temporal_feature<VertexDescriptor>`

Errors are left in the state of the stream; `Output_file` reports them.

Needs nlohmann-json 3.9 or newer.
*/
template <class FeatureRange>
void write_json(std::ostream& os, const FeatureRange& features, const Result_description& description)
{
  std::vector<std::vector<std::size_t>> file_vertices;
  if (!description.origins.empty())
    for (const Feature_point& feature : features) file_vertices.push_back(description.origins.of(feature.vertex_index));
  internal::write_json(os, features, description, file_vertices);
}

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes what `read_json()` has read, or features with a selection of them taken out. Of a file that `write_json()` has
written and nobody has changed, it makes the same bytes.
*/
inline void write_json(std::ostream& os, const Feature_file_data& data)
{
  internal::write_json(os, data.features, data.description, data.file_vertices);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_JSON_H
