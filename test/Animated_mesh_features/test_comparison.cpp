// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Descriptors, matching, alignment, distance: against exact values, invariances and plain forms of the same sums.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/pose_variation.h>
#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>
#include <CGAL/Animated_mesh_features/Applications/align_animations.h>
#include <CGAL/Animated_mesh_features/Applications/align_events.h>
#include <CGAL/Animated_mesh_features/Applications/animation_activity.h>
#include <CGAL/Animated_mesh_features/Applications/animation_distance.h>
#include <CGAL/Animated_mesh_features/Applications/classical_scaling.h>
#include <CGAL/Animated_mesh_features/Applications/event_differences.h>
#include <CGAL/Animated_mesh_features/Applications/match_aligned_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/describe_features.h>
#include <CGAL/Animated_mesh_features/Descriptors/match_features.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Rest_shape Rest_shape;
typedef Amf::Feature_point Feature;
typedef Amf::Spatio_temporal_field<double> Field;
typedef Amf::Rotation_free_gradient_histogram Rotation_free;
typedef Amf::Oriented_gradient_histogram Oriented;

// the first feature at this vertex, without a triangle
Feature feature_at(std::size_t vertex, double time, double sigma, double tau, double amplitude = 1)
{
  Feature f;
  f.vertex_index = vertex;
  f.triangle = {{vertex, vertex, vertex}};
  f.time = time;
  f.sigma = sigma;
  f.tau = tau;
  f.amplitude = f.strength = amplitude;
  return f;
}

std::size_t nearest_vertex(const Points& points, const Vec& p)
{
  std::size_t best = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    if ((points[v] - p).norm() < (points[best] - p).norm()) best = v;
  return best;
}

// A field that is a function of place and time.
template <class Function>
Field field_of(const Points& points, std::size_t frames, double frame_duration, const Function& function)
{
  Field field(points.size(), frames);
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t f = 0; f < frames; ++f) field(v, f) = function(points[v], double(f) * frame_duration);
  return field;
}

double length_of(const std::vector<float>& d)
{
  double squares = 0;
  for (float x : d) squares += double(x) * double(x);
  return std::sqrt(squares);
}

template <class Descriptor>
std::vector<float> described(const Rest_shape& shape, const Field& field, double frame_duration, const Feature& f,
                             const Descriptor& descriptor)
{
  const Amf::Feature_descriptors d = Amf::describe_features(shape, field, frame_duration, {f}, descriptor);
  return std::vector<float>(d[0], d[0] + d.length());
}

double difference(const std::vector<float>& a, const std::vector<float>& b)
{
  return Amf::descriptor_distance(a.data(), b.data(), a.size());
}

// --------------------------------------------------------------------------------------------------- neighbourhoods

// On a plane the log map is the plane itself, and the gradient of a linear field is exact.
void test_neighbourhood()
{
  Random random(1);
  const Shape square = irregular_square(16, random);
  const Rest_shape shape = rest_shape_of(square);
  const std::size_t centre = nearest_vertex(square.points, Vec(0.5, 0.5, 0));
  const Vec slope(0.7, -0.4, 0);
  const double rate = 0.3, duration = 0.1;
  const Field field =
      field_of(square.points, 41, duration, [&](const Vec& p, double t) { return slope.dot(p) + rate * t; });
  Feature f = feature_at(centre, 2.03, 0.1, 0.4);
  Amf::Neighbourhood_sampler<double> sampler(shape, field, duration);
  const Amf::Feature_neighbourhood n = sampler(f);
  CHECK(n.places.size() == 127); // a whole disc
  CHECK(n.times.size() == 25 && n.times.front() == -3 && n.times.back() == 3);
  double area = 0;
  for (std::size_t i = 0; i < n.places.size(); ++i) {
    const auto& v = n.places[i];
    CHECK(std::hypot(v.x, v.y) <= 3 + 1e-12);
    area += v.area;
    const auto& g = n.gradients[i * n.times.size() + 5];
    CHECK_NEAR(std::hypot(g[0], g[1]), slope.norm() * f.sigma, 1e-5);
    // the value at the place that the map tells: linear, so that value - value at the centre is the gradient's product
    CHECK_NEAR(n.values[i * n.times.size() + 12] - n.values[12], g[0] * v.x + g[1] * v.y, 1e-5);
    CHECK_NEAR(g[2], rate * f.tau, 1e-5);
  }
  const double disc = 3.14159265358979323846 * 3.25 * 3.25; // rings reach half a step farther, vertices a whole one
  CHECK(area > 0.75 * disc && area < disc);
  // counterclockwise from outside: a gradient, and the one a quarter turn from it
  const Field quarter =
      field_of(square.points, 41, duration, [&](const Vec& p, double) { return slope[0] * p[1] - slope[1] * p[0]; });
  Amf::Neighbourhood_sampler<double> quarter_sampler(shape, quarter, duration);
  const auto g = n.gradients[0], h = quarter_sampler(f).gradients[0];
  CHECK_NEAR(g[0] * h[1] - g[1] * h[0], slope.squaredNorm() * f.sigma * f.sigma, 1e-6);
  // at the end of a surface there are fewer
  const std::size_t border =
      sampler(feature_at(nearest_vertex(square.points, Vec(0, 0.5, 0)), 1, 0.1, 0.4)).places.size();
  CHECK(border > 64 && border < 127);
  CHECK_THROWS(Amf::Input_error, sampler(feature_at(square.points.size(), 1, 0.1, 0.1)), "vertices");
  CHECK_THROWS(Amf::Input_error, sampler(feature_at(centre, 1, 0, 0.1)), "must be positive");
  CHECK_THROWS(Amf::Option_error, Amf::Neighbourhood_sampler<double>(shape, Field(3, 5), 1), "the field is 3 x 5");
}

// ------------------------------------------------------------------------------------------------------ descriptors

// something without symmetry around the feature
double event(const Vec& p, double t)
{
  const double s = 0.12, u = 0.3;
  const auto blob = [&](const Vec& c, double when, double a) {
    return a * std::exp(-(p - c).squaredNorm() / (2 * s * s) - (t - when) * (t - when) / (2 * u * u));
  };
  return blob(Vec(0.5, 0.5, 0), 1, 1) + blob(Vec(0.7, 0.56, 0), 1.3, 0.8) + blob(Vec(0.45, 0.3, 0), 0.6, 0.5);
}

