// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of features against analytic values, invariances and plain forms of the same sums.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Detection/feature_fit.h>
#include <CGAL/Animated_mesh_features/Evaluation/Painting_scores.h>
#include <CGAL/Animated_mesh_features/Evaluation/Placed_feature.h>
#include <CGAL/Animated_mesh_features/Evaluation/Rig_events.h>
#include <CGAL/Animated_mesh_features/Evaluation/bootstrap_interval.h>
#include <CGAL/Animated_mesh_features/Evaluation/chance_level.h>
#include <CGAL/Animated_mesh_features/Evaluation/feature_regions.h>
#include <CGAL/Animated_mesh_features/Evaluation/map_scores.h>
#include <CGAL/Animated_mesh_features/Evaluation/matching_errors.h>
#include <CGAL/Animated_mesh_features/Evaluation/maximum_matching.h>
#include <CGAL/Animated_mesh_features/Evaluation/paired_features.h>
#include <CGAL/Animated_mesh_features/Evaluation/prominent_maxima.h>
#include <CGAL/Animated_mesh_features/Evaluation/repeated_features.h>

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Rest_shape Rest_shape;
typedef Amf::Feature_point Feature;
typedef Amf::Spatio_temporal_field<double> Field;

const double frame_duration = 1. / 25;

// ------------------------------------------------------------------------------------------------------------- the fit

// Shortest paths along edges by relaxing all edges until nothing changes.
std::vector<double> path_lengths(const Rest_shape& shape, std::size_t from)
{
  std::vector<double> d(shape.number_of_vertices(), std::numeric_limits<double>::infinity());
  d[from] = 0;
  for (bool changes = true; changes;) {
    changes = false;
    for (const Rest_shape::Edge& e : shape.edges()) {
      const double length = (shape.points()[e.source] - shape.points()[e.target]).norm();
      for (const auto& [a, b] : {std::make_pair(e.source, e.target), std::make_pair(e.target, e.source)})
        if (d[a] + length < d[b]) {
          d[b] = d[a] + length;
          changes = true;
        }
    }
  }
  return d;
}

Feature feature_at(std::size_t vertex, double time, double sigma, double tau, double strength = 1)
{
  Feature f;
  f.vertex_index = vertex;
  f.time = time;
  f.sigma = sigma;
  f.tau = tau;
  f.response = -strength;
  return f;
}

// a + b g, with the Gaussian g of a feature.
Field gaussian_field(const Rest_shape& shape, std::size_t frames, const Feature& f, double a, double b)
{
  const std::vector<double> d = path_lengths(shape, f.vertex_index);
  Field field(shape.number_of_vertices(), frames);
  for (std::size_t v = 0; v < d.size(); ++v)
    for (std::size_t m = 0; m < frames; ++m) {
      const double x = d[v] / f.sigma, t = (double(m) * frame_duration - f.time) / f.tau;
      field(v, m) = a + b * std::exp(-(x * x + t * t) / 2);
    }
  return field;
}

// The definition, sample by sample; of every `step`-th frame, counted from the one that is nearest to the feature.
double plain_fit(const Rest_shape& shape, const Field& field, const Feature& f, std::ptrdiff_t step = 1)
{
  double disc = 0;
  const std::ptrdiff_t nearest = std::ptrdiff_t(std::floor(f.time / frame_duration + 0.5));
  const std::vector<double> d = path_lengths(shape, f.vertex_index);
  std::vector<double> w, g, x;
  for (std::size_t v = 0; v < d.size(); ++v) {
    double area = 0;
    for (std::size_t i = 0; i < shape.triangles().size(); ++i)
      for (Rest_shape::Index corner : shape.triangles()[i]) area += corner == v ? shape.areas()[i] / 3 : 0;
    if (d[v] <= std::sqrt(2.) * f.sigma) disc += area;
    for (std::size_t m = 0; m < field.number_of_frames(); ++m) {
      const double t = double(m) * frame_duration - f.time;
      if (d[v] > 2.5 * f.sigma || std::abs(t) > 2.5 * f.tau || (std::ptrdiff_t(m) - nearest) % step != 0) continue;
      w.push_back(area);
      g.push_back(std::exp(-d[v] * d[v] / (2 * f.sigma * f.sigma) - t * t / (2 * f.tau * f.tau)));
      x.push_back(field(v, m));
    }
  }
  typedef Eigen::Map<Eigen::ArrayXd> Array;
  const Array W(w.data(), Eigen::Index(w.size()));
  Array G(g.data(), Eigen::Index(g.size())), X(x.data(), Eigen::Index(x.size()));
  G -= (W * G).sum() / W.sum();
  X -= (W * X).sum() / W.sum();
  const double share = std::min(1., disc / (pi * f.sigma * f.sigma)); // of half a disc
  return share * (W * G * X).sum() / std::sqrt((W * G * G).sum() * (W * X * X).sum());
}

