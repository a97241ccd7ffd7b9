// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The filters of the scale space against exact impulse responses, moments and dense matrices.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_cascade.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Window_sum.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/bessel.hpp>

#include <Eigen/Dense>

#include <limits>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Rest_shape Rest_shape;
typedef Amf::Spatio_temporal_field<double> Field;
typedef std::vector<double> Row;

const double frame_duration = 1. / 30; // seconds between frames

// Level `l` of a row.
template <class FT = double, class Filter>
std::vector<FT> smoothed(const Filter& filter, std::size_t levels, std::vector<FT> row)
{
  std::vector<FT> out(row.size());
  for (std::size_t l = 0; l < levels; ++l) {
    filter(l, row.data(), out.data());
    row.swap(out);
  }
  return row;
}

Row in_seconds(Row squared_frames)
{
  for (double& u : squared_frames) u *= frame_duration * frame_duration;
  return squared_frames;
}

Row random_row(std::size_t n, Random& random)
{
  Row row(n);
  for (double& x : row) x = random(-1, 3);
  return row;
}

double sum_of(const Row& row)
{
  double s = 0;
  for (double x : row) s += x;
  return s;
}

double largest_difference(const Row& a, const Row& b)
{
  double d = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i] - b[i]) <= d)) d = std::abs(a[i] - b[i]);
  return d;
}

// The response to an impulse far from both ends: sum 1, symmetric, falling to both sides, of the given variance (frames^2).
void check_impulse_response(const Row& response, double variance, double tolerance)
{
  const std::size_t middle = response.size() / 2;
  double moment = 0;
  bool falling = true, symmetric = true;
  for (std::size_t i = 0; i < response.size(); ++i) {
    const double d = double(i) - double(middle);
    moment += d * d * response[i];
  }
  for (std::size_t i = 0; i < middle; ++i) {
    falling = falling && response[middle + i] >= response[middle + i + 1] - 1e-15;
    symmetric = symmetric && std::abs(response[middle + i] - response[middle - i]) < 1e-14;
  }
  CHECK_NEAR(sum_of(response), 1, 1e-13);
  CHECK_NEAR(moment, variance, tolerance);
  CHECK(falling);
  CHECK(symmetric);
}

Row impulse(std::size_t n)
{
  Row row(n, 0);
  row[n / 2] = 1;
  return row;
}

void test_box_variances()
{
  const std::size_t n = 801;
  for (std::size_t w = 1; w <= 13; ++w) {
    const double width = double(w);
    const double unit = w % 2 == 1 ? (width * width - 1) / 12 : (width * width + 2) / 12;
    Amf::Box_temporal_filter filter(w);
    CHECK(filter.width() == w);
    CHECK_NEAR(filter.unit_variance(n, frame_duration) / (frame_duration * frame_duration), unit, 1e-12);
    if (w == 1) continue; // no smoothing
    filter.initialize(n, frame_duration, in_seconds({unit, 2 * unit, 2 * unit, 7 * unit}));
    std::size_t level = 0;
    for (double passes : {1., 2., 2., 7.}) {
      CHECK_NEAR(filter.variance(level) / (frame_duration * frame_duration), passes * unit, 1e-11);
      check_impulse_response(smoothed(filter, ++level, impulse(n)), passes * unit, 1e-10);
    }
    // a single pass is a plain mean: of w frames, or of w + 1 of which the ends count half
    const Row one = smoothed(filter, 1, impulse(n));
    for (std::size_t i = 0; i < n; ++i) {
      const double d = std::abs(double(i) - double(n / 2)), half = w % 2 == 1 ? (width - 1) / 2 : width / 2;
      const double expected = d > half ? 0 : d == half && w % 2 == 0 ? 0.5 / width : 1 / width;
      if (!(std::abs(one[i] - expected) < 1e-15)) CHECK(!"the box's own values");
    }
  }
  // boxes that fit the variance, whatever it is
  const Row variances = {0.01, 0.3, 0.3, 1, 2.5, 6, 6.0001, 50, 400};
  Amf::Box_temporal_filter filter;
  filter.initialize(n, frame_duration, in_seconds(variances));
  for (std::size_t l = 0; l < variances.size(); ++l) {
    CHECK_NEAR(filter.variance(l) / (frame_duration * frame_duration), variances[l], 1e-11 * variances[l]);
    check_impulse_response(smoothed(filter, l + 1, impulse(n)), variances[l], 1e-9 * (1 + variances[l]));
  }
  // three boxes of width w make a parabola at the centre, of height 3 / (4 w) with w^2 / 4 = variance: 0.94 of a Gaussian's
  filter.initialize(n, frame_duration, in_seconds({900}));
  CHECK_NEAR(smoothed(filter, 1, impulse(n))[n / 2], 0.375 / 30, 1e-5);
}

