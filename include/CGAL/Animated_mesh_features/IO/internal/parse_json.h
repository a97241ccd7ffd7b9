// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_JSON_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_JSON_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/check_nesting.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Where a parser is in a JSON text, as "features[3].sigma"; it is told what the parser meets.
class Json_place
{
public:
  void enter(bool is_array) { m_levels.push_back({is_array, 0, std::string()}); }
  void name(const std::string& member) { m_levels.back().member = member; }
  void leave()
  {
    m_levels.pop_back();
    pass();
  }
  void pass() // a value that is complete
  {
    if (!m_levels.empty()) ++m_levels.back().index;
  }

  std::size_t depth() const { return m_levels.size(); }

  // of the whole, in which it is
  const std::string& member() const { return m_levels.front().member; }

  std::string text() const
  {
    std::string result;
    for (const Level& level : m_levels) {
      if (level.is_array)
        result += "[" + std::to_string(level.index) + "]";
      else if (!level.member.empty())
        result += (result.empty() ? "" : ".") + level.member;
    }
    return result;
  }

private:
  struct Level
  {
    bool is_array;
    std::size_t index;
    std::string member;
  };
  std::vector<Level> m_levels;
};

// "line 3, column 7" of the byte that is the `n`-th, from 1.
inline std::string line_and_column(const std::string& text, std::size_t n)
{
  const auto end = text.begin() + std::ptrdiff_t((std::min)(n == 0 ? 0 : n - 1, text.size()));
  const auto line_begin = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return "line " + std::to_string(1 + std::count(text.begin(), end, '\n')) + ", column " +
         std::to_string(1 + (end - line_begin));
}

// The value of a JSON text. To nlohmann-json the members of objects are sorted: the names of those of the member `object`
// of the whole are appended to `names` in the order of the text.
// throws Input_error if it is none, is nested too deeply, or holds a number that no double can hold; `file` is for messages.
inline nlohmann::json parse_json(const std::string& text, const std::string& file, const std::string& object,
                                 std::vector<std::string>& names)
{
  typedef nlohmann::json Json;
  check_nesting(text, file);
  Json_place place;
  const auto at = [&] { return place.text().empty() ? std::string() : ", at " + place.text(); };
  const auto follow = [&](int, Json::parse_event_t event, Json& parsed) {
    switch (event) {
    case Json::parse_event_t::object_start:
    case Json::parse_event_t::array_start:
      place.enter(event == Json::parse_event_t::array_start);
      break;
    case Json::parse_event_t::object_end:
    case Json::parse_event_t::array_end:
      place.leave();
      break;
    case Json::parse_event_t::value:
      place.pass();
      break;
    case Json::parse_event_t::key:
      if (place.depth() == 2 && place.member() == object) names.push_back(parsed.get<std::string>());
      place.name(parsed.get<std::string>());
      break;
    }
    return true;
  };
  try {
    return Json::parse(text, follow);
  } catch (const Json::parse_error& e) {
    throw Input_error(file + ": is no valid JSON: " + line_and_column(text, e.byte) + at());
  } catch (const Json::out_of_range&) {
    throw Input_error(file + ": a number is too large" + at());
  }
}

inline nlohmann::json parse_json(const std::string& text, const std::string& file)
{
  std::vector<std::string> names;
  return parse_json(text, file, std::string(), names);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_JSON_H
