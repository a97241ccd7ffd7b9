// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for extrema against a brute force that keeps all levels of all samples and filters in the other order, in
// time first; the refinement of extrema against quadratics; the suppression of weaker ones against all pairs.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Difference_of_gaussians.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Scale_space_engine.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/refine_extremum.h>
#include <CGAL/Animated_mesh_features/Detection/internal/suppress_non_maxima.h>
#include <CGAL/Animated_mesh_features/Detection/internal/suppress_overlapped.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <tuple>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Rest_shape Rest_shape;
typedef Amf::internal::Extremum Extremum;
typedef Amf::Spatio_temporal_field<double> Field;
typedef std::vector<double> Row;

const double frame_duration = 1. / 30;

// The variances of the levels and the units of the response.
struct Levels
{
  Row space, time; // squared length, squared seconds
  double unit_length, unit_time;
};

// As many levels as wanted, at ratios below those of a detection, so that extrema of noise are many.
Levels levels_at_ratio(std::size_t space, std::size_t time, double smallest_space, double ratio)
{
  Levels levels;
  for (std::size_t k = 0; k < space; ++k) levels.space.push_back(smallest_space * std::pow(ratio, 2 * double(k)));
  for (std::size_t l = 0; l < time; ++l)
    levels.time.push_back(0.2 * std::pow(ratio, 2 * double(l)) * frame_duration * frame_duration);
  levels.unit_length = std::sqrt(std::sqrt(levels.space.front() * levels.space.back()));
  levels.unit_time = std::sqrt(std::sqrt(levels.time.front() * levels.time.back()));
  return levels;
}

// Every count of passes from `first` on.
Levels levels_of_counts(std::size_t space, std::size_t time, std::size_t first, double space_unit, double time_unit)
{
  Levels levels;
  for (std::size_t k = 0; k < space; ++k) levels.space.push_back(double(first + k) * space_unit);
  for (std::size_t l = 0; l < time; ++l) levels.time.push_back(double(first + l) * time_unit);
  levels.unit_length = std::sqrt(5 * space_unit);
  levels.unit_time = frame_duration;
  return levels;
}

template <class SpatialFilter, class TemporalFilter, class Response>
void initialize(const Rest_shape& shape, std::size_t frames, const Levels& levels, SpatialFilter& spatial,
                TemporalFilter& temporal, Response& response)
{
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  spatial.initialize(shape, levels.space, loop);
  temporal.initialize(frames, frame_duration, levels.time);
  Row sigma, tau;
  for (std::size_t k = 0; k < levels.space.size(); ++k) sigma.push_back(std::sqrt(spatial.variance(k)));
  for (std::size_t l = 0; l < levels.time.size(); ++l) tau.push_back(std::sqrt(temporal.variance(l)));
  Amf::Scale_levels scales;
  scales.unit_length = levels.unit_length;
  scales.unit_time = levels.unit_time;
  response.initialize(sigma, tau, scales);
}

// How the engine is to work; the result must not depend on it.
struct Way
{
  std::size_t largest_batch = std::size_t(-1);
  Amf::internal::Instruction_set instructions = Amf::internal::widest_instruction_set();
};

template <class FT, class Tag = CGAL::Sequential_tag, class SpatialFilter, class TemporalFilter, class Response>
std::vector<Extremum> extrema_of(const Rest_shape& shape, const Amf::Spatio_temporal_field<FT>& field,
                                 const Levels& levels, SpatialFilter spatial, TemporalFilter temporal,
                                 Response response, const Way& way = Way())
{
  initialize(shape, field.number_of_frames(), levels, spatial, temporal, response);
  Amf::Difference_of_gaussians_minima search;
  search.join_equal = false;
  Amf::internal::Scale_space_engine<TemporalFilter, Response, Amf::Difference_of_gaussians_minima> engine(
      shape, field.number_of_frames(), levels.space.size(), levels.time.size(), temporal, response, search);
  engine.set_largest_batch(way.largest_batch);
  engine.set_instruction_set(way.instructions);
  Amf::Default_visitor visitor;
  std::vector<Extremum> extrema = engine.template run<Tag>(field, spatial, visitor);
  std::sort(extrema.begin(), extrema.end(), [](const Extremum& a, const Extremum& b) {
    return std::tie(a.k, a.l, a.vertex, a.frame) < std::tie(b.k, b.l, b.vertex, b.frame);
  });
  return extrema;
}

// A filter of which nothing is known but that it models the concept.
template <class Filter>
class Plain_filter
{
public:
  explicit Plain_filter(const Filter& filter) : m_filter(filter) {}
  void initialize(std::size_t frames, double duration, const Row& variances)
  {
    m_filter.initialize(frames, duration, variances);
  }
  double variance(std::size_t l) const { return m_filter.variance(l); }
  template <class FT>
  void operator()(std::size_t l, const FT* in, FT* out) const
  {
    m_filter(l, in, out);
  }

private:
  Filter m_filter;
};

