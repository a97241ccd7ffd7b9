// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_PROGRESS_BAR_H
#define DETECT_FEATURES_PROGRESS_BAR_H

#ifdef _WIN32
  #include <io.h>
#else
  #include <unistd.h>
#endif

#include <cstddef>
#include <cstdio>
#include <string>

namespace Detect_features {

inline bool stderr_is_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(fileno(stderr)) != 0;
#endif
}

// One line at the bottom of a terminal; nothing where there is none.
class Progress_bar
{
public:
  explicit Progress_bar(bool wanted)
    : m_is_shown(wanted && stderr_is_terminal())
  {}
  ~Progress_bar() { clear(); }
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void show(const std::string& what, double fraction)
  {
    if (!m_is_shown) return;
    const std::size_t width = 40, done = std::size_t(fraction * double(width));
    const std::string line = "[" + std::string(done, '#') + std::string(width - done, ' ') + "] " +
                             std::to_string(int(100 * fraction)) + " % " + what;
    if (line == m_line) return;
    std::fprintf(stderr, "\r%s%s", line.c_str(), erase_rest);
    std::fflush(stderr);
    m_line = line;
  }

  void clear()
  {
    if (m_line.empty()) return;
    std::fprintf(stderr, "\r%s", erase_rest);
    std::fflush(stderr);
    m_line.clear();
  }

private:
  static constexpr const char* erase_rest = "\x1b[K"; // ECMA-48: erase to the end of the line
  bool m_is_shown;
  std::string m_line;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_PROGRESS_BAR_H
