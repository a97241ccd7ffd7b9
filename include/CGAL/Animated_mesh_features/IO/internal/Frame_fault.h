// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_FAULT_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_FAULT_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_edges.h>
#include <CGAL/Animated_mesh_features/IO/internal/Frame_extents.h>
#include <CGAL/Animated_mesh_features/IO/internal/short_number.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

inline std::string vertex_name(const Vertex_origins& origins, std::size_t v)
{
  return "vertex " + std::to_string(origins.empty() ? v : origins.file_vertices[origins.first[v]]);
}

// The frame that others are measured by: with a quarter of them, a body is not larger. Those without extent do not count.
inline std::size_t usual_frame(const std::vector<Frame_extent>& extents)
{
  std::vector<std::size_t> frames;
  for (std::size_t f = 0; f < extents.size(); ++f)
    if (extents[f].is_extended()) frames.push_back(f);
  if (frames.empty()) return extents.size();
  const auto quarter = frames.begin() + std::ptrdiff_t((frames.size() - 1) / 4);
  std::nth_element(frames.begin(), quarter, frames.end(), [&](std::size_t f, std::size_t g) {
    return extents[f].diagonal != extents[g].diagonal ? extents[f].diagonal < extents[g].diagonal : f < g;
  });
  return *quarter;
}

// What is wrong with a frame for certain.
struct Frame_fault
{
  enum Kind
  {
    NONE,
    NO_EXTENT,
    NO_AREA,
    EXPLODED
  };
  Kind kind = NONE;
  std::string what; // in words

  // nothing is there that could be missed
  bool holds_nothing() const { return kind == NO_EXTENT || kind == NO_AREA; }
};

template <class FT>
Frame_fault frame_fault(const Animation_file_data<FT>& data, const std::vector<Frame_extent>& extents, std::size_t f,
                        std::size_t usual, const Frame_edges& usual_edges)
{
  const double no_extent = 1e-9, exploded = 10, torn = 1e8; // over the usual extent
  const double size = extents[f].diagonal, usual_size = extents[usual].diagonal;
  if (!extents[f].is_extended() || !(size > no_extent * usual_size))
    return {Frame_fault::NO_EXTENT, "has no extent: all vertices are at one point"};
  if (has_no_area(data, f)) return {Frame_fault::NO_AREA, "has no surface: all triangles are collapsed"};
  if (!(size > exploded * usual_size)) return Frame_fault();
  // A body that grows as a whole has longer edges everywhere, one that flies away has the same ones.
  const Frame_edges edges = frame_edges(data, f);
  const double growth = usual_edges.median > 0 ? (std::max)(1., edges.median / usual_edges.median) : 1;
  if (!(edges.longest > exploded * usual_size * growth) && !(size > torn * usual_size)) return Frame_fault();
  const Position middle = middle_of_frame(data, f);
  std::array<std::size_t, 2> ends = edges.ends_of_longest;
  if (distance(position(data, ends[0], f), middle) < distance(position(data, ends[1], f), middle))
    std::swap(ends[0], ends[1]);
  return {Frame_fault::EXPLODED,
          vertex_name(data.origins, ends[0]) + " is " + short_number(distance(position(data, ends[0], f), middle)) +
              " away from the middle of the others; other frames are " + short_number(usual_size) + " large in all"};
}

template <class ConcurrencyTag, class FT>
std::vector<Frame_fault> frame_faults(const Animation_file_data<FT>& data, const std::vector<Frame_extent>& extents,
                                      std::size_t usual)
{
  const Frame_edges usual_edges = frame_edges(data, usual);
  std::vector<Frame_fault> faults(data.frames);
  parallel_for<ConcurrencyTag>(0, data.frames,
                               [&](std::size_t f) { faults[f] = frame_fault(data, extents, f, usual, usual_edges); });
  return faults;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_FAULT_H