// The weights of the two terms, from the formulas.
struct Weights
{
  double space, time;
};
Weights weights(const Amf::Central_difference_of_gaussians&, const Row& s, const Row& u, const Levels& levels,
                std::size_t k, std::size_t l)
{
  const double s_hat = s[k] / (levels.unit_length * levels.unit_length);
  const double u_hat = u[l] / (levels.unit_time * levels.unit_time);
  return {std::pow(u_hat, 0.25) * 2 / std::log(s[k + 1] / s[k - 1]),
          std::sqrt(s_hat) * std::pow(u_hat, -0.25) * 2 / std::log(u[l + 1] / u[l - 1])};
}
Weights weights(const Amf::Forward_difference_of_gaussians&, const Row& s, const Row& u, const Levels& levels,
                std::size_t k, std::size_t l)
{
  const double sigma = std::sqrt(s[k]) / levels.unit_length, tau = std::sqrt(u[l]) / levels.unit_time;
  return {sigma * sigma * std::sqrt(tau), sigma * std::pow(tau, 1.5)};
}

// All responses.
template <class SpatialFilter, class TemporalFilter, class Response>
class Brute_force
{
  static constexpr std::size_t below = Response::below, above = Response::above;

public:
  Brute_force(const Rest_shape& shape, const Field& field, const Levels& levels, SpatialFilter spatial,
              TemporalFilter temporal, Response response)
    : m_shape(shape)
    , m_frames(field.number_of_frames())
    , m_space(levels.space.size())
    , m_time(levels.time.size())
  {
    initialize(shape, m_frames, levels, spatial, temporal, response);
    Row s, u;
    for (std::size_t k = 0; k < m_space; ++k) s.push_back(spatial.variance(k));
    for (std::size_t l = 0; l < m_time; ++l) u.push_back(temporal.variance(l));
    Amf::Default_visitor visitor;
    const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
    std::vector<Field> smoothed(m_space * m_time, Field(field.number_of_rows(), m_frames));
    // Space before time, as the engine does: a spatial filter may be linear up to single precision only.
    Field now = field, next(field.number_of_rows(), m_frames);
    for (std::size_t k = 0; k < m_space; ++k) {
      spatial(k, now, next, loop);
      now.swap(next);
      for (std::size_t l = 0; l < m_time; ++l)
        for (std::size_t v = 0; v < field.number_of_rows(); ++v)
          temporal(l, l > 0 ? smoothed[k * m_time + l - 1].row(v) : now.row(v), smoothed[k * m_time + l].row(v));
    }
    m_responses.assign(m_space * m_time, Field());
    m_weights.resize(m_space * m_time);
    for (std::size_t v = 0; v < field.number_of_rows(); ++v)
      for (std::size_t f = 0; f < m_frames; ++f) m_largest_value = (std::max)(m_largest_value, std::abs(field(v, f)));
    for (std::size_t k = below; k + above < m_space; ++k)
      for (std::size_t l = below; l + above < m_time; ++l) {
        const Weights w = m_weights[k * m_time + l] = weights(response, s, u, levels, k, l);
        Field& d = m_responses[k * m_time + l];
        d = Field(field.number_of_rows(), m_frames);
        for (std::size_t v = 0; v < field.number_of_rows(); ++v)
          for (std::size_t f = 0; f < m_frames; ++f) {
            d(v, f) = w.space * (smoothed[(k + above) * m_time + l](v, f) - smoothed[(k - below) * m_time + l](v, f)) +
                      w.time * (smoothed[k * m_time + l + above](v, f) - smoothed[k * m_time + l - below](v, f));
            m_largest = (std::max)(m_largest, std::abs(d(v, f)));
          }
      }
  }

  double response(std::size_t k, std::size_t l, std::size_t v, std::size_t f) const
  {
    return m_responses[k * m_time + l](v, f);
  }

  double largest() const { return m_largest; }

  // below which responses count as rounding
  double floor(std::size_t k, std::size_t l) const
  {
    const Weights& w = m_weights[k * m_time + l];
    return std::ldexp(1., -30) * (w.space + w.time) * m_largest_value;
  }

  // By how much a sample is below zero and all that it has to be below of.
  double margin(std::size_t k, std::size_t l, std::size_t v, std::size_t f) const
  {
    const double centre = response(k, l, v, f);
    double m = -centre;
    for (std::size_t kk = k - 1; kk <= k + 1; ++kk)
      for (std::size_t ll = l - 1; ll <= l + 1; ++ll)
        if (kk != k || ll != l) m = (std::min)(m, response(kk, ll, v, f) - centre);
    for (std::size_t ff = f - 1; ff <= f + 1; ++ff) {
      if (ff != f) m = (std::min)(m, response(k, l, v, ff) - centre);
      for (Rest_shape::Index w : m_shape.neighbours()[v]) m = (std::min)(m, response(k, l, w, ff) - centre);
    }
    return m;
  }