const Amf::Boundary_condition all_ends[] = {Amf::Boundary_condition::REFLECT, Amf::Boundary_condition::REPLICATE,
                                            Amf::Boundary_condition::TRUNCATE, Amf::Boundary_condition::PERIODIC};

// The value of frame f beyond the ends of a row, by walking back and forth or round.
double beyond(const Row& row, long f, Amf::Boundary_condition ends, bool& exists)
{
  const long n = long(row.size());
  exists = true;
  if (ends == Amf::Boundary_condition::REPLICATE) return row[std::size_t(std::max(0L, std::min(n - 1, f)))];
  if (ends == Amf::Boundary_condition::REFLECT) {
    while (f < 0 || f >= n) f = f < 0 ? -1 - f : 2 * n - 1 - f;
    return row[std::size_t(f)];
  }
  if (ends == Amf::Boundary_condition::PERIODIC) return row[std::size_t((f % n + n) % n)];
  exists = f >= 0 && f < n;
  return exists ? row[std::size_t(f)] : 0;
}

void test_box_ends()
{
  Random random(31);
  for (std::size_t n : {3, 4, 7, 20})
    for (std::size_t w : {2, 3, 4, 5, 8, 11, 17})
      for (const Amf::Boundary_condition ends : all_ends) {
        Amf::Box_temporal_filter filter(w, ends);
        const double unit = filter.unit_variance(n, frame_duration);
        filter.initialize(n, frame_duration, {unit, 3 * unit});
        const Row row = random_row(n, random);
        Row expected = row;
        for (int pass = 0; pass < 3; ++pass) {
          const Row before = expected;
          for (long f = 0; f < long(n); ++f) {
            double sum = 0, total = 0;
            const long half = long(w / 2);
            for (long d = -half; d <= half; ++d) {
              const double weight = w % 2 == 0 && std::abs(d) == half ? 0.5 : 1;
              bool exists;
              const double value = beyond(before, f + d, ends, exists);
              sum += weight * value;
              total += exists ? weight : 0;
            }
            expected[std::size_t(f)] = sum / total;
          }
        }
        CHECK(largest_difference(smoothed(filter, 2, row), expected) < 1e-13);
        CHECK(largest_difference(smoothed(filter, 2, Row(n, 0.3)), Row(n, 0.3)) < 1e-15);
        if (ends == Amf::Boundary_condition::REFLECT || ends == Amf::Boundary_condition::PERIODIC)
          CHECK_NEAR(sum_of(smoothed(filter, 2, row)), sum_of(row), 1e-12);
      }
  // the default is to reflect
  const Row row = random_row(9, random);
  Amf::Box_temporal_filter usual(5), reflecting(5, Amf::Boundary_condition::REFLECT);
  usual.initialize(9, frame_duration, {usual.unit_variance(9, frame_duration)});
  reflecting.initialize(9, frame_duration, {usual.unit_variance(9, frame_duration)});
  CHECK(smoothed(usual, 1, row) == smoothed(reflecting, 1, row));
}

// Rows as pairs of packs, smoothed with the instructions of a set.
struct Pair_loop
{
  const Amf::Box_temporal_filter& filter;
  const std::vector<Row>& rows; // 32 of them
  std::vector<Row> smoothed;

  template <std::size_t bytes>
  void run()
  {
    typedef Amf::internal::Pack<float, 16, bytes> L;
    const std::size_t n = rows.front().size();
    std::vector<Amf::internal::Pack_pair<L>> in(n), out(n);
    for (std::size_t f = 0; f < n; ++f) {
      float p[16], q[16];
      for (std::size_t i = 0; i < 16; ++i) {
        p[i] = float(rows[i][f]);
        q[i] = float(rows[16 + i][f]);
      }
      in[f] = {L::load(p), L::load(q)};
    }
    filter(1, in.data(), out.data());
    smoothed.assign(32, Row(n));
    for (std::size_t f = 0; f < n; ++f) {
      float p[16], q[16];
      out[f].p.store(p);
      out[f].q.store(q);
      for (std::size_t i = 0; i < 16; ++i) {
        smoothed[i][f] = p[i];
        smoothed[16 + i][f] = q[i];
      }
    }
  }
};

// What is computed for many rows at once, in single precision, against one row at a time.
void test_box_packs()
{
  Random random(33);
  const double largest = 3; // of a random row
  using Amf::internal::Instruction_set;
  for (Instruction_set set : {Instruction_set::BASELINE, Instruction_set::AVX2, Instruction_set::AVX512}) {
    if (set > Amf::internal::widest_instruction_set()) break;
    for (std::size_t n : {3, 4, 7, 20, 49})
      for (std::size_t w = 2; w <= 14; ++w)
        for (const Amf::Boundary_condition ends : all_ends) {
          Amf::Box_temporal_filter filter(w, ends);
          const double unit = filter.unit_variance(n, frame_duration);
          filter.initialize(n, frame_duration, {unit, 4 * unit}); // three passes from level to level
          std::vector<Row> rows;
          for (std::size_t i = 0; i < 32; ++i) rows.push_back(random_row(n, random));
          Pair_loop kernel = {filter, rows, {}};
          Amf::internal::run_vectorized<float>(set, kernel);
          double difference = 0;
          for (std::size_t i = 0; i < 32; ++i) {
            Row expected(n);
            filter(1, rows[i].data(), expected.data());
            difference = (std::max)(difference, largest_difference(kernel.smoothed[i], expected));
          }
          CHECK(difference < largest * Amf::internal::smoothing_error<float>()); // what the search counts on
        }
  }
}

