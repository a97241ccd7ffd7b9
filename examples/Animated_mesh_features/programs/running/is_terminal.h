// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_IS_TERMINAL_H
#define PROGRAMS_RUNNING_IS_TERMINAL_H

#include <cstdio>

namespace Programs {

// Whether somebody reads what is written there while it is written.
bool is_terminal(std::FILE* stream);

} // namespace Programs

#endif // PROGRAMS_RUNNING_IS_TERMINAL_H
