// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What must not change the features: how the body lies in space, its unit, the numbering of its vertices, the
// orientation of its triangles, when the motion begins, how finely it is sampled. And where they are: at the joints of
// the bending cylinder, when these bend.

#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "../../examples/Animated_mesh_features/generators/bending_cylinder.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
namespace Generators = Animated_mesh_generators;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Amf::Frame_sequence<Mesh> Sequence;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

namespace {

struct Animation
{
  Mesh mesh;
  std::vector<std::vector<Point>> frames;
  double frame_duration;
};

template <class Options>
std::vector<Feature> detect(const Animation& a, const Options& options)
{
  const Sequence sequence(a.mesh, a.frames, a.frame_duration);
  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(sequence, std::back_inserter(features), options);
  return features;
}

// What features should have become; NaN: not compared.
struct Expected
{
  double length = 1;     // factor of sigma
  double time_shift = 0; // seconds
  std::function<std::size_t(std::size_t)> vertex = [](std::size_t v) { return v; };
};

// Equal up to rounding. The order of features of equal strength - the cylinder is symmetric - is free, hence the
// matching.
void compare(const std::string& name, const std::vector<Feature>& before, const std::vector<Feature>& after,
             const Expected& expected, double tolerance)
{
  std::size_t matched = 0;
  for (const Feature& f : before)
    matched += std::any_of(after.begin(), after.end(), [&](const Feature& g) {
      return g.vertex_index == expected.vertex(f.vertex_index) &&
             std::abs(g.time - f.time - expected.time_shift) <= tolerance * f.tau &&
             std::abs(g.sigma / (f.sigma * expected.length) - 1) <= tolerance &&
             std::abs(g.tau / f.tau - 1) <= tolerance && std::abs(g.strength / f.strength - 1) <= tolerance;
    });
  std::cout << name << ": " << before.size() << " features, " << after.size() << " after, " << matched << " equal"
            << std::endl;
  CHECK(!before.empty());
  CHECK(before.size() == after.size());
  CHECK(matched == before.size());
}

Animation cylinder(std::size_t around, double frame_rate)
{
  Generators::Bending_cylinder_options options;
  options.vertices_around = around;
  options.frame_rate = frame_rate;
  options.number_of_frames = std::size_t(std::lround(2 * frame_rate));
  const Generators::Generated_animation g = Generators::bending_cylinder(options);
  return {g.mesh, g.frames, g.frame_duration};
}

// The cylinder is symmetric about the plane in which it bends, and periodic around: strengths tie up to rounding. A
// dent that turns with the frames would be no longer the same motion; a shear of the rest shape is.
Animation without_symmetry(Animation a)
{
  const auto shear = [](const Point& p) {
    return Point(p.x() + 0.11 * p.y() + 0.013 * p.z(), p.y() + 0.07 * p.z() + 0.02 * p.x(), p.z() + 0.05 * p.y());
  };
  for (auto& frame : a.frames)
    for (Point& p : frame) p = shear(p);
  for (Mesh::Vertex_index v : a.mesh.vertices()) a.mesh.point(v) = shear(a.mesh.point(v));
  return a;
}

Animation transformed(Animation a, const CGAL::Aff_transformation_3<Kernel>& t)
{
  for (auto& frame : a.frames)
    for (Point& p : frame) p = t(p);
  return a;
}

template <class Options>
void check_invariances(const std::string& name, const Animation& a, const Options& options, double tolerance,
                       double renumbering_tolerance)
{
  const std::vector<Feature> features = detect(a, options);

  // A rotation by an orthogonal matrix of rational numbers, and a shift.
  const CGAL::Aff_transformation_3<Kernel> rigid(2. / 3, -1. / 3, 2. / 3, 3, 2. / 3, 2. / 3, -1. / 3, -2, -1. / 3,
                                                 2. / 3, 2. / 3, 1);
  compare(name + ", rigid motion", features, detect(transformed(a, rigid), options), Expected(), tolerance);

  Expected scaled;
  scaled.length = 1000;
  compare(name + ", metres to millimetres", features,
          detect(transformed(a, CGAL::Aff_transformation_3<Kernel>(CGAL::SCALING, 1000)), options), scaled, tolerance);

  std::vector<std::size_t> new_number(a.mesh.number_of_vertices());
  std::iota(new_number.begin(), new_number.end(), 0);
  std::shuffle(new_number.begin(), new_number.end(), std::mt19937(3));
  Animation renumbered = {Mesh(), a.frames, a.frame_duration};
  for (std::size_t i = 0; i < new_number.size(); ++i) renumbered.mesh.add_vertex(Point(0, 0, 0));
  for (Mesh::Vertex_index v : a.mesh.vertices())
    for (std::size_t f = 0; f < a.frames.size(); ++f) renumbered.frames[f][new_number[v]] = a.frames[f][v];
  Animation reversed = {Mesh(), a.frames, a.frame_duration};
  for (std::size_t i = 0; i < new_number.size(); ++i) reversed.mesh.add_vertex(Point(0, 0, 0));
  for (Mesh::Face_index f : a.mesh.faces()) {
    std::vector<Mesh::Vertex_index> c, r;
    for (Mesh::Vertex_index v : a.mesh.vertices_around_face(a.mesh.halfedge(f))) {
      c.push_back(Mesh::Vertex_index(Mesh::size_type(new_number[v])));
      r.insert(r.begin(), v);
    }
    renumbered.mesh.add_face(c);
    reversed.mesh.add_face(r);
  }
  Expected numbers;
  numbers.vertex = [&](std::size_t v) { return new_number[v]; };
  compare(name + ", renumbered vertices", features, detect(renumbered, options), numbers,
          renumbering_tolerance);
  compare(name + ", reversed winding", features, detect(reversed, options), Expected(), tolerance);
}

} // namespace

