// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_SCALE_SPACE_ENGINE_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_SCALE_SPACE_ENGINE_H

#include <CGAL/Animated_mesh_features/Extrema/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Batch_search.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Difference_cascade.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Exhaustive_candidate_detector.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Extremum.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_batch.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_cascade.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_filter_traits.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Temporal_weights.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Time_axis.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Vectorized_candidate_detector.h>
#include <CGAL/Animated_mesh_features/Animation/largest_value.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Whether a search accepts nothing but strict minima.
template <class Search, class = void>
struct Searches_strict_minima : std::false_type
{
};
template <class Search>
struct Searches_strict_minima<Search, std::enable_if_t<Search::strict_minima>> : std::true_type
{
};

// Finds the extrema of the response over all samples (vertex, frame, k, l).
//
// The spatial filter S acts on frames, the temporal filter T on rows of frames, so they commute, L_kl = S_k d T_l, and
// S is applied once for each k only. A batch of space levels is kept in memory; for each vertex all its time levels,
// responses and the comparisons at the vertex itself run in the caches. They detect candidates - generously, since they
// run in single precision where they can -, which are verified in double precision, at the vertex and at its
// neighbours. Levels are in double precision whatever the scalar of the field.
template <class TemporalFilter, class Response, class Search>
class Scale_space_engine
{
  static constexpr std::size_t below = Response::below, above = Response::above;
  typedef Level_batch::Field Level;

public:
  Scale_space_engine(const Rest_shape& shape,
                     std::size_t number_of_frames,
                     std::size_t space_levels,
                     std::size_t time_levels,
                     const TemporalFilter& temporal,
                     const Response& response,
                     const Search& search)
    : m_shape(shape)
    , m_frames(number_of_frames)
    , m_space_levels(space_levels)
    , m_time_levels(time_levels)
    , m_temporal(temporal)
    , m_response(response)
    , m_search(search)
  {
  }

  // At most that many space levels at which extrema are searched for at a time; a level of N x F doubles is in memory
  // for each, and for `below` + `above` + 2 more.
  void set_largest_batch(std::size_t levels) { m_largest_batch = levels; }

  // Responses that are at most as large are none; default: 0.
  void set_least_response(double least) { m_least_response = least; }

  // All responses at a vertex and space level are multiplied by a factor, [vertex][space level]; default: none.
  void set_factors(std::vector<float> factors) { m_factors = std::move(factors); }

  void set_instruction_set(Instruction_set instructions) { m_instructions = instructions; }

  // Seconds, in which the temporal filter has its variances. It only decides in which way candidates are found: without
  // it, all weights of a row count as different from zero.
  void set_frame_duration(double seconds) { m_frame_duration = seconds; }

  template <class ConcurrencyTag, class FT, class SpatialFilter>
  std::vector<Extremum> run(const Spatio_temporal_field<FT>& field, SpatialFilter& spatial, Any_visitor visitor)
  {
    const Level_weights weights(m_response, m_space_levels, m_time_levels, largest_value(field),
                                m_least_response, m_factors);
    Temporal_weights<TemporalFilter> temporal_weights(m_temporal, m_frames, m_time_levels, below + above + 3);
    const std::vector<double> costs = verification_costs();
    const auto run_with = [&](std::size_t fitting, const auto& make_detector) {
      return run_batches<ConcurrencyTag>(field, spatial, visitor, weights, temporal_weights, fitting, make_detector);
    };
    const auto run_cascade = [&](const auto& cascade) {
      typedef std::decay_t<decltype(cascade)> Cascade;
      return run_with(Cascade::largest_batch(below, above), [&](const Level_batch& batch) {
        return Vectorized_candidate_detector<Cascade>(batch, weights, cascade, time_axis(), costs, m_instructions);
      });
    };
    if constexpr (Is_vectorized_filter<TemporalFilter>::value && Searches_strict_minima<Search>::value &&
                  below + above <= 5) { // what a pack has room for
      if (!rows_are_slow()) {
        if (m_temporal.has_equal_steps()) return run_cascade(Difference_cascade<TemporalFilter>(m_temporal));
        if (levels_are_far_apart(spatial)) return run_cascade(Level_cascade<float, TemporalFilter>(m_temporal));
      }
      return run_cascade(Level_cascade<double, TemporalFilter>(m_temporal));
    } else {
      constexpr std::size_t fitting = 12;
      return run_with(fitting, [&](const Level_batch& batch) {
        return Exhaustive_candidate_detector<TemporalFilter, Search>(batch, weights, time_axis(), m_time_levels,
                                                                     m_temporal, m_search);
      });
    }
  }

private:
  Time_axis time_axis() const { return Time_axis(m_frames, m_temporal); }

  // What a candidate costs to be verified, by time level: products with all frames that have a weight, of which the
  // first few count as 1.
  std::vector<double> verification_costs() const
  {
    constexpr double standard_deviations = 9, unit = 64;
    std::vector<double> costs;
    for (std::size_t l = 0; l < m_time_levels; ++l) {
      double reach = double(m_frames);
      if constexpr (Is_vectorized_filter<TemporalFilter>::value) // of others all candidates are verified
        if (m_frame_duration > 0)
          reach = (std::min)(reach, standard_deviations * std::sqrt(m_temporal.variance(l)) / m_frame_duration);
      costs.push_back((std::max)(1., reach / unit));
    }
    return costs;
  }

