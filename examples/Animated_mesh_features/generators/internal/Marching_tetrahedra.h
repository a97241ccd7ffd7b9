// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_MARCHING_TETRAHEDRA_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_MARCHING_TETRAHEDRA_H

#include "../Generated_animation.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Animated_mesh_generators {
namespace internal {

/*!
The surface where a function of a place is zero, which is negative inside: marching tetrahedra (Doi and Koide, 1991) on the
six tetrahedra around the diagonal of each cube of a grid (Kuhn's), which fit together from cube to cube, so that the
result is a closed 2-manifold. The grid's border has to be outside. Vertices in the order of the grid.

Takes time linear in the number of the grid's points.
*/
template <class Function>
class Marching_tetrahedra
{
public:
  typedef Generated_animation::Mesh Mesh;

  /// \param size how many points the grid has along each axis; \param spacing the edge of a cube.
  Marching_tetrahedra(const Function& function, const Eigen::Vector3d& corner, const std::array<std::size_t, 3>& size,
                      double spacing)
    : m_corner(corner)
    , m_size(size)
    , m_spacing(spacing)
  {
    m_value.reserve(size[0] * size[1] * size[2]);
    for (std::size_t z = 0; z < size[2]; ++z)
      for (std::size_t y = 0; y < size[1]; ++y)
        for (std::size_t x = 0; x < size[0]; ++x) m_value.push_back(function(place({x, y, z})));
    for (std::size_t z = 0; z + 1 < size[2]; ++z)
      for (std::size_t y = 0; y + 1 < size[1]; ++y)
        for (std::size_t x = 0; x + 1 < size[0]; ++x) march_through_cube({x, y, z});
  }

  /// the surface.
  const Mesh& mesh() const { return m_mesh; }

private:
  typedef std::array<std::size_t, 3> Grid_point;

  Eigen::Vector3d place(const Grid_point& p) const
  {
    return m_corner + m_spacing * Eigen::Vector3d(double(p[0]), double(p[1]), double(p[2]));
  }

  std::size_t rank(const Grid_point& p) const { return p[0] + m_size[0] * (p[1] + m_size[1] * p[2]); }

  bool is_inside(const Grid_point& p) const { return m_value[rank(p)] < 0; }

  // A tetrahedron goes from the cube's first corner to its last one, along one axis after the other.
  void march_through_cube(const Grid_point& first)
  {
    std::array<std::size_t, 3> axes = {0, 1, 2};
    do {
      std::array<Grid_point, 4> corners;
      corners[0] = first;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i + 1] = corners[i];
        ++corners[i + 1][axes[i]];
      }
      const bool positive = (axes[1] + 3 - axes[0]) % 3 == 1;
      march_through_tetrahedron(corners, positive);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  // With the corners that are inside first, by swaps that each turn the orientation round.
  void march_through_tetrahedron(std::array<Grid_point, 4> q, bool positive)
  {
    std::size_t inside = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!is_inside(q[i])) continue;
      if (i != inside) {
        std::swap(q[i], q[inside]);
        positive = !positive;
      }
      ++inside;
    }
    if (inside == 1) add_triangle(cut(q[0], q[1]), cut(q[0], q[2]), cut(q[0], q[3]), positive);
    if (inside == 3) add_triangle(cut(q[0], q[3]), cut(q[1], q[3]), cut(q[2], q[3]), positive);
    if (inside == 2) {
      const auto a = cut(q[0], q[2]), b = cut(q[0], q[3]), c = cut(q[1], q[3]), d = cut(q[1], q[2]);
      add_triangle(a, b, c, positive);
      add_triangle(a, c, d, positive);
    }
  }

  void add_triangle(Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c, bool positive)
  {
    if (positive)
      m_mesh.add_face(a, b, c);
    else
      m_mesh.add_face(a, c, b);
  }

  // The vertex on the edge of two points of the grid.
  Mesh::Vertex_index cut(Grid_point p, Grid_point q)
  {
    if (rank(q) < rank(p)) std::swap(p, q);
    const std::size_t direction = (q[0] - p[0]) + 2 * (q[1] - p[1]) + 4 * (q[2] - p[2]);
    const auto found = m_cuts.emplace(8 * rank(p) + direction, Mesh::Vertex_index());
    if (found.second) {
      // Not at the ends, where triangles would collapse.
      const double from = m_value[rank(p)], to = m_value[rank(q)];
      const double t = (std::min)((std::max)(from / (from - to), 0.05), 0.95);
      const Eigen::Vector3d x = (1 - t) * place(p) + t * place(q);
      found.first->second = m_mesh.add_vertex(Generated_animation::Kernel::Point_3(x.x(), x.y(), x.z()));
    }
    return found.first->second;
  }

  Eigen::Vector3d m_corner;
  std::array<std::size_t, 3> m_size;
  double m_spacing;
  std::vector<double> m_value;
  std::unordered_map<std::size_t, Mesh::Vertex_index> m_cuts;
  Mesh m_mesh;
};

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_MARCHING_TETRAHEDRA_H
