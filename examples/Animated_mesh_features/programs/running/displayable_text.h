// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_DISPLAYABLE_TEXT_H
#define PROGRAMS_RUNNING_DISPLAYABLE_TEXT_H

#include <string>
#include <string_view>

namespace Programs {

// The same text, for who accepts UTF-8 only. File names may be any bytes: those that are not UTF-8 become U+FFFD, and so
// do control characters, also those beyond ASCII and those that turn the direction of writing.
std::string displayable_text(std::string_view text);

} // namespace Programs

#endif // PROGRAMS_RUNNING_DISPLAYABLE_TEXT_H
