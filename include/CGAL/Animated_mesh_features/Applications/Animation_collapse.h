// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_COLLAPSE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_COLLAPSE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Applications/Collapse_guidance.h>
#include <CGAL/Animated_mesh_features/Applications/Simplification_options.h>
#include <CGAL/Animated_mesh_features/Applications/Vertex_binding.h>
#include <CGAL/Animated_mesh_features/Applications/choose_poses.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Collapse_optional.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Edge_costs.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Place_refinement.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_collapses.h>
#include <CGAL/Animated_mesh_features/Applications/internal/collapse_settings.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

The policies with which `CGAL::Surface_mesh_simplification::edge_collapse()` simplifies an animated mesh: cost,
placement, filter and visitor, which share this object. Any of \cgal's stop predicates goes with them.

\code
Animation_collapse<Mesh, Index_map> collapse(mesh, index, animation.rest_shape(), animation.trajectories(), options);
const auto cost = collapse.cost();
const auto placement = collapse.placement();
const auto filter = collapse.filter();
SMS::edge_collapse(mesh, stop, parameters::get_cost(cost).get_placement(placement).filter(filter)
                                   .visitor(collapse.visitor(SMS::Edge_collapse_visitor_base<Mesh>())));
\endcode

The cost of an edge is the sum, over poses, of the least value that the quadrics of its ends take together (A. Mohr,
M. Gleicher, Deformation sensitive decimation, 2003). A vertex takes the place of two by weights of vertices of the
original, the same in all frames, for which the summed quadrics are least: so it has a place in every frame, pose or
not, and in any other animation of the mesh.

The filter looks at all frames and the rest shape. It compares a triangle with the original around all that its corners
have taken the place of, wherever that has a side, that is, the sum of its normals is at least half as long as its area:
the triangle looks to that side, unless it looked away before, and its normal turns by no more than the options allow,
unless it comes within 60 degrees of that side, or nearer to it than it was. Without the second exception meshes lock that
crumple in some frame: what else is left is collapsed then, at any cost. For the same reason the filter does not refuse
an edge whose best place it does not allow if it allows one of its ends or its middle, for up to four times the cost.

Quadrics are of planes, which reach beyond the triangles that they come from. `refine()` moves what is left by distances of
surfaces, now and then, or at the end.

The mesh is the only thing that \cgal changes; this object keeps what belongs to its vertices. Several calls of
`edge_collapse()`, one after the other, go on where the last one stopped. Vertices that must stay are told to this
object, with `Simplification_options::fixed_vertices`; edges, by \cgal's `edge_is_constrained_map`.

\tparam TriangleMesh a model of `MutableFaceGraph` and `HalfedgeListGraph` with dynamic properties.
\tparam VertexIndexMap readable, vertex descriptor to rank in the rest shape; ranks are kept while vertices are removed.
*/
template <class TriangleMesh, class VertexIndexMap>
class Animation_collapse
{
  typedef internal::Pose_collapses Collapses;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type Vertex_point_map;
  typedef typename boost::property_traits<Vertex_point_map>::value_type Point;

public:
  typedef Rest_shape::Index Index; ///< rank of a vertex

  /*!
  computes the quadrics of all vertices, in parallel if oneTBB is there, in `O(N F)` time and `80 N P + 40 N (F + 1)`
  bytes for `P` poses.

  \param mesh is kept by reference; its points at rest are changed as vertices move.
  \param index the rank of each vertex.
  \param rest the surface at rest.
  \param trajectories the positions in all frames.
  \param options of which the number of vertices is not used.
  \param guidance a model of `CollapseGuidance`.
  \throw Option_error if an option is out of its range.
  */
  template <class FT, class Guidance = Plain_guidance>
  Animation_collapse(TriangleMesh& mesh, VertexIndexMap index, const Rest_shape& rest,
                     const Vertex_trajectories<FT>& trajectories, const Simplification_options& options,
                     const Guidance& guidance = Guidance())
    : m_index(index)
    , m_points(get(CGAL::vertex_point, mesh))
    , m_poses(choose_poses(rest, trajectories, options.poses, options.preferred_poses))
    , m_collapses(
          rest, trajectories, internal::pose_columns(m_poses, trajectories.number_of_frames()), m_poses.size(),
          internal::fixed_vertices(options, rest.number_of_vertices()), internal::collapse_settings(options),
          [&](std::size_t v, std::size_t pose) { return guidance(v, m_poses[pose]); },
          [](std::size_t n, const auto& task) { parallel_for<CGAL::Parallel_if_available_tag>(0, n, task); })
    , m_costs(mesh, index, m_collapses)
  {
    const Rest_shape::Point& first = rest.points().front();
    const std::array<double, 3> relative = m_collapses.rest_point(0);
    for (int axis = 0; axis < 3; ++axis) m_centre[axis] = first[axis] - relative[axis];
  }

