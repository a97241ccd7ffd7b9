// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The detector on fields whose features are known: Gaussian blobs in space and time on surfaces of which the geodesic
// distances are known. What it finds must lie where the blobs are, with their scales.

#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

namespace {

const double pi = std::acos(-1.);
const std::size_t frames = 48;
const double frame_duration = 1. / 30;

struct Blob
{
  Point centre;
  double time, sigma, tau, amplitude;
};

typedef std::function<double(const Point&, const Point&)> Distance;

Amf::Spatio_temporal_field<double> field_of(const Mesh& mesh, const std::vector<Blob>& blobs, const Distance& distance)
{
  Amf::Spatio_temporal_field<double> field(num_vertices(mesh), frames);
  for (Mesh::Vertex_index v : mesh.vertices())
    for (const Blob& b : blobs) {
      const double r = distance(mesh.point(v), b.centre) / b.sigma;
      for (std::size_t f = 0; f < frames; ++f) {
        const double t = (double(f) * frame_duration - b.time) / b.tau;
        field(v, f) += b.amplitude * std::exp(-(r * r + t * t) / 2);
      }
    }
  return field;
}

double median(std::vector<double> x)
{
  std::nth_element(x.begin(), x.begin() + std::ptrdiff_t(x.size() / 2), x.end());
  return x[x.size() / 2];
}

struct Bounds
{
  double median_scale, largest_scale; // relative errors of sigma and tau
  double place;                       // over the blob's sigma
  double time;                        // over the blob's tau
};

template <class Options>
void check(const std::string& name, const Mesh& mesh, const std::vector<Blob>& blobs, const Distance& distance,
           const Options& options, const Bounds& bounds)
{
  const Amf::Rest_shape shape = Amf::rest_shape_of_mesh(mesh);
  Amf::Feature_detector<double, Options> detector(shape, field_of(mesh, blobs, distance), frame_duration, options);
  std::vector<typename Amf::Feature_detector<double, Options>::Feature> features;
  detector(std::back_inserter(features));

  // one feature for each blob, and no other
  CHECK(features.size() == blobs.size());
  std::vector<double> sigma_errors, tau_errors, place_errors, time_errors;
  for (const Blob& b : blobs) {
    const auto nearest = std::min_element(features.begin(), features.end(), [&](const auto& f, const auto& g) {
      const auto away = [&](const auto& x) {
        const Point p(x.rest_position[0], x.rest_position[1], x.rest_position[2]);
        return distance(p, b.centre) / b.sigma + std::abs(x.time - b.time) / b.tau;
      };
      return away(f) < away(g);
    });
    if (nearest == features.end()) continue;
    const Point p(nearest->rest_position[0], nearest->rest_position[1], nearest->rest_position[2]);
    sigma_errors.push_back(std::abs(nearest->sigma / b.sigma - 1));
    tau_errors.push_back(std::abs(nearest->tau / b.tau - 1));
    place_errors.push_back(distance(p, b.centre) / b.sigma);
    time_errors.push_back(std::abs(nearest->time - b.time) / b.tau);
    CHECK(!nearest->at_scale_limit);
  }
  if (sigma_errors.empty()) return;
  const auto largest = [](const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); };
  std::cout << std::setw(28) << std::left << name << std::fixed << std::setprecision(2) << " sigma median "
            << 100 * median(sigma_errors) << " % largest " << 100 * largest(sigma_errors) << " %, tau "
            << 100 * median(tau_errors) << " % " << 100 * largest(tau_errors) << " %, place "
            << 100 * largest(place_errors) << " % of sigma, time " << 100 * largest(time_errors) << " % of tau"
            << std::endl;
  CHECK(median(sigma_errors) <= bounds.median_scale);
  CHECK(largest(sigma_errors) <= bounds.largest_scale);
  CHECK(median(tau_errors) <= bounds.median_scale);
  CHECK(largest(tau_errors) <= bounds.largest_scale);
  CHECK(largest(place_errors) <= bounds.place);
  CHECK(largest(time_errors) <= bounds.time);
}

