// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_CANONICAL_SHAPE_BUILDER_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_CANONICAL_SHAPE_BUILDER_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_assembly.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_components.h>
#include <CGAL/Animated_mesh_features/Animation/internal/Surface_plan.h>
#include <CGAL/Animated_mesh_features/Animation/internal/mean_edge_measures.h>
#include <CGAL/Animated_mesh_features/Animation/internal/nearest_rotation.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The canonical shape, component by component: large ones with all threads, one after the other, then small ones, each
// by a single thread.
template <class ConcurrencyTag, class FT>
class Canonical_shape_builder
{
  typedef Rest_shape::Point Point;
  typedef std::vector<Point> Points;
  typedef Task_loop<ConcurrencyTag, Any_visitor> Loop;

  // From this many triangles on, threads that work together wait less than they gain.
  static constexpr std::size_t large = 2000;

public:
  Canonical_shape_builder(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories, Any_visitor& visitor)
    : m_shape(shape)
    , m_trajectories(trajectories)
    , m_visitor(visitor)
    , m_adjacency(shape)
    , m_components(surface_components(shape))
    , m_rank_of_vertex(shape.number_of_vertices())
    , m_rank_of_triangle(shape.triangles().size())
    , m_result(shape.number_of_vertices())
  {}

  Points build()
  {
    const double averaged = 0.15, chosen = 0.3; // of the time, by experience
    m_mean = mean_edge_measures(m_shape, m_trajectories, m_adjacency, loop(0, averaged));
    m_closest = closest_frames(m_shape, m_trajectories, m_adjacency, m_components, m_mean, loop(averaged, chosen));
    std::vector<std::size_t> small;
    std::size_t done = 0, all = m_shape.triangles().size();
    const auto fraction = [&] { return chosen + (1 - chosen) * double(done) / double(all); };
    for (std::size_t c = 0; c < m_components.size(); ++c) {
      const std::size_t triangles = m_components[c].triangles.size();
      if (triangles < large) {
        small.push_back(c);
        continue;
      }
      const double before = fraction();
      done += triangles;
      assemble_large(c, before, fraction());
    }
    loop(fraction(), 1)(small.size(), [&](std::size_t i) { assemble_small(small[i]); });
    return std::move(m_result);
  }

private:
  Loop loop(double from, double to) const { return Loop(m_visitor, Stage::REST_SHAPE, from, to); }

  // A component's start: the frame in which it is closest to the averages.
  struct Start
  {
    Surface_plan plan;
    Points points, normals;
  };

  Start start(std::size_t c)
  {
    const Surface_component& component = m_components[c];
    Start s = {Surface_plan(m_shape, m_adjacency, component, m_mean, m_rank_of_vertex, m_rank_of_triangle), {}, {}};
    for (Rest_shape::Index v : component.vertices) s.points.push_back(m_trajectories.point(v, m_closest[c]));
    const Surface_frame<FT> frame(m_shape, m_adjacency, m_trajectories, m_closest[c]);
    for (Rest_shape::Index t : s.plan.original) s.normals.push_back(frame.normal(t));
    return s;
  }

  // Where the component fits its first frame best.
  void place(std::size_t c, const Points& points)
  {
    const std::vector<Rest_shape::Index>& vertices = m_components[c].vertices;
    Points target;
    for (Rest_shape::Index v : vertices) target.push_back(m_trajectories.point(v, 0));
    const Points placed = fitted_rigidly(points, target);
    for (std::size_t i = 0; i < vertices.size(); ++i) m_result[vertices[i]] = placed[i];
  }

  void assemble_small(std::size_t c)
  {
    if (m_components[c].triangles.empty()) return take_mean_position(m_components[c].vertices[0]);
    const Start s = start(c);
    Surface_assembly<ConcurrencyTag> assembly(s.plan, s.points, s.normals, false);
    for (std::size_t i = 0; i < assembly.number_of_preparations; ++i) assembly.prepare(i);
    assembly.begin();
    while (assembly.round())
      ;
    place(c, assembly.points());
  }

  void assemble_large(std::size_t c, double from, double to)
  {
    const auto share = [&](double a, double b) { return loop((1 - a) * from + a * to, (1 - b) * from + b * to); };
    const Start s = start(c);
    Surface_assembly<ConcurrencyTag> assembly(s.plan, s.points, s.normals, true);
    const double prepared = 0.3, begun = 0.4;
    share(0, prepared)(assembly.number_of_preparations, [&](std::size_t i) { assembly.prepare(i); });
    share(prepared, begun)(1, [&](std::size_t) { assembly.begin(); });
    // How many rounds there will be, nobody knows; some 15 are usual.
    const double usual_rounds = 15;
    const auto after = [&](double rounds) { return begun + (1 - begun) * rounds / (rounds + usual_rounds); };
    bool goes_on = true;
    for (double i = 0;; i += 1) {
      share(after(i), after(i + 1))(1, [&](std::size_t) { goes_on = assembly.round(); });
      if (!goes_on) break;
    }
    share(1, 1).finish();
    place(c, assembly.points());
  }

  void take_mean_position(Rest_shape::Index v)
  {
    Point sum = Point::Zero();
    for (std::size_t f = 0; f < m_trajectories.number_of_frames(); ++f) sum += m_trajectories.point(v, f);
    m_result[v] = sum / double(m_trajectories.number_of_frames());
  }

  const Rest_shape& m_shape;
  const Vertex_trajectories<FT>& m_trajectories;
  Any_visitor& m_visitor;
  Triangle_adjacency m_adjacency;
  std::vector<Surface_component> m_components;
  Edge_measures m_mean;
  std::vector<std::size_t> m_closest; // frame of each component
  std::vector<Rest_shape::Index> m_rank_of_vertex, m_rank_of_triangle; // scratch, of which each component has its own
  Points m_result;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_CANONICAL_SHAPE_BUILDER_H
