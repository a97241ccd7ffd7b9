// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The detectors of static shapes with which the package's own is compared, on shapes whose answers are known.

#include "Harris_3d.h"
#include "Heat_kernel_signature.h"
#include "Mesh_dog.h"
#include "Mesh_saliency.h"
#include "One_ring_scale_space.h"
#include "../../test/Animated_mesh_features/test_shapes.h"
#include "../../test/Animated_mesh_features/test_support.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
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
  double error = 0;
  for (double h : m.mean_curvature) error = (std::max)(error, std::abs(h - 0.5));
  CHECK_NEAR(error, 0, 0.02);
}

const double bump_sigma = 0.09;

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

// All see the bump, at its top, and nothing on its foot. Around the border averages see the end of the mesh.
void test_bump()
{
  std::size_t top = 0;
  const Shape shape = bump(top);
  const Connectivity connectivity = connectivity_of(shape);
  const double diagonal = 4;
  struct Case
  {
    std::unique_ptr<Static_detector> detector;
    const char* name;
  };
  std::vector<Case> cases;
  cases.push_back({std::make_unique<Mesh_saliency>(), "saliency"});
  cases.push_back({std::make_unique<Mesh_dog>(), "MeshDOG"});
  cases.push_back({std::make_unique<Harris_3d>(), "Harris"});
  cases.push_back({std::make_unique<One_ring_scale_space>(), "one-ring"});
  for (const Case& c : cases) {
    const Static_response r = response_of(*c.detector, {connectivity, shape.points, diagonal});
    const auto strongest = std::find_if(r.points.begin(), r.points.end(), [&](const Interest_point& p) {
      return (shape.points[p.vertex] - shape.points[top]).norm() < 2 * bump_sigma;
    });
    test_support::report(strongest != r.points.end() && strongest->vertex == top, __FILE__, __LINE__, c.name);
    if (strongest == r.points.end()) continue;
    double foot = 0;
    for (std::size_t v = 0; v < shape.points.size(); ++v) {
      const double distance = (shape.points[v] - shape.points[top]).norm();
      if (distance > 4 * bump_sigma && distance < 4.5 * bump_sigma) foot = (std::max)(foot, r.values[v]);
    }
    const bool moves_borders = std::string(c.name) == "one-ring"; // far into the plane
    if (!moves_borders) test_support::report(foot < 0.05 * strongest->strength, __FILE__, __LINE__, c.name);
    // how far a pass moves the top, times the passes, is k / (sigma^2 + s_k)^2, greatest at s_k = sigma^2
    if (moves_borders) CHECK_NEAR(strongest->sigma / bump_sigma, 1, 0.2);
  }
}

// Turned and four times as large: lengths and their powers, and nothing else, change.
void test_invariance()
{
  Shape shape = test_support::sphere(4);
  for (Vec& p : shape.points)
    p *= 1 + 0.1 * std::sin(5 * p[0] + 1) + 0.1 * std::cos(4 * p[1] + 2) + 0.05 * std::sin(9 * p[2] + 0.5);
  const Eigen::AngleAxisd rotation(1, Vec(1, 2, 3).normalized());
  const double factor = 4, diagonal = 3;
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
  cases.push_back({std::make_unique<Heat_kernel_signature>(), 1});
  for (const Case& c : cases) {
    const Static_response a = response_of(*c.detector, {connectivity, shape.points, diagonal});
    const Static_response b = response_of(*c.detector, {connectivity, turned, diagonal * factor});
    double error = 0;
    for (std::size_t v = 0; v < a.values.size(); ++v)
      error = (std::max)(error, std::abs(b.values[v] / c.value_factor - a.values[v]));
    CHECK_NEAR(error, 0, 1e-5 * *std::max_element(a.values.begin(), a.values.end()));
    CHECK(!a.points.empty() && a.points.size() == b.points.size());
    if (a.points.empty() || b.points.empty()) continue;
    CHECK(a.points[0].vertex == b.points[0].vertex);
    CHECK_NEAR(b.points[0].sigma, factor * a.points[0].sigma, 1e-6 * factor);
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
    const double t = detector.time(), wave = 0.1; // waves of so few edges are too slow on a mesh by 6 %
    CHECK_NEAR(t, 4 * std::log(10.) / 56, wave * t);
    double kernel = 0;
    for (int l = 0; l <= 7; ++l) kernel += (2 * l + 1) * std::exp(-l * (l + 1) * t);
    double error = 0; // 4 pi t over the area, 4 pi
    for (double value : r.values) error = (std::max)(error, std::abs(value - kernel * t));
    CHECK_NEAR(error, 0, 0.05 * kernel * t);
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