void test_fit()
{
  Random random(1);
  const Rest_shape shape = rest_shape_of(irregular_square(12, random));
  const std::vector<double> areas = Amf::vertex_areas(shape);
  double total = 0;
  for (double a : areas) total += a;
  CHECK_NEAR(total, 1, 1e-12);

  const std::size_t middle = 6 * 13 + 6, frames = 20;
  const Feature f = feature_at(middle, 0.37, 0.15, 0.09);
  for (const double b : {2., -0.5}) // a Gaussian is its own best description, whatever its height and its foot
    for (const double a : {0., 3., -1e3})
      CHECK_NEAR(Amf::feature_fit(shape, areas, gaussian_field(shape, frames, f, a, b), frame_duration, f).fit,
                 b > 0 ? 1 : -1, 1e-9);
  for (const double constant : {0., 0.1, 1e10}) // whose mean is rounded
    CHECK(Amf::feature_fit(shape, areas, gaussian_field(shape, frames, f, constant, 0), frame_duration, f).fit == 0);

  Field noise(shape.number_of_vertices(), frames);
  for (std::size_t v = 0; v < shape.number_of_vertices(); ++v)
    for (std::size_t m = 0; m < frames; ++m) noise(v, m) = random(0, 1);
  Amf::Feature_fit_measure<double> measure(shape, areas, noise, frame_duration);
  for (int i = 0; i < 30; ++i) {
    const Feature g = feature_at(random.below(areas.size()), random(0, frames * frame_duration), random.power(.05, 1),
                                 random.power(.03, 1));
    CHECK_NEAR(measure(g).fit, plain_fit(shape, noise, g), 1e-12);
  }
  // slow ones: at least 256 frames of a tau
  const std::size_t long_row = 700;
  Field long_noise(shape.number_of_vertices(), long_row);
  for (std::size_t v = 0; v < shape.number_of_vertices(); ++v)
    for (std::size_t m = 0; m < long_row; ++m) long_noise(v, m) = random(0, 1);
  for (const double start : {0.1, 311.2, 699.}) // frames
    for (const std::ptrdiff_t step : {1, 3, 8}) {
      const Feature g = feature_at(middle, start * frame_duration, 0.15, (256 * double(step) + 100) * frame_duration);
      CHECK_NEAR(Amf::feature_fit(shape, areas, long_noise, frame_duration, g).fit, plain_fit(shape, long_noise, g, step),
                 1e-12);
      CHECK_NEAR(Amf::feature_fit(shape, areas, gaussian_field(shape, long_row, g, 1, 2), frame_duration, g).fit, 1, 1e-9);
    }
  // one vertex, one frame: nothing varies
  CHECK(measure(feature_at(middle, 10 * frame_duration, 1e-3, 1e-3)).fit == 0);
  // no frame at all
  CHECK(measure(feature_at(middle, 100, 0.1, 0.1)).fit == 0);

  CHECK_THROWS(Amf::Input_error, measure(feature_at(areas.size(), 0, 1, 1)), "vertex 169");
  CHECK_THROWS(Amf::Input_error, measure(feature_at(3, 0, 0, 1)), "must be positive");
  CHECK_THROWS(Amf::Input_error, measure(feature_at(3, 0, 1, -1)), "must be positive");
  CHECK_THROWS(Amf::Option_error, Amf::Feature_fit_measure<double>(shape, areas, Field(5, 3), 1), "5 rows");
  CHECK_THROWS(Amf::Option_error, Amf::Feature_fit_measure<double>(shape, areas, noise, 0), "between two frames");
}

// On equilateral triangles what is within a length of paths along edges is a hexagon of this circumradius: of
// sqrt(2) sigma, its area is 3 sqrt(3) sigma^2.
void test_area_ratio()
{
  const Rest_shape shape = rest_shape_of(regular_plane(80, 90));
  const std::vector<double> areas = Amf::vertex_areas(shape);
  const Field field(shape.number_of_vertices(), 3);
  const double sigma = 20.5 / std::sqrt(2.);
  const double ratio = Amf::feature_fit(shape, areas, field, 1., feature_at(45 * 81 + 40, 1, sigma, 1)).area_ratio;
  CHECK_NEAR(ratio, 3 * std::sqrt(3.) / (2 * pi), 0.02);
}

