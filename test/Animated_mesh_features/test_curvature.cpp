// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvature against closed forms, dihedral angles against two independent computations, sums over balls against sums
// over all edges and triangles.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Deformation/deformation.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/geodesic_balls.h>

#include <CGAL/Kernel/global_functions.h>

#include <limits>
#include <set>

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

template <class Sequence>
Amf::Compressed_rows dijkstra_balls(const Sequence& sequence, double radius)
{
  return Amf::geodesic_balls(sequence.rest_shape(), radius, Amf::Dijkstra_geodesic_balls());
}

Points scaled(const Points& points, double factor)
{
  return mapped(points, [&](const Vec& p) { return Vec(factor * p); });
}

template <class A, class B>
double largest_difference(const A& a, const B& b)
{
  double largest = a.number_of_rows() == b.number_of_rows() && a.number_of_frames() == b.number_of_frames()
                       ? 0
                       : std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < a.number_of_rows(); ++v)
    for (std::size_t f = 0; f < a.number_of_frames(); ++f)
      if (!(std::abs(double(a(v, f)) - double(b(v, f))) <= largest))
        largest = std::abs(double(a(v, f)) - double(b(v, f)));
  return largest;
}

struct Density_error
{
  double mean, largest;
};

// |mean of H R - 1| and the largest |H R - 1| (cylinder: 2 H R) over the vertices for which `counts` says so. The
// frames have radii 1/2, 1, 2 times that of the rest shape, on which the balls are.
template <class Counts>
Density_error density_error(const Shape& s, double radius, double curvature_of_unit, const Counts& counts)
{
  const double radii[] = {0.5, 1, 2};
  std::vector<Points> frames;
  for (double r : radii) frames.push_back(scaled(s.points, r));
  const Mesh mesh = mesh_of(s);
  const auto sequence = sequence_of(mesh, s.points, frames);
  Amf::Mean_curvature_density measure;
  measure.length_over_diameter = 1 / sequence.rest_shape().diameter();
  const Field h = Amf::curvature(sequence, dijkstra_balls(sequence, radius), measure);
  double sum = 0, worst = 0;
  std::size_t counted = 0;
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    if (!counts(s.points[v])) continue;
    for (std::size_t f = 0; f < 3; ++f) {
      const double error = h(v, f) * radii[f] / curvature_of_unit - 1;
      ++counted;
      sum += error;
      if (!(std::abs(error) <= worst)) worst = std::abs(error);
    }
  }
  CHECK(counted > 60);
  return {std::abs(sum / double(counted)), worst};
}

void test_density_under_refinement()
{
  const auto all = [](const Vec&) { return true; };
  const auto inner = [](const Vec& p) {
    return p[2] > 1 && p[2] < 3;
  }; // farther from the border than the ball's radius
  for (int level = 0; level < 3; ++level) {
    const Density_error on_sphere = density_error(sphere(3 + level), 0.6, 1, all);
    const int around = 20 << level;
    const Density_error on_tube = density_error(tube(around, 1 + 4 * around / 5, 4), 0.6, 0.5, inner);
    const double h2 = std::pow(4., -level); // of second order in h
    CHECK(on_sphere.mean < 0.009 * h2);
    CHECK(on_tube.mean < 0.004 * h2);
    CHECK(on_sphere.largest < 0.02 * h2);
    CHECK(on_tube.largest < 0.005 * h2);
    std::cout << "mean curvature density, h / " << (1 << level) << ": error on sphere " << on_sphere.mean
              << ", largest " << on_sphere.largest << "; on cylinder " << on_tube.mean << ", largest "
              << on_tube.largest << std::endl;
  }
}

void test_sign()
{
  Shape s = sphere(2);
  s.add(tube(16, 7, 3), Vec(4, 0, 0));
  Shape inverted = s;
  for (auto& f : inverted.faces) std::swap(f[1], f[2]);
  const Mesh mesh = mesh_of(s), inside_out = mesh_of(inverted);
  const auto a = sequence_of(mesh, s.points, {s.points, s.points, s.points});
  const auto b = sequence_of(inside_out, s.points, {s.points, s.points, s.points});
  const auto check = [&](const auto& measure, double least) {
    const Field outward = Amf::curvature(a, dijkstra_balls(a, 0.7), measure);
    const Field inward = Amf::curvature(b, dijkstra_balls(b, 0.7), measure);
    double worst = 0, smallest = 1;
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      worst = (std::max)(worst, std::abs(outward(v, 1) + inward(v, 1)));
      smallest = (std::min)(smallest, outward(v, 1));
    }
    CHECK(worst < 1e-13);
    CHECK(smallest > least);
  };
  check(Amf::Mean_curvature_density(), 0.005); // H l with H >= 1/2 and a diagonal of 6
  check(Amf::Mean_dihedral_angle(), 0.1);
}