// Sums of a stream, of numbers small enough to be added without rounding.
template <std::size_t width>
void test_window_sum()
{
  Random random(34);
  Amf::internal::Window_sum<double, width> sums(0);
  Row values;
  for (std::size_t i = 0; i < 60; ++i) {
    values.push_back(std::floor(random(-1000, 1000)));
    double expected = 0;
    for (std::size_t j = 0; j < (std::min)(width, values.size()); ++j) expected += values[i - j];
    CHECK(sums.push(values.back()) == expected);
  }
}

std::size_t number_of_extrema(const Row& row)
{
  std::size_t n = 0;
  for (std::size_t f = 1; f + 1 < row.size(); ++f) n += (row[f] - row[f - 1]) * (row[f + 1] - row[f]) < 0;
  return n;
}

void test_gaussian()
{
  Random random(32);
  for (std::size_t n : {3, 5, 8, 24, 48, 61})
    for (const double u : {0.01, 0.4, 1., 3.3, 20., 150.}) {
      Amf::Gaussian_temporal_filter filter;
      filter.initialize(n, frame_duration, in_seconds({u}));
      CHECK_NEAR(filter.variance(0) / (frame_duration * frame_duration), u, 1e-12 * u);
      // the discrete Gaussian exp(-u) I_m(u) on a line on which the row and its mirror image alternate
      const auto kernel = [&](long m) { return std::exp(-u) * boost::math::cyl_bessel_i(double(std::abs(m)), u); };
      const Row row = random_row(n, random);
      Row expected(n, 0);
      const long reach = 20 + long(12 * std::sqrt(u));
      for (long f = 0; f < long(n); ++f)
        for (long m = -reach; m <= reach; ++m) {
          bool exists;
          expected[std::size_t(f)] += kernel(m) * beyond(row, f + m, Amf::Boundary_condition::REFLECT, exists);
        }
      const Row direct = smoothed(filter, 1, row);
      CHECK(largest_difference(direct, expected) < 2e-13);
      CHECK_NEAR(sum_of(direct), sum_of(row), 1e-11);
      CHECK(largest_difference(smoothed(filter, 1, Row(n, 0.3)), Row(n, 0.3)) < 1e-13);
      // semigroup: by steps of any size, among them none
      filter.initialize(n, frame_duration, in_seconds({0.1 * u, 0.1 * u, 0.35 * u, 0.36 * u, u}));
      CHECK(largest_difference(smoothed(filter, 5, row), direct) < 1e-12);
      CHECK(largest_difference(smoothed(filter, 1, row), smoothed(filter, 2, row)) < 1e-14);
      std::size_t extrema = number_of_extrema(row);
      for (std::size_t l = 1; l <= 5; ++l) {
        const std::size_t now = number_of_extrema(smoothed(filter, l, row));
        CHECK(now <= extrema);
        extrema = now;
      }
    }
  Amf::Gaussian_temporal_filter filter;
  filter.initialize(401, frame_duration, in_seconds({2, 70}));
  check_impulse_response(smoothed(filter, 1, impulse(401)), 2, 1e-9);
  check_impulse_response(smoothed(filter, 2, impulse(401)), 70, 1e-9);
  CHECK_NEAR(filter.unit_variance(401, frame_duration) / (frame_duration * frame_duration), 2. / 3, 1e-12); // a box of three frames
}

template <class Filter>
void test_temporal_float(Filter filter)
{
  Random random(33);
  filter.initialize(50, frame_duration, in_seconds({1, 4, 16}));
  const Row row = random_row(50, random);
  const std::vector<float> rounded = smoothed<float>(filter, 3, std::vector<float>(row.begin(), row.end()));
  const double d = largest_difference(smoothed(filter, 3, row), Row(rounded.begin(), rounded.end()));
  CHECK(d > 0 && d < 1e-6);
}

