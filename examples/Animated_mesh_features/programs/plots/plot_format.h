// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_PLOT_FORMAT_H
#define PROGRAMS_PLOTS_PLOT_FORMAT_H

#include "drawing/Drawing_format.h"

#include <string>

namespace Programs {

// The format of a plot, by the ending of its file; SVG on the standard output, which has none.
// throws Option_error, with the option, if the ending tells nothing.
Drawing_format plot_format(const std::string& option, const std::string& path);

} // namespace Programs

#endif // PROGRAMS_PLOTS_PLOT_FORMAT_H
