// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The canonical shape against surfaces that are known in closed form. Shapes are compared by the distances between
// their vertices and by a signed volume: no rigid motion changes those, and the comparison shares nothing with the
// code under test.

#include "test_support.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Eigen::Vector3d Vec;
typedef std::vector<Vec> Points;
typedef std::vector<std::array<int, 3>> Faces;

const double pi = 3.14159265358979323846;

struct Shape
{
  Points points;
  Faces faces;
};

Mesh mesh_of(const Shape& shape, bool reverse_face_order = false)
{
  Mesh mesh;
  for (const Vec& p : shape.points) mesh.add_vertex(Point_3(p[0], p[1], p[2]));
  Faces faces = shape.faces;
  if (reverse_face_order) std::reverse(faces.begin(), faces.end());
  for (const auto& f : faces)
    CHECK(mesh.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2])) !=
          Mesh::null_face());
  return mesh;
}

// An open tube of radius 1 about the z axis, from 0 to `length`; point [ring * around + i].
Shape tube(int around, int rings, double length)
{
  Shape s;
  for (int k = 0; k < rings; ++k)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * pi * (i + 0.5 * (k % 2)) / around;
      s.points.emplace_back(std::cos(a), std::sin(a), length * k / (rings - 1));
    }
  for (int k = 0; k + 1 < rings; ++k)
    for (int i = 0; i < around; ++i) {
      const int a = k * around + i, b = k * around + (i + 1) % around, c = a + around, d = b + around;
      if (k % 2 == 0) {
        s.faces.push_back({{a, b, c}});
        s.faces.push_back({{b, d, c}});
      } else {
        s.faces.push_back({{a, b, d}});
        s.faces.push_back({{a, d, c}});
      }
    }
  return s;
}

Shape sphere(int subdivisions)
{
  Shape s;
  s.points = {Vec(1, 0, 0), Vec(-1, 0, 0), Vec(0, 1, 0), Vec(0, -1, 0), Vec(0, 0, 1), Vec(0, 0, -1)};
  s.faces = {{{0, 2, 4}}, {{2, 1, 4}}, {{1, 3, 4}}, {{3, 0, 4}}, {{2, 0, 5}}, {{1, 2, 5}}, {{3, 1, 5}}, {{0, 3, 5}}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto found = middles.emplace(std::minmax(a, b), int(s.points.size()));
      if (found.second) s.points.push_back((s.points[a] + s.points[b]).normalized());
      return found.first->second;
    };
    Faces faces;
    for (const auto& f : s.faces) {
      const int a = middle(f[0], f[1]), b = middle(f[1], f[2]), c = middle(f[2], f[0]);
      for (const std::array<int, 3>& g : {std::array<int, 3>{{f[0], a, c}}, std::array<int, 3>{{a, f[1], b}},
                                          std::array<int, 3>{{c, b, f[2]}}, std::array<int, 3>{{a, b, c}}})
        faces.push_back(g);
    }
    s.faces = faces;
  }
  return s;
}

Points mapped(const Points& points, const std::function<Vec(const Vec&)>& map)
{
  Points result;
  for (const Vec& p : points) result.push_back(map(p));
  return result;
}

std::vector<std::vector<Point_3>> frames_of(const std::vector<Points>& frames)
{
  std::vector<std::vector<Point_3>> result(frames.size());
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (const Vec& p : frames[f]) result[f].emplace_back(p[0], p[1], p[2]);
  return result;
}

template <class FT = double>
Points canonical(const Mesh& mesh, const std::vector<Points>& frames)
{
  const Amf::Frame_sequence<Mesh, FT> sequence(mesh, frames_of(frames), 1. / 30);
  return Amf::canonical_shape(sequence.rest_shape(), sequence.trajectories());
}

Points plain_mean(const std::vector<Points>& frames)
{
  Points mean(frames[0].size(), Vec::Zero());
  for (const Points& points : frames)
    for (std::size_t i = 0; i < points.size(); ++i) mean[i] += points[i] / double(frames.size());
  return mean;
}

