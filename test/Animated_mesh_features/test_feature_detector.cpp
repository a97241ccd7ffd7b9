// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The detector as an object: progress and cancellation, use for several detections, animations that are no Frame_sequence,
// fields of the user's own, options that make no sense, and the same bits from any number of threads.

#include "test_same_features.h"

#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Surface_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

using namespace test_support;
namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef AMF::Frame_sequence<Mesh> Sequence;
typedef AMF::Feature_detector<Sequence> Detector;
typedef std::vector<Detector::Feature> Features;
using AMF::Stage;

const std::vector<Stage> all_stages = {Stage::GEODESIC_BALLS, Stage::STRAIN, Stage::CURVATURE, Stage::SCALE_SPACE,
                                       Stage::EXTREMA};

bool same(const Features& a, const Features& b)
{
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].vertex != b[i].vertex || a[i].vertex_index != b[i].vertex_index || a[i].frame != b[i].frame ||
        a[i].time != b[i].time || a[i].triangle != b[i].triangle ||
        a[i].barycentric_coordinates != b[i].barycentric_coordinates || a[i].position != b[i].position ||
        a[i].rest_position != b[i].rest_position || a[i].sigma != b[i].sigma || a[i].tau != b[i].tau ||
        a[i].response != b[i].response || a[i].at_scale_limit != b[i].at_scale_limit)
      return false;
  return true;
}

template <class Some_detector>
Features detect_with(Some_detector& detector)
{
  Features features;
  detector(std::back_inserter(features));
  return features;
}

// Writes down what it is told, checks that it is told in order, and cancels at a certain call of a certain stage.
class Recorder
{
public:
  void begin(Stage stage)
  {
    here();
    CHECK(!m_running);
    m_running = true;
    m_stage = stage;
    if (m_order.empty() || m_order.back() != stage) m_order.push_back(stage);
  }

  bool progress(Stage stage, double fraction)
  {
    here();
    CHECK(m_running && m_stage == stage);
    CHECK(fraction >= m_fraction[stage] && fraction <= 1);
    m_fraction[stage] = fraction;
    ++m_calls[stage];
    return !(stage == m_cancel_stage && m_calls[stage] == m_cancel_call);
  }

  void end(Stage stage)
  {
    here();
    CHECK(m_running && m_stage == stage);
    m_running = false;
  }

  void cancel_at(Stage stage, std::size_t call)
  {
    m_cancel_stage = stage;
    m_cancel_call = call;
  }

  bool running() const { return m_running; }
  double fraction(Stage stage) { return m_fraction[stage]; }
  std::size_t calls(Stage stage) { return m_calls[stage]; }
  std::size_t calls() const
  {
    std::size_t n = 0;
    for (const auto& c : m_calls) n += c.second;
    return n;
  }
  const std::vector<Stage>& order() const { return m_order; }

private:
  void here() const { CHECK(std::this_thread::get_id() == m_thread); }

  std::thread::id m_thread = std::this_thread::get_id();
  bool m_running = false;
  Stage m_stage = Stage::STRAIN;
  std::map<Stage, double> m_fraction;
  std::map<Stage, std::size_t> m_calls;
  std::vector<Stage> m_order;
  Stage m_cancel_stage = Stage::STRAIN;
  std::size_t m_cancel_call = 0;
};

// The calling thread tells between its own tasks: how often depends on how many of them other threads take.
class Single_thread
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control m_limit{tbb::global_control::max_allowed_parallelism, 1};
#endif
};

