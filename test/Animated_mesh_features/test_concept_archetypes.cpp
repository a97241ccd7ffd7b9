// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// For each concept a class that has what the concept says and nothing more: neither default constructors nor assignment,
// unless the concept asks for them. That this program compiles says that the library does not use more; that it finds a
// feature, that it uses what is there as it is documented.

#include "test_bumpy_sphere.h"
#include "test_support.h"
#include "test_two_stages.h"

#include <CGAL/Animated_mesh_features/Applications/select_views.h>
#include <CGAL/Animated_mesh_features/Descriptors/describe_features.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

using namespace test_support;
namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<Point_3> Mesh;

// Copyable, as the policies have to be, and nothing else.
struct Copy_only
{
  explicit Copy_only(int) {}
  Copy_only(const Copy_only&) = default;
  Copy_only& operator=(const Copy_only&) = delete;
};

// As little of a point as is looked at.
struct Archetype_point
{
  float x() const { return m_x; }
  float y() const { return m_y; }
  float z() const { return m_z; }
  float m_x, m_y, m_z;
};

struct Archetype_point_map
{
  typedef Mesh::Vertex_index key_type;
  typedef Archetype_point value_type;
  typedef Archetype_point reference;
  typedef boost::readable_property_map_tag category;

  explicit Archetype_point_map(const std::vector<Point_3>& points)
    : m_points(&points)
  {}
  Archetype_point_map(const Archetype_point_map&) = default;
  Archetype_point_map& operator=(const Archetype_point_map&) = delete;

  friend Archetype_point get(const Archetype_point_map& map, Mesh::Vertex_index v)
  {
    const Point_3& p = (*map.m_points)[v.idx()];
    return {float(p.x()), float(p.y()), float(p.z())};
  }

private:
  const std::vector<Point_3>* m_points;
};

struct Rest_map : Archetype_point_map // the rest shape may have a map of another type
{
  using Archetype_point_map::Archetype_point_map;
};

class Archetype_animation
{
public:
  typedef Mesh Triangle_mesh;
  typedef float FT;

  Archetype_animation(const Mesh& mesh, const Bumpy_sphere& sphere)
    : m_mesh(mesh)
    , m_sphere(sphere)
  {}
  Archetype_animation(const Archetype_animation&) = delete;
  Archetype_animation& operator=(const Archetype_animation&) = delete;

  const Mesh& triangle_mesh() const { return m_mesh; }
  std::size_t number_of_frames() const { return m_sphere.frames.size(); }
  double frame_duration() const { return m_sphere.frame_duration; }
  Archetype_point_map point_map(std::size_t f) const { return Archetype_point_map(m_sphere.frames[f]); }
  Rest_map rest_point_map() const { return Rest_map(m_sphere.rest); }

private:
  const Mesh& m_mesh;
  const Bumpy_sphere& m_sphere;
};

struct Archetype_strain : Copy_only
{
  using Copy_only::Copy_only;
  float operator()(float lambda_1, float lambda_2) const
  {
    CHECK(lambda_1 * 1.0001f >= lambda_2 && lambda_2 > 0); // the order is up to rounding
    return std::abs(lambda_1 - 1) + std::abs(lambda_2 - 1);
  }
};

struct Archetype_vectorized_strain : Copy_only
{
  using Copy_only::Copy_only;
  static constexpr bool vectorized = true;
  typedef Eigen::Array<float, 16, 1> Array;
  Array operator()(const Array& lambda_1, const Array& lambda_2) const
  {
    return (lambda_1 - 1).abs() + (lambda_2 - 1).abs();
  }
};

struct Archetype_curvature : Copy_only
{
  using Copy_only::Copy_only;
  static constexpr AMF::Ball_membership membership = AMF::Ball_membership::WHOLE;
  typedef Eigen::Array<float, 16, 1> Array;
  float factor(const AMF::Rest_shape&) const { return 0.01f; }
  Array edge_numerator(const Array& angle, const Array& length) const { return angle * length; }
  Array edge_denominator(const Array&, const Array&) const { return Array::Zero(); }
  Array triangle_denominator(const Array& area) const { return area; }
};