  // Compares with what was found, and returns the number of extrema. Samples that are within `rounding` (as a fraction of the
  // largest response) of being one or of not being one may be either.
  std::size_t check(const std::string& what, const std::vector<Extremum>& found, double rounding) const
  {
    typedef std::tuple<std::size_t, std::size_t, std::size_t, std::size_t> Sample;
    const double tolerance = rounding * m_largest;
    std::set<Sample> samples;
    double worst = 0;
    bool complete = true;
    for (const Extremum& e : found) {
      samples.emplace(e.k, e.l, e.vertex, e.frame);
      for (int dk = -1; dk <= 1; ++dk)
        for (int dl = -1; dl <= 1; ++dl)
          for (int df = -1; df <= 1; ++df)
            worst = (std::max)(worst, std::abs(e.window[std::size_t(dk + 1)][std::size_t(dl + 1)][std::size_t(df + 1)] -
                                               response(std::size_t(int(e.k) + dk), std::size_t(int(e.l) + dl),
                                                        e.vertex, std::size_t(int(e.frame) + df))));
      const auto ring = m_shape.neighbours()[e.vertex];
      complete = complete && e.ring.size() == std::size_t(ring.size());
      for (std::size_t i = 0; i < e.ring.size(); ++i)
        worst = (std::max)(worst, std::abs(e.ring[i] - response(e.k, e.l, ring[std::ptrdiff_t(i)], e.frame)));
    }
    CHECK(samples.size() == found.size()); // none twice
    CHECK(complete);
    CHECK(worst <= tolerance);
    std::size_t expected = 0, missing = 0, wrong = 0, unclear = 0;
    for (std::size_t k = below + 1; k + above + 1 < m_space; ++k)
      for (std::size_t l = below + 1; l + above + 1 < m_time; ++l)
        for (std::size_t v = 0; v < m_shape.number_of_vertices(); ++v)
          for (std::size_t f = 1; f + 1 < m_frames; ++f) {
            const double m = (std::min)(margin(k, l, v, f), -response(k, l, v, f) - floor(k, l));
            const bool is_found = samples.erase(Sample(k, l, v, f)) > 0;
            expected += m > 0;
            unclear += std::abs(m) <= tolerance;
            missing += m > tolerance && !is_found;
            wrong += m < -tolerance && is_found;
          }
    // forward differences at small scales and boxes about as wide as the animation is long leave small responses, of
    // which float leaves more open
    const bool decided = unclear <= 2 + expected / (rounding < 1e-9 ? 50 : 2);
    if (missing > 0 || wrong > 0 || !samples.empty() || !decided)
      std::cerr << what << ": " << expected << " extrema, missing " << missing << ", wrong " << wrong
                << ", out of range " << samples.size() << ", unclear " << unclear << std::endl;
    CHECK(missing == 0);
    CHECK(wrong == 0);
    CHECK(samples.empty()); // outer scales, first and last frame
    CHECK(decided);
    return expected;
  }

private:
  const Rest_shape& m_shape;
  std::size_t m_frames, m_space, m_time;
  std::vector<Field> m_responses;
  std::vector<Weights> m_weights;
  double m_largest = 0, m_largest_value = 0;
};

// Border, several components, an isolated vertex.
Shape mixed_surface(Random& random)
{
  Shape s = irregular_square(9, random);
  Shape ball = sphere(2);
  ball.points = mapped(ball.points, [](const Vec& p) { return Vec(0.3 * p); });
  s.add(ball, Vec(2, 0, 0));
  s.points.emplace_back(0, 0, 1);
  return s;
}

Field noise(std::size_t n, std::size_t frames, Random& random)
{
  Field field(n, frames);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t f = 0; f < frames; ++f) field(v, f) = random() * random();
  return field;
}

template <class FT>
Amf::Spatio_temporal_field<FT> converted(const Field& field, double factor)
{
  Amf::Spatio_temporal_field<FT> result(field.number_of_rows(), field.number_of_frames());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) result(v, f) = FT(factor * field(v, f));
  return result;
}

// The same extrema, responses `factor` times as large up to an error.
bool same(const std::vector<Extremum>& a, const std::vector<Extremum>& b, double factor = 1, double error = 0)
{
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < a.size(); ++i) {
    equal = a[i].vertex == b[i].vertex && a[i].frame == b[i].frame && a[i].k == b[i].k && a[i].l == b[i].l &&
            a[i].ring.size() == b[i].ring.size();
    for (std::size_t j = 0; equal && j < a[i].ring.size(); ++j) equal = std::abs(factor * a[i].ring[j] - b[i].ring[j]) <= error;
    for (std::size_t j = 0; equal && j < 27; ++j)
      equal = std::abs(factor * a[i].window[j / 9][j / 3 % 3][j % 3] - b[i].window[j / 9][j / 3 % 3][j % 3]) <= error;
  }
  return equal;
}