// A Gaussian whose disc is on the surface in part: the fit is less where it is less than a half of it.
void test_fit_of_parts()
{
  const std::size_t columns = 80;
  const Rest_shape shape = rest_shape_of(regular_plane(columns, 90));
  const std::vector<double> areas = Amf::vertex_areas(shape);
  const auto fit = [&](std::size_t vertex, double sigma) {
    const Feature f = feature_at(vertex, 10 * frame_duration, sigma, 3 * frame_duration);
    return Amf::feature_fit(shape, areas, gaussian_field(shape, 20, f, 0, 1), frame_duration, f);
  };
  CHECK_NEAR(fit(45 * (columns + 1) + 40, 5).fit, 1, 1e-9);
  const Amf::Feature_fit border = fit(40, 5), corner = fit(0, 5);
  CHECK(border.area_ratio > 0.38 && border.area_ratio < 0.5);
  CHECK_NEAR(border.fit, 2 * border.area_ratio, 1e-9);
  CHECK(corner.area_ratio < 0.35);
  CHECK_NEAR(corner.fit, 2 * corner.area_ratio, 1e-9);
  // a disc that takes in all of a strip, 2 sqrt(2) sigma by 2
  Shape strip = regular_plane(columns, 4);
  const Rest_shape narrow = rest_shape_of(strip);
  const Feature f = feature_at(2 * (columns + 1) + 40, 10 * frame_duration, 8, 3 * frame_duration);
  const std::vector<double> narrow_areas = Amf::vertex_areas(narrow);
  const Amf::Feature_fit part =
      Amf::feature_fit(narrow, narrow_areas, gaussian_field(narrow, 20, f, 0, 1), frame_duration, f);
  CHECK(part.area_ratio < 0.3);
  CHECK_NEAR(part.fit, 2 * part.area_ratio, 1e-9);
}

// ----------------------------------------------------------------------------------------------- samples and intervals

void test_bootstrap()
{
  CHECK(Amf::sample_mean({1, 2, 6}) == 3 && Amf::sample_mean({}) == 0);
  CHECK(Amf::sample_median({5, 1, 2}) == 2 && Amf::sample_median({4, 1, 2, 9}) == 3 && Amf::sample_median({}) == 0);

  // Of n throws of which a share p hits, the mean has the standard deviation sqrt(p (1 - p) / n).
  std::vector<double> sample(400, 0.);
  std::fill(sample.begin(), sample.begin() + 100, 1.);
  const double deviation = std::sqrt(0.25 * 0.75 / 400);
  Amf::Bootstrap_options options;
  options.resamples = 4000;
  for (const std::uint64_t seed : {1, 2, 3}) {
    options.seed = seed;
    const Amf::Interval i = Amf::bootstrap_interval(sample, options);
    CHECK_NEAR(i.low, 0.25 - 1.96 * deviation, 0.1 * deviation + 1. / 400);
    CHECK_NEAR(i.high, 0.25 + 1.96 * deviation, 0.1 * deviation + 1. / 400);
  }
  const Amf::Interval again = Amf::bootstrap_interval(sample, options), wide = Amf::bootstrap_interval(sample, options);
  CHECK(again.low == wide.low && again.high == wide.high);
  options.confidence = 0.5;
  const Amf::Interval narrow = Amf::bootstrap_interval(sample, options);
  CHECK(narrow.low > wide.low && narrow.high < wide.high && narrow.low < 0.25 && narrow.high > 0.25);

  const Amf::Interval constant = Amf::bootstrap_interval({7, 7, 7}, Amf::sample_median);
  CHECK(constant.low == 7 && constant.high == 7);
  CHECK(Amf::bootstrap_interval({}).high == 0);
  options.confidence = 1;
  CHECK_THROWS(Amf::Option_error, Amf::bootstrap_interval(sample, options), "confidence");
  options = Amf::Bootstrap_options();
  options.resamples = 0;
  CHECK_THROWS(Amf::Option_error, Amf::bootstrap_interval(sample, options), "resample");
}

void test_chance()
{
  // as many places as were asked for, among the vertices and within the duration; the mean of a constant is the constant
  std::size_t calls = 0;
  std::vector<std::size_t> counts(10, 0);
  double latest = 0, sum = 0;
  Amf::Chance_options options;
  const double level = Amf::chance_level(
      1000, 10, 8.,
      [&](const std::vector<Amf::Random_place>& places) {
        CHECK(places.size() == 1000);
        for (const Amf::Random_place& p : places) {
          ++counts.at(p.vertex);
          latest = std::max(latest, p.time);
          sum += p.time;
          CHECK(p.time >= 0 && p.time < 8);
        }
        return double(++calls);
      },
      options);
  CHECK(calls == 20);
  CHECK_NEAR(level, 10.5, 1e-12); // the mean of 1, ..., 20
  // of 20,000 numbers: five standard deviations
  for (std::size_t n : counts) CHECK_NEAR(double(n), 2000, 5 * std::sqrt(20000 * 0.1 * 0.9));
  CHECK_NEAR(sum / 20000, 4, 5 * 8 / std::sqrt(12. * 20000));
  CHECK(latest > 7.9);
  options.draws = 0;
  CHECK_THROWS(Amf::Option_error,
               Amf::chance_level(
                   1, 1, 1., [](const std::vector<Amf::Random_place>&) { return 0.; }, options),
               "draw");
}

