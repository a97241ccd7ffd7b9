// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_ANIMATION_REPORT_H
#define PROGRAMS_READING_ANIMATION_REPORT_H

#include "reading/Animation.h"
#include "reading/Reading_options.h"

#include <CGAL/Animated_mesh_features/IO/Result_description.h>

#include <string>

// What is told of an animation: to the user, and in files of results.

namespace Programs {

// Some lines, for --verbose.
std::string animation_report(const Reading_options& options, const Animation& animation);

// A line for each thing that must be known to judge the result: of several clips one was taken that nobody chose, files
// were left out or changed.
std::string reading_notices(const Reading_options& options, const Animation& animation);

// For files of results; without parameters.
CGAL::Animated_mesh_features::IO::Result_description animation_description(const Animation& animation);

// Adds all that is needed to read the same animation again.
void add_reading_parameters(CGAL::Animated_mesh_features::IO::Result_description& description,
                            const Reading_options& options, const Animation& animation);

// Adds a parameter, or that there is none.
template <class T>
void add_if(bool is_used, CGAL::Animated_mesh_features::IO::Result_description& description, const std::string& name,
            const T& value)
{
  if (is_used)
    description.add(name, value);
  else
    description.add(name, CGAL::Animated_mesh_features::IO::Result_description::Value());
}

} // namespace Programs

#endif // PROGRAMS_READING_ANIMATION_REPORT_H
