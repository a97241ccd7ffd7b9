// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFY_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFY_ANIMATION_H

#include <CGAL/Animated_mesh_features/Animation/as_frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/Animation_collapse.h>
#include <CGAL/Animated_mesh_features/Applications/Collapse_guidance.h>
#include <CGAL/Animated_mesh_features/Applications/Simplification_limits.h>
#include <CGAL/Animated_mesh_features/Applications/Simplification_options.h>
#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

Nobody watches a simplification.
*/
struct Unwatched_simplification
{
  /// go on
  bool operator()(double) const { return true; }
};

namespace internal {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Collapsed_mesh;

// a copy whose vertices are numbered by rank; isolated ones have no faces there, either
template <class Animation>
Collapsed_mesh mesh_to_collapse(const Animation& animation)
{
  typedef Collapsed_mesh::Vertex_index Vertex;
  const auto& mesh = animation.triangle_mesh();
  const auto index = animation.vertex_index_map();
  Collapsed_mesh copy;
  for (const Rest_shape::Point& p : animation.rest_shape().points()) copy.add_vertex({p[0], p[1], p[2]});
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const auto vertex = [&](auto g) { return Vertex(Rest_shape::Index(get(index, target(g, mesh)))); };
    if (copy.add_face(vertex(h), vertex(next(h, mesh)), vertex(next(next(h, mesh), mesh))) ==
        Collapsed_mesh::null_face())
      throw Input_error("the mesh is no surface around a face of the vertices " +
                        std::to_string(get(index, target(h, mesh))) + ", ...: repair it first");
  }
  return copy;
}

// Stops at a number of vertices that belong to faces: an edge that is collapsed takes one of them.
class Vertex_count_stop
{
public:
  Vertex_count_stop(const std::size_t& vertices, std::size_t target)
    : m_vertices(&vertices)
    , m_target(target)
  {}

  template <class Cost, class Profile, class Size>
  bool operator()(const Cost&, const Profile&, Size, Size) const
  {
    return *m_vertices <= m_target;
  }

private:
  const std::size_t* m_vertices;
  std::size_t m_target;
};

// Counts vertices, and asks now and then whether to go on.
template <class Watch>
struct Collapse_counter : CGAL::Surface_mesh_simplification::Edge_collapse_visitor_base<Collapsed_mesh>
{
  Collapse_counter(std::size_t& vertices, std::size_t from, std::size_t to, const Watch& watch)
    : m_vertices(&vertices)
    , m_from(from)
    , m_to(to)
    , m_watch(&watch)
  {}

  template <class Profile, class Cost, class Size>
  void OnSelected(const Profile&, const Cost&, Size, Size)
  {
    if (++m_selected % 256 == 0 && !(*m_watch)(done())) throw Cancelled();
  }

  double done() const
  {
    const double done = double(m_from - *m_vertices), all = double(m_from > m_to ? m_from - m_to : 1);
    return (std::min)(1., .1 + .9 * done / all);
  }

  template <class Profile, class Vertex>
  void OnCollapsed(const Profile&, const Vertex&)
  {
    --*m_vertices;
  }

private:
  std::size_t *m_vertices, m_from, m_to, m_selected = 0;
  const Watch* m_watch;
};

// On the way from one number of vertices to another those at which places are refined, each about half of the one before,
// and the last.
inline std::vector<std::size_t> stages_between(std::size_t from, std::size_t to)
{
  std::vector<std::size_t> stages;
  const double steps = std::ceil(std::log2(double(from) / double(to)) - 1e-2); // from 100 % to 50 %: one
  for (double k = 1; k < steps; ++k)
    stages.push_back(std::size_t(double(from) * std::pow(double(to) / double(from), k / steps)));
  stages.push_back(to);
  return stages;
}

