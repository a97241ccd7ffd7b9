// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_MEASURE_DEFORMATION_H
#define DETECT_FEATURES_MEASURE_DEFORMATION_H

#include "detect_features/Method_options.h"
#include "detect_features/Method_values.h"
#include "output/Wanted_fields.h"
#include "reading/Sequence.h"
#include "running/Monitor.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

namespace Detect_features {

// The deformation of all vertices in all frames.
struct Deformation
{
  Programs::Values field;
  double noise = 0;                // of the responses to it
  double ball_radius = 0;          // length; 0 if no balls were needed
  bool bounds_ball_radius = false; // the default is smaller, as balls would have too many vertices
};

// The first stage. On the way, the fields that are wanted are written and kept; the deformation is written only, since
// the second stage has it as long as that takes.
// throws Option_error, Output_error, Numerical_error, Cancelled.
Deformation measure_deformation(const Programs::Sequence& sequence, const Method_options& options,
                                const Method_values& values, Programs::Wanted_fields& fields,
                                Programs::Monitor& monitor);

// The geodesic balls alone, of the radius and by the method that the options tell: of each vertex the vertices around it.
// throws Option_error, Numerical_error, Cancelled.
CGAL::Animated_mesh_features::Compressed_rows find_balls(const CGAL::Animated_mesh_features::Rest_shape& shape,
                                                         const Method_options& options, Programs::Monitor& monitor);

} // namespace Detect_features

#endif // DETECT_FEATURES_MEASURE_DEFORMATION_H
