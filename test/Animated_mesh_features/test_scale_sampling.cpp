// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The levels of the scale space: the counts of the paper's Table 1, its names of scales, and levels of a fixed ratio.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_sampling.h>

#include <array>
#include <fstream>
#include <limits>

#ifndef ANIMATED_MESH_FEATURES_TEST_DATA
  #define ANIMATED_MESH_FEATURES_TEST_DATA ""
#endif

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Rest_shape Rest_shape;
typedef Amf::Scale_levels Scale_levels;

const double frame_duration = 1. / 30; // seconds between frames

// A spatial filter as far as samplings look at it.
struct Filter_of_limit
{
  double smallest;
  double unit_variance(const Rest_shape&) const { return 1; }
  double smallest_variance(const Rest_shape&) const { return smallest; }
};

// Two equilateral triangles with edges of length 1, at the ends of a diagonal of the given length.
Rest_shape two_triangles(double diagonal)
{
  Shape s = regular_plane(1, 1);
  s.points.pop_back();
  s.faces = {{{0, 1, 2}}};
  // the box of both is 1 by y by 0
  const double y = std::sqrt(diagonal * diagonal - 1) - std::sqrt(0.75);
  s.add(s, Vec(0, y, 0));
  const Rest_shape shape = rest_shape_of(s);
  CHECK_NEAR(shape.mean_edge_length(), 1, 1e-14);
  CHECK_NEAR(shape.bounding_box_diagonal(), diagonal, 1e-10);
  return shape;
}

Scale_levels published_levels(const Rest_shape& shape, std::size_t frames, std::size_t width)
{
  Amf::Every_smoothing_count sampling;
  sampling.box_width = width;
  return sampling(shape, frames, frame_duration, Amf::One_ring_average_filter(false), Amf::Box_temporal_filter(width));
}

void test_counts_of_table_1()
{
  const Rest_shape shape = two_triangles(100);
  struct
  {
    std::size_t frames, width, count;
  } const table[] = {{48, 8, 54},  {139, 16, 113}, {169, 20, 107}, {159, 20, 94},
                     {99, 16, 57}, {100, 10, 150}, {70, 8, 114}};
  for (const auto& row : table) {
    const Scale_levels levels = published_levels(shape, row.frames, row.width);
    CHECK(levels.time_variances.size() == row.count + 1); // and none
    CHECK(levels.time_variances.front() == 0);
    // the counts of the filter are those of the levels
    Amf::Box_temporal_filter filter(row.width);
    filter.initialize(row.frames, frame_duration, levels.time_variances);
    const double unit = filter.unit_variance(row.frames, frame_duration);
    for (std::size_t l = 0; l <= row.count; ++l)
      if (!(std::abs(filter.variance(l) - double(l) * unit) <= 1e-12 * double(l) * unit)) CHECK(!"l passes at level l");
  }
  // The paper's 100 for the cylinder (F = 40) is 6 (F/2)^2 / (w^2 - 1) for w = 5; by the formula it is 96.
  CHECK(published_levels(shape, 40, 5).time_variances.size() == 96 + 1);
  // a width that is not told is that of the filter's variance; odd boxes have their own
  Amf::Every_smoothing_count untold;
  CHECK(untold(shape, 40, frame_duration, Amf::One_ring_average_filter(false), Amf::Box_temporal_filter(5))
            .time_variances.size() == 96 + 1);
  CHECK(untold(shape, 40, frame_duration, Amf::One_ring_average_filter(false), Amf::Gaussian_temporal_filter())
            .time_variances.size() == 266 + 1); // three frames: floor(6 * 400 / 9)
  // own numbers
  untold.max_space_count = 5;
  untold.max_time_count = 7;
  const Scale_levels few =
      untold(shape, 40, frame_duration, Amf::One_ring_average_filter(false), Amf::Box_temporal_filter(5));
  CHECK(few.space_variances.size() == 6 && few.time_variances.size() == 8);
}