struct Archetype_balls : Copy_only
{
  using Copy_only::Copy_only;
  template <class Loop>
  AMF::Compressed_rows operator()(const AMF::Rest_shape& shape, double radius, const Loop& loop) const
  {
    CHECK(radius > 0);
    std::vector<std::vector<AMF::Compressed_rows::Index>> balls(shape.number_of_vertices());
    loop(balls.size(), [&](std::size_t v) {
      balls[v].assign(shape.neighbours()[v].begin(), shape.neighbours()[v].end());
      balls[v].push_back(AMF::Compressed_rows::Index(v));
      std::sort(balls[v].begin(), balls[v].end());
    });
    return AMF::Compressed_rows(std::move(balls));
  }
};

// Calls are checked against what is promised: levels in turn, from the level before.
class Archetype_spatial_filter : Copy_only
{
public:
  using Copy_only::Copy_only;

  template <class Loop>
  void initialize(const AMF::Rest_shape& shape, const std::vector<double>& variances, const Loop& loop)
  {
    m_shape = &shape;
    m_variances.reset(new std::vector<double>(variances));
    m_next = 0;
    loop.part(0, 1)(3, [](std::size_t) {});
  }
  double variance(std::size_t k) const { return (*m_variances)[k]; }
  double variance(std::size_t k, std::size_t) const { return (*m_variances)[k]; }

  template <class Loop>
  void operator()(std::size_t k, const AMF::Spatio_temporal_field<double>& in, AMF::Spatio_temporal_field<double>& out,
                  const Loop& loop)
  {
    CHECK(k == m_next++ && &in != &out);
    CHECK(out.number_of_rows() == in.number_of_rows() && out.number_of_frames() == in.number_of_frames());
    loop(in.number_of_rows(), [&](std::size_t v) {
      for (std::size_t f = 0; f < in.number_of_frames(); ++f) {
        double sum = in(v, f);
        for (AMF::Rest_shape::Index w : m_shape->neighbours()[v]) sum += in(w, f);
        out(v, f) = sum / double(m_shape->neighbours()[v].size() + 1);
      }
    });
  }

private:
  const AMF::Rest_shape* m_shape = nullptr;
  std::shared_ptr<std::vector<double>> m_variances;
  std::size_t m_next = 0;
};

class Archetype_temporal_filter : Copy_only
{
public:
  using Copy_only::Copy_only;

  void initialize(std::size_t number_of_frames, double, const std::vector<double>& variances)
  {
    m_frames = number_of_frames;
    m_variances.reset(new std::vector<double>(variances));
  }
  double variance(std::size_t l) const { return (*m_variances)[l]; }

  void operator()(std::size_t, const double* in, double* out) const
  {
    for (std::size_t f = 0; f < m_frames; ++f)
      out[f] = (in[f > 0 ? f - 1 : 0] + 2 * in[f] + in[f + 1 < m_frames ? f + 1 : f]) / 4;
  }

private:
  std::size_t m_frames = 0;
  std::shared_ptr<std::vector<double>> m_variances;
};

struct Archetype_sampling : Copy_only
{
  using Copy_only::Copy_only;

  template <class SpatialFilter, class TemporalFilter>
  AMF::Scale_levels operator()(const AMF::Rest_shape& shape, std::size_t, double frame_duration, const SpatialFilter&,
                               const TemporalFilter&) const
  {
    const double h = shape.mean_edge_length();
    AMF::Scale_levels levels;
    for (int i = 1; i <= 12; ++i) {
      levels.space_variances.push_back(i * 3 * h * h / 7);
      levels.time_variances.push_back(i * frame_duration * frame_duration / 2);
    }
    levels.unit_length = 2 * h;
    levels.unit_time = 2 * frame_duration;
    return levels;
  }
};

class Archetype_response : Copy_only
{
public:
  using Copy_only::Copy_only;
  static constexpr std::size_t below = 2;
  static constexpr std::size_t above = 1;

