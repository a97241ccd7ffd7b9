// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_HEAT_DISTANCES_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_HEAT_DISTANCES_H

#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Patch_factors.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Surface_patch.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The heat method (Crane, Weischedel, Wardetzky 2013) on a patch, for a pack of single sources at a time.
class Heat_distances
{
public:
  typedef Rest_shape::Index Index;
  typedef Source_pack::Array Array;
  typedef Source_pack::Rows Rows;

  // Factors M + L and L, with the lumped masses M and the cotangent Laplacian L, where the unit of length is the square
  // root of the time step.
  void set(const Surface_patch& patch, double unit)
  {
    m_unit = unit;
    const std::size_t n = patch.number_of_vertices();
    m_triangles.clear();
    m_diagonal.assign(n, Patch_factors::Pair::Zero());
    find_pattern(patch);
    m_values.assign(m_pattern.columns.size(), Patch_factors::Pair::Zero());
    m_in_triangle.assign(m_pattern.columns.size(), 0);
    for (const Rest_shape::Triangle& corners : patch.triangles()) add(patch, corners);
    drop_edges_without_triangle();
    m_factors.factorize(m_pattern, m_diagonal, m_values);
    for (Triangle& t : m_triangles)
      for (int& v : t.corners) v = m_factors.position(v);
    m_all.assign(n, 1);
    m_heat.resize(n);
    m_distance.resize(n);
  }

  // Distances from each of the sources, an entry of the pack each, to the vertices in `wanted`.
  void run(const std::vector<Index>& sources, const std::vector<Index>& wanted)
  {
    const std::size_t n = m_factors.size();
    m_heat.assign(n, Array::Zero());
    m_distance.assign(n, Array::Zero());
    m_marks.assign(n, 0);
    for (std::size_t l = 0; l < sources.size(); ++l) {
      const int s = m_factors.position(sources[l]);
      m_heat[s][l] = 1;
      m_marks[s] = 1;
    }
    m_factors.mark_ancestors(m_marks);
    m_factors.solve_lower(Patch_factors::HEAT, m_heat, m_marks);
    m_factors.solve_upper(Patch_factors::HEAT, m_heat, m_all);
    // Obtuse triangles may turn little heat into less than none; as CGAL's, its absolute value proves the better guide.
    for (Array& u : m_heat) u = u.abs();
    add_divergences();
    m_factors.solve_lower(Patch_factors::DISTANCE, m_distance, m_all);
    for (Index v : wanted) m_marks[m_factors.position(v)] = 1;
    m_factors.mark_ancestors(m_marks);
    m_factors.solve_upper(Patch_factors::DISTANCE, m_distance, m_marks);
    m_at_source.setZero();
    m_component.fill(m_factors.component(m_factors.position(sources[0])));
    m_is_one_component = true;
    for (std::size_t l = 0; l < sources.size(); ++l) {
      const int s = m_factors.position(sources[l]);
      m_at_source[l] = m_distance[s][l];
      m_component[l] = m_factors.component(s);
      m_is_one_component = m_is_one_component && m_component[l] == m_component[0];
    }
  }

  // To a wanted vertex. Infinite where no triangles lead.
  Array distance(Index v) const
  {
    const int p = m_factors.position(v);
    Array d = (m_distance[p] - m_at_source) * m_unit;
    if (m_is_one_component && m_component[0] == m_factors.component(p)) return d;
    for (std::size_t l = 0; l < Source_pack::size; ++l)
      if (m_component[l] != m_factors.component(p)) d[l] = std::numeric_limits<double>::infinity();
    return d;
  }

  std::size_t number_of_entries() const { return m_factors.number_of_entries(); }

private:
  // In the plane of the triangle with its first two corners, which its longest edge joins, on the x axis: the gradients
  // of the hat functions of corners 1 and 2 are (a, -c) and (0, b); those times the area give the divergence.
  struct Triangle
  {
    int corners[3];
    double a, b, c;
    double area;
  };