typedef Eigen::Matrix<long double, 3, 1> Long_vec;

// The angle from the normal of (a, b, c) to that of (b, a, d) about b - a: positive where convex.
long double dihedral_angle(const Vec& pa, const Vec& pb, const Vec& pc, const Vec& pd)
{
  const Long_vec a = pa.cast<long double>(), b = pb.cast<long double>(), c = pc.cast<long double>(),
                 d = pd.cast<long double>();
  const Long_vec e = b - a, n1 = e.cross(Long_vec(c - a)), n2 = Long_vec(d - a).cross(e);
  return std::atan2(n1.cross(n2).dot(e) / e.norm(), n1.dot(n2));
}

void test_dihedral_angles()
{
  // Hinges of two triangles, each in a ball of its own, in which the only inner edge is the hinge: the mean over the
  // ball's edges is its angle.
  Random random(11);
  const std::size_t n = 2000, number_of_frames = 11;
  Shape s;
  std::vector<Points> frames(number_of_frames);
  Amf::Compressed_rows balls;
  for (std::size_t i = 0; i < n; ++i) {
    const int o = int(4 * i);
    // both orders of the edge's ends
    if (i % 2 == 0)
      s.faces.insert(s.faces.end(), {{{o, o + 1, o + 2}}, {{o + 1, o, o + 3}}});
    else
      s.faces.insert(s.faces.end(), {{{o + 1, o, o + 2}}, {{o, o + 1, o + 3}}});
    for (std::size_t f = 0; f < number_of_frames; ++f) {
      const double side = random.bits() % 2 ? 1 : -1;
      // any angle; nearly flat; nearly folded
      const double angle = i % 3 == 0   ? random(-pi, pi)
                           : i % 3 == 1 ? side * random.power(1e-12, 1e-2)
                                        : side * (pi - random.power(1e-10, 1e-2));
      const double length = random.power(0.2, 5);
      const Vec c(random(-1, 2), random.power(0.2, 5), 0);
      const double height = random.power(0.2, 5);
      const Vec d(random(-1, 2), -height * std::cos(angle), -height * std::sin(angle));
      const Eigen::AngleAxisd turn = random.rotation();
      const Vec shift = random.vector();
      Vec a(0, 0, 0), b(length, 0, 0);
      if (i % 2) std::swap(a, b);
      for (const Vec& p : {a, b, c, d}) frames[f].push_back(turn * p + shift);
    }
    for (int k = 0; k < 4; ++k) {
      const int ball[] = {o, o + 1, o + 2, o + 3};
      balls.push_back(ball, ball + 4);
    }
  }
  s.points = frames[0];
  const Mesh mesh = mesh_of(s);
  const Field angle = Amf::curvature(sequence_of(mesh, frames[0], frames), balls, Amf::Mean_dihedral_angle());
  const auto single = Amf::curvature(sequence_of<float>(mesh, frames[0], frames), balls, Amf::Mean_dihedral_angle());
  double worst = 0, worst_float = 0, worst_cgal = 0, flattest = 1, most_folded = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t f = 0; f < number_of_frames; ++f) {
      Vec p[4];
      Point_3 q[4];
      for (std::size_t k = 0; k < 4; ++k) p[k] = frames[f][4 * i + k];
      if (i % 2) std::swap(p[0], p[1]);
      for (std::size_t k = 0; k < 4; ++k) q[k] = Point_3(p[k][0], p[k][1], p[k][2]);
      const double expected = double(dihedral_angle(p[0], p[1], p[2], p[3]));
      const double value = angle(4 * i + f % 4, f);
      // Rounding of normals is up to 100 eps, as edges differ in length by up to 25; and the angle, which is computed
      // from the tangent of its half, loses digits towards a fold, where its sign is lost as well.
      const auto tolerance = [&](double eps) { return 100 * eps + 8 * eps / (pi - std::abs(expected)); };
      const double eps = std::numeric_limits<double>::epsilon(), float_eps = std::numeric_limits<float>::epsilon();
      const auto error = [&](double v) {
        return std::min(std::abs(v - expected), std::abs(std::abs(v - expected) - 2 * pi)); // the sign, at a fold
      };
      const auto bounded = [&](double& worst_error, double v, double eps) {
        const double bound = tolerance(eps);
        // away from the fold the sign counts
        const double e = pi - std::abs(expected) > 100 * std::sqrt(eps) ? std::abs(v - expected) : error(v);
        if (!(e / bound <= worst_error)) worst_error = e / bound;
      };
      bounded(worst, value, eps);
      bounded(worst_float, double(single(4 * i, f)), float_eps);
      // CGAL's is in degrees, interior, through acos: good to some 1e-6 at its ends
      const double cgal = CGAL::approximate_dihedral_angle(q[0], q[1], q[2], q[3]) * pi / 180;
      const double signed_cgal = (cgal > 0 ? 1 : -1) * (pi - std::abs(cgal));
      if (pi - std::abs(expected) > 1e-5 && std::abs(expected) > 1e-5)
        worst_cgal = (std::max)(worst_cgal, std::abs(value - signed_cgal));
      flattest = (std::min)(flattest, std::abs(expected));
      most_folded = (std::max)(most_folded, std::abs(expected));
    }
  CHECK(worst < 1);
  CHECK(worst_float < 5); // here coordinates are rounded as well
  CHECK(worst_cgal < 1e-5);
  CHECK(flattest < 1e-11 && pi - most_folded < 1e-9);
  std::cout << "dihedral angles: error / bound " << worst << ", float " << worst_float << "; against CGAL's "
            << worst_cgal << std::endl;
}

