// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_CACHE_FITS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_CACHE_FITS_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/internal/Point_set_index.h>
#include <CGAL/Animated_mesh_features/IO/internal/frame_position.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// How the edges of a mesh compare with those of a frame.
struct Edge_comparison
{
  std::size_t frame = 0;
  double ratio = 1;      // median of the lengths in the frame over those in the mesh
  double share_off = 0;  // of the edges whose own ratio is more than twice or less than half of that
  std::size_t edges = 0; // that have a length in both
};

template <class FT>
Edge_comparison compare_edges(const Animation_file_data<FT>& data, std::size_t f)
{
  const std::size_t most_edges = 30000; // of a larger mesh every second, third...
  const std::size_t corners = 3 * data.mesh.triangles.size(), step = corners / most_edges + 1;
  std::vector<double> logs;
  for (std::size_t c = 0; c < corners; c += step) {
    const std::array<std::size_t, 3>& t = data.mesh.triangles[c / 3];
    const std::size_t v = t[c % 3], w = t[(c + 1) % 3];
    const double in_mesh = distance(data.mesh.points[v], data.mesh.points[w]);
    const double in_frame = distance(position(data, v, f), position(data, w, f));
    if (in_mesh > 0 && in_frame > 0) logs.push_back(std::log(in_frame / in_mesh));
  }
  Edge_comparison result;
  result.frame = f;
  result.edges = logs.size();
  if (logs.empty()) return result;
  const auto middle = logs.begin() + std::ptrdiff_t(logs.size() / 2);
  std::nth_element(logs.begin(), middle, logs.end());
  const double median = *middle, off = std::log(2.);
  result.ratio = std::exp(median);
  result.share_off =
      double(std::count_if(logs.begin(), logs.end(), [&](double x) { return std::abs(x - median) > off; })) /
      double(logs.size());
  return result;
}

// The frame whose edges are most like those of the mesh, of some that are spread over the animation.
template <class FT>
Edge_comparison best_edge_comparison(const Animation_file_data<FT>& data)
{
  const std::size_t most_frames = 16, n = (std::min)(most_frames, data.frames);
  Edge_comparison best = compare_edges(data, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const Edge_comparison other = compare_edges(data, i * (data.frames - 1) / (n - 1));
    if (other.edges > 0 && (best.edges == 0 || other.share_off < best.share_off)) best = other;
  }
  return best;
}

// Whether the points of the mesh are those of a frame, but not in its order.
template <class FT>
bool is_another_order(const Animation_file_data<FT>& data, std::size_t f)
{
  std::vector<Position> points;
  for (std::size_t v = 0; v < data.mesh.points.size(); ++v) points.push_back(position(data, v, f));
  const Point_set_index index(points);
  std::size_t moved = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (distance(data.mesh.points[v], points[v]) <= index.tolerance()) continue;
    if (!index.has(data.mesh.points[v])) return false;
    ++moved;
  }
  return moved > 0;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

checks that the vertices of a mesh and those of a point cache are in the same order, by the lengths of edges in the mesh
and in up to 16 frames, of which the most similar counts. With the median ratio of lengths as unit,
- where more than a tenth of the edges are more than twice as long as in the mesh, or less than half, the vertices are in
  another order. Of animations that fit, from game characters to an elastic cow and to one person's mesh with the motion
  of another one, 2.3 % of the edges are at most; of the same ones in a wrong order, by any coordinate or at random, 18 %
  at least, if only a tenth of the vertices are exchanged 12 %;
- regular meshes are like themselves in another order, but for a few edges: it is also refused if more than 0.2 % are so
  and the points of the mesh are those of the frame in another order;
- a ratio beyond 1.25 is noted: the mesh is in another unit, which does no harm, since positions are those of the cache.

At most 30,000 edges are looked at; linear in the number of vertices.

\param cache_file its name, for messages
\param data mesh and fields as they were read; what is noted goes to its `notices`.
\throws Input_error if the order is another.
*/
template <class FT>
void check_cache_fits(const std::string& cache_file, Animation_file_data<FT>& data)
{
  const double most_off = 0.1, most_off_of_same_points = 0.002, usual_ratio = 1.25;
  const internal::Edge_comparison c = internal::best_edge_comparison(data);
  const std::size_t least_edges = 12; // of fewer, nothing can be said
  if (c.edges < least_edges) return;
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(4);
  const bool is_scattered = c.share_off > most_off;
  if (is_scattered || (c.share_off > most_off_of_same_points &&
                       (internal::is_another_order(data, c.frame) || internal::is_another_order(data, 0)))) {
    os << cache_file << ": its vertices are in another order than those of the mesh " << data.sources.front() << ": "
       << 100 * c.share_off << " % of the edges have quite another length, compared with the others, "
       << (is_scattered ? "in every frame" : "though the points are the same")
       << "; export mesh and cache from the same object";
    throw Input_error(os.str());
  }
  if (c.ratio > 1 / usual_ratio && c.ratio < usual_ratio) return;
  const bool is_smaller = c.ratio > 1;
  os << "the mesh " << data.sources.front() << " is " << (is_smaller ? c.ratio : 1 / c.ratio) << " times "
     << (is_smaller ? "smaller" : "larger") << " than the frames of " << cache_file
     << ", as in another unit; positions and lengths are those of the cache";
  data.notices.push_back(os.str());
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_CACHE_FITS_H