// ------------------------------------------------------------------------------------------- features found once more

// The most pairs, by trying all partners of the first left that is not decided.
std::size_t most_pairs(const std::vector<std::vector<Amf::Compressed_rows::Index>>& partners, std::size_t left,
                       std::set<std::size_t>& taken)
{
  if (left == partners.size()) return 0;
  std::size_t most = most_pairs(partners, left + 1, taken);
  for (std::size_t right : partners[left]) {
    if (!taken.insert(right).second) continue;
    most = std::max(most, 1 + most_pairs(partners, left + 1, taken));
    taken.erase(right);
  }
  return most;
}

void test_maximum_matching()
{
  Random random(2);
  for (int i = 0; i < 400; ++i) {
    const std::size_t lefts = random.below(8), rights = random.below(8);
    const double density = random();
    std::vector<std::vector<Amf::Compressed_rows::Index>> partners(lefts);
    for (auto& row : partners)
      for (std::size_t r = 0; r < rights; ++r)
        if (random() < density) row.push_back(Amf::Compressed_rows::Index(r));
    std::set<std::size_t> taken;
    const std::size_t most = most_pairs(partners, 0, taken);
    const Amf::Bipartite_matching m = Amf::maximum_matching(
        Amf::Compressed_rows(std::vector<std::vector<Amf::Compressed_rows::Index>>(partners)), rights);
    CHECK(m.size == most);
    std::size_t pairs = 0;
    for (std::size_t l = 0; l < lefts; ++l) {
      const std::size_t r = m.right_of_left[l];
      if (r == Amf::Bipartite_matching::none) continue;
      ++pairs;
      CHECK(m.left_of_right[r] == l);
      CHECK(std::count(partners[l].begin(), partners[l].end(), r) == 1);
    }
    CHECK(pairs == most);
  }
  // a path through all elements, which has to be turned round as a whole
  const std::size_t n = 20000;
  Amf::Compressed_rows chain;
  for (std::size_t l = 0; l < n; ++l) {
    const Amf::Compressed_rows::Index two[] = {Amf::Compressed_rows::Index(l), Amf::Compressed_rows::Index(l - 1)};
    chain.push_back(two, two + (l == 0 ? 1 : 2));
  }
  CHECK(Amf::maximum_matching(chain, n).size == n);
  Amf::Compressed_rows other_way;
  for (std::size_t l = 0; l < n; ++l) {
    const Amf::Compressed_rows::Index two[] = {Amf::Compressed_rows::Index(l), Amf::Compressed_rows::Index(l + 1)};
    other_way.push_back(two, two + (l + 1 == n ? 1 : 2));
  }
  const Amf::Compressed_rows::Index first = 0;
  other_way.push_back(&first, &first + 1); // one left more than there are rights
  CHECK(Amf::maximum_matching(other_way, n).size == n);
}

Amf::Placed_feature placed(double x, double time, double sigma = 1, double tau = 1)
{
  return {Vec(x, 0, 0), time, sigma, tau};
}

void test_repeated_features()
{
  const Amf::Matching_gates gates = {1., 0.5, 2.};
  const std::vector<Amf::Placed_feature> a = {placed(0, 0), placed(10, 1), placed(20, 2), placed(30, 3)};
  // just within all gates; too far in space; too far in time; a near one of another size, and one of the same farther
  const std::vector<Amf::Placed_feature> b = {placed(1, 0.5, 2, 0.5), placed(11.01, 1), placed(20, 2.51),
                                              placed(30, 3, 2.01, 1), placed(30.9, 3.4)};
  Amf::Repeated_features r = Amf::repeated_features(a, b, 4, 5, gates);
  CHECK(r.in_place_and_time == std::vector<double>({1, 0, 0, 1}));
  CHECK(r.with_scales == std::vector<double>({1, 0, 0, 1}));
  r = Amf::repeated_features(a, b, 4, 4, gates); // without the last one
  CHECK(r.in_place_and_time == std::vector<double>({1, 0, 0, 1}));
  CHECK(r.with_scales == std::vector<double>({1, 0, 0, 0}));
  r = Amf::repeated_features(a, b, 1, 100, gates);
  CHECK(r.in_place_and_time == std::vector<double>({1}));
  CHECK(Amf::repeated_features(a, {}, 4, 4, gates).with_scales == std::vector<double>({0, 0, 0, 0}));
  CHECK(Amf::repeated_features({}, b, 4, 4, gates).with_scales.empty());

  const std::vector<Amf::Placed_feature> shifted = Amf::shifted_in_time(a, 2.5, 4);
  CHECK(shifted[0].time == 2.5 && shifted[1].time == 3.5 && shifted[2].time == 0.5 && shifted[3].time == 1.5);
  CHECK(Amf::shifted_in_time(a, -1, 4)[0].time == 3);
}