void test_complete_fold()
{
  // one triangle exactly on the other: whether by pi or -pi cannot be told
  const Shape s = {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(0.5, -1, 0.1)}, {{{0, 1, 2}}, {{1, 0, 3}}}};
  std::vector<Points> frames(3, s.points);
  frames[1][3] = Vec(0, 1, 0);
  frames[2][3] = Vec(0.5, 2, 0);
  const Mesh mesh = mesh_of(s);
  const auto sequence = sequence_of(mesh, s.points, frames);
  const Field angle = Amf::curvature(sequence, dijkstra_balls(sequence, 9), Amf::Mean_dihedral_angle());
  CHECK_NEAR(angle(0, 0), -std::atan2(0.1, 1.), 1e-14);
  CHECK(angle(0, 1) == 0);
  CHECK(angle(0, 2) == 0);
}

// A surface with borders, another component, an isolated vertex; all of it moves in every frame.
struct Waving
{
  Shape rest;
  std::vector<Points> frames;

  explicit Waving(std::size_t number_of_frames)
  {
    Random random(12);
    rest = irregular_square(11, random, 0.35);
    rest.points =
        mapped(rest.points, [](const Vec& p) { return Vec(p + 0.1 * Vec(0, 0, std::sin(6 * p[0] + 4 * p[1]))); });
    Shape ball = sphere(2);
    ball.points = scaled(ball.points, 0.3);
    rest.add(ball, Vec(2, 0, 0));
    rest.points.emplace_back(0, 0, 1);
    for (std::size_t f = 0; f < number_of_frames; ++f)
      frames.push_back(mapped(rest.points, [&](const Vec& p) {
        const double t = 0.4 * double(f);
        return Vec(p + 0.1 * Vec(std::sin(3 * p[1] + t), std::cos(2 * p[0] - t), std::sin(7 * p[0] + 5 * p[1] + t)));
      }));
  }
};

// All edges with the corners opposite to them, -1 at a border, from the faces alone.
struct Plain_edge
{
  int a, b, left, right; // the left triangle runs a, b
};

std::vector<Plain_edge> plain_edges(const Shape& s)
{
  std::map<std::pair<int, int>, int> opposite;
  for (const auto& f : s.faces)
    for (std::size_t i = 0; i < 3; ++i) opposite[{f[i], f[(i + 1) % 3]}] = f[(i + 2) % 3];
  std::vector<Plain_edge> edges;
  for (const auto& o : opposite) {
    const auto other = opposite.find({o.first.second, o.first.first});
    if (other == opposite.end())
      edges.push_back({o.first.first, o.first.second, o.second, -1});
    else if (o.first.first < o.first.second)
      edges.push_back({o.first.first, o.first.second, o.second, other->second});
  }
  return edges;
}