void test_descriptors()
{
  Random random(2);
  const Shape square = irregular_square(30, random);
  const Rest_shape shape = rest_shape_of(square);
  const double duration = 0.05;
  const std::size_t centre = nearest_vertex(square.points, Vec(0.5, 0.5, 0));
  const Feature f = feature_at(centre, 1, 0.12, 0.3);
  const Field field = field_of(square.points, 45, duration, event);
  const std::vector<float> free = described(shape, field, duration, f, Rotation_free());
  const std::vector<float> oriented = described(shape, field, duration, f, Oriented());
  CHECK(free.size() == 100 && oriented.size() == 192);
  CHECK_NEAR(length_of(free), 1, 1e-5);
  CHECK_NEAR(length_of(oriented), 1, 1e-5);
  CHECK(*std::min_element(free.begin(), free.end()) >= 0 && *std::max_element(free.begin(), free.end()) < 0.35);

  // moved, turned, scaled, its field multiplied and raised
  const Eigen::AngleAxisd turn = random.rotation();
  const Vec shift = random.vector(3);
  Shape moved = square;
  for (Vec& p : moved.points) p = turn * (2.5 * p) + shift;
  Feature g = f;
  g.sigma *= 2.5;
  Field other = field;
  for (std::size_t v = 0; v < square.points.size(); ++v)
    for (std::size_t k = 0; k < 45; ++k) other(v, k) = 3 * field(v, k) + 2;
  CHECK_NEAR(difference(free, described(rest_shape_of(moved), other, duration, g, Rotation_free())), 0, 1e-3);
  CHECK_NEAR(difference(oriented, described(rest_shape_of(moved), other, duration, g, Oriented())), 0, 1e-3);

  // mirrored: x is -x, and faces the other way round
  Shape mirror = square;
  for (Vec& p : mirror.points) p[0] = -p[0];
  for (auto& c : mirror.faces) std::swap(c[0], c[1]);
  CHECK_NEAR(difference(free, described(rest_shape_of(mirror), field, duration, f, Rotation_free())), 0, 1e-3);
  const std::vector<float> opposite = described(rest_shape_of(mirror), field, duration, f, Oriented());
  std::vector<float> mirrored(oriented.size());
  Oriented().mirrored(oriented.data(), mirrored.data());
  CHECK_NEAR(difference(mirrored, opposite), 0, 1e-3);
  CHECK(difference(oriented, opposite) > 0.1); // this event is not its own mirror image

  // numbered the other way round
  Shape renumbered = square;
  const int last = int(square.points.size()) - 1;
  std::reverse(renumbered.points.begin(), renumbered.points.end());
  for (auto& c : renumbered.faces)
    for (int& v : c) v = last - v;
  const Field again = field_of(renumbered.points, 45, duration, event);
  const Feature h = feature_at(std::size_t(last) - centre, 1, 0.12, 0.3);
  CHECK_NEAR(difference(free, described(rest_shape_of(renumbered), again, duration, h, Rotation_free())), 0, 1e-3);
  CHECK_NEAR(difference(oriented, described(rest_shape_of(renumbered), again, duration, h, Oriented())), 0, 1e-3);

  // other frame rate and other mesh: what changes is small against another event
  const Field half = field_of(square.points, 23, 2 * duration, event);
  CHECK(difference(free, described(shape, half, 2 * duration, f, Rotation_free())) < 0.08);
  const Shape coarse_square = irregular_square(20, random);
  const std::size_t near = nearest_vertex(coarse_square.points, square.points[centre]);
  const Rest_shape coarse = rest_shape_of(coarse_square);
  const double resampled = difference(free, described(coarse, field_of(coarse_square.points, 45, duration, event),
                                                      duration, feature_at(near, 1, 0.12, 0.3), Rotation_free()));
  const double different = difference(
      free, described(shape, field, duration,
                      feature_at(nearest_vertex(square.points, Vec(0.7, 0.56, 0)), 1.3, 0.12, 0.3), Rotation_free()));
  CHECK(resampled < 0.5 * different);
  // the refined place is what counts: the same as that of the vertex it lies on
  Feature placed = feature_at(centre + 1, 1, 0.12, 0.3);
  placed.triangle = {{centre + 1, centre, centre}};
  placed.barycentric_coordinates = {{0, 1, 0}};
  CHECK_NEAR(difference(free, described(shape, field, duration, placed, Rotation_free())), 0, 0.02);
  // a loop, in the middle of the event and from it on
  const std::size_t frames = 36;
  const auto around = [&](const Vec& p, double t) { return event(p, t + 1 - frames * duration) + event(p, t + 1); };
  const Field loop = field_of(square.points, frames, duration, event),
              late = field_of(square.points, frames, duration, around);
  const auto of_loop = [&](const Field& values, double time, bool is_cyclic) {
    const Amf::Feature_descriptors d = Amf::describe_features(
        shape, values, duration, {feature_at(centre, time, 0.12, 0.25)}, Rotation_free(),
        [](std::size_t count, const auto& task) {
          for (std::size_t i = 0; i < count; ++i) task(i);
        },
        is_cyclic);
    return std::vector<float>(d[0], d[0] + d.length());
  };
  CHECK(difference(of_loop(loop, 1, true), of_loop(late, 0, true)) < 0.02);
  CHECK(difference(of_loop(loop, 1, false), of_loop(late, 0, false)) > 0.1);
  // nothing happens: nothing to describe
  CHECK(length_of(described(shape, Field(square.points.size(), 45), duration, f, Oriented())) == 0);
}

// -------------------------------------------------------------------------------------------------------- landmarks