void test_paired_features()
{
  const Amf::Matching_gates gates = {1., 0.5, 1.5};
  // A crowd is found again by one feature, but paired with it once.
  const std::vector<Amf::Placed_feature> crowd = {placed(0, 0), placed(0.1, 0), placed(0.2, 0)}, one = {placed(0, 0)};
  CHECK(Amf::repeated_features(crowd, one, 9, 9, gates).in_place_and_time == std::vector<double>({1, 1, 1}));
  CHECK(Amf::paired_features(crowd, one, gates).in_place_and_time == std::vector<double>({1})); // of the shorter list
  CHECK(Amf::paired_features(one, crowd, gates).in_place_and_time == std::vector<double>({1}));
  // Taking the nearest first leaves one alone; an assignment does not.
  const std::vector<Amf::Placed_feature> x = {placed(0.9, 0), placed(2.1, 0)}, y = {placed(1.2, 0), placed(0, 0)};
  CHECK(Amf::paired_features(x, y, gates).in_place_and_time == std::vector<double>({1, 1}));
  // With scales the pairs are other ones.
  const std::vector<Amf::Placed_feature> u = {placed(0, 0, 1, 1), placed(0, 0, 9, 9)},
                                         v = {placed(0, 0, 9, 9), placed(0, 0, 1, 1), placed(0, 0, 5, 5)};
  CHECK(Amf::paired_features(u, v, gates).with_scales == std::vector<double>({1, 1}));
  CHECK(Amf::paired_features({}, v, gates).with_scales.empty());

  // Never more than are found again, and both ways the same number.
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    std::vector<Amf::Placed_feature> p, q;
    for (int k = 0; k < 12; ++k)
      p.push_back(placed(random(0, 8), random(0, 2), random.power(1, 3), random.power(1, 3)));
    for (int k = 0; k < 12; ++k)
      q.push_back(placed(random(0, 8), random(0, 2), random.power(1, 3), random.power(1, 3)));
    const Amf::Paired_features pq = Amf::paired_features(p, q, gates), qp = Amf::paired_features(q, p, gates);
    const Amf::Repeated_features found = Amf::repeated_features(p, q, 99, 99, gates);
    CHECK(Amf::sample_mean(pq.in_place_and_time) == Amf::sample_mean(qp.in_place_and_time));
    CHECK(Amf::sample_mean(pq.with_scales) == Amf::sample_mean(qp.with_scales));
    CHECK(Amf::sample_mean(pq.in_place_and_time) <= Amf::sample_mean(found.in_place_and_time));
    CHECK(Amf::sample_mean(pq.with_scales) <= Amf::sample_mean(pq.in_place_and_time));
  }
}

void test_matching_errors()
{
  Random random(4);
  Shape two = irregular_square(9, random);
  const std::size_t n = two.points.size();
  two.add(irregular_square(3, random), Vec(5, 0, 0));
  const Rest_shape shape = rest_shape_of(two);
  std::vector<Amf::Feature_on_shape> a, b;
  for (int i = 0; i < 30; ++i) a.push_back({Rest_shape::Index(random.below(two.points.size())), random(0, 3)});
  for (int i = 0; i < 6; ++i) b.push_back({Rest_shape::Index(random.below(n)), random(0, 3)}); // on the first part only
  const double gate = 0.4;
  const std::vector<double> any_time = Amf::matching_errors(shape, a, b),
                            timed = Amf::matching_errors(shape, a, b, gate);
  const std::vector<double> on_one_thread = Amf::matching_errors<CGAL::Sequential_tag>(shape, a, b, gate);
  std::size_t reached = 0, not_reached = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::vector<double> d = path_lengths(shape, a[i].vertex);
    double nearest = std::numeric_limits<double>::infinity(), nearest_in_time = nearest;
    for (const Amf::Feature_on_shape& f : b) {
      nearest = std::min(nearest, d[f.vertex]);
      if (std::abs(f.time - a[i].time) <= gate) nearest_in_time = std::min(nearest_in_time, d[f.vertex]);
    }
    const auto same = [](double x, double y) {
      return x == y || std::abs(x - y) < 1e-12;
    }; // also where both are infinite
    CHECK(same(any_time[i], nearest));
    CHECK(same(timed[i], nearest_in_time));
    CHECK(timed[i] == on_one_thread[i]);
    ++(std::isfinite(timed[i]) ? reached : not_reached);
  }
  CHECK(reached > 5 && not_reached > 5);
  CHECK_THROWS(Amf::Input_error, Amf::matching_errors(shape, a, {{Rest_shape::Index(9999), 0}}), "vertex 9999");
}

