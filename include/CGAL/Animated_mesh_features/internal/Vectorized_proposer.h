// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_VECTORIZED_PROPOSER_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_VECTORIZED_PROPOSER_H

#include <CGAL/Animated_mesh_features/internal/Lane_rows.h>
#include <CGAL/Animated_mesh_features/internal/Lane_weights.h>
#include <CGAL/Animated_mesh_features/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/internal/Response_lanes.h>
#include <CGAL/Animated_mesh_features/internal/run_vectorized.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The share of the largest value in a chain of smoothings by which a result may differ from the exact one: each smoothing
// is an average with some roundings, most of which the following ones average away.
template <class T>
constexpr T smoothing_error()
{
  return 16 * std::numeric_limits<T>::epsilon();
}

// Proposes the samples of a range of vertices that may be strict minima, for temporal filters that take lanes: a lane
// for each space level of a batch, all time levels one after the other, in the caches. It proposes all that the errors
// of its arithmetic leave possible, so that nothing is lost by single precision; deciding is up to others.
//
// Chains::Row<bytes> makes the responses of successive time levels of a vertex.
template <class Chains>
class Vectorized_proposer
{
  typedef typename Chains::Scalar T;

public:
  Vectorized_proposer(const Level_batch& batch, const Level_weights& weights, const Chains& chains,
                      std::size_t number_of_frames, std::size_t time_levels, Instruction_set instructions)
    : m_batch(batch)
    , m_weights(weights, batch, time_levels, Chains::lanes)
    , m_chains(chains)
    , m_frames(number_of_frames)
    , m_time_levels(time_levels)
    , m_instructions(instructions)
  {
  }

  void operator()(std::size_t first_vertex, std::size_t last_vertex, std::vector<Candidate>& candidates) const
  {
    Kernel kernel = {*this, first_vertex, last_vertex, candidates};
    run_vectorized<T>(m_instructions, kernel);
  }

private:
  struct Kernel
  {
    const Vectorized_proposer& proposer;
    std::size_t first_vertex, last_vertex;
    std::vector<Candidate>& candidates;

    template <std::size_t bytes>
    void run()
    {
      proposer.template search<bytes>(first_vertex, last_vertex, candidates);
    }
  };

  template <std::size_t bytes>
  void search(std::size_t first_vertex, std::size_t last_vertex, std::vector<Candidate>& candidates) const
  {
    typedef Lanes<T, Chains::lanes, bytes> L;
    typename Chains::template Rows<bytes> rows(m_chains, m_batch, m_frames);
    Response_lanes<L> responses(m_frames);
    const std::size_t last_lane = m_batch.last - m_batch.first + 1;
    const std::size_t first = m_batch.below, last = m_time_levels - m_batch.above;
    for (std::size_t v = first_vertex; v < last_vertex; ++v) {
      rows.start(v);
      responses.start(first);
      for (std::size_t l = first; l < last; ++l) {
        rows.advance(l);
        const L a = L::load(m_weights.space(l)), b = L::load(m_weights.time(l));
        responses.push(rows.slack(a, b), L::load(m_weights.floor(l)),
                       [&](std::size_t f) { return rows.response(a, b, f); });
        if (!responses.can_search()) continue;
        const std::size_t searched = responses.searched_level();
        responses.search(m_weights.floor(searched), last_lane, [&](std::size_t f, std::size_t lane) {
          candidates.push_back({std::uint32_t(v), std::uint32_t(f), std::uint32_t(m_batch.first - 1 + lane),
                                std::uint32_t(searched)});
        });
      }
    }
  }

  const Level_batch& m_batch;
  Lane_weights<T> m_weights;
  const Chains& m_chains;
  std::size_t m_frames, m_time_levels;
  Instruction_set m_instructions;
};

// A chain U_l = T_l d for each space level, of which D_kl = a (U_{k+p,l} - U_{k-q,l}) + b (U_{k,l+p} - U_{k,l-q}): for
// levels so far from one another that their differences keep their digits.
template <class T, class TemporalFilter>
class Level_chains
{
public:
  typedef T Scalar;
  static constexpr std::size_t lanes = 16;

  static std::size_t largest_batch(std::size_t below, std::size_t above) { return lanes - 2 - below - above; }

  explicit Level_chains(const TemporalFilter& temporal) : m_temporal(temporal) {}

  template <std::size_t bytes>
  class Rows
  {
    typedef Lanes<T, lanes, bytes> L;

  public:
    Rows(const Level_chains& chains, const Level_batch& batch, std::size_t number_of_frames)
      : m_temporal(chains.m_temporal)
      , m_batch(batch)
      , m_frames(number_of_frames)
      , m_chain(batch.below + batch.above + 1)
    {
      // a frame more, since lanes are loaded from beyond the last
      for (std::vector<L>& row : m_chain) row.assign(number_of_frames + 1, L::all(0));
    }

    void start(std::size_t v)
    {
      load_levels(m_batch, v, m_frames, m_loaded);
      L bound = L::all(0);
      for (const L& frame : m_loaded) bound = larger(bound, absolute(frame));
      m_bound = bound;
      m_smoothed = 0;
    }