// In single precision a level is made from few frames of the level before. Rows that change from frame to frame and waves
// of all lengths, through levels as close as the search takes them in single precision, and further apart.
void test_sparse_gaussian()
{
  Random random(35);
  const auto cosine = [](std::size_t n, double j) {
    Row row(n);
    for (std::size_t f = 0; f < n; ++f) row[f] = std::cos(boost::math::constants::pi<double>() * j * (double(f) + 0.5) / double(n));
    return row;
  };
  for (std::size_t n : {40, 300, 1000})
    for (const double ratio : {1.4, 1.5874, 2., 4., 30.}) {
      double largest_error = 0;
      Row variances = {0.3};
      while (variances.back() < double(n * n) / 40) variances.push_back(variances.back() * ratio);
      Amf::Gaussian_temporal_filter filter;
      filter.initialize(n, frame_duration, in_seconds(variances));
      std::vector<Row> rows = {random_row(n, random), random_row(n, random), Row(n, 1), impulse(n)};
      for (std::size_t j = 1; j < n; j += (std::max)(std::size_t(1), n / 60)) rows.push_back(cosine(n, double(j)));
      for (Row& row : rows) {
        double largest = 0;
        for (double& x : row) {
          x = double(float(x));
          largest = (std::max)(largest, std::abs(x));
        }
        std::vector<float> single(row.begin(), row.end());
        Row exact = row;
        for (std::size_t l = 0; l < variances.size(); ++l) {
          std::vector<float> next(n);
          Row next_exact(n);
          filter(l, single.data(), next.data());
          filter(l, exact.data(), next_exact.data());
          single.swap(next);
          exact.swap(next_exact);
          const double error = largest_difference(exact, Row(single.begin(), single.end())) / largest;
          largest_error = (std::max)(largest_error, error);
        }
      }
      std::cout << "Gaussian in float, " << n << " frames, " << variances.size() << " levels: error at most "
                << largest_error << " of the largest value" << std::endl;
      CHECK(largest_error > 0 && largest_error < Amf::internal::smoothing_error<float>()); // what the search counts on
    }
}

// The levels of a field.
template <class FT = double, class Tag = CGAL::Sequential_tag, class Filter>
std::vector<Amf::Spatio_temporal_field<FT>> levels_of(Filter& filter, const Rest_shape& shape, const Row& variances,
                                                      const Amf::Spatio_temporal_field<FT>& field)
{
  Amf::Default_visitor visitor;
  const Amf::Task_loop<Tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  filter.initialize(shape, variances, loop);
  std::vector<Amf::Spatio_temporal_field<FT>> levels;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    levels.emplace_back(field.number_of_rows(), field.number_of_frames());
    filter(k, k > 0 ? levels[k - 1] : field, levels[k], loop);
  }
  return levels;
}

template <class FT>
bool same_values(const Amf::Spatio_temporal_field<FT>& a, const Amf::Spatio_temporal_field<FT>& b)
{
  bool same = a.number_of_rows() == b.number_of_rows() && a.number_of_frames() == b.number_of_frames();
  for (std::size_t v = 0; same && v < a.number_of_rows(); ++v)
    for (std::size_t f = 0; f < a.number_of_frames(); ++f) same = same && a(v, f) == b(v, f);
  return same;
}

template <class A, class B>
double largest_difference(const Amf::Spatio_temporal_field<A>& a, const Amf::Spatio_temporal_field<B>& b)
{
  double d = 0;
  for (std::size_t v = 0; v < a.number_of_rows(); ++v)
    for (std::size_t f = 0; f < a.number_of_frames(); ++f)
      if (!(std::abs(double(a(v, f)) - double(b(v, f))) <= d)) d = std::abs(double(a(v, f)) - double(b(v, f)));
  return d;
}

// Squared coordinates, coordinates and 1 of planar points, as frames: smoothed, they are the moments of the weights with
// which a vertex takes its value.
Field monomials(const Points& points)
{
  Field field(points.size(), 5);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double x = points[v][0], y = points[v][1];
    const double values[] = {1, x, y, x * x, y * y};
    std::copy(values, values + 5, field.row(v));
  }
  return field;
}

// The mean over both axes of the second moment about the vertex.
double variance_at(const Field& moments, const Points& points, std::size_t v)
{
  const double x = points[v][0], y = points[v][1];
  const double* m = moments.row(v);
  return (m[3] - 2 * x * m[1] + x * x * m[0] + m[4] - 2 * y * m[2] + y * y * m[0]) / 2;
}

