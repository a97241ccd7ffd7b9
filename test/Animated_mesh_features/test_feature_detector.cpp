// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The second stage on its own: fields of the user's own over a rest shape, without any animation. What is found and what is
// refused, other selections from what is known, samplings with few levels, stages and threads, and cyclic animations: the
// same features wherever a period begins, and those of any period among others.

#include "test_bumpy_sphere.h"
#include "test_support.h"
#include "test_two_stages.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/last_frame_repeats_first.h>
#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test_support;
namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef AMF::Feature_detector<double> Detector;
typedef Detector::Field Field;
typedef std::vector<Detector::Feature> Features;
using AMF::Rest_shape;
using AMF::Stage;

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

// A Gaussian blob.
template <class FT = double>
AMF::Spatio_temporal_field<FT> field_of(const Bumpy_sphere& sphere, const Bump& blob)
{
  const Point_3 c = sphere.place(blob);
  AMF::Spatio_temporal_field<FT> field(sphere.rest.size(), sphere.frames.size());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      field(v, f) = FT(
          std::exp(-CGAL::squared_distance(c, sphere.rest[v]) / (2 * blob.width * blob.width) -
                   std::pow(double(f) * sphere.frame_duration - blob.time, 2) / (2 * blob.duration * blob.duration)));
  return field;
}

// The stages that a detector tells of.
struct Stages
{
  std::vector<Stage> begun;

  void begin(Stage stage)
  {
    if (std::find(begun.begin(), begun.end(), stage) == begun.end()) begun.push_back(stage);
  }
  bool progress(Stage, double) { return true; }
  void end(Stage) {}
};

// A blob has one feature, with the blob's place, time and scales.
void test_blob(const Bumpy_sphere& sphere, const Rest_shape& shape)
{
  const Bump blob = {{{0.1, -0.8, 0.3}}, 0.3, 1, 0.5, 0.09};
  const Field field = field_of(sphere, blob);
  Detector detector(shape, field, sphere.frame_duration);
  CHECK(detector.number_of_minima() == 0 && detector.sigma_levels().empty() && detector.tau_levels().empty());
  Features features;
  Stages stages;
  detector(std::back_inserter(features), stages);
  CHECK(stages.begun == std::vector<Stage>({Stage::SCALE_SPACE, Stage::EXTREMA}));
  CHECK(detector.number_of_minima() >= 1 && detector.sigma_levels().size() >= 5 && detector.tau_levels().size() >= 5);
  CHECK(features.size() == 1);
  if (features.empty()) return;
  const Detector::Feature& found = features[0];
  const Point_3 c = sphere.place(blob);
  CHECK_NEAR(found.time, blob.time, 0.01);
  CHECK(found.time == found.refined_frame * sphere.frame_duration);
  CHECK_NEAR(found.sigma, blob.width, 0.1 * blob.width);
  CHECK_NEAR(found.tau, blob.duration, 0.1 * blob.duration);
  CHECK(CGAL::squared_distance(c, sphere.rest[found.vertex_index]) < 0.15 * 0.15);
  CHECK(found.vertex == found.vertex_index && found.position == found.rest_position);
  CHECK(same(detect_with(detector), features)); // asked again

  // a field that is moved into a detector is not copied
  Field moved = field;
  const double* const values = moved.row(0);
  AMF::Feature_detector<double, AMF::Extremum_options<>, CGAL::Sequential_tag> sequential(shape, std::move(moved),
                                                                                          sphere.frame_duration);
  CHECK(sequential.field().row(0) == values);
  CHECK(same(detect_with(sequential), features));

  // whose types can be left to the compiler
  AMF::Feature_detector deduced(shape, field, sphere.frame_duration, AMF::calibrated_options());
  static_assert(std::is_same<decltype(deduced), AMF::Feature_detector<double, AMF::Calibrated_options>>::value, "");
  CHECK(same(detect_with(deduced), features));

  AMF::Feature_detector single_precision(shape, field_of<float>(sphere, blob), sphere.frame_duration);
  static_assert(std::is_same<decltype(single_precision), AMF::Feature_detector<float>>::value, "");
  const auto rounded = detect_with(single_precision);
  CHECK(rounded.size() == 1 && rounded[0].vertex == found.vertex && rounded[0].frame == found.frame);
  if (!rounded.empty()) CHECK_NEAR(rounded[0].strength, found.strength, 1e-6 * found.strength);

  // nothing is weaker than the noise
  const auto number_above = [&](double noise) {
    return detect_with(AMF::Feature_detector(shape, field, sphere.frame_duration, AMF::Extremum_options<>(), noise))
        .size();
  };
  CHECK(number_above(-0.9 * found.response) == 1);
  CHECK(number_above(-1.01 * found.response) == 0);
}

