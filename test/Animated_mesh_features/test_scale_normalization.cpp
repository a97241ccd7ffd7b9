// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The normalisation of scales against sums of eigenfunctions on surfaces that have them, against dense matrices and the
// heat kernel, and what it must not depend on.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_kernel_normalization.h>
#include <CGAL/Animated_mesh_features/Scale_space/Planar_normalization.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef std::vector<double> Row;
typedef std::vector<float> Factors; // [vertex][level]

template <class Tag = CGAL::Sequential_tag>
Factors factors_of(const Shape& s, const Row& variances)
{
  Amf::Default_visitor visitor;
  const Amf::Task_loop<Tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  return Amf::Heat_kernel_normalization()(rest_shape_of(s), variances, loop);
}

Row variances_at(double first_sigma, double last_sigma, double ratio = std::sqrt(2.))
{
  Row variances;
  for (double sigma = first_sigma; sigma < 1.001 * last_sigma; sigma *= ratio) variances.push_back(sigma * sigma);
  return variances;
}

// The largest relative difference from the factors of another shape, whose vertex map(v) is v here.
template <class Map>
double largest_difference(const Factors& a, const Factors& b, std::size_t levels, const Map& map)
{
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(double(b[map(i / levels) * levels + i % levels]) / double(a[i]) - 1);
    if (!(d <= difference)) difference = d; // NaN, too
  }
  return difference;
}

// Against 1 / sqrt(4 pi t k(t)) with the diagonal k of the kernel of (1 + t L)^-2, at the vertices where it holds. What a
// mesh of edges e does not have of a surface is felt as about e / sigma; interpolation adds a constant error.
template <class Kernel>
void check_factors(const std::string& name, const Shape& s, const std::vector<std::size_t>& vertices,
                   const Row& variances, const Kernel& kernel)
{
  const Factors factors = factors_of(s, variances);
  const double edge = rest_shape_of(s).mean_edge_length();
  CHECK(factors.size() == s.points.size() * variances.size());
  for (std::size_t k = 0; k < variances.size(); ++k) {
    const double t = variances[k] / 2, sigma = std::sqrt(variances[k]);
    const double expected = std::min(1., 1 / std::sqrt(4 * pi * t * kernel(t)));
    double low = 0, high = 0;
    bool is_close = true;
    for (std::size_t v : vertices) {
      const double error = factors[v * variances.size() + k] / expected - 1;
      low = std::min(low, error);
      high = std::max(high, error);
      is_close = is_close && std::abs(error) < 0.01 + 0.15 * edge / sigma;
    }
    CHECK(is_close);
    std::cout << name << ", sigma of " << sigma / edge << " edges: factor " << expected << ", errors from " << low
              << " to " << high << std::endl;
  }
}

void test_plane()
{
  Random random(51);
  const auto kernel = [](double t) { return 1 / (4 * pi * t); };
  const Shape regular = regular_plane(70, 80);
  check_factors("regular plane", regular, {40 * 71 + 35}, variances_at(3, 8), kernel);
  const int n = 70;
  const Shape irregular = irregular_square(n, random);
  std::vector<std::size_t> inner;
  for (std::size_t v = 0; v < irregular.points.size(); ++v)
    if ((irregular.points[v] - Vec(0.5, 0.5, 0)).cwiseAbs().head(2).maxCoeff() < 0.15) inner.push_back(v);
  CHECK(inner.size() > 100);
  check_factors("irregular plane", irregular, inner, variances_at(3.5 / n, 0.1), kernel);
  // half of the surroundings are missing at a border
  const Row variances = variances_at(4, 8);
  const Factors factors = factors_of(regular, variances);
  for (std::size_t k = 0; k < variances.size(); ++k)
    CHECK_NEAR(factors[35 * variances.size() + k], 1 / std::sqrt(2.), 0.03);
}

// On a cylinder of radius 1 the waves e^(i n phi) e^(i k z):
//   k(t) = 1 / (2 pi) sum_n 1 / (2 pi) integral dk (1 + t (k^2 + n^2))^-2 = 1 / (8 pi sqrt t) sum_n (1 + t n^2)^(-3/2).
void test_tube()
{
  const int around = 40, rings = 141;
  std::vector<std::size_t> middle;
  for (std::size_t i = 0; i < around; ++i) middle.push_back(rings / 2 * around + i);
  check_factors("tube", tube(around, rings, 20), middle, variances_at(0.48, 4), [](double t) {
    double sum = 1;
    for (int n = 100000; n > 0; --n) sum += 2 * std::pow(1 + t * n * double(n), -1.5);
    return sum / (8 * pi * std::sqrt(t));
  });
}