int main()
{
  const Animation symmetric = cylinder(16, 30);
  const Animation a = without_symmetry(symmetric);
  std::cout << a.mesh.number_of_vertices() << " vertices, " << a.frames.size() << " frames" << std::endl;
  auto options = Amf::calibrated_options();
  options.selection.relative_threshold = 0.1;
  options.selection.absolute_threshold = 0;
  // clusters of the heat method's sources depend on the numbering, see Heat_method_geodesic_balls
  check_invariances("calibrated", a, options, 1e-6, 5e-3);
  check_invariances("Dijkstra balls", a, options.with_balls(Amf::Dijkstra_geodesic_balls()), 1e-6, 1e-6);

  auto published = Amf::published_options(6).with_balls(Amf::Dijkstra_geodesic_balls());
  published.sampling.max_space_count = 12;
  published.sampling.max_time_count = 12;
  check_invariances("published", a, published, 1e-6, 1e-6);

  // A body that turns and travels without deforming has no features, however low the threshold.
  Animation rigid = {a.mesh, {}, a.frame_duration};
  for (std::size_t f = 0; f < 20; ++f) {
    const double angle = 0.3 * double(f), c = std::cos(angle), s = std::sin(angle);
    rigid.frames.push_back(a.frames.front());
    for (Point& p : rigid.frames.back())
      p = Point(c * p.x() - s * p.y() + 0.1 * double(f), s * p.x() + c * p.y(), p.z() - 3);
  }
  auto everything = Amf::calibrated_options();
  everything.selection.absolute_threshold = 0;
  everything.selection.min_fit = 0;
  CHECK(detect(rigid, everything).empty());

  // The motion begins and ends at rest: more rest before and less behind it only shifts the features.
  Animation later = a;
  const std::size_t delay = 4;
  later.frames.insert(later.frames.begin(), delay, a.frames.front());
  later.frames.resize(a.frames.size());
  Expected shifted;
  shifted.time_shift = double(delay) * a.frame_duration;
  compare("later by 4 frames", detect(a, options), detect(later, options), shifted, 3e-3);

  // At the joints, when they bend, on the inner and outer side. The truth is that of the generator.
  const Generators::Bending_cylinder_options truth;
  for (const Animation& resolution : {cylinder(20, 30), cylinder(28, 60)}) {
    auto scales = Amf::calibrated_options();
    scales.sampling.tau = {1. / 30, 2. / 6};
    const std::vector<Feature> found = detect(resolution, scales);
    for (const Generators::Cylinder_bend& joint : truth.bends) {
      const auto at_joint = [&](const Feature& f) {
        return std::abs(f.rest_position[2] - joint.axial_position) <= joint.axial_deviation() &&
               std::abs(f.time - joint.centre_time) <= joint.temporal_deviation();
      };
      const auto strongest = std::find_if(found.begin(), found.end(), at_joint);
      CHECK(strongest != found.end());
      if (strongest == found.end()) continue;
      std::cout << "joint at " << joint.axial_position << ", " << joint.centre_time << " s: found at "
                << strongest->rest_position[2] << ", " << strongest->time << " s, sigma " << strongest->sigma
                << ", tau " << strongest->tau << " (bend " << joint.temporal_deviation() << ")" << std::endl;
      // strain is even in the angle and grows with it: the event is as long as the bend
      CHECK_NEAR(std::log(strongest->tau / joint.temporal_deviation()), 0, std::log(1.5));
    }
    // and nowhere else: the strongest ten
    for (std::size_t i = 0; i < (std::min)(found.size(), std::size_t(10)); ++i)
      CHECK(std::any_of(truth.bends.begin(), truth.bends.end(), [&](const Generators::Cylinder_bend& joint) {
        return std::abs(found[i].rest_position[2] - joint.axial_position) <= joint.region_length / 2 &&
               std::abs(found[i].time - joint.centre_time) <= joint.duration / 2;
      }));
  }
  return test_support::test_result();
}
