// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CALENDAR_SECONDS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CALENDAR_SECONDS_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

enum class Date_order
{
  YEAR_MONTH_DAY,
  DAY_MONTH_YEAR,
  MONTH_DAY_YEAR
};

// Takes dates and times that are written without separators apart: 20240131 and 235959 after it, or both in one.
inline std::vector<std::string> calendar_fields(const std::vector<std::string>& digits)
{
  std::vector<std::string> fields;
  bool is_after_date = false;
  for (const std::string& d : digits) {
    const bool is_date = d.size() == 8 || d.size() == 14;
    const bool is_time = is_after_date && (d.size() == 4 || d.size() == 6);
    std::size_t i = 0;
    if (is_date) fields.push_back(d.substr(0, i = 4));
    if (is_date || is_time)
      for (; i < d.size(); i += 2) fields.push_back(d.substr(i, 2));
    else
      fields.push_back(d);
    is_after_date = d.size() == 8;
  }
  return fields;
}

// Days from some day on, in the Gregorian calendar, or nothing if there is no such day. A year has four digits.
inline std::optional<long long> calendar_day(const std::string& year, const std::string& month, const std::string& day)
{
  if (year.size() != 4 || month.size() > 2 || day.size() > 2) return std::nullopt;
  int y = std::stoi(year), m = std::stoi(month);
  const int d = std::stoi(day);
  const bool is_leap = (y % 4 == 0 && y % 100 != 0) || y % 400 == 0;
  const std::array<int, 12> days = {{31, is_leap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31}};
  if (m < 1 || m > 12 || d < 1 || d > days[std::size_t(m) - 1]) return std::nullopt;
  long long n = 365LL * y + d;
  for (int i = 1; i < m; ++i) n += days[std::size_t(i) - 1];
  --y; // leap days of the years before
  return n + y / 4 - y / 100 + y / 400;
}

// The seconds that a date stands for whose first field is `first`, with up to three fields of a time of day after it;
// nothing if it is no date. `end` is the field after it.
inline std::optional<long long> calendar_seconds(const std::vector<std::string>& fields, std::size_t first,
                                                 Date_order order, std::size_t& end)
{
  if (first + 3 > fields.size()) return std::nullopt;
  const std::string &a = fields[first], &b = fields[first + 1], &c = fields[first + 2];
  const std::optional<long long> day = order == Date_order::YEAR_MONTH_DAY   ? calendar_day(a, b, c)
                                       : order == Date_order::DAY_MONTH_YEAR ? calendar_day(c, b, a)
                                                                             : calendar_day(c, a, b);
  if (!day) return std::nullopt;
  long long seconds = *day * 86400;
  const int limits[] = {24, 60, 60}, units[] = {3600, 60, 1};
  end = first + 3;
  for (int i = 0; i < 3 && end < fields.size(); ++i, ++end) {
    if (fields[end].size() > 2 || std::stoi(fields[end]) >= limits[i]) break;
    seconds += std::stoll(fields[end]) * units[i];
  }
  return seconds;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CALENDAR_SECONDS_H