// On the unit sphere the spherical harmonics, 2 l + 1 of the eigenvalue l (l + 1) and with squares that have that sum over
// 4 pi anywhere; from where it is flat to where heat is everywhere.
void test_sphere()
{
  const Shape s = sphere(4);
  std::vector<std::size_t> all(s.points.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  const double edge = std::sqrt(4 * pi / double(s.points.size()) / std::sqrt(0.75));
  check_factors("sphere", s, all, variances_at(3 * edge, 6), [](double t) {
    double sum = 0;
    for (int l = 100000; l >= 0; --l) sum += (2 * l + 1) / (4 * pi) * std::pow(1 + t * l * (l + 1.), -2.);
    return sum;
  });
}

// Dense matrices of the same surface, by sums over corners.
Eigen::MatrixXd dense_matrix(const Shape& s, double t, Eigen::VectorXd& mass)
{
  const Eigen::Index n = Eigen::Index(s.points.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  mass = Eigen::VectorXd::Zero(n);
  for (const auto& f : s.faces)
    for (int i = 0; i < 3; ++i) {
      const int p = f[i], q = f[(i + 1) % 3], r = f[(i + 2) % 3];
      const Vec u = s.points[q] - s.points[p], w = s.points[r] - s.points[p];
      const double double_area = u.cross(w).norm(), c = t * u.dot(w) / double_area / 2;
      mass[p] += double_area / 6;
      a(q, q) += c;
      a(r, r) += c;
      a(q, r) -= c;
      a(r, q) -= c;
    }
  a.diagonal() += mass;
  return a;
}

// A body with limbs of several sizes: an irregular bumpy tube with a thin one beside it.
Shape limbs(Random& random)
{
  Shape s = tube(14, 41, 12);
  for (Vec& p : s.points) p = (1 + 0.3 * std::sin(p[2])) * Vec(p[0], p[1], 0) + Vec(0, 0, p[2]) + random.vector(0.06);
  Shape thin = tube(5, 30, 9);
  for (Vec& p : thin.points) p = Vec(0.2 * p[0], 0.3 * p[1], p[2]) + random.vector(0.02);
  s.add(thin, Vec(4, 0, 0));
  return s;
}

// 4 pi t k_t on the lattice of equilateral triangles whose vertices have the area 1: an integral over its waves, of which
// the steepest part at k = 0 is as wide as t^-1/2.
double of_lattice(double t)
{
  const std::size_t n = 120;
  static const Row cosines = [&] {
    Row c;
    for (std::size_t i = 0; i < 2 * n; ++i) c.push_back(std::cos(pi * double(i) / double(n)));
    return c;
  }();
  const double area = std::sqrt(3.) / 2;
  double sum = 0;
  for (std::size_t i = 1; i < 2 * n; i += 2) // angles between those of the whole steps, so that none is 0
    for (std::size_t j = 1; j < 2 * n; j += 2) {
      const double lambda = 4. / 3 * (3 - cosines[i] - cosines[j] - cosines[i > j ? i - j : j - i]);
      sum += 1 / ((1 + t * area * lambda) * (1 + t * area * lambda));
    }
  return 4 * pi * t * sum / double(n * n);
}

// What is interpolated against the kernel itself at each level, and this one against the heat kernel.
void test_against_dense_matrices()
{
  Random random(52);
  const Shape s = limbs(random);
  const std::size_t n = s.points.size();
  const Row variances = variances_at(0.2, 6);
  const Factors factors = factors_of(s, variances);
  const Amf::Rest_shape shape = rest_shape_of(s);
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  Amf::Heat_diffusion_filter filter;
  filter.initialize(shape, variances, loop);
  Amf::Spatio_temporal_field<double> heat(n, n), next(n, n);
  for (std::size_t v = 0; v < n; ++v) heat(v, v) = 1;
  double error = 0, low = 1e9, high = 0;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    filter(k, heat, next, loop);
    heat.swap(next);
    const double t = variances[k] / 2;
    Eigen::VectorXd mass;
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(Eigen::Index(n), Eigen::Index(n));
    const Eigen::MatrixXd inverse = dense_matrix(s, t, mass).llt().solve(identity);
    for (std::size_t v = 0; v < n; ++v) {
      const Eigen::Index i = Eigen::Index(v);
      const double kernel = inverse.col(i).dot(mass.cwiseProduct(inverse.col(i)));
      double squares = 0; // of the edges at v
      for (Amf::Rest_shape::Index w : shape.neighbours()[v]) squares += (s.points[w] - s.points[v]).squaredNorm();
      const double in_edges = t / (std::sqrt(3.) / 2 * squares / double(shape.neighbours()[v].size()));
      const double exact = std::min(1., std::sqrt(of_lattice(in_edges) / (4 * pi * t * kernel))), g = factors[v * variances.size() + k];
      error = std::max(error, std::abs(g / exact - 1));
      if (in_edges < 2) continue; // the heat kernel of the mesh is far from that of the surface
      const double by_heat = std::min(1., 1 / std::sqrt(4 * pi * t * heat(v, v) / mass[i]));
      low = std::min(low, g / by_heat);
      high = std::max(high, g / by_heat);
    }
  }
  std::cout << "limbs, " << n << " vertices: factors within " << error << " of exact ones, " << low << " to " << high
            << " of those by the heat kernel from two edges on" << std::endl;
  CHECK(error < 0.02);
  CHECK(low > 0.87 && high < 1.17);
}

void test_invariances()
{
  Random random(53);
  const Shape s = limbs(random);
  const std::size_t n = s.points.size();
  const Row variances = variances_at(0.2, 6);
  const std::size_t levels = variances.size();
  const Factors factors = factors_of(s, variances);
  const auto itself = [](std::size_t v) { return v; };
  CHECK(std::all_of(factors.begin(), factors.end(), [](float g) { return g > 0 && g <= 1; }));
  CHECK(*std::min_element(factors.begin(), factors.end()) < 0.3f);
  CHECK(factors_of<CGAL::Parallel_if_available_tag>(s, variances) == factors); // the same bits

  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  Shape renumbered = s;
  for (std::size_t v = 0; v < n; ++v) renumbered.points[order[v]] = s.points[v];
  for (auto& f : renumbered.faces)
    for (int& v : f) v = int(order[std::size_t(v)]);
  const Factors others = factors_of(renumbered, variances);
  CHECK(largest_difference(factors, others, levels, [&](std::size_t v) { return order[v]; }) < 1e-6);

  Shape moved = s;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec(1, -2, 0.5).normalized()).toRotationMatrix();
  for (Vec& p : moved.points) p = turn * p + Vec(3, 1, -2);
  CHECK(largest_difference(factors, factors_of(moved, variances), levels, itself) < 1e-6);

  for (double unit : {1e-3, 25.4, 1e6}) {
    Shape scaled = s;
    for (Vec& p : scaled.points) p *= unit;
    Row in_unit = variances;
    for (double& x : in_unit) x *= unit * unit;
    CHECK(largest_difference(factors, factors_of(scaled, in_unit), levels, itself) < 1e-6);
  }
}