// ------------------------------------------------------------------------------------------------------- maps of regions

typedef Amf::Spatio_temporal_field<float> Map;

void test_feature_regions()
{
  Random random(5);
  const Rest_shape shape = rest_shape_of(irregular_square(9, random));
  const std::size_t n = shape.number_of_vertices(), frames = 12;
  std::vector<Feature> features;
  for (int i = 0; i < 4; ++i)
    features.push_back(
        feature_at(random.below(n), random(0, frames * frame_duration), random.power(.1, .3), random.power(.04, .2)));
  for (const auto course : {Amf::Region_course::PRESENT, Amf::Region_course::GAUSSIAN}) {
    const Map map = Amf::feature_regions(shape, frames, frame_duration, features, course);
    const Map sums = Amf::summed_over_frames(map);
    for (std::size_t v = 0; v < n; ++v) {
      double sum = 0;
      for (std::size_t m = 0; m < frames; ++m) {
        double most = 0;
        for (const Feature& f : features) {
          const double t = (double(m) * frame_duration - f.time) / f.tau;
          if (path_lengths(shape, v)[f.vertex_index] > f.sigma) continue;
          const double weight = course == Amf::Region_course::PRESENT ? (std::abs(t) <= 1 ? 1 : 0)
                                                                      : (std::abs(t) <= 3 ? std::exp(-t * t / 2) : 0);
          most = std::max(most, weight);
        }
        CHECK_NEAR(map(v, m), most, 1e-6);
        sum += most;
      }
      CHECK_NEAR(sums(v, 0), sum, 1e-5);
    }
  }
  const auto regions_of = [&](const Feature& f) {
    return Amf::feature_regions(shape, frames, 1., std::vector<Feature>{f}, Amf::Region_course::PRESENT);
  };
  CHECK_THROWS(Amf::Input_error, regions_of(feature_at(n, 0, 1, 1)), "no region");
  CHECK_THROWS(Amf::Input_error, regions_of(feature_at(0, 0, -1, 1)), "no region");
}

// All pairs of a marked and an unmarked sample.
double plain_auc(const Map& map, const Map& marks, const std::vector<double>& areas)
{
  double wins = 0, all = 0;
  const std::size_t frames = map.number_of_frames();
  for (std::size_t i = 0; i < areas.size() * frames; ++i)
    for (std::size_t k = 0; k < areas.size() * frames; ++k) {
      const double x = map(i / frames, i % frames), y = map(k / frames, k % frames);
      const double weight = areas[i / frames] * marks(i / frames, i % frames) * areas[k / frames] *
                            (1 - double(marks(k / frames, k % frames)));
      all += weight;
      wins += weight * (x > y ? 1 : x == y ? 0.5 : 0);
    }
  return wins / all;
}

Map random_map(std::size_t n, std::size_t frames, Random& random, double share_of_zeros, double steps)
{
  Map map(n, frames);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t m = 0; m < frames; ++m)
      map(v, m) = random() < share_of_zeros ? 0.f : float(std::ceil(random(0, steps)) / steps);
  return map;
}