void test_one_ring_on_regular_plane()
{
  const double h = 0.5;
  const Shape s = regular_plane(40, 46, h);
  const Rest_shape shape = rest_shape_of(s);
  const double unit = 3 * h * h / 7;
  Amf::One_ring_average_filter filter;
  // added per vertex the mean is smaller: at the border the rings are
  CHECK(filter.unit_variance(shape) < unit && filter.unit_variance(shape) > 0.95 * unit);
  const double u = filter.unit_variance(shape);
  const std::size_t middle = 23 * 41 + 20;
  Field impulse(s.points.size(), 3);
  impulse(middle, 1) = 1;
  const Row counts = {0, 1, 2, 5, 5, 14};
  Row variances;
  for (double c : counts) variances.push_back(c * u);
  const auto levels = levels_of(filter, shape, variances, impulse);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    CHECK(double(filter.count(k)) == counts[k]);
    CHECK_NEAR(filter.variance(k), counts[k] * u, 1e-12);
    CHECK_NEAR(filter.variance(k, middle), counts[k] * unit, 1e-6 * counts[k]);
    double sum = 0, xx = 0, xy = 0, yy = 0;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      const Vec d = s.points[v] - s.points[middle];
      const double value = levels[k](v, 1);
      sum += value;
      xx += value * d[0] * d[0];
      xy += value * d[0] * d[1];
      yy += value * d[1] * d[1];
      if (levels[k](v, 0) != 0 || levels[k](v, 2) != 0) CHECK(!"frames are apart");
    }
    CHECK_NEAR(sum, 1, 1e-13);
    CHECK_NEAR(xx, counts[k] * unit, 1e-12);
    CHECK_NEAR(yy, counts[k] * unit, 1e-12);
    CHECK_NEAR(xy, 0, 1e-12);
  }
  // levels that are asked for too closely get counts of their own; equal ones share theirs
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  filter.initialize(shape, {0.2 * u, 1.1 * u, 1.2 * u, 1.3 * u, 1.3 * u, 6.4 * u}, loop);
  const std::size_t expected[] = {0, 1, 2, 3, 3, 6};
  for (std::size_t k = 0; k < 6; ++k) CHECK(filter.count(k) == expected[k]);
  Amf::One_ring_average_filter plain(false);
  plain.initialize(shape, {u, 3 * u}, loop);
  CHECK(plain.variance(1, middle) == plain.variance(1) && plain.variance(1, 0) == plain.variance(1));
}

// A sector of a ring meshed at random, at its inner side eight times as densely (triangles per area) as at its outer one, which
// is x = 1 to 2.83 at y = 0.
Shape graded_sector(int n, Random& random, double jitter = 0.3)
{
  Shape s = irregular_square(n, random, jitter);
  const double a = std::log(8.) / 2;
  s.points = mapped(s.points, [&](const Vec& p) {
    const double r = std::exp(a * p[0]), angle = a * (p[1] - 0.5);
    return Vec(r * std::cos(angle), r * std::sin(angle), 0);
  });
  return s;
}

// What the filter tells about its scale at a vertex, and what one number for all would tell, against the second moment of the
// weights with which the vertex takes its value. Later passes are told with the neglect of rings that are not centred.
void test_one_ring_scale_at_vertices(double jitter, double bound_of_median, double bound)
{
  Random random(34);
  const Shape s = graded_sector(40, random, jitter);
  const Rest_shape shape = rest_shape_of(s);
  Amf::One_ring_average_filter filter;
  const double u = filter.unit_variance(shape);
  const Row variances = {u, 4 * u, 16 * u};
  const auto levels = levels_of(filter, shape, variances, monomials(s.points));
  for (std::size_t k = 0; k < variances.size(); ++k) {
    Row told, constant;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      const Vec& p = s.points[v];
      if (!(p[0] > 1.3 && p[0] < 2.2 && std::abs(p[1]) < 0.25 * p[0])) continue; // the border is out of reach
      const double measured = variance_at(levels[k], s.points, v);
      told.push_back(std::abs(std::sqrt(filter.variance(k, v) / measured) - 1));
      constant.push_back(std::abs(std::sqrt(filter.variance(k) / measured) - 1));
    }
    CHECK(told.size() > 300);
    std::sort(told.begin(), told.end());
    std::sort(constant.begin(), constant.end());
    const double median = told[told.size() / 2], median_of_constant = constant[told.size() / 2];
    CHECK(median < (k == 0 ? 1e-6 : bound_of_median));
    CHECK(told.back() < (k == 0 ? 1e-6 : bound));
    CHECK(median < 0.8 * median_of_constant && told.back() < 0.4 * constant.back());
    std::cout << "one-ring averages on a graded mesh, jitter " << jitter << ", " << filter.count(k)
              << " passes: error of sigma, median " << median << ", at most " << told.back()
              << "; of one sigma for all " << median_of_constant << ", " << constant.back() << std::endl;
  }
}

