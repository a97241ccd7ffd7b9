// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CLOSING_STEP_H
#define DETECT_FEATURES_CLOSING_STEP_H

#include "reading/Values.h"

namespace Detect_features {

// By how much a field, N x F, changes from the last frame to the first, in the mean over its vertices, over the largest
// change from a frame to the next: about 1 at most if the animation is cyclic. 0 if nothing changes.
double closing_step(const Programs::Values& field);

} // namespace Detect_features

#endif // DETECT_FEATURES_CLOSING_STEP_H