// The unit sphere, by splitting the triangles of an icosahedron.
Mesh sphere(int splits)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point>(mesh);
  for (int i = 0; i < splits; ++i) {
    Mesh finer;
    for (Mesh::Vertex_index v : mesh.vertices()) finer.add_vertex(mesh.point(v));
    std::map<Mesh::Edge_index, Mesh::Vertex_index> middle;
    for (Mesh::Edge_index e : mesh.edges())
      middle[e] = finer.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
    for (Mesh::Face_index f : mesh.faces()) {
      std::vector<Mesh::Vertex_index> c, m;
      for (Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        c.push_back(mesh.source(h));
        m.push_back(middle[mesh.edge(h)]);
      }
      finer.add_face(m[0], m[1], m[2]);
      for (int j = 0; j < 3; ++j) finer.add_face(c[j], m[j], m[(j + 2) % 3]);
    }
    mesh = finer;
  }
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Vector_3 x = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + x / std::sqrt(x.squared_length());
  }
  return mesh;
}

double great_circle(const Point& p, const Point& q)
{
  const Kernel::Vector_3 a = p - CGAL::ORIGIN, b = q - CGAL::ORIGIN;
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

Point on_sphere(double longitude, double latitude)
{
  return Point(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude));
}

// The flat torus' lattice on a torus in space: a regular triangulation, each vertex with six neighbours.
Mesh torus(std::size_t around, std::size_t along, double large, double small)
{
  Mesh mesh;
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return Mesh::Vertex_index(Mesh::size_type((i % along) * around + j % around));
  };
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const double a = 2 * pi * double(i) / double(along);
      const double b = 2 * pi * (double(j) + (i % 2 ? 0.5 : 0)) / double(around);
      const double r = large + small * std::cos(b);
      mesh.add_vertex(Point(r * std::cos(a), r * std::sin(a), small * std::sin(b)));
    }
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      if (i % 2 == 0) {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        mesh.add_face(vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1));
      } else {
        mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  return mesh;
}

// A square of side 2 whose density of vertices rises 8-fold from left to right: random points that keep a distance, and
// their Delaunay triangulation.
Mesh irregular_square()
{
  typedef CGAL::Projection_traits_xy_3<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
  typedef CGAL::Delaunay_triangulation_2<Traits> Delaunay;
  std::mt19937 random(7);
  const auto uniform = [&] { return double(random()) / double(std::mt19937::max()) * 2 - 1; };
  std::vector<Point> points;
  for (int i = -1; i <= 1; i += 2)
    for (int j = -1; j <= 1; j += 2) points.emplace_back(i, j, 0);
  for (int attempt = 0; attempt < 40000; ++attempt) {
    const Point p(uniform(), uniform(), 0);
    const double apart = 0.042 * std::pow(8., -(p.x() + 1) / 4); // a density of 8 is a distance of sqrt(1/8)
    const double squared = apart * apart;
    if (std::all_of(points.begin(), points.end(),
                    [&](const Point& q) { return CGAL::squared_distance(p, q) >= squared; }))
      points.push_back(p);
  }
  Delaunay delaunay;
  std::map<Delaunay::Vertex_handle, Mesh::Vertex_index> index;
  Mesh mesh;
  for (const Point& p : points) index[delaunay.insert(Traits::Point_2(p.x(), p.y(), 0))] = mesh.add_vertex(p);
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f)
    mesh.add_face(index[f->vertex(0)], index[f->vertex(1)], index[f->vertex(2)]);
  return mesh;
}

