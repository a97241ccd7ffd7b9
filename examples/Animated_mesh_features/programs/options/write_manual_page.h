// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_WRITE_MANUAL_PAGE_H
#define PROGRAMS_OPTIONS_WRITE_MANUAL_PAGE_H

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace Programs {

class Option_groups;

// What the manual page of a program says besides its options.
struct Manual_page
{
  std::string program, version, summary;
  std::string usage;                                         // one line
  std::vector<std::pair<std::string, std::string>> sections; // title and lines, as they are; after the options
};

// Writes a page for man(1).
void write_manual_page(std::ostream& os, const Manual_page& page, const Option_groups& options);

} // namespace Programs

#endif // PROGRAMS_OPTIONS_WRITE_MANUAL_PAGE_H