void test_progress(const Sequence& sequence, const Features& expected, std::size_t least_calls)
{
  Detector detector(sequence);
  Recorder recorder;
  Features features;
  detector(std::back_inserter(features), recorder);
  CHECK(same(features, expected));
  CHECK(!recorder.running());
  CHECK(recorder.order() == all_stages);
  for (Stage stage : all_stages) {
    CHECK(recorder.calls(stage) >= least_calls);
    CHECK(recorder.fraction(stage) == 1);
  }

  // what is known is not computed again
  Recorder idle;
  features.clear();
  detector(std::back_inserter(features), idle);
  CHECK(same(features, expected));
  CHECK(idle.calls() == 0 && idle.order().empty());

  // fields on their own report their own stages
  Detector fields(sequence);
  Recorder one;
  fields.strain(one);
  CHECK(one.order() == std::vector<Stage>{Stage::STRAIN});
  fields.deformation(one);
  CHECK(one.order() == std::vector<Stage>({Stage::STRAIN, Stage::GEODESIC_BALLS, Stage::CURVATURE}));
}

// Whatever the other threads do, whoever says no at the first or second call is not asked again.
void test_parallel_cancellation(const Sequence& sequence, const Features& expected)
{
  for (Stage stage : all_stages)
    for (std::size_t call : {1, 2}) {
      Detector detector(sequence);
      Recorder recorder;
      recorder.cancel_at(stage, call);
      Features features;
      CHECK_THROWS(AMF::Cancelled, detector(std::back_inserter(features), recorder), "cancelled");
      CHECK(features.empty() && !recorder.running());
      CHECK(recorder.order().back() == stage && recorder.calls(stage) == call);
      CHECK(same(detect_with(detector), expected));
    }
}

void test_cancellation(const Sequence& sequence, const Features& expected)
{
  const Single_thread single_thread;
  Recorder complete;
  {
    Detector detector(sequence);
    Features features;
    detector(std::back_inserter(features), complete);
  }
  for (Stage stage : all_stages)
    for (std::size_t call : {std::size_t(1), complete.calls(stage) / 2, complete.calls(stage)}) {
      Detector detector(sequence);
      Recorder recorder;
      recorder.cancel_at(stage, call);
      Features features;
      CHECK_THROWS(AMF::Cancelled, detector(std::back_inserter(features), recorder), "cancelled");
      CHECK(features.empty());
      CHECK(!recorder.running()); // also the stage that was cancelled has ended
      CHECK(recorder.order().back() == stage);
      CHECK(recorder.calls(stage) == call); // and was not asked again
      CHECK(same(detect_with(detector), expected));
    }
}

// Another threshold from what is known, against a detector that starts with it; on noise, which has many minima.
void test_reuse(const Sequence& sequence)
{
  std::mt19937 random(1);
  Detector::Field noise(sequence.number_of_vertices(), sequence.number_of_frames());
  for (std::size_t v = 0; v < noise.number_of_rows(); ++v)
    for (std::size_t f = 0; f < noise.number_of_frames(); ++f) noise(v, f) = double(random()) / double(random.max());
  Detector detector(sequence);
  detector.set_deformation(noise);
  const double middle = detect_with(detector).front().strength() / 2;
  std::vector<std::size_t> numbers;
  for (double relative : {0.9, 0.0, 0.2})
    for (bool suppress : {false, true})
      for (double absolute : {0., middle}) {
        AMF::Calibrated_options options;
        options.selection.relative_threshold = relative;
        options.selection.absolute_threshold = absolute;
        options.selection.suppress_non_maxima = suppress;
        Detector fresh(sequence, options);
        fresh.set_deformation(noise);
        detector.selection() = options.selection;
        const Features features = detect_with(detector);
        CHECK(same(features, detect_with(fresh)));
        numbers.push_back(features.size());
        const double least = features.empty() ? 0 : relative * features.front().strength();
        for (std::size_t i = 0; i < features.size(); ++i) {
          CHECK(features[i].strength() >= least && features[i].strength() >= absolute);
          CHECK(i == 0 || features[i].strength() <= features[i - 1].strength());
        }
      }
  std::cout << detector.number_of_minima() << " minima;";
  for (std::size_t n : numbers) std::cout << " " << n;
  std::cout << " features by thresholds" << std::endl;
  // the thresholds and the suppression do something
  CHECK(*std::min_element(numbers.begin(), numbers.end()) < *std::max_element(numbers.begin(), numbers.end()));
  CHECK(*std::max_element(numbers.begin(), numbers.end()) == detector.number_of_minima());
  detector.selection() = AMF::Feature_selection();
  for (double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    detector.selection().relative_threshold = bad;
    CHECK_THROWS(AMF::Option_error, detect_with(detector), "relative threshold");
  }
  detector.selection() = AMF::Feature_selection();
  detector.selection().absolute_threshold = -1;
  CHECK_THROWS(AMF::Option_error, detect_with(detector), "absolute threshold");
}