// The largest difference between two shapes in the distance of two vertices.
double difference(const Points& a, const Points& b)
{
  double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double d = std::abs((a[i] - a[j]).norm() - (b[i] - b[j]).norm());
      if (!(d <= largest)) largest = d;
    }
  return largest;
}

double largest_move(const Points& a, const Points& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!((a[i] - b[i]).norm() <= largest)) largest = (a[i] - b[i]).norm();
  return largest;
}

double volume(const Points& p, const Faces& faces)
{
  double sum = 0;
  for (const auto& f : faces) sum += (p[f[0]] - p[0]).dot((p[f[1]] - p[0]).cross(p[f[2]] - p[0])) / 6;
  return sum;
}

double mean_radius(const Points& points)
{
  double sum = 0;
  for (const Vec& p : points) sum += p.head<2>().norm();
  return sum / double(points.size());
}

Points part(const Points& points, std::size_t first, std::size_t n)
{
  return Points(points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(first + n));
}

// Bends the z axis to an arc in the plane y = 0, which keeps its length.
Vec bent(const Vec& p, double curvature)
{
  if (curvature == 0) return p;
  const double r = 1 / curvature - p[0];
  return Vec(1 / curvature - r * std::cos(curvature * p[2]), p[1], r * std::sin(curvature * p[2]));
}

void test_turning_tube()
{
  const Shape s = tube(24, 17, 6);
  std::vector<Points> frames;
  for (int f = 0; f < 12; ++f)
    frames.push_back(mapped(s.points, [f](const Vec& p) {
      return Vec(Eigen::AngleAxisd(2 * pi * f / 12, Vec::UnitZ()) * p + Vec(0.3 * f, 0, -0.1 * f * f));
    }));
  const Points result = canonical(mesh_of(s), frames);
  const double error = difference(result, s.points);
  CHECK(error < 1e-9);
  CHECK_NEAR(volume(result, s.faces), volume(s.points, s.faces), 1e-8);
  CHECK(largest_move(result, frames[0]) < 1e-9); // placed where the first frame is
  Points mean = plain_mean(frames);
  Vec shift = Vec::Zero();
  for (const Vec& p : mean) shift += p / double(mean.size());
  for (Vec& p : mean) p -= shift;
  CHECK(mean_radius(mean) < 1e-9);
  std::cout << "turning tube: error " << error << ", radius of the plain mean " << mean_radius(mean) << std::endl;
}

void test_bending_tube()
{
  const double length = 8;
  const Shape s = tube(24, 25, length);
  std::vector<Points> frames;
  const int n = 24;
  for (int f = 0; f < n; ++f) {
    // to either side by 60 to 90 degrees: no frame is near to the middle
    const double angle = (f % 2 == 0 ? 1 : -1) * pi / 6 * (2 + double(f / 2) / (n / 2 - 1));
    frames.push_back(mapped(s.points, [&](const Vec& p) { return bent(p, angle / length); }));
  }
  const Points result = canonical(mesh_of(s), frames), mean = plain_mean(frames);
  const double error = difference(result, s.points) / length;
  // chords of a bent edge are shorter by (curvature * edge)^2 / 24, and angles across the bend do not average exactly
  CHECK(error < 2e-3);
  CHECK(difference(mean, s.points) / length > 0.05);
  const auto extent = [](const Points& p) { return (p.back() - p[0]).norm(); };
  CHECK(extent(mean) < 0.95 * extent(s.points));
  CHECK(extent(result) > 0.998 * extent(s.points));
  std::cout << "bending tube: error / length " << error << ", of the plain mean " << difference(mean, s.points) / length
            << std::endl;
}