template <class SpatialFilter, class TemporalFilter, class Response>
std::size_t check_case(const std::string& what, const Rest_shape& shape, const Field& field, const Levels& levels,
                       const SpatialFilter& spatial, const TemporalFilter& temporal, const Response& response)
{
  const Brute_force<SpatialFilter, TemporalFilter, Response> brute(shape, field, levels, spatial, temporal, response);
  const auto found = extrema_of(shape, field, levels, spatial, temporal, response);
  const std::size_t expected = brute.check(what, found, 1e-12);
  brute.check(what + ", float", extrema_of(shape, converted<float>(field, 1), levels, spatial, temporal, response),
              2e-7);
  // twice the field, twice the responses, to the last bit
  CHECK(same(found, extrema_of(shape, converted<double>(field, 2), levels, spatial, temporal, response), 2));
  for (const std::size_t threads : {1, 2, 3}) {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
    CHECK(same(found,
               extrema_of<double, CGAL::Parallel_if_available_tag>(shape, field, levels, spatial, temporal, response)));
    (void)threads;
  }
  // the same bits with every instruction set of this processor, every size of a batch, and by the way for any filter
  using Amf::internal::Instruction_set;
  for (const Instruction_set set : {Instruction_set::BASELINE, Instruction_set::AVX2, Instruction_set::AVX512})
    for (const std::size_t batch : {std::size_t(-1), std::size_t(1), std::size_t(3)}) {
      if (set > Amf::internal::widest_instruction_set()) continue;
      CHECK(same(found, extrema_of(shape, field, levels, spatial, temporal, response, {batch, set})));
    }
  // (whose matrix may be computed in another order)
  CHECK(same(found, extrema_of(shape, field, levels, spatial, Plain_filter<TemporalFilter>(temporal), response), 1,
             1e-12 * brute.largest()));
  return expected;
}

void test_against_brute_force()
{
  Random random(51);
  const Amf::Central_difference_of_gaussians central;
  const Amf::Forward_difference_of_gaussians forward;
  const Amf::Gaussian_temporal_filter gaussian;
  const Amf::Heat_diffusion_filter heat;
  const Amf::One_ring_average_filter ring(false);
  std::size_t total = 0;
  // 5 levels leave one at which extrema are found; the engine takes several batches for 20 and 30
  const std::pair<std::size_t, std::size_t> cases[] = {{3, 13}, {4, 5}, {5, 30}, {8, 6}, {17, 7}, {33, 20}, {60, 13}, {130, 6}};
  for (const auto& c : cases) {
    const std::size_t frames = c.first, space = c.second, time = 5 + frames / 8;
    const Rest_shape shape = rest_shape_of(mixed_surface(random));
    const Field field = noise(shape.number_of_vertices(), frames, random);
    const double h = shape.mean_edge_length();
    const double space_unit = ring.unit_variance(shape);
    const Levels ratio = levels_at_ratio(space, time, 0.1 * h * h, 1.25);
    const auto counts = [&](const auto& temporal, std::size_t first) {
      return levels_of_counts(space, time, first, space_unit, temporal.unit_variance(frames, frame_duration));
    };
    const std::string name =
        std::to_string(frames) + " frames, " + std::to_string(space) + " x " + std::to_string(time) + " levels, ";
    std::size_t n = 0;
    n += check_case(name + "heat, gaussian, central", shape, field, ratio, heat, gaussian, central);
    n += check_case(name + "heat, fitting boxes, central", shape, field, ratio, heat, Amf::Box_temporal_filter(),
                    central);
    n += check_case(name + "heat, gaussian, forward", shape, field, ratio, heat, gaussian, forward);
    const Amf::Box_temporal_filter box(3), even(4, Amf::Boundary_condition::TRUNCATE), wide(25), wide_even(24, Amf::Boundary_condition::REPLICATE);
    n += check_case(name + "ring, box, central", shape, field, counts(box, 1), ring, box, central);
    n += check_case(name + "ring, box, forward", shape, field, counts(box, 0), ring, box, forward);
    n += check_case(name + "ring, even box, forward", shape, field, counts(even, 0), ring, even, forward);
    n += check_case(name + "ring, gaussian, forward", shape, field, counts(gaussian, 0), ring, gaussian, forward);
    if (frames >= 8) {
      n += check_case(name + "ring, wide box, central", shape, field, counts(wide, 0), ring, wide, central);
      n += check_case(name + "ring, wide even box, forward", shape, field, counts(wide_even, 0), ring, wide_even, forward);
    }
    const Levels close = levels_at_ratio(space, time, 0.1 * h * h, 1.04); // in double precision
    n += check_case(name + "heat, gaussian, close levels", shape, field, close, heat, gaussian, central);
    std::cout << name << n << " extrema" << std::endl;
    CHECK(n > 0 || frames == 3);
    total += n;
  }
  CHECK(total > 1000);
}