  Animation_collapse(const Animation_collapse&) = delete;
  Animation_collapse& operator=(const Animation_collapse&) = delete;

  /// the frames whose quadrics are summed.
  const std::vector<std::size_t>& poses() const { return m_poses; }

  /// the cost of an edge: squared length times area, summed over poses, in the unit of the rest shape's diameter.
  auto cost()
  {
    return [this](const auto& profile, const auto&) {
      return internal::Collapse_optional<typename std::decay_t<decltype(profile)>::FT>(m_costs(profile.v0_v1()));
    };
  }

  /// where the vertex is at rest that an edge becomes.
  auto placement()
  {
    return [this](const auto& profile) { return internal::Collapse_optional<Point>(this->place(profile)); };
  }

  /// refuses what would turn a triangle over in any frame, or has it take place at one of the edge's ends or in its middle.
  auto filter()
  {
    return [this](const auto& profile, const auto& placement) {
      typedef std::decay_t<decltype(placement)> Placement;
      if (this->is_allowed(profile)) return placement;
      return this->find_other_place(profile) ? Placement(this->point(m_collapses.rest_point(m_collapse))) : Placement();
    };
  }

  /// A model of \cgal's `EdgeCollapseSimplificationVisitor`, without which nothing is remembered. `Next` is a visitor
  /// that is told everything, too, after this object.
  template <class Next>
  struct Visitor : Next
  {
    /// \cond SKIP_IN_MANUAL
    Visitor(Animation_collapse* collapse, const Next& next)
      : Next(next)
      , m_collapse(collapse)
    {}

    template <class Profile, class Cost, class Size>
    void OnSelected(const Profile& profile, const Cost& cost, Size initial, Size current)
    {
      m_collapse->m_selected = profile.v0_v1();
      m_collapse->m_is_selected = true;
      m_collapse->m_is_placed = false;
      Next::OnSelected(profile, cost, initial, current);
    }

    template <class Profile, class Vertex>
    void OnCollapsed(const Profile& profile, const Vertex& v)
    {
      m_collapse->commit(profile, v);
      Next::OnCollapsed(profile, v);
    }

  private:
    Animation_collapse* m_collapse;
    /// \endcond
  };

  /// the visitor, which tells `next`.
  template <class Next>
  Visitor<Next> visitor(const Next& next)
  {
    return Visitor<Next>(this, next);
  }

  /// appends what a vertex that is left follows.
  void bind(vertex_descriptor v, Vertex_binding& binding) const
  {
    const std::size_t i = get(m_index, v);
    binding.push_back(m_collapses.followed(i).vertices, m_collapses.followed(i).weights);
  }

  /*!
  moves the vertices that are left, but for fixed ones and those at borders, to where both surfaces are nearest to each
  other around them, in the mean over samples of both, in all poses together: for distances \f$e\f$ with the mean
  \f$s/2\f$ in a pose the sum of \f$e - s\,\log(1 + e/s)\f$ becomes less. No step turns a triangle over; collapses may
  go on from there.

  \param mesh that of the constructor, as it is now; its points at rest are changed.
  \param rest, guidance those of the constructor.

  A step towards the points that are nearest now; a few more get nearer. Takes `O(N P)` time, in parallel if oneTBB is
  there, and `80 M P` bytes for `M` vertices that are left.
  */
  template <class Guidance = Plain_guidance>
  void refine(const TriangleMesh& mesh, const Rest_shape& rest, const Guidance& guidance = Guidance())
  {
    std::vector<Rest_shape::Triangle> triangles;
    for (auto f : faces(mesh)) {
      const halfedge_descriptor h = halfedge(f, mesh), g = next(h, mesh);
      triangles.push_back(
          {{Index(rank(target(h, mesh))), Index(rank(target(g, mesh))), Index(rank(target(next(g, mesh), mesh)))}});
    }
    const std::vector<Index> survivors = m_collapses.survivors();
    const internal::Place_refinement level(rest, triangles, survivors);
    std::vector<char> at_border(rest.number_of_vertices(), 0), may_move;
    for (auto h : halfedges(mesh))
      if (is_border_edge(h, mesh)) at_border[rank(target(h, mesh))] = 1;
    for (Index v : level.vertices()) may_move.push_back(at_border[v] == 0);
    m_collapses.refine(
        level, may_move, [&](std::size_t v, std::size_t pose) { return guidance(v, m_poses[pose]); },
        [](std::size_t n, const auto& task) { parallel_for<CGAL::Parallel_if_available_tag>(0, n, task); });
    for (vertex_descriptor v : vertices(mesh)) put(m_points, v, point(m_collapses.rest_point(rank(v))));
  }