void test_sums_over_balls()
{
  const Waving w(5);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of(mesh, w.rest.points, w.frames);
  const std::vector<Plain_edge> edges = plain_edges(w.rest);
  for (const double radius : {0.05, 0.2, 0.5}) { // the smallest one holds no edges at some vertices
    const Amf::Compressed_rows balls = dijkstra_balls(sequence, radius);
    const Field density = Amf::curvature(sequence, balls),
                mean = Amf::curvature(sequence, balls, Amf::Mean_dihedral_angle());
    double worst_density = 0, worst_mean = 0;
    std::size_t lonely = 0;
    for (std::size_t v = 0; v < w.rest.points.size(); ++v) {
      const std::set<int> ball(balls[v].begin(), balls[v].end());
      for (std::size_t f = 0; f < w.frames.size(); ++f) {
        const Points& p = w.frames[f];
        double numerator = 0, sum = 0, area = 0;
        int count = 0;
        for (const Plain_edge& e : edges) {
          const int ends = int(ball.count(e.a) + ball.count(e.b));
          if (e.right < 0 || ends == 0) continue; // at the border there is no angle
          const double beta = double(dihedral_angle(p[std::size_t(e.a)], p[std::size_t(e.b)], p[std::size_t(e.left)],
                                                    p[std::size_t(e.right)]));
          numerator += ends / 2. * beta * (p[std::size_t(e.b)] - p[std::size_t(e.a)]).norm();
          if (ends == 2) sum += beta, ++count;
        }
        for (const auto& t : w.rest.faces) {
          const double corners = double(ball.count(t[0]) + ball.count(t[1]) + ball.count(t[2]));
          const Vec o = p[std::size_t(t[0])];
          area += corners / 3 * (p[std::size_t(t[1])] - o).cross(p[std::size_t(t[2])] - o).norm() / 2;
        }
        const double unit = 0.006 * sequence.rest_shape().diameter();
        const double expected = area > 0 ? unit * numerator / (2 * area) : 0;
        const double expected_mean = count > 0 ? sum / count : 0;
        if (count == 0) ++lonely;
        const double e = std::abs(density(v, f) - expected), m = std::abs(mean(v, f) - expected_mean);
        if (!(e <= worst_density)) worst_density = e;
        if (!(m <= worst_mean)) worst_mean = m;
      }
    }
    CHECK(worst_density < 1e-13);
    CHECK(worst_mean < 1e-13);
    CHECK(lonely >= w.frames.size()); // at least the isolated vertex
    CHECK((radius < 0.1) == (lonely > 10 * w.frames.size()));
  }
}

template <class FT>
void test_change_is_zero_at_rest()
{
  Waving w(9);
  w.frames[4] = w.rest.points;
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of<FT>(mesh, w.rest.points, w.frames);
  const auto check = [&](const auto& measure) {
    const Amf::Compressed_rows balls = dijkstra_balls(sequence, 0.3);
    const auto change = Amf::curvature_change(sequence, balls, measure);
    const auto now = Amf::curvature(sequence, balls, measure);
    double zero = 0, moved = 0, difference = 0;
    for (std::size_t v = 0; v < change.number_of_rows(); ++v) {
      zero = (std::max)(zero, double(std::abs(change(v, 4))));
      moved = (std::max)(moved, double(change(v, 3)));
      for (std::size_t f = 0; f < w.frames.size(); ++f)
        difference = (std::max)(difference, std::abs(double(std::abs(now(v, f) - now(v, 4)) - change(v, f))));
    }
    CHECK(zero == 0); // to the last bit
    CHECK(moved > 0.005);
    CHECK(difference == 0);
  };
  check(Amf::Mean_curvature_density());
  check(Amf::Mean_dihedral_angle());
}