  // Whether differences of levels have enough digits in single precision to tell minima from their neighbours. They
  // need the square of the step: a fifth of the logarithm leaves some hundred roundings.
  template <class SpatialFilter>
  bool levels_are_far_apart(const SpatialFilter& spatial) const
  {
    constexpr double least_ratio = 1.4; // of variances
    bool result = true;
    for (std::size_t k = 1; k < m_space_levels; ++k)
      result = result && spatial.variance(k) >= least_ratio * spatial.variance(k - 1);
    for (std::size_t l = 1; l < m_time_levels; ++l)
      result = result && m_temporal.variance(l) >= least_ratio * m_temporal.variance(l - 1);
    return result;
  }

  // Whether levels of long rows change so little from frame to frame that single precision cannot tell one from the
  // next: nearly every vertex would be searched again in double precision.
  bool rows_are_slow() const
  {
    constexpr std::size_t long_row = 1024, slow = 64; // frames
    const double widest = std::sqrt(m_temporal.variance(m_time_levels - 1));
    return m_frames > long_row && widest > double(slow) * m_frame_duration;
  }

  template <class ConcurrencyTag, class FT, class SpatialFilter, class MakeDetector>
  std::vector<Extremum> run_batches(const Spatio_temporal_field<FT>& field,
                                    SpatialFilter& spatial,
                                    Any_visitor& visitor,
                                    const Level_weights& weights,
                                    Temporal_weights<TemporalFilter>& temporal_weights,
                                    std::size_t fitting,
                                    const MakeDetector& make_detector)
  {
    const Task_loop<ConcurrencyTag, Any_visitor> smooth_loop(visitor, Stage::SCALE_SPACE);
    const Task_loop<ConcurrencyTag, Any_visitor> search_loop(visitor, Stage::EXTREMA);
    // D exists for k in [below, space_levels - above), an extremum has a D on either side.
    const std::size_t first = below + 1, last = m_space_levels - above - 1; // [first, last)
    const std::size_t largest = (std::max)(std::size_t(1), (std::min)(fitting, m_largest_batch));
    const std::size_t batches = (last - first + largest - 1) / largest;
    std::vector<Extremum> extrema;
    Level_batch batch;
    batch.levels.resize(m_space_levels);
    batch.below = below;
    batch.above = above;
    std::vector<std::shared_ptr<Level>> unused;
    std::size_t smoothed = 0;
    for (std::size_t i = 0; i < batches; ++i) {
      batch.first = first + i * (last - first) / batches; // as equal as they can be: the last one costs as much
      batch.last = first + (i + 1) * (last - first) / batches;
      {
        const Stage_scope stage(visitor, Stage::SCALE_SPACE);
        for (; smoothed < batch.last_level(); ++smoothed) {
          batch.levels[smoothed] = new_level(field, unused);
          const auto loop = smooth_loop.part(smoothed, m_space_levels);
          if (smoothed > 0)
            spatial(smoothed, *batch.levels[smoothed - 1], *batch.levels[smoothed], loop);
          else if constexpr (std::is_same<FT, double>::value)
            spatial(smoothed, field, *batch.levels[smoothed], loop);
          else
            spatial(smoothed, in_double(field), *batch.levels[smoothed], loop);
        }
      }
      {
        const Stage_scope stage(visitor, Stage::EXTREMA);
        std::vector<Extremum> found;
        const auto loop = search_loop.part(i, batches);
        Batch_search<TemporalFilter, Search> search(m_shape, batch, weights, time_axis(), m_search, m_time_levels,
                                                    temporal_weights);
        search.find(make_detector(batch), loop.part(0, 2), found);
        if (joins_equal(m_search)) search.join(loop.part(1, 2), found);
        extrema.insert(extrema.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
      }
      // the next batch begins at batch.last
      for (std::size_t k = batch.first_level(); k < batch.last - 1 - below; ++k)
        unused.push_back(std::move(batch.levels[k]));
    }
    return extrema;
  }

  template <class FT>
  static std::shared_ptr<Level> new_level(const Spatio_temporal_field<FT>& field,
                                          std::vector<std::shared_ptr<Level>>& unused)
  {
    if (unused.empty())
      return std::make_shared<Level>(field.number_of_rows(), field.number_of_frames(), field.memory());
    std::shared_ptr<Level> level = std::move(unused.back());
    unused.pop_back();
    return level;
  }

  template <class FT>
  static Level in_double(const Spatio_temporal_field<FT>& field)
  {
    Level result(field.number_of_rows(), field.number_of_frames(), field.memory());
    for (std::size_t v = 0; v < field.number_of_rows(); ++v)
      std::copy(field.row(v), field.row(v) + field.number_of_frames(), result.row(v));
    return result;
  }

  const Rest_shape& m_shape;
  std::size_t m_frames, m_space_levels, m_time_levels;
  const TemporalFilter& m_temporal;
  const Response& m_response;
  const Search& m_search;
  std::size_t m_largest_batch = std::size_t(-1);
  double m_least_response = 0, m_frame_duration = 0;
  std::vector<float> m_factors;
  Instruction_set m_instructions = widest_instruction_set();
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_SCALE_SPACE_ENGINE_H
