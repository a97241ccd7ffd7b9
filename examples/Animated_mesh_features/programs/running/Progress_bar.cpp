// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/Progress_bar.h"

#include "running/displayable_text.h"
#include "running/is_terminal.h"

#include <cstddef>
#include <cstdio>

namespace Programs {

namespace {

const char* const erase_rest = "\x1b[K"; // ECMA-48: erase to the end of the line

} // namespace

Progress_bar::Progress_bar(bool wanted, const std::string& prefix)
  : m_is_shown(wanted && is_terminal(stderr))
  , m_prefix(displayable_text(prefix))
{}

void Progress_bar::show(const std::string& what, double fraction)
{
  if (!m_is_shown) return;
  const std::size_t width = 40, done = std::size_t(fraction * double(width));
  const std::string line = "[" + std::string(done, '#') + std::string(width - done, ' ') + "] " +
                           std::to_string(int(100 * fraction)) + " % " + m_prefix + what;
  if (line == m_line) return;
  std::fprintf(stderr, "\r%s%s", line.c_str(), erase_rest);
  std::fflush(stderr);
  m_line = line;
}

void Progress_bar::clear()
{
  if (m_line.empty()) return;
  std::fprintf(stderr, "\r%s", erase_rest);
  std::fflush(stderr);
  m_line.clear();
}

} // namespace Programs