// What varies by a ten-millionth of itself: more than what counts as zero, less than what single precision can tell, so
// that every vertex is searched in double.
void test_small_variations()
{
  Random random(55);
  const Rest_shape shape = rest_shape_of(mixed_surface(random));
  Field field = noise(shape.number_of_vertices(), 20, random);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) field(v, f) = 1 + 1e-7 * field(v, f);
  const Amf::One_ring_average_filter ring(false);
  const double h = shape.mean_edge_length(), space_unit = ring.unit_variance(shape);
  std::size_t total = 0;
  const auto check = [&](const std::string& what, const Levels& levels, const auto& temporal, const auto& response) {
    const Brute_force<Amf::One_ring_average_filter, std::decay_t<decltype(temporal)>, std::decay_t<decltype(response)>>
        brute(shape, field, levels, ring, temporal, response);
    // roundings of the field, as a share of the responses
    total += brute.check(what, extrema_of(shape, field, levels, ring, temporal, response), 1e-6);
  };
  const Amf::Box_temporal_filter box(3);
  const Amf::Gaussian_temporal_filter gaussian;
  check("small variations, equal steps", levels_of_counts(20, 9, 0, space_unit, box.unit_variance(20, frame_duration)), box,
        Amf::Forward_difference_of_gaussians());
  check("small variations, levels far apart", levels_at_ratio(7, 7, 2 * h * h, 2), gaussian,
        Amf::Central_difference_of_gaussians());
  CHECK(total > 100);
}

// Filters that do nothing but multiply by numbers which are exact in binary, so that ties are ties.
struct Multiplying_spatial_filter
{
  const Row* factors; // of level k, relative to the field
  template <class FT, class Loop>
  void operator()(std::size_t k, const Amf::Spatio_temporal_field<FT>& in, Amf::Spatio_temporal_field<FT>& out,
                  const Loop&)
  {
    const double factor = (*factors)[k] / (k > 0 ? (*factors)[k - 1] : 1);
    for (std::size_t v = 0; v < in.number_of_rows(); ++v)
      for (std::size_t f = 0; f < in.number_of_frames(); ++f) out(v, f) = FT(factor * in(v, f));
  }
};
struct Multiplying_temporal_filter
{
  const Row* factors;
  std::size_t frames;
  template <class FT>
  void operator()(std::size_t l, const FT* in, FT* out) const
  {
    const double factor = (*factors)[l] / (l > 0 ? (*factors)[l - 1] : 1);
    for (std::size_t f = 0; f < frames; ++f) out[f] = FT(factor * in[f]);
  }
};
struct Plain_central_difference
{
  static constexpr std::size_t below = 1, above = 1;
  double space_weight(std::size_t, std::size_t) const { return 1; }
  double time_weight(std::size_t, std::size_t) const { return 0; }
};

void test_ties()
{
  const Shape s = regular_plane(10, 10);
  const Rest_shape shape = rest_shape_of(s);
  const std::size_t frames = 9, centre = 5 * 11 + 5;
  // the response is the field times (space[k + 1] - space[k - 1]) * time[l]: 0, -8, 0 times 1, 2, 1
  Row space = {16, 16, 16, 8, 16}, time = {1, 1, 2, 1, 1};
  const auto number = [&](const Field& field) {
    const Multiplying_spatial_filter spatial = {&space};
    Multiplying_spatial_filter copy = spatial;
    const Multiplying_temporal_filter temporal = {&time, frames};
    const Plain_central_difference response;
    Amf::Difference_of_gaussians_minima search;
    search.join_equal = false;
    Amf::internal::Scale_space_engine<Multiplying_temporal_filter, Plain_central_difference,
                                      Amf::Difference_of_gaussians_minima>
        engine(shape, frames, 5, 5, temporal, response, search);
    Amf::Default_visitor visitor;
    return engine.run<CGAL::Sequential_tag>(field, copy, visitor).size();
  };
  Field field(s.points.size(), frames);
  CHECK(number(field) == 0); // zero
  for (std::size_t v = 0; v < s.points.size(); ++v)
    for (std::size_t f = 0; f < frames; ++f) field(v, f) = 3;
  CHECK(number(field) == 0); // constant
  field(centre, 4) = 5;
  CHECK(number(field) == 1); // a peak
  for (const std::size_t other :
       {std::size_t(shape.neighbours()[centre][0]), std::size_t(shape.neighbours()[centre][5])})
    for (const std::size_t f : {3, 4, 5}) {
      Field tied = field;
      tied(other, f) = 5;
      CHECK(number(tied) == 0); // two of the same height next to each other, in space or time
      tied(other, f) = std::nextafter(5., 0.);
      CHECK(number(tied) == 1);
      tied(other, f) = std::nextafter(5., 6.);
      CHECK(number(tied) == 1); // the other one
    }
  Field tied = field;
  tied(centre, 5) = 5;
  CHECK(number(tied) == 0);
  tied = field;
  tied(centre, 6) = 5;
  CHECK(number(tied) == 2); // two frames apart they are two
  tied = field;
  tied(centre, 0) = 6;
  CHECK(number(tied) == 1); // the first frame has no frame before it
  tied(centre, 1) = 6;
  CHECK(number(tied) == 1);
  // two levels of the same response
  space[4] = 8;
  CHECK(number(field) == 0);
  space[4] = 8 + std::ldexp(1., -30);
  CHECK(number(field) == 1);
  time[3] = 2;
  CHECK(number(field) == 0);
  time[3] = 2 - std::ldexp(1., -30);
  CHECK(number(field) == 1);
}

