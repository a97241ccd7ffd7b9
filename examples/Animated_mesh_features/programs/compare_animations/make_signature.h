// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_MAKE_SIGNATURE_H
#define COMPARE_ANIMATIONS_MAKE_SIGNATURE_H

#include "compare_animations/Analysed_animation.h"
#include "compare_animations/Item.h"
#include "compare_animations/Settings.h"

#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace Compare_animations {

typedef CGAL::Animated_mesh_features::Animation_signature Signature;

// Reads an animation, detects its features and describes them, or takes what the cache has; or reads a file of
// features. throws Error.
Signature make_signature(const Item& item, const Settings& settings);

// The same of an animation that is to be shown, too, and is not a file of features. throws Error.
Signature make_signature(const Item& item, const Settings& settings, std::unique_ptr<Analysed_animation>& animation);

// The same for all of a collection. What cannot be read is told on the standard error output and left out of both
// lists. returns how many were left out.
std::size_t make_signatures(std::vector<Item>& items, std::vector<Signature>& signatures, const Settings& settings);

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_MAKE_SIGNATURE_H
