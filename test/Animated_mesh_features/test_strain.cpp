// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Strain against closed forms, and against its definition by a 3 x 3 deformation gradient with unit normals.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <limits>

namespace Amf = CGAL::Animated_mesh_features;
using namespace test_support;

typedef Amf::Spatio_temporal_field<double> Field;

template <class FT = double>
Amf::Frame_sequence<Mesh, FT> sequence_of(const Mesh& mesh, const Points& rest, const std::vector<Points>& frames)
{
  Amf::Frame_sequence<Mesh, FT> sequence(mesh, frames_of(frames), 1. / 30);
  sequence.set_rest_shape(frames_of({rest}).front(), Amf::Rest_unit::KEEP);
  return sequence;
}

template <class FT>
bool same_bits(const Amf::Spatio_temporal_field<FT>& a, const Amf::Spatio_temporal_field<FT>& b, std::size_t frames)
{
  bool same = a.number_of_rows() == b.number_of_rows() && a.number_of_rows() > 0;
  for (std::size_t i = 0; same && i < a.number_of_rows(); ++i)
    for (std::size_t f = 0; f < frames; ++f) same = same && a(i, f) == b(i, f);
  return same;
}

// The strain of a triangle with edges u, v at rest by a linear map, which the test knows exactly.
template <class Measure>
std::vector<double> strains_of_maps(const std::vector<Eigen::Matrix3d>& maps, const Measure& measure)
{
  const Shape s = {{Vec(1, 1, 0), Vec(3, 2, 0), Vec(1.5, 4, 0)}, {{{0, 1, 2}}}};
  std::vector<Points> frames;
  for (const Eigen::Matrix3d& m : maps)
    frames.push_back(mapped(s.points, [&](const Vec& p) { return Vec(m * p + Vec(10, -20, 30)); }));
  const Mesh mesh = mesh_of(s);
  const Field field = Amf::triangle_strain(sequence_of(mesh, s.points, frames), measure);
  CHECK(field.number_of_rows() == 1 && field.number_of_frames() == maps.size());
  return std::vector<double>(field.row(0), field.row(0) + maps.size());
}

void test_known_deformations()
{
  const auto in_plane = [](double xx, double xy, double yx, double yy) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
    m.topLeftCorner<2, 2>() << xx, xy, yx, yy;
    return m;
  };
  const double gamma = 0.7;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec(1, 2, -1).normalized()).toRotationMatrix();
  const std::vector<Eigen::Matrix3d> maps = {
      Eigen::Matrix3d::Identity(),                                                           // 0
      turn,                                                                                  // 1
      in_plane(2, 0, 0, 1),                                                                  // 2: stretch
      in_plane(0.5, 0, 0, 1),                                                                // 3: compression
      turn * in_plane(1, 0, 0, 2) * Eigen::AngleAxisd(0.3, Vec::UnitZ()).toRotationMatrix(), // 4: stretch, turned
      in_plane(2, 0, 0, 2),                                                                  // 5: both ways
      in_plane(1, gamma, 0, 1),                                                              // 6: simple shear
      in_plane(-1, 0, 0, 1),   // 7: reflected in the plane, as a triangle can be by turning it over in space
      in_plane(2, 0, 0, 0.5)}; // 8: pure shear
  // C of the simple shear is [1 g; g 1 + g^2]; sqrt(lambda) = sqrt(1 + g^2/4) +- g/2, and their product is 1
  const double stretch = std::sqrt(1 + gamma * gamma / 4) + gamma / 2;
  const double l1 = stretch * stretch, l2 = 1 / l1;
  const double ln2 = std::log(2.);
  const auto check = [](const std::vector<double>& strains, const std::vector<double>& expected) {
    CHECK(strains.size() == expected.size());
    for (std::size_t i = 0; i < strains.size(); ++i) CHECK_NEAR(strains[i], expected[i], 1e-13);
  };
  check(strains_of_maps(maps, Amf::Hencky_strain()),
        {0, 0, ln2, ln2, ln2, std::sqrt(2.) * ln2, std::sqrt(2.) * std::log(stretch), 0, std::sqrt(2.) * ln2});
  check(strains_of_maps(maps, Amf::Green_lagrange_strain()),
        {0, 0, 1.5, 0.375, 1.5, 1.5 * std::sqrt(2.), 0.5 * std::hypot(l1 - 1, l2 - 1), 0, std::hypot(1.5, 0.375)});
  check(strains_of_maps(maps, Amf::Principal_stretch_strain()), {0, 0, 1, 0.5, 1, 1, stretch - 1, 0, 1});
  check(strains_of_maps(maps, Amf::Largest_eigenvalue_strain()), {1, 1, 4, 1, 4, 4, l1, 1, 4});
}

