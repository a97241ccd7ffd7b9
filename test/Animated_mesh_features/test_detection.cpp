// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Whole detections: progress and cancellation, use for several detections, animations that are no Frame_sequence, the
// fields on the way, options that make no sense, and the same bits from any number of threads.

#include "test_recording_memory.h"
#include "test_same_features.h"
#include "test_two_stages.h"

#include <CGAL/Animated_mesh_features/Animation/as_frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Deformation/deformation.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <thread>
#include <vector>

using namespace test_support;
namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef AMF::Frame_sequence<Mesh> Sequence;
typedef Two_stages<Sequence> Detection;
typedef std::vector<Detection::Feature> Features;
using AMF::Stage;

const std::vector<Stage> all_stages = {Stage::GEODESIC_BALLS, Stage::STRAIN, Stage::CURVATURE, Stage::SCALE_SPACE,
                                       Stage::EXTREMA};

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
  Detection detector(sequence);
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

  // fields on their own report their own stages, and each of them once
  AMF::Deformation_measurement<Sequence> fields(sequence);
  Recorder one;
  fields.strain(one);
  CHECK(one.order() == std::vector<Stage>{Stage::STRAIN});
  fields.deformation(one);
  CHECK(one.order() == std::vector<Stage>({Stage::STRAIN, Stage::GEODESIC_BALLS, Stage::CURVATURE}));
  const std::size_t calls = one.calls();
  fields.deformation(one);
  fields.strain(one);
  fields.geodesic_balls(one);
  CHECK(one.calls() == calls);
}

// Whatever the other threads do, whoever says no at the first or second call is not asked again.
void test_parallel_cancellation(const Sequence& sequence, const Features& expected)
{
  for (Stage stage : all_stages)
    for (std::size_t call : {1, 2}) {
      Detection detector(sequence);
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
    Detection detector(sequence);
    Features features;
    detector(std::back_inserter(features), complete);
  }
  for (Stage stage : all_stages)
    for (std::size_t call : {std::size_t(1), complete.calls(stage) / 2, complete.calls(stage)}) {
      Detection detector(sequence);
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

// An animation that is computed when it is asked for, and counts how often it is.
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
    std::size_t* number_of_reads;
    friend Point_3 get(const Point_map& map, Mesh::Vertex_index v)
    {
      ++*map.number_of_reads;
      return (*map.points)[v.idx()];
    }
  };

  Own_animation(const Bumpy_sphere& sphere, const Mesh& mesh)
    : m_sphere(&sphere)
    , m_mesh(&mesh)
  {}
  const Mesh& triangle_mesh() const { return *m_mesh; }
  std::size_t number_of_frames() const { return m_sphere->frames.size(); }
  double frame_duration() const { return m_sphere->frame_duration; }
  Point_map point_map(std::size_t f) const { return Point_map{&m_sphere->frames[f], &m_number_of_reads}; }
  Mesh::Property_map<Mesh::Vertex_index, Point_3> rest_point_map() const { return m_mesh->points(); }

  std::size_t number_of_reads() const { return m_number_of_reads; }

private:
  const Bumpy_sphere* m_sphere;
  const Mesh* m_mesh;
  mutable std::size_t m_number_of_reads = 0;
};

void test_own_animation(const Bumpy_sphere& sphere, const Mesh& mesh, const Features& expected)
{
  const Own_animation animation(sphere, mesh);
  Features features;
  CGAL::detect_spatio_temporal_features<CGAL::Sequential_tag>(animation, std::back_inserter(features));
  CHECK(same(features, expected));
  // its positions are read once, whatever is computed from them
  const std::size_t positions = sphere.rest.size() * sphere.frames.size();
  CHECK(animation.number_of_reads() == positions);

  AMF::Deformation_measurement<Own_animation> measurement(animation);
  measurement.strain();
  measurement.curvature_change();
  measurement.deformation();
  CHECK(measurement.noise() > 0);
  CHECK(animation.number_of_reads() == 2 * positions);

  // a sequence of its own, in memory of one's own
  const auto memory = std::make_shared<Recording_memory>();
  const Sequence sequence = AMF::as_frame_sequence(animation, memory);
  CHECK(animation.number_of_reads() == 3 * positions);
  CHECK(sequence.trajectories().memory() == memory && memory->in_use() == 3);
  CHECK(&sequence.triangle_mesh() == &mesh && sequence.frame_duration() == sphere.frame_duration);
  bool is_same = true;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    is_same = is_same && get(sequence.rest_point_map(), v) == mesh.point(v);
    for (std::size_t f = 0; f < sphere.frames.size(); ++f)
      is_same = is_same && get(sequence.point_map(f), v) == sphere.frames[f][v.idx()];
  }
  CHECK(is_same);

  // a sequence needs no conversion
  CHECK(&AMF::as_frame_sequence(sequence) == &sequence);
  CHECK(&AMF::Deformation_measurement<Sequence>(sequence).sequence() == &sequence);
}

