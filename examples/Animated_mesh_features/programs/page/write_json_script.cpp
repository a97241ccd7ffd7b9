// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/write_json_script.h"

#include <nlohmann/json.hpp>

namespace Programs {

void write_json_script(std::ostream& os, const std::string& id, const nlohmann::ordered_json& json)
{
  os << "<script type=\"application/json\" id=\"" << id << "\">\n";
  // A script ends at "</script" even within quotes. In JSON, "<" can occur within quotes only.
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<')
      os << "\\u003c";
    else
      os << c;
  }
  os << "\n</script>\n";
}

} // namespace Programs