void test_landmarks()
{
  const Shape ball = sphere(3);
  const Rest_shape shape = rest_shape_of(ball);
  const Amf::Surface_landmarks landmarks(shape);
  CHECK(landmarks.vertices().size() == 64);
  for (std::size_t v = 0; v < ball.points.size(); v += 7) CHECK_NEAR(landmarks.eccentricity(v), 1, 0.06);
  float profile[Amf::Surface_landmarks::profile_length];
  landmarks.profile(5, profile);
  CHECK(std::is_sorted(profile, profile + Amf::Surface_landmarks::profile_length));
  CHECK_NEAR(profile[Amf::Surface_landmarks::profile_length - 1], 1, 0.02); // all of it within pi, twice the mean
  CHECK_NEAR(profile[4], 0.5, 0.06);                                        // half of it within the mean

  // with all vertices as landmarks, the plain mean over all paths
  Random random(3);
  const Shape small = irregular_square(6, random);
  const Rest_shape plane = rest_shape_of(small);
  const Amf::Surface_landmarks all(plane, 1000);
  CHECK(all.vertices().size() == small.points.size());
  const std::size_t n = small.points.size();
  std::vector<double> d(n * n, std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < n; ++v) d[v * n + v] = 0;
  for (const Rest_shape::Edge& e : plane.edges())
    d[e.source * n + e.target] = d[e.target * n + e.source] = (small.points[e.source] - small.points[e.target]).norm();
  for (std::size_t k = 0; k < n; ++k) // Floyd and Warshall
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) d[i * n + j] = std::min(d[i * n + j], d[i * n + k] + d[k * n + j]);
  const std::vector<double>& areas = all.areas();
  const double area = std::accumulate(areas.begin(), areas.end(), 0.);
  double mean = 0;
  std::vector<double> means(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) means[i] += areas[j] * d[i * n + j] / area;
    mean += areas[i] * means[i] / area;
  }
  CHECK_NEAR(all.mean_distance(), mean, 1e-6);
  for (std::size_t i = 0; i < n; ++i) CHECK_NEAR(all.eccentricity(i), means[i] / mean, 1e-6);
}

// --------------------------------------------------------------------------------------------------------- matching

// Features at places in space, with straight distances, told apart by sigma only.
Amf::Described_features body(const Points& places, const std::vector<double>& times, const std::vector<double>& sigmas)
{
  std::vector<Feature> features;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Feature f = feature_at(i, times[i], sigmas[i], 0.1, 1 + 0.01 * double(i));
    for (std::size_t k = 0; k < 3; ++k) f.rest_position[k] = places[i][Eigen::Index(k)];
    features.push_back(f);
  }
  return Amf::described_features(features, 4);
}

void test_matching()
{
  Random random(4);
  Points places, other;
  std::vector<double> times, warped, sigmas;
  const std::size_t n = 24;
  for (std::size_t i = 0; i < n; ++i) {
    places.push_back(random.vector());
    times.push_back(random(0, 3));
    sigmas.push_back(random.power(0.1, 0.4));
  }
  // turned, and a little slower towards the end; then some that are of nothing
  const Eigen::AngleAxisd turn = random.rotation();
  for (std::size_t i = 0; i < n; ++i) {
    other.push_back(turn * places[n - 1 - i] + Vec(1, 2, 3));
    warped.push_back(times[n - 1 - i] * (1 + 0.04 * times[n - 1 - i]));
  }
  std::vector<double> other_sigmas(sigmas.rbegin(), sigmas.rend());
  for (int i = 0; i < 8; ++i) {
    other.push_back(random.vector() + Vec(1, 2, 3));
    warped.push_back(random(0, 3));
    other_sigmas.push_back(random.power(0.1, 0.4));
  }
  const Amf::Described_features a = body(places, times, sigmas), b = body(other, warped, other_sigmas);
  const std::vector<Amf::Feature_match> matches = Amf::match_features(a, b);
  std::size_t right = 0;
  std::set<std::size_t> used;
  for (const Amf::Feature_match& m : matches) {
    right += m.b == n - 1 - m.a ? 1 : 0;
    CHECK(m.confidence > 0 && m.confidence <= 1);
    CHECK(used.insert(m.b).second);
  }
  CHECK(right >= n - 1 && matches.size() <= n + 3);
  // backwards in time nothing agrees
  for (double& t : warped) t = 5 - t;
  CHECK(Amf::match_features(a, body(other, warped, other_sigmas)).size() < n / 2);

  // a body with two sides that do the same at the same time: of the two ways the one that is a rotation
  Points sides, turned_sides;
  std::vector<double> at, size;
  for (int i = 0; i < 8; ++i) {
    const Vec p(random(0.3, 1), random(-1, 1), random(-1, 1));
    for (double s : {1., -1.}) {
      sides.push_back(Vec(s * p[0], p[1], p[2]));
      at.push_back(0.3 * i);
      size.push_back(0.2);
    }
  }
  for (const Vec& p : sides) turned_sides.push_back(turn * p);
  for (const Amf::Feature_match& m : Amf::match_features(body(sides, at, size), body(turned_sides, at, size)))
    CHECK(m.a == m.b);
  // of its mirror image, the other side
  for (Vec& p : turned_sides) p[2] = -p[2];
  for (const Amf::Feature_match& m : Amf::match_features(body(sides, at, size), body(turned_sides, at, size)))
    CHECK(m.a == (m.b ^ 1));
  CHECK(Amf::match_features(body({}, {}, {}), a).empty());
  Amf::Matching_options options;
  options.mutual_nearest = true;
  CHECK(Amf::match_features(a, a, options).size() == n);
  options.max_ratio = 0;
  CHECK_THROWS(Amf::Option_error, Amf::match_features(a, a, options), "ratio");
}

// -------------------------------------------------------------------------------------------------------- alignment

// A motion of some places that deform one after the other, at times that `clock` maps to its own.
template <class Clock>
Amf::Activity motion(std::size_t frames, double duration, const Clock& clock, int kind = 0)
{
  const std::size_t n = 12;
  Field field(n, frames);
  std::vector<double> areas(n), eccentricities(n);
  for (std::size_t v = 0; v < n; ++v) {
    areas[v] = 1 + double(v % 3);
    eccentricities[v] = 0.7 + 0.08 * double(v);
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = clock(double(f) * duration);
      const double when = kind == 0 ? 0.3 * double((7 * v) % n) : 0.25 * double((5 * v + 3) % n) + 0.2;
      const double width = kind == 0 ? 0.2 + 0.02 * double(v) : 0.35 - 0.02 * double(v);
      field(v, f) = (kind == 0 ? 1 + 0.5 * double(v % 4) : 2 - 0.4 * double(v % 5)) *
                    std::exp(-(t - when) * (t - when) / (2 * width * width));
    }
  }
  return Amf::animation_activity(field, areas, eccentricities, duration);
}

