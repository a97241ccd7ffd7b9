// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_PATCH_SYSTEMS_H
#define CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_PATCH_SYSTEMS_H

#include "animations.h"

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Patch_factors.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Surface_patch.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Vertex_clusters.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

// The linear systems of geodesic balls, and two ways to solve them.

namespace Benchmark {

namespace Ai = Amf::internal;

// The two matrices of the heat method on a patch, M + L and L, in units of its edges.
struct Patch_system
{
  Ai::Patch_factors::Pattern pattern;
  std::vector<Ai::Patch_factors::Pair> diagonal, values;
  Amf::Compressed_rows neighbours;
  std::vector<Amf::Rest_shape::Point> points;
  std::vector<std::size_t> sources;

  Patch_system(const Ai::Surface_patch& patch, double unit)
    : diagonal(patch.number_of_vertices(), Ai::Patch_factors::Pair::Zero())
    , points(patch.points())
  {
    for (std::size_t v = 0; v < patch.number_of_vertices(); ++v) {
      std::vector<Amf::Rest_shape::Index> row;
      for (const auto& w : patch.neighbours(v)) row.push_back(w.vertex);
      std::sort(row.begin(), row.end());
      neighbours.push_back(row.begin(), row.end());
      pattern.columns.insert(pattern.columns.end(), row.begin(), row.end());
      pattern.offsets.push_back(int(pattern.columns.size()));
    }
    values.assign(pattern.columns.size(), Ai::Patch_factors::Pair::Zero());
    for (const Amf::Rest_shape::Triangle& corner : patch.triangles())
      for (std::size_t i = 0; i < 3; ++i) {
        const Amf::Rest_shape::Index v = corner[i], a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
        const Amf::Rest_shape::Point p = (points[a] - points[v]) / unit, q = (points[b] - points[v]) / unit;
        const double area = p.cross(q).norm() / 2, weight = p.dot(q) / (4 * area);
        diagonal[v][0] += area / 3;
        diagonal[a] += weight;
        diagonal[b] += weight;
        values[entry(a, b)] -= weight;
        values[entry(b, a)] -= weight;
      }
  }

  std::size_t entry(Amf::Rest_shape::Index v, Amf::Rest_shape::Index w) const
  {
    const auto first = pattern.columns.begin() + pattern.offsets[v];
    return std::size_t(std::find(first, pattern.columns.begin() + pattern.offsets[v + 1], int(w)) -
                       pattern.columns.begin());
  }
};

inline std::vector<Patch_system> patches_of_balls(const Amf::Rest_shape& shape, double radius, std::size_t number)
{
  const Amf::Heat_method_geodesic_balls balls;
  const double margin = balls.patch_margin * shape.mean_edge_length();
  const Amf::Compressed_rows clusters = Ai::Vertex_clusters(shape, balls.cluster_radius * (radius + margin)).rows();
  std::vector<Patch_system> patches;
  Ai::Bounded_dijkstra dijkstra(shape);
  Ai::Surface_patch patch(shape);
  const std::size_t step = (std::max)(std::size_t(1), clusters.size() / number);
  for (std::size_t c = 0; c < clusters.size(); c += step) {
    patch.set(dijkstra.run(clusters[c], radius + margin));
    patches.emplace_back(patch, shape.mean_edge_length());
    for (Amf::Rest_shape::Index v : clusters[c]) patches.back().sources.push_back(patch.number(v));
  }
  return patches;
}

// calls f(first source, last source) for each pack of sources.
template <class Function>
void for_each_pack(const Patch_system& p, const Function& f)
{
  for (std::size_t first = 0; first < p.sources.size(); first += Ai::Source_pack::size)
    f(first, (std::min)(first + Ai::Source_pack::size, p.sources.size()));
}

inline void solve_patch(const Ai::Patch_factors& factors, const Patch_system& p, Ai::Source_pack::Rows& x,
                        std::vector<char>& marks, std::vector<char>& all)
{
  const std::size_t n = factors.size();
  all.assign(n, 1);
  for_each_pack(p, [&](std::size_t first, std::size_t last) {
    x.assign(n, Ai::Source_pack::Array::Zero());
    marks.assign(n, 0);
    for (std::size_t s = first; s < last; ++s) {
      x[std::size_t(factors.position(p.sources[s]))][Eigen::Index(s - first)] = 1;
      marks[std::size_t(factors.position(p.sources[s]))] = 1;
    }
    factors.mark_ancestors(marks);
    factors.solve_lower(Ai::Patch_factors::HEAT, x, marks);
    factors.solve_upper(Ai::Patch_factors::HEAT, x, all);
    factors.solve_lower(Ai::Patch_factors::DISTANCE, x, all);
    factors.solve_upper(Ai::Patch_factors::DISTANCE, x, marks);
  });
}

struct Patch_choleskies
{
  std::unique_ptr<Ai::Symbolic_cholesky> symbolic;
  std::unique_ptr<Ai::Sparse_cholesky<double>> factor[2];
};

// The Laplacian is singular; a little mass makes it definite.
inline void factor_patch(const Patch_system& p, Patch_choleskies& c)
{
  c.symbolic = std::make_unique<Ai::Symbolic_cholesky>(p.neighbours, p.points);
  for (std::size_t w : {0u, 1u})
    c.factor[w] = std::make_unique<Ai::Sparse_cholesky<double>>(
        *c.symbolic, [&](std::size_t v) { return p.diagonal[v][Eigen::Index(w)] + (w == 1 ? 1e-6 : 0.); },
        [&](std::size_t v, std::size_t k) { return p.values[std::size_t(p.pattern.offsets[v]) + k][Eigen::Index(w)]; });
}

inline void solve_patch(const Patch_choleskies& c, const Patch_system& p, Ai::Right_hand_sides<double>& x)
{
  for_each_pack(p, [&](std::size_t first, std::size_t last) {
    std::fill_n(x.first_row(0), c.symbolic->size() * x.pack_size, 0.);
    for (std::size_t s = first; s < last; ++s) x(p.sources[s], s - first) = 1;
    c.factor[0]->solve(x);
    c.factor[1]->solve(x);
  });
}

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_PATCH_SYSTEMS_H
