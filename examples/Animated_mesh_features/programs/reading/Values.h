// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_VALUES_H
#define PROGRAMS_READING_VALUES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

// The fields of all programs.

namespace Programs {

typedef double FT;
typedef CGAL::Animated_mesh_features::Spatio_temporal_field<FT> Values; // of all vertices in all frames

} // namespace Programs

#endif // PROGRAMS_READING_VALUES_H
