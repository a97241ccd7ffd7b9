// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_DENOISED_TRAJECTORIES_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_DENOISED_TRAJECTORIES_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Numerics/Small_cholesky.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// The weights by which the positions around a vertex make its own: see denoised_trajectories().
class Affine_smoother
{
public:
  typedef Rest_shape::Index Index;

  Affine_smoother(const Rest_shape& shape, double noise)
    : m_shape(&shape)
    , m_noise(noise)
    , m_dijkstra(shape)
  {
  }

  // Calls take(w, weight) for each vertex w whose position counts at v; weights sum to 1.
  template <class Take>
  void weights(Index v, const Take& take)
  {
    const double sigma = this->sigma(v);
    const std::vector<Index>& near = m_dijkstra.run(std::array<Index, 1>{{v}}, 2.5 * sigma);
    const std::vector<Rest_shape::Point>& points = m_shape->points();
    m_weights.clear();
    double sum = 0;
    Rest_shape::Point mean = Rest_shape::Point::Zero();
    for (const Index w : near) {
      const double d = m_dijkstra.distance(w) / sigma;
      m_weights.push_back(std::exp(-d * d / 2));
      sum += m_weights.back();
      mean += m_weights.back() * (points[w] - points[v]);
    }
    mean /= sum;
    Small_cholesky<3>::Matrix moments{};
    for (std::size_t i = 0; i < near.size(); ++i) {
      const Rest_shape::Point x = points[near[i]] - points[v] - mean;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c <= r; ++c) moments[r][c] += m_weights[i] * x[r] * x[c];
    }
    // Across a surface that is flat to rounding there is nothing to fit.
    const double ridge = 1e-9 * (moments[0][0] + moments[1][1] + moments[2][2]);
    for (int r = 0; r < 3; ++r) moments[r][r] += ridge;
    const Small_cholesky<3> factor(moments);
    Rest_shape::Point slope = Rest_shape::Point::Zero();
    if (factor.is_definite()) {
      const auto solution = factor.solve({{-mean[0], -mean[1], -mean[2]}});
      slope = Rest_shape::Point(solution[0], solution[1], solution[2]);
    }
    for (std::size_t i = 0; i < near.size(); ++i) {
      const Rest_shape::Point x = points[near[i]] - points[v] - mean;
      take(near[i], m_weights[i] * (1 / sum + x.dot(slope)));
    }
  }

private:
  double sigma(Index v) const
  {
    double length = 0;
    const auto edges = m_shape->incident_edges()[v];
    for (const Index e : edges) length += m_shape->lengths()[e];
    return 3 * std::sqrt(m_noise * length / double(edges.size()));
  }

  const Rest_shape* m_shape;
  double m_noise;
  Bounded_dijkstra m_dijkstra;
  std::vector<double> m_weights;
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

the animation without most of its noise, where that is independent in vertices and frames, as in scans and captures.

In each frame the surface around a vertex is taken as an affine image of the same part of a reference shape, fitted by least
squares with Gaussian weights - moving least squares \cgalCite{lancaster1981}, with the reference shape as the domain -, and
the vertex is put to where this map has it. Frames that are affine images of the reference shape stay as they are, whatever
details it has: it is the deformation that is smoothed, not the surface. Positions of a frame enter linearly, with weights
that depend on the reference shape only.

The weights' standard deviation, by lengths of paths along edges, is \f$ 3 \sqrt{s l} \f$ at a vertex whose edges have the
mean length \f$ l \f$, for noise of \f$ s \f$: noise strains what results by some \f$ s l / \sigma^2 \f$, the same everywhere
and for any noise, and what is fitted wrong grows with \f$ \sigma \f$. The factor was chosen among 2.5, 3 and 4 by the features
of one animation that are found again in noise of .1, .3 and 1 % of its diagonal.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag`, `CGAL::Parallel_tag` or `CGAL::Sequential_tag`.

\param shape the reference shape, with little noise: one that came with the animation, or `canonical_shape()`.
\param trajectories the positions of all vertices in all frames.
\param noise its standard deviation in each coordinate, as `position_noise()` tells (length); 0 changes nothing.
\param visitor is told of `Stage::DENOISING`.

\returns positions in memory of the same kind. They do not depend on the number of threads, bit for bit. A vertex without
  edges keeps its positions.

\throw Cancelled if the visitor asks for it.

Complexity: `O(N F m)` time, where `m`, the number of vertices within 2.5 standard deviations, is some `180 s / l`; a second
copy of the positions.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class FT>
Vertex_trajectories<FT> denoised_trajectories(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories,
                                              double noise, Any_visitor visitor = Any_visitor())
{
  typedef Rest_shape::Index Index;
  const internal::Stage_scope stage(visitor, Stage::DENOISING);
  const Task_loop<ConcurrencyTag, Any_visitor> loop(visitor, Stage::DENOISING);
  const std::size_t frames = trajectories.number_of_frames();
  typedef Spatio_temporal_field<FT> Field;
  Vertex_trajectories<FT> result = {Field(trajectories.number_of_vertices(), frames, trajectories.memory()),
                                    Field(trajectories.number_of_vertices(), frames, trajectories.memory()),
                                    Field(trajectories.number_of_vertices(), frames, trajectories.memory())};
  const std::array<const Field*, 3> from = {{&trajectories.x, &trajectories.y, &trajectories.z}};
  const std::array<Field*, 3> to = {{&result.x, &result.y, &result.z}};
  internal::Thread_local<internal::Affine_smoother> smoothers;
  loop(trajectories.number_of_vertices(), [&](std::size_t v) {
    for (std::size_t k = 0; k < 3; ++k) std::copy_n(from[k]->row(v), frames, to[k]->row(v));
    if (!(noise > 0) || shape.incident_edges()[v].size() == 0) return;
    const auto make = [&] { return std::make_unique<internal::Affine_smoother>(shape, noise); };
    smoothers.get(make).weights(Index(v), [&](Index w, double weight) {
      // by differences, so that a body far from the origin loses nothing
      for (std::size_t k = 0; k < 3; ++k) {
        const FT* const here = from[k]->row(v);
        const FT* const there = from[k]->row(w);
        FT* const sum = to[k]->row(v);
        for (std::size_t f = 0; f < frames; ++f) sum[f] += FT(weight) * (there[f] - here[f]);
      }
    });
  });
  return result;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_DENOISED_TRAJECTORIES_H
