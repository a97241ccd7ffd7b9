// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_DEFLATED_H
#define PROGRAMS_PAGE_DEFLATED_H

#include <string>

namespace Programs {

// The bytes compressed as a zlib stream (RFC 1950): what browsers call "deflate".
// throws std::bad_alloc, Output_error.
std::string deflated(const std::string& bytes);

} // namespace Programs

#endif // PROGRAMS_PAGE_DEFLATED_H
