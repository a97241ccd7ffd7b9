// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_JSON_VALUE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_JSON_VALUE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A value in a JSON file, which knows where it is. All functions throw Input_error, with the file and the place, if it is
// something else than what it is asked for.
class Json_value
{
  typedef nlohmann::json Json;

public:
  Json_value(const Json& json, const std::string& file, std::string place = std::string())
    : m_json(&json)
    , m_file(&file)
    , m_place(std::move(place))
  {}

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Input_error(*m_file + ": " + (m_place.empty() ? "" : m_place + ": ") + what);
  }

  const Json& json() const { return *m_json; }

  bool has(const std::string& name) const { return m_json->is_object() && m_json->contains(name); }

  Json_value operator[](const std::string& name) const
  {
    if (!m_json->is_object()) fail("an object is expected");
    const auto found = m_json->find(name);
    const Json_value member(found == m_json->end() ? *m_json : *found, *m_file,
                            (m_place.empty() ? "" : m_place + ".") + name);
    if (found == m_json->end()) member.fail("is missing");
    return member;
  }

  std::size_t size() const
  {
    if (!m_json->is_array()) fail("an array is expected");
    return m_json->size();
  }

  Json_value operator[](std::size_t i) const
  {
    return Json_value((*m_json)[i], *m_file, m_place + "[" + std::to_string(i) + "]");
  }

  double number() const
  {
    if (!m_json->is_number()) fail("a finite number is expected");
    return m_json->get<double>();
  }

  std::size_t count() const
  {
    if (!m_json->is_number_unsigned()) fail("a whole number is expected, 0 or more");
    return m_json->get<std::size_t>();
  }

  // of something of which there are `size`
  std::size_t index(std::size_t size, const char* what) const
  {
    const std::size_t i = count();
    if (i >= size)
      fail("there is no " + std::string(what) + " " + std::to_string(i) + ", only " + std::to_string(size));
    return i;
  }

  bool truth() const
  {
    if (!m_json->is_boolean()) fail("true or false is expected");
    return m_json->get<bool>();
  }

  std::string text() const
  {
    if (!m_json->is_string()) fail("a text is expected");
    return m_json->get<std::string>();
  }

private:
  const Json* m_json;
  const std::string* m_file;
  std::string m_place;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_JSON_VALUE_H