  /// for each vertex of the original the rank of the one that has taken its place, or its own. Linear time.
  std::vector<Index> survivors() const { return m_collapses.survivors(); }

private:
  std::size_t rank(vertex_descriptor v) const { return std::size_t(get(m_index, v)); }

  Point point(const std::array<double, 3>& relative) const
  {
    return Point(m_centre[0] + relative[0], m_centre[1] + relative[1], m_centre[2] + relative[2]);
  }

  // Of an edge that is about to be collapsed, its place; of others, of which only the cost is wanted, any.
  template <class Profile>
  Point place(const Profile& profile)
  {
    if (!m_is_selected || profile.v0_v1() != m_selected) return profile.p0();
    compute(profile);
    return point(m_collapses.rest_point(m_collapse));
  }

  template <class Profile>
  void compute(const Profile& profile)
  {
    if (m_is_placed) return;
    m_link.clear();
    for (vertex_descriptor v : profile.link()) m_link.push_back(Index(rank(v)));
    m_collapses.place(rank(profile.v0()), rank(profile.v1()), m_link, m_collapse);
    m_is_placed = true;
  }

  template <class Profile>
  bool is_allowed(const Profile& profile)
  {
    const std::size_t i = rank(profile.v0()), j = rank(profile.v1());
    if (m_collapses.is_fixed(i) && m_collapses.is_fixed(j)) return false;
    compute(profile);
    for (const auto& t : profile.triangles()) {
      std::array<std::size_t, 3> r = {{rank(t.v0), rank(t.v1), rank(t.v2)}};
      const auto moves = [&](std::size_t k) { return int(r[k] == i || r[k] == j); };
      if (moves(0) + moves(1) + moves(2) != 1) continue;
      const std::size_t k = moves(0) ? 0 : moves(1) ? 1 : 2;
      if (m_collapses.turns(r[k], r[(k + 1) % 3], r[(k + 2) % 3], m_collapse)) return false;
    }
    return true;
  }

  // At an end or in the middle of the edge, the cheapest that is allowed, if it costs little more than the best place,
  // which is not.
  template <class Profile>
  bool find_other_place(const Profile& profile)
  {
    const std::size_t i = rank(profile.v0()), j = rank(profile.v1());
    if (m_collapses.is_fixed(i) || m_collapses.is_fixed(j)) return false;
    const double most = most_of_best * m_collapses.cost(i, j, m_collapse);
    std::array<std::pair<double, double>, 3> others; // cost and place
    for (std::size_t k = 0; k < 3; ++k) {
      others[k].second = double(k) / 2;
      m_collapses.place_between(i, j, others[k].second, m_collapse);
      others[k].first = m_collapses.cost(i, j, m_collapse);
    }
    std::sort(others.begin(), others.end());
    for (const auto& other : others) {
      if (other.first > most) return false;
      m_collapses.place_between(i, j, other.second, m_collapse);
      if (is_allowed(profile)) return true;
    }
    return false;
  }

  template <class Profile>
  void commit(const Profile& profile, vertex_descriptor v)
  {
    const std::size_t i = rank(profile.v0()), j = rank(profile.v1()), kept = rank(v);
    if (!m_is_selected || profile.v0_v1() != m_selected)
      m_is_placed = false; // edges of no length, which nobody is asked about
    if (!m_is_placed) m_collapses.place(i, j, {}, m_collapse);
    m_collapses.commit(kept, kept == i ? j : i, m_collapse);
    put(m_points, v, point(m_collapses.rest_point(kept)));
    m_is_selected = m_is_placed = false;
  }

  // How much more than the best place another one may cost. With 2 a crumpled mesh locks sooner, with 10 collapses are
  // worse than others that wait.
  static constexpr double most_of_best = 4;

  VertexIndexMap m_index;
  Vertex_point_map m_points;
  std::vector<std::size_t> m_poses;
  Collapses m_collapses;
  internal::Edge_costs<TriangleMesh, VertexIndexMap> m_costs;
  double m_centre[3];
  halfedge_descriptor m_selected = halfedge_descriptor();
  bool m_is_selected = false, m_is_placed = false;
  std::vector<Index> m_link;
  Collapses::Collapse m_collapse;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ANIMATION_COLLAPSE_H