void test_rigid_motion()
{
  Random random(1);
  Shape s = sphere(3);
  s.add(irregular_square(12, random), Vec(3, 0, 0));
  std::vector<Points> frames;
  for (int f = 0; f < 7; ++f) {
    const Eigen::AngleAxisd turn = random.rotation();
    const Vec shift = random.vector(100);
    frames.push_back(mapped(s.points, [&](const Vec& p) { return Vec(turn * p + shift); }));
  }
  const Mesh mesh = mesh_of(s);
  const auto sequence = sequence_of(mesh, s.points, frames);
  // coordinates near 100 against edges of 0.1: 1e-13 of an edge is lost
  const auto largest = [](const Field& field, double rest) {
    double e = 0;
    for (std::size_t i = 0; i < field.number_of_rows(); ++i)
      for (std::size_t f = 0; f < field.number_of_frames(); ++f)
        if (!(std::abs(field(i, f) - rest) <= e)) e = std::abs(field(i, f) - rest);
    return e;
  };
  CHECK(largest(Amf::strain(sequence), 0) < 5e-12);
  CHECK(largest(Amf::strain(sequence, Amf::Green_lagrange_strain()), 0) < 5e-12);
  CHECK(largest(Amf::strain(sequence, Amf::Principal_stretch_strain()), 0) < 5e-12);
  CHECK(largest(Amf::strain(sequence, Amf::Largest_eigenvalue_strain()), 1) < 5e-12);
}

// Triangles of their own, with needles and flat ones among them, and how each is deformed.
struct Loose_triangles
{
  Shape rest;
  std::vector<Points> frames;
};

typedef Eigen::Matrix<long double, 3, 1> Long_vec;
typedef Eigen::Matrix<long double, 3, 3> Long_matrix;

Loose_triangles loose_triangles(int n, int number_of_frames, double flattest, Random& random)
{
  Loose_triangles result;
  result.frames.resize(std::size_t(number_of_frames));
  for (int t = 0; t < n; ++t) {
    // base, foot of the height, height, in random position
    const double size = random.power(0.01, 100), foot = random(-0.5, 1.5);
    const double height = t % 2 == 0 ? random.power(flattest, 1) : random.power(0.1, 10);
    const Eigen::AngleAxisd turn = random.rotation();
    const auto placed = [&](double x, double y) { return Vec(size * (turn * Vec(x, y, 0))); };
    const int first = int(result.rest.points.size());
    const Points corners = {placed(0, 0), placed(1, 0), placed(foot, height)};
    result.rest.points.insert(result.rest.points.end(), corners.begin(), corners.end());
    result.rest.faces.push_back({{first, first + 1, first + 2}});
    for (Points& frame : result.frames) {
      // a random map of the plane into space, with stretches far from and close to 1
      const double spread = t % 3 == 0 ? 1e-4 : t % 3 == 1 ? 0.5 : 4;
      const Eigen::AngleAxisd before(random(-pi, pi), turn * Vec::UnitZ());
      const Eigen::AngleAxisd after = random.rotation();
      const double a = std::exp(random(-spread, spread)), b = std::exp(random(-spread, spread));
      const Vec x = turn * Vec::UnitX(), y = turn * Vec::UnitY();
      for (const Vec& p : corners) {
        const Vec q = before * p;
        frame.push_back(after * Vec(a * x.dot(q) * x + b * y.dot(q) * y));
      }
    }
  }
  return result;
}

