// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_BUFFER_H
#define PROGRAMS_SCENES_GLTF_BUFFER_H

#include "scenes/append_little_endian.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace Programs {

// The binary part of a glTF file, and the JSON that tells what is where in it. What is small is kept; places after it
// are reserved for what is large, which is written piece by piece later. Everything is a multiple of four bytes.
class Gltf_buffer
{
public:
  // what a view is for, in glTF's own numbers
  enum Target
  {
    ANIMATION = 0,
    VERTICES = 34962,
    TRIANGLES = 34963
  };

  struct Bounds
  {
    std::vector<double> min, max;
  };

  // All that is added until the next view belongs to this one.
  void begin_view(Target target, std::size_t stride = 0) { m_views.push_back({target, stride, m_size, 0}); }

  // Appends tuples of values; the number of their accessor. Not after anything was reserved.
  template <class T>
  std::size_t add(const std::vector<T>& values, std::size_t components)
  {
    append_little_endian(m_data, values);
    return reserve<T>(values.size() / components, components);
  }
  std::size_t add_with_bounds(const std::vector<float>& values, std::size_t components);

  // The number of the accessor of `count` tuples that will be written after all that was added and reserved so far.
  template <class T>
  std::size_t reserve(std::size_t count, std::size_t components, Bounds bounds = Bounds())
  {
    return reserve(component_type(T()), sizeof(T), count, components, std::move(bounds));
  }

  static Bounds bounds(const std::vector<float>& values, std::size_t components);

  const std::string& data() const { return m_data; }
  std::size_t size() const { return m_size; } // with what is reserved

  // Adds the members "buffers", "bufferViews" and "accessors".
  void append_to(nlohmann::ordered_json& gltf) const;

private:
  struct View
  {
    Target target;
    std::size_t stride, offset, size;
  };
  struct Accessor
  {
    std::size_t view, offset;
    int component_type;
    std::size_t count, components;
    bool is_normalized; // bytes stand for numbers from -1 or 0 to 1
    Bounds bounds;
  };

  // in glTF's own numbers
  static int component_type(std::int8_t) { return 5120; }
  static int component_type(std::uint8_t) { return 5121; }
  static int component_type(std::uint16_t) { return 5123; }
  static int component_type(std::uint32_t) { return 5125; }
  static int component_type(float) { return 5126; }

  std::size_t reserve(int component_type, std::size_t component_size, std::size_t count, std::size_t components,
                      Bounds bounds);

  std::vector<View> m_views;
  std::vector<Accessor> m_accessors;
  std::string m_data;
  std::size_t m_size = 0;
};

} // namespace Programs

#endif // PROGRAMS_SCENES_GLTF_BUFFER_H