void test_parts()
{
  Random random(54);
  const Shape s = limbs(random);
  const std::size_t n = s.points.size();
  const Row variances = variances_at(0.2, 3);
  const Factors alone = factors_of(s, variances);
  // other components, vertices of no triangle or of flat ones only, and levels without smoothing change nothing
  Shape more = s;
  more.add(sphere(2), Vec(9, 0, 0));
  const std::size_t flat = more.points.size();
  more.points.insert(more.points.end(), {Vec(0, 5, 0), Vec(1, 5, 0), Vec(2, 5, 0), Vec(7, 7, 7)});
  more.faces.push_back({{int(flat), int(flat) + 1, int(flat) + 2}});
  Row with_none = variances;
  with_none.insert(with_none.begin(), 2, 0.);
  const std::size_t levels = with_none.size();
  const Factors all = factors_of(more, with_none);
  double difference = 0;
  bool is_one = true;
  for (std::size_t v = 0; v < more.points.size(); ++v)
    for (std::size_t k = 0; k < levels; ++k) {
      const double g = all[v * levels + k];
      if (k < 2 || v >= flat)
        is_one = is_one && g == 1;
      else if (v < n)
        difference = std::max(difference, std::abs(g / double(alone[v * variances.size() + k - 2]) - 1));
    }
  CHECK(difference < 1e-6);
  CHECK(is_one);

  CHECK(factors_of(s, {}).empty());
  CHECK(factors_of(s, {0, 0}) == Factors(2 * n, 1.f));
  // a level has nearly the same factors whatever the others are; the difference is that of the interpolation
  for (std::size_t k = 0; k < variances.size(); ++k) {
    const Factors one = factors_of(s, {variances[k]});
    double change = 0;
    for (std::size_t v = 0; v < n; ++v)
      change = std::max(change, std::abs(double(one[v]) / double(alone[v * variances.size() + k]) - 1));
    CHECK(change < 0.05);
  }
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  CHECK(Amf::Planar_normalization()(rest_shape_of(s), variances, loop).empty());
}

struct Impatient_visitor : Amf::Default_visitor
{
  bool progress(Amf::Stage, double fraction) { return fraction < 0.3; }
};

void test_cancellation()
{
  Impatient_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Impatient_visitor> loop(visitor, Amf::Stage::SCALE_SPACE);
  CHECK_THROWS(Amf::Cancelled, Amf::Heat_kernel_normalization()(rest_shape_of(sphere(2)), variances_at(0.3, 3), loop),
               "");
}

int main()
{
  test_cancellation();
  test_plane();
  test_tube();
  test_sphere();
  test_against_dense_matrices();
  test_invariances();
  test_parts();
  return test_result();
}