void test_counts_in_space()
{
  // floor(6 (0.03 D / h)^2): 77 from D / h = 119.4 on, 78 from 120.2 on
  const std::pair<double, std::size_t> counts[] = {{119.4, 76}, {119.5, 77}, {120.1, 77}, {120.2, 78},
                                                   {100, 54},   {200, 216},  {300, 486}};
  for (const auto& c : counts)
    CHECK(published_levels(two_triangles(c.first), 48, 8).space_variances.size() == c.second + 1);

  const std::string path = std::string(ANIMATED_MESH_FEATURES_TEST_DATA) + "/horse-gallop.obj";
  if (!std::ifstream(path)) {
    std::cout << "the horse of Table 1: SKIPPED, there is no " << path << std::endl;
    return;
  }
  const Amf::IO::Indexed_mesh mesh = Amf::IO::read_mesh(path);
  Shape s;
  for (const auto& p : mesh.points) s.points.emplace_back(p[0], p[1], p[2]);
  for (const auto& t : mesh.triangles) s.faces.push_back({{int(t[0]), int(t[1]), int(t[2])}});
  // the paper's table has 77: D / h is 120.4 in the first frame of the gallop, just beyond
  CHECK(published_levels(rest_shape_of(s), 48, 8).space_variances.size() == 78 + 1);
}

void test_names_of_scales()
{
  // on a plane far from whose border every ring is regular
  const double h = 0.021;
  const Rest_shape shape = rest_shape_of(regular_plane(100, 100, h));
  const std::size_t width = 8;
  Amf::Every_smoothing_count sampling;
  sampling.box_width = width;
  Amf::One_ring_average_filter spatial(false);
  const Scale_levels levels = sampling(shape, 48, frame_duration, spatial, Amf::Box_temporal_filter(width));
  CHECK_NEAR(levels.unit_length, h / 3.48, 1e-12);
  CHECK(levels.unit_time == frame_duration);
  for (std::size_t k = 0; k < levels.space_variances.size(); ++k) {
    CHECK_NEAR(levels.space_variances[k], double(k) * spatial.unit_variance(shape), 1e-15);
    // Eq. (7), with the edge in the unit of which it has 3.48
    const double named = levels.sigma_factor * std::sqrt(levels.space_variances[k]) / levels.unit_length;
    CHECK_NEAR(named, std::sqrt(double(k) * (3.48 * 3.48 - 1) / 12), 1e-12);
  }
  CHECK_NEAR(levels.sigma_factor, 0.42, 0.005); // of the true standard deviation
  for (std::size_t l = 0; l < levels.time_variances.size(); ++l)
    CHECK_NEAR(levels.tau_factor * std::sqrt(levels.time_variances[l]) / frame_duration,
               std::sqrt(double(l) * (double(width * width) - 1) / 12), 1e-12);
  // in another unit of length the same names, which the paper's formula as it stands would not give
  const Rest_shape larger = rest_shape_of(regular_plane(100, 100, 1000 * h));
  const Scale_levels other = sampling(larger, 48, frame_duration, spatial, Amf::Box_temporal_filter(width));
  CHECK(other.space_variances.size() == levels.space_variances.size());
  CHECK_NEAR(other.sigma_factor, levels.sigma_factor, 1e-12);
  CHECK_NEAR(other.unit_length, 1000 * levels.unit_length, 1e-9);
}

void test_too_few_counts()
{
  CHECK_THROWS(Amf::Option_error, published_levels(two_triangles(20), 48, 8), "in space");
  CHECK(Amf::Every_smoothing_count::largest_count(100) == 60000);
  CHECK_THROWS(Amf::Option_error, Amf::Every_smoothing_count::largest_count(1e200), "smoothing counts");
  CHECK_THROWS(Amf::Option_error, published_levels(two_triangles(100), 48, 40), "in time");
  CHECK_THROWS(Amf::Option_error, published_levels(two_triangles(100), 48, 1), "box of one frame");
}

// Levels at `range.min` times powers of the ratio, two below and two above those at which features are found.
void check_levels(const std::vector<double>& variances, const Amf::Scale_range& range, double ratio, long first,
                  long last)
{
  CHECK(long(variances.size()) == last - first + 5);
  for (std::size_t i = 0; i < variances.size(); ++i)
    CHECK_NEAR(std::sqrt(variances[i]) / (range.min * std::pow(ratio, double(first - 2 + long(i)))), 1, 1e-12);
}