template <class FT>
void test_units()
{
  const Waving w(4);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of<FT>(mesh, w.rest.points, w.frames);
  const Amf::Compressed_rows balls = dijkstra_balls(sequence, 0.3);
  const auto check = [&](const auto& measure) {
    const auto field = Amf::curvature(sequence, balls, measure);
    // powers of two change no digit, so nothing may change at all; thousands round
    for (const double unit : {std::ldexp(1., -40), std::ldexp(1., 40), 0.001, 1000.}) {
      std::vector<Points> frames;
      for (const Points& f : w.frames) frames.push_back(scaled(f, unit));
      const auto other = sequence_of<FT>(mesh, scaled(w.rest.points, unit), frames);
      const double difference = largest_difference(field, Amf::curvature(other, balls, measure));
      const bool exact = unit < 1e-6 || unit > 1e6;
      CHECK(difference <= (exact ? 0 : 500 * double(std::numeric_limits<FT>::epsilon())));
    }
  };
  check(Amf::Mean_curvature_density());
  check(Amf::Mean_dihedral_angle());
}

void test_float()
{
  const Waving w(12);
  const Mesh mesh = mesh_of(w.rest);
  const auto exact = sequence_of(mesh, w.rest.points, w.frames);
  const auto rounded = sequence_of<float>(mesh, w.rest.points, w.frames);
  const Amf::Compressed_rows balls = dijkstra_balls(exact, 0.3);
  const double density = largest_difference(Amf::curvature_change(exact, balls), Amf::curvature_change(rounded, balls));
  const double mean = largest_difference(Amf::curvature_change(exact, balls, Amf::Mean_dihedral_angle()),
                                         Amf::curvature_change(rounded, balls, Amf::Mean_dihedral_angle()));
  CHECK(density > 0 && density < 2e-6);
  CHECK(mean > 0 && mean < 1e-5);
  std::cout << "change of curvature, float against double: density " << density << ", mean angle " << mean << std::endl;
}

void test_collapsed_frames()
{
  Waving w(5);
  w.frames[1] = Points(w.rest.points.size(), Vec(1, 2, 3));                          // to a point
  w.frames[2] = mapped(w.rest.points, [](const Vec& p) { return Vec(p[0], 0, 0); }); // to a line
  for (int i = 0; i < 20; ++i) w.frames[3][std::size_t(i)] = w.frames[3][0];         // some edges and triangles
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of(mesh, w.rest.points, w.frames);
  const Amf::Compressed_rows balls = dijkstra_balls(sequence, 0.3);
  for (const Field& field :
       {Amf::curvature(sequence, balls), Amf::curvature(sequence, balls, Amf::Mean_dihedral_angle())}) {
    bool finite = true, flat = true;
    for (std::size_t v = 0; v < field.number_of_rows(); ++v) {
      for (std::size_t f = 0; f < w.frames.size(); ++f) finite = finite && std::isfinite(field(v, f));
      flat = flat && field(v, 1) == 0;
    }
    CHECK(finite);
    CHECK(flat);
  }
}

template <class FT>
void test_numbers_of_frames()
{
  const Waving w(20);
  const Mesh mesh = mesh_of(w.rest);
  const auto longest = sequence_of<FT>(mesh, w.rest.points, w.frames);
  const Amf::Compressed_rows balls = dijkstra_balls(longest, 0.3);
  const auto all = Amf::curvature_change(longest, balls);
  for (std::size_t n = 3; n <= 20; ++n) {
    const std::vector<Points> some(w.frames.begin(), w.frames.begin() + std::ptrdiff_t(n));
    const auto sequence = sequence_of<FT>(mesh, w.rest.points, some);
    const auto one = Amf::curvature_change<CGAL::Sequential_tag>(sequence, balls);
    const auto many = Amf::curvature_change<CGAL::Parallel_tag>(sequence, balls);
    bool same = one.number_of_frames() == n;
    for (std::size_t v = 0; v < w.rest.points.size(); ++v)
      for (std::size_t f = 0; f < n; ++f) same = same && one(v, f) == all(v, f) && many(v, f) == all(v, f);
    CHECK(same);
  }
}

// atan2 in packs, at all angles and scales.
template <class FT>
struct Angle_loop
{
  static constexpr std::size_t width = 64 / sizeof(FT);
  const FT *y, *x;
  FT* angles;
  std::size_t n;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Amf::internal::Pack<FT, width, register_bytes> P;
    for (std::size_t i = 0; i < n; i += width)
      Amf::internal::signed_angle(P::load(y + i), P::load(x + i)).store(angles + i);
  }
};