// C = F^T F with F = [f1 f2 m] [e1 e2 n]^-1, n and m unit normals: the definition, in three dimensions.
Long_matrix cauchy_green(const Points& rest, const Points& frame, const std::array<int, 3>& c, double& aspect)
{
  const auto frame_of = [&](const Points& p) {
    Long_matrix v;
    v.col(0) = (p[std::size_t(c[1])] - p[std::size_t(c[0])]).cast<long double>();
    v.col(1) = (p[std::size_t(c[2])] - p[std::size_t(c[0])]).cast<long double>();
    v.col(2) = Long_vec(v.col(0)).cross(Long_vec(v.col(1)));
    v.col(2) /= v.col(2).norm();
    return v;
  };
  const Long_matrix v0 = frame_of(rest), v1 = frame_of(frame);
  const long double area = Long_vec(v0.col(0)).cross(Long_vec(v0.col(1))).norm();
  const long double longest =
      (std::max)({v0.col(0).squaredNorm(), v0.col(1).squaredNorm(), (v0.col(0) - v0.col(1)).squaredNorm()});
  aspect = double(longest / area);
  const Long_matrix f = v1 * v0.inverse();
  return f.transpose() * f;
}

void test_against_definition()
{
  Random random(2);
  const Loose_triangles loose = loose_triangles(600, 9, 1e-6, random);
  const Mesh mesh = mesh_of(loose.rest);
  const auto sequence = sequence_of(mesh, loose.rest.points, loose.frames);
  const Field hencky = Amf::triangle_strain(sequence);
  const Field green = Amf::triangle_strain(sequence, Amf::Green_lagrange_strain());
  const Field stretch = Amf::triangle_strain(sequence, Amf::Principal_stretch_strain());
  const Field largest = Amf::triangle_strain(sequence, Amf::Largest_eigenvalue_strain());
  double worst = 0, flattest = 0;
  for (std::size_t t = 0; t < loose.rest.faces.size(); ++t)
    for (std::size_t f = 0; f < loose.frames.size(); ++f) {
      double aspect;
      const Long_matrix long_c = cauchy_green(loose.rest.points, loose.frames[f], loose.rest.faces[t], aspect);
      const Eigen::SelfAdjointEigenSolver<Long_matrix> solver(long_c);
      const Eigen::Vector3d lambda = solver.eigenvalues().cast<double>();
      const Eigen::Matrix3d c = long_c.cast<double>();
      // Rounding moves a corner by 1e-16 of the triangle, which is 1e-16 * aspect of its height; where it is much more
      // stretched in one direction than in the other, the small stretch takes its error from the large one.
      const double unit = 1e-15 * aspect * std::sqrt(lambda[2] / lambda[0]);
      const auto check = [&](double value, double expected, double scale) {
        const double error = std::abs(value - expected) / (scale * unit);
        if (!(error <= worst)) worst = error;
      };
      check(hencky(t, f), 0.5 * lambda.array().log().matrix().norm(), 1);
      check(green(t, f), 0.5 * (c - Eigen::Matrix3d::Identity()).norm(), lambda[2]);
      check(stretch(t, f), (lambda.array().sqrt() - 1).abs().maxCoeff(), std::sqrt(lambda[2]));
      check(largest(t, f), lambda[2], lambda[2]);
      flattest = (std::max)(flattest, aspect);
    }
  CHECK(flattest > 1e5);
  CHECK(worst < 1);
  std::cout << "strain against C of 3 x 3: error / (1e-15 aspect sqrt(l1 / l2)) up to " << worst << ", aspects up to "
            << flattest << std::endl;
}