    // to the responses of time level l
    void advance(std::size_t l)
    {
      for (; m_smoothed <= l + m_batch.above; ++m_smoothed)
        m_temporal(m_smoothed, m_smoothed == 0 ? m_loaded.data() : row(m_smoothed - 1), row(m_smoothed));
      m_now = reinterpret_cast<const T*>(row(l));
      m_late = reinterpret_cast<const T*>(row(l + m_batch.above));
      m_early = reinterpret_cast<const T*>(row(l - m_batch.below));
    }

    CGAL_ANIMATED_MESH_FEATURES_INLINE L response(const L& a, const L& b, std::size_t f) const
    {
      const std::size_t i = f * lanes;
      const L space = L::load(m_now + i + m_batch.below + m_batch.above) - L::load(m_now + i);
      const L time = L::load(m_late + i + m_batch.below) - L::load(m_early + i + m_batch.below);
      return a * space + b * time;
    }

    // of two responses: each is made of two differences, of lanes that are neighbours
    CGAL_ANIMATED_MESH_FEATURES_INLINE L slack(const L& a, const L& b) const
    {
      return (absolute(a) + absolute(b)) * m_bound * (4 * smoothing_error<T>());
    }

  private:
    L* row(std::size_t l) { return m_chain[l % m_chain.size()].data(); }

    const TemporalFilter& m_temporal;
    const Level_batch& m_batch;
    std::size_t m_frames;
    std::vector<L> m_loaded;
    std::vector<std::vector<L>> m_chain; // time level l in [l % size]
    std::size_t m_smoothed = 0;          // time levels made so far
    L m_bound;
    const T *m_now = nullptr, *m_late = nullptr, *m_early = nullptr;
  };

private:
  const TemporalFilter& m_temporal;
};

// For a temporal filter whose steps are all the same, T_l = T^l T_0: the differences first, in double, and then their
// chains in single precision, D_kl = a T^l p_k + b T^l q_k. Nothing cancels, however close levels are.
template <class TemporalFilter>
class Difference_chains
{
public:
  typedef float Scalar;
  static constexpr std::size_t lanes = 16;

  static std::size_t largest_batch(std::size_t, std::size_t) { return lanes - 2; }

  explicit Difference_chains(const TemporalFilter& temporal) : m_temporal(temporal) {}

  template <std::size_t bytes>
  class Rows
  {
    typedef Lanes<float, lanes, bytes> L;
    // the levels from which the lanes' differences are made
    static constexpr std::size_t most_levels = lanes + 8;
    typedef Lanes<double, most_levels, bytes> Level_lanes;

  public:
    Rows(const Difference_chains& chains, const Level_batch& batch, std::size_t number_of_frames)
      : m_temporal(chains.m_temporal)
      , m_batch(batch)
      , m_frames(number_of_frames)
      , m_levels(batch.below + batch.above + 1)
      , m_row(number_of_frames)
      , m_next(number_of_frames)
    {
      for (std::vector<Level_lanes>& level : m_levels) level.resize(number_of_frames);
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
        float space[lanes], time[lanes];
        const double *same = numbers(q, f), *late = numbers(q + p, f), *early = numbers(0, f);
        for (std::size_t i = 0; i < lanes; ++i) {
          space[i] = float(same[i + q + p] - same[i]);
          time[i] = float(late[i + q] - early[i + q]);
        }
        m_row[f] = {L::load(space), L::load(time)};
      }
      m_level = q;
      measure();
    }

    // to the responses of time level l
    void advance(std::size_t l)
    {
      for (; m_level < l; ++m_level) {
        m_temporal(m_level + 1, m_row.data(), m_next.data());
        m_row.swap(m_next);
      }
      // the chains decay, and their errors with them
      if (l % 32 == 0) measure();
    }

    CGAL_ANIMATED_MESH_FEATURES_INLINE L response(const L& a, const L& b, std::size_t f) const
    {
      return a * m_row[f].p + b * m_row[f].q;
    }

    // of two responses
    CGAL_ANIMATED_MESH_FEATURES_INLINE L slack(const L& a, const L& b) const
    {
      return (absolute(a) * m_bound.p + absolute(b) * m_bound.q) * (2 * smoothing_error<float>());
    }

  private:
    void measure()
    {
      L p = L::all(0), q = p;
      for (std::size_t f = 0; f < m_frames; ++f) {
        p = larger(p, absolute(m_row[f].p));
        q = larger(q, absolute(m_row[f].q));
      }
      m_bound = {p, q};
    }

    const TemporalFilter& m_temporal;
    const Level_batch& m_batch;
    std::size_t m_frames;
    std::vector<Level_lanes> m_loaded;
    std::vector<std::vector<Level_lanes>> m_levels; // the first time levels
    std::vector<Lane_pair<L>> m_row, m_next;
    std::size_t m_level = 0; // of m_row
    Lane_pair<L> m_bound;
  };

private:
  const TemporalFilter& m_temporal;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_VECTORIZED_PROPOSER_H
