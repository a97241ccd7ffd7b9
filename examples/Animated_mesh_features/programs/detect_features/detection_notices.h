// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_DETECTION_NOTICES_H
#define DETECT_FEATURES_DETECTION_NOTICES_H

#include "detect_features/Detection.h"
#include "detect_features/Method_options.h"

#include <string>

namespace Detect_features {

// What a user should know to judge the features: that many of them are at a limit of the scales, that the mesh is too coarse
// for small ones, that one event dwarfs all others. A line each, which says what to do.
std::string detection_notices(const Programs::Sequence& sequence, const Method_options& options, const Detection& detection);

} // namespace Detect_features

#endif // DETECT_FEATURES_DETECTION_NOTICES_H
