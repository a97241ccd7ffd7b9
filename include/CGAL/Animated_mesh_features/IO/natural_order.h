// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_NATURAL_ORDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_NATURAL_ORDER_H

#include <cstddef>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

compares names as people count: `walk_2.obj` comes before `walk_10.obj`. Runs of digits are compared by their value,
of whatever length, everything else byte by byte. Names that differ in leading zeros only are ordered by these, fewer
first, so that different names are never equivalent. Independent of the locale.

\returns `true` if `a` comes before `b`: a strict total order.
*/
inline bool natural_order(std::string_view a, std::string_view b)
{
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto byte = [](char c) { return static_cast<unsigned char>(c); };
  // The number that starts at `i`, without leading zeros; `i` moves after it.
  const auto number = [&](std::string_view s, std::size_t& i) {
    while (i < s.size() && s[i] == '0') ++i;
    const std::size_t begin = i;
    while (i < s.size() && is_digit(s[i])) ++i;
    return s.substr(begin, i - begin);
  };

  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::string_view m = number(a, i), n = number(b, j);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
    } else {
      if (a[i] != b[j]) return byte(a[i]) < byte(b[j]);
      ++i;
      ++j;
    }
  }
  if (i < a.size() || j < b.size()) return j < b.size();
  if (a.size() != b.size()) return a.size() < b.size();
  return a > b; // as many leading zeros, of different numbers: those of the later number first
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_NATURAL_ORDER_H