void test_fixed_ratio()
{
  const Rest_shape shape = two_triangles(100);
  const Filter_of_limit fine = {1e-12};
  const Amf::Gaussian_temporal_filter temporal;
  Amf::Fixed_ratio_sampling sampling;
  sampling.sigma = {2, 16};
  sampling.tau = {0.1, 0.5};
  sampling.sigma_ratio = std::sqrt(2.);
  sampling.tau_ratio = 2;
  Scale_levels levels = sampling(shape, 48, frame_duration, fine, temporal);
  check_levels(levels.space_variances, sampling.sigma, std::sqrt(2.), 0, 6);
  check_levels(levels.time_variances, sampling.tau, 2, 0, 2); // log2(5) = 2.3
  CHECK(levels.sigma_factor == 1 && levels.tau_factor == 1);
  // units of one's own
  sampling.unit_length = 3;
  sampling.unit_time = 0.2;
  levels = sampling(shape, 48, frame_duration, fine, temporal);
  CHECK(levels.unit_length == 3 && levels.unit_time == 0.2);
  // the same levels however the motion is sampled
  const Scale_levels twin = sampling(shape, 24, 2 * frame_duration, fine, temporal);
  CHECK(twin.time_variances == levels.time_variances && twin.space_variances == levels.space_variances);
  // a range of a single level
  sampling.sigma = {3, 3};
  check_levels(sampling(shape, 48, frame_duration, fine, temporal).space_variances, {3, 3}, std::sqrt(2.), 0, 0);
}

void test_default_ranges()
{
  Shape s = sphere(2);
  s.points = mapped(s.points, [](const Vec& p) { return Vec(50 * p); });
  const Rest_shape shape = rest_shape_of(s);
  const Filter_of_limit fine = {1e-12};
  const Amf::Gaussian_temporal_filter temporal;
  const Amf::Fixed_ratio_sampling sampling;
  const Scale_levels levels = sampling(shape, 48, frame_duration, fine, temporal);
  const double size = shape.diameter();
  const Amf::Scale_range sigma = {0.00495 * size, 0.175 * size}, tau = {frame_duration, 16 * frame_duration};
  check_levels(levels.space_variances, sigma, sampling.sigma_ratio, 0,
               std::lround(std::log(sigma.max / sigma.min) / std::log(sampling.sigma_ratio)));
  check_levels(levels.time_variances, tau, sampling.tau_ratio, 0,
               std::lround(std::log(16) / std::log(sampling.tau_ratio)));
  CHECK(levels.reported_sigma.min == sigma.min && levels.reported_sigma.max == sigma.max);
  CHECK(levels.reported_tau.contains(tau.min) && levels.reported_tau.contains(tau.max));
  CHECK(!levels.reported_tau.contains(0.99 * tau.min) && !levels.reported_tau.contains(1.01 * tau.max));
  // units that depend on neither range nor clip
  CHECK_NEAR(levels.unit_length, 0.05 * size, 1e-12 * size);
  CHECK(levels.unit_time == 0.1);
  // fewer frames than four have a single level, of one frame
  check_levels(sampling(shape, 3, frame_duration, fine, temporal).time_variances, tau, sampling.tau_ratio, 0, 0);
  // one bound of one's own
  Amf::Fixed_ratio_sampling upper;
  upper.sigma.max = 2 * sigma.min;
  check_levels(upper(shape, 48, frame_duration, fine, temporal).space_variances, sigma, upper.sigma_ratio, 0,
               std::lround(std::log(2) / std::log(upper.sigma_ratio)));
  // the unit of length does not show
  Shape small = s;
  small.points = mapped(s.points, [](const Vec& p) { return Vec(p / 1024); });
  const Scale_levels other = sampling(rest_shape_of(small), 48, frame_duration, fine, temporal);
  CHECK(other.space_variances.size() == levels.space_variances.size());
  CHECK_NEAR(other.space_variances.back() * 1024 * 1024 / levels.space_variances.back(), 1, 1e-12);
}