void test_parts()
{
  // a sphere, a tube with borders, an isolated vertex, a patch with a triangle of zero height
  Shape s = sphere(2);
  const std::size_t n_sphere = s.points.size();
  const Shape t = tube(12, 7, 3);
  const std::size_t first_tube = n_sphere, isolated = first_tube + t.points.size(), patch = isolated + 1;
  for (const Vec& p : t.points) s.points.push_back(p + Vec(5, 0, 0));
  for (const auto& f : t.faces) {
    const int o = int(first_tube);
    s.faces.push_back({{f[0] + o, f[1] + o, f[2] + o}});
  }
  s.points.emplace_back(0, 9, 0);
  s.points.insert(s.points.end(), {Vec(-5, 0, 0), Vec(-4, 0, 0), Vec(-4, 1, 0.5), Vec(-5, 1, 0), Vec(-4.5, 0.5, 0.25)});
  const int a = int(patch);
  const Faces patch_faces = {{{a, a + 1, a + 2}}, {{a, a + 2, a + 4}}, {{a, a + 4, a + 3}}, {{a + 4, a + 2, a + 3}}};
  s.faces.insert(s.faces.end(), patch_faces.begin(), patch_faces.end());

  std::vector<Points> frames;
  for (int f = 0; f < 9; ++f) {
    Points points = s.points;
    const Eigen::AngleAxisd one(0.7 * f, Vec(1, 2, 3).normalized()), other(-1.1 * f, Vec(0, 1, -1).normalized());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i < n_sphere)
        points[i] = one * points[i] + Vec(0, 0, f);
      else if (i < isolated)
        points[i] = other * points[i];
      else if (i == isolated)
        points[i] += Vec(f, 0, 0);
      else
        points[i] = other * (one * points[i]);
    }
    frames.push_back(points);
  }
  const Points result = canonical(mesh_of(s), frames);
  for (const Vec& p : result) CHECK(p.allFinite());
  CHECK(largest_move(part(result, 0, n_sphere), part(frames[0], 0, n_sphere)) < 1e-9);
  CHECK(largest_move(part(result, first_tube, t.points.size()), part(frames[0], first_tube, t.points.size())) < 1e-9);
  CHECK((result[isolated] - Vec(4, 9, 0)).norm() < 1e-12);
  // rounding of lengths leaves a height of its square root
  CHECK(largest_move(part(result, patch, 5), part(frames[0], patch, 5)) < 1e-7);

  // the tube collapses to a point in all frames, and one triangle of the sphere in one of them
  for (Points& points : frames) std::fill_n(points.begin() + std::ptrdiff_t(first_tube), t.points.size(), Vec(1, 2, 3));
  frames[4][s.faces[7][1]] = frames[4][s.faces[7][2]] = frames[4][s.faces[7][0]];
  const Points collapsed = canonical(mesh_of(s), frames);
  for (const Vec& p : collapsed) CHECK(p.allFinite());
  for (std::size_t i = first_tube; i < isolated; ++i) CHECK((collapsed[i] - Vec(1, 2, 3)).norm() < 1e-9);
  CHECK(difference(part(collapsed, 0, n_sphere), part(s.points, 0, n_sphere)) < 0.15); // one frame of nine
}

void test_pulsating_sphere()
{
  const Shape s = sphere(3);
  std::vector<Points> frames;
  double mean = 0;
  const int n = 7;
  for (int f = 0; f < n; ++f) {
    const double radius = 2 + std::sin(1.3 * f + 1);
    mean += radius / n;
    frames.push_back(mapped(s.points, [&](const Vec& p) {
      return Vec(Eigen::AngleAxisd(0.9 * f, Vec(1, 1, 0).normalized()) * (radius * p) + Vec(10, 0, 0));
    }));
  }
  const Points result = canonical(mesh_of(s), frames);
  // turned as the first frame, which is not the one closest to the mean
  const double ratio = mean / (frames[0][0] - Vec(10, 0, 0)).norm();
  CHECK(ratio < 0.8);
  for (std::size_t i = 0; i < result.size(); ++i)
    CHECK((result[i] - Vec(10, 0, 0) - ratio * (frames[0][i] - Vec(10, 0, 0))).norm() < 1e-9);
  CHECK_NEAR(volume(result, s.faces), std::pow(mean, 3) * volume(s.points, s.faces), 1e-7);
}

