// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_METHOD_POLICIES_H
#define DETECT_FEATURES_METHOD_POLICIES_H

#include "detect_features/Chosen_spatial_filter.h"
#include "detect_features/Method_values.h"
#include "detect_features/Method_options.h"

#include <CGAL/Animated_mesh_features/Scale_space/Scale_sampling.h>

#include <cstddef>

// What the options stand for.

namespace Detect_features {

// What the presets have where the options leave the choice.
Method_values method_values(const Method_options& options, std::size_t number_of_frames);

Chosen_spatial_filter spatial_filter(const Method_options& options);

// of the preset CALIBRATED; `diameter` is that of the rest shape.
AMF::Fixed_ratio_sampling fixed_ratio_sampling(const Method_options& options, double diameter);

// of the preset PUBLISHED
AMF::Every_smoothing_count every_smoothing_count(const Method_options& options);

} // namespace Detect_features

#endif // DETECT_FEATURES_METHOD_POLICIES_H