void test_one_ring_pass()
{
  Random random(37);
  Shape s = irregular_square(12, random);
  s.add(sphere(1), Vec(3, 0, 0));
  s.points.emplace_back(0, 0, 9); // isolated
  const Rest_shape shape = rest_shape_of(s);
  Amf::One_ring_average_filter filter;
  const double u = filter.unit_variance(shape);
  Field noise(s.points.size(), 11);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    for (std::size_t f = 0; f < 11; ++f) noise(v, f) = random(-1, 1);
  const auto levels = levels_of(filter, shape, {0, u, u, 3 * u}, noise);
  CHECK(same_values(levels[0], noise));
  CHECK(same_values(levels[1], levels[2]));
  // the mean over the closed ring, from the faces alone
  std::vector<std::vector<std::size_t>> rings(s.points.size());
  for (const auto& t : s.faces)
    for (int a : t)
      for (int b : t) rings[std::size_t(a)].push_back(std::size_t(b));
  Field expected = noise;
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    std::vector<std::size_t>& ring = rings[v];
    ring.push_back(v);
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  }
  for (int pass = 1; pass <= 3; ++pass) {
    const Field before = expected;
    for (std::size_t v = 0; v < s.points.size(); ++v)
      for (std::size_t f = 0; f < 11; ++f) {
        double sum = 0;
        for (std::size_t w : rings[v]) sum += before(w, f);
        expected(v, f) = sum / double(rings[v].size());
      }
    if (pass == 1) CHECK(largest_difference(levels[1], expected) < 1e-15);
  }
  CHECK(largest_difference(levels[3], expected) < 1e-15);
}

struct Dense_heat
{
  Eigen::MatrixXd laplacian;
  Eigen::VectorXd mass;

  // cotangents by angles, from the faces alone
  explicit Dense_heat(const Shape& s)
  {
    const Eigen::Index n = Eigen::Index(s.points.size());
    laplacian = Eigen::MatrixXd::Zero(n, n);
    mass = Eigen::VectorXd::Zero(n);
    for (const auto& t : s.faces)
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = t[(i + 1) % 3], b = t[(i + 2) % 3];
        const Vec u = s.points[std::size_t(a)] - s.points[std::size_t(t[i])];
        const Vec w = s.points[std::size_t(b)] - s.points[std::size_t(t[i])];
        const double angle = std::atan2(u.cross(w).norm(), u.dot(w));
        const double c = 0.5 / std::tan(angle);
        laplacian(a, b) -= c;
        laplacian(b, a) -= c;
        laplacian(a, a) += c;
        laplacian(b, b) += c;
        mass[t[i]] += u.cross(w).norm() / 6;
      }
  }

  Eigen::MatrixXd step(double variance) const
  {
    const double root = std::sqrt(2.), t = variance / 2;
    const Eigen::MatrixXd m = mass.asDiagonal();
    const Eigen::MatrixXd b = (m + (1 - 1 / root) * t * laplacian).partialPivLu().solve(m);
    return (1 + root) * b * b - root * b;
  }
};

void test_heat_against_dense_matrices(const Row& variances, std::size_t levels_in_double)
{
  Random random(35);
  Shape s = irregular_square(9, random, 0.35);
  s.points = mapped(s.points, [](const Vec& p) { return Vec(p[0], p[1], 0.2 * std::sin(5 * p[0] + 3 * p[1])); });
  s.add(sphere(1), Vec(3, 0, 0));
  const Rest_shape shape = rest_shape_of(s);
  const std::size_t n = s.points.size(), frames = 11;
  Field field(n, frames);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(Eigen::Index(n), Eigen::Index(frames));
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t f = 0; f < frames; ++f) dense(Eigen::Index(v), Eigen::Index(f)) = field(v, f) = random(-1, 2);
  const Dense_heat heat(s);
  Amf::Heat_diffusion_filter filter;
  const auto levels = levels_of(filter, shape, variances, field);
  const Eigen::VectorXd total = dense.transpose() * heat.mass;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    CHECK(filter.variance(k) == variances[k] && filter.variance(k, 3) == variances[k]);
    const double step = variances[k] - (k > 0 ? variances[k - 1] : 0);
    if (step == 0) CHECK(same_values(levels[k], k > 0 ? levels[k - 1] : field));
    dense = heat.step(step) * dense;
    double worst = 0;
    Eigen::VectorXd now = Eigen::VectorXd::Zero(Eigen::Index(frames));
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t f = 0; f < frames; ++f) {
        worst = (std::max)(worst, std::abs(levels[k](v, f) - dense(Eigen::Index(v), Eigen::Index(f))));
        now[Eigen::Index(f)] += heat.mass[Eigen::Index(v)] * levels[k](v, f);
      }
    const double lost = (now - total).cwiseAbs().maxCoeff() / total.cwiseAbs().maxCoeff(); // heat is kept
    std::cout << "heat against dense matrices, level " << k << ": error " << worst << ", heat lost " << lost
              << std::endl;
    CHECK(worst < (k < levels_in_double ? 1e-12 : 4e-7));
    CHECK(lost < (k < levels_in_double ? 1e-12 : 5e-8));
  }
  // symmetric with respect to the masses: <a, S b> = <S a, b> for all pairs of frames
  const auto once = levels_of(filter, shape, {0.02}, field);
  double asymmetry = 0;
  for (std::size_t a = 0; a < frames; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      double left = 0, right = 0;
      for (std::size_t v = 0; v < n; ++v) {
        left += heat.mass[Eigen::Index(v)] * field(v, a) * once[0](v, b);
        right += heat.mass[Eigen::Index(v)] * once[0](v, a) * field(v, b);
      }
      asymmetry = (std::max)(asymmetry, std::abs(left - right));
    }
  CHECK(asymmetry < 1e-12);
  Field constant(n, 3);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t f = 0; f < 3; ++f) constant(v, f) = 0.7;
  for (const Field& level : levels_of(filter, shape, {0.001, 0.1, 0.2, 10}, constant))
    CHECK(same_values(level, constant));
  CHECK_NEAR(filter.unit_variance(shape), 3 * std::pow(shape.mean_edge_length(), 2) / 7, 1e-15);
  CHECK(filter.smallest_variance(shape) > 0 && filter.smallest_variance(shape) < filter.unit_variance(shape));
}