// The least sum over all ways, by trying all last steps; from the first to the last pair, if ends are fixed.
double plain_warping(const std::vector<std::vector<double>>& c, std::size_t slope, bool has_fixed_ends = false)
{
  const std::size_t n = c.size(), m = c[0].size();
  std::vector<std::vector<double>> best(n, std::vector<double>(m, std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      double& b = best[i][j];
      if (i == 0 && j == 0) b = 2 * c[0][0];
      if (i == 0 && j > 0 && !has_fixed_ends) b = best[0][j - 1] + c[0][j];
      if (j == 0 && i > 0 && !has_fixed_ends) b = best[i - 1][0] + c[i][0];
      for (std::size_t q = 1; q <= slope; ++q) {
        if (i >= 1 && j >= q) {
          double sum = best[i - 1][j - q] + c[i][j - q + 1];
          for (std::size_t r = 0; r < q; ++r) sum += c[i][j - r];
          b = std::min(b, sum);
        }
        if (j >= 1 && i >= q) {
          double sum = best[i - q][j - 1] + c[i - q + 1][j];
          for (std::size_t r = 0; r < q; ++r) sum += c[i - r][j];
          b = std::min(b, sum);
        }
      }
    }
  double least = best[n - 1][m - 1], rest = 0;
  if (has_fixed_ends) return least;
  for (std::size_t j = m - 1; j-- > 0;) least = std::min(least, best[n - 1][j] + (rest += c[n - 1][j + 1]));
  rest = 0;
  for (std::size_t i = n - 1; i-- > 0;) least = std::min(least, best[i][m - 1] + (rest += c[i + 1][m - 1]));
  return least;
}

void test_alignment()
{
  const double pi = 3.14159265358979323846, frame = 1. / 30, D = 3.6;
  const auto same = [](double t) { return t; };
  const Amf::Activity a = motion(109, frame, same);
  CHECK(a.samples == 109 && a.classes == 6 && a.lags == 7);
  double squares = 0;
  for (float x : a.mean) squares += double(x) * double(x) / 109;
  CHECK_NEAR(squares, 1, 1e-5);
  Amf::Time_alignment self = Amf::align_animations(a, a);
  CHECK(self.cost == 0);
  for (double t : {0., 0.77, 3.6}) CHECK_NEAR(self.to_b(t), t, 1e-9);
  CHECK(self.confidence > 0.5);

  // a smooth warp of up to 30 %, and both ways
  const auto warp = [&](double t) { return t + 0.3 * D * std::sin(2 * pi * t / D) / (2 * pi); };
  const Amf::Activity b = motion(109, frame, warp);
  const Amf::Time_alignment warped = Amf::align_animations(b, a);
  std::vector<double> errors;
  for (double t = 0; t <= D; t += frame) {
    errors.push_back(std::abs(warped.to_b(t) - warp(t)) / frame);
    CHECK_NEAR(warped.to_a(warped.to_b(t)), t, frame);
  }
  std::sort(errors.begin(), errors.end());
  CHECK(errors[errors.size() / 2] < 0.5 && errors[errors.size() * 95 / 100] < 1.5);
  for (const std::vector<double>* times : {&warped.times_a, &warped.times_b})
    CHECK(std::adjacent_find(times->begin(), times->end(), std::greater_equal<double>()) == times->end());
  CHECK(warped.confidence > 0.5);

  const Amf::Time_alignment back = Amf::align_animations(a, b); // neither comes first
  for (double t : {0.4, 1.7, 3.1}) CHECK_NEAR(back.to_a(t), warped.to_b(t), 1e-6);

  Amf::Alignment_options rough; // steps of a sample
  rough.smoothing = 0;
  const Amf::Time_alignment steps = Amf::align_animations(b, a, rough);
  CHECK(steps.cost == warped.cost);
  for (double t : steps.times_b) CHECK_NEAR(t / frame, std::round(t / frame), 1e-9);
  CHECK_NEAR(steps.to_b(1.7), warp(1.7), 2 * frame);

  // stands still for the second half: the map goes on smoothly to the end, which is that of the other one
  const double still = 7.2;
  const auto slow = [&](double t) { return t + 0.25 * still * std::sin(2 * pi * t / still) / (2 * pi); };
  const Amf::Activity halting = motion(217, frame, same), slowed = motion(217, frame, slow);
  const Amf::Time_alignment halted = Amf::align_animations(slowed, halting);
  CHECK_NEAR(halted.to_b(still), still, 1e-9);
  double largest = 0;
  for (double t = 0; t <= still; t += frame) largest = std::max(largest, std::abs(halted.to_b(t) - slow(t)) / frame);
  CHECK(largest < 3);
  // another one, that stands for longer than a slope of 3 allows, goes on alike
  const Amf::Time_alignment longer = Amf::align_animations(motion(130, frame, same), motion(400, frame, same));
  CHECK_NEAR(longer.to_b(4.2), 4.2, 3 * frame);

  // what is slow, and held for long by a warp: the mean over time is another one, the map is not
  const auto hold = [&](double t) { return t - 0.45 * D * std::sin(2 * pi * t / D) / (2 * pi); };
  const auto bow = [&](const auto& clock) {
    Field field(1, 109);
    for (std::size_t f = 0; f < 109; ++f) field(0, f) = 1 - std::cos(2 * pi * clock(double(f) * frame) / D);
    return Amf::animation_activity(field, {1.}, {1.}, frame);
  };
  const Amf::Time_alignment bowed = Amf::align_animations(bow(hold), bow(same));
  largest = 0;
  for (double t = 0; t <= D; t += frame) largest = std::max(largest, std::abs(bowed.to_b(t) - hold(t)) / frame);
  CHECK(largest < 1.5);

  // a part of it: open ends
  const Amf::Activity part = motion(60, frame, [&](double t) { return t + 0.9; });
  Amf::Alignment_options open;
  open.end_weight = 0.1;
  const Amf::Time_alignment inside = Amf::align_animations(part, a, open);
  CHECK_NEAR(inside.to_b(1), 1.9, 1.5 * frame);

  const Amf::Activity other = motion(109, frame, same, 1);
  const Amf::Time_alignment unlike = Amf::align_animations(a, other);
  CHECK(unlike.confidence < 0.35);
  for (std::size_t k = 1; k < unlike.times_a.size(); ++k) {
    const double slope = (unlike.times_b[k] - unlike.times_b[k - 1]) / (unlike.times_a[k] - unlike.times_a[k - 1]);
    CHECK(slope > 1 / 3.001 && slope < 3.001);
  }

  // against the plain form, on the mean alone
  Amf::Alignment_options options;
  options.recurrence_weight = options.recurrence_without_places = options.place_weight = 0;
  options.bend_weight = 0;
  options.surrogates = 0;
  const Amf::Activity x = motion(20, 0.15, same), y = motion(26, 0.15, warp, 1);
  std::vector<std::vector<double>> costs(x.samples, std::vector<double>(y.samples));
  double norm = 0;
  for (float u : x.mean) norm += std::abs(u);
  for (float u : y.mean) norm += std::abs(u);
  for (std::size_t i = 0; i < x.samples; ++i)
    for (std::size_t j = 0; j < y.samples; ++j) costs[i][j] = std::abs(x.mean[i] - y.mean[j]);
  for (std::size_t slope : {1, 2, 3}) {
    options.max_slope = slope;
    CHECK_NEAR(Amf::align_animations(x, y, options).cost, plain_warping(costs, slope) / norm, 1e-6);
  }
  options.max_slope = 0;
  CHECK_THROWS(Amf::Option_error, Amf::align_animations(x, y, options), "slope");
  options.max_slope = 2;
  options.smoothing = -1;
  CHECK_THROWS(Amf::Option_error, Amf::align_animations(x, y, options), "smoothing");
  Amf::Activity_options finer;
  finer.sample_duration = 1. / 60;
  CHECK_THROWS(Amf::Option_error, Amf::align_animations(a, Amf::animation_activity(Field(1, 9), {1.}, {}, 0.1, finer)),
               "activities");
}

// Each asks in its middle, whoever runs it as a task, whether it is still wanted.
void test_cancelled()
{
  const Amf::Activity a = motion(109, 1. / 30, [](double t) { return t; });
  Random random(5);
  Points places;
  std::vector<double> times, sigmas(30, 0.1);
  for (std::size_t i = 0; i < sigmas.size(); ++i) {
    places.push_back(random.vector());
    times.push_back(random(0, 3));
  }
  const Amf::Described_features events = body(places, times, sigmas);
  const std::vector<std::pair<int, std::function<void()>>> computations = {
      {400, [&] { Amf::align_animations(a, a); }}, // both passes over the samples, of surrogates, too
      {200, [&] { Amf::animation_distance(a, a); }},
      {150, [&] { Amf::match_features(events, events); }}, // features, candidates, iterations
      {30, [&] { Amf::align_events(events, events); }}};
  for (const auto& computation : computations) {
    const std::function<void()>& compute = computation.second; // no binding, which a lambda could not capture
    const int most = computation.first;
    int asked = 0;
    const auto goes_on = [&] { return ++asked < most; };
    const Amf::internal::Cancellation_scope scope(goes_on);
    CHECK_THROWS(Amf::Cancelled, compute(), "");
    CHECK(asked == most);
  }
}

void test_distance()
{
  const double frame = 1. / 30;
  const auto same = [](double t) { return t; };
  const Amf::Activity a = motion(109, frame, same), b = motion(109, frame, same, 1);
  const double different = Amf::animation_distance(a, b);
  CHECK(different > 0.1 && different <= 1);
  CHECK(Amf::animation_distance(a, a) == 0);
  CHECK(Amf::animation_distance(a, b) == Amf::animation_distance(b, a));
  CHECK(Amf::animation_distance(a, motion(55, 2 * frame, same)) < 0.1 * different); // half of the frames
  CHECK(Amf::animation_distance(a, motion(217, frame / 2, same)) < 0.1 * different);
  // nothing moves: nothing in common with what does, the same as another one that does not
  const Amf::Activity still = Amf::animation_activity(Field(5, 40), std::vector<double>(5, 1), {}, frame);
  CHECK(still.level == 0 && still.cycle.period == 0);
  CHECK(Amf::animation_distance(still, still) == 0);
  CHECK(Amf::animation_distance(still, a) > 0.9);
  const Amf::Activity twice = Amf::animation_activity(Field(5, 79), std::vector<double>(5, 1), {}, frame);
  CHECK_NEAR(Amf::animation_distance(still, twice), 0.1, 1e-12); // but for the duration
  // farther moved, twice as far, four times, and more
  Amf::Distance_options far;
  far.least_variation = 1e-9;
  Amf::Activity near = a, moved = a;
  moved.pose_variation = 0.1;
  CHECK(Amf::animation_distance(near, moved, far) == 0); // one is not known
  near.pose_variation = 0.05;
  CHECK_NEAR(Amf::animation_distance(near, moved, far), 0.2, 1e-6);
  near.pose_variation = 0.01;
  CHECK_NEAR(Amf::animation_distance(near, moved, far), 0.4, 1e-6);
  far.variation_weight = 1.1;
  CHECK_THROWS(Amf::Option_error, Amf::animation_distance(near, moved, far), "weights");
  // what is there at all times, and adds in squares, is no motion
  Field clean(1, 40), noisy(1, 40);
  for (std::size_t f = 0; f < 40; ++f) {
    clean(0, f) = f < 10 ? 0 : std::sin(0.2 * double(f - 10)) + 1 - std::cos(0.3 * double(f - 10));
    clean(0, f) = std::abs(clean(0, f));
    noisy(0, f) = std::sqrt(clean(0, f) * clean(0, f) + 0.09);
  }
  Amf::Distance_options of_mean;
  of_mean.alignment.recurrence_weight = 0;
  of_mean.cycle_weight = 0;
  const Amf::Activity without = Amf::animation_activity(clean, {1.}, {}, frame);
  const Amf::Activity with = Amf::animation_activity(noisy, {1.}, {}, frame);
  CHECK_NEAR(Amf::animation_distance(with, without, of_mean), 0, 0.01);
  of_mean.alignment.without_least_mean = false;
  CHECK(Amf::animation_distance(with, without, of_mean) > 0.05);
  CHECK_THROWS(Amf::Input_error, Amf::animation_activity(Field(5, 40), std::vector<double>(5, 1), {}, 1e-4), "samples");
  CHECK_THROWS(Amf::Option_error, Amf::animation_activity(Field(5, 40), std::vector<double>(4, 1), {}, 1), "areas");
}

// A cloud that grows and shrinks by a tenth, while it flies and spins: each frame is a tenth off the mean.
void test_pose_variation()
{
  const std::size_t n = 40, frames = 10;
  for (double size : {1., 1000.}) {
    Amf::Vertex_trajectories<double> t{Field(n, frames), Field(n, frames), Field(n, frames)};
    std::vector<double> areas(n);
    std::vector<Eigen::Vector3d> points(n);
    Eigen::Vector3d centre(0, 0, 0);
    double area = 0;
    for (std::size_t v = 0; v < n; ++v) {
      areas[v] = size * size * (1 + double(v % 3));
      points[v] = size * Eigen::Vector3d(std::sin(7. * double(v)), std::cos(3. * double(v)), std::sin(double(v * v)));
      centre += areas[v] * points[v];
      area += areas[v];
    }
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t f = 0; f < frames; ++f) {
        const Eigen::AngleAxisd spin(0.7 * double(f), Eigen::Vector3d(1, 2, 3).normalized());
        const Eigen::Vector3d p = spin * ((f % 2 == 0 ? 0.9 : 1.1) * (points[v] - centre / area)) +
                                  double(f) * size * Eigen::Vector3d(1, 0, -2);
        t.x(v, f) = p[0];
        t.y(v, f) = p[1];
        t.z(v, f) = p[2];
      }
    CHECK_NEAR(Amf::pose_variation(t, areas), 0.1 / std::sqrt(1.01), 1e-6);
    CHECK(Amf::pose_variation(t, std::vector<double>(n, 0.)) == 0);
    CHECK_THROWS(Amf::Option_error, Amf::pose_variation(t, {1.}), "areas");
  }
}