// Relative to the mean length of each edge.
double rms_of_lengths(const Points& points, const Mesh& mesh, const std::vector<Points>& frames)
{
  double sum = 0;
  for (Mesh::Edge_index e : mesh.edges()) {
    const std::size_t i = std::size_t(mesh.vertex(e, 0)), j = std::size_t(mesh.vertex(e, 1));
    double mean = 0;
    for (const Points& p : frames) mean += (p[i] - p[j]).norm() / double(frames.size());
    sum += std::pow((points[i] - points[j]).norm() / mean - 1, 2);
  }
  return std::sqrt(sum / double(mesh.number_of_edges()));
}

void test_generic_deformation()
{
  const double length = 8;
  const Shape s = tube(20, 25, length);
  std::vector<Points> frames;
  const int n = 16;
  for (int f = 0; f < n; ++f) {
    const double t = 2 * pi * f / n;
    frames.push_back(mapped(s.points, [&](const Vec& p) {
      const double bulge = 1 + 0.3 * std::sin(t + p[2]);
      const Eigen::AngleAxisd twist(0.2 * p[2] * std::cos(t), Vec::UnitZ());
      const Vec q =
          bent(twist * Vec(bulge * p[0], bulge * p[1], p[2] * (1 + 0.1 * std::cos(2 * t))), 0.25 * (0.4 + std::sin(t)));
      return Vec(Eigen::AngleAxisd(t, Vec(1, 0, 1).normalized()) * q);
    }));
  }
  const Mesh mesh = mesh_of(s);
  const Points result = canonical(mesh, frames);
  const double rms = rms_of_lengths(result, mesh, frames);
  double closest_frame = 1;
  for (const Points& points : frames) closest_frame = (std::min)(closest_frame, rms_of_lengths(points, mesh, frames));
  const double mean = rms_of_lengths(plain_mean(frames), mesh, frames);
  CHECK(rms < 0.003);
  CHECK(rms < closest_frame / 4);
  CHECK(mean > 0.3);
  CHECK(volume(result, s.faces) > 0);
  std::cout << "generic deformation: RMS of lengths " << rms << ", closest frame " << closest_frame << ", plain mean "
            << mean << std::endl;

  // The same bits again, in another order of faces, and whatever the rest shape is.
  const Points other = canonical(mesh_of(s, true), frames);
  Amf::Frame_sequence<Mesh> sequence(mesh, frames_of(frames), 1. / 30);
  sequence.set_rest_frame(5);
  Amf::set_canonical_rest_shape(sequence);
  bool same = true;
  for (std::size_t i = 0; i < result.size(); ++i)
    same = same && result[i] == other[i] && result[i] == sequence.rest_shape().points()[i];
  CHECK(same);
  CHECK(difference(canonical<float>(mesh, frames), result) < 1e-3 * length);
}

// Tells how far it was, in order.
struct Fractions
{
  std::vector<double> told;
  void begin(Amf::Stage) {}
  bool progress(Amf::Stage, double fraction)
  {
    told.push_back(fraction);
    return true;
  }
  void end(Amf::Stage) {}
};

// The same bits by one thread and by all, in another order of faces, with a component that many threads work on and
// others that one does; and the way there is told from 0 to 1.
void test_threads()
{
  Shape s = tube(40, 40, 10);
  const int n = int(s.points.size());
  CHECK(s.faces.size() > 2000);
  for (int i = 1; i < 4; ++i) {
    const Shape ball = sphere(1);
    const int first = int(s.points.size());
    for (const Vec& p : ball.points) s.points.push_back(p + Vec(5 * i, 0, 0));
    for (const auto& f : ball.faces) s.faces.push_back({{f[0] + first, f[1] + first, f[2] + first}});
  }
  std::vector<Points> frames;
  for (int f = 0; f < 5; ++f)
    frames.push_back(mapped(s.points, [f](const Vec& p) { return bent(Vec(p[0], p[1] * (1 + 0.1 * f), p[2]), 0.05 * f); }));
  const Mesh mesh = mesh_of(s);
  const Amf::Frame_sequence<Mesh> sequence(mesh, frames_of(frames), 1. / 30);
  Fractions fractions;
  const Points all = Amf::canonical_shape<CGAL::Parallel_if_available_tag>(sequence.rest_shape(), sequence.trajectories(),
                                                                           fractions);
  const Points one = Amf::canonical_shape<CGAL::Sequential_tag>(sequence.rest_shape(), sequence.trajectories());
  CHECK(all == one);
  CHECK(all == canonical(mesh_of(s, true), frames));
  CHECK(std::is_sorted(fractions.told.begin(), fractions.told.end()));
  CHECK(fractions.told.size() > 10 && fractions.told.front() == 0 && fractions.told.back() == 1);
  // what else there is makes no difference to a component, but for the rounding of its order of elimination
  const Shape alone = {part(s.points, 0, std::size_t(n)), tube(40, 40, 10).faces};
  std::vector<Points> frames_alone;
  for (const Points& f : frames) frames_alone.push_back(part(f, 0, std::size_t(n)));
  CHECK(largest_move(canonical(mesh_of(alone), frames_alone), part(all, 0, std::size_t(n))) < 1e-9);
}

