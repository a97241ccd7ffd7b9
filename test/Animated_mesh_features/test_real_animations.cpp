// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole way on scanned and simulated animals, from files to features. Skipped where there are no such animations.

#include <CGAL/Animated_mesh_features/Applications/probable_up_axis.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#ifndef ANIMATED_MESH_FEATURES_TEST_DATA
  #define ANIMATED_MESH_FEATURES_TEST_DATA ""
#endif

namespace Amf = CGAL::Animated_mesh_features;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Amf::Frame_sequence<Mesh> Sequence;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

namespace {

const std::string folder = std::string(ANIMATED_MESH_FEATURES_TEST_DATA) + "/";

struct Animation
{
  std::unique_ptr<Mesh> mesh; // where the sequence finds it, also when this is moved
  std::unique_ptr<Sequence> sequence;
};

std::vector<Point> points_of(const std::string& file)
{
  std::vector<Point> points;
  for (const auto& p : Amf::IO::read_mesh(folder + file).points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Animation read(const std::string& name, double fps, const std::string& rest)
{
  auto data = Amf::IO::read_animation<double>({folder + name + ".obj", folder + name + ".pc2"});
  Animation a;
  a.mesh = std::make_unique<Mesh>(Amf::IO::to_surface_mesh(data.mesh, name));
  a.sequence = std::make_unique<Sequence>(*a.mesh, std::move(data.x), std::move(data.y), std::move(data.z), 1 / fps);
  if (!rest.empty()) a.sequence->set_rest_shape(points_of(rest));
  return a;
}

std::vector<Feature> detect(const Animation& a, Amf::Scale_range tau, double threshold)
{
  auto options = Amf::calibrated_options();
  options.sampling.tau = tau;
  options.selection.absolute_threshold = threshold;
  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(*a.sequence, std::back_inserter(features), options);
  return features;
}

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
}

// The share of the strongest 50 features of a that b has among its strongest 150: at the same place on the common rest
// shape, at the same time, and, for the second number, at scales within a factor of 1.5.
std::pair<double, double> repeated(const std::vector<Feature>& a, const std::vector<Feature>& b, double place,
                                   double time)
{
  const std::size_t top = (std::min)(a.size(), std::size_t(50)), among = (std::min)(b.size(), std::size_t(150));
  const auto alike = [](double x, double y) { return x <= 1.5 * y && y <= 1.5 * x; };
  double there = 0, with_scales = 0;
  for (std::size_t i = 0; i < top; ++i) {
    bool found = false, also = false;
    for (std::size_t j = 0; j < among; ++j)
      if (distance(a[i].rest_position, b[j].rest_position) <= place && std::abs(a[i].time - b[j].time) <= time) {
        found = true;
        also = also || (alike(a[i].sigma, b[j].sigma) && alike(a[i].tau, b[j].tau));
      }
    there += found;
    with_scales += also;
  }
  return {there / double(top), with_scales / double(top)};
}

void compare(const std::string& name, const std::vector<Feature>& a, const std::vector<Feature>& b, double place,
             double time, double least, double least_with_scales)
{
  const auto ab = repeated(a, b, place, time), ba = repeated(b, a, place, time);
  std::cout << name << ": " << a.size() << " and " << b.size() << " features, repeated " << ab.first << " / "
            << ba.first << ", with scales " << ab.second << " / " << ba.second << std::endl;
  CHECK((std::min)(ab.first, ba.first) >= least);
  CHECK((std::min)(ab.second, ba.second) >= least_with_scales);
}

// All of these bodies are upright along y; turned, along z.
void check_upright(const std::filesystem::path& file)
{
  auto mesh = Amf::IO::read_mesh(file.string());
  for (int up : {1, 2}) {
    const Mesh surface = Amf::IO::to_surface_mesh(mesh, file.string());
    std::vector<Amf::Rest_shape::Point> points;
    for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
    Amf::Rest_shape shape(surface, get(boost::vertex_index, surface), points.size());
    shape.set_points(std::move(points));
    if (Amf::probable_up_axis(shape) != up) std::cout << file << " does not stand along axis " << up << std::endl;
    CHECK(Amf::probable_up_axis(shape) == up);
    for (auto& p : mesh.points) p = {{p[2], p[0], p[1]}};
  }
}

} // namespace

int main()
{
  if (!std::filesystem::exists(folder + "horse-gallop.pc2") || !std::filesystem::exists(folder + "pcow.pc2")) {
    std::cout << "SKIPPED: no animations in \"" << folder << "\" (ANIMATED_MESH_FEATURES_TEST_DATA)" << std::endl;
    return test_support::skipped;
  }

  for (const char* name : {"horse-rest", "horse-rest-dec4200", "horse-rest-irregular", "camel-rest-manifold", "pcow"})
    check_upright(folder + name + ".obj");
  for (const char* name : {"bodies/bodies", "actions"})
    if (std::filesystem::exists(folder + name))
      for (const auto& entry : std::filesystem::directory_iterator(folder + name))
        if (entry.path().extension() == ".obj") check_upright(entry.path());

  const Animation horse = read("horse-gallop", 30, "horse-rest.obj");
  const Amf::Animation_report report = horse.sequence->report();
  CHECK(horse.sequence->number_of_vertices() == 8431 && horse.sequence->number_of_frames() == 48);
  CHECK(report.connected_components == 1 && report.isolated_vertices == 0 && report.border_edges > 0);

  const double place = 0.03 * horse.sequence->rest_shape().bounding_box_diagonal();
  const double frame = horse.sequence->frame_duration();
  const Amf::Scale_range tau = {frame, 8 * frame};
  const std::vector<Feature> features = detect(horse, tau, 0.01);

  // The animation is one cycle of 24 frames, played twice: further than three tau from its ends features come in pairs.
  std::size_t in_first = 0, again = 0;
  for (const Feature& f : features)
    if (f.time > 3 * f.tau && f.time < 23 * frame - 3 * f.tau && f.strength > 0.2 * features.front().strength) {
      ++in_first;
      again += std::any_of(features.begin(), features.end(), [&](const Feature& g) {
        return g.vertex_index == f.vertex_index && std::abs(g.time - f.time - 24 * frame) < 0.2 * frame &&
               std::abs(g.strength / f.strength - 1) < 0.02 && std::abs(g.sigma / f.sigma - 1) < 0.02;
      });
    }
  std::cout << "cycle: " << again << " of " << in_first << " features again after 24 frames" << std::endl;
  CHECK(in_first >= 10);
  CHECK(double(again) >= 0.9 * double(in_first));

  // The same motion at half the frame rate and with half of the vertices.
  compare("half the frame rate", features, detect(read("horse-gallop-half", 15, "horse-rest.obj"), tau, 0.01), place,
          3 * frame, 0.9, 0.75);
  compare("half the vertices", features, detect(read("horse-gallop-dec4200", 30, "horse-rest-dec4200.obj"), tau, 0.01),
          place, 1.5 * frame, 0.9, 0.75);

  // The rest shape as it was published, 1.677 times smaller than the gallop.
  std::vector<Point> small = points_of("horse-rest.obj");
  for (Point& p : small) p = CGAL::ORIGIN + (p - CGAL::ORIGIN) / 1.677;
  CHECK_THROWS(Amf::Input_error, horse.sequence->set_rest_shape(small), "--rescale-rest");
  CHECK_NEAR(horse.sequence->set_rest_shape(small, Amf::Rest_unit::RESCALE), 1.677, 0.01);

  // An elastic cow under large deformations: finite, in order, in range.
  const Animation cow = read("pcow", 30, "");
  const std::vector<Feature> cow_features = detect(cow, {}, 0.2);
  std::cout << "cow: " << cow_features.size() << " features" << std::endl;
  CHECK(!cow_features.empty());
  const double duration = double(cow.sequence->number_of_frames()) / 30;
  for (std::size_t i = 0; i < cow_features.size(); ++i) {
    const Feature& f = cow_features[i];
    CHECK(std::isfinite(f.strength) && f.strength > 0 && (i == 0 || f.strength <= cow_features[i - 1].strength));
    CHECK(f.time > 0 && f.time < duration && f.sigma > 0 && std::isfinite(f.sigma) && f.tau > 0 && f.tau < duration);
    const double sum = f.barycentric_coordinates[0] + f.barycentric_coordinates[1] + f.barycentric_coordinates[2];
    CHECK_NEAR(sum, 1, 1e-12);
  }
  return test_support::test_result();
}
