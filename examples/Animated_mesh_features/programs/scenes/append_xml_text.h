// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_APPEND_XML_TEXT_H
#define PROGRAMS_SCENES_APPEND_XML_TEXT_H

#include <CGAL/Animated_mesh_features/IO/internal/append_json_string.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A text for the content of an XML element or an attribute in double quotes. File names may be any bytes; what is not
// UTF-8, and the control characters that XML cannot hold, become U+FFFD.
inline void append_xml_text(std::string& xml, std::string_view s)
{
  while (!s.empty()) {
    const std::size_t n = utf8_sequence_length(s);
    const char c = s[0];
    const bool is_control = n == 1 && c >= 0 && c < ' ' && c != '\t' && c != '\n';
    if (n == 0 || is_control) {
      xml += "\xef\xbf\xbd";
    } else if (c == '&') {
      xml += "&amp;";
    } else if (c == '<') {
      xml += "&lt;";
    } else if (c == '>') {
      xml += "&gt;";
    } else if (c == '"') {
      xml += "&quot;";
    } else {
      xml += s.substr(0, n);
    }
    s.remove_prefix(n == 0 ? 1 : n);
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_APPEND_XML_TEXT_H