template <class FT>
void test_angles()
{
  namespace Ai = Amf::internal;
  Random random(53);
  const std::size_t n = 1 << 14;
  std::vector<FT> y(n), x(n), angles(n), again(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = i % 4 == 0 ? random.power(1e-20, 3) : random(-pi, pi), size = random.power(1e-6, 1e6);
    y[i] = FT(size * std::sin(angle));
    x[i] = FT(size * std::cos(angle));
  }
  const FT special[][2] = {{0, 0}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}, {FT(-0.), 1}};
  for (std::size_t i = 0; i < 10; ++i) {
    y[i] = special[i][0];
    x[i] = special[i][1];
  }
  Angle_loop<FT> baseline{y.data(), x.data(), angles.data(), n}, widest{y.data(), x.data(), again.data(), n};
  Ai::run_reproducibly<FT>(Ai::Instruction_set::BASELINE, baseline);
  Ai::run_reproducibly<FT>(Ai::widest_instruction_set(), widest);
  CHECK(angles == again);
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double expected = y[i] == 0 ? 0 : std::atan2(double(y[i]), double(x[i]));
    // small angles to their own precision
    const double error = expected == 0 ? std::abs(double(angles[i])) : std::abs(angles[i] / expected - 1);
    if (!(error <= worst)) worst = error;
  }
  CHECK(worst < 4 * double(std::numeric_limits<FT>::epsilon()));
  std::cout << "angles: relative error " << worst << std::endl;
}

template <class Measure>
struct With_arrays : Measure
{
};

// The same bits with any vector instructions, through Eigen arrays, and added to the strain block by block.
template <class FT, class Measure>
void test_instructions()
{
  namespace Ai = Amf::internal;
  const Waving w(35);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of<FT>(mesh, w.rest.points, w.frames);
  const Amf::Compressed_rows balls = dijkstra_balls(sequence, 0.3);
  Amf::Default_visitor visitor;
  const Amf::Task_loop<CGAL::Sequential_tag, Amf::Default_visitor> loop(visitor, Amf::Stage::CURVATURE);
  const auto change = [&](const auto& measure, Ai::Instruction_set instructions) {
    return Ai::curvature_change_rows(sequence.rest_shape(), sequence.trajectories(), balls, measure, loop,
                                     instructions);
  };
  const auto expected = change(Measure(), Ai::Instruction_set::BASELINE);
  const auto strain = Amf::strain(sequence);
  auto sum = strain;
  Ai::add_curvature_change(sequence.rest_shape(), sequence.trajectories(), balls, Measure(), 7.3, loop, sum);
  CHECK(largest_difference(expected, change(Measure(), Ai::widest_instruction_set())) == 0);
  CHECK(largest_difference(expected, change(With_arrays<Measure>(), Ai::widest_instruction_set())) == 0);
  CHECK(largest_difference(sum, Amf::deformation(strain, expected, 7.3)) == 0);
  CHECK(largest_difference(sum, strain) > 0);
}

void test_radius()
{
  const Waving w(3);
  const Mesh mesh = mesh_of(w.rest);
  const auto sequence = sequence_of(mesh, w.rest.points, w.frames);
  const Amf::Rest_shape& rest = sequence.rest_shape();
  CHECK_NEAR(Amf::default_ball_radius(rest), (std::max)(0.045 * rest.diameter(), 3 * rest.mean_edge_length()), 1e-15);
  CHECK_THROWS(Amf::Option_error, dijkstra_balls(sequence, -1), "radius");
  CHECK_THROWS(Amf::Option_error, dijkstra_balls(sequence, std::numeric_limits<double>::quiet_NaN()), "radius");
  CHECK_THROWS(Amf::Option_error, dijkstra_balls(sequence, std::numeric_limits<double>::infinity()), "radius");
}

int main()
{
  test_density_under_refinement();
  test_sign();
  test_dihedral_angles();
  test_complete_fold();
  test_sums_over_balls();
  test_change_is_zero_at_rest<double>();
  test_change_is_zero_at_rest<float>();
  test_units<double>();
  test_units<float>();
  test_float();
  test_collapsed_frames();
  test_numbers_of_frames<double>();
  test_numbers_of_frames<float>();
  test_angles<double>();
  test_angles<float>();
  test_instructions<double, Amf::Mean_curvature_density>();
  test_instructions<double, Amf::Mean_dihedral_angle>();
  test_instructions<float, Amf::Mean_curvature_density>();
  test_instructions<float, Amf::Mean_dihedral_angle>();
  test_radius();
  return test_result();
}