void test_collapse_in_a_frame()
{
  const Shape s = {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)}, {{{0, 1, 2}}}};
  const std::vector<Points> frames = {
      s.points,
      Points(3, Vec(5, 6, 7)),                        // to a point
      {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 0, 0)},     // to a segment: the second direction is lost
      {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1e-9, 0)}}; // nearly so: below the clamp of 1e-6 in length
  const Mesh mesh = mesh_of(s);
  const double lost = std::log(1e12); // -ln of the smallest squared stretch
  const auto check = [&](auto ft, double tolerance) {
    typedef decltype(ft) FT;
    const auto sequence = sequence_of<FT>(mesh, s.points, frames);
    const auto hencky = Amf::triangle_strain(sequence);
    const auto green = Amf::triangle_strain(sequence, Amf::Green_lagrange_strain());
    const auto stretch = Amf::triangle_strain(sequence, Amf::Principal_stretch_strain());
    const auto largest = Amf::triangle_strain(sequence, Amf::Largest_eigenvalue_strain());
    CHECK_NEAR(hencky(0, 0), 0, tolerance);
    CHECK_NEAR(hencky(0, 1), lost / std::sqrt(2.), 20 * tolerance);
    CHECK_NEAR(green(0, 1), std::sqrt(0.5), tolerance);
    CHECK_NEAR(stretch(0, 1), 1 - 1e-6, tolerance);
    CHECK_NEAR(largest(0, 1), 1, tolerance);
    for (int f = 2; f < 4; ++f) {
      CHECK_NEAR(hencky(0, f), lost / 2, 20 * tolerance);
      CHECK_NEAR(green(0, f), 0.5, tolerance);
      CHECK_NEAR(stretch(0, f), 1 - 1e-6, tolerance);
      CHECK_NEAR(largest(0, f), 1, tolerance);
    }
  };
  check(double(), 1e-12);
  check(float(), 1e-6);
}

void test_degenerate_rest_triangles()
{
  // a square of which one triangle has its corners in a line, and a triangle whose corners coincide, by itself
  const Shape s = {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(1, 1, 0), Vec(0, 1, 0), Vec(0.5, 0, 0), // 0-4
                    Vec(9, 9, 9), Vec(9, 9, 9), Vec(9, 9, 9),                               // 5-7
                    Vec(4, 4, 4)},                                                          // 8, isolated
                   {{{0, 2, 3}}, {{0, 4, 2}}, {{4, 1, 2}}, {{0, 1, 4}}, {{5, 6, 7}}}};
  std::vector<Points> frames;
  Random random(3);
  for (int f = 0; f < 5; ++f)
    frames.push_back(mapped(s.points, [&](const Vec& p) { return Vec(p + random.vector(0.3)); }));
  const Mesh mesh = mesh_of(s);
  const auto sequence = sequence_of(mesh, s.points, frames);
  CHECK(sequence.report().degenerate_rest_triangles == 2);
  for (const Amf::Triangle_weights weights : {Amf::Triangle_weights::UNIFORM, Amf::Triangle_weights::REST_AREA}) {
    const Field triangle = Amf::triangle_strain(sequence, Amf::Largest_eigenvalue_strain());
    const Field vertex = Amf::strain(sequence, Amf::Largest_eigenvalue_strain(), weights);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      for (std::size_t t : {0, 1, 2}) CHECK(triangle(t, f) >= 1);
      for (std::size_t t : {3, 4}) CHECK(triangle(t, f) == 0);
      for (std::size_t v : {5, 6, 7, 8}) CHECK(vertex(v, f) == 0);
      CHECK_NEAR(vertex(1, f), triangle(2, f), 1e-12); // its other triangle is degenerate and left out
      const double a = weights == Amf::Triangle_weights::UNIFORM ? 0.5 : 1. / 2; // areas 1/4 each
      CHECK_NEAR(vertex(4, f), a * triangle(1, f) + (1 - a) * triangle(2, f), 1e-12);
      const double b = weights == Amf::Triangle_weights::UNIFORM ? 0.5 : 2. / 3; // areas 1/2 and 1/4
      CHECK_NEAR(vertex(0, f), b * triangle(0, f) + (1 - b) * triangle(1, f), 1e-12);
    }
  }
}

// Surfaces with borders and a component by itself; every frame deforms all of it.
struct Waving
{
  Shape rest;
  std::vector<Points> frames;

  explicit Waving(std::size_t number_of_frames)
  {
    Random random(4);
    rest = irregular_square(9, random, 0.35);
    rest.add(sphere(2), Vec(3, 0, 0));
    rest.points.emplace_back(0, 0, 5);
    for (std::size_t f = 0; f < number_of_frames; ++f)
      frames.push_back(mapped(rest.points, [&](const Vec& p) {
        const double t = 0.4 * double(f);
        return Vec(p + 0.2 * Vec(std::sin(3 * p[1] + t), std::cos(2 * p[0] - t), std::sin(4 * p[0] + 2 * p[1] + t)));
      }));
  }
};

