// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_COLLAPSES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_COLLAPSES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Applications/Vertex_binding.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_quadrics.h>
#include <CGAL/Animated_mesh_features/Applications/internal/solve_definite.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What collapses of edges need to know of an animation, whatever collapses them: for each vertex that is left its
// quadrics, the vertices of the original that it follows, and where it is in every frame. Vertices are ranks in the
// original.
class Pose_collapses
{
public:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;

  struct Settings
  {
    double line_weight, border_weight; // of the area at a vertex; of the squared length of an edge
    double least_cosine;               // between the normals of a triangle before and after
    std::size_t support;               // the most vertices that one follows
  };

  // A vertex in place of two others.
  struct Collapse
  {
    std::vector<Index> vertices; // that it follows
    std::vector<double> weights;
    std::vector<float> rows[3];    // where it is, in all columns
    std::vector<float> normals[3]; // of the original around it, as long as areas
  };

  // `weight(v, pose)`: how much the surface around a vertex matters in a pose. `is_fixed`: `N` vertices that stay.
  template <class FT, class Weight, class Loop>
  Pose_collapses(const Rest_shape& rest, const Vertex_trajectories<FT>& trajectories,
                 const std::vector<std::size_t>& columns, std::size_t poses, const std::vector<char>& is_fixed,
                 const Settings& settings, const Weight& weight, const Loop& loop)
    : m_settings(settings)
    , m_unit(rest.diameter() > 0 ? rest.diameter() : 1)
    , m_original(rest, trajectories, columns, m_unit)
    , m_current(m_original)
    , m_normals(m_original)
    , m_quadrics(rest.number_of_vertices(), poses)
    , m_is_fixed(is_fixed)
    , m_stamps(rest.number_of_vertices(), 0)
    , m_vertices(rest.number_of_vertices())
    , m_weights(rest.number_of_vertices(), std::vector<double>(1, 1.))
    , m_merged_into(rest.number_of_vertices())
  {
    std::iota(m_merged_into.begin(), m_merged_into.end(), Index(0));
    for (std::size_t v = 0; v < m_vertices.size(); ++v) m_vertices[v].assign(1, Index(v));
    loop(m_vertices.size(), [&](std::size_t v) {
      set_quadrics(rest, v, weight);
      set_normals(rest, v);
    });
  }

  bool is_fixed(std::size_t v) const { return m_is_fixed[v] != 0; }

  // changes whenever the quadric or the place of the vertex does, and never takes a value that any vertex had before.
  std::uint32_t stamp(std::size_t v) const { return m_stamps[v]; }