void test_cycles()
{
  const double pi = 3.14159265358979323846, frame = 1. / 30;
  const auto gait = [&](double period, double ahead) {
    Field field(4, 120);
    for (std::size_t v = 0; v < 4; ++v)
      for (std::size_t f = 0; f < 120; ++f) {
        const double phase = 2 * pi * (double(f) * frame / period + ahead) + 0.9 * double(v);
        field(v, f) = std::exp(std::sin(phase) + 0.3 * std::cos(2 * phase));
      }
    return Amf::animation_activity(field, {1, 2, 1, 3}, {0.7, 0.9, 1.1, 1.5}, frame);
  };
  const Amf::Activity a = gait(0.8, 0), b = gait(1.1, 0.3);
  CHECK_NEAR(a.cycle.period, 0.8, 0.02);
  CHECK_NEAR(b.cycle.period, 1.1, 0.02);
  CHECK(a.cycle.strength > 0.9);
  const Amf::Time_alignment alignment = Amf::align_animations(a, gait(0.8, 0.3));
  CHECK(bool(alignment.phase));
  if (alignment.phase) CHECK_NEAR(*alignment.phase, 0.3, 0.03);
  CHECK(motion(109, frame, [](double t) { return t; }).cycle.period == 0);
}

// A loop of some places that deform one after the other, from its frame `first` on.
Amf::Activity loop_of(std::size_t frames, double duration, std::size_t first, int kind = 0, bool is_cyclic = true,
                      std::size_t plays = 1, const std::function<double(double)>& clock = {})
{
  const double pi = 3.14159265358979323846;
  const std::size_t n = 12;
  Field field(n, frames * plays + (is_cyclic ? 0 : 1));
  std::vector<double> areas(n), eccentricities(n);
  for (std::size_t v = 0; v < n; ++v) {
    areas[v] = 1 + double(v % 3);
    eccentricities[v] = 0.7 + 0.08 * double(v);
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) {
      double x = double((f + first) % frames) / double(frames);
      if (clock) x = clock(x);
      const double when = kind == 0 ? double((7 * v) % n) / double(n) : double((5 * v + 3) % n) / 15.;
      const double angle = 2 * pi * (x - when), sharp = kind == 0 ? 3 + double(v % 4) : 9 - double(v % 3);
      field(v, f) =
          (kind == 0 ? 1 + 0.5 * double(v % 4) : 3 - 0.5 * double(v % 5)) * std::exp(sharp * (std::cos(angle) - 1));
    }
  }
  Amf::Activity_options options;
  options.is_cyclic = is_cyclic;
  return Amf::animation_activity(field, areas, eccentricities, duration, options);
}