// What is flat up to rounding has extrema of the size of rounding at most.
void test_constant_fields()
{
  Random random(52);
  const Rest_shape shape = rest_shape_of(mixed_surface(random));
  const double h = shape.mean_edge_length();
  const Levels levels = levels_at_ratio(9, 8, 0.5 * h * h, std::sqrt(2.));
  std::size_t number = 0;
  double strongest = 0;
  for (const double constant : {0.1, 1., 1 / 3., 12345.6}) {
    Field field(shape.number_of_vertices(), 12);
    for (std::size_t v = 0; v < shape.number_of_vertices(); ++v)
      for (std::size_t f = 0; f < 12; ++f) field(v, f) = constant;
    const auto look = [&](const auto& spatial, const auto& temporal) {
      const auto found = extrema_of(shape, field, levels, spatial, temporal, Amf::Central_difference_of_gaussians());
      number += found.size();
      for (const Extremum& e : found) strongest = (std::max)(strongest, -e.response() / constant);
    };
    look(Amf::Heat_diffusion_filter(), Amf::Gaussian_temporal_filter());
    look(Amf::Heat_diffusion_filter(), Amf::Box_temporal_filter());
    look(Amf::One_ring_average_filter(), Amf::Gaussian_temporal_filter());
    look(Amf::One_ring_average_filter(), Amf::Box_temporal_filter());
  }
  std::cout << "constant fields: " << number << " extrema by rounding, response / constant up to " << strongest
            << std::endl;
  CHECK(strongest < 1e-13);
}

// The window of a quadratic with its minimum, of value `least`, at `x`.
Extremum quadratic_window(const Eigen::Vector3d& x, const Eigen::Matrix3d& hessian, double least)
{
  Extremum e;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int m = -1; m <= 1; ++m) {
        const Eigen::Vector3d d = Eigen::Vector3d(i, j, m) - x;
        e.window[std::size_t(i + 1)][std::size_t(j + 1)][std::size_t(m + 1)] = least + d.dot(hessian * d) / 2;
      }
  return e;
}

void test_refined_scales()
{
  Random random(53);
  for (int i = 0; i < 300; ++i) {
    Eigen::Matrix3d a;
    for (int j = 0; j < 9; ++j) a(j / 3, j % 3) = random(-1, 1);
    const Eigen::Matrix3d hessian = a * a.transpose() + 0.3 * Eigen::Matrix3d::Identity();
    const Vec x = random.vector(0.499);
    const Amf::internal::Refined_scales r = Amf::internal::refine_scales(quadratic_window(x, hessian, -2.5));
    CHECK((Vec(r.space_level, r.time_level, r.frame) - x).norm() < 1e-12);
    CHECK_NEAR(r.response, -2.5, 1e-12);
  }
  // without a minimum nearby each direction is on its own, and stays within half a step
  const Eigen::Vector3d diagonal(1, 2, 4);
  const Amf::internal::Refined_scales far =
      Amf::internal::refine_scales(quadratic_window(Vec(0.9, -0.7, 0.2), diagonal.asDiagonal(), -1));
  CHECK_NEAR(far.space_level, 0.5, 1e-12);
  CHECK_NEAR(far.time_level, -0.5, 1e-12);
  CHECK_NEAR(far.frame, 0.2, 1e-12);
  Eigen::Matrix3d saddle = diagonal.asDiagonal();
  saddle(0, 1) = saddle(1, 0) = 5;
  for (int i = 0; i < 100; ++i) {
    Extremum e = quadratic_window(random.vector(0.5), saddle, -1);
    const Amf::internal::Refined_scales r = Amf::internal::refine_scales(e);
    for (double offset : {r.space_level, r.time_level, r.frame}) CHECK(std::abs(offset) <= 0.5);
    CHECK(r.response <= e.response());
  }
  const Amf::internal::Refined_scales flat =
      Amf::internal::refine_scales(quadratic_window(Vec(0, 0, 0), Eigen::Matrix3d::Zero(), -1));
  CHECK(flat.space_level == 0 && flat.time_level == 0 && flat.frame == 0 && flat.response == -1);
}

void test_interpolated_scales()
{
  using Amf::internal::interpolated_scale;
  for (double offset : {-1., -0.5, -0.2, 0., 0.3, 0.5, 1.}) {
    CHECK_NEAR(interpolated_scale(2, 3, 4.5, offset), 3 * std::pow(1.5, offset), 1e-14);
    // quadratic in the logarithm: log = 0.2 + 0.7 x + 0.1 x^2
    const auto scale = [](double x) { return std::exp(0.2 + 0.7 * x + 0.1 * x * x); };
    CHECK_NEAR(interpolated_scale(scale(-1), scale(0), scale(1), offset), scale(offset), 1e-14);
    CHECK_NEAR(interpolated_scale(0, 3, 4.5, offset), 3 * std::pow(1.5, offset), 1e-14); // next to the unsmoothed level
  }
}

Vec position(const Rest_shape& shape, const Amf::internal::Refined_place& place)
{
  Vec p = Vec::Zero();
  for (std::size_t i = 0; i < 3; ++i) p += place.barycentric[i] * shape.points()[place.triangle[i]];
  return p;
}

