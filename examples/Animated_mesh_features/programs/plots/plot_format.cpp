// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plots/plot_format.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace Programs {

Drawing_format plot_format(const std::string& option, const std::string& path)
{
  std::string ending = path == "-" ? ".svg" : std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (ending == ".svg") return Drawing_format::SVG;
  if (ending == ".pdf") return Drawing_format::PDF;
  if (ending == ".png") return Drawing_format::PNG;
  throw CGAL::Animated_mesh_features::Option_error(option + " " + path +
                                                   ": the format is not clear from the ending (.svg, .pdf, .png)");
}

} // namespace Programs
