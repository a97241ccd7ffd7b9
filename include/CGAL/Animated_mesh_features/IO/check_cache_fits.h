// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_CACHE_FITS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_CHECK_CACHE_FITS_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/internal/Point_set_index.h>
#include <CGAL/Animated_mesh_features/IO/internal/frame_position.h>
#include <CGAL/Animated_mesh_features/IO/internal/frame_noise.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/upper_median.h>

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
  double length = 0;     // median in the frame
  double ratio = 1;      // median of the lengths in the frame, without what noise adds, over those in the mesh
  double share_off = 0;  // of the edges that are more than twice as long as that ratio says, or less than half
  std::size_t edges = 0; // that have a length in both
};

// Noise of standard deviation s in each coordinate of both ends adds 6 s^2 to the square of an edge's length in the mean,
// and moves 99 % of the edges by less than 4.8 s (the quantile of a normal vector in space, 3.37, times sqrt 2).
template <class FT>
Edge_comparison compare_edges(const Animation_file_data<FT>& data, const std::vector<std::array<std::size_t, 2>>& edges, std::size_t f, double noise)
{
  Edge_comparison result;
  result.frame = f;
  std::vector<std::array<double, 2>> lengths; // in the mesh, in the frame
  std::vector<double> in_frame, ratios;
  for (const auto& edge : edges) {
    const double l = distance(data.mesh.points[edge[0]], data.mesh.points[edge[1]]);
    const double m = distance(position(data, edge[0], f), position(data, edge[1], f));
    if (!(l > 0) || !(m > 0)) continue;
    lengths.push_back({{l, m}});
    in_frame.push_back(m);
    ratios.push_back(std::sqrt((std::max)(0., m * m - 6 * noise * noise)) / l);
  }
  result.edges = lengths.size();
  if (lengths.empty()) return result;
  result.length = Animated_mesh_features::internal::upper_median(in_frame);
  result.ratio = Animated_mesh_features::internal::upper_median(ratios);
  const double margin = 4.8 * noise;
  const auto is_off = [&](const std::array<double, 2>& l) {
    return l[1] > 2 * result.ratio * l[0] + margin || l[1] < result.ratio * l[0] / 2 - margin;
  };
  result.share_off = double(std::count_if(lengths.begin(), lengths.end(), is_off)) / double(lengths.size());
  return result;
}

// The frame whose edges are most like those of the mesh, of some that are spread over the animation.
template <class FT>
Edge_comparison best_edge_comparison(const Animation_file_data<FT>& data, double noise)
{
  const std::vector<std::array<std::size_t, 2>> edges = some_edges(data);
  Edge_comparison best = compare_edges(data, edges, 0, noise);
  const std::size_t most_frames = 16, n = (std::min)(most_frames, data.frames);
  for (std::size_t i = 1; i < n; ++i) {
    const Edge_comparison other = compare_edges(data, edges, i * (data.frames - 1) / (n - 1), noise);
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
and in up to 16 frames, of which the most similar counts. Noise that is independent in vertices and frames,
where it is more than a tenth of the edges (see `position_noise()`), is allowed for. With the median ratio of lengths as unit,
- where more than a tenth of the edges are more than twice as long as in the mesh, or less than half, the vertices are in
  another order. Of animations that fit, from game characters to an elastic cow and to one person's mesh with the motion
  of another one, 2.3 % of the edges are at most; of the same ones in a wrong order, by any coordinate or at random, 18 %
  at least, if only a tenth of the vertices are exchanged 12 %;
- regular meshes are like themselves in another order, but for a few edges: it is also refused if more than 0.2 % are so
  and the points of the mesh are those of the frame in another order;
- a ratio beyond 1.25 is noted: the mesh is in another unit, which does no harm, since positions are those of the cache.
  Where the noise is more than a quarter of the edges, these do not tell.

At most 30,000 edges are looked at; linear in the number of vertices.

\param cache_file its name, for messages
\param data mesh and fields as they were read; what is noted goes to its `notices`.
\throws Input_error if the order is another.
*/
template <class FT>
void check_cache_fits(const std::string& cache_file, Animation_file_data<FT>& data)
{
  const double most_off = 0.1, most_off_of_same_points = 0.002, usual_ratio = 1.25;
  const double usual_noise = 0.1; // of an edge: what neighbours do not do alike is motion, too
  const double most_noise = 0.25; // of an edge whose length shall tell the unit
  const double noise = internal::frame_noise(data);
  internal::Edge_comparison c = internal::best_edge_comparison(data, 0);
  if (noise > usual_noise * c.length) c = internal::best_edge_comparison(data, noise);
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
  if ((c.ratio > 1 / usual_ratio && c.ratio < usual_ratio) || noise > most_noise * c.length) return;
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