void test_refused(const Bumpy_sphere& sphere, const Rest_shape& shape)
{
  const double dt = sphere.frame_duration;
  const auto with_noise = [&](double noise) {
    return Detector(shape, Field(642, 24), dt, AMF::Extremum_options<>(), noise);
  };
  CHECK_THROWS(AMF::Option_error, Detector(shape, Field(641, 24), dt), "641 rows");
  CHECK_THROWS(AMF::Option_error, Detector(shape, Field(643, 24), dt), "643 rows, the rest shape 642 vertices");
  CHECK_THROWS(AMF::Option_error, Detector(Rest_shape(), Field(642, 24), dt), "0 vertices");
  CHECK_THROWS(AMF::Input_error, Detector(shape, Field(642, 2), dt), "2 frame(s); at least 3");
  CHECK_THROWS(AMF::Input_error, Detector(shape, Field(), dt), "0 frame(s); at least 3");
  for (double bad : {0., -1., infinity, not_a_number})
    CHECK_THROWS(AMF::Input_error, Detector(shape, Field(642, 24), bad), "must be positive");
  for (double bad : {-1., -1e-300, -infinity, not_a_number})
    CHECK_THROWS(AMF::Option_error, with_noise(bad), "must not be negative");
  CHECK(detect_with(with_noise(infinity)).empty());
  for (double bad : {infinity, -infinity, not_a_number}) {
    Field field(642, 24);
    field(5, 6) = bad;
    CHECK_THROWS(AMF::Input_error, Detector(shape, field, dt), "frame 6: the field is not finite at vertex 5");
    field(5, 3) = bad; // the first vertex is told, and its first frame
    field(6, 0) = bad;
    CHECK_THROWS(AMF::Input_error, Detector(shape, field, dt), "frame 3: the field is not finite at vertex 5");
  }
  CHECK(detect_with(Detector(shape, Field(642, 3), dt)).empty()); // as few as can be
}

// Another threshold from what is known, against a detector that starts with it; on noise, which has many minima.
void test_reuse(const Bumpy_sphere& sphere, const Rest_shape& shape)
{
  std::mt19937 random(1);
  Field noise(shape.number_of_vertices(), sphere.frames.size());
  for (std::size_t v = 0; v < noise.number_of_rows(); ++v)
    for (std::size_t f = 0; f < noise.number_of_frames(); ++f) noise(v, f) = double(random()) / double(random.max());
  Detector detector(shape, noise, sphere.frame_duration);
  detector.selection().min_fit = 0;
  const double middle = detect_with(detector).front().strength / 2;
  std::vector<std::size_t> numbers;
  for (double relative : {0.9, 0.0, 0.2})
    for (bool suppress : {false, true})
      for (double absolute : {0., middle}) {
        AMF::Feature_selection selection;
        selection.relative_threshold = relative;
        selection.absolute_threshold = absolute;
        selection.suppress_non_maxima = suppress;
        selection.min_fit = 0;
        AMF::Calibrated_options options;
        options.selection = selection;
        AMF::Feature_detector fresh(shape, noise, sphere.frame_duration, options); // takes the selection of its options
        detector.selection() = selection;
        const Features features = detect_with(detector);
        CHECK(same(features, detect_with(fresh)));
        numbers.push_back(features.size());
        const double least = features.empty() ? 0 : relative * features.front().strength;
        for (std::size_t i = 0; i < features.size(); ++i) {
          CHECK(features[i].strength >= least && features[i].strength >= absolute);
          CHECK(i == 0 || features[i].strength <= features[i - 1].strength);
        }
      }
  std::cout << detector.number_of_minima() << " minima;";
  for (std::size_t n : numbers) std::cout << " " << n;
  std::cout << " features by thresholds" << std::endl;
  // the thresholds and the suppression do something
  CHECK(*std::min_element(numbers.begin(), numbers.end()) < *std::max_element(numbers.begin(), numbers.end()));
  CHECK(*std::max_element(numbers.begin(), numbers.end()) == detector.number_of_minima());
  detector.selection() = AMF::Feature_selection();
  for (double bad : {1.1, std::numeric_limits<double>::quiet_NaN()}) {
    detector.selection().min_fit = bad;
    CHECK_THROWS(AMF::Option_error, detect_with(detector), "least fit");
  }
  detector.selection() = AMF::Feature_selection();
  for (double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    detector.selection().relative_threshold = bad;
    CHECK_THROWS(AMF::Option_error, detect_with(detector), "relative threshold");
  }
  detector.selection() = AMF::Feature_selection();
  detector.selection().absolute_threshold = -1;
  CHECK_THROWS(AMF::Option_error, detect_with(detector), "absolute threshold");
}