void test_heat_kernel()
{
  const Shape s = regular_plane(90, 104);
  const Rest_shape shape = rest_shape_of(s);
  const std::size_t middle = 52 * 91 + 45;
  Field impulse(s.points.size(), 3);
  impulse(middle, 0) = 1;
  Row variances; // as a detection has them: at ratio sqrt(2) in sigma, from half an edge
  for (int j = 0; j < 9; ++j) variances.push_back(0.25 * std::pow(2., j));
  Amf::Heat_diffusion_filter filter;
  const auto levels = levels_of(filter, shape, variances, impulse);
  const double mass = std::sqrt(0.75);
  for (std::size_t k = 0; k < variances.size(); ++k) {
    double sum = 0, xx = 0, yy = 0, off = 0;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      const Vec d = s.points[v] - s.points[middle];
      const double value = levels[k](v, 0);
      sum += value;
      xx += value * d[0] * d[0];
      yy += value * d[1] * d[1];
      off = (std::max)(
          off, std::abs(value - mass * std::exp(-d.squaredNorm() / (2 * variances[k])) / (2 * pi * variances[k])));
    }
    const double exact_peak = mass / (2 * pi * variances[k]);
    const double peak = levels[k](middle, 0) / exact_peak - 1, variance = (xx + yy) / (2 * variances[k]) - 1;
    CHECK_NEAR(sum, 1, 1e-5); // little reaches the border
    CHECK(std::abs(variance) < 1e-5);
    std::cout << "heat, sigma of " << std::sqrt(variances[k]) << " edges: error of variance " << variance
              << ", of peak " << peak << ", anywhere " << off / exact_peak << " of the peak" << std::endl;
    if (k >= 4) CHECK(off / exact_peak < 0.05); // an impulse is finer than the mesh; see blobs for what is not
  }
}

// A Gaussian blob, smoothed as a detection does it, has the height and the shape of a wider one. Returns the largest error, as
// a fraction of the height, at scales up to `reach` times that of the blob.
double error_of_blob(const Shape& s, const Vec& centre, double sigma, double reach)
{
  const Rest_shape shape = rest_shape_of(s);
  Field blob(s.points.size(), 3);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    blob(v, 1) = std::exp(-(s.points[v] - centre).squaredNorm() / (2 * sigma * sigma));
  Row variances;
  for (double x = 0.35 * shape.mean_edge_length(); x < reach * sigma; x *= std::sqrt(2.)) variances.push_back(x * x);
  Amf::Heat_diffusion_filter filter;
  const auto levels = levels_of(filter, shape, variances, blob);
  double worst = 0;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    const double total = sigma * sigma + variances[k], height = sigma * sigma / total;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      const double exact = height * std::exp(-(s.points[v] - centre).squaredNorm() / (2 * total));
      const double error = std::abs(levels[k](v, 1) - exact) / height;
      if (!(error <= worst)) worst = error;
    }
  }
  return worst;
}

void test_heat_of_blobs()
{
  Random random(36);
  const Shape regular = regular_plane(80, 92);
  const double to_its_scale = error_of_blob(regular, Vec(40, 40, 0), 4, 1.01);
  const double beyond_its_scale = error_of_blob(regular, Vec(40, 40, 0), 4, 1.5);
  CHECK(to_its_scale < 0.004);
  CHECK(beyond_its_scale < 0.015);
  // however the surface is meshed; what is left is what the mesh cannot show of the blob
  const Vec centre(0.5, 0.5, 0);
  const double coarse = error_of_blob(irregular_square(40, random), centre, 0.06, 1.5);
  const double fine = error_of_blob(irregular_square(80, random), centre, 0.06, 1.5);
  const double graded = error_of_blob(graded_sector(60, random), Vec(1.68, 0, 0), 0.12, 1.5);
  CHECK(coarse < 0.035);
  CHECK(fine < 0.016);
  CHECK(graded < 0.018);
  std::cout << "heat of a blob, error / height: regular mesh " << to_its_scale << ", beyond its scale "
            << beyond_its_scale << "; irregular meshes " << coarse << ", twice as fine " << fine << ", graded "
            << graded << std::endl;
}