bool is_place_at(const Rest_shape& shape, const Amf::internal::Refined_place& place, std::size_t v)
{
  double sum = 0;
  bool inside = true;
  for (double b : place.barycentric) {
    sum += b;
    inside = inside && b >= 0 && b <= 1;
  }
  std::array<std::size_t, 3> corners = place.triangle;
  std::sort(corners.begin(), corners.end());
  bool exists = false;
  for (Rest_shape::Index t : shape.incident_triangles()[v]) {
    std::array<std::size_t, 3> c = {{shape.triangles()[t][0], shape.triangles()[t][1], shape.triangles()[t][2]}};
    std::sort(c.begin(), c.end());
    exists = exists || c == corners;
  }
  return inside && std::abs(sum - 1) < 1e-12 && exists;
}

void test_refined_places()
{
  Random random(54);
  Shape s = irregular_square(12, random, 0.2);
  const Eigen::AngleAxisd turn = random.rotation();
  const Shape flat = s;
  s.points = mapped(s.points, [&](const Vec& p) { return Vec(turn * (100 * p) + Vec(5, 6, 7)); });
  s.points.emplace_back(0, 0, 0); // isolated
  const Rest_shape shape = rest_shape_of(s);
  std::size_t exact = 0, kept = 0, pulled = 0;
  for (std::size_t v = 0; v + 1 < s.points.size(); ++v) {
    const Vec origin = flat.points[v];
    const auto ring = shape.neighbours()[v];
    // a point in one of its triangles, nearer than half of the way to the opposite side, or farther
    const auto& t =
        shape.triangles()[shape.incident_triangles()[v]
                                                    [random.below(std::size_t(shape.incident_triangles()[v].size()))]];
    const bool near = v % 2 == 0;
    const double distance = near ? random(0.01, 0.49) : random(0.6, 2), share = random(0.05, 0.95);
    Vec middle = Vec::Zero();
    double weight = share;
    for (Rest_shape::Index c : t)
      if (c != v) {
        middle += distance * weight * (flat.points[c] - origin);
        weight = 1 - share;
      }
    Eigen::Matrix2d a;
    for (int j = 0; j < 4; ++j) a(j / 2, j % 2) = random(-1, 1);
    Eigen::Matrix2d hessian = a * a.transpose() + 0.3 * Eigen::Matrix2d::Identity();
    if (v % 7 == 0) hessian(0, 0) *= -1; // no minimum
    const auto value = [&](const Vec& p) {
      const Eigen::Vector2d d = (p - origin - middle).head<2>();
      return -1 + d.dot(hessian * d) / 2;
    };
    Extremum e;
    e.vertex = Rest_shape::Index(v);
    e.window[1][1][1] = value(origin);
    for (Rest_shape::Index w : ring) e.ring.push_back(value(flat.points[w]));
    const Amf::internal::Refined_place place = Amf::internal::refine_place(shape, e);
    CHECK(is_place_at(shape, place, v));
    const double off = (position(shape, place) - (turn * (100 * (origin + middle)) + Vec(5, 6, 7))).norm();
    if (ring.size() < 5 || v % 7 == 0) {
      ++kept;
      CHECK((position(shape, place) - s.points[v]).norm() < 1e-12);
    } else if (near) {
      ++exact;
      CHECK(off < 1e-6); // edges are 8 long
    } else {
      ++pulled;
      // in the right direction, half of the way to the opposite side
      const Vec d = position(shape, place) - s.points[v], m = turn * middle;
      CHECK(d.normalized().dot(m.normalized()) > 1 - 1e-9);
      CHECK_NEAR(*std::max_element(place.barycentric.begin(), place.barycentric.end()), 0.5, 1e-9);
    }
  }
  CHECK(exact > 40 && pulled > 40 && kept > 20);
  Extremum lonely;
  lonely.vertex = Rest_shape::Index(s.points.size() - 1);
  const Amf::internal::Refined_place place = Amf::internal::refine_place(shape, lonely);
  CHECK(position(shape, place) == s.points.back());
}

struct Plain_feature
{
  std::size_t vertex_index;
  double time, sigma, tau, strength;
};

// The lengths of shortest paths along edges, of all pairs of vertices.
std::vector<Row> all_path_lengths(const Rest_shape& shape)
{
  const std::size_t n = shape.number_of_vertices();
  std::vector<Row> length(n, Row(n, std::numeric_limits<double>::infinity()));
  for (std::size_t v = 0; v < n; ++v) length[v][v] = 0;
  for (const Rest_shape::Edge& e : shape.edges())
    length[e.source][e.target] = length[e.target][e.source] =
        (shape.points()[e.source] - shape.points()[e.target]).norm();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) length[i][j] = (std::min)(length[i][j], length[i][k] + length[k][j]);
  return length;
}