void test_map_scores()
{
  Random random(6);
  const std::size_t n = 15, frames = 4;
  std::vector<double> areas;
  for (std::size_t v = 0; v < n; ++v) areas.push_back(random.power(.1, 10));
  for (int i = 0; i < 30; ++i) {
    const Map map = random_map(n, frames, random, 0.4, 6), marks = random_map(n, frames, random, 0.6, i % 2 ? 1 : 3);
    const Amf::Map_scores scores = Amf::map_scores(map, marks, areas);
    CHECK_NEAR(scores.auc, plain_auc(map, marks, areas), 1e-12);

    std::vector<double> w, x, y;
    Map rising(n, frames), stretched(n, frames);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t m = 0; m < frames; ++m) {
        w.push_back(areas[v]);
        x.push_back(map(v, m));
        y.push_back(marks(v, m));
        rising(v, m) = std::exp(map(v, m)); // without zeros
        stretched(v, m) = 2 * map(v, m) - 8;
      }
    typedef Eigen::Map<Eigen::ArrayXd> Array;
    Array W(w.data(), Eigen::Index(w.size())), X(x.data(), Eigen::Index(x.size())), Y(y.data(), Eigen::Index(y.size()));
    W /= W.sum();
    const double marked = (W * Y).sum();
    X -= (W * X).sum();
    X /= std::sqrt((W * X * X).sum());
    CHECK_NEAR(scores.nss, (W * X * Y).sum() / marked, 1e-9);
    Y -= marked;
    CHECK_NEAR(scores.correlation, (W * X * Y).sum() / std::sqrt((W * Y * Y).sum()), 1e-9);

    CHECK_NEAR(Amf::map_scores(rising, marks, areas).auc, scores.auc, 1e-12);
    const Amf::Map_scores of_stretched = Amf::map_scores(stretched, marks, areas);
    CHECK_NEAR(of_stretched.auc, scores.auc, 1e-12);
    CHECK_NEAR(of_stretched.nss, scores.nss, 1e-6);
    CHECK_NEAR(of_stretched.correlation, scores.correlation, 1e-6);
  }
  Map constant(n, frames), marks = random_map(n, frames, random, 0.5, 1);
  for (std::size_t v = 0; v < n; ++v) std::fill(constant.row(v), constant.row(v) + frames, 0.1f);
  const Amf::Map_scores none = Amf::map_scores(constant, marks, areas), all = Amf::map_scores(marks, marks, areas);
  CHECK(none.auc == 0.5 && none.nss == 0 && none.correlation == 0);
  CHECK_NEAR(all.auc, 1, 1e-12);
  CHECK_NEAR(all.correlation, 1, 1e-12);
  CHECK_THROWS(Amf::Input_error, Amf::map_scores(marks, Map(n, frames), areas), "nothing is marked");
  for (std::size_t v = 0; v < n; ++v) std::fill(constant.row(v), constant.row(v) + frames, 1.f);
  CHECK_THROWS(Amf::Input_error, Amf::map_scores(marks, constant, areas), "everything is marked");
  CHECK_THROWS(Amf::Option_error, Amf::map_scores(marks, Map(n, 2), areas), "same size");
}

void test_painting_scores()
{
  Random random(7);
  const std::size_t n = 12, frames = 3;
  const std::vector<double> areas(n, 2.);
  const Map map = random_map(n, frames, random, 0.2, 5);
  std::vector<Map> painted;
  for (int i = 0; i < 4; ++i) painted.push_back(random_map(n, frames, random, 0.5, 1));
  const Amf::Painting_scores scores(painted, areas);
  double auc = 0;
  for (const Map& p : painted) auc += plain_auc(map, p, areas) / 4;
  CHECK_NEAR(scores.mean(map).auc, auc, 1e-12);
  CHECK(scores(map).size() == 4 && scores.number_of_painters() == 4);

  // all the same: nobody is better than they are
  const Amf::Painting_scores same(std::vector<Map>(5, painted[0]), areas);
  CHECK_NEAR(same.split_half().auc, 1, 1e-12);
  CHECK_NEAR(same.split_half().correlation, 1, 1e-12);
  // of two painters each is the map of the other one
  const Amf::Painting_scores two({painted[0], painted[1]}, areas);
  CHECK_NEAR(two.split_half().auc,
             (plain_auc(painted[0], painted[1], areas) + plain_auc(painted[1], painted[0], areas)) / 2, 1e-12);
  CHECK(scores.split_half(3, 1).auc == scores.split_half(3, 1).auc);
  CHECK_THROWS(Amf::Option_error, Amf::Painting_scores({painted[0]}, areas).split_half(), "two or more");
  CHECK_THROWS(Amf::Option_error, Amf::Painting_scores({}, areas), "no painting");
}

// ------------------------------------------------------------------------------------------------- events of a skeleton

void test_prominent_maxima()
{
  Random random(8);
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> x;
    for (std::size_t k = random.below(16); k > 0; --k) x.push_back(double(random.below(5))); // with plateaus
    const double least = double(random.below(3));
    std::vector<Amf::Prominent_maximum> expected;
    for (std::size_t k = 0; k < x.size(); ++k) {
      // the plateau around k
      std::size_t first = k, last = k;
      while (first > 0 && x[first - 1] == x[k]) --first;
      while (last + 1 < x.size() && x[last + 1] == x[k]) ++last;
      if (k != (first + last) / 2 || first == 0 || last + 1 == x.size()) continue;
      if (x[first - 1] > x[k] || x[last + 1] > x[k]) continue;
      // the highest level at which it hangs together with what is higher, or with an end
      double saddle = -1;
      for (std::size_t j = 0; j < x.size(); ++j) {
        const std::size_t from = std::min(j, k), to = std::max(j, k);
        const bool is_end =
            (j < k ? std::all_of(x.begin(), x.begin() + std::ptrdiff_t(k), [&](double y) { return y <= x[k]; })
                   : std::all_of(x.begin() + std::ptrdiff_t(k), x.end(), [&](double y) { return y <= x[k]; })) &&
            (j == 0 || j + 1 == x.size());
        if (x[j] > x[k] || is_end)
          saddle =
              std::max(saddle, *std::min_element(x.begin() + std::ptrdiff_t(from), x.begin() + std::ptrdiff_t(to) + 1));
      }
      if (x[k] - saddle >= least) expected.push_back({k, x[k], x[k] - saddle});
    }
    const std::vector<Amf::Prominent_maximum> maxima = Amf::prominent_maxima(x, least);
    CHECK(maxima.size() == expected.size());
    for (std::size_t k = 0; k < std::min(maxima.size(), expected.size()); ++k) {
      CHECK(maxima[k].place == expected[k].place && maxima[k].value == expected[k].value);
      CHECK(maxima[k].prominence == expected[k].prominence);
    }
    found += maxima.size();
  }
  CHECK(found > 100);
}