void test_loops()
{
  const double frame = 1. / 30, pi = 3.14159265358979323846;
  const Amf::Activity a = loop_of(48, frame, 0), other = loop_of(40, frame, 0, 1);
  CHECK(a.is_cyclic && a.samples == 48);
  CHECK_NEAR(a.duration(), 1.6, 1e-12);
  CHECK_NEAR(a.cycle.period, 1.6, 1e-12);
  CHECK_NEAR(a.cycle.strength, 1, 1e-12);
  const double different = Amf::animation_distance(a, other);
  CHECK(different > 0.1);
  for (std::size_t k : {1, 17, 24, 47}) { // begun with another frame
    const Amf::Activity rotated = loop_of(48, frame, k);
    CHECK_NEAR(Amf::animation_distance(a, rotated), 0, 1e-6);
    CHECK_NEAR(Amf::animation_distance(rotated, other), different, 0.01 * different);
    CHECK(Amf::animation_distance(rotated, other) == Amf::animation_distance(other, rotated));
    const Amf::Time_alignment alignment = Amf::align_animations(a, rotated);
    CHECK_NEAR(alignment.cost, 0, 1e-6);
    CHECK(alignment.confidence > 0.5);
    CHECK(bool(alignment.phase));
    if (alignment.phase) CHECK_NEAR(std::remainder(*alignment.phase - double(k) / 48, 1), 0, 1e-6);
    CHECK_NEAR(alignment.times_a.back() - alignment.times_a.front(), 1.6, 1e-9);
    CHECK_NEAR(alignment.times_b.back() - alignment.times_b.front(), 1.6, 1e-9);
    for (double t : {0., 0.5, 1.59, 3.3, -2.}) {
      CHECK(alignment.to_b(t) >= 0 && alignment.to_b(t) < 1.6);
      CHECK_NEAR(std::remainder(alignment.to_b(t) - (t - double(k) * frame), 1.6), 0, 1e-5);
      CHECK_NEAR(std::remainder(alignment.to_a(alignment.to_b(t)) - t, 1.6), 0, 1e-5);
      CHECK_NEAR(alignment.lateness(t, t + 0.1 - double(k) * frame), 0.1, 1e-5);
    }
  }
  // without being told it is another motion
  CHECK(Amf::animation_distance(loop_of(48, frame, 0, 0, false), loop_of(48, frame, 17, 0, false)) > 0.3 * different);

  // at other frame rates, played several times, slower, uneven
  CHECK(Amf::animation_distance(a, loop_of(24, 2 * frame, 5)) < 0.1 * different);
  CHECK(Amf::animation_distance(a, loop_of(96, frame / 2, 33)) < 0.1 * different);
  for (std::size_t plays : {2, 3})
    CHECK_NEAR(Amf::animation_distance(a, loop_of(48, frame, 31, 0, true, plays)), 0, 1e-6);
  const auto uneven = [&](double x) { return x + 0.25 * std::sin(2 * pi * x) / (2 * pi); };
  const Amf::Activity warped = loop_of(57, frame, 20, 0, true, 1, uneven);
  const Amf::Time_alignment way = Amf::align_animations(warped, a);
  for (double f = 0; f < 57; ++f) {
    const double x = std::fmod(f + 20, 57.) / 57;
    CHECK_NEAR(std::remainder(way.to_b(f * frame) - 1.6 * uneven(x), 1.6), 0, frame);
  }
  const Amf::Time_alignment back = Amf::align_animations(a, warped);
  for (double t : {0.1, 0.6, 1.3}) CHECK_NEAR(std::remainder(back.to_b(t) - way.to_a(t), 57 * frame), 0, 0.1 * frame);
  CHECK(std::adjacent_find(way.times_b.begin(), way.times_b.end(), std::greater_equal<double>()) == way.times_b.end());

  // a take, of twice around, from the 9th frame on
  const Amf::Activity take = loop_of(48, frame, 9, 0, false, 2);
  CHECK(!take.is_cyclic && take.samples == 97);
  const Amf::Time_alignment played = Amf::align_animations(take, a);
  CHECK(played.period_a == 0 && std::abs(played.period_b - 1.6) < 1e-12);
  for (double t : {0.2, 1., 2.}) CHECK_NEAR(std::remainder(played.to_b(t) - (t + 9 * frame), 1.6), 0, frame / 4);
  CHECK_NEAR(std::remainder(Amf::align_animations(a, take).to_a(1) - played.to_b(1), 1.6), 0, 1e-9);
  CHECK(Amf::animation_distance(take, loop_of(48, frame, 30)) == Amf::animation_distance(loop_of(48, frame, 30), take));
  CHECK_NEAR(Amf::animation_distance(take, loop_of(48, frame, 30)), Amf::animation_distance(take, a), 0.02 * different);
  CHECK(Amf::animation_distance(take, a) < 0.3 * different);

  // a slope of 1 closes no way but that of loops that are as long
  Amf::Alignment_options even;
  even.max_slope = 1;
  CHECK(Amf::align_animations(a, warped, even).cost == 1);
  CHECK(Amf::align_animations(a, loop_of(48, frame, 17), even).cost < 1e-6);

  // against the plain form, on the mean alone: closed ways from all pairs with the first sample of either
  Amf::Alignment_options of_mean;
  of_mean.recurrence_weight = of_mean.recurrence_without_places = of_mean.place_weight = of_mean.bend_weight = 0;
  of_mean.surrogates = 0;
  const std::vector<float>&x = warped.mean, &y = other.mean;
  const auto between = [](float value, const std::vector<float>& of, std::size_t k) { // where the other one is linear
    const std::size_t n = of.size();
    const double here = of[k], before = (here + of[(k + n - 1) % n]) / 2, after = (here + of[(k + 1) % n]) / 2;
    return std::max({std::min({here, before, after}) - value, value - std::max({here, before, after}), 0.});
  };
  const auto closed = [&](std::size_t first_a, std::size_t first_b) {
    std::vector<std::vector<double>> costs(x.size() + 1, std::vector<double>(y.size() + 1));
    for (std::size_t i = 0; i <= x.size(); ++i)
      for (std::size_t j = 0; j <= y.size(); ++j) {
        const std::size_t k = (first_a + i) % x.size(), l = (first_b + j) % y.size();
        costs[i][j] = std::min(between(x[k], y, l), between(y[l], x, k));
      }
    return plain_warping(costs, of_mean.max_slope, true) - 2 * costs[0][0];
  };
  double least = closed(0, 0), norm = 0;
  for (std::size_t i = 0; i < x.size(); ++i) least = std::min(least, closed(i, 0));
  for (std::size_t j = 0; j < y.size(); ++j) least = std::min(least, closed(0, j));
  for (float value : x) norm += double(value);
  for (float value : y) norm += double(value);
  CHECK(least > 0);
  CHECK_NEAR(Amf::align_animations(warped, other, of_mean).cost, least / norm, 1e-6);

  // half of it is nearly as the other half: one cycle, as long as it is played without end; twice the same: two
  for (double odd : {0.4, 0.}) {
    Field halves(1, 40);
    for (std::size_t f = 0; f < 40; ++f)
      halves(0, f) = 2 + std::cos(4 * pi * double(f) / 40) + odd * std::cos(2 * pi * double(f) / 40);
    Amf::Activity_options around;
    around.is_cyclic = true;
    const Amf::Activity loop = Amf::animation_activity(halves, {1.}, {}, frame, around);
    CHECK_NEAR(loop.cycle.period, (odd > 0 ? 40 : 20) * frame, 1e-9);
    CHECK_NEAR(loop.cycle.strength, 1, 1e-6);
  }

  // of features, whose Gaussians go around
  const Amf::Feature_point event = feature_at(0, 0.1, 1, 0.2);
  Amf::Activity_options cyclic;
  cyclic.is_cyclic = true;
  const Amf::Activity of_event = Amf::activity_of_features({event}, 30, frame, cyclic);
  for (std::size_t k : {1, 7, 14}) CHECK_NEAR(of_event.mean[3 + k], of_event.mean[(33 - k) % 30], 1e-5);
}

