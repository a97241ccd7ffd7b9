// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_VIEWER_PAGE_H
#define PROGRAMS_OUTPUT_VIEWER_PAGE_H

#include <string>
#include <string_view>

namespace Programs {

// The viewer's page, which scenes are put into; empty if this program was built without.
std::string_view viewer_page();

// Why this program cannot write pages; empty if it can.
std::string missing_viewer();

} // namespace Programs

#endif // PROGRAMS_OUTPUT_VIEWER_PAGE_H