  void find_pattern(const Surface_patch& patch)
  {
    m_pattern.offsets.assign(1, 0);
    m_pattern.columns.clear();
    for (std::size_t v = 0; v < patch.number_of_vertices(); ++v) {
      for (const Surface_patch::Neighbour& w : patch.neighbours(v)) m_pattern.columns.push_back(int(w.vertex));
      m_pattern.offsets.push_back(int(m_pattern.columns.size()));
    }
  }

  void add(const Surface_patch& patch, const Rest_shape::Triangle& corners)
  {
    const auto& points = patch.points();
    int first = 0;
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
      const double l = (points[corners[i]] - points[corners[(i + 1) % 3]]).squaredNorm();
      if (l > longest) {
        longest = l;
        first = i;
      }
    }
    Triangle t;
    for (int i = 0; i < 3; ++i) t.corners[i] = int(corners[(first + i) % 3]);
    const Rest_shape::Point base = (points[t.corners[1]] - points[t.corners[0]]) / m_unit,
                            side = (points[t.corners[2]] - points[t.corners[0]]) / m_unit;
    const double length = base.norm(), height = base.cross(side).norm() / length, foot = base.dot(side) / length;
    t.a = 1 / length;
    t.b = 1 / height;
    t.c = foot / length / height;
    t.area = length * height / 2;
    m_triangles.push_back(t);
    const double l12 = -t.area * t.b * t.c, l22 = t.area * t.b * t.b, l11 = t.area * (t.a * t.a + t.c * t.c);
    add(t.corners[1], t.corners[2], l12);
    add(t.corners[0], t.corners[1], -(l11 + l12));
    add(t.corners[0], t.corners[2], -(l12 + l22));
    for (int v : t.corners) m_diagonal[v][0] += t.area / 3;
  }

  // An entry of the Laplacian beside its diagonal, which makes the sum of the row vanish.
  void add(int v, int w, double l)
  {
    const std::size_t vw = entry(v, w), wv = entry(w, v);
    m_values[vw] += l;
    m_values[wv] += l;
    m_in_triangle[vw] = m_in_triangle[wv] = 1;
    m_diagonal[v] -= l;
    m_diagonal[w] -= l;
  }

  std::size_t entry(int v, int w) const
  {
    int p = m_pattern.offsets[v];
    while (m_pattern.columns[p] != w) ++p;
    return std::size_t(p);
  }

  // They would hide which vertices no heat can reach.
  void drop_edges_without_triangle()
  {
    int kept = 0, p = 0;
    for (std::size_t v = 0; v < m_pattern.size(); ++v) {
      for (; p < m_pattern.offsets[v + 1]; ++p)
        if (m_in_triangle[p]) {
          m_pattern.columns[kept] = m_pattern.columns[p];
          m_values[kept++] = m_values[p];
        }
      m_pattern.offsets[v + 1] = kept;
    }
    m_pattern.columns.resize(kept);
    m_values.resize(kept);
  }

  // The divergence of the field of unit vectors against the gradient of the heat.
  void add_divergences()
  {
    // where there is no gradient, there is no direction
    const double least = (std::numeric_limits<double>::min)();
    for (const Triangle& t : m_triangles) {
      const Array u0 = m_heat[t.corners[0]], u1 = m_heat[t.corners[1]] - u0, u2 = m_heat[t.corners[2]] - u0;
      const Array x = u1 * t.a, y = u2 * t.b - u1 * t.c;
      const Array scale = t.area / (x * x + y * y).max(least).sqrt();
      const Array sx = x * scale, sy = y * scale;
      const Array d1 = sy * t.c - sx * t.a, d2 = sy * -t.b;
      m_distance[t.corners[1]] += d1;
      m_distance[t.corners[2]] += d2;
      m_distance[t.corners[0]] -= d1 + d2;
    }
  }

  Patch_factors m_factors;
  Patch_factors::Pattern m_pattern;
  std::vector<Patch_factors::Pair> m_diagonal, m_values;
  std::vector<char> m_in_triangle; // for each entry of the pattern
  std::vector<Triangle> m_triangles;
  double m_unit = 1;
  Rows m_heat, m_distance; // in the order of the factor
  Array m_at_source;
  std::array<int, Source_pack::size> m_component; // of the sources
  bool m_is_one_component = true;
  std::vector<char> m_marks, m_all;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_HEAT_DISTANCES_H
