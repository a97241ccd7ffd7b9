// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_WRITE_COMPLETION_H
#define PROGRAMS_OPTIONS_WRITE_COMPLETION_H

#include "options/Names.h"

#include <iosfwd>
#include <string>

namespace Programs {

class Option_groups;

// A shell that completes options when the user types them.
enum class Shell
{
  BASH,
  ZSH,
  FISH
};

Names<Shell> names(Shell);

// Writes what tells a shell the options of a program, to be installed as /usr/share/bash-completion/completions/PROGRAM,
// /usr/share/zsh/site-functions/_PROGRAM or /usr/share/fish/vendor_completions.d/PROGRAM.fish.
void write_completion(std::ostream& os, Shell shell, const std::string& program, const Option_groups& options);

} // namespace Programs

#endif // PROGRAMS_OPTIONS_WRITE_COMPLETION_H
