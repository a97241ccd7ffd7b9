// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_WRITE_MATRIX_H
#define COMPARE_ANIMATIONS_WRITE_MATRIX_H

#include "compare_animations/Distance_matrix.h"
#include "drawing/Drawing_format.h"

#include <iosfwd>

namespace Compare_animations {

// Draws the matrix, dark where animations are alike, and beside it the places in the plane with their names.
// throws Output_error if cairo cannot draw it, bad_alloc; errors of the stream are left in its state.
void write_matrix(std::ostream& os, const Distance_matrix& matrix, Programs::Drawing_format format);

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_WRITE_MATRIX_H
