// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CHECK_SCALES_H
#define DETECT_FEATURES_CHECK_SCALES_H

#include "detect_features/Method_options.h"
#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <string>

// The scales that a mesh and its frames allow, known before anything is computed.

namespace Detect_features {

// Checks that there are scales to be searched; `file` is that of the rest shape.
// throws Option_error if a limit that was typed leaves none, Input_error if the animation itself does.
void check_scales(const Programs::Sequence& sequence, const Method_options& options, const std::string& file);

// One line, or nothing: there are so many smoothing counts that they take long.
std::string counts_notice(const Programs::Sequence& sequence, const Method_options& options);

// Whether the mesh resolves no level below that sigma.
bool is_smallest_resolved(const CGAL::Animated_mesh_features::Rest_shape& shape, const Method_options& options, double sigma);

// Whether edges are so large a part of the surface that the smallest sigma at which features are found is the one that the
// mesh resolves.
bool is_limited_by_mesh(const CGAL::Animated_mesh_features::Rest_shape& shape, const Method_options& options,
                        double smallest_sigma);

// What edges a mesh has, what they resolve, and what to do.
std::string coarse_mesh(const CGAL::Animated_mesh_features::Rest_shape& shape, const Method_options& options);

} // namespace Detect_features

#endif // DETECT_FEATURES_CHECK_SCALES_H
