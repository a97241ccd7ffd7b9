// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_JSON_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_JSON_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Feature_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Result_description.h>
#include <CGAL/Animated_mesh_features/IO/internal/Json_value.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

inline void check_json_format(const Json_value& file)
{
  const std::string format = "animated-mesh-features";
  if (!file.has("format") || file["format"].json() != format)
    file.fail("is no file of features: it has no \"format\": \"" + format + "\"");
  const std::size_t known_version = 1, version = file["version"].count();
  if (version != known_version)
    file.fail("has version " + std::to_string(version) + " of the format; known is version " +
              std::to_string(known_version) + " only");
}

inline std::vector<Vertex_origins::Part> read_parts(const Json_value& array)
{
  std::vector<Vertex_origins::Part> parts;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const Json_value part = array[i];
    parts.push_back({part["name"].text(), part["first_vertex"].count(), part["vertices"].count()});
  }
  return parts;
}

inline void read_animation_description(const Json_value& animation, Result_description& d)
{
  d.vertices = animation["vertices"].count();
  d.faces = animation["faces"].count();
  d.frames = animation["frames"].count();
  d.frame_duration = animation["frame_duration"].number();
  if (d.frame_duration < 0) animation["frame_duration"].fail("is negative");
  d.bounding_box_diagonal = animation["bounding_box_diagonal"].number();
  d.mean_edge_length = animation["mean_edge_length"].number();
  if (animation.has("parts")) d.origins.parts = read_parts(animation["parts"]);
}

inline Result_description::Value read_parameter(const Json_value& value)
{
  const nlohmann::json& json = value.json();
  const auto all = [&](auto is) { return json.is_array() && std::all_of(json.begin(), json.end(), is); };
  // what was not finite
  const auto number = [](const nlohmann::json& x) {
    return x.is_null() ? std::numeric_limits<double>::quiet_NaN() : x.get<double>();
  };
  if (json.is_null()) return std::monostate();
  if (json.is_boolean()) return json.get<bool>();
  const std::uint64_t largest = std::uint64_t((std::numeric_limits<std::int64_t>::max)());
  if (json.is_number_integer() && !(json.is_number_unsigned() && json.get<std::uint64_t>() > largest))
    return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (all([](const auto& x) { return x.is_number() || x.is_null(); })) {
    std::vector<double> numbers;
    for (const auto& x : json) numbers.push_back(number(x));
    return numbers;
  }
  if (all([](const auto& x) { return x.is_string(); })) return json.get<std::vector<std::string>>();
  value.fail("a truth value, a number, a text, or an array of numbers or of texts is expected");
}

template <class T, class Read>
void read_triple(const Json_value& array, std::array<T, 3>& values, const Read& read)
{
  if (array.size() != values.size()) array.fail("three values are expected");
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = read(array[i]);
}

// From 1 in files, from 0 in memory.
inline std::size_t read_number(const Json_value& number)
{
  const std::size_t i = number.count();
  if (i == 0) number.fail("is 0: ranks and places are counted from 1");
  return i - 1;
}

// Parents are ranks. In a selection of features, or in another order, ranks are not 1, 2, 3 ...; a parent that was not
// selected is none.
inline void find_parents(const Json_value& features, std::vector<Feature_point>& result)
{
  std::map<std::size_t, std::size_t> rows;
  bool is_in_order = true;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const std::size_t rank = features[i].has("rank") ? read_number(features[i]["rank"]) : i;
    is_in_order = is_in_order && rank == i;
    rows.emplace(rank, i);
  }
  if (is_in_order) return;
  for (Feature_point& f : result) {
    const auto row = rows.find(f.parent);
    f.parent = row == rows.end() ? Feature_point::none : row->second;
  }
}

