// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_CHECK_OUTPUTS_H
#define PROGRAMS_OUTPUT_CHECK_OUTPUTS_H

#include <string>
#include <vector>

namespace Programs {

// To be called before anything is written. Compares files, not names: by whatever names, links and folders two paths lead
// to the same one. Pipes and devices may be written as often as one likes.
// throws Option_error if an output has no name, two outputs are the same file, or an output is an input.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

} // namespace Programs

#endif // PROGRAMS_OUTPUT_CHECK_OUTPUTS_H