void test_rig_events()
{
  Random random(9);
  const std::size_t n = 300, joints = 4, frames = 20;
  const double size = 3, duration = frames * frame_duration;
  Points points;
  for (std::size_t v = 0; v < n; ++v) points.push_back(random.vector(0.3));
  std::vector<std::vector<Rest_shape::Index>> regions(joints);
  for (std::size_t v = 0; v < n; ++v)
    if (random() < 0.1) regions[random.below(joints - 1)].push_back(Rest_shape::Index(v)); // the last one has none
  std::vector<Amf::Joint_event> events;
  for (int i = 0; i < 80; ++i)
    events.push_back(
        {random.below(joints), double(random.below(frames)) * frame_duration, random(0, 40), random(0, 30)});
  std::vector<Amf::Rig_feature> features;
  for (int i = 0; i < 120; ++i)
    features.push_back({random.below(n), random(0, duration), random.power(0.02, 0.2), random.power(0.02, 0.3)});

  const Amf::Rig_events rig(points, size, regions, events, frames, frame_duration);
  const Amf::Rig_matches matches = rig(features);
  std::vector<double> found, at_event(features.size(), 0);
  std::vector<std::set<std::size_t>> of_joint(joints);
  for (const Amf::Joint_event& e : events) {
    const bool counts = e.prominence >= 10 && e.angle >= 10 && !regions[e.joint].empty() && e.time > frame_duration &&
                        e.time < duration - 2 * frame_duration;
    if (!counts) continue;
    bool is_found = false;
    for (std::size_t i = 0; i < features.size(); ++i) {
      double distance = std::numeric_limits<double>::infinity();
      for (Rest_shape::Index v : regions[e.joint])
        distance = std::min(distance, (points[v] - points[features[i].vertex]).norm());
      if (distance > std::min(features[i].sigma, 0.02 * size)) continue;
      if (std::abs(features[i].time - e.time) > std::max(1.5 * frame_duration, features[i].tau / 2)) continue;
      is_found = true;
      at_event[i] = 1;
      of_joint[e.joint].insert(i);
    }
    if (e.angle >= 20) found.push_back(is_found ? 1 : 0);
  }
  CHECK(matches.found == found);
  CHECK(matches.at_event == at_event);
  for (std::size_t j = 0; j < joints; ++j) CHECK(matches.of_joint[j] == of_joint[j].size());
  // the test tests something: there is some of everything
  CHECK(Amf::sample_mean(found) > 0 && Amf::sample_mean(found) < 1 && found.size() > 3);
  CHECK(Amf::sample_mean(at_event) > 0 && Amf::sample_mean(at_event) < 1);

  CHECK_THROWS(Amf::Input_error, rig({{n, 0, 1, 1}}), "vertex 300");
  CHECK_THROWS(Amf::Input_error, Amf::Rig_events(points, size, {{999}}, {}, frames, 1), "vertex 999");
  CHECK_THROWS(Amf::Input_error, Amf::Rig_events(points, size, {{1}}, {{1, 0, 0, 0}}, frames, 1), "joint 1");
  CHECK_THROWS(Amf::Option_error, Amf::Rig_events(points, 0, {{1}}, {}, frames, 1), "size");
  CHECK_THROWS(Amf::Option_error, Amf::Rig_events(points, 1, {{1}}, {}, frames, 0), "between two frames");
}

int main()
{
  test_fit();
  test_area_ratio();
  test_fit_of_parts();
  test_bootstrap();
  test_chance();
  test_maximum_matching();
  test_repeated_features();
  test_paired_features();
  test_matching_errors();
  test_feature_regions();
  test_map_scores();
  test_painting_scores();
  test_prominent_maxima();
  test_rig_events();
  return test_result();
}
