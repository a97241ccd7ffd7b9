// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_VECTORIZED_CANDIDATE_DETECTOR_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_VECTORIZED_CANDIDATE_DETECTOR_H

#include <CGAL/Animated_mesh_features/Extrema/internal/Packed_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Packed_responses.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Finds the samples of a range of vertices that may be strict minima, for temporal filters that take packs: an entry
// for each space level of a batch, all time levels one after the other, in the caches. It finds all that the errors of
// its arithmetic leave possible, so that nothing is lost by single precision; they are verified afterwards.
//
// Where a field hardly changes over frames and scales, single precision leaves everything possible. A vertex of which
// that is so is searched again with Cascade::Precise, unless that is `void`; as that may take fewer space levels at a
// time, in parts of the batch.
//
// Cascade::Row<bytes> makes the responses of successive time levels of a vertex.
template <class Cascade>
class Vectorized_candidate_detector
{
  typedef typename Cascade::Scalar T;
  static constexpr bool is_precise = std::is_void<typename Cascade::Precise>::value;
  typedef std::conditional_t<is_precise, Cascade, typename Cascade::Precise> Precise_cascade;
  struct Nothing
  {
  };
  typedef std::conditional_t<is_precise, Nothing, Vectorized_candidate_detector<Precise_cascade>> Precise_detector;

  struct Precise_part
  {
    template <class... Arguments>
    Precise_part(const Level_batch& batch, std::size_t first, std::size_t last, const Arguments&... arguments)
      : levels(batch.part(first, last))
      , detector(levels, arguments...)
    {}
    const Level_batch levels;
    const Precise_detector detector;
  };

public:
  // costs: of verifying a candidate, by time level; 1 for short rows
  Vectorized_candidate_detector(const Level_batch& batch, const Level_weights& weights, const Cascade& cascade,
                                const Time_axis& time, const std::vector<double>& costs, Instruction_set instructions)
    : m_batch(batch)
    , m_weights(weights, batch, costs.size(), Cascade::pack_size)
    , m_cascade(cascade)
    , m_time(time)
    , m_costs(costs)
    , m_instructions(instructions)
  {
    if constexpr (!is_precise) {
      const std::size_t largest = Precise_cascade::largest_batch(batch.below, batch.above);
      for (std::size_t first = batch.first; first < batch.last; first += largest)
        m_precise.push_back(std::make_shared<const Precise_part>(batch, first, (std::min)(batch.last, first + largest),
                                                                 weights, cascade.precise(), time, costs,
                                                                 instructions));
    }
  }

  void operator()(std::size_t first_vertex, std::size_t last_vertex, std::vector<Candidate>& candidates) const;

private:
  struct Vector_loop
  {
    const Vectorized_candidate_detector& detector;
    std::size_t first_vertex, last_vertex;
    std::vector<Candidate>& candidates;
    std::vector<std::size_t>& unclear;

    template <std::size_t bytes>
    void run()
    {
      detector.template search<bytes>(first_vertex, last_vertex, candidates, unclear);
    }
  };

  // Verifying what costs that much takes about as long as searching again.
  double largest_cost() const
  {
    constexpr double packs_per_candidate = 24;
    return double(m_precise.size() * m_costs.size() * m_time.number_of_frames()) / packs_per_candidate + 1;
  }

  template <std::size_t bytes>
  void search(std::size_t first_vertex, std::size_t last_vertex, std::vector<Candidate>& candidates,
              std::vector<std::size_t>& unclear) const
  {
    typedef Pack<T, Cascade::pack_size, bytes> Response_pack;
    typename Cascade::template Rows<bytes> rows(m_cascade, m_batch, m_time);
    const std::size_t margin = m_time.margin();
    Packed_responses<Response_pack> responses(m_time.number_of_frames() + 2 * margin);
    const std::size_t last_entry = m_batch.last - m_batch.first + 1;
    const std::size_t first = m_batch.below, last = m_costs.size() - m_batch.above;
    const double largest = largest_cost();
    for (std::size_t v = first_vertex; v < last_vertex; ++v) {
      const std::size_t clear = candidates.size();
      double cost = 0;
      rows.start(v);
      responses.start(first);
      Response_pack factors = Response_pack::all(1);
      if (m_weights.has_factors()) {
        T numbers[Cascade::pack_size];
        m_weights.factors(v, numbers);
        factors = Response_pack::load(numbers);
      }
      for (std::size_t l = first; l < last; ++l) {
        rows.advance(l);
        const Response_pack a = Response_pack::load(m_weights.space(l)) * factors;
        const Response_pack b = Response_pack::load(m_weights.time(l)) * factors;
        responses.push(rows.slack(a, b), Response_pack::load(m_weights.floor(l)),
                       [&](std::size_t f) { return rows.response(a, b, f); });
        if (!responses.can_search()) continue;
        const std::size_t searched = responses.searched_level(), before = candidates.size();
        responses.search(last_entry, [&](std::size_t f, std::size_t entry) {
          candidates.push_back({std::uint32_t(v), std::uint32_t(f - margin), std::uint32_t(m_batch.first - 1 + entry),
                                std::uint32_t(searched)});
        });
        cost += m_costs[searched] * double(candidates.size() - before);
        if (!is_precise && cost > largest) {
          candidates.resize(clear);
          unclear.push_back(v);
          break;
        }
      }
    }
  }

  const Level_batch& m_batch;
  Packed_weights<T> m_weights;
  const Cascade m_cascade;
  const Time_axis m_time;
  const std::vector<double>& m_costs; // [time level]
  Instruction_set m_instructions;
  std::vector<std::shared_ptr<const Precise_part>> m_precise;
};

// Outside of the class: a function that is defined within it is compiled wherever it is used, also where it is had
// compiled.
template <class Cascade>
void Vectorized_candidate_detector<Cascade>::operator()(std::size_t first_vertex, std::size_t last_vertex,
                                                        std::vector<Candidate>& candidates) const
{
  std::vector<std::size_t> unclear;
  Vector_loop loop = {*this, first_vertex, last_vertex, candidates, unclear};
  run_vectorized<T>(m_instructions, loop);
  if constexpr (!is_precise)
    for (std::size_t v : unclear)
      for (const std::shared_ptr<const Precise_part>& part : m_precise) part->detector(v, v + 1, candidates);
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_VECTORIZED_CANDIDATE_DETECTOR_H
