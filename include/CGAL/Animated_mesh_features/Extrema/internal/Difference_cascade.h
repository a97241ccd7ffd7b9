// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_DIFFERENCE_CASCADE_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_DIFFERENCE_CASCADE_H

#include <CGAL/Animated_mesh_features/Extrema/internal/load_levels.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_cascade.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// For a temporal filter whose steps are all the same, T_l = T^l T_0: the differences first, in double; then they go
// through the cascade in single precision, D_kl = a T^l p_k + b T^l q_k. Nothing cancels, however close levels are.
template <class TemporalFilter>
class Difference_cascade
{
public:
  typedef float Scalar;
  typedef Level_cascade<double, TemporalFilter> Precise;
  static constexpr std::size_t pack_size = 16;

  static std::size_t largest_batch(std::size_t, std::size_t) { return pack_size - 2; }

  explicit Difference_cascade(const TemporalFilter& temporal) : m_temporal(temporal) {}

  Precise precise() const { return Precise(m_temporal); }

  template <std::size_t bytes>
  class Rows
  {
    typedef Pack<float, pack_size, bytes> Response_pack;
    // the levels of whose differences a pack of responses is made
    static constexpr std::size_t most_levels = pack_size + 8;
    typedef Pack<double, most_levels, bytes> Level_pack;

  public:
    Rows(const Difference_cascade& cascade, const Level_batch& batch, const Time_axis& time)
      : m_temporal(cascade.m_temporal)
      , m_batch(batch)
      , m_time(time)
      , m_frames(time.number_of_frames())
      , m_levels(batch.below + batch.above + 1)
      , m_row(m_frames + 2 * time.margin())
      , m_next(m_row.size())
    {
      for (std::vector<Level_pack>& level : m_levels) level.resize(m_frames);
    }

    void start(std::size_t v)
    {
      load_levels(m_batch, v, m_frames, m_loaded);
      for (std::size_t l = 0; l < m_levels.size(); ++l)
        m_temporal(l, l == 0 ? m_loaded.data() : m_levels[l - 1].data(), m_levels[l].data());
      const std::size_t p = m_batch.above, q = m_batch.below;
      const auto numbers = [&](std::size_t l, std::size_t f) {
        return reinterpret_cast<const double*>(m_levels[l].data() + f);
      };
      for (std::size_t f = 0; f < m_frames; ++f) {
        float space[pack_size], time[pack_size];
        const double *same = numbers(q, f), *late = numbers(q + p, f), *early = numbers(0, f);
        for (std::size_t i = 0; i < pack_size; ++i) {
          space[i] = float(same[i + q + p] - same[i]);
          time[i] = float(late[i + q] - early[i + q]);
        }
        m_row[m_time.margin() + f] = {Response_pack::load(space), Response_pack::load(time)};
      }
      m_time.join_ends(m_row.data());
      m_level = q;
      measure();
    }

    // to the responses of time level l
    void advance(std::size_t l)
    {
      for (; m_level < l; ++m_level) {
        m_temporal(m_level + 1, m_row.data() + m_time.margin(), m_next.data() + m_time.margin());
        m_row.swap(m_next);
        m_time.join_ends(m_row.data());
      }
      // the differences decay, and their errors with them
      if (l % 32 == 0) measure();
    }

    // in frame f of the row with its margins
    CGAL_ANIMATED_MESH_FEATURES_INLINE Response_pack response(const Response_pack& a, const Response_pack& b,
                                                              std::size_t f) const
    {
      return a * m_row[f].p + b * m_row[f].q;
    }

    // of two responses
    CGAL_ANIMATED_MESH_FEATURES_INLINE Response_pack slack(const Response_pack& a, const Response_pack& b) const
    {
      return (absolute(a) * m_bound.p + absolute(b) * m_bound.q) * (2 * smoothing_error<float>());
    }

  private:
    void measure()
    {
      Response_pack p = Response_pack::all(0), q = p;
      for (std::size_t f = 0; f < m_row.size(); ++f) {
        p = larger(p, absolute(m_row[f].p));
        q = larger(q, absolute(m_row[f].q));
      }
      m_bound = {p, q};
    }

    const TemporalFilter& m_temporal;
    const Level_batch& m_batch;
    const Time_axis m_time;
    std::size_t m_frames;
    std::vector<Level_pack> m_loaded;
    std::vector<std::vector<Level_pack>> m_levels; // the first time levels
    std::vector<Pack_pair<Response_pack>> m_row, m_next; // with their margins
    std::size_t m_level = 0; // of m_row
    Pack_pair<Response_pack> m_bound;
  };

private:
  const TemporalFilter& m_temporal;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_DIFFERENCE_CASCADE_H