// Where a measure of its own is asked for before, the sum is the same.
void test_fields(const Sequence& sequence)
{
  typedef AMF::Deformation_measurement<Sequence> Measurement;
  const auto same_values = [](const Measurement::Field& a, const Measurement::Field& b) {
    bool equal = a.number_of_rows() == b.number_of_rows() && a.number_of_frames() == b.number_of_frames();
    for (std::size_t v = 0; equal && v < a.number_of_rows(); ++v)
      equal = std::equal(a.row(v), a.row(v) + a.number_of_frames(), b.row(v));
    return equal;
  };
  Measurement together(sequence), apart(sequence);
  const Measurement::Field expected = together.deformation();
  const Measurement::Field& strain = apart.strain();
  const Measurement::Field& change = apart.curvature_change();
  CHECK(same_values(strain, AMF::strain(sequence)));
  CHECK(same_values(change, AMF::curvature_change(sequence, apart.geodesic_balls())));
  CHECK(same_values(expected, apart.deformation()));
  CHECK(same_values(expected, AMF::deformation(strain, change)));

  // what is handed over is not kept
  const double* const values = apart.deformation().row(0);
  const Measurement::Field taken = apart.take_deformation();
  CHECK(taken.row(0) == values && same_values(expected, taken));
  CHECK(same_values(expected, apart.take_deformation()));
  CHECK(same_values(expected, apart.deformation()));

  // without curvature there is nothing to find balls for
  AMF::Deformation_options<> only_strain;
  only_strain.alpha = 0;
  Recorder recorder;
  AMF::Deformation_measurement<Sequence> no_curvature(sequence, only_strain);
  CHECK(same_values(strain, no_curvature.deformation(recorder)));
  CHECK(recorder.order() == std::vector<Stage>{Stage::STRAIN});
}

void test_threads(const Sequence& sequence, const Features& expected)
{
  Two_stages<Sequence, AMF::Calibrated_options, CGAL::Sequential_tag> sequential(sequence);
  CHECK(same(detect_with(sequential), expected));
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 3}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Two_stages<Sequence, AMF::Calibrated_options, CGAL::Parallel_tag> parallel(sequence);
    CHECK(same(detect_with(parallel), expected));
  }
#else
  std::cout << "compiled without TBB: Parallel_tag not tested" << std::endl;
#endif
}

// Features are placed where the surface is at their time.
void test_places(const Sequence& sequence)
{
  Detection detection(sequence);
  const Features features = detect_with(detection);
  auto field = detection.measurement().deformation();
  AMF::subtract_baseline(field, AMF::Least_value_baseline());
  AMF::Feature_detector<double> detector(sequence.rest_shape(), field, sequence.frame_duration(), {},
                                         detection.measurement().noise());
  detector.selection() = detection.selection();
  const auto on_rest_shape = detect_with(detector);
  CHECK(on_rest_shape.size() == features.size());
  for (std::size_t i = 0; i < features.size() && i < on_rest_shape.size(); ++i) {
    const auto& rest = on_rest_shape[i];
    CHECK(rest.vertex == rest.vertex_index && rest.position == rest.rest_position);
    const Detection::Feature placed = AMF::place_on_animation(rest, sequence);
    CHECK(same(Features{placed}, Features{features[i]}));
    CHECK(placed.vertex == sequence.vertex_descriptors()[rest.vertex] && placed.rest_position == rest.rest_position);
    const std::size_t before = std::size_t(rest.refined_frame);
    const double after = rest.refined_frame - double(before);
    for (int c = 0; c < 3; ++c) {
      double expected = 0;
      for (int j = 0; j < 3; ++j) {
        const auto v = sequence.vertex_descriptors()[rest.triangle[j]];
        expected += rest.barycentric_coordinates[j] * ((1 - after) * get(sequence.point_map(before), v)[c] +
                                                       after * get(sequence.point_map(before + 1), v)[c]);
      }
      CHECK_NEAR(placed.position[c], expected, 1e-14);
    }
  }
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
  Detection detection(sequence);
  CHECK(detect_with(detection).empty());
  CHECK(detection.number_of_minima() == 0);
  const AMF::Spatio_temporal_field<double>& deformation = detection.measurement().deformation();
  const double noise = detection.measurement().noise();
  CHECK(noise > 0);
  const auto number_of_features = [&](double noise) {
    AMF::Feature_detector<double> detector(sequence.rest_shape(), deformation, sphere.frame_duration, {}, noise);
    return detect_with(detector).size();
  };
  CHECK(number_of_features(noise) == 0);
  CHECK_THROWS(AMF::Option_error, number_of_features(-1), "negative");
  CHECK_THROWS(AMF::Option_error, number_of_features(std::numeric_limits<double>::quiet_NaN()), "negative");
  CHECK(number_of_features(0) > 0); // taken at its word
}

void test_option_errors(const Sequence& sequence)
{
  for (double bad : {-1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    AMF::Calibrated_options options;
    options.ball_radius = bad;
    Detection detector(sequence, options);
    CHECK_THROWS(AMF::Option_error, detect_with(detector), "radius");
  }
  AMF::Calibrated_options options;
  options.sampling.sigma = {0.5, 0.4};
  Detection empty(sequence, options);
  CHECK_THROWS(AMF::Option_error, detect_with(empty), "range of sigma");
  options.sampling.sigma = {1e-4, 1e-3};
  Detection fine(sequence, options);
  CHECK_THROWS(AMF::Option_error, detect_with(fine), "edge length");
}

int main()
{
  const Bumpy_sphere sphere;
  Mesh mesh;
  add_sphere(sphere, mesh);
  const Sequence sequence = animated(sphere, mesh);
  Detection detector(sequence);
  const Features expected = detect_with(detector);
  CHECK(expected.size() == sphere.bumps.size());

  test_progress(sequence, expected, 2); // at the beginning and at the end
  {
    const Single_thread single_thread;
    test_progress(sequence, expected, 12); // 30 on larger meshes
  }
  test_cancellation(sequence, expected);
  test_parallel_cancellation(sequence, expected);
  test_own_animation(sphere, mesh, expected);
  test_fields(sequence);
  test_threads(sequence, expected);
  test_places(sequence);
  test_rounded_coordinates(sphere, mesh);
  test_option_errors(sequence);
  return test_result();
}