  // Of the edge; an end that is fixed is where the new vertex would be.
  double cost(std::size_t i, std::size_t j) const
  {
    if (!is_fixed(i) && !is_fixed(j)) return m_quadrics.cost(i, j, m_current);
    double sum = 0;
    const std::size_t end = is_fixed(i) ? i : j;
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p) {
      const Matrix a = quadric(i, j, p);
      const std::array<double, 3> x = m_current.point(end, p), g = gradient(a, x);
      double value = a[9];
      for (int k = 0; k < 3; ++k) value += x[k] * (g[k] + a[6 + k]);
      sum += (std::max)(0., value);
    }
    return sum;
  }

  // The place of the vertex in place of i and j: the weights of vertices that these and their neighbours follow for
  // which the quadrics, summed over poses, are least. `link`: the neighbours of both.
  void place(std::size_t i, std::size_t j, const std::vector<Index>& link, Collapse& c)
  {
    c.vertices.clear();
    c.weights.clear();
    if (is_fixed(i) || is_fixed(j)) {
      const std::size_t end = is_fixed(i) ? i : j;
      c.vertices = m_vertices[end];
      c.weights = m_weights[end];
    } else {
      const double t = place_on_edge(i, j);
      follow(i, 1 - t, c);
      follow(j, t, c);
      for (Index v : link) add(dominant(v), 0., c);
      improve(i, j, c);
      if (c.vertices.size() > m_settings.support) {
        keep_largest(c);
        improve(i, j, c);
      }
    }
    const std::size_t columns = m_original.number_of_columns();
    for (int axis = 0; axis < 3; ++axis) {
      m_sum.assign(columns, 0.);
      for (std::size_t k = 0; k < c.vertices.size(); ++k) {
        const float* const row = m_original.row(c.vertices[k], axis);
        for (std::size_t f = 0; f < columns; ++f) m_sum[f] += c.weights[k] * double(row[f]);
      }
      c.rows[axis].assign(m_sum.begin(), m_sum.end());
      const float *const n = m_normals.row(i, axis), *const m = m_normals.row(j, axis);
      c.normals[axis].resize(columns);
      for (std::size_t f = 0; f < columns; ++f) c.normals[axis][f] = n[f] + m[f];
    }
  }

  // Whether the triangle turns over, or shrinks to nothing, in any column, when its first vertex moves: by its own
  // normal, and by that of the original around its corners, so that it does not turn little by little. Where it is
  // degenerate already, there is nothing to turn over.
  bool flips(std::size_t moved, std::size_t b, std::size_t d, const Collapse& c) const
  {
    const float *const ax = m_current.row(moved, 0), *const ay = m_current.row(moved, 1),
                       *const az = m_current.row(moved, 2);
    const float *const bx = m_current.row(b, 0), *const by = m_current.row(b, 1), *const bz = m_current.row(b, 2);
    const float *const dx = m_current.row(d, 0), *const dy = m_current.row(d, 1), *const dz = m_current.row(d, 2);
    const float *const nx = c.rows[0].data(), *const ny = c.rows[1].data(), *const nz = c.rows[2].data();
    const float *const px = c.normals[0].data(), *const py = c.normals[1].data(), *const pz = c.normals[2].data();
    const float *const qx = m_normals.row(b, 0), *const qy = m_normals.row(b, 1), *const qz = m_normals.row(b, 2);
    const float *const rx = m_normals.row(d, 0), *const ry = m_normals.row(d, 1), *const rz = m_normals.row(d, 2);
    const float least = float(m_settings.least_cosine);
    const std::size_t columns = m_current.number_of_columns();
    int bad = 0;
    for (std::size_t f = 0; f < columns; ++f) {
      const float ex = dx[f] - bx[f], ey = dy[f] - by[f], ez = dz[f] - bz[f];
      const float ux = ax[f] - bx[f], uy = ay[f] - by[f], uz = az[f] - bz[f];
      const float vx = nx[f] - bx[f], vy = ny[f] - by[f], vz = nz[f] - bz[f];
      const float ox = ey * uz - ez * uy, oy = ez * ux - ex * uz, oz = ex * uy - ey * ux;
      const float wx = ey * vz - ez * vy, wy = ez * vx - ex * vz, wz = ex * vy - ey * vx;
      const float dot = ox * wx + oy * wy + oz * wz;
      const float old_area = ox * ox + oy * oy + oz * oz, area = wx * wx + wy * wy + wz * wz;
      const float side = ex * ex + ey * ey + ez * ez;
      const float sx = px[f] + qx[f] + rx[f], sy = py[f] + qy[f] + ry[f], sz = pz[f] + qz[f] + rz[f];
      const int against = int(sx * wx + sy * wy + sz * wz < 0) & int(sx * ox + sy * oy + sz * oz >= 0);
      const int was_flat = int(old_area <= 1e-12f * side * side);
      const int turns = int(dot <= 0) | int(dot < least * (std::sqrt(old_area) * std::sqrt(area))) |
                        int(area <= 1e-10f * side * side) | against;
      bad |= turns & (1 - was_flat);
    }
    return bad != 0;
  }

  // where the new vertex is at rest, relative to the mean of all vertices
  std::array<double, 3> rest_point(const Collapse& c) const
  {
    return {{m_unit * double(c.rows[0].back()), m_unit * double(c.rows[1].back()), m_unit * double(c.rows[2].back())}};
  }
  std::array<double, 3> rest_point(std::size_t v) const
  {
    const std::array<double, 3> p = m_current.point(v, m_current.number_of_columns() - 1);
    return {{m_unit * p[0], m_unit * p[1], m_unit * p[2]}};
  }

  // The vertex `kept` takes the place of both.
  void commit(std::size_t kept, std::size_t removed, const Collapse& c)
  {
    m_quadrics.add(kept, removed);
    m_vertices[kept] = c.vertices;
    m_weights[kept] = c.weights;
    std::vector<Index>().swap(m_vertices[removed]);
    std::vector<double>().swap(m_weights[removed]);
    for (int axis = 0; axis < 3; ++axis) {
      std::copy(c.rows[axis].begin(), c.rows[axis].end(), m_current.row(kept, axis));
      std::copy(c.normals[axis].begin(), c.normals[axis].end(), m_normals.row(kept, axis));
    }
    if (is_fixed(removed)) m_is_fixed[kept] = 1;
    m_merged_into[removed] = Index(kept);
    m_stamps[kept] = ++m_stamp;
  }

  const std::vector<Index>& vertices(std::size_t v) const { return m_vertices[v]; }
  const std::vector<double>& weights(std::size_t v) const { return m_weights[v]; }

  // the vertex that is left in place of each of the original
  std::vector<Index> survivors() const
  {
    std::vector<Index> all(m_merged_into);
    for (std::size_t v = 0; v < all.size(); ++v) {
      Index u = Index(v);
      while (all[u] != u) u = all[u] = all[all[u]];
      all[v] = u;
    }
    return all;
  }

