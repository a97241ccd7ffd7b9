// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CGAL_HEAT_PATCH_H
#define CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CGAL_HEAT_PATCH_H

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/ball_reach.h>

// The heat method is written against an Eigen solver; the including program may not have said so.
#ifndef CGAL_EIGEN3_ENABLED
  #define CGAL_EIGEN3_ENABLED 1
#endif
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// CGAL's heat method on some triangles of a rest shape, for one source after the other. Degenerate triangles are left
// out, since their gradient is not a number; vertices that are then in no triangle have no distance.
class CGAL_heat_patch
{
public:
  typedef Rest_shape::Index Index;
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  typedef CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Direct> Heat_method;

  template <class TriangleIds>
  CGAL_heat_patch(const Rest_shape& shape, const TriangleIds& triangles)
  {
    for (std::size_t t : triangles) {
      if (is_degenerate(shape, t)) continue;
      std::array<Mesh::Vertex_index, 3> corners;
      for (int i = 0; i < 3; ++i) corners[i] = vertex(shape, shape.triangles()[t][i]);
      // A patch's rim may touch itself in a vertex; where Surface_mesh cannot express that, the rim does without the
      // triangle.
      m_mesh.add_face(corners[0], corners[1], corners[2]);
    }
    for (Mesh::Vertex_index v : m_mesh.vertices())
      if (m_mesh.is_isolated(v)) m_number.erase(m_global[v]);
    if (m_number.size() < m_mesh.number_of_vertices()) {
      // the heat method's matrices would be singular
      for (std::size_t v = 0; v < m_global.size(); ++v)
        if (m_mesh.is_isolated(Mesh::Vertex_index(v))) m_mesh.remove_vertex(Mesh::Vertex_index(v));
    }
    if (m_mesh.number_of_faces() == 0) return;
    m_distances = m_mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
    try {
      m_heat_method = std::make_unique<Heat_method>(m_mesh);
    } catch (const CGAL::Failure_exception&) {
      throw Numerical_error("the heat method cannot factor its matrices around vertex " +
                            std::to_string(m_global.front()));
    }
  }

  // Computes the distances from `source`. Returns false if the source has no triangle here.
  bool run(Index source)
  {
    const auto s = m_number.find(source);
    if (s == m_number.end()) return false;
    m_heat_method->clear_sources();
    m_heat_method->add_source(s->second);
    m_heat_method->estimate_geodesic_distances(m_distances);
    return true;
  }

  // The distance of v in the last run; infinity where v is not part of the patch or the method has no number.
  double distance(Index v) const
  {
    const auto i = m_number.find(v);
    if (i == m_number.end() || !std::isfinite(m_distances[i->second])) return std::numeric_limits<double>::infinity();
    return m_distances[i->second];
  }

private:
  Mesh::Vertex_index vertex(const Rest_shape& shape, Index v)
  {
    const auto inserted = m_number.emplace(v, Mesh::Vertex_index(m_number.size()));
    if (inserted.second) {
      const Rest_shape::Point& p = shape.points()[v];
      m_mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
      m_global.push_back(v);
    }
    return inserted.first->second;
  }

  Mesh m_mesh;
  std::unordered_map<Index, Mesh::Vertex_index> m_number;
  std::vector<Index> m_global;
  Mesh::Property_map<Mesh::Vertex_index, double> m_distances;
  std::unique_ptr<Heat_method> m_heat_method;
};

// The vertices within the radius of a source, by the heat method's distance clamped to [Euclid, shortest path along
// edges]: both are bounds of the geodesic distance, and the heat method's own error a few edges from the source (6 to
// 8 %) often lies outside of them.
inline std::vector<Rest_shape::Index> clamped_heat_ball(const Rest_shape& shape,
                                                        Bounded_dijkstra& dijkstra,
                                                        CGAL_heat_patch& patch,
                                                        Rest_shape::Index source,
                                                        double radius)
{
  const std::array<Rest_shape::Index, 1> sources = {{source}};
  const bool has_heat = patch.run(source);
  std::vector<Rest_shape::Index> ball;
  for (Rest_shape::Index v : dijkstra.run(sources, ball_reach * radius)) {
    const double euclid = (shape.points()[v] - shape.points()[source]).norm();
    if (euclid > radius) continue;
    if (dijkstra.distance(v) <= radius || (has_heat && patch.distance(v) <= radius)) ball.push_back(v);
  }
  std::sort(ball.begin(), ball.end());
  return ball;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GEODESIC_BALLS_INTERNAL_CGAL_HEAT_PATCH_H
