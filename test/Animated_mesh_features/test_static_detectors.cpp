// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The detectors of static shapes with which the package's own is compared, on shapes whose answers are known.

#include "../../benchmark/evaluation/Harris_3d.h"
#include "../../benchmark/evaluation/Heat_kernel_signature.h"
#include "../../benchmark/evaluation/Mesh_dog.h"
#include "../../benchmark/evaluation/Mesh_saliency.h"
#include "../../benchmark/evaluation/One_ring_scale_space.h"
#include "test_shapes.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace Static_detectors;
using test_support::Shape;
using test_support::Vec;

namespace {

Connectivity connectivity_of(const Shape& shape)
{
  std::vector<Triangle> triangles;
  for (const auto& f : shape.faces) triangles.push_back({{std::size_t(f[0]), std::size_t(f[1]), std::size_t(f[2])}});
  return Connectivity(shape.points.size(), triangles);
}

Static_response response_of(Static_detector& detector, const Surface& s)
{
  detector.prepare(s);
  std::vector<Static_response> frames = {detector(s)};
  detector.finish(s, frames);
  keep_strongest(frames.front().points, frames.front().points.size()); // sorted
  return frames.front();
}

void test_mean_curvature()
{
  Shape shape = test_support::sphere(4);
  for (Vec& p : shape.points) p *= 2;
  const Connectivity connectivity = connectivity_of(shape);
  const Vertex_measures m = vertex_measures({connectivity, shape.points, 1});
  double area = 0;
  for (double a : m.areas) area += a;
  CHECK_NEAR(area, 16 * test_support::pi, 0.01 * area);
  for (double h : m.mean_curvature) CHECK_NEAR(h, 0.5, 0.02);
}

const double bump_sigma = 0.12;

// A plane with a low Gaussian bump, and where its middle is.
Shape bump(std::size_t& top)
{
  const int n = 60;
  Shape shape = test_support::regular_plane(n, n, 0.03);
  top = std::size_t(n / 2 * (n + 1) + n / 2);
  const Vec middle = shape.points[top];
  for (Vec& p : shape.points) p[2] = 0.03 * std::exp(-(p - middle).squaredNorm() / (2 * bump_sigma * bump_sigma));
  return shape;
}

// The strongest point away from the border of the plane, where all detectors see the end of the mesh.
Interest_point strongest_inside(const Shape& shape, const Static_response& r, std::size_t top)
{
  for (const Interest_point& p : r.points)
    if ((shape.points[p.vertex] - shape.points[top]).norm() < 0.6) return p;
  CHECK(!"a point inside");
  return {0, 0, 0};
}

void test_bump()
{
  std::size_t top = 0;
  const Shape shape = bump(top);
  const Connectivity connectivity = connectivity_of(shape);
  const double diagonal = 2.4;
  const Surface s = {connectivity, shape.points, diagonal};
  std::vector<std::unique_ptr<Static_detector>> all;
  all.push_back(std::make_unique<Mesh_saliency>());
  all.push_back(std::make_unique<Mesh_dog>());
  all.push_back(std::make_unique<Harris_3d>());
  all.push_back(std::make_unique<One_ring_scale_space>());
  for (const auto& detector : all) {
    const Static_response r = response_of(*detector, s);
    const Interest_point p = strongest_inside(shape, r, top);
    CHECK(p.vertex == top);
    CHECK(r.values.size() == shape.points.size());
    // nothing is salient far from the bump
    for (std::size_t v = 0; v < shape.points.size(); ++v) {
      const double distance = (shape.points[v] - shape.points[top]).norm();
      if (distance > 5 * bump_sigma && distance < 6 * bump_sigma) CHECK(r.values[v] < 0.05 * p.strength);
    }
  }
  // how far a pass moves the middle, times the passes, is k / (sigma^2 + s_k)^2, greatest at s_k = sigma^2
  One_ring_scale_space one_ring;
  CHECK_NEAR(strongest_inside(shape, response_of(one_ring, s), top).sigma / bump_sigma, 1, 0.2);
}

// Turned and four times as large: lengths and their powers, and nothing else, change.
void test_invariance()
{
  std::size_t top = 0;
  const Shape shape = bump(top);
  const Eigen::AngleAxisd rotation(1, Vec(1, 2, 3).normalized());
  const double factor = 4;
  const test_support::Points turned =
      test_support::mapped(shape.points, [&](const Vec& p) { return Vec(factor * (rotation * p) + Vec(5, 6, 7)); });
  const Connectivity connectivity = connectivity_of(shape);
  struct Case
  {
    std::unique_ptr<Static_detector> detector;
    double value_factor;
  };
  std::vector<Case> cases;
  cases.push_back({std::make_unique<Mesh_saliency>(), 1});
  cases.push_back({std::make_unique<Mesh_dog>(), 1 / factor});
  cases.push_back({std::make_unique<Harris_3d>(), 1});
  cases.push_back({std::make_unique<One_ring_scale_space>(), factor});
  for (const Case& c : cases) {
    const Static_response a = response_of(*c.detector, {connectivity, shape.points, 2.4});
    const Static_response b = response_of(*c.detector, {connectivity, turned, 2.4 * factor});
    const double greatest = *std::max_element(a.values.begin(), a.values.end());
    for (std::size_t v = 0; v < a.values.size(); ++v)
      CHECK_NEAR(b.values[v] / c.value_factor, a.values[v], 1e-5 * greatest);
    CHECK_NEAR(strongest_inside(shape, b, top).sigma, factor * strongest_inside(shape, a, top).sigma, 1e-6 * factor);
  }
}

void test_heat_kernel_signature()
{
  // On the unit sphere l (l + 1) is an eigenvalue 2 l + 1 times: the fiftieth is 7 * 8. The kernel is the same
  // everywhere.
  {
    const Shape shape = test_support::sphere(4);
    const Connectivity connectivity = connectivity_of(shape);
    Heat_kernel_signature detector;
    const Static_response r = response_of(detector, {connectivity, shape.points, 2});
    const double t = 4 * std::log(10.) / 56;
    CHECK_NEAR(detector.time(), t, 0.02 * t);
    double kernel = 0;
    for (int l = 0; l <= 7; ++l) kernel += (2 * l + 1) * std::exp(-l * (l + 1) * t);
    for (double value : r.values) CHECK_NEAR(value, kernel * t, 0.05 * kernel * t); // 4 pi t over the area, 4 pi
  }
  // Heat stays longest at the tips of an ellipsoid.
  Shape shape = test_support::sphere(4);
  for (Vec& p : shape.points) p[2] *= 3;
  const Connectivity connectivity = connectivity_of(shape);
  Heat_kernel_signature detector;
  const Static_response r = response_of(detector, {connectivity, shape.points, 6});
  CHECK(r.points.size() >= 2);
  if (r.points.size() < 2) return;
  for (std::size_t i : {0, 1}) CHECK_NEAR(std::abs(shape.points[r.points[i].vertex][2]), 3, 1e-12);
  CHECK_NEAR(r.points[0].strength, r.points[1].strength, 1e-6);
  for (std::size_t i = 2; i < r.points.size(); ++i) CHECK(r.points[i].strength < 0.9 * r.points[0].strength);
}

} // namespace

int main()
{
  test_mean_curvature();
  test_bump();
  test_invariance();
  test_heat_kernel_signature();
  return test_support::test_result();
}
