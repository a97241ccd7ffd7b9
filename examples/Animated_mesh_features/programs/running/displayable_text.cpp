// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/displayable_text.h"

#include <cstddef>

namespace Programs {

namespace {

// How many bytes the first character has (Unicode, table 3-7: no surrogates, none longer than it must be); 0 if there
// is none.
std::size_t character_length(std::string_view s)
{
  const auto byte = [s](std::size_t i) -> unsigned { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0; };
  const unsigned lead = byte(0), second = byte(1);
  if (lead < 0x80) return 1;
  const std::size_t length = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0u) != 0x80) return 0;
  const bool is_too_long = (lead == 0xe0 && second < 0xa0) || (lead == 0xf0 && second < 0x90);
  const bool is_surrogate = lead == 0xed && second > 0x9f, is_beyond_all = lead == 0xf4 && second > 0x8f;
  return is_too_long || is_surrogate || is_beyond_all ? 0 : length;
}

// Of a character of several bytes: C1 (a terminal takes U+009B for the begin of a command), separators of lines, and what
// overrides the direction of writing (U+202A to U+202E, U+2066 to U+2069).
bool is_control(std::string_view c)
{
  const auto is_between = [c](std::string_view first, std::string_view last) {
    return c.size() == first.size() && c >= first && c <= last;
  };
  return is_between("\xc2\x80", "\xc2\x9f") || is_between("\xe2\x80\xa8", "\xe2\x80\xae") ||
         is_between("\xe2\x81\xa6", "\xe2\x81\xa9");
}

} // namespace

std::string displayable_text(std::string_view text)
{
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const unsigned char first = static_cast<unsigned char>(text[0]);
    if (length == 0 || first < 0x20 || first == 0x7f || is_control(text.substr(0, length)))
      result += "\xef\xbf\xbd";
    else
      result += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

} // namespace Programs