// What counts how much where ranges begin.
void test_fade()
{
  const Amf::Scale_fade fade = {2, 8};
  CHECK(fade(1) == 0 && fade(2) == 0 && fade(8) == 1 && fade(1e9) == 1);
  CHECK_NEAR(fade(4), 0.5, 1e-15);
  CHECK_NEAR(fade(2 * std::cbrt(4.)), 1. / 3, 1e-15);
  for (const Amf::Scale_fade& none : {Amf::Scale_fade(), Amf::Scale_fade{3, 3}, Amf::Scale_fade{3, 1}})
    CHECK(none(1e-300) == 1 && none(3) == 1 && none(1e300) == 1);

  const Rest_shape shape = two_triangles(100);
  const Amf::Gaussian_temporal_filter temporal;
  const auto fades = [&](const Amf::Fixed_ratio_sampling& sampling, double smallest_variance) {
    const Scale_levels levels = sampling(shape, 48, frame_duration, Filter_of_limit{smallest_variance}, temporal);
    return std::array<double, 4>{
        {levels.sigma_fade.from, levels.sigma_fade.full, levels.tau_fade.from, levels.tau_fade.full}};
  };
  Amf::Fixed_ratio_sampling sampling;
  sampling.sigma = {1, 32};
  sampling.unit_length = 20;
  sampling.tau = {0.04, 0.5};
  std::array<double, 4> f = fades(sampling, 1e-9);
  const std::array<double, 4> expected = {{1, 1.6, 0.04, 0.08}};
  for (std::size_t i = 0; i < 4; ++i) CHECK_NEAR(f[i], expected[i], 1e-12);
  // on a coarse mesh from half a level below the first one: 2 sqrt(3) is resolved, 4 is the first level above
  f = fades(sampling, 3);
  CHECK_NEAR(f[0], 4 / std::pow(2, 0.25), 1e-12);
  CHECK_NEAR(f[1], 1.6 * f[0], 1e-12);
  // the upper half of a short range counts in full; so does all of a single level
  sampling.tau = {0.04, 0.08};
  f = fades(sampling, 1e-9);
  CHECK_NEAR(f[3], 0.04 * std::sqrt(2.), 1e-12);
  sampling.tau = {0.04, 0.04};
  f = fades(sampling, 1e-9);
  CHECK(Amf::Scale_fade({f[2], f[3]})(0.04) == 1);
  // what is as large as an ankle counts in full, however coarse the mesh is, or takes as long as a quick movement
  sampling.unit_length = 3;
  CHECK_NEAR(fades(sampling, 1e-9)[1], 1.2, 1e-12);
  sampling.unit_length = 2;
  f = fades(sampling, 1e-9);
  CHECK(f[0] == f[1]);
  sampling.unit_length = 20;
  sampling.tau = {0.1, 0.5};
  f = fades(sampling, 1e-9);
  CHECK_NEAR(f[3], 0.12, 1e-12);
  sampling.tau = {0.13, 0.5};
  f = fades(sampling, 1e-9);
  CHECK(f[2] == f[3]);
  sampling.unit_time = 1;
  f = fades(sampling, 1e-9);
  CHECK_NEAR(f[3], sampling.tau.min * 1.9611613513818404, 1e-9); // sqrt(0.5 / 0.13), the middle of the range
  sampling.unit_time = 0.1;
  // none
  sampling.sigma_fade = sampling.tau_fade = 1;
  f = fades(sampling, 1e-9);
  CHECK(f[0] == f[1] && f[2] == f[3]);
  for (double* factor : {&sampling.sigma_fade, &sampling.tau_fade}) {
    for (double bad : {0.99, -1., std::numeric_limits<double>::quiet_NaN()}) {
      *factor = bad;
      CHECK_THROWS(Amf::Option_error, fades(sampling, 1e-9), "at least 1");
    }
    *factor = 1;
  }
  // the paper knows of none
  CHECK(published_levels(shape, 48, 8).sigma_fade(1e-9) == 1 && published_levels(shape, 48, 8).tau_fade(1e-9) == 1);
}

void test_resolution_of_the_mesh()
{
  const Rest_shape shape = two_triangles(100);
  const Amf::Gaussian_temporal_filter temporal;
  Amf::Fixed_ratio_sampling sampling;
  sampling.sigma = {1, 32};
  sampling.tau = {0.1, 0.5};
  const Scale_levels all = sampling(shape, 48, frame_duration, Filter_of_limit{1e-9}, temporal);
  const long last = std::lround(std::log(32) / std::log(sampling.sigma_ratio));
  check_levels(all.space_variances, sampling.sigma, sampling.sigma_ratio, 0, last);
  for (const double smallest : {0.26, 0.5, 0.99, 3., 17.}) {
    const Scale_levels some = sampling(shape, 48, frame_duration, Filter_of_limit{smallest}, temporal);
    const std::size_t cut = all.space_variances.size() - some.space_variances.size();
    CHECK(cut > 0 && cut < all.space_variances.size());
    // those that remain stay where they were, to the last bit, and none that would do is left out
    CHECK(
        std::equal(some.space_variances.begin(), some.space_variances.end(), all.space_variances.begin() + long(cut)));
    CHECK(some.space_variances.front() >= smallest * (1 - 1e-9)); // a level that is at the limit but for rounding
    CHECK(all.space_variances[cut - 1] < smallest * (1 - 1e-9));
    CHECK(some.unit_length == all.unit_length); // a response means the same on both
    CHECK(some.time_variances == all.time_variances);
  }
  // exactly at the limit nothing is cut
  const Scale_levels at = sampling(shape, 48, frame_duration, Filter_of_limit{all.space_variances.front()}, temporal);
  CHECK(at.space_variances == all.space_variances);
  CHECK_THROWS(Amf::Option_error, sampling(shape, 48, frame_duration, Filter_of_limit{1000}, temporal), "edge length");
}

