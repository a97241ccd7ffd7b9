// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_WRITE_PLOT_H
#define PROGRAMS_PLOTS_WRITE_PLOT_H

#include "drawing/Drawing_format.h"
#include "scenes/Shown_scene.h"

#include <ostream>

namespace Programs {

// Writes a plot of features as a drawing:
//
// - Above, the features over time: a circle at the time (seconds) and the strength, with a radius in proportion to sigma,
//   and a bar as long as tau; colours are from red for the smallest tau to blue for the largest.
// - Below, how many features there are of which sigma (length) and of which tau (seconds), on logarithmic axes. They are
//   left out if there are no features.
//
// The fields of the scene are not used. Errors of the stream are left in its state, `Output_file` reports them.
// throws what check_scene() does if the scene does not fit together; Output_error if cairo cannot draw.
void write_plot(std::ostream& os, const Shown_scene& scene, Drawing_format format);

} // namespace Programs

#endif // PROGRAMS_PLOTS_WRITE_PLOT_H