// A sampling with as many levels as it is told.
struct Few_levels
{
  std::size_t space_levels, time_levels;

  template <class SpatialFilter, class TemporalFilter>
  AMF::Scale_levels operator()(const AMF::Rest_shape&, std::size_t, double, const SpatialFilter&,
                               const TemporalFilter&) const
  {
    AMF::Scale_levels levels;
    for (std::size_t k = 0; k < space_levels; ++k) levels.space_variances.push_back(0.02 * double(k + 1));
    for (std::size_t l = 0; l < time_levels; ++l) levels.time_variances.push_back(0.002 * double(l + 1));
    return levels;
  }
};

// A minimum between scales has a scale on either side, each with a central difference: five levels.
void test_number_of_levels(const Bumpy_sphere& sphere, const Rest_shape& shape)
{
  const auto try_with = [&](std::size_t space_levels, std::size_t time_levels) {
    const auto options = AMF::calibrated_options().with_sampling(Few_levels{space_levels, time_levels});
    const Field zeros(shape.number_of_vertices(), sphere.frames.size());
    AMF::Feature_detector detector(shape, zeros, sphere.frame_duration, options);
    CHECK(detect_with(detector).empty());
  };
  try_with(5, 5);
  for (std::size_t few : {0, 1, 2, 3, 4}) {
    CHECK_THROWS(AMF::Option_error, try_with(few, 5), "levels");
    CHECK_THROWS(AMF::Option_error, try_with(5, few), "levels");
  }
}

// What the detector finds with ends that are reflected or joined, with tau from a frame to a quarter of 36.
Features features_of(const Rest_shape& shape, const Field& field, AMF::Boundary_condition ends)
{
  const double dt = 1. / 24;
  AMF::Extremum_options<> options;
  options.temporal_filter = AMF::Gaussian_temporal_filter(ends);
  options.sampling.tau = {dt, 9 * dt};
  Detector detector(shape, field, dt, options);
  detector.selection().min_fit = -1;
  detector.selection().relative_threshold = 0;
  return detect_with(detector);
}

// Frames [first, first + count) of a field that goes on for ever.
Field frames_of(const Field& field, std::size_t first, std::size_t count)
{
  Field result(field.number_of_rows(), count);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < count; ++f) result(v, f) = field(v, (first + f) % field.number_of_frames());
  return result;
}

// The features in frames [first, first + period), with the times that they have if the period begins in frame `start`, in
// an order that does not depend on rounding; of their parents the vertices.
typedef std::tuple<std::size_t, std::size_t, std::size_t> Key;
std::vector<std::pair<Key, Detector::Feature>> of_period(const Features& features, std::size_t first,
                                                         std::size_t period, std::size_t start)
{
  std::vector<std::pair<Key, Detector::Feature>> result;
  for (Detector::Feature f : features) {
    if (f.frame < first || f.frame >= first + period) continue;
    f.frame = (f.frame + start) % period;
    f.refined_frame = std::fmod(f.refined_frame + double(start + period), double(period));
    const std::size_t parent = f.parent == f.none ? f.none : features[f.parent].vertex_index;
    result.emplace_back(Key(f.vertex_index, f.frame, parent), f);
  }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.sigma) < std::tie(b.first, b.second.sigma);
  });
  return result;
}

void test_periods(const Rest_shape& shape)
{
  constexpr std::size_t period = 36;
  std::mt19937 random(2);
  Field field(shape.number_of_vertices(), period);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < period; ++f) field(v, f) = double(random()) / double(random.max());
  const auto joined = AMF::Boundary_condition::PERIODIC, reflected = AMF::Boundary_condition::REFLECT;
  const Features features = features_of(shape, field, joined);
  const auto expected = of_period(features, 0, period, 0);
  CHECK(expected.size() == features.size() && expected.size() > 100);
  CHECK(std::all_of(features.begin(), features.end(),
                    [](const auto& f) { return f.refined_frame >= 0 && f.refined_frame < 36; }));
  double largest = 0;
  const auto compare = [&](const auto& found) {
    CHECK(found.size() == expected.size());
    for (std::size_t i = 0; i < (std::min)(found.size(), expected.size()); ++i) {
      const Detector::Feature &a = found[i].second, &b = expected[i].second;
      CHECK(found[i].first == expected[i].first);
      const double frames = std::abs(a.refined_frame - b.refined_frame);
      for (double difference : {(std::min)(frames, double(period) - frames), a.sigma / b.sigma - 1, a.tau / b.tau - 1,
                                a.amplitude / b.amplitude - 1, a.strength - b.strength, a.fit - b.fit})
        largest = (std::max)(largest, std::abs(difference));
    }
  };
  for (std::size_t start : {std::size_t(1), std::size_t(20), period - 1})
    compare(of_period(features_of(shape, frames_of(field, start, period), joined), 0, period, start));
  // so many that the largest tau does not see the ends
  compare(of_period(features_of(shape, frames_of(field, 0, 9 * period), reflected), 4 * period, period, 0));
  compare(of_period(features_of(shape, frames_of(field, 0, 2 * period), joined), period, period, 0));
  const auto in_ends = std::count_if(features.begin(), features.end(), [](const auto& f) { return f.frame % 35 == 0; });
  std::cout << features.size() << " features of a cyclic animation, " << in_ends
            << " in its first or last frame, differ by " << largest << std::endl;
  CHECK(in_ends > 3 && largest < 1e-9);
}

