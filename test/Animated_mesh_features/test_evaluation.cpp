// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of features against analytic values, invariances and plain forms of the same sums.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Detection/feature_fit.h>

#include <Eigen/Dense>

#include <limits>
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

// The definition, sample by sample.
double plain_fit(const Rest_shape& shape, const Field& field, const Feature& f)
{
  const std::vector<double> d = path_lengths(shape, f.vertex_index);
  std::vector<double> w, g, x;
  for (std::size_t v = 0; v < d.size(); ++v)
    for (std::size_t m = 0; m < field.number_of_frames(); ++m) {
      const double t = double(m) * frame_duration - f.time;
      if (d[v] > 2.5 * f.sigma || std::abs(t) > 2.5 * f.tau) continue;
      double area = 0;
      for (std::size_t i = 0; i < shape.triangles().size(); ++i)
        for (Rest_shape::Index corner : shape.triangles()[i]) area += corner == v ? shape.areas()[i] / 3 : 0;
      w.push_back(area);
      g.push_back(std::exp(-d[v] * d[v] / (2 * f.sigma * f.sigma) - t * t / (2 * f.tau * f.tau)));
      x.push_back(field(v, m));
    }
  typedef Eigen::Map<Eigen::ArrayXd> Array;
  const Array W(w.data(), Eigen::Index(w.size()));
  Array G(g.data(), Eigen::Index(g.size())), X(x.data(), Eigen::Index(x.size()));
  G -= (W * G).sum() / W.sum();
  X -= (W * X).sum() / W.sum();
  return (W * G * X).sum() / std::sqrt((W * G * G).sum() * (W * X * X).sum());
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

int main()
{
  test_fit();
  test_area_ratio();
  return test_result();
}
