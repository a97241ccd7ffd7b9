// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_WRITE_BASE64_H
#define PROGRAMS_PAGE_WRITE_BASE64_H

#include <ostream>
#include <string>

namespace Programs {

// Bytes as text, four characters for three of them (RFC 4648, with padding, in a single line).
void write_base64(std::ostream& os, const std::string& bytes);

} // namespace Programs

#endif // PROGRAMS_PAGE_WRITE_BASE64_H