// A single wave, the slowest event of a period, is found, wherever its crest is.
void test_wave(const Bumpy_sphere& sphere, const Rest_shape& shape)
{
  const std::size_t frames = 40;
  const Bump place = {{{0.1, -0.8, 0.3}}, 0.2, 1, 0, 0};
  for (double crest : {0., 17.3, 39.7}) {
    Field field(shape.number_of_vertices(), frames);
    for (std::size_t v = 0; v < field.number_of_rows(); ++v)
      for (std::size_t f = 0; f < frames; ++f)
        field(v, f) =
            std::exp(-CGAL::squared_distance(sphere.place(place), sphere.rest[v]) / (2 * place.width * place.width)) *
            (1 + std::cos(2 * std::acos(-1.) * (double(f) - crest) / double(frames)));
    AMF::Extremum_options<> options;
    options.temporal_filter = AMF::Gaussian_temporal_filter(AMF::Boundary_condition::PERIODIC);
    Detector detector(shape, field, 0.1, options);
    const Features features = detect_with(detector);
    CHECK(features.size() == 1);
    if (features.empty()) continue;
    const Detector::Feature& found = features[0];
    CHECK(found.frame == std::size_t(std::lround(crest)) % frames);
    const double off = std::abs(found.refined_frame - crest);
    CHECK((std::min)(off, 40 - off) < 0.05);
    CHECK_NEAR(found.tau, 0.2 * 4, 0.05 * 4);
    CHECK(!found.at_scale_limit && found.fit > 0.9);
    std::cout << "a wave of 4 s: tau " << found.tau << " s, fit " << found.fit << std::endl;
  }
}

// Vertices that go round, each in its own phase, on a body that walks on.
template <class FT>
bool is_repeated(std::size_t frames, double period, double step, double noise = 0)
{
  AMF::Spatio_temporal_field<FT> x(7, frames), y(7, frames), z(7, frames);
  std::mt19937 random(4);
  const auto error = [&] { return noise * (double(random()) / double(random.max()) - 0.5); };
  for (std::size_t v = 0; v < 7; ++v)
    for (std::size_t f = 0; f < frames; ++f) {
      const double angle = 2 * std::acos(-1.) * double(f) / period + double(v);
      x(v, f) = FT(std::cos(angle) + step * double(f) + error());
      y(v, f) = FT(std::sin(angle) * double(v) - 2 * step * double(f) + error());
      z(v, f) = FT(double(v) + error());
    }
  return AMF::last_frame_repeats_first(x, y, z);
}

void test_repeated_frame()
{
  for (double step : {0., 0.7}) {
    CHECK(is_repeated<double>(20, 19, step) && is_repeated<float>(20, 19, step) && is_repeated<float>(500, 499, step));
    CHECK(!is_repeated<double>(20, 20, step) && !is_repeated<float>(20, 21, step) && !is_repeated<double>(20, 18, step));
    CHECK(is_repeated<double>(20, 19, step, 1e-3) && !is_repeated<double>(20, 19, step, 0.1));
    CHECK(!is_repeated<double>(20, infinity, step)); // nothing but the walk
  }
  CHECK(!is_repeated<double>(2, 1, 0));
  // at rest before and after a motion
  Field rests(3, 20);
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t f = 5; f < 15; ++f) rests(v, f) = double(v * f);
  CHECK(!AMF::last_frame_repeats_first(rests, rests, rests));
}

int main()
{
  const Bumpy_sphere sphere;
  Mesh mesh;
  add_sphere(sphere, mesh);
  const Rest_shape shape = AMF::rest_shape_of_mesh(mesh);
  test_blob(sphere, shape);
  test_refused(sphere, shape);
  test_reuse(sphere, shape);
  test_number_of_levels(sphere, shape);
  test_repeated_frame();
  test_periods(shape);
  test_wave(sphere, shape);
  return test_result();
}
