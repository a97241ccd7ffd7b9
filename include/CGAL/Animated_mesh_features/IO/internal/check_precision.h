// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_PRECISION_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_PRECISION_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_edges.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_extents.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_fault.h>
#include <CGAL/Animated_mesh_features/IO/internal/short_number.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Notes, or refuses, coordinates whose rounding is a large part of the edges, by the frame that lies farthest
// away. Where they are larger than edges, all triangles may be collapsed, which is told in these words.
template <class FT>
void check_precision(const std::vector<Frame_extent>& extents, const std::vector<Frame_fault>& faults,
                     Animation_file_data<FT>& data)
{
  const double coarse = 0.01, hopeless = 0.1; // of the mean edge
  const auto distance_in_sizes = [&](std::size_t f) { return extents[f].magnitude / extents[f].diagonal; };
  std::size_t farthest = extents.size();
  for (std::size_t f = 0; f < extents.size(); ++f) {
    const bool has_edges = faults[f].kind == Frame_fault::NONE || faults[f].kind == Frame_fault::NO_AREA;
    if (!extents[f].is_single_precision || !has_edges) continue;
    if (farthest == extents.size() || distance_in_sizes(f) > distance_in_sizes(farthest)) farthest = f;
  }
  if (farthest == extents.size()) return;
  const double edge = frame_edges(data, farthest).mean;
  const float magnitude = float(extents[farthest].magnitude);
  const double step = double(std::nextafter(magnitude, (std::numeric_limits<float>::infinity)())) - double(magnitude);
  if (!(edge > 0) || !(step > coarse * edge)) return;
  const std::string what = data.frame_name(farthest) + ": coordinates up to " + short_number(magnitude) +
                           " in single precision are multiples of " + short_number(step) + ", " +
                           short_number(100 * step / edge) + " % of the mean edge, " + short_number(edge);
  const std::string remedy = "export the animation with its origin near the body";
  if (step > hopeless * edge) throw Input_error(what + ": what deforms is lost in rounding; " + remedy);
  data.notices.push_back(what + ": weak features are noise; " + remedy);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CHECK_PRECISION_H
