// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_COLLAPSES_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_COLLAPSES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Followed_vertices.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Place_refinement.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_positions.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Pose_quadrics.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Quadric.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Surface_quadrics.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Turn_filter.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Weight_fit.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
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

  struct Settings
  {
    double line_weight, border_weight; // of the area at a vertex; of the squared length of an edge
    double least_cosine;               // between the normals of a triangle before and after
    std::size_t support;               // the most vertices that one follows
  };

  // A vertex in place of two others.
  struct Collapse
  {
    Followed_vertices followed;
    Turn_filter::Rows place; // in all columns
    Turn_filter::Side side;  // of the original around what it stands for
  };

  // `weight(v, pose)`: how much the surface around a vertex matters in a pose. `is_fixed`: `N` vertices that stay.
  template <class FT, class Weight, class Loop>
  Pose_collapses(const Rest_shape& rest, const Vertex_trajectories<FT>& trajectories,
                 const std::vector<std::size_t>& columns, std::size_t poses, const std::vector<char>& is_fixed,
                 const Settings& settings, const Weight& weight, const Loop& loop)
    : m_support(settings.support)
    , m_unit(rest.diameter() > 0 ? rest.diameter() : 1)
    , m_original(rest, trajectories, columns, m_unit)
    , m_current(m_original)
    , m_quadrics(rest.number_of_vertices(), poses)
    , m_turns(m_original, settings.least_cosine)
    , m_is_fixed(is_fixed)
    , m_stamps(rest.number_of_vertices(), 0)
    , m_followed(rest.number_of_vertices())
    , m_merged_into(rest.number_of_vertices())
  {
    std::iota(m_merged_into.begin(), m_merged_into.end(), Index(0));
    for (std::size_t v = 0; v < m_followed.size(); ++v) m_followed[v].add(Index(v), 1.);
    const Surface_quadrics surface(rest, m_original, settings.line_weight, settings.border_weight);
    loop(m_followed.size(), [&](std::size_t v) {
      for (std::size_t p = 0; p < poses; ++p) surface.add_to(m_quadrics, v, p, weight(v, p));
      m_turns.set_side(rest, m_original, v);
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
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p)
      sum += (std::max)(0., value(m_quadrics.sum(i, j, p), m_current.point(end, p)));
    return sum;
  }

  // The place of the vertex in place of i and j: the weights of vertices that these and their neighbours follow for
  // which the quadrics, summed over poses, are least. `link`: the neighbours of both.
  void place(std::size_t i, std::size_t j, const std::vector<Index>& link, Collapse& c)
  {
    c.followed.clear();
    if (is_fixed(i) || is_fixed(j)) {
      c.followed = m_followed[is_fixed(i) ? i : j];
    } else {
      const double t = place_on_edge(i, j);
      c.followed.add(m_followed[i], 1 - t);
      c.followed.add(m_followed[j], t);
      for (Index v : link) c.followed.add(m_followed[v].vertices[m_followed[v].heaviest()], 0.);
      m_fit.improve(m_quadrics, i, j, m_original, c.followed);
      if (c.followed.size() > m_support) {
        c.followed.keep_largest(m_support);
        m_fit.improve(m_quadrics, i, j, m_original, c.followed);
      }
    }
    follow(c.followed, c.place);
    m_turns.add_sides(i, j, c.side);
  }

  // The same on the edge, from 0 at i to 1 at j, for what place() was called for before.
  void place_between(std::size_t i, std::size_t j, double t, Collapse& c)
  {
    c.followed.clear();
    if (t < 1) c.followed.add(m_followed[i], 1 - t);
    if (t > 0) c.followed.add(m_followed[j], t);
    if (c.followed.size() > m_support) c.followed.keep_largest(m_support);
    follow(c.followed, c.place);
  }

  // of an edge whose vertex has that place: the sum of its quadrics there, no less than cost(i, j)
  double cost(std::size_t i, std::size_t j, const Collapse& c) const
  {
    double sum = 0;
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p)
      sum += (std::max)(
          0., value(m_quadrics.sum(i, j, p), {{double(c.place[0][p]), double(c.place[1][p]), double(c.place[2][p])}}));
    return sum;
  }

  // Whether the triangle of these vertices, of which the first moves, turns over in any column.
  bool turns(std::size_t moved, std::size_t b, std::size_t d, const Collapse& c) const
  {
    return m_turns.turns(m_current, moved, b, d, c.place, c.side);
  }

  // where the new vertex is at rest, relative to the mean of all vertices
  std::array<double, 3> rest_point(const Collapse& c) const
  {
    return {
        {m_unit * double(c.place[0].back()), m_unit * double(c.place[1].back()), m_unit * double(c.place[2].back())}};
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
    m_followed[kept] = c.followed;
    m_followed[removed] = Followed_vertices();
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::copy(c.place[axis].begin(), c.place[axis].end(), m_current.row(kept, int(axis)));
    m_turns.commit(kept, c.side);
    if (is_fixed(removed)) m_is_fixed[kept] = 1;
    m_merged_into[removed] = Index(kept);
    m_stamps[kept] = ++m_stamp;
  }

  // Moves the vertices of a level towards where it is nearest to the original around them; `weight(v, pose)` as above.
  // Fixed vertices stay, and those that may not move. Collapses may go on afterwards.
  template <class Weight, class Loop>
  void refine(const Place_refinement& level, const std::vector<char>& may_move, const Weight& weight, const Loop& loop)
  {
    const std::size_t n = level.vertices().size(), poses = m_quadrics.number_of_poses();
    Pose_quadrics planes(n + 1, poses); // and one that draws nowhere, the other end of what is no edge
    loop(poses, [&](std::size_t p) {
      level.add_planes(
          m_original, m_current, p, [&](std::size_t v) { return weight(v, p); }, planes);
    });
    std::vector<Followed_vertices> wanted(n);
    loop(n, [&](std::size_t k) {
      wanted[k] = m_followed[level.vertices()[k]];
      Weight_fit().improve(planes, k, n, m_original, wanted[k]);
    });
    for (std::size_t k = 0; k < n; ++k)
      if (may_move[k] != 0 && !is_fixed(level.vertices()[k])) move(level, k, wanted[k]);
  }

  // by the vertex
  const Followed_vertices& followed(std::size_t v) const { return m_followed[v]; }

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
  // where a vertex is in all columns that follows these
  void follow(const Followed_vertices& followed, Turn_filter::Rows& place)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      m_sum.assign(m_original.number_of_columns(), 0.);
      for (std::size_t k = 0; k < followed.size(); ++k) {
        const float* const row = m_original.row(followed.vertices[k], int(axis));
        for (std::size_t f = 0; f < m_sum.size(); ++f) m_sum[f] += followed.weights[k] * double(row[f]);
      }
      place[axis].assign(m_sum.begin(), m_sum.end());
    }
  }

  // Moves a vertex of a level to where it would follow these, and beyond: where all of them move, steps of up to twice as
  // long still go down, and 1.5 takes fewer of them. Less far, if that turned a triangle over.
  void move(const Place_refinement& level, std::size_t k, const Followed_vertices& wanted)
  {
    const Index v = level.vertices()[k];
    Collapse c;
    m_turns.side(v, c.side);
    const auto is_turned = [&](Index t) {
      const Rest_shape::Triangle& r = level.triangles()[t];
      const std::size_t i = r[0] == k ? 0 : r[1] == k ? 1 : 2;
      return turns(v, level.vertices()[r[(i + 1) % 3]], level.vertices()[r[(i + 2) % 3]], c);
    };
    for (double step : {1.5, .75, .375}) {
      c.followed = m_followed[v];
      for (double& w : c.followed.weights) w *= 1 - step;
      c.followed.add(wanted, step);
      follow(c.followed, c.place);
      const auto around = level.around(k);
      if (std::any_of(around.begin(), around.end(), is_turned)) continue;
      m_followed[v] = c.followed;
      for (std::size_t axis = 0; axis < 3; ++axis)
        std::copy(c.place[axis].begin(), c.place[axis].end(), m_current.row(v, int(axis)));
      m_stamps[v] = ++m_stamp;
      return;
    }
  }

  // the best place on the edge in all poses together, from 0 to 1
  double place_on_edge(std::size_t i, std::size_t j) const
  {
    double square = 0, linear = 0;
    for (std::size_t p = 0; p < m_quadrics.number_of_poses(); ++p) {
      const Quadric a = m_quadrics.sum(i, j, p);
      const std::array<double, 3> x = m_current.point(i, p), y = m_current.point(j, p);
      const std::array<double, 3> d = {{y[0] - x[0], y[1] - x[1], y[2] - x[2]}};
      const std::array<double, 3> m = {{(y[0] + x[0]) / 2, (y[1] + x[1]) / 2, (y[2] + x[2]) / 2}};
      const double small = Pose_quadrics::regularisation * trace(a);
      const std::array<double, 3> ad = product(a, d), g = half_gradient(a, m);
      for (std::size_t k = 0; k < 3; ++k) {
        square += d[k] * (ad[k] + small * d[k]);
        linear += d[k] * g[k];
      }
    }
    return square > 0 ? (std::min)(1., (std::max)(0., .5 - linear / square)) : .5;
  }

  std::size_t m_support;
  double m_unit; // of all that follows
  Pose_positions m_original, m_current;
  Pose_quadrics m_quadrics;
  Turn_filter m_turns;
  std::vector<char> m_is_fixed;
  std::vector<std::uint32_t> m_stamps;
  std::uint32_t m_stamp = 0;
  std::vector<Followed_vertices> m_followed;
  std::vector<Index> m_merged_into;
  Weight_fit m_fit;
  std::vector<double> m_sum; // of one collapse
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_POSE_COLLAPSES_H