void test_vertex_means()
{
  const Waving w(6);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of(mesh, w.rest.points, w.frames);
  const Field triangle = Amf::triangle_strain(sequence);
  for (const Amf::Triangle_weights weights : {Amf::Triangle_weights::UNIFORM, Amf::Triangle_weights::REST_AREA}) {
    const Field vertex = Amf::strain(sequence, Amf::Hencky_strain(), weights);
    CHECK(vertex.number_of_rows() == w.rest.points.size());
    double worst = 0;
    for (std::size_t v = 0; v < w.rest.points.size(); ++v)
      for (std::size_t f = 0; f < w.frames.size(); ++f) {
        double sum = 0, total = 0;
        for (std::size_t t = 0; t < w.rest.faces.size(); ++t) {
          const auto& c = w.rest.faces[t];
          if (std::find(c.begin(), c.end(), int(v)) == c.end()) continue;
          const Vec p = w.rest.points[std::size_t(c[0])];
          const Vec n = (w.rest.points[std::size_t(c[1])] - p).cross(w.rest.points[std::size_t(c[2])] - p);
          const double weight = weights == Amf::Triangle_weights::UNIFORM ? 1 : n.norm();
          sum += weight * triangle(t, f);
          total += weight;
        }
        const double error = std::abs(vertex(v, f) - (total > 0 ? sum / total : 0));
        if (!(error <= worst)) worst = error;
      }
    CHECK(worst < 1e-13);
  }
  // the two weights are not the same thing, and the default is by area
  const Field uniform = Amf::strain(sequence, Amf::Hencky_strain(), Amf::Triangle_weights::UNIFORM);
  CHECK(!same_bits(Amf::strain(sequence), uniform, w.frames.size()));
  CHECK(same_bits(Amf::strain(sequence), Amf::strain(sequence, Amf::Hencky_strain(), Amf::Triangle_weights::REST_AREA),
                  w.frames.size()));
}

// A measure as a user writes it, knowing nothing of Eigen.
struct Scalar_hencky
{
  double operator()(double lambda_1, double lambda_2) const
  {
    return 0.5 * std::sqrt(std::log(lambda_1) * std::log(lambda_1) + std::log(lambda_2) * std::log(lambda_2));
  }
};
struct Area_change // a quantity of the user's own
{
  static constexpr bool vectorized = false;
  double operator()(double lambda_1, double lambda_2) const { return std::sqrt(lambda_1 * lambda_2); }
};

void test_user_measures()
{
  const Waving w(11);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of(mesh, w.rest.points, w.frames);
  const Field ours = Amf::strain(sequence), theirs = Amf::strain(sequence, Scalar_hencky());
  double worst = 0;
  for (std::size_t v = 0; v < ours.number_of_rows(); ++v)
    for (std::size_t f = 0; f < w.frames.size(); ++f)
      if (!(std::abs(ours(v, f) - theirs(v, f)) <= worst)) worst = std::abs(ours(v, f) - theirs(v, f));
  CHECK(worst < 1e-14);
  const Field area = Amf::triangle_strain(sequence, Area_change());
  for (std::size_t t = 0; t < area.number_of_rows(); ++t)
    for (std::size_t f = 0; f < w.frames.size(); ++f) {
      const auto twice = [&](const Points& p) {
        const auto& c = w.rest.faces[t];
        return (p[std::size_t(c[1])] - p[std::size_t(c[0])]).cross(p[std::size_t(c[2])] - p[std::size_t(c[0])]).norm();
      };
      if (std::abs(area(t, f) - twice(w.frames[f]) / twice(w.rest.points)) > 1e-12) CHECK(!"ratio of areas");
    }
}

// A measure of the user's that takes Eigen arrays, as the concept has it, which those of the library need not be given.
template <class Measure>
struct With_arrays : Measure
{
};

