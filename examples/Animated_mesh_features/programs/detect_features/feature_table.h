// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_FEATURE_TABLE_H
#define DETECT_FEATURES_FEATURE_TABLE_H

#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Detect_features {

// The strongest features as a table for a reader at a terminal: at most `most` of them, a line each, and how many others
// there are. Where vertices are not those of the file, a column has the first of the file's that each is made of. Empty if
// there are no features.
std::string feature_table(const std::vector<Programs::Feature>& features,
                          const CGAL::Animated_mesh_features::IO::Vertex_origins& origins, std::size_t most = 20);

} // namespace Detect_features

#endif // DETECT_FEATURES_FEATURE_TABLE_H
