// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_DETECT_H
#define DETECT_FEATURES_DETECT_H

#include "detect_features/Detection.h"
#include "detect_features/Method_options.h"
#include "output/Wanted_fields.h"
#include "reading/Sequence.h"
#include "running/Monitor.h"

#include <cstddef>

namespace Detect_features {

// Both stages: computes the deformation, hands out the fields that are wanted, and finds the features. `level_memory`
// bytes are for the space levels.
// throws Option_error, Output_error, Numerical_error, Cancelled.
Detection detect(const Programs::Sequence& sequence, const Method_options& options, std::size_t level_memory,
                 Programs::Wanted_fields& fields, Programs::Monitor& monitor);

} // namespace Detect_features

#endif // DETECT_FEATURES_DETECT_H
