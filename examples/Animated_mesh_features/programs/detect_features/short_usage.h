// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_SHORT_USAGE_H
#define DETECT_FEATURES_SHORT_USAGE_H

#include <string>

namespace Detect_features {

// What the program is for, commands to begin with, and which of its optional parts were built.
std::string short_usage();

} // namespace Detect_features

#endif // DETECT_FEATURES_SHORT_USAGE_H