// Vertices without triangles, or with none of any area, are in nobody's way.
template <class Filter>
void test_incomplete_meshes(Filter filter, bool keeps_degenerate)
{
  Random random(38);
  Shape s = irregular_square(8, random);
  const std::size_t n = s.points.size();
  s.points.emplace_back(0.5, 0.5, 0); // n: isolated
  const int o = int(n) + 1;
  s.points.insert(s.points.end(), {Vec(3, 0, 0), Vec(4, 0, 0), Vec(5, 0, 0)}); // a triangle in a line
  s.faces.push_back({{o, o + 1, o + 2}});
  const auto f = s.faces[20]; // and one split on its edge
  s.points.push_back((s.points[std::size_t(f[0])] + s.points[std::size_t(f[1])]) / 2);
  s.faces[20] = {{f[1], f[2], o + 3}};
  s.faces.push_back({{f[2], f[0], o + 3}});
  s.faces.push_back({{f[0], f[1], o + 3}});
  const Rest_shape shape = rest_shape_of(s);
  Field noise(s.points.size(), 9);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    for (std::size_t i = 0; i < 9; ++i) noise(v, i) = random(-1, 1);
  const auto levels = levels_of(filter, shape, {0.02, 0.04, 0.1}, noise);
  bool finite = true, within = true;
  for (const Field& level : levels)
    for (std::size_t v = 0; v < s.points.size(); ++v)
      for (std::size_t i = 0; i < 9; ++i) {
        finite = finite && std::isfinite(level(v, i));
        within = within && std::abs(level(v, i)) < 1.2;
      }
  CHECK(finite);
  CHECK(within);
  double moved = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    moved = (std::max)(moved, std::abs(levels[2](n, i) - noise(n, i)));
    if (keeps_degenerate)
      for (std::size_t v = n + 1; v < n + 4; ++v) moved = (std::max)(moved, std::abs(levels[2](v, i) - noise(v, i)));
  }
  CHECK(moved < 1e-14);
}

// float, and any number of threads
template <class Filter>
void test_numbers_and_threads(const Filter& prototype, double bound)
{
  Random random(39);
  const Shape s = graded_sector(16, random);
  const Rest_shape shape = rest_shape_of(s);
  for (std::size_t frames : {3, 8, 17, 20}) {
    Field noise(s.points.size(), frames);
    Amf::Spatio_temporal_field<float> rounded(s.points.size(), frames);
    for (std::size_t v = 0; v < s.points.size(); ++v)
      for (std::size_t f = 0; f < frames; ++f) rounded(v, f) = float(noise(v, f) = random(-1, 2));
    const Row variances = {0.01, 0.02, 0.04, 0.08};
    Filter a = prototype, b = prototype, c = prototype, d = prototype;
    const auto sequential = levels_of(a, shape, variances, noise);
    const auto parallel = levels_of<double, CGAL::Parallel_if_available_tag>(b, shape, variances, noise);
    const auto single = levels_of(c, shape, variances, rounded);
    const auto single_parallel = levels_of<float, CGAL::Parallel_if_available_tag>(d, shape, variances, rounded);
    for (std::size_t k = 0; k < variances.size(); ++k) {
      CHECK(same_values(sequential[k], parallel[k]));
      CHECK(same_values(single[k], single_parallel[k]));
      const double difference = largest_difference(sequential[k], single[k]);
      CHECK(difference > 0 && difference < bound);
    }
  }
}

int main()
{
  test_box_variances();
  test_box_ends();
  test_box_packs();
  test_window_sum<1>();
  test_window_sum<2>();
  test_window_sum<3>();
  test_window_sum<7>();
  test_window_sum<10>();
  test_window_sum<12>();
  test_window_sum<23>();
  test_gaussian();
  test_temporal_float(Amf::Box_temporal_filter());
  test_temporal_float(Amf::Gaussian_temporal_filter());
  test_sparse_gaussian();
  test_one_ring_on_regular_plane();
  test_one_ring_scale_at_vertices(0, 0.06, 0.15);
  test_one_ring_scale_at_vertices(0.3, 0.1, 0.25);
  test_one_ring_pass();
  test_heat_against_dense_matrices({0, 0.003, 0.003, 0.03, 0.3}, 5); // steps large enough for double precision
  test_heat_against_dense_matrices({0, 0.003, 0.003, 0.01, 0.03, 0.08, 0.2, 0.5}, 3);
  test_heat_kernel();
  test_heat_of_blobs();
  test_incomplete_meshes(Amf::One_ring_average_filter(), false);
  test_incomplete_meshes(Amf::Heat_diffusion_filter(), true);
  test_numbers_and_threads(Amf::One_ring_average_filter(), 1e-6);
  test_numbers_and_threads(Amf::Heat_diffusion_filter(), 2e-6);
  return test_result();
}