void test_hinge()
{
  // Bent by 90 degrees to one side, then to the other: the unit vectors of the angles cancel, the middle is flat.
  const Shape flat = {{Vec(0, 0, 0), Vec(0, 1, 0), Vec(-1, 0.5, 0), Vec(1, 0.5, 0)}, {{{0, 1, 2}}, {{1, 0, 3}}}};
  std::vector<Points> frames;
  for (int f = 0; f < 4; ++f) {
    frames.push_back(flat.points);
    frames.back()[3] = Vec(0, 0.5, f % 2 == 0 ? 1 : -1);
  }
  CHECK(difference(canonical(mesh_of(flat), frames), flat.points) < 1e-9);
  // 30 and 80 degrees: 55
  for (int f = 0; f < 4; ++f) {
    const double angle = (f % 2 == 0 ? 30 : 80) * pi / 180;
    frames[f][3] = Vec(std::cos(angle), 0.5, std::sin(angle));
  }
  const Points result = canonical(mesh_of(flat), frames);
  CHECK_NEAR((result[3] - result[2]).norm(), 2 * std::cos(55 * pi / 360), 1e-9);
}

void test_overflow()
{
  const Shape s = sphere(1);
  const std::vector<Points> frames(3, mapped(s.points, [](const Vec& p) { return Vec(1e200 * p); }));
  CHECK_THROWS(Amf::Numerical_error, canonical(mesh_of(s), frames), "canonical shape");
}

// Goes on as often as it is told.
struct Impatient
{
  int patience;
  int calls = 0;
  void begin(Amf::Stage) {}
  bool progress(Amf::Stage stage, double)
  {
    CHECK(stage == Amf::Stage::REST_SHAPE);
    return ++calls <= patience;
  }
  void end(Amf::Stage) {}
};

// In the middle, too: a visitor is asked every tenth of a second.
void test_cancelled()
{
  const Shape s = tube(100, 150, 10);
  const std::vector<Points> frames(3, s.points);
  const Amf::Frame_sequence<Mesh> sequence(mesh_of(s), frames_of(frames), 1. / 30);
  for (int patience : {0, 1}) {
    Impatient visitor{patience};
    CHECK_THROWS(Amf::Cancelled, Amf::canonical_shape(sequence.rest_shape(), sequence.trajectories(), visitor), "");
    CHECK(visitor.calls == patience + 1);
  }
  // a task that would not end
  Impatient visitor{3};
  const Amf::Task_loop<CGAL::Parallel_if_available_tag, Impatient> loop(visitor, Amf::Stage::REST_SHAPE);
  CHECK_THROWS(Amf::Cancelled,
               loop(2,
                    [](std::size_t) {
                      while (true) Amf::internal::cancellation_point();
                    }),
               "");
  CHECK(visitor.calls == 4);
  Amf::internal::cancellation_point(); // where nobody can be asked, nothing happens
}

int main()
{
  test_turning_tube();
  test_bending_tube();
  test_parts();
  test_pulsating_sphere();
  test_generic_deformation();
  test_threads();
  test_hinge();
  test_overflow();
  test_cancelled();
  return test_support::test_result();
}