// ----------------------------------------------------------------------------------------------------------- events

void test_events()
{
  Random random(5);
  Points places;
  std::vector<double> times, sigmas;
  for (int i = 0; i < 12; ++i) {
    places.push_back(random.vector());
    times.push_back(0.3 * i);
    sigmas.push_back(random.power(0.05, 0.8));
  }
  const Amf::Described_features a = body(places, times, sigmas);
  const Amf::Event_alignment same = Amf::align_events(a, a);
  CHECK(same.pairs.size() == 12 && same.only_a.empty() && same.only_b.empty());
  CHECK_NEAR(same.score, 12, 1e-9);
  for (std::size_t i = 0; i < same.pairs.size(); ++i) CHECK(same.pairs[i].a == i && same.pairs[i].b == i);
  // without two that follow one another: one gap of two
  const auto without = [](auto v) {
    v.erase(v.begin() + 5, v.begin() + 7);
    return v;
  };
  Amf::Described_features b = body(without(places), without(times), without(sigmas));
  for (std::size_t i = 0; i < b.features.size(); ++i) b.features[i].amplitude = a.features[i < 5 ? i : i + 2].amplitude;
  const Amf::Event_alignment gap = Amf::align_events(a, b);
  CHECK(gap.pairs.size() == 10 && gap.only_b.empty());
  CHECK(gap.only_a == std::vector<std::size_t>({5, 6}));
  CHECK_NEAR(gap.score, 10 - 0.4 - 0.1, 1e-9);
  const Amf::Event_alignment back = Amf::align_events(b, a);
  CHECK(back.only_b == gap.only_a);
  CHECK(Amf::align_events(a, body({}, {}, {})).pairs.empty());

  // two takes: one event is missing, one is stronger
  Amf::Animation_signature x, y;
  x.vertices = y.vertices = 12;
  x.diagonal = y.diagonal = 4;
  x.frame_duration = y.frame_duration = 1. / 30;
  x.events = y.events = a;
  y.events.features[3].amplitude += 0.5;
  y.events.features.erase(y.events.features.begin() + 8);
  const std::vector<Amf::Event_difference> differences = Amf::event_differences(x, y, Amf::Time_alignment());
  CHECK(differences.size() == 12);
  CHECK(differences[0].a && *differences[0].a == 8 && !differences[0].b);
  CHECK_NEAR(differences[0].amplitude, a.features[8].amplitude, 1e-12);
  CHECK(differences[1].a && differences[1].b && *differences[1].a == 3);
  CHECK_NEAR(differences[1].amplitude, 0.5, 1e-12);
  CHECK_NEAR(differences[2].amplitude, 0, 1e-12);
}

