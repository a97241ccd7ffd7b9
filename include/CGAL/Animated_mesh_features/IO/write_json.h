// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_JSON_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_JSON_H

#include <CGAL/Animated_mesh_features/IO/Result_description.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_output.h>
#include <CGAL/Animated_mesh_features/IO/internal/append_json_string.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// JSON of values; JSON has no infinity and no NaN, they become `null`.
class Json_output
{
public:
  explicit Json_output(std::ostream& os)
    : m_out(os)
  {}

  Json_output& raw(std::string_view text)
  {
    m_out << text;
    return *this;
  }

  // `"name": value`
  template <class T>
  Json_output& member(std::string_view name, const T& value)
  {
    put(name);
    m_out << ": ";
    put(value);
    return *this;
  }

  void flush() { m_out.flush(); }

private:
  template <class T>
  void put(const T& value)
  {
    if constexpr (std::is_floating_point<T>::value) {
      if (is_finite(value)) {
        m_out << value;
      } else {
        m_out << "null";
      }
    } else if constexpr (std::is_arithmetic<T>::value) {
      m_out << value;
    } else if constexpr (std::is_same<T, std::monostate>::value) {
      m_out << "null";
    } else if constexpr (std::is_same<T, Result_description::Value>::value) {
      std::visit([this](const auto& v) { this->put(v); }, value);
    } else if constexpr (std::is_convertible<const T&, std::string_view>::value) {
      std::string quoted;
      append_json_string(quoted, value);
      m_out << quoted;
    } else { // a range
      m_out << '[';
      std::size_t i = 0;
      for (const auto& v : value) {
        if (i++ > 0) m_out << ", ";
        put(v);
      }
      m_out << ']';
    }
  }

  Text_output m_out;
};

// `"features": [...]`
template <class FeatureRange>
void write_json_features(Json_output& out, const FeatureRange& features,
                         const Vertex_origins& origins = Vertex_origins())
{
  out.raw("\"features\": [");
  const char* separator = "\n  {";
  for (const auto& f : features) {
    out.raw(separator).member("vertex", f.vertex_index).raw(", ").member("frame", f.frame);
    out.raw(", ").member("time", f.time).raw(", ").member("position", f.position);
    out.raw(", ").member("sigma", f.sigma).raw(", ").member("tau", f.tau).raw(", ").member("radius", f.radius());
    out.raw(", ").member("response", f.response).raw(", ").member("strength", f.strength());
    out.raw(", ").member("rest_position", f.rest_position).raw(", ").member("triangle", f.triangle);
    out.raw(", ").member("barycentric_coordinates", f.barycentric_coordinates);
    out.raw(", ").member("at_scale_limit", f.at_scale_limit);
    if (!origins.empty()) out.raw(", ").member("file_vertices", origins.of(f.vertex_index));
    out.raw("}");
    separator = ",\n  {";
  }
  out.raw("]");
}

// Where the file's vertices are that are counted through all parts.
inline void write_parts(Json_output& out, const Vertex_origins& origins)
{
  if (origins.empty()) return;
  out.raw(",\n               \"parts\": [");
  const char* separator = "\n                 {";
  for (const Vertex_origins::Part& part : origins.parts) {
    out.raw(separator).member("name", part.name).raw(", ").member("first_vertex", part.first_vertex);
    out.raw(", ").member("vertices", part.vertices).raw("}");
    separator = ",\n                 {";
  }
  out.raw("]");
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes features as JSON, one per line and in the order of the range; a detector's are sorted by strength, strongest
first.

\code{.json}
{"format": "animated-mesh-features", "version": 1,
 "animation": {"vertices": 8431, "faces": 16843, "frames": 48, "frame_duration": 0.0333333,
               "bounding_box_diagonal": 2.54, "mean_edge_length": 0.0212},
 "parameters": {"preset": "calibrated"},
 "features": [
  {"vertex": 12, "frame": 7, "time": 0.2371, "position": [0, 0, 0], "sigma": 0.06, "tau": 0.1, "radius": 0.085,
   "response": -0.31, "strength": 0.31, "rest_position": [0, 0, 0], "triangle": [12, 13, 20],
   "barycentric_coordinates": [1, 0, 0], "at_scale_limit": false}]}
\endcode

If vertices are not those of the file (`Result_description::origins`), a feature has `"file_vertices": [12, 907]` too,
the vertices of the file of which its vertex is made, counted from 0 through all of the file's parts, and the animation
has `"parts": [{"name": "node 3, mesh 0, primitive 0", "first_vertex": 0, "vertices": 1425}]`.

Vertices are counted from 0 in the order of the input file; times are in seconds, lengths in the input's unit. Numbers
have as many digits as it takes to read the same number back, strings are UTF-8. Independent of the stream's locale.

\tparam FeatureRange a range of `Spatio_temporal_feature<VertexDescriptor>`

Errors are left in the state of the stream; `Output_file` reports them.
*/
template <class FeatureRange>
void write_json(std::ostream& os, const FeatureRange& features, const Result_description& description)
{
  const Result_description& d = description;
  internal::Json_output out(os);
  out.raw("{").member("format", "animated-mesh-features").raw(", ").member("version", 1).raw(",\n");
  out.raw(" \"animation\": {").member("vertices", d.vertices).raw(", ").member("faces", d.faces);
  out.raw(", ").member("frames", d.frames).raw(", ").member("frame_duration", d.frame_duration);
  out.raw(",\n               ").member("bounding_box_diagonal", d.bounding_box_diagonal);
  out.raw(", ").member("mean_edge_length", d.mean_edge_length);
  internal::write_parts(out, d.origins);
  out.raw("},\n");

  out.raw(" \"parameters\": {");
  const char* separator = "\n  ";
  for (const auto& parameter : d.parameters) {
    out.raw(separator).member(parameter.first, parameter.second);
    separator = ",\n  ";
  }
  out.raw("},\n");

  out.raw(" ");
  internal::write_json_features(out, features, d.origins);
  out.raw("}\n").flush();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_JSON_H
