// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_CANDIDATE_VERIFIER_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_CANDIDATE_VERIFIER_H

#include <CGAL/Animated_mesh_features/Extrema/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Extremum.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_matrices.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Decides whether a candidate is an extremum. The temporal filter is linear, so a single response anywhere is a few
// scalar products of rows of the space levels with rows of the filter's matrices; in double precision and always by the
// same operations in the same order, so that neither the way in which candidates were found nor batches nor
// instruction sets show in the result.
template <class TemporalFilter, class Search>
class Candidate_verifier
{
  typedef Pack<double, 8, Baseline_register<double>::value> Block;

public:
  Candidate_verifier(const Rest_shape& shape,
                     const Level_batch& batch,
                     const Level_weights& weights,
                     const Temporal_matrices<TemporalFilter>& matrices,
                     const Search& search,
                     std::size_t number_of_frames)
    : m_shape(shape)
    , m_batch(batch)
    , m_weights(weights)
    , m_matrices(matrices)
    , m_search(search)
    , m_whole_blocks(number_of_frames / Block::size * Block::size)
    , m_frames(number_of_frames)
  {
  }

  bool operator()(const Candidate& c, Extremum& extremum) const
  {
    const double centre = response(c.vertex, c.k, c.l, c.frame);
    if (!(std::abs(centre) > m_weights.floor(c.k, c.l))) return false;
    // Neighbours first: a candidate has passed the test at its vertex already, though with less precision.
    extremum.ring.clear();
    for (Rest_shape::Index w : m_shape.neighbours()[c.vertex]) {
      const double same = response(w, c.k, c.l, c.frame);
      if (!m_search.at_neighbour(centre, response(w, c.k, c.l, c.frame - 1), same,
                                 response(w, c.k, c.l, c.frame + 1)))
        return false;
      extremum.ring.push_back(same);
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t m = 0; m < 3; ++m)
          extremum.window[i][j][m] = response(c.vertex, c.k + i - 1, c.l + j - 1, c.frame + m - 1);
    const auto& window = extremum.window;
    if (!m_search.at_vertex(
            Response_window<double>(&window[0][1][1], &window[1][1][1], &window[2][1][1], std::ptrdiff_t(3))))
      return false;
    extremum.vertex = c.vertex;
    extremum.frame = c.frame;
    extremum.k = c.k;
    extremum.l = c.l;
    return true;
  }

private:
  double response(std::size_t v, std::size_t k, std::size_t l, std::size_t f) const
  {
    const double a = m_weights.space(k, l), b = m_weights.time(k, l);
    const double *upper = m_batch.row(k + m_batch.above, v), *lower = m_batch.row(k - m_batch.below, v);
    const double* same = m_batch.row(k, v);
    const double* now = m_matrices.row(l, f);
    const double *late = m_matrices.row(l + m_batch.above, f), *early = m_matrices.row(l - m_batch.below, f);
    Block space = Block::all(0), time = space;
    std::size_t j = 0;
    for (; j < m_whole_blocks; j += Block::size) {
      space = space + (Block::load(upper + j) - Block::load(lower + j)) * Block::load(now + j);
      time = time + Block::load(same + j) * (Block::load(late + j) - Block::load(early + j));
    }
    double space_rest = 0, time_rest = 0; // what follows a row's last frame is nobody's
    for (; j < m_frames; ++j) {
      space_rest += (upper[j] - lower[j]) * now[j];
      time_rest += same[j] * (late[j] - early[j]);
    }
    return a * (sum(space) + space_rest) + b * (sum(time) + time_rest);
  }

  static double sum(const Block& block)
  {
    double x[Block::size];
    block.store(x);
    return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
  }

  const Rest_shape& m_shape;
  const Level_batch& m_batch;
  const Level_weights& m_weights;
  const Temporal_matrices<TemporalFilter>& m_matrices;
  const Search& m_search;
  std::size_t m_whole_blocks, m_frames;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_CANDIDATE_VERIFIER_H
