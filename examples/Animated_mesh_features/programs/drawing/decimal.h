// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_DRAWING_DECIMAL_H
#define PROGRAMS_DRAWING_DECIMAL_H

#include <string>

// Numbers for people, whatever the locale.

namespace Programs {

// `n` times 10 to the power of `exponent` as a decimal number, exactly.
std::string decimal(long long n, int exponent);

// A number with so many digits, without zeros that say nothing; very large and very small ones with a power of ten.
std::string rounded(double x, int digits = 3);

} // namespace Programs

#endif // PROGRAMS_DRAWING_DECIMAL_H