template <class Collapse>
Animation_level level_of(const Collapsed_mesh& mesh, const Collapse& collapse)
{
  Animation_level level;
  std::vector<Rest_shape::Index> number(mesh.num_vertices(), Rest_shape::none); // also of those that are removed
  for (auto v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    number[v] = Rest_shape::Index(level.binding.size());
    collapse.bind(v, level.binding);
  }
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto n = [&](auto g) { return number[mesh.target(g)]; };
    level.triangles.push_back({{n(h), n(mesh.next(h)), n(mesh.next(mesh.next(h)))}});
    level.triangle_of.push_back(Rest_shape::Index(f)); // faces are in the order of the original's
  }
  for (Rest_shape::Index v : collapse.survivors()) level.vertex_of.push_back(number[v]);
  return level;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

simplifies an animated mesh, for all of its frames at once: one coarse connectivity, or several, nested, whose
vertices follow those of the original. See `Animation_collapse` for the method, `simplification_errors()` for what it
costs.

Where the number of vertices has halved, and at each level, places are refined, and all edges that no collapse was possible
of are tried again: from where quadrics alone lead, many good collapses of a mesh that crumples would turn a triangle over.

Topology stays: closed surfaces stay closed, each component keeps its genus and its borders. No collapse turns a
triangle over in any frame; those that look away from the original around them do so in the original.

\tparam Animation a model of `MeshAnimation`.
\tparam Guidance a model of `CollapseGuidance`.
\tparam Watch a functor `bool(double)`, told how much is done, from 0 to 1, every few hundred edges, from the thread
  that called; returns whether to go on.

\param animation converted by `as_frame_sequence()` if it is no `Frame_sequence`.
\param options of which `vertices` has no default.
\param guidance where and when the surface matters more.
\param watch who watches.

\throw Option_error if no number of vertices is given, one is not smaller than the one before, the first is larger
  than the number of vertices that belong to faces, or the last is less than four for each closed component and three
  for each with a border; and as `Animation_collapse`.
\throw Input_error if the mesh is no 2-manifold.
\throw Cancelled if `watch` has had enough.

\f$O(N \log N\,P + N F)\f$ time for `P` poses; memory see `Animation_collapse`. The result is the same bits whatever
the number of threads.
*/
template <class Animation, class Guidance = Plain_guidance, class Watch = Unwatched_simplification>
Simplified_animation simplify_animation(const Animation& animation, const Simplification_options& options,
                                        const Guidance& guidance = Guidance(), const Watch& watch = Watch())
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  const auto& sequence = as_frame_sequence(animation);
  const Rest_shape& rest = sequence.rest_shape();
  std::size_t vertices = internal::check_targets(rest, options.vertices);
  internal::Collapsed_mesh mesh = internal::mesh_to_collapse(sequence);
  if (!watch(0.)) throw Cancelled();
  const auto index = get(CGAL::vertex_index, mesh);
  Animation_collapse<internal::Collapsed_mesh, std::decay_t<decltype(index)>> collapse(
      mesh, index, rest, sequence.trajectories(), options, guidance);
  const auto cost = collapse.cost();
  const auto placement = collapse.placement();
  const auto filter = collapse.filter();
  Simplified_animation result;
  result.poses = collapse.poses();
  const std::size_t from = vertices, last = options.vertices.back();
  const internal::Collapse_counter<Watch> counter(vertices, from, last, watch);
  for (std::size_t target : options.vertices) {
    for (std::size_t stage : internal::stages_between(vertices, target)) {
      const std::size_t before = vertices;
      SMS::edge_collapse(
          mesh, internal::Vertex_count_stop(vertices, stage),
          CGAL::parameters::get_cost(cost).get_placement(placement).filter(filter).visitor(collapse.visitor(counter)));
      const std::size_t refinements = stage == target ? options.refinements : (options.refinements + 2) / 3;
      for (std::size_t k = 0; k < refinements && vertices < before; ++k) {
        if (!watch(counter.done())) throw Cancelled();
        collapse.refine(mesh, rest, guidance);
      }
    }
    result.levels.push_back(internal::level_of(mesh, collapse));
  }
  if (!watch(1.)) throw Cancelled();
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFY_ANIMATION_H
