// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_CASCADE_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_CASCADE_H

#include <CGAL/Animated_mesh_features/Extrema/internal/load_levels.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The share of the largest value in a cascade of smoothings by which a result may differ from the exact one: each
// smoothing is an average with some roundings, most of which the following ones average away.
template <class T>
constexpr T smoothing_error()
{
  return 16 * std::numeric_limits<T>::epsilon();
}

// A cascade U_l = T_l d for each space level, D_kl = a (U_{k+p,l} - U_{k-q,l}) + b (U_{k,l+p} - U_{k,l-q}): for levels
// so far from one another that their differences keep their digits.
template <class T, class TemporalFilter>
class Level_cascade
{
public:
  typedef T Scalar;
  static constexpr bool is_single = sizeof(T) == sizeof(float);
  typedef std::conditional_t<is_single, Level_cascade<double, TemporalFilter>, void> Precise;
  // Levels in a pack, of which as many responses are made but for `below` + `above`. In double precision half as many:
  // one register at most, and hardly any of them idle where a mesh has few space levels.
  static constexpr std::size_t pack_size = is_single ? 16 : 8;

  static std::size_t largest_batch(std::size_t below, std::size_t above) { return pack_size - 2 - below - above; }

  explicit Level_cascade(const TemporalFilter& temporal) : m_temporal(temporal) {}

  Level_cascade<double, TemporalFilter> precise() const { return Level_cascade<double, TemporalFilter>(m_temporal); }

  template <std::size_t bytes>
  class Rows
  {
    typedef Pack<T, pack_size, bytes> Response_pack;

  public:
    Rows(const Level_cascade& cascade, const Level_batch& batch, const Time_axis& time)
      : m_temporal(cascade.m_temporal)
      , m_batch(batch)
      , m_time(time)
      , m_cascade(batch.below + batch.above + 1)
    {
      // a frame more, since packs are loaded from beyond the last
      for (std::vector<Response_pack>& row : m_cascade)
        row.assign(time.number_of_frames() + 2 * time.margin() + 1, Response_pack::all(0));
    }

    void start(std::size_t v)
    {
      load_levels(m_batch, v, m_time.number_of_frames(), m_loaded);
      m_bound = Response_pack::all(0);
      for (const Response_pack& frame : m_loaded) m_bound = larger(m_bound, absolute(frame));
      m_smoothed = 0;
    }

    // to the responses of time level l
    void advance(std::size_t l)
    {
      const std::size_t margin = m_time.margin();
      for (; m_smoothed <= l + m_batch.above; ++m_smoothed) {
        m_temporal(m_smoothed, m_smoothed == 0 ? m_loaded.data() : row(m_smoothed - 1) + margin,
                   row(m_smoothed) + margin);
        m_time.join_ends(row(m_smoothed));
      }
      m_now = reinterpret_cast<const T*>(row(l));
      m_late = reinterpret_cast<const T*>(row(l + m_batch.above));
      m_early = reinterpret_cast<const T*>(row(l - m_batch.below));
    }

    // in frame f of the row with its margins
    CGAL_ANIMATED_MESH_FEATURES_INLINE Response_pack response(const Response_pack& a, const Response_pack& b,
                                                              std::size_t f) const
    {
      const std::size_t i = f * pack_size;
      const Response_pack space =
          Response_pack::load(m_now + i + m_batch.below + m_batch.above) - Response_pack::load(m_now + i);
      const Response_pack time =
          Response_pack::load(m_late + i + m_batch.below) - Response_pack::load(m_early + i + m_batch.below);
      return a * space + b * time;
    }

    // of two responses, each of which is made of two differences, and which are neighbours in the pack
    CGAL_ANIMATED_MESH_FEATURES_INLINE Response_pack slack(const Response_pack& a, const Response_pack& b) const
    {
      return (absolute(a) + absolute(b)) * m_bound * (4 * smoothing_error<T>());
    }

  private:
    Response_pack* row(std::size_t l) { return m_cascade[l % m_cascade.size()].data(); }

    const TemporalFilter& m_temporal;
    const Level_batch& m_batch;
    const Time_axis m_time;
    std::vector<Response_pack> m_loaded;
    std::vector<std::vector<Response_pack>> m_cascade; // time level l in [l % size], with its margins
    std::size_t m_smoothed = 0; // time levels made so far
    Response_pack m_bound;
    const T *m_now = nullptr, *m_late = nullptr, *m_early = nullptr;
  };

private:
  const TemporalFilter& m_temporal;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_LEVEL_CASCADE_H