double euclid(const Point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

typedef Amf::Feature_detector<double>::Feature Feature;

std::vector<Feature> found(const Mesh& mesh, const Amf::Spatio_temporal_field<double>& field, double duration,
                           const Amf::Calibrated_options& options)
{
  const Amf::Rest_shape shape = Amf::rest_shape_of_mesh(mesh);
  Amf::Feature_detector<double, Amf::Calibrated_options> detector(shape, field, duration, options);
  std::vector<Feature> features;
  detector(std::back_inserter(features));
  return features;
}

// Amplitude and strength of an event do not depend on the range of scales, the length of the clip or its frame rate.
void test_strength(const Mesh& ball)
{
  const Blob blob = {on_sphere(0.5, 0.3), 0.8, 0.13, 0.11, 0.6};
  const auto field = field_of(ball, {blob}, great_circle);
  std::vector<Feature> all;
  const auto add = [&](const Amf::Spatio_temporal_field<double>& f, double duration, double sigma_max, double tau_max) {
    Amf::Calibrated_options options;
    options.sampling.sigma = {0.05, sigma_max};
    options.sampling.tau = {0.04, tau_max};
    const std::vector<Feature> features = found(ball, f, duration, options);
    CHECK(features.size() == 1);
    all.insert(all.end(), features.begin(), features.end());
  };
  add(field, frame_duration, 0.3, 0.3);
  add(field, frame_duration, 0.2, 0.3);
  add(field, frame_duration, 0.6, 0.2);
  Amf::Spatio_temporal_field<double> part(field.number_of_rows(), 36), coarse(field.number_of_rows(), frames / 2);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v) {
    for (std::size_t f = 0; f < 36; ++f) part(v, f) = field(v, f + 6);
    for (std::size_t f = 0; f < frames / 2; ++f) coarse(v, f) = field(v, 2 * f);
  }
  add(part, frame_duration, 0.3, 0.3);
  add(coarse, 2 * frame_duration, 0.3, 0.3);
  for (const Feature& f : all) {
    CHECK_NEAR(f.amplitude, blob.amplitude, 0.02 * blob.amplitude);
    CHECK_NEAR(f.strength, all.front().strength, 0.02 * all.front().strength);
  }
  // Where a range begins it counts less, though it is the same.
  const auto fading = [&](double sigma_min, double tau_min) {
    Amf::Calibrated_options options;
    options.sampling.sigma = {sigma_min, 0.6};
    options.sampling.tau = {tau_min, 0.5};
    options.sampling.unit_length = options.sampling.unit_time = 1; // larger than these, nothing fades
    options.selection.absolute_threshold = 0;
    const std::vector<Feature> features = found(ball, field, frame_duration, options);
    CHECK(!features.empty());
    const Feature f = features.empty() ? Feature() : features.front();
    CHECK_NEAR(f.amplitude, blob.amplitude, 0.03 * blob.amplitude);
    const double in_space = std::log(f.sigma / sigma_min) / std::log(1.6), in_time = std::log(f.tau / tau_min) / std::log(2.);
    CHECK_NEAR(f.strength, f.amplitude * f.fit * std::min(1., in_space) * std::min(1., in_time), 1e-12);
    return f.strength / all.front().strength;
  };
  CHECK_NEAR(fading(0.05, 0.08), 0.46, 0.05);
  CHECK_NEAR(fading(0.11, 0.04), 0.36, 0.07);
  CHECK(fading(0.12, 0.1) < 0.1);
}

// A burst that is twenty times as strong as all else removes nothing but what it covers.
void test_burst(const Mesh& ball)
{
  std::vector<Blob> blobs = {{on_sphere(0.1, 0.2), 0.4, 0.1, 0.06, 0.5},
                             {on_sphere(1.3, -0.3), 0.9, 0.13, 0.1, 0.2},
                             {on_sphere(2.4, 0.5), 1.2, 0.09, 0.08, 1}};
  const std::vector<Feature> before = found(ball, field_of(ball, blobs, great_circle), frame_duration, {});
  CHECK(before.size() == 3);
  blobs.push_back({on_sphere(4.5, -0.4), 0.7, 0.1, 0.07, 20});
  const std::vector<Feature> after = found(ball, field_of(ball, blobs, great_circle), frame_duration, {});
  for (const Feature& f : before)
    CHECK(std::any_of(after.begin(), after.end(), [&](const Feature& g) {
      return g.vertex == f.vertex && g.frame == f.frame && std::abs(g.strength / f.strength - 1) < 0.02;
    }));
}