  void initialize(const std::vector<double>& sigma, const std::vector<double>& tau, const AMF::Scale_levels& levels)
  {
    CHECK(sigma.size() == levels.space_variances.size() && tau.size() == levels.time_variances.size());
    m_space_levels = sigma.size();
    m_time_levels = tau.size();
  }
  double space_weight(std::size_t k, std::size_t l) const { return weight(k, l); }
  double time_weight(std::size_t k, std::size_t l) const { return weight(k, l); }

private:
  double weight(std::size_t k, std::size_t l) const
  {
    CHECK(k >= below && k + above < m_space_levels);
    CHECK(l >= below && l + above < m_time_levels);
    return std::sqrt(double(k * l)) * double(k);
  }

  std::size_t m_space_levels = 0, m_time_levels = 0;
};

struct Archetype_search : Copy_only
{
  using Copy_only::Copy_only;
  bool at_vertex(const AMF::Response_window<double>& d) const
  {
    return d(0, 0, 0) < 0 && d(0, 0, 0) < d(0, 0, -1) && d(0, 0, 0) < d(0, 0, 1);
  }
  bool at_neighbour(double centre, double, double same, double) const { return centre < same; }
};

struct Archetype_normalization : Copy_only
{
  using Copy_only::Copy_only;
  template <class Loop>
  std::vector<float> operator()(const AMF::Rest_shape& shape, const std::vector<double>& variances, const Loop& loop) const
  {
    std::vector<float> factors(shape.number_of_vertices() * variances.size());
    loop(shape.number_of_vertices(), [&](std::size_t v) {
      for (std::size_t k = 0; k < variances.size(); ++k) factors[v * variances.size() + k] = 2 / (1 + float(k));
    });
    return factors;
  }
};

struct Archetype_descriptor : Copy_only
{
  using Copy_only::Copy_only;
  std::size_t length() const { return 2; }
  void operator()(const AMF::Feature_neighbourhood& n, float* out) const
  {
    out[0] = n.values.front();
    out[1] = float(n.places.size());
  }
};

struct Archetype_baseline : Copy_only
{
  using Copy_only::Copy_only;
  template <class FT>
  FT operator()(const FT* row, std::size_t number_of_frames) const
  {
    CHECK(number_of_frames > 0);
    return row[number_of_frames / 2] / 2;
  }
};

class Archetype_visitor
{
public:
  Archetype_visitor() = default;
  Archetype_visitor(const Archetype_visitor&) = delete;
  Archetype_visitor& operator=(const Archetype_visitor&) = delete;
  void begin(AMF::Stage) { ++m_begun; }
  bool progress(AMF::Stage, double) { return true; }
  void end(AMF::Stage) { ++m_ended; }

  std::size_t begun() const { return m_begun; }
  std::size_t ended() const { return m_ended; }

private:
  std::size_t m_begun = 0, m_ended = 0;
};

// The free function takes its visitor by value.
struct Archetype_movable_visitor : Archetype_visitor
{
  Archetype_movable_visitor() = default;
  Archetype_movable_visitor(Archetype_movable_visitor&&) {}
};

// what two of the samplings ask of the filters in addition
struct Filter_with_smallest_variance : Archetype_spatial_filter
{
  using Archetype_spatial_filter::Archetype_spatial_filter;
  double smallest_variance(const AMF::Rest_shape& shape) const { return std::pow(shape.mean_edge_length(), 2) / 8; }
};
struct Filter_with_unit_variance : Archetype_spatial_filter
{
  using Archetype_spatial_filter::Archetype_spatial_filter;
  double unit_variance(const AMF::Rest_shape& shape) const { return std::pow(shape.mean_edge_length(), 2) / 2; }
};
struct Temporal_filter_with_unit_variance : Archetype_temporal_filter
{
  using Archetype_temporal_filter::Archetype_temporal_filter;
  double unit_variance(std::size_t, double frame_duration) const { return frame_duration * frame_duration / 2; }
};

// What of the surface is turned to the camera, in two frames.
struct Archetype_view_score : Copy_only
{
  using Copy_only::Copy_only;
  std::size_t number_of_frames() const { return 2; }
  std::size_t first_item(std::size_t k) const { return 3 * k; }
  double weight(std::size_t item) const { return double(item % 3); }
  void operator()(const AMF::Surface_view& view, float* seen) const
  {
    for (std::size_t i = 0; i < 3; ++i) seen[i] = view.cosine(10 * i + view.frame_rank()) > 0 ? 1.f : 0.f;
  }
};

