// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_REST_SHAPE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_REST_SHAPE_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/internal/rows_of_vertices.h>
#include <CGAL/Animated_mesh_features/Animation/internal/surface_size.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// Within `Rest_shape`, whose own edges() hides the graph's, and without a namespace, as that of the graph may be
// another.
template <class TriangleMesh>
auto edges_of(const TriangleMesh& mesh)
{
  return edges(mesh);
}

// Not degree(), which Seam_mesh does not have for faces.
template <class Halfedge, class TriangleMesh>
std::size_t number_of_sides(const Halfedge& h, const TriangleMesh& mesh)
{
  std::size_t n = 1;
  for (Halfedge g = next(h, mesh); g != h; g = next(g, mesh)) ++n;
  return n;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

The undeformed surface in the form in which the policies (geodesic balls, spatial filters) see it: triangles, edges
and neighbours by index, points in double precision. Vertex `i` is the `i`-th element of `vertices(mesh)`, triangle
`i` the `i`-th element of `faces(mesh)`.

Triangles start at their smallest vertex, edges and neighbours are sorted: whatever the model of `FaceGraph` from which
the shape was built, sums run in the same order and give the same bits.
*/
class Rest_shape
{
public:
  typedef Compressed_rows::Index Index;  ///< of a vertex, edge or triangle, from 0
  typedef std::array<Index, 3> Triangle; ///< its vertices, counterclockwise, the smallest first
  typedef Eigen::Vector3d Point;         ///< a position

  /// stands for the missing triangle at a border edge.
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  /// An edge with `source < target`; `left` is the third vertex of the triangle that runs from `source` to `target`,
  /// `right` that of the other triangle.
  struct Edge
  {
    Index source; ///< the smaller end
    Index target; ///< the greater end
    Index left;   ///< the third vertex on one side, or `none`
    Index right;  ///< the third vertex on the other side, or `none`

    /// whether a triangle is missing on a side.
    bool is_border() const { return left == none || right == none; }
  };

  /// no vertices.
  Rest_shape() = default;

  /// takes over the connectivity of `mesh`; all points are at the origin until `set_points()` is called.
  /// \tparam VertexIndexMap readable, vertex descriptor to rank in `vertices(mesh)`.
  /// \param mesh the connectivity; is not kept.
  /// \param index the rank of each vertex.
  /// \param number_of_vertices the number of elements of `vertices(mesh)`.
  /// \throw Input_error if a face is no triangle, or if there are no faces, or more than 2^32 - 2 vertices.
  template <class TriangleMesh, class VertexIndexMap>
  Rest_shape(const TriangleMesh& mesh, VertexIndexMap index, std::size_t number_of_vertices)
  {
    if (number_of_vertices >= none) throw Input_error("the mesh has more than 2^32 - 2 vertices");
    m_points.assign(number_of_vertices, Point::Zero());
    read_triangles(mesh, index);
    read_edges(mesh, index);
    connect();
  }

  /// \name Connectivity
  /// @{

  /// `N`.
  std::size_t number_of_vertices() const { return m_points.size(); }

  /// the triangles, in the order of `faces(mesh)`.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  /// the indices of all triangles in an order that depends on the indices of their vertices only. A sum over triangles
  /// that runs in this order gives the same bits, whatever the order of `faces(mesh)`.
  const std::vector<Index>& ordered_triangles() const { return m_ordered_triangles; }

  /// the edges that a triangle uses, by source, then by target.
  const std::vector<Edge>& edges() const { return m_edges; }

  /// the vertices that share an edge with each vertex, ascending.
  const Compressed_rows& neighbours() const { return m_neighbours; }

  /// the triangles around each vertex, in an order that depends on the indices of their vertices only.
  const Compressed_rows& incident_triangles() const { return m_incident_triangles; }

  /// the edges at each vertex, in the order of `neighbours()`.
  const Compressed_rows& incident_edges() const { return m_incident_edges; }

  /// whether vertex `v` is an end of a border edge.
  bool is_border(std::size_t v) const { return m_is_border[v] != 0; }

  /// whether vertex `v` belongs to no triangle.
  bool is_isolated(std::size_t v) const { return m_incident_triangles[v].size() == 0; }
  /// @}

  /// \name Geometry
  /// @{

  /// the position of each vertex.
  const std::vector<Point>& points() const { return m_points; }

  /// the area of each triangle (squared length).
  const std::vector<double>& areas() const { return m_areas; }

  /// the length of each edge.
  const std::vector<double>& lengths() const { return m_lengths; }

  /// the vertices by which the shape's size is measured: all that belong to triangles, or those of them that
  /// `set_measured_vertices()` was told, ascending. A vertex that belongs to no triangle has no size.
  const std::vector<Index>& measured_vertices() const { return m_measured; }

  /// the mean of the lengths of the edges of measured vertices.
  double mean_edge_length() const { return m_size.mean_edge_length; }

  /// the diagonal of the axis-parallel bounding box of all measured vertices (length).
  double bounding_box_diagonal() const { return m_size.diagonal; }

  /// the diameter of the smallest sphere around all measured vertices: the size of the shape that default lengths are
  /// fractions of. Other than the diagonal of the axis-parallel bounding box, which it equals for a box and else is 85
  /// to 95 % of, it does not change when the shape is turned.
  double diameter() const { return m_size.diameter; }

  /// moves the vertices, `N` points, and measures the shape anew. Linear time.
  void set_points(std::vector<Point> points)
  {
    m_points = std::move(points);
    measure();
  }

  /// measures the shape's size by these vertices, ascending, not isolated, without repetitions, at least one, from now
  /// on: the parts of a scene that matter. Linear time.
  void set_measured_vertices(std::vector<Index> vertices)
  {
    m_measured = std::move(vertices);
    measure();
  }
  /// @}

private:
  template <class TriangleMesh, class VertexIndexMap>
  void read_triangles(const TriangleMesh& mesh, VertexIndexMap index)
  {
    m_triangles.reserve(2 * number_of_vertices()); // as many as a closed surface has, but for a few
    for (auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      const std::size_t sides = internal::number_of_sides(h, mesh);
      if (sides != 3)
        throw Input_error("face " + std::to_string(m_triangles.size()) + " has " + std::to_string(sides) +
                          " vertices, not 3; triangulate the mesh first");
      Triangle t = {{Index(get(index, source(h, mesh))), Index(get(index, target(h, mesh))),
                     Index(get(index, target(next(h, mesh), mesh)))}};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      m_triangles.push_back(t);
    }
    if (m_triangles.empty()) throw Input_error("the mesh has no faces");
  }

  template <class TriangleMesh, class VertexIndexMap>
  void read_edges(const TriangleMesh& mesh, VertexIndexMap index)
  {
    m_edges.reserve(number_of_vertices() + m_triangles.size()); // Euler
    for (auto e : internal::edges_of(mesh)) {
      auto h = halfedge(e, mesh);
      auto o = opposite(h, mesh);
      if (CGAL::is_border(h, mesh) && CGAL::is_border(o, mesh)) continue; // an edge that no face uses
      if (get(index, target(h, mesh)) < get(index, source(h, mesh))) std::swap(h, o);
      const auto third = [&](auto g) {
        return CGAL::is_border(g, mesh) ? none : Index(get(index, target(next(g, mesh), mesh)));
      };
      m_edges.push_back({Index(get(index, source(h, mesh))), Index(get(index, target(h, mesh))), third(h), third(o)});
    }
    m_edges = internal::sorted_in_rows(
        number_of_vertices(), m_edges, [](const Edge& e) { return e.source; },
        [](const Edge& a, const Edge& b) {
          return std::tie(a.target, a.left, a.right) < std::tie(b.target, b.left, b.right);
        });
  }

  // Rows are filled in the order in which they are to be: edges are sorted, so that those to smaller neighbours of a
  // vertex, in the order of these, come before those to larger ones; triangles are taken in their order.
  void connect()
  {
    const std::size_t n = number_of_vertices();
    m_is_border.assign(n, 0);
    for (const Edge& e : m_edges)
      if (e.is_border()) m_is_border[e.source] = m_is_border[e.target] = 1;
    const auto ends_of_edge = [this](Index e) { return std::array<Index, 2>{{m_edges[e].source, m_edges[e].target}}; };
    m_incident_edges =
        internal::rows_of_vertices(n, m_edges.size(), [](std::size_t i) { return Index(i); }, ends_of_edge);
    std::vector<Index> row;
    for (std::size_t v = 0; v < n; ++v) {
      row.clear();
      for (Index e : m_incident_edges[v]) {
        const Index other = m_edges[e].source == v ? m_edges[e].target : m_edges[e].source;
        if (row.empty() || row.back() != other) row.push_back(other);
      }
      m_neighbours.push_back(row.begin(), row.end());
    }

    m_ordered_triangles.resize(m_triangles.size());
    std::iota(m_ordered_triangles.begin(), m_ordered_triangles.end(), Index(0));
    m_ordered_triangles = internal::sorted_in_rows(
        n, m_ordered_triangles, [this](Index t) { return m_triangles[t][0]; },
        [this](Index a, Index b) { return std::tie(m_triangles[a], a) < std::tie(m_triangles[b], b); });
    m_incident_triangles = internal::rows_of_vertices(
        n, m_triangles.size(), [this](std::size_t i) { return m_ordered_triangles[i]; },
        [this](Index t) { return m_triangles[t]; });
    for (std::size_t v = 0; v < n; ++v)
      if (!is_isolated(v)) m_measured.push_back(Index(v));
  }

  void measure()
  {
    m_lengths.resize(m_edges.size());
    for (std::size_t i = 0; i < m_edges.size(); ++i)
      m_lengths[i] = (m_points[m_edges[i].source] - m_points[m_edges[i].target]).norm();
    m_areas.resize(m_triangles.size());
    for (std::size_t i = 0; i < m_triangles.size(); ++i) {
      const Triangle& t = m_triangles[i];
      m_areas[i] = (m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]).norm() / 2;
    }
    m_size = internal::surface_size(m_points, m_edges, m_lengths, m_measured);
  }

  std::vector<Triangle> m_triangles;
  std::vector<Index> m_ordered_triangles;
  std::vector<Edge> m_edges;
  Compressed_rows m_neighbours, m_incident_triangles, m_incident_edges;
  std::vector<char> m_is_border;
  std::vector<Point> m_points;
  std::vector<Index> m_measured;
  std::vector<double> m_areas, m_lengths;
  internal::Surface_size m_size;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_REST_SHAPE_H
