// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_TELL_H
#define PROGRAMS_RUNNING_TELL_H

#include <string>
#include <string_view>

namespace Programs {

// Lines as a terminal may get them, whatever names from files are in them: without control characters, see
// displayable_text(); of a line of more than 4,000 bytes, the middle is left out.
std::string terminal_text(std::string_view lines);

// Writes lines to the standard error output, by terminal_text(). All that programs tell about their inputs goes this way.
void tell(std::string_view lines);

} // namespace Programs

#endif // PROGRAMS_RUNNING_TELL_H