// A tube of radius 1 along z; rows of vertices are turned by half an edge against each other.
Mesh tube(std::size_t around, std::size_t along, double height)
{
  Mesh mesh;
  const auto vertex = [&](std::size_t i, std::size_t j) { return Mesh::Vertex_index(Mesh::size_type(i * around + j % around)); };
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const double a = 2 * pi * (double(j) + (i % 2 ? 0.5 : 0)) / double(around);
      mesh.add_vertex(Point(std::cos(a), std::sin(a), height * (double(i) / double(along - 1) - 0.5)));
    }
  for (std::size_t i = 0; i + 1 < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      if (i % 2 == 0) {
        mesh.add_face(vertex(i, j), vertex(i, j + 1), vertex(i + 1, j));
        mesh.add_face(vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j));
      } else {
        mesh.add_face(vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1));
        mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j));
      }
    }
  return mesh;
}

// A tube that swells all around is one event, whether by exactly the same amount or by a bit more on one side, which is
// where it is reported then.
void test_joined()
{
  const Mesh mesh = tube(40, 121, 20);
  for (double more : {0., 1e-9, 0.01}) {
    Amf::Spatio_temporal_field<double> field(num_vertices(mesh), frames);
    for (Mesh::Vertex_index v : mesh.vertices()) {
      const Point p = mesh.point(v);
      for (std::size_t f = 0; f < frames; ++f) {
        const double t = (double(f) * frame_duration - 0.8) / 0.1, z = p.z() / 0.8;
        field(v, f) = std::exp(-(z * z + t * t) / 2) * (1 + more * (p.x() > 0 ? p.x() * p.x() : 0));
      }
    }
    const std::vector<Feature> features = found(mesh, field, frame_duration, {});
    CHECK(features.size() == 1);
    if (features.empty()) continue;
    std::cout << "ring, stronger by " << more << " on one side: sigma " << features[0].sigma / 0.8 << ", tau "
              << features[0].tau / 0.1 << " times that of the band" << std::endl;
    CHECK_NEAR(features[0].tau, 0.1, 0.012);
    CHECK(std::abs(features[0].rest_position[2]) < 0.2);
    if (more > 1e-3) CHECK(features[0].rest_position[0] > 0.9);
    Amf::Calibrated_options apart;
    apart.search.join_equal = false;
    if (more < 1e-3) CHECK(found(mesh, field, frame_duration, apart).size() != 1);
  }
}

} // namespace

