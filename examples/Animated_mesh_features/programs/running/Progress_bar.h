// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_PROGRESS_BAR_H
#define PROGRAMS_RUNNING_PROGRESS_BAR_H

#include <string>

namespace Programs {

// One line at the bottom of a terminal; nothing where there is none.
class Progress_bar
{
public:
  // `prefix` stands before all that is shown.
  explicit Progress_bar(bool wanted, const std::string& prefix = std::string());
  ~Progress_bar() { clear(); }
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void show(const std::string& what, double fraction);
  void clear();

private:
  bool m_is_shown;
  std::string m_prefix, m_line;
};

} // namespace Programs

#endif // PROGRAMS_RUNNING_PROGRESS_BAR_H
