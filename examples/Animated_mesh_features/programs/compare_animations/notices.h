// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_NOTICES_H
#define COMPARE_ANIMATIONS_NOTICES_H

#include "compare_animations/Item.h"

#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>

#include <string>
#include <vector>

namespace Compare_animations {

// What the user is to be told: a line, or nothing.

// Files of features are among animations: less is known of them, and how alike two of these are is not to be compared
// with how alike animations are.
std::string notice_of_kinds(const std::vector<Item>& items);

// Two animations have as many frames, but other frame rates: one may have been told wrongly.
std::string notice_of_clocks(const CGAL::Animated_mesh_features::Animation_signature& a,
                             const CGAL::Animated_mesh_features::Animation_signature& b);

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_NOTICES_H