// An animation that is computed when it is asked for.
class Own_animation
{
public:
  typedef Mesh Triangle_mesh;
  typedef double FT;

  struct Point_map
  {
    typedef Mesh::Vertex_index key_type;
    typedef Point_3 value_type;
    typedef Point_3 reference;
    typedef boost::readable_property_map_tag category;
    const std::vector<Point_3>* points;
    friend Point_3 get(const Point_map& map, Mesh::Vertex_index v) { return (*map.points)[v.idx()]; }
  };

  Own_animation(const Bumpy_sphere& sphere, const Mesh& mesh)
    : m_sphere(&sphere)
    , m_mesh(&mesh)
  {}
  const Mesh& triangle_mesh() const { return *m_mesh; }
  std::size_t number_of_frames() const { return m_sphere->frames.size(); }
  double frame_duration() const { return m_sphere->frame_duration; }
  Point_map point_map(std::size_t f) const { return Point_map{&m_sphere->frames[f]}; }
  Mesh::Property_map<Mesh::Vertex_index, Point_3> rest_point_map() const { return m_mesh->points(); }

private:
  const Bumpy_sphere* m_sphere;
  const Mesh* m_mesh;
};

void test_own_animation(const Bumpy_sphere& sphere, const Mesh& mesh, const Features& expected)
{
  const Own_animation animation(sphere, mesh);
  Features features;
  CGAL::detect_spatio_temporal_features<CGAL::Sequential_tag>(animation, std::back_inserter(features));
  CHECK(same(features, expected));
}

void test_threads(const Sequence& sequence, const Features& expected)
{
  AMF::Feature_detector<Sequence, AMF::Calibrated_options, CGAL::Sequential_tag> sequential(sequence);
  CHECK(same(detect_with(sequential), expected));
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    AMF::Feature_detector<Sequence, AMF::Calibrated_options, CGAL::Parallel_tag> parallel(sequence);
    CHECK(same(detect_with(parallel), expected));
  }
#else
  std::cout << "compiled without TBB: Parallel_tag not tested" << std::endl;
#endif
}

// A Gaussian blob as a field of the user's own has one feature.
void test_own_field(const Bumpy_sphere& sphere, const Sequence& sequence, const Features& expected)
{
  const Bump blob = {{{0.1, -0.8, 0.3}}, 0.3, 1, 0.5, 0.09};
  const Point_3 c = sphere.place(blob);
  Detector::Field field(sequence.number_of_vertices(), sequence.number_of_frames());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      field(v, f) =
          std::exp(-CGAL::squared_distance(c, sphere.rest[v]) / (2 * blob.width * blob.width) -
                   std::pow(double(f) * sphere.frame_duration - blob.time, 2) / (2 * blob.duration * blob.duration));
  Detector detector(sequence);
  CHECK(same(detect_with(detector), expected));
  detector.set_deformation(field);
  const Features features = detect_with(detector);
  CHECK(features.size() == 1);
  if (!features.empty()) {
    CHECK_NEAR(features[0].time, blob.time, 0.01);
    CHECK_NEAR(features[0].sigma, blob.width, 0.1 * blob.width);
    CHECK_NEAR(features[0].tau, blob.duration, 0.1 * blob.duration);
    CHECK(CGAL::squared_distance(c, sphere.rest[features[0].vertex_index]) < 0.15 * 0.15);
  }
  // what is refused leaves the detector as it was
  CHECK_THROWS(AMF::Option_error, detector.set_deformation(Detector::Field(642, 23)), "642 x 23");
  CHECK_THROWS(AMF::Option_error, detector.set_deformation(Detector::Field(641, 24)), "641 x 24");
  field(5, 6) = std::numeric_limits<double>::infinity();
  CHECK_THROWS(AMF::Input_error, detector.set_deformation(field), "frame 6: the field is not finite at vertex 5");
  CHECK(same(detect_with(detector), features));
}

