// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_GLTF_BUFFER_H
#define PROGRAMS_SCENES_GLTF_BUFFER_H

#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

template <class T>
void append_little_endian(std::string& bytes, const T* values, std::size_t n)
{
  const std::size_t begin = bytes.size();
  bytes.resize(begin + n * sizeof(T));
  for (std::size_t i = 0; i < n; ++i) store(&bytes[begin + i * sizeof(T)], values[i], Byte_order::LITTLE_ENDIAN_ORDER);
}

// The binary part of a glTF file, and the JSON that tells what is where in it. What is small is kept; places behind it
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

  // Appends tuples of values; the number of their accessor.
  template <class T>
  std::size_t add(const std::vector<T>& values, std::size_t components, bool with_bounds = false)
  {
    CGAL_precondition(m_data.size() == m_size);
    append_little_endian(m_data, values.data(), values.size());
    return reserve<T>(values.size() / components, components,
                      with_bounds ? bounds(values.data(), values.size(), components) : Bounds());
  }

  // The number of the accessor of `count` tuples that will be written behind all that was added and reserved so far.
  template <class T>
  std::size_t reserve(std::size_t count, std::size_t components, Bounds bounds = Bounds())
  {
    View& view = m_views.back();
    m_accessors.push_back(
        {m_views.size() - 1, view.size, component<T>(), count, components, sizeof(T) == 1, std::move(bounds)});
    view.size += count * components * sizeof(T);
    m_size += count * components * sizeof(T);
    CGAL_precondition(m_size % 4 == 0);
    return m_accessors.size() - 1;
  }

  template <class T>
  static Bounds bounds(const T* values, std::size_t n, std::size_t components)
  {
    Bounds b;
    for (std::size_t c = 0; c < components; ++c) {
      b.min.push_back(double(values[c]));
      b.max.push_back(double(values[c]));
    }
    for (std::size_t i = 0; i < n; ++i) {
      b.min[i % components] = (std::min)(b.min[i % components], double(values[i]));
      b.max[i % components] = (std::max)(b.max[i % components], double(values[i]));
    }
    return b;
  }

  const std::string& data() const { return m_data; }
  std::size_t size() const { return m_size; } // with what is reserved

  // the members "buffers", "bufferViews" and "accessors"
  void write(Json_output& out) const
  {
    out.raw("\"buffers\":[{").member("byteLength", m_size).raw("}],\n\"bufferViews\":[");
    const char* separator = "\n{";
    for (const View& v : m_views) {
      out.raw(separator).member("buffer", 0).raw(",").member("byteOffset", v.offset);
      out.raw(",").member("byteLength", v.size);
      if (v.stride != 0) out.raw(",").member("byteStride", v.stride);
      if (v.target != ANIMATION) out.raw(",").member("target", int(v.target));
      out.raw("}");
      separator = ",\n{";
    }
    out.raw("],\n\"accessors\":[");
    separator = "\n{";
    for (const Accessor& a : m_accessors) {
      const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
      out.raw(separator).member("bufferView", a.view).raw(",").member("byteOffset", a.offset);
      out.raw(",").member("componentType", a.component).raw(",").member("count", a.count);
      out.raw(",").member("type", types[a.components - 1]);
      if (a.is_normalized) out.raw(",").member("normalized", true);
      if (!a.bounds.min.empty()) out.raw(",").member("min", a.bounds.min).raw(",").member("max", a.bounds.max);
      out.raw("}");
      separator = ",\n{";
    }
    out.raw("]");
  }

private:
  struct View
  {
    Target target;
    std::size_t stride, offset, size;
  };
  struct Accessor
  {
    std::size_t view, offset;
    int component;
    std::size_t count, components;
    bool is_normalized; // bytes stand for numbers from -1 or 0 to 1
    Bounds bounds;
  };

  template <class T>
  static constexpr int component()
  {
    return std::is_same<T, std::int8_t>::value     ? 5120
           : std::is_same<T, std::uint8_t>::value  ? 5121
           : std::is_same<T, std::uint32_t>::value ? 5125
                                                   : 5126; // float
  }

  std::vector<View> m_views;
  std::vector<Accessor> m_accessors;
  std::string m_data;
  std::size_t m_size = 0;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_GLTF_BUFFER_H
