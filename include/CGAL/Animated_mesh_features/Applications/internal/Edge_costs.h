// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_EDGE_COSTS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_EDGE_COSTS_H

#include <CGAL/Animated_mesh_features/Applications/internal/Pose_collapses.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The costs of a mesh's edges, kept as long as their ends stay what they are: CGAL asks for those of all edges near a
// collapse, of which most have not changed.
template <class TriangleMesh, class VertexIndexMap>
class Edge_costs
{
  typedef boost::graph_traits<TriangleMesh> Traits;

public:
  // All at once, in parallel; CGAL asks one by one. Arguments are kept by reference but for the index map.
  Edge_costs(const TriangleMesh& mesh, VertexIndexMap index, const Pose_collapses& collapses)
    : m_mesh(&mesh)
    , m_index(index)
    , m_collapses(&collapses)
    , m_costs(get(CGAL::dynamic_edge_property_t<Known_cost>(), mesh))
  {
    const std::vector<typename Traits::edge_descriptor> all(edges(mesh).begin(), edges(mesh).end());
    std::vector<double> costs(all.size());
    parallel_for<CGAL::Parallel_if_available_tag>(0, all.size(), [&](std::size_t e) {
      const typename Traits::halfedge_descriptor h = halfedge(all[e], mesh);
      costs[e] = collapses.cost(rank(source(h, mesh)), rank(target(h, mesh)));
    });
    for (std::size_t e = 0; e < all.size(); ++e) put(m_costs, all[e], Known_cost{costs[e], 0, 1});
  }

  double operator()(typename Traits::halfedge_descriptor h)
  {
    const std::size_t i = rank(source(h, *m_mesh)), j = rank(target(h, *m_mesh));
    const std::uint32_t stamp = (std::max)(m_collapses->stamp(i), m_collapses->stamp(j));
    const auto e = edge(h, *m_mesh);
    const Known_cost known = get(m_costs, e);
    if (known.is_known != 0 && known.stamp == stamp) return known.cost;
    const double cost = m_collapses->cost(i, j);
    put(m_costs, e, Known_cost{cost, stamp, 1});
    return cost;
  }

private:
  struct Known_cost
  {
    double cost = 0;
    std::uint32_t stamp = 0, is_known = 0;
  };

  std::size_t rank(typename Traits::vertex_descriptor v) const { return std::size_t(get(m_index, v)); }

  const TriangleMesh* m_mesh;
  VertexIndexMap m_index;
  const Pose_collapses* m_collapses;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_edge_property_t<Known_cost>>::const_type m_costs;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_EDGE_COSTS_H
