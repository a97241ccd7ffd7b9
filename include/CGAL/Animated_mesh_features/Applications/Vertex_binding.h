// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VERTEX_BINDING_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VERTEX_BINDING_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

How the vertices of a coarse mesh follow those of a fine one: a sparse matrix of `M` rows, each of a few weights with
sum 1, so that \f$\sum_i w_{vi}\,x_i\f$ moves with every translation, rotation and affine map of the vertices
\f$x_i\f$. Weights may be negative: a vertex that lies off the fine surface is extrapolated.
*/
class Vertex_binding
{
public:
  typedef Compressed_rows::Index Index; ///< of a vertex of the fine mesh

  /// appends the row of one more vertex; weights are in the order of the vertices, their sum is 1.
  void push_back(const std::vector<Index>& vertices, const std::vector<double>& weights)
  {
    m_first.push_back(m_first.back() + vertices.size());
    m_vertices.push_back(vertices.begin(), vertices.end());
    m_weights.insert(m_weights.end(), weights.begin(), weights.end());
  }

  /// `M`
  std::size_t size() const { return m_vertices.size(); }

  /// the vertices of the fine mesh that vertex `v` follows, from 0.
  Compressed_rows::Row vertices(std::size_t v) const { return m_vertices[v]; }

  /// their weights, as many.
  boost::iterator_range<const double*> weights(std::size_t v) const
  {
    return {m_weights.data() + m_first[v], m_weights.data() + m_first[v + 1]};
  }

  /// where vertex `v` is if the vertices of the fine mesh are at `positions`: anything with `positions[i]`, a
  /// `Rest_shape::Point`; a `Frame_positions`, for instance.
  template <class Positions>
  Rest_shape::Point position(std::size_t v, const Positions& positions) const
  {
    Rest_shape::Point p(0, 0, 0);
    const Compressed_rows::Row row = vertices(v);
    for (std::size_t i = 0; i < std::size_t(row.size()); ++i) p += m_weights[m_first[v] + i] * positions[row[i]];
    return p;
  }

  /// the same for all vertices.
  template <class Positions>
  std::vector<Rest_shape::Point> positions(const Positions& fine) const
  {
    std::vector<Rest_shape::Point> all(size());
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = position(v, fine);
    return all;
  }

private:
  Compressed_rows m_vertices;
  std::vector<double> m_weights;
  std::vector<std::size_t> m_first = std::vector<std::size_t>(1, 0);
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_VERTEX_BINDING_H
