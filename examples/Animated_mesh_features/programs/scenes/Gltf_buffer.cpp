// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/Gltf_buffer.h"

#include <CGAL/assertions.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace Programs {

std::size_t Gltf_buffer::add_with_bounds(const std::vector<float>& values, std::size_t components)
{
  const std::size_t accessor = add(values, components);
  m_accessors[accessor].bounds = bounds(values, components);
  return accessor;
}

std::size_t Gltf_buffer::reserve(int component_type, std::size_t component_size, std::size_t count,
                                 std::size_t components, Bounds bounds)
{
  View& view = m_views.back();
  m_accessors.push_back(
      {m_views.size() - 1, view.size, component_type, count, components, component_size == 1, std::move(bounds)});
  view.size += count * components * component_size;
  m_size += count * components * component_size;
  CGAL_postcondition(m_size % 4 == 0 && m_data.size() <= m_size);
  return m_accessors.size() - 1;
}

Gltf_buffer::Bounds Gltf_buffer::bounds(const std::vector<float>& values, std::size_t components)
{
  Bounds b;
  b.min.assign(values.begin(), values.begin() + std::ptrdiff_t(components));
  b.max = b.min;
  for (std::size_t i = 0; i < values.size(); ++i) {
    b.min[i % components] = (std::min)(b.min[i % components], double(values[i]));
    b.max[i % components] = (std::max)(b.max[i % components], double(values[i]));
  }
  return b;
}

void Gltf_buffer::append_to(nlohmann::ordered_json& gltf) const
{
  typedef nlohmann::ordered_json Json;
  gltf["buffers"] = Json::array({{{"byteLength", m_size}}});
  Json& views = gltf["bufferViews"] = Json::array();
  for (const View& v : m_views) {
    Json view = {{"buffer", 0}, {"byteOffset", v.offset}, {"byteLength", v.size}};
    if (v.stride != 0) view["byteStride"] = v.stride;
    if (v.target != ANIMATION) view["target"] = int(v.target);
    views.push_back(std::move(view));
  }
  Json& accessors = gltf["accessors"] = Json::array();
  for (const Accessor& a : m_accessors) {
    const char* const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    Json accessor = {{"bufferView", a.view},
                     {"byteOffset", a.offset},
                     {"componentType", a.component_type},
                     {"count", a.count},
                     {"type", a.components == 16 ? "MAT4" : types[a.components - 1]}};
    if (a.is_normalized) accessor["normalized"] = true;
    if (!a.bounds.min.empty()) {
      accessor["min"] = a.bounds.min;
      accessor["max"] = a.bounds.max;
    }
    accessors.push_back(std::move(accessor));
  }
}

} // namespace Programs