private:
  typedef std::array<double, Pose_quadrics::size> Matrix;

  template <class Weight>
  void set_quadrics(const Rest_shape& rest, std::size_t v, const Weight& weight)
  {
    const auto point = [&](Index u, std::size_t p) {
      const std::array<double, 3> x = m_original.point(u, p);
      return Point(x[0], x[1], x[2]);
    };
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p) {
      const double w = weight(v, p);
      Point normal(0, 0, 0);
      double area = 0;
      for (Index t : rest.incident_triangles()[v]) {
        const Rest_shape::Triangle& triangle = rest.triangles()[t];
        const Point a = point(triangle[0], p);
        const Point n = (point(triangle[1], p) - a).cross(point(triangle[2], p) - a);
        const double length = n.norm();
        if (!(length > 0)) continue;
        m_quadrics.add_plane(v, p, n / length, a, w * length / 6); // a third of its area
        normal += n;
        area += length / 6;
      }
      const double length = normal.norm();
      if (length > 0) m_quadrics.add_line(v, p, normal / length, point(Index(v), p), w * m_settings.line_weight * area);
      if (rest.is_border(v)) add_border(rest, v, p, w, point);
    }
  }

  void set_normals(const Rest_shape& rest, std::size_t v)
  {
    for (std::size_t f = 0; f < m_normals.number_of_columns(); ++f) {
      Point sum(0, 0, 0);
      for (Index t : rest.incident_triangles()[v]) {
        const Rest_shape::Triangle& triangle = rest.triangles()[t];
        Point p[3];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::array<double, 3> x = m_original.point(triangle[k], f);
          p[k] = Point(x[0], x[1], x[2]);
        }
        sum += (p[1] - p[0]).cross(p[2] - p[0]);
      }
      for (int axis = 0; axis < 3; ++axis) m_normals.row(v, axis)[f] = float(sum[axis]);
    }
  }

  // the plane through a border edge that stands on its triangle
  template <class Point_of>
  void add_border(const Rest_shape& rest, std::size_t v, std::size_t p, double weight, const Point_of& point)
  {
    for (Index e : rest.incident_edges()[v]) {
      const Rest_shape::Edge& edge = rest.edges()[e];
      if (!edge.is_border()) continue;
      const Point a = point(edge.source, p), along = point(edge.target, p) - a;
      const Index third = edge.left == Rest_shape::none ? edge.right : edge.left;
      const Point n = along.cross(along.cross(point(third, p) - a));
      const double length = n.norm();
      if (length > 0)
        m_quadrics.add_plane(v, p, n / length, a, weight * m_settings.border_weight * along.squaredNorm() / 2);
    }
  }

  Matrix quadric(std::size_t i, std::size_t j, std::size_t p) const
  {
    const std::size_t n = m_quadrics.number_of_poses();
    const double *const q = m_quadrics.of(i) + p, *const r = m_quadrics.of(j) + p;
    Matrix a;
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = q[k * n] + r[k * n];
    return a;
  }

  static std::array<double, 3> times(const Matrix& a, const std::array<double, 3>& x)
  {
    return {{a[0] * x[0] + a[1] * x[1] + a[2] * x[2], a[1] * x[0] + a[3] * x[1] + a[4] * x[2],
             a[2] * x[0] + a[4] * x[1] + a[5] * x[2]}};
  }

  // half of the gradient
  static std::array<double, 3> gradient(const Matrix& a, const std::array<double, 3>& x)
  {
    std::array<double, 3> g = times(a, x);
    for (int k = 0; k < 3; ++k) g[k] += a[6 + k];
    return g;
  }

  // the best place on the edge in all poses together, from 0 to 1
  double place_on_edge(std::size_t i, std::size_t j) const
  {
    double square = 0, linear = 0;
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p) {
      Matrix a = quadric(i, j, p);
      const std::array<double, 3> x = m_current.point(i, p), y = m_current.point(j, p);
      const std::array<double, 3> d = {{y[0] - x[0], y[1] - x[1], y[2] - x[2]}};
      const std::array<double, 3> m = {{(y[0] + x[0]) / 2, (y[1] + x[1]) / 2, (y[2] + x[2]) / 2}};
      const double small = Pose_quadrics::regularisation * (a[0] + a[3] + a[5]);
      const std::array<double, 3> ad = times(a, d), g = gradient(a, m);
      for (int k = 0; k < 3; ++k) {
        square += d[k] * (ad[k] + small * d[k]);
        linear += d[k] * g[k];
      }
    }
    return square > 0 ? (std::min)(1., (std::max)(0., .5 - linear / square)) : .5;
  }

  // the vertex that it follows most
  Index dominant(std::size_t v) const
  {
    const std::vector<double>& w = m_weights[v];
    return m_vertices[v][std::size_t(std::max_element(w.begin(), w.end()) - w.begin())];
  }

  static void add(Index v, double weight, Collapse& c)
  {
    for (std::size_t k = 0; k < c.vertices.size(); ++k)
      if (c.vertices[k] == v) {
        c.weights[k] += weight;
        return;
      }
    c.vertices.push_back(v);
    c.weights.push_back(weight);
  }

  void follow(std::size_t v, double weight, Collapse& c) const
  {
    for (std::size_t k = 0; k < m_vertices[v].size(); ++k) add(m_vertices[v][k], weight * m_weights[v][k], c);
  }

  // Only the largest weights; what is left out is added to the largest of all.
  void keep_largest(Collapse& c)
  {
    m_order.resize(c.vertices.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(c.weights[a]) > std::abs(c.weights[b]); });
    m_order.resize(m_settings.support);
    std::vector<Index> vertices;
    std::vector<double> weights;
    double sum = 0;
    for (std::size_t k : m_order) {
      vertices.push_back(c.vertices[k]);
      weights.push_back(c.weights[k]);
      sum += c.weights[k];
    }
    weights[0] += 1 - sum;
    c.vertices.swap(vertices);
    c.weights.swap(weights);
  }

  // Changes the weights, whose sum stays 1, so that the quadrics are least, in the sense of least squares: each step
  // u_k from the heaviest vertex to another one costs a little, and so does each step of the place, so that what does
  // not matter stays.
  void improve(std::size_t i, std::size_t j, Collapse& c)
  {
    const std::size_t n = c.vertices.size() - 1;
    if (n == 0) return;
    const auto heaviest = std::max_element(c.weights.begin(), c.weights.end()) - c.weights.begin();
    std::swap(c.vertices[0], c.vertices[std::size_t(heaviest)]);
    std::swap(c.weights[0], c.weights[std::size_t(heaviest)]);
    m_matrix.assign(n * n, 0.);
    m_right.assign(n, 0.);
    m_steps.resize(6 * n);
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p) {
      Matrix a = quadric(i, j, p);
      const std::array<double, 3> reference = m_original.point(c.vertices[0], p);
      std::array<double, 3> x = reference;
      for (std::size_t k = 0; k < n; ++k) {
        const std::array<double, 3> y = m_original.point(c.vertices[k + 1], p);
        for (int axis = 0; axis < 3; ++axis) {
          m_steps[6 * k + std::size_t(axis)] = y[axis] - reference[axis];
          x[axis] += c.weights[k + 1] * (y[axis] - reference[axis]);
        }
      }
      const std::array<double, 3> g = gradient(a, x);
      const double small = Pose_quadrics::regularisation * (a[0] + a[3] + a[5]);
      a[0] += small;
      a[3] += small;
      a[5] += small;
      for (std::size_t k = 0; k < n; ++k) {
        double* const e = m_steps.data() + 6 * k;
        const std::array<double, 3> ae = times(a, {{e[0], e[1], e[2]}});
        std::copy(ae.begin(), ae.end(), e + 3);
        m_right[k] -= e[0] * g[0] + e[1] * g[1] + e[2] * g[2];
        for (std::size_t l = 0; l <= k; ++l) {
          const double* const f = m_steps.data() + 6 * l;
          m_matrix[k * n + l] += ae[0] * f[0] + ae[1] * f[1] + ae[2] * f[2];
        }
      }
    }
    double trace = 0;
    for (std::size_t k = 0; k < n; ++k) trace += m_matrix[k * n + k];
    const double ridge = weight_ridge * trace / double(n);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l <= k; ++l) m_matrix[k * n + l] += k == l ? 2 * ridge : ridge;
    if (!solve_definite(m_matrix, m_right, n)) return;
    for (std::size_t k = 0; k < n; ++k) {
      c.weights[k + 1] += m_right[k];
      c.weights[0] -= m_right[k];
    }
  }

  static constexpr double weight_ridge = 1e-4; // of the mean diagonal

  Settings m_settings;
  double m_unit; // of all that follows
  Pose_positions m_original, m_current;
  Pose_positions m_normals; // of the original around what each vertex has taken the place of, as long as areas
  Pose_quadrics m_quadrics;
  std::vector<char> m_is_fixed;
  std::vector<std::uint32_t> m_stamps;
  std::uint32_t m_stamp = 0;
  std::vector<std::vector<Index>> m_vertices;
  std::vector<std::vector<double>> m_weights;
  std::vector<Index> m_merged_into;
  std::vector<double> m_matrix, m_right, m_steps, m_sum; // of one collapse
  std::vector<std::size_t> m_order;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_COLLAPSES_H
