// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_APPEND_JSON_STRING_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_APPEND_JSON_STRING_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The length of the UTF-8 sequence at the start of `s`, which is not empty; 0 if there is no valid one.
inline std::size_t utf8_sequence_length(std::string_view s)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(s[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t n = first >= 0xc2 && first < 0xe0   ? 2
                        : first >= 0xe0 && first < 0xf0 ? 3
                        : first >= 0xf0 && first < 0xf5 ? 4
                                                        : 0;
  if (n == 0 || s.size() < n) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const unsigned char second = byte(1);
  if (first == 0xe0 && second < 0xa0) return 0;  // could be shorter
  if (first == 0xed && second >= 0xa0) return 0; // half of a UTF-16 pair
  if (first == 0xf0 && second < 0x90) return 0;  // could be shorter
  if (first == 0xf4 && second >= 0x90) return 0; // beyond U+10FFFF
  return n;
}

// A string as JSON, in quotes. File names may be any bytes, JSON must be UTF-8: what is not becomes U+FFFD.
inline void append_json_string(std::string& json, std::string_view s)
{
  json += '"';
  while (!s.empty()) {
    const std::size_t n = utf8_sequence_length(s);
    const char c = s[0];
    if (n == 0) {
      json += "\xef\xbf\xbd";
    } else if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (n == 1 && c < ' ') {
      const char digits[] = "0123456789abcdef";
      json += "\\u00";
      json += digits[c >> 4];
      json += digits[c & 15];
    } else {
      json += s.substr(0, n);
    }
    s.remove_prefix(n == 0 ? 1 : n);
  }
  json += '"';
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_APPEND_JSON_STRING_H