// A body that turns, in coordinates rounded as files round them: deformation is noise, and known to be, wherever it goes.
void test_rounded_coordinates(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  std::vector<std::vector<Point_3>> frames(12);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const double c = std::cos(0.1 * double(f)), s = std::sin(0.1 * double(f));
    for (const Point_3& p : sphere.rest)
      frames[f].emplace_back(float(c * p.x() - s * p.y()), float(s * p.x() + c * p.y()), float(p.z()));
  }
  const Sequence sequence(mesh, frames, sphere.frame_duration);
  Detector detector(sequence);
  CHECK(detect_with(detector).empty());
  CHECK(detector.number_of_minima() == 0);
  Detector other(sequence);
  other.set_deformation(detector.deformation(), detector.deformation_noise());
  CHECK(other.deformation_noise() == detector.deformation_noise());
  CHECK(detect_with(other).empty());
  CHECK_THROWS(AMF::Option_error, other.set_deformation(detector.deformation(), -1), "negative");
  other.set_deformation(detector.deformation()); // taken at its word
  CHECK(!detect_with(other).empty());
}

void test_option_errors(const Sequence& sequence)
{
  for (double bad : {-1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    AMF::Calibrated_options options;
    options.ball_radius = bad;
    Detector detector(sequence, options);
    CHECK_THROWS(AMF::Option_error, detect_with(detector), "radius");
  }
  AMF::Calibrated_options options;
  options.sampling.sigma = {0.5, 0.4};
  Detector empty(sequence, options);
  CHECK_THROWS(AMF::Option_error, detect_with(empty), "range of sigma");
  options.sampling.sigma = {1e-4, 1e-3};
  Detector fine(sequence, options);
  CHECK_THROWS(AMF::Option_error, detect_with(fine), "edge length");
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
void test_number_of_levels(const Sequence& sequence)
{
  const auto try_with = [&](std::size_t space_levels, std::size_t time_levels) {
    const auto options = AMF::calibrated_options().with_sampling(Few_levels{space_levels, time_levels});
    AMF::Feature_detector<Sequence, std::decay_t<decltype(options)>> detector(sequence, options);
    detector.set_deformation(Detector::Field(sequence.number_of_vertices(), sequence.number_of_frames()));
    CHECK(detect_with(detector).empty()); // a field of zeros
  };
  try_with(5, 5);
  for (std::size_t few : {0, 1, 2, 3, 4}) {
    CHECK_THROWS(AMF::Option_error, try_with(few, 5), "levels");
    CHECK_THROWS(AMF::Option_error, try_with(5, few), "levels");
  }
}

int main()
{
  const Bumpy_sphere sphere;
  Mesh mesh;
  add_sphere(sphere, mesh);
  const Sequence sequence = animated(sphere, mesh);
  Detector detector(sequence);
  const Features expected = detect_with(detector);
  CHECK(expected.size() == sphere.bumps.size());

  test_progress(sequence, expected, 2); // at the beginning and at the end
  {
    const Single_thread single_thread;
    test_progress(sequence, expected, 12); // 30 on larger meshes
  }
  test_cancellation(sequence, expected);
  test_parallel_cancellation(sequence, expected);
  test_reuse(sequence);
  test_own_animation(sphere, mesh, expected);
  test_threads(sequence, expected);
  test_own_field(sphere, sequence, expected);
  test_rounded_coordinates(sphere, mesh);
  test_option_errors(sequence);
  test_number_of_levels(sequence);
  return test_result();
}
