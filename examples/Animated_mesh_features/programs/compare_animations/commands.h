// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_COMMANDS_H
#define COMPARE_ANIMATIONS_COMMANDS_H

#include "compare_animations/Output.h"
#include "compare_animations/Settings.h"

namespace Compare_animations {

// Each reads what it compares and tells what it has found. The words of the settings are theirs.
// throws Error.

// Two animations: matched features, alignment in time, events of one of them only, distance.
Result compare_pair(const Settings& settings);

// All pairs of a collection.
Result compare_all(const Settings& settings);

// One animation with all of a collection.
Result rank(const Settings& settings);

// One animation's features with their descriptors. `descriptors`: the array as a file, if there is one.
Result describe(const Settings& settings, std::string& descriptors);

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_COMMANDS_H
