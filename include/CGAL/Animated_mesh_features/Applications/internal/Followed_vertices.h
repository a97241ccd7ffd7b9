// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FOLLOWED_VERTICES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FOLLOWED_VERTICES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The vertices of the original that a vertex follows, and their weights.
struct Followed_vertices
{
  typedef Rest_shape::Index Index;

  std::vector<Index> vertices;
  std::vector<double> weights;

  std::size_t size() const { return vertices.size(); }

  void clear()
  {
    vertices.clear();
    weights.clear();
  }

  void add(Index v, double weight)
  {
    for (std::size_t k = 0; k < vertices.size(); ++k)
      if (vertices[k] == v) {
        weights[k] += weight;
        return;
      }
    vertices.push_back(v);
    weights.push_back(weight);
  }

  void add(const Followed_vertices& other, double factor)
  {
    for (std::size_t k = 0; k < other.size(); ++k) add(other.vertices[k], factor * other.weights[k]);
  }

  // rank among them; the first of several
  std::size_t heaviest() const
  {
    return std::size_t(std::max_element(weights.begin(), weights.end()) - weights.begin());
  }

  void bring_heaviest_first()
  {
    const std::size_t k = heaviest();
    std::swap(vertices[0], vertices[k]);
    std::swap(weights[0], weights[k]);
  }

  // Only the `most` largest weights; what is left out is added to the largest of all.
  void keep_largest(std::size_t most)
  {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(weights[a]) > std::abs(weights[b]); });
    order.resize((std::min)(most, order.size()));
    Followed_vertices kept;
    double sum = 0;
    for (std::size_t k : order) {
      kept.vertices.push_back(vertices[k]);
      kept.weights.push_back(weights[k]);
      sum += weights[k];
    }
    kept.weights[0] += 1 - sum;
    *this = std::move(kept);
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_FOLLOWED_VERTICES_H
