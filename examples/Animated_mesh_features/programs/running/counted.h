// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_COUNTED_H
#define PROGRAMS_RUNNING_COUNTED_H

#include <cstddef>
#include <string>

namespace Programs {

// "1 feature", "2 features"
inline std::string counted(std::size_t n, const std::string& singular, const std::string& plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

} // namespace Programs

#endif // PROGRAMS_RUNNING_COUNTED_H