void test_views(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  const AMF::Frame_sequence<Mesh> sequence(mesh, sphere.frames, sphere.frame_duration);
  AMF::View_options options;
  options.subdivisions = 1;
  const AMF::View_selection selection = AMF::select_views(sequence, {3, 9}, Archetype_view_score(0), options);
  CHECK(!selection.views.empty() && selection.views.front().score > 0.5);
}

template <class Strain>
using Archetype_options =
    AMF::Detection_options<Strain, Archetype_curvature, Archetype_balls, Archetype_spatial_filter,
                           Archetype_temporal_filter, Archetype_sampling, Archetype_response, Archetype_search,
                           Archetype_normalization, Archetype_baseline>;

template <class Options>
void test_detection(const Archetype_animation& animation, const Options& options, const std::string& name)
{
  // some archetypes count their checks, which is for one thread only
  Two_stages<Archetype_animation, Options, CGAL::Sequential_tag> detector(animation, options);
  Archetype_visitor visitor;
  std::vector<AMF::Spatio_temporal_feature<Mesh::Vertex_index>> features;
  detector(std::back_inserter(features), visitor);
  std::cout << name << ": " << features.size() << " features" << std::endl;
  CHECK(!features.empty());
  CHECK(visitor.begun() >= 5 && visitor.begun() == visitor.ended());
}

int main()
{
  static_assert(!std::is_default_constructible<Archetype_strain>::value, "");
  static_assert(!std::is_copy_assignable<Archetype_spatial_filter>::value, "");

  const Bumpy_sphere sphere;
  Mesh mesh;
  add_sphere(sphere, mesh);
  const Archetype_animation animation(mesh, sphere);

  typedef Archetype_options<Archetype_strain> Options;
  const Options options(Options::Measurement{Archetype_strain(0), Archetype_curvature(0), Archetype_balls(0)},
                        Options::Search{Archetype_spatial_filter(0), Archetype_temporal_filter(0),
                                        Archetype_sampling(0), Archetype_response(0), Archetype_search(0),
                                        Archetype_normalization(0)},
                        AMF::Feature_selection::of_any_field(), Archetype_baseline(0));
  test_detection(animation, options, "archetypes");
  test_detection(animation, options.with_strain(Archetype_vectorized_strain(0)), "vectorized strain");
  test_detection(animation,
                 options.with_sampling(AMF::Fixed_ratio_sampling())
                     .with_spatial_filter(Filter_with_smallest_variance(0))
                     .with_response(AMF::Central_difference_of_gaussians()),
                 "Fixed_ratio_sampling");
  AMF::Every_smoothing_count every;
  every.max_space_count = every.max_time_count = 6;
  test_detection(animation,
                 options.with_sampling(every)
                     .with_spatial_filter(Filter_with_unit_variance(0))
                     .with_temporal_filter(Temporal_filter_with_unit_variance(0))
                     .with_response(AMF::Forward_difference_of_gaussians()),
                 "Every_smoothing_count");

  // a descriptor, of a field on the sphere
  const AMF::Frame_sequence<Mesh> sequence(mesh, sphere.frames, sphere.frame_duration);
  AMF::Feature_point feature;
  feature.sigma = 0.2;
  feature.tau = 0.1;
  const AMF::Spatio_temporal_field<float> field(sequence.number_of_vertices(), 5);
  const AMF::Feature_descriptors described =
      AMF::describe_features(sequence.rest_shape(), field, 0.1, {feature}, Archetype_descriptor(0));
  CHECK(described.length() == 2 && described[0][0] == 0 && described[0][1] > 1);

  test_views(sphere, mesh);

  // each policy on its own among those of the library
  const AMF::Calibrated_options calibrated;
  test_detection(animation, calibrated.with_strain(Archetype_strain(0)), "StrainMeasure");
  std::vector<AMF::Spatio_temporal_feature<Mesh::Vertex_index>> features;
  CGAL::detect_spatio_temporal_features(animation, std::back_inserter(features), calibrated,
                                        Archetype_movable_visitor());
  CHECK(features.size() == sphere.bumps.size());
  return test_result();
}
