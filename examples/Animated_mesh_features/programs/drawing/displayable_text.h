// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_DRAWING_DISPLAYABLE_TEXT_H
#define PROGRAMS_DRAWING_DISPLAYABLE_TEXT_H

#include <string>
#include <string_view>

namespace Programs {

// The same text, for who accepts UTF-8 only. File names may be any bytes: what is not UTF-8, and control characters,
// become U+FFFD, one for each byte.
std::string displayable_text(std::string_view text);

} // namespace Programs

#endif // PROGRAMS_DRAWING_DISPLAYABLE_TEXT_H