void test_suppression()
{
  Random random(55);
  const Rest_shape shape = rest_shape_of(mixed_surface(random));
  const std::size_t n = shape.number_of_vertices();
  const std::vector<Row> length = all_path_lengths(shape);
  for (const std::size_t count : {0, 1, 30, 600}) {
    std::vector<Plain_feature> features;
    for (std::size_t i = 0; i < count; ++i)
      features.push_back({random.below(n), random(0, 2), random.power(0.03, 0.4), random.power(0.03, 0.4), 1});
    const auto alike = [](double a, double b) { return (std::max)(a, b) <= 1.5 * (std::min)(a, b); };
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < count; ++i) {
      const Plain_feature& weak = features[i];
      bool dropped = false;
      for (std::size_t j : expected) {
        const Plain_feature& strong = features[j];
        dropped = dropped || (length[weak.vertex_index][strong.vertex_index] <= (std::max)(weak.sigma, strong.sigma) &&
                              std::abs(weak.time - strong.time) <= (std::max)(weak.tau, strong.tau) &&
                              alike(weak.sigma, strong.sigma) && alike(weak.tau, strong.tau));
      }
      if (!dropped) expected.push_back(i);
    }
    const std::vector<Plain_feature> kept = Amf::internal::suppress_non_maxima(shape, features);
    bool equal = kept.size() == expected.size();
    for (std::size_t i = 0; equal && i < kept.size(); ++i)
      equal = kept[i].vertex_index == features[expected[i]].vertex_index && kept[i].time == features[expected[i]].time;
    CHECK(equal);
    CHECK(count < 600 || (kept.size() > 20 && kept.size() < 580));
  }
}

// The cosine of two Gaussians along a line and in time, by sums.
double summed_overlap(const Plain_feature& a, const Plain_feature& b, double distance, double later)
{
  const auto cosine = [](double width_a, double width_b, double apart) {
    double ab = 0, aa = 0, bb = 0;
    const double step = (std::min)(width_a, width_b) / 8, end = 8 * (std::max)(width_a, width_b) + apart;
    for (double x = -end; x < end; x += step) {
      const double f = std::exp(-x * x / (2 * width_a * width_a));
      const double g = std::exp(-(x - apart) * (x - apart) / (2 * width_b * width_b));
      ab += f * g;
      aa += f * f;
      bb += g * g;
    }
    return ab / std::sqrt(aa * bb);
  };
  return cosine(a.sigma, b.sigma, distance) * cosine(a.tau, b.tau, later);
}

void test_overlapped()
{
  Random random(56);
  const Rest_shape shape = rest_shape_of(mixed_surface(random));
  const std::vector<Row> length = all_path_lengths(shape);
  const Plain_feature one = {0, 0.5, 0.1, 0.2, 1}, other = {0, 0.7, 0.25, 0.15, 1};
  CHECK(std::abs(Amf::internal::event_overlap(one, other, 0.17, 0.2) - summed_overlap(one, other, 0.17, 0.2)) < 1e-9);
  CHECK(std::abs(Amf::internal::event_overlap(one, one, 0, 0) - 1) < 1e-15);
  for (const double period : {0., 2.})
    for (const double least : {0., 0.1, 0.3}) {
      const Amf::internal::Time_difference between(period);
      std::vector<Plain_feature> features;
      for (std::size_t i = 0; i < 400; ++i)
        features.push_back({random.below(shape.number_of_vertices()), random(0, 2), random.power(0.03, 0.4),
                            random.power(0.03, 0.4), random.power(0.1, 2)});
      std::vector<std::size_t> order(features.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      const auto norm = [&](std::size_t i) {
        return features[i].strength * std::sqrt(features[i].sigma * features[i].tau);
      };
      std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return norm(i) > norm(j); });
      std::vector<std::size_t> expected;
      for (std::size_t i : order) {
        const Plain_feature& weak = features[i];
        bool dropped = false;
        for (std::size_t j : expected) {
          const Plain_feature& strong = features[j];
          const double distance = length[weak.vertex_index][strong.vertex_index], later = between(weak.time, strong.time);
          if (distance > 3 * (std::max)(weak.sigma, strong.sigma) || later > 3 * (std::max)(weak.tau, strong.tau)) continue;
          const double overlap = Amf::internal::event_overlap(weak, strong, distance, later);
          const double exponent = 1.5 / (std::max)(norm(i) / norm(j), 0.2);
          dropped = dropped || (overlap >= 0.03 && weak.strength * std::pow(1 - overlap, exponent) < least);
        }
        if (!dropped) expected.push_back(i);
      }
      std::sort(expected.begin(), expected.end());
      const auto kept = Amf::internal::Overlap_suppression<Plain_feature>(shape, features, between).kept(least);
      bool equal = kept.size() == expected.size();
      for (std::size_t i = 0; equal && i < kept.size(); ++i) equal = kept[i].time == features[expected[i]].time;
      CHECK(equal);
      CHECK(least > 0 ? kept.size() > 20 && kept.size() < 390 : kept.size() == features.size());
    }
}

int main()
{
  test_against_brute_force();
#ifndef ANIMATED_MESH_FEATURES_TEST_THREADS_ONLY
  test_small_variations();
  test_ties();
  test_constant_fields();
  test_refined_scales();
  test_interpolated_scales();
  test_refined_places();
  test_suppression();
  test_overlapped();
#endif
  return test_result();
}
