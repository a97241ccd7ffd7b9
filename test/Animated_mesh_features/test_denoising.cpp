// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Noise of positions: that it is measured as large as it is, and taken out without what is no noise.

#include "test_bumpy_sphere.h"
#include "test_support.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/denoised_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/position_noise.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using test_support::Bumpy_sphere;
using test_support::Point_3;

typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef Amf::Vertex_trajectories<double> Trajectories;
typedef std::vector<std::vector<Point_3>> Frames;

Frames with_noise(Frames frames, double deviation)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0, deviation);
  for (auto& frame : frames)
    for (Point_3& p : frame) {
      const double x = normal(generator), y = normal(generator), z = normal(generator);
      p = Point_3(p.x() + x, p.y() + y, p.z() + z);
    }
  return frames;
}

struct Sphere
{
  Bumpy_sphere sphere;
  Mesh mesh;

  Sphere(int subdivisions, std::size_t frames)
    : sphere(subdivisions, frames)
  {
    test_support::add_sphere(sphere, mesh);
  }

  Amf::Frame_sequence<Mesh> sequence(const Frames& frames) const
  {
    Amf::Frame_sequence<Mesh> result(mesh, frames, sphere.frame_duration);
    result.set_rest_shape(sphere.rest, Amf::Rest_unit::KEEP);
    return result;
  }
};

// root mean square of the distances
double difference(const Trajectories& a, const Trajectories& b)
{
  double sum = 0;
  for (std::size_t v = 0; v < a.number_of_vertices(); ++v)
    for (std::size_t f = 0; f < a.number_of_frames(); ++f) sum += (a.point(v, f) - b.point(v, f)).squaredNorm();
  return std::sqrt(sum / double(a.number_of_vertices() * a.number_of_frames()));
}

void test_noise_is_measured()
{
  const Sphere s(4, 24);
  const auto measured = [&](double deviation) {
    const auto sequence = s.sequence(with_noise(s.sphere.frames, deviation));
    return Amf::position_noise(sequence.rest_shape(), sequence.trajectories());
  };
  const double edge = s.sequence(s.sphere.frames).rest_shape().mean_edge_length();
  CHECK(measured(0) < 0.01 * edge);
  for (const double share : {0.05, 0.2, 1.}) CHECK_NEAR(measured(share * edge) / (share * edge), 1., 0.03);
  const auto of_few = [&](std::size_t edges, std::size_t frames) {
    const Frames noisy = with_noise(s.sphere.frames, edge);
    return Amf::position_noise(std::vector<std::array<std::size_t, 2>>(edges, {{0, 1}}), frames,
                               [&](std::size_t v, std::size_t f) {
                                 return Eigen::Vector3d(noisy[f][v].x(), noisy[f][v].y(), noisy[f][v].z());
                               });
  };
  CHECK(of_few(12, 3) > 0 && of_few(11, 3) == 0 && of_few(12, 2) == 0);

  // A body that turns by 30 degrees from frame to frame: its edges turn, the mean of a ring stays near its vertex.
  Frames turning;
  for (std::size_t f = 0; f < 24; ++f) {
    const double c = std::cos(0.52 * double(f)), d = std::sin(0.52 * double(f));
    std::vector<Point_3> frame;
    for (const Point_3& p : s.sphere.rest) frame.emplace_back(c * p.x() - d * p.y(), d * p.x() + c * p.y(), p.z());
    turning.push_back(frame);
  }
  const auto sequence = s.sequence(turning);
  std::vector<std::array<std::size_t, 2>> edges;
  for (const auto& e : sequence.rest_shape().edges()) edges.push_back({{e.source, e.target}});
  const auto& positions = sequence.trajectories();
  const double by_edges =
      Amf::position_noise(edges, 24, [&](std::size_t v, std::size_t f) { return positions.point(v, f); });
  CHECK(by_edges > 0.03 * edge);
  CHECK(Amf::position_noise(sequence.rest_shape(), positions) < 0.2 * by_edges);
}

// What moves as an affine image of the reference shape stays where it is, wherever that is.
void test_affine_images_stay()
{
  const Sphere s(3, 3);
  Frames frames;
  for (int f = 0; f < 5; ++f) {
    Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
    map(0, 1) = 0.3 * f;
    map(2, 0) = -0.2 * f;
    map(1, 1) = 1 + 0.1 * f;
    std::vector<Point_3> frame;
    for (const Point_3& p : s.sphere.rest) {
      const Eigen::Vector3d q = map * Eigen::Vector3d(p.x(), p.y(), p.z()) + Eigen::Vector3d(100., f, -50.);
      frame.emplace_back(q[0], q[1], q[2]);
    }
    frames.push_back(frame);
  }
  const auto sequence = s.sequence(frames);
  for (const double share : {0.1, 0.3, 1.})
    CHECK(difference(Amf::denoised_trajectories(sequence.rest_shape(), sequence.trajectories(),
                                                share * sequence.rest_shape().mean_edge_length()),
                     sequence.trajectories()) < 1e-7);
}

