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
#include <CGAL/Animated_mesh_features/Extrema/internal/join_equal_extrema.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Decides whether a candidate is an extremum. The temporal filter is linear, so a single response anywhere is a few
// scalar products of rows of the space levels with rows of the filter's weights; in double precision and always by the
// same operations in the same order, so that neither the way in which candidates were found nor batches nor
// instruction sets show in the result.
template <class TemporalFilter, class Search>
class Candidate_verifier
{
  typedef Pack<double, 8, Baseline_register<double>::value> Block;
  typedef typename Temporal_weights<TemporalFilter>::Rows Rows;

public:
  Candidate_verifier(const Rest_shape& shape, const Level_batch& batch, const Level_weights& weights,
                     const Time_axis& time, const Search& search)
    : m_shape(shape)
    , m_batch(batch)
    , m_weights(weights)
    , m_time(time)
    , m_search(search)
  {
  }

  // `rows` are those of a window of levels that has all that the responses at the neighbouring scales are made of.
  bool operator()(const Candidate& c, Rows& rows, Extremum& extremum) const
  {
    rows.seek(c.l - 1 - m_batch.below, c.l + 2 + m_batch.above, c.frame);
    const auto response = [&](std::size_t v, std::size_t k, std::size_t l, std::size_t f) {
      return this->response(v, k, l, f, rows);
    };
    const std::size_t before = m_time.before(c.frame), after = m_time.after(c.frame),
                      frames[3] = {before, c.frame, after};
    const double centre = response(c.vertex, c.k, c.l, c.frame);
    if (!(std::abs(centre) > m_weights.floor(c.k, c.l))) return false;
    // Neighbours first: a candidate has passed the test at its vertex already, though with less precision.
    extremum.ring.clear();
    for (Rest_shape::Index w : m_shape.neighbours()[c.vertex]) {
      double same = response(w, c.k, c.l, c.frame);
      // Of equal neighbours one counts as lower: on a ring that is exactly symmetric there would be no extremum at all.
      if (same == centre && joins_equal(m_search))
        same = std::nextafter(centre, (precedes(m_shape, c.vertex, w) ? 1 : -1) * std::numeric_limits<double>::infinity());
      if (!m_search.at_neighbour(centre, response(w, c.k, c.l, before), same, response(w, c.k, c.l, after)))
        return false;
      extremum.ring.push_back(same);
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t m = 0; m < 3; ++m)
          extremum.window[i][j][m] = response(c.vertex, c.k + i - 1, c.l + j - 1, frames[m]);
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

  // The response anywhere; `rows` are those of a window that has the levels it is made of, at the frame `f`.
  double response(std::size_t v, std::size_t k, std::size_t l, std::size_t f, Rows& rows) const
  {
    const double a = m_weights.space(k, l), b = m_weights.time(k, l);
    const std::size_t begin = rows.begin(), size = rows.end() - begin;
    const double* upper = m_batch.row(k + m_batch.above, v) + begin;
    const double* lower = m_batch.row(k - m_batch.below, v) + begin;
    const double* same = m_batch.row(k, v) + begin;
    const double* now = rows.row(l, f);
    const double *late = rows.row(l + m_batch.above, f), *early = rows.row(l - m_batch.below, f);
    Block space = Block::all(0), time = space;
    std::size_t j = 0;
    for (; j + Block::size <= size; j += Block::size) {
      space = space + (Block::load(upper + j) - Block::load(lower + j)) * Block::load(now + j);
      time = time + Block::load(same + j) * (Block::load(late + j) - Block::load(early + j));
    }
    double space_rest = 0, time_rest = 0; // what follows a row's last frame is nobody's
    for (; j < size; ++j) {
      space_rest += (upper[j] - lower[j]) * now[j];
      time_rest += same[j] * (late[j] - early[j]);
    }
    return (a * (sum(space) + space_rest) + b * (sum(time) + time_rest)) * m_weights.factor(v, k);
  }

private:
  static double sum(const Block& block)
  {
    double x[Block::size];
    block.store(x);
    return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
  }

  const Rest_shape& m_shape;
  const Level_batch& m_batch;
  const Level_weights& m_weights;
  const Time_axis m_time;
  const Search& m_search;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_CANDIDATE_VERIFIER_H