// Events that go around, seen from two beginnings.
void test_events_of_loops()
{
  Random random(7);
  const double loop = 3.6, ahead = 1.5;
  Points places;
  std::vector<double> times, later, sigmas;
  for (int i = 0; i < 12; ++i) {
    places.push_back(random.vector());
    times.push_back(0.3 * i);
    later.push_back(std::fmod(0.3 * i - ahead + loop, loop));
    sigmas.push_back(random.power(0.05, 0.8));
  }
  Amf::Animation_signature x, y;
  x.vertices = y.vertices = 12;
  x.diagonal = y.diagonal = 4;
  x.frame_duration = y.frame_duration = 1. / 30;
  x.events = body(places, times, sigmas);
  y.events = body(places, later, sigmas);
  CHECK(Amf::match_features(x.events, y.events).size() < 12);
  x.events.loop = y.events.loop = loop;
  const std::vector<Amf::Feature_match> matches = Amf::match_features(x.events, y.events);
  CHECK(matches.size() == 12);
  for (const Amf::Feature_match& m : matches) CHECK(m.a == m.b);
  Amf::Time_alignment alignment;
  alignment.times_a = {0, loop};
  alignment.times_b = {loop - ahead, 2 * loop - ahead};
  alignment.period_a = alignment.period_b = loop;
  CHECK(Amf::align_events(x.events, y.events).pairs.size() < 12);
  CHECK(Amf::align_events(x.events, y.events, alignment).pairs.size() == 12);
  CHECK(Amf::align_events(y.events, x.events, alignment.reversed()).pairs.size() == 12);
  const std::vector<Amf::Event_difference> differences = Amf::event_differences(x, y, alignment);
  CHECK(differences.size() == 12 && differences[0].amplitude == 0);

  // cycles of which each of the second one is like the one before of the first one: the alignment says which it is
  const std::size_t cycles = 3, of_a_cycle = 6;
  Points again;
  std::vector<double> at, of_a, of_b;
  for (std::size_t i = 0; i < cycles * of_a_cycle; ++i) {
    again.push_back(places[i % of_a_cycle]);
    at.push_back(double(i / of_a_cycle) + 0.13 * double(i % of_a_cycle));
    of_a.push_back(1e-3 * std::pow(20., double(i / of_a_cycle)));
    of_b.push_back(of_a.back() / 20);
  }
  Amf::Animation_signature p, q;
  p.events = body(again, at, of_a);
  q.events = body(again, at, of_b);
  Amf::Time_alignment even;
  even.times_a = even.times_b = {0, 3};
  const auto latest = [&](const std::vector<Amf::Feature_match>& pairs) {
    double late = 0;
    for (const Amf::Feature_match& m : pairs) late = std::max(late, std::abs(at[m.b] - at[m.a]));
    return late;
  };
  CHECK(latest(Amf::match_aligned_features(p, q, even)) > 0.9); // no cycles: the alignment says nothing
  p.activity.cycle = q.activity.cycle = {1, 1};
  const std::vector<Amf::Feature_match> in_cycle = Amf::match_aligned_features(p, q, even);
  CHECK(in_cycle.size() >= 12 && latest(in_cycle) < 0.1);
}

void test_scaling()
{
  Random random(6);
  const std::size_t n = 9;
  std::vector<double> x(2 * n), d(n * n);
  for (double& c : x) c = random(-1, 1);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) d[i * n + j] = std::hypot(x[2 * i] - x[2 * j], x[2 * i + 1] - x[2 * j + 1]);
  const auto places = Amf::classical_scaling(d, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      CHECK_NEAR(std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]), d[i * n + j], 1e-5);
  CHECK(Amf::classical_scaling({}, 0).empty());
  CHECK_THROWS(Amf::Option_error, Amf::classical_scaling({1}, 2), "distances");
}

int main()
{
  test_neighbourhood();
  test_descriptors();
  test_landmarks();
  test_matching();
  test_alignment();
  test_cancelled();
  test_distance();
  test_pose_variation();
  test_cycles();
  test_loops();
  test_events();
  test_events_of_loops();
  test_scaling();
  return test_result();
}