int main()
{
  const auto scales = [](auto options, double sigma_min, double sigma_max) {
    options.sampling.sigma = {sigma_min, sigma_max};
    options.sampling.tau = {0.04, 0.3};
    options.selection.relative_threshold = 0.3;
    options.selection.absolute_threshold = 0;
    return options;
  };
  const auto ring = Amf::calibrated_options().with_spatial_filter(Amf::One_ring_average_filter());
  const auto box = Amf::calibrated_options().with_temporal_filter(Amf::Box_temporal_filter());

  const Mesh ball = sphere(5);
  const std::vector<Blob> on_ball = {
      {on_sphere(0.1, 0.2), 0.4, 0.1, 0.06, 1},   {on_sphere(1.3, -0.3), 0.9, 0.13, 0.1, 1},
      {on_sphere(2.4, 0.5), 1.2, 0.09, 0.08, 1},  {on_sphere(3.7, -0.1), 0.5, 0.17, 0.12, 1},
      {on_sphere(4.8, 0.4), 0.71, 0.11, 0.15, 1}, {on_sphere(1.0, -1.3), 0.633, 0.15, 0.09, 1}};
  check("sphere, heat, gaussian", ball, on_ball, great_circle, scales(Amf::calibrated_options(), 0.06, 0.3),
        {0.01, 0.026, 0.05, 0.05});
  check("sphere, one-ring, gaussian", ball, on_ball, great_circle, scales(ring, 0.06, 0.3), {0.01, 0.026, 0.1, 0.05});
  check("sphere, heat, box", ball, on_ball, great_circle, scales(box, 0.06, 0.3), {0.02, 0.04, 0.05, 0.05});

  // on the outer equator, where the metric is symmetric; distances by the torus' own coordinates there
  const double large = 3, small = 1;
  const Mesh ring_surface = torus(60, 208, large, small);
  const auto on_torus = [&](double a) {
    return Point((large + small) * std::cos(a), (large + small) * std::sin(a), 0);
  };
  const Distance near_equator = [&](const Point& p, const Point& q) {
    const auto coordinates = [&](const Point& x) {
      return std::make_pair(std::atan2(x.y(), x.x()), std::atan2(x.z(), std::hypot(x.x(), x.y()) - large));
    };
    const auto c = coordinates(p), d = coordinates(q);
    const double along = std::remainder(c.first - d.first, 2 * pi);
    const double around = std::remainder(c.second - d.second, 2 * pi);
    // the circle of latitude in the middle between the two
    const double r = large + small * std::cos((c.second + d.second) / 2);
    return std::hypot(r * along, small * around);
  };
  check("torus, heat, gaussian", ring_surface,
        {{on_torus(0), 0.5, 0.25, 0.08, 1}, {on_torus(2), 0.8, 0.2, 0.13, 1}, {on_torus(4.1), 1.1, 0.3, 0.1, 1}},
        near_equator, scales(Amf::calibrated_options(), 0.12, 0.6), {0.02, 0.04, 0.05, 0.05});

  const Mesh square = irregular_square();
  std::cout << "irregular square: " << num_vertices(square) << " vertices" << std::endl;
  const std::vector<Blob> on_square = {{Point(-0.5, -0.5, 0), 0.4, 0.14, 0.08, 1},
                                       {Point(-0.45, 0.5, 0), 1.1, 0.12, 0.1, 1},
                                       {Point(0.02, 0.01, 0), 0.8, 0.11, 0.12, 1},
                                       {Point(0.5, -0.5, 0), 1.2, 0.1, 0.09, 1},
                                       {Point(0.55, 0.45, 0), 0.5, 0.13, 0.1, 1}};
  check("8-fold density, heat", square, on_square, euclid, scales(Amf::calibrated_options(), 0.06, 0.3),
        {0.01, 0.026, 0.1, 0.05});
  check("8-fold density, one-ring", square, on_square, euclid, scales(ring, 0.06, 0.3), {0.06, 0.12, 0.3, 0.05});

  // A blob of amplitude A with the scales of the response's units: smoothed to (s, u), its centre is
  // A s0 / (s0 + s) sqrt(u0 / (u0 + u)); the differences of that between the levels sqrt(2) and cbrt(2) away give 0.515
  // A.
  auto options = scales(Amf::calibrated_options(), 0.06, 0.3);
  const double sigma = std::sqrt(0.06 * 0.3), tau = std::sqrt(0.04 * 0.3);
  options.sampling.unit_length = sigma;
  options.sampling.unit_time = tau;
  const Amf::Rest_shape shape = Amf::rest_shape_of_mesh(ball);
  Amf::Feature_detector<double> detector(
      shape, field_of(ball, {{on_sphere(0.5, 0.3), 0.8, sigma, tau, 2.5}}, great_circle), frame_duration, options);
  std::vector<Amf::Feature_detector<double>::Feature> features;
  detector(std::back_inserter(features));
  CHECK(features.size() == 1);
  if (!features.empty()) {
    CHECK_NEAR(-features[0].response / 2.5, 0.515, 0.005);
    CHECK_NEAR(features[0].amplitude, 2.5, 0.02 * 2.5);
    CHECK(features[0].fit > 0.97);
    CHECK(features[0].strength == features[0].amplitude * features[0].fit);
  }

  test_strength(ball);
  test_burst(ball);
  test_joined();

  return test_support::test_result();
}