void test_errors()
{
  const Rest_shape shape = two_triangles(100);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto levels = [&](const Amf::Fixed_ratio_sampling& sampling) {
    return sampling(shape, 48, frame_duration, Filter_of_limit{1e-9}, Amf::Gaussian_temporal_filter());
  };
  for (const Amf::Scale_range& range :
       {Amf::Scale_range{5, 4}, Amf::Scale_range{-1, 4}, Amf::Scale_range{1, -4}, Amf::Scale_range{nan, 4},
        Amf::Scale_range{1, nan}, Amf::Scale_range{1, infinity}}) {
    Amf::Fixed_ratio_sampling sampling;
    sampling.sigma = range;
    CHECK_THROWS(Amf::Option_error, levels(sampling), "sigma");
    sampling.sigma = Amf::Scale_range();
    sampling.tau = range;
    CHECK_THROWS(Amf::Option_error, levels(sampling), "tau");
  }
  // next to nothing, or beyond all: refused at once rather than computed for ever
  Amf::Fixed_ratio_sampling extreme;
  extreme.tau.max = 1e9;
  CHECK_THROWS(Amf::Option_error, levels(extreme), "the range of tau up to 1e+09 goes beyond 10 times the duration");
  extreme.tau = {1e-300, 0};
  CHECK_THROWS(Amf::Option_error, levels(extreme), "levels; at most 500 are made");
  extreme = Amf::Fixed_ratio_sampling();
  extreme.sigma.max = 1e300;
  CHECK_THROWS(Amf::Option_error, levels(extreme), "goes beyond 10 times the diameter of the rest shape");
  extreme = Amf::Fixed_ratio_sampling();
  extreme.tau_ratio = 1 + 1e-9;
  CHECK_THROWS(Amf::Option_error, levels(extreme), "levels; at most 500 are made");
  CHECK_THROWS(Amf::Option_error,
               extreme(shape, 48, frame_duration, Filter_of_limit{infinity}, Amf::Gaussian_temporal_filter()),
               "is not finite");
  CHECK_THROWS(Amf::Option_error, Amf::Every_smoothing_count::largest_count(infinity), "smoothing counts");
  CHECK_THROWS(Amf::Option_error, Amf::internal::number_of_passes(1, 0), "inf passes");
  CHECK_THROWS(Amf::Option_error, Amf::internal::number_of_passes(1e10, 1), "at most 1e+09 are made");
  CHECK(Amf::internal::number_of_passes(5, 2) == 3 && Amf::internal::number_of_passes(0, 2) == 0);
  for (const double ratio : {1., 0.5, 0., -2., nan}) {
    Amf::Fixed_ratio_sampling sampling;
    sampling.sigma_ratio = ratio;
    CHECK_THROWS(Amf::Option_error, levels(sampling), "ratio");
    sampling = Amf::Fixed_ratio_sampling();
    sampling.tau_ratio = ratio;
    CHECK_THROWS(Amf::Option_error, levels(sampling), "ratio");
  }
  // more levels than anybody can want, or than can be counted
  Amf::Fixed_ratio_sampling many;
  many.tau = {1e-300, 1};
  CHECK_THROWS(Amf::Option_error, levels(many), "the range of tau from 1e-300 to 1 has ");
  many.tau = Amf::Scale_range();
  many.sigma_ratio = 1.001;
  CHECK_THROWS(Amf::Option_error, levels(many), "levels; at most 500 are made");
}

int main()
{
  test_counts_of_table_1();
  test_counts_in_space();
  test_names_of_scales();
  test_too_few_counts();
  test_fixed_ratio();
  test_default_ranges();
  test_fade();
  test_resolution_of_the_mesh();
  test_errors();
  return test_result();
}
