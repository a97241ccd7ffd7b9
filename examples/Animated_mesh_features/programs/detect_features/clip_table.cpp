// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/clip_table.h"

#include "running/displayable_text.h"

#include <algorithm>
#include <cstdio>

namespace Detect_features {

namespace {

// How many columns a text takes at a terminal, if every letter takes one.
std::size_t letters(const std::string& utf8)
{
  return std::size_t(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width)
{
  const std::size_t n = letters(text);
  return text + std::string(n < width ? width - n : 0, ' ');
}

} // namespace

std::string clip_table(const std::vector<Clip_outcome>& clips)
{
  std::size_t width = 4;
  for (const Clip_outcome& c : clips) width = (std::max)(width, letters(Programs::displayable_text(c.clip)));
  std::string table = padded("clip", width) +
                      "  frames  seconds  features  strongest: time (s)   vertex  size (sigma)  " +
                      "duration (tau, s)  strength\n";
  for (const Clip_outcome& c : clips) {
    table += padded(Programs::displayable_text(c.clip), width);
    if (!c.failure.empty()) {
      table += "  left out: " + c.failure + '\n';
      continue;
    }
    const Outcome& o = c.outcome;
    char line[160];
    std::snprintf(line, sizeof line, "  %6zu  %7.4g  %8zu", o.frames, o.duration, o.features);
    table += line;
    if (o.strongest) {
      const Programs::Feature& f = *o.strongest;
      std::snprintf(line, sizeof line, "  %19.4g  %7zu  %12.4g  %17.4g  %8.3g\n", f.time, f.vertex_index, f.sigma,
                    f.tau, f.strength);
      table += line;
    } else {
      table += "  " + o.reason + '\n';
    }
  }
  return table;
}

} // namespace Detect_features
