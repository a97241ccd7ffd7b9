// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_GEOMETRY_READER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_GEOMETRY_READER_H

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_accessor_reader.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>
#include <CGAL/Animated_mesh_features/IO/internal/skin_influences.h>

#include <tiny_gltf.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Reads the primitives of a glTF file's meshes: triangles, texture coordinates, morph targets, influences of joints.
class Gltf_geometry_reader
{
public:
  Gltf_geometry_reader(const Gltf_accessor_reader& accessors, const Gltf_check& check)
    : m_accessors(accessors)
    , m_check(check)
  {}

  // The triangles of a primitive; points and lines have none. `name` is the primitive's, for messages.
  std::optional<Keyframed_model::Geometry> read(const tinygltf::Primitive& primitive, const std::string& name) const
  {
    const auto position = primitive.attributes.find("POSITION");
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (position == primitive.attributes.end() ||
        (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN))
      return std::nullopt;
    Keyframed_model::Geometry geometry;
    geometry.points = vectors(position->second, name + ", positions");
    add_triangles(primitive, mode, name, geometry);
    for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
      const auto displacement = primitive.targets[t].find("POSITION");
      geometry.targets.emplace_back();
      if (displacement == primitive.targets[t].end()) continue;
      const std::string target = name + ", morph target " + std::to_string(t);
      geometry.targets.back() = vectors(displacement->second, target);
      if (geometry.targets.back().size() != geometry.points.size())
        m_check.fail(target + " has another number of vertices");
    }
    add_texture_coordinates(primitive, name, geometry);
    add_influences(primitive, name, geometry);
    return geometry;
  }

private:
  std::vector<Keyframed_model::Vector> vectors(int accessor, const std::string& name) const
  {
    const std::vector<double> values = m_accessors.read(accessor, 3, name);
    std::vector<Keyframed_model::Vector> result(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) result[i / 3][i % 3] = values[i];
    return result;
  }

  void add_triangles(const tinygltf::Primitive& primitive, int mode, const std::string& name,
                     Keyframed_model::Geometry& geometry) const
  {
    std::vector<std::size_t> corners;
    if (primitive.indices >= 0) {
      corners = m_accessors.read_indices(primitive.indices, 1, name + ", indices");
    } else {
      for (std::size_t v = 0; v < geometry.points.size(); ++v) corners.push_back(v);
    }
    const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
      for (std::size_t c : {corners[i], corners[j], corners[k]})
        if (c >= geometry.points.size())
          m_check.fail(name + ", triangle " + std::to_string(geometry.triangles.size()) + " has a corner at vertex " +
                       std::to_string(c) + ", there are " + std::to_string(geometry.points.size()) + " vertices");
      // Strips are tied together by triangles that repeat a vertex.
      if (mode != TINYGLTF_MODE_TRIANGLES &&
          (corners[i] == corners[j] || corners[j] == corners[k] || corners[k] == corners[i]))
        return;
      geometry.triangles.push_back({{corners[i], corners[j], corners[k]}});
    };
    const std::size_t n = corners.size();
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      if (n % 3 != 0) m_check.fail(name + " has " + std::to_string(n) + " corners, which do not make triangles");
      for (std::size_t i = 0; i < n; i += 3) add(i, i + 1, i + 2);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      for (std::size_t i = 0; i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2); // every second one the other way
    } else {
      for (std::size_t i = 0; i + 2 < n; ++i) add(i + 1, i + 2, 0);
    }
  }

  // the first set of them
  void add_texture_coordinates(const tinygltf::Primitive& primitive, const std::string& name,
                               Keyframed_model::Geometry& geometry) const
  {
    const auto found = primitive.attributes.find("TEXCOORD_0");
    if (found == primitive.attributes.end()) return;
    const std::vector<double> values = m_accessors.read(found->second, 2, name + ", texture coordinates");
    if (values.size() != 2 * geometry.points.size())
      m_check.fail(name + ": texture coordinates are not as many as vertices");
    for (std::size_t i = 0; i < values.size(); i += 2)
      geometry.texture_coordinates.push_back({{values[i], values[i + 1]}});
  }

  void add_influences(const tinygltf::Primitive& primitive, const std::string& name,
                      Keyframed_model::Geometry& geometry) const
  {
    const std::size_t width = 4;
    std::vector<std::vector<std::size_t>> joints;
    std::vector<std::vector<double>> weights;
    for (std::size_t set = 0;; ++set) {
      const auto j = primitive.attributes.find("JOINTS_" + std::to_string(set));
      const auto w = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (j == primitive.attributes.end() || w == primitive.attributes.end()) break;
      joints.push_back(m_accessors.read_indices(j->second, width, name + ", joints"));
      weights.push_back(m_accessors.read(w->second, width, name + ", weights"));
      if (joints.back().size() != width * geometry.points.size() || weights.back().size() != joints.back().size())
        m_check.fail(name + ": joints or weights are not as many as vertices");
    }
    if (joints.empty()) return;
    std::vector<Keyframed_model::Influence> influences;
    for (std::size_t v = 0; v < geometry.points.size(); ++v) {
      influences.clear();
      for (std::size_t set = 0; set < joints.size(); ++set)
        for (std::size_t i = width * v; i < width * (v + 1); ++i)
          influences.push_back({joints[set][i], weights[set][i]});
      append_influences(influences, geometry);
    }
  }

  const Gltf_accessor_reader& m_accessors;
  const Gltf_check& m_check;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_GEOMETRY_READER_H
