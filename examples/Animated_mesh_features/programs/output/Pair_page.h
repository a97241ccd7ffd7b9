// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_PAIR_PAGE_H
#define PROGRAMS_OUTPUT_PAIR_PAGE_H

#include "scenes/Shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace Programs {

// Checks that this program can write a page of two animations at all.
// throws Option_error.
void check_pair_page();

// Checks that the page has room for one of them, of that size; to be asked before anything is computed.
// throws Option_error.
void check_pair_page(std::size_t number_of_vertices, std::size_t number_of_frames);

// The page, see write_html_pair().
// throws Option_error, Input_error.
std::string pair_page(const Shown_scene& a, const Shown_scene& b, const nlohmann::ordered_json& comparison);

} // namespace Programs

#endif // PROGRAMS_OUTPUT_PAIR_PAGE_H