inline Feature_point read_feature(const Json_value& feature, const Result_description& d)
{
  const auto number = [](const Json_value& x) { return x.number(); };
  const auto vertex = [&](const Json_value& i) { return i.index(d.vertices, "vertex"); };
  Feature_point f;
  f.vertex_index = vertex(feature["vertex"]);
  f.frame = feature["frame"].index(d.frames, "frame");
  f.time = feature["time"].number();
  f.refined_frame = f.time / d.frame_duration;
  read_triple(feature["position"], f.position, number);
  f.sigma = feature["sigma"].number();
  f.tau = feature["tau"].number();
  f.response = feature["response"].number();
  f.strength = feature["strength"].number();
  // which files of other programs need not have
  if (feature.has("amplitude")) f.amplitude = feature["amplitude"].number();
  if (feature.has("fit")) f.fit = feature["fit"].number();
  if (feature.has("place")) f.place = read_number(feature["place"]);
  if (feature.has("parent") && !feature["parent"].json().is_null()) f.parent = read_number(feature["parent"]);
  read_triple(feature["rest_position"], f.rest_position, number);
  read_triple(feature["triangle"], f.triangle, vertex);
  read_triple(feature["barycentric_coordinates"], f.barycentric_coordinates, number);
  f.at_scale_limit = feature["at_scale_limit"].truth();
  return f;
}

inline void read_parameters(const Json_value& object, const std::vector<std::string>& names, Result_description& d)
{
  for (const std::string& name : names) d.parameters.emplace_back(name, read_parameter(object[name]));
  if (object.json().size() < names.size()) object.fail("two parameters have the same name");
}

// Each feature has them, or none.
inline std::vector<std::vector<std::size_t>> read_file_vertices(const Json_value& features,
                                                                const std::vector<Vertex_origins::Part>& parts)
{
  const std::string name = "file_vertices";
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!features[0].has(name)) {
      if (features[i].has(name)) features[i].fail("has " + name + ", the first feature has not");
      continue;
    }
    const Json_value vertices = features[i][name];
    result.emplace_back();
    for (std::size_t k = 0; k < vertices.size(); ++k)
      result.back().push_back(
          parts.empty() ? vertices[k].count()
                        : vertices[k].index(parts.back().first_vertex + parts.back().vertices, "vertex of the file"));
  }
  return result;
}

inline Feature_file_data read_json_text(const std::string& text, const std::string& name)
{
  std::vector<std::string> parameters;
  const nlohmann::json json = parse_json(text, name, "parameters", parameters);
  const Json_value file(json, name);
  check_json_format(file);

  Feature_file_data data;
  Result_description& d = data.description;
  read_animation_description(file["animation"], d);
  read_parameters(file["parameters"], parameters, d);
  const Json_value features = file["features"];
  if (features.size() > 0 && !(d.frame_duration > 0)) file["animation"]["frame_duration"].fail("is not positive");
  for (std::size_t i = 0; i < features.size(); ++i) data.features.push_back(read_feature(features[i], d));
  find_parents(features, data.features);
  data.file_vertices = read_file_vertices(features, d.origins.parts);
  return data;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads features from JSON, as `write_json()` writes it: they are the same numbers, bit for bit, and `write_json()`
makes the same bytes of them.

- What follows from other members is not looked at: `radius`. `Feature_point::refined_frame`, which is
  not written, is `time` over the time between two frames.
- Members that are not known are ignored. `amplitude`, `fit`, `rank`, `place` and `parent` may be missing; `amplitude` is 0
  then, and the others are as in a `Feature_point` of which nothing is known. Ranks are those of the file's order; where it
  has others, as a selection of features does, parents are found by them.
- Numbers of parameters that are written without a point and without an exponent are `std::int64_t` if they fit,
  others `double`; an empty array is one of numbers; `null` in an array of numbers stands for what is not finite and
  becomes NaN.

\param is a stream; read to its end.
\param name the file for messages.

\throws Input_error if the stream cannot be read; it is no JSON, or no file of features; its version is not known; a
member is missing or of another type, a number of a feature or of the animation is not finite, a vertex or a frame is not
in the animation; it is nested more than 64 times. The message names the file and the member, as `features[3].sigma`.

Linear in the size of the file, which is held in memory.

Needs nlohmann-json 3.9 or newer.
*/
inline Feature_file_data read_json(std::istream& is, const std::string& name)
{
  const std::string text{std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>()};
  if (!is) throw Input_error(name + ": cannot read");
  return internal::read_json_text(text, name);
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the same from the file at `path`.
*/
inline Feature_file_data read_json(const std::string& path)
{
  std::string text;
  internal::read_content(path, text);
  return internal::read_json_text(text, path);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_JSON_H
