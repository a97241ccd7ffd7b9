// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/feature_table.h"

#include "running/counted.h"

#include <algorithm>
#include <cstdio>

namespace Detect_features {

std::string feature_table(const std::vector<Programs::Feature>& features,
                          const CGAL::Animated_mesh_features::IO::Vertex_origins& origins, std::size_t most)
{
  if (features.empty()) return "";
  std::string table = "rank    time (s)  frame   vertex  " + std::string(origins.empty() ? "" : "of the file  ") +
                      "size (sigma)  duration (tau, s)  amplitude   fit  place\n";
  const std::size_t n = (std::min)(most, features.size());
  bool has_limits = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Programs::Feature& f = features[i];
    char begin[80], end[80], in_file[24] = "";
    std::snprintf(begin, sizeof begin, "%4zu  %10.4g  %5zu  %7zu", i + 1, f.time, f.frame, f.vertex_index);
    if (!origins.empty())
      std::snprintf(in_file, sizeof in_file, "  %11zu", origins.file_vertices[origins.first[f.vertex_index]]);
    std::snprintf(end, sizeof end, "  %11.4g%c  %17.4g  %9.4g  %4.2f  %5zu\n", f.sigma, f.at_scale_limit ? '*' : ' ',
                  f.tau, f.amplitude, f.fit, f.place + 1);
    has_limits |= f.at_scale_limit;
    table += std::string(begin) + in_file + end;
  }
  if (has_limits) table += "* at a limit of the scales: it may be larger, smaller, longer or shorter\n";
  if (n < features.size()) table += "and " + Programs::counted(features.size() - n, "other", "others") + '\n';
  return table + "-o FILE writes all that is known of them, as .json, .csv or .ply; --html FILE shows them\n";
}

} // namespace Detect_features
