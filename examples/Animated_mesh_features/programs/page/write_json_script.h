// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_WRITE_JSON_SCRIPT_H
#define PROGRAMS_PAGE_WRITE_JSON_SCRIPT_H

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>

namespace Programs {

// A script of a page that holds JSON. Errors of the stream are left in its state.
void write_json_script(std::ostream& os, const std::string& id, const nlohmann::ordered_json& json);

} // namespace Programs

#endif // PROGRAMS_PAGE_WRITE_JSON_SCRIPT_H