// One vertex by the definition: the weighted least-squares fit of an affine map, solved densely, with distances along edges
// by relaxation over all of them.
void test_against_dense_fit()
{
  const Sphere s(2, 4);
  const auto sequence = s.sequence(with_noise(s.sphere.frames, 0.05));
  const Amf::Rest_shape& shape = sequence.rest_shape();
  const double noise = 0.04;
  const Trajectories clean = Amf::denoised_trajectories(shape, sequence.trajectories(), noise);
  for (const std::size_t v : {std::size_t(0), std::size_t(77)}) {
    std::vector<double> distance(shape.number_of_vertices(), 1e300);
    distance[v] = 0;
    for (std::size_t round = 0; round < shape.number_of_vertices(); ++round)
      for (std::size_t e = 0; e < shape.edges().size(); ++e) {
        double& a = distance[shape.edges()[e].source];
        double& b = distance[shape.edges()[e].target];
        a = (std::min)(a, b + shape.lengths()[e]);
        b = (std::min)(b, a + shape.lengths()[e]);
      }
    double length = 0;
    for (const auto w : shape.neighbours()[v]) length += (shape.points()[w] - shape.points()[v]).norm();
    const double sigma = 3 * std::sqrt(noise * length / double(shape.neighbours()[v].size()));
    std::vector<std::size_t> near;
    for (std::size_t w = 0; w < distance.size(); ++w)
      if (distance[w] <= 2.5 * sigma) near.push_back(w);
    CHECK(near.size() > 10 && near.size() < shape.number_of_vertices());
    for (std::size_t f = 0; f < 4; ++f) {
      Eigen::MatrixXd a(near.size(), 4), b(near.size(), 3);
      for (std::size_t i = 0; i < near.size(); ++i) {
        const double root = std::exp(-std::pow(distance[near[i]] / sigma, 2) / 4);
        const Eigen::Vector3d x = shape.points()[near[i]] - shape.points()[v];
        a.row(Eigen::Index(i)) << root, root * x[0], root * x[1], root * x[2];
        b.row(Eigen::Index(i)) = root * sequence.trajectories().point(near[i], f).transpose();
      }
      const Eigen::MatrixXd fit = a.colPivHouseholderQr().solve(b);
      CHECK((clean.point(v, f) - Eigen::Vector3d(fit.row(0))).norm() < 1e-6);
    }
  }
}

// Edges, by which strain is measured, gain more than positions: their noise is alike at both ends.
double edge_error(const Trajectories& a, const Trajectories& truth, const Amf::Rest_shape& shape)
{
  double sum = 0;
  for (const Amf::Rest_shape::Edge& e : shape.edges())
    for (std::size_t f = 0; f < a.number_of_frames(); ++f)
      sum += std::pow((a.point(e.source, f) - a.point(e.target, f)).norm() -
                        (truth.point(e.source, f) - truth.point(e.target, f)).norm(), 2);
  return std::sqrt(sum / double(shape.edges().size() * a.number_of_frames()));
}

// The larger the noise the farther the weights reach: what is left of it strains edges by the same, 6 % of these.
void test_noise_is_taken_out()
{
  const Sphere s(4, 24);
  const auto truth = s.sequence(s.sphere.frames);
  const Amf::Rest_shape& shape = truth.rest_shape();
  for (const double share : {0.15, 0.3, 0.6}) {
    const double noise = share * shape.mean_edge_length();
    const auto noisy = s.sequence(with_noise(s.sphere.frames, noise));
    const Trajectories clean = Amf::denoised_trajectories(shape, noisy.trajectories(), noise);
    CHECK(difference(clean, truth.trajectories()) < 0.5 * difference(noisy.trajectories(), truth.trajectories()));
    CHECK_NEAR(edge_error(clean, truth.trajectories(), shape) / shape.mean_edge_length(), 0.063, 0.006);
    // the same bits by one thread
    const Trajectories one = Amf::denoised_trajectories<CGAL::Sequential_tag>(shape, noisy.trajectories(), noise);
    CHECK(difference(one, clean) == 0);
    CHECK(difference(Amf::denoised_trajectories(shape, noisy.trajectories(), 0), noisy.trajectories()) == 0);
  }
}

struct Impatient
{
  void begin(Amf::Stage stage) { CHECK(stage == Amf::Stage::DENOISING); }
  bool progress(Amf::Stage, double fraction) { return fraction < 0.5; }
  void end(Amf::Stage) {}
};

void test_cancelled()
{
  const Sphere s(3, 6);
  const auto sequence = s.sequence(s.sphere.frames);
  Impatient visitor;
  CHECK_THROWS(Amf::Cancelled,
               Amf::denoised_trajectories(sequence.rest_shape(), sequence.trajectories(), 0.01, visitor), "");
}

int main()
{
  test_noise_is_measured();
  test_affine_images_stay();
  test_against_dense_fit();
  test_noise_is_taken_out();
  test_cancelled();
  return test_support::test_result();
}
