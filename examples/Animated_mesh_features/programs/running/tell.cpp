// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/tell.h"

#include "running/displayable_text.h"

#include <cstddef>
#include <iostream>

namespace Programs {

namespace {

// With the begin, which says what it is about, and the end, which says what is wrong.
std::string shortened(std::string_view line)
{
  const std::size_t longest = 4000, begin = 3000, end = longest - begin;
  if (line.size() <= longest) return std::string(line);
  return std::string(line.substr(0, begin)) + " [...] " + std::string(line.substr(line.size() - end));
}

} // namespace

std::string terminal_text(std::string_view lines)
{
  std::string result;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    result += displayable_text(shortened(lines.substr(0, end)));
    if (end == std::string_view::npos) break;
    result += '\n';
    lines.remove_prefix(end + 1);
  }
  return result;
}

void tell(std::string_view lines)
{
  std::cerr << terminal_text(lines) << std::flush;
}

} // namespace Programs