// The same bits with any vector instructions, and through Eigen arrays where all operations are exactly rounded.
template <class FT, class Measure>
void test_instructions(double difference_of_arrays)
{
  namespace Ai = Amf::internal;
  const Waving w(35);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of<FT>(mesh, w.rest.points, w.frames);
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::STRAIN);
  const auto strains = [&](const auto& measure, Ai::Instruction_set instructions) {
    return Ai::triangle_strain_rows(sequence.rest_shape(), sequence.trajectories(), measure, loop, instructions);
  };
  const auto means = [&](Ai::Instruction_set instructions) {
    return Ai::vertex_strain_rows(sequence.rest_shape(), sequence.trajectories(), Measure(), Amf::Triangle_weights::REST_AREA, loop,
                                  instructions);
  };
  const auto baseline = strains(Measure(), Ai::Instruction_set::BASELINE);
  const auto widest = Ai::widest_instruction_set();
  CHECK(same_bits(baseline, strains(Measure(), widest), w.frames.size()));
  CHECK(same_bits(means(Ai::Instruction_set::BASELINE), means(widest), w.frames.size()));
  const auto arrays = strains(With_arrays<Measure>(), widest);
  double worst = 0;
  for (std::size_t t = 0; t < arrays.number_of_rows(); ++t)
    for (std::size_t f = 0; f < w.frames.size(); ++f) {
      const double difference = std::abs(double(arrays(t, f)) - double(baseline(t, f)));
      if (!(difference <= worst)) worst = difference;
    }
  CHECK(worst <= difference_of_arrays);
}

void test_float()
{
  const Waving w(12);
  const Mesh mesh = mesh_of(w.rest);
  const Field exact = Amf::strain(sequence_of(mesh, w.rest.points, w.frames));
  const auto rounded = Amf::strain(sequence_of<float>(mesh, w.rest.points, w.frames));
  double worst = 0;
  for (std::size_t v = 0; v < exact.number_of_rows(); ++v)
    for (std::size_t f = 0; f < w.frames.size(); ++f)
      if (!(std::abs(exact(v, f) - double(rounded(v, f))) <= worst))
        worst = std::abs(exact(v, f) - double(rounded(v, f)));
  // coordinates of 4 are rounded by 2.4e-7, edges are about 0.1 long, heights half of that
  CHECK(worst > 0);
  CHECK(worst < 3e-6);
  std::cout << "strain, float against double: " << worst << std::endl;
}

template <class FT>
void test_numbers_of_frames()
{
  const Waving w(20);
  const Mesh mesh = mesh_of(w.rest);
  const auto all = Amf::strain(sequence_of<FT>(mesh, w.rest.points, w.frames));
  for (std::size_t n = 3; n <= 20; ++n) {
    const std::vector<Points> some(w.frames.begin(), w.frames.begin() + std::ptrdiff_t(n));
    const auto sequence = sequence_of<FT>(mesh, w.rest.points, some);
    const auto field = Amf::strain<CGAL::Sequential_tag>(sequence);
    CHECK(field.number_of_frames() == n);
    CHECK(same_bits(field, all, n));
    CHECK(same_bits(field, Amf::strain<CGAL::Parallel_tag>(sequence), n));
    CHECK(same_bits(Amf::triangle_strain<CGAL::Sequential_tag>(sequence), Amf::triangle_strain<CGAL::Parallel_tag>(sequence), n));
  }
}

int main()
{
  test_known_deformations();
  test_rigid_motion();
  test_against_definition();
  test_collapse_in_a_frame();
  test_degenerate_rest_triangles();
  test_vertex_means();
  test_user_measures();
  test_instructions<double, Amf::Hencky_strain>(1e-14); // logarithms of their own
  test_instructions<double, Amf::Green_lagrange_strain>(0);
  test_instructions<double, Amf::Principal_stretch_strain>(0);
  test_instructions<double, Amf::Largest_eigenvalue_strain>(0);
  test_instructions<float, Amf::Hencky_strain>(1e-6); // Eigen's roots of floats are not exactly rounded
  test_instructions<float, Amf::Green_lagrange_strain>(4e-6);
  test_instructions<float, Amf::Principal_stretch_strain>(1e-6);
  test_instructions<float, Amf::Largest_eigenvalue_strain>(0);
  test_float();
  test_numbers_of_frames<double>();
  test_numbers_of_frames<float>();
  return test_result();
}
