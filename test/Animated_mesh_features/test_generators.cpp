// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The generators of examples and tests: sound meshes, and a motion that depends on neither resolution nor frame rate.

#include "test_support.h"

#include "generators/articulated_figure.h"
#include "generators/bending_cylinder.h"
#include "generators/figure_joints.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

using namespace Animated_mesh_generators;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Animated_mesh_features::Option_error Option_error;
typedef Generated_animation::Mesh Mesh;
typedef Generated_animation::Kernel::Point_3 Point_3;
typedef Generated_animation::Kernel::Vector_3 Vector_3;

const double pi = std::acos(-1.);

Mesh in_frame(const Generated_animation& animation, std::size_t f)
{
  Mesh mesh = animation.mesh;
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) mesh.point(v) = animation.frames[f][i++];
  return mesh;
}

// With exact predicates: the discs of a cylinder are flat, up to rounding.
bool intersects_itself(const Mesh& mesh)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Exact;
  CGAL::Surface_mesh<Exact::Point_3> exact;
  CGAL::copy_face_graph(mesh, exact);
  return PMP::does_self_intersect(exact);
}

double smallest_angle(const Mesh& mesh)
{
  double angle = 180;
  for (const auto h : halfedges(mesh))
    if (!is_border(h, mesh))
      angle = (std::min)(angle, CGAL::approximate_angle(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                                        mesh.point(target(next(h, mesh), mesh))));
  return angle;
}

double distance(const Point_3& p, const Point_3& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// The largest distance between where vertices are in two frames; infinite if one of them has a bad number.
double largest_distance(const std::vector<Point_3>& a, const std::vector<Point_3>& b)
{
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = distance(a[i], b[i]);
    if (!(d <= largest)) largest = std::isfinite(d) ? d : std::numeric_limits<double>::infinity();
  }
  return largest;
}

// Whether two meshes are the same, bit for bit.
bool same_mesh(const Mesh& a, const Mesh& b)
{
  if (num_vertices(a) != num_vertices(b) || num_halfedges(a) != num_halfedges(b)) return false;
  for (const auto v : vertices(a))
    if (a.point(v) != b.point(v)) return false;
  for (const auto h : halfedges(a))
    if (target(h, a) != target(h, b) || next(h, a) != next(h, b)) return false;
  return true;
}

// What holds for every generated animation.
void check_sound(const Generated_animation& animation, std::size_t number_of_frames, double frame_rate, int euler)
{
  const Mesh& mesh = animation.mesh;
  CHECK(!mesh.has_garbage());
  CHECK(mesh.is_valid());
  CHECK(CGAL::is_triangle_mesh(mesh));
  CHECK(int(num_vertices(mesh)) - int(num_edges(mesh)) + int(num_faces(mesh)) == euler);
  std::vector<std::size_t> component(num_faces(mesh));
  CHECK(PMP::connected_components(mesh, CGAL::make_property_map(component)) == 1);
  CHECK(std::none_of(vertices(mesh).begin(), vertices(mesh).end(), [&](auto v) { return mesh.is_isolated(v); }));

  CHECK(animation.frames.size() == number_of_frames);
  CHECK_NEAR(animation.frame_duration, 1 / frame_rate, 1e-15);
  std::size_t bad = 0;
  for (const auto& frame : animation.frames) {
    if (frame.size() != num_vertices(mesh)) ++bad;
    for (const Point_3& p : frame)
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) ++bad;
  }
  CHECK(bad == 0);
}

void test_cylinder_shape()
{
  Bending_cylinder_options o;
  o.number_of_frames = 1;
  const double exact = pi * o.radius * o.radius * o.height;
  for (const std::size_t around : {6, 20, 36, 60}) {
    o.vertices_around = around;
    o.closed = true;
    const Generated_animation closed = bending_cylinder(o);
    check_sound(closed, 1, 30, 2);
    CHECK(CGAL::is_closed(closed.mesh));
    CHECK(num_vertices(closed.mesh) == number_of_cylinder_vertices(o));
    // Staggered rows make it lose less against the cylinder than a prism with as many sides would.
    const double sides = double((around + 5) / 6 * 6);
    const double prism = 1 - std::sin(2 * pi / sides) / (2 * pi / sides);
    CHECK_NEAR(1 - PMP::volume(closed.mesh) / exact, 0.75 * prism, 0.02 * prism);
    // A flat disc comes down to 45 degrees, where the straight sides of a sextant meet the circle.
    CHECK(smallest_angle(closed.mesh) > 45);

    o.closed = false;
    const Generated_animation open = bending_cylinder(o);
    check_sound(open, 1, 30, 0);
    CHECK(num_vertices(open.mesh) == number_of_cylinder_vertices(o));
    const double lost = 1 - PMP::area(open.mesh) / (2 * pi * o.radius * o.height);
    CHECK(lost > 0 && lost < 1 - std::sin(pi / sides) / (pi / sides));
    CHECK(smallest_angle(open.mesh) > 55);
    CHECK(std::count_if(halfedges(open.mesh).begin(), halfedges(open.mesh).end(),
                        [&](auto h) { return is_border(h, open.mesh); }) == std::ptrdiff_t(2 * sides));
  }
  o.closed = true;
  for (const std::size_t n : {500, 4394, 20000}) {
    o.vertices_around = vertices_around_for(n, o);
    const double found = std::abs(double(number_of_cylinder_vertices(o)) - double(n));
    for (const int step : {-6, 6}) {
      Bending_cylinder_options other = o;
      other.vertices_around = std::size_t(int(o.vertices_around) + step);
      CHECK(std::abs(double(number_of_cylinder_vertices(other)) - double(n)) >= found);
    }
  }
}

// Against an axis that is integrated anew, by midpoints.
void test_cylinder_motion()
{
  for (const std::size_t around : {12, 36}) {
    Bending_cylinder_options o;
    o.vertices_around = around;
    const Generated_animation animation = bending_cylinder(o);
    check_sound(animation, 60, 30, 2);
    double off_axis = 0, off_plane = 0;
    for (const std::size_t f : {0, 10, 15, 20, 30, 44}) {
      const double time = double(f) / 30;
      auto angle = [&](double s) {
        double sum = 0;
        for (const Cylinder_bend& b : o.bends) {
          if (2 * std::abs(time - b.centre_time) >= b.duration) continue;
          const double x = (s - b.axial_position) / b.region_length + 0.5;
          const double portion = x <= 0 ? 0 : x >= 1 ? 1 : x * x * x * (6 * x * x - 15 * x + 10);
          sum += portion * b.angle * (1 + std::cos(2 * pi * (time - b.centre_time) / b.duration)) / 2;
        }
        return sum;
      };
      const std::size_t steps = 7000;
      const double ds = o.height / double(steps);
      std::vector<Point_3> axis(1, Point_3(0, 0, 0));
      for (std::size_t k = 0; k < steps; ++k) {
        const double a = angle((double(k) + 0.5) * ds);
        axis.push_back(axis.back() + ds * Vector_3(std::sin(a), 0, std::cos(a)));
      }
      std::size_t i = 0;
      for (const auto v : vertices(animation.mesh)) {
        const Point_3& rest = animation.mesh.point(v);
        const std::size_t k = (std::min)(steps - 1, std::size_t(rest.z() / ds));
        const Point_3 centre = axis[k] + (rest.z() / ds - double(k)) * (axis[k + 1] - axis[k]);
        const double a = angle(rest.z());
        const Vector_3 d = animation.frames[f][i++] - centre;
        off_plane = (std::max)(off_plane, std::abs(d * Vector_3(std::sin(a), 0, std::cos(a))));
        off_axis = (std::max)(
            {off_axis, std::abs(d.y() - rest.y()), std::abs(d * Vector_3(std::cos(a), 0, -std::sin(a)) - rest.x())});
      }
    }
    CHECK_NEAR(off_axis, 0, 1e-6);
    CHECK_NEAR(off_plane, 0, 1e-6);
  }

  Bending_cylinder_options o;
  const Generated_animation slow = bending_cylinder(o);
  o.frame_rate = 90;
  o.number_of_frames = 180;
  const Generated_animation fast = bending_cylinder(o);
  double difference = 0;
  for (std::size_t f = 0; f < 60; ++f)
    difference = (std::max)(difference, largest_distance(slow.frames[f], fast.frames[3 * f]));
  CHECK_NEAR(difference, 0, 1e-12);
  CHECK(largest_distance(slow.frames[15], slow.frames[0]) > 1);
  for (const std::size_t f : {15, 20, 30}) CHECK(!intersects_itself(in_frame(slow, f)));

  const Generated_animation again = bending_cylinder();
  CHECK(same_mesh(again.mesh, slow.mesh));
  CHECK(again.frames == slow.frames);
}

// Whether bends are where and when they are said to be, and the axis keeps its length.
void test_cylinder_truth()
{
  const Bending_cylinder_options o;
  const Bending_cylinder_motion motion(o.bends);
  for (const double time : {0.5, 0.8, 1.0}) {
    double length = 0;
    for (int k = 0; k < 1400; ++k) {
      const auto a = motion.section(k * 0.005, time), b = motion.section((k + 1) * 0.005, time);
      length += std::hypot(b.x - a.x, b.z - a.z);
    }
    CHECK_NEAR(length, o.height, 1e-4);
  }

  for (const Cylinder_bend& b : o.bends) {
    // The stretch of the side that is outside in the bend, sampled around it.
    const double x = b.angle > 0 ? -o.radius : o.radius, h = 1e-4;
    auto stretch = [&](double s, double t) {
      return distance(motion(Point_3(x, 0, s + h), t), motion(Point_3(x, 0, s - h), t)) / (2 * h);
    };
    double most = 0, place = 0, time = 0;
    for (int i = -45; i <= 45; ++i)
      for (int j = -45; j <= 45; ++j) {
        const double s = b.axial_position + b.region_length * i / 80., t = b.centre_time + b.duration * j / 80.;
        if (stretch(s, t) > most) {
          most = stretch(s, t);
          place = s;
          time = t;
        }
        if (std::abs(i) > 40) CHECK_NEAR(stretch(s, t), 1, 1e-9);
        if (std::abs(j) > 40) CHECK_NEAR(stretch(s, t), 1, 1e-9);
      }
    CHECK_NEAR(place, b.axial_position, 1e-12);
    CHECK_NEAR(time, b.centre_time, 1e-12);
    CHECK_NEAR(most, 1 + o.radius * b.largest_curvature(), 1e-6);

    double sum = 0, square = 0, curved = 0, curved_square = 0;
    for (int i = 0; i < 1000; ++i) {
      const double u = (i + 0.5) / 1000 - 0.5;
      sum += b.angle_at(b.centre_time + u * b.duration);
      square += u * u * b.duration * b.duration * b.angle_at(b.centre_time + u * b.duration);
      const double s = b.axial_position + u * b.region_length;
      const double slope = b.portion_at(s + h) - b.portion_at(s - h);
      curved += slope;
      curved_square += u * u * b.region_length * b.region_length * slope;
    }
    CHECK_NEAR(b.temporal_deviation(), std::sqrt(square / sum), 1e-4 * b.duration);
    CHECK_NEAR(b.axial_deviation(), std::sqrt(curved_square / curved), 1e-4 * b.region_length);
  }
}

void test_figure_default()
{
  const Generated_animation figure = articulated_figure();
  check_sound(figure, 48, 30, 2);
  CHECK(CGAL::is_closed(figure.mesh));
  CHECK_NEAR(num_vertices(figure.mesh), 9000, 450);
  CHECK(smallest_angle(figure.mesh) > 25);
  double lowest = 1;
  for (const Point_3& p : figure.mesh.points()) lowest = (std::min)(lowest, p.z());
  CHECK_NEAR(lowest, 0, 0.01);

  const double volume = PMP::volume(figure.mesh);
  CHECK(volume > 0);
  for (std::size_t f = 0; f < 48; ++f) CHECK_NEAR(PMP::volume(in_frame(figure, f)), volume, 0.01 * volume);
  // Half a period, in which everything but left and right comes back.
  for (const std::size_t f : {0, 3, 6, 9}) {
    const Mesh mesh = in_frame(figure, f);
    CHECK(!intersects_itself(mesh));
    CHECK(smallest_angle(mesh) > 4);
  }

  double period = 0, movement = 0;
  for (std::size_t f = 0; f < 24; ++f) {
    period = (std::max)(period, largest_distance(figure.frames[f], figure.frames[f + 24]));
    movement = (std::max)(movement, largest_distance(figure.frames[f], figure.frames[(f + 12) % 24]));
  }
  CHECK_NEAR(period, 0, 1e-12);
  CHECK(movement > 0.5);
}

// Angles of which the formula is short, at times between frames; regions at the knee and at the elbow.
void check_joints(const Mesh& mesh)
{
  const double pi = 3.14159265358979323846, degrees = 180 / pi, period = 0.8;
  std::vector<double> times;
  for (int i = 0; i < 48; ++i) times.push_back(i * period / 48);
  const std::vector<Animated_mesh_generators::Figure_joint> joints =
      Animated_mesh_generators::figure_joints(mesh, period, times);
  const auto joint = [&](const std::string& name) {
    return *std::find_if(joints.begin(), joints.end(), [&](const auto& j) { return j.name == name; });
  };
  const auto left_thigh = joint("left thigh"), right_thigh = joint("right thigh"), knee = joint("left shin"),
             elbow = joint("right forearm");
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double phase = 2 * pi * times[i] / period;
    CHECK_NEAR(left_thigh.angles[i], std::abs(-0.3 - 0.75 * std::cos(phase)) * degrees, 1e-9);
    CHECK_NEAR(knee.angles[i], (0.35 + 1.1 * std::pow(0.5 + 0.5 * std::cos(phase + pi / 2 + 0.3), 2)) * degrees, 1e-9);
    CHECK_NEAR(right_thigh.angles[(i + 24) % 48], left_thigh.angles[i], 1e-9); // half a period later
    // a pitch and a yaw: the cosine of half the angle is the product of theirs
    const double pitch = -0.95 + 0.35 * std::cos(phase + pi + 0.3), yaw = 0.45;
    CHECK_NEAR(std::cos(elbow.angles[i] / degrees / 2), std::cos(pitch / 2) * std::cos(yaw / 2), 1e-12);
  }
  const auto check_region = [&](const std::vector<std::size_t>& region, const Point_3& centre, double radius) {
    CHECK(region.size() > 5 && std::is_sorted(region.begin(), region.end()));
    double farthest = 0;
    for (std::size_t v : region)
      farthest =
          (std::max)(farthest, CGAL::to_double(squared_distance(mesh.point(Mesh::Vertex_index(unsigned(v))), centre)));
    CHECK(farthest < radius * radius);
  };
  // as thick as the limb, and as far as the upper bone takes part in the motion
  check_region(knee.region, Point_3(0.05, 0.155, 0.42), 0.08 + 0.11);
  check_region(elbow.region, Point_3(0.01, -0.33, 0.97), 0.05 + 0.11);
  CHECK(joint("pelvis").region.empty()); // everything hangs on it
}

void test_figure_sampling()
{
  Articulated_figure_options o;
  o.number_of_vertices = 1500;
  const Generated_animation figure = articulated_figure(o);
  check_sound(figure, 48, 30, 2);
  CHECK_NEAR(num_vertices(figure.mesh), 1500, 75);

  o.frame_rate = 60;
  o.number_of_frames = 20;
  const Generated_animation faster = articulated_figure(o);
  // The same mesh, bit for bit, in another call.
  CHECK(same_mesh(figure.mesh, faster.mesh));
  bool same_motion = true;
  for (std::size_t f = 0; f < 10; ++f) same_motion = same_motion && figure.frames[f] == faster.frames[2 * f];
  CHECK(same_motion);
  check_joints(figure.mesh);

  o.number_of_vertices = 6000;
  const Generated_animation finer = articulated_figure(o);
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Generated_animation::Kernel, Primitive>> Tree;
  for (const std::size_t f : {0, 7}) {
    const Mesh mesh = in_frame(finer, 2 * f);
    const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
    double apart = 0;
    for (const Point_3& p : figure.frames[f]) apart = (std::max)(apart, tree.squared_distance(p));
    // Edges of 0.024 on joints of radius 0.045: chords e^2 / (8 r) = 0.0016 inside the surface.
    CHECK_NEAR(std::sqrt(apart), 0, 0.004);
  }
}

void test_options()
{
  Bending_cylinder_options c;
  c.number_of_frames = 0;
  CHECK_THROWS(Option_error, bending_cylinder(c), "at least one frame");
  c = Bending_cylinder_options();
  c.frame_rate = 0;
  CHECK_THROWS(Option_error, bending_cylinder(c), "frame rate");
  c = Bending_cylinder_options();
  c.radius = -1;
  CHECK_THROWS(Option_error, bending_cylinder(c), "radius");
  c = Bending_cylinder_options();
  c.bends[0].angle = 3;
  CHECK_THROWS(Option_error, bending_cylinder(c), "too thick");
  c = Bending_cylinder_options();
  c.bends[1].axial_position = c.bends[0].axial_position; // both together, not one alone
  CHECK_THROWS(Option_error, bending_cylinder(c), "too thick");
  c = Bending_cylinder_options();
  c.bends[0].duration = 0;
  CHECK_THROWS(Option_error, bending_cylinder(c), "duration");

  Articulated_figure_options o;
  o.number_of_vertices = 999;
  CHECK_THROWS(Option_error, articulated_figure(o), "1000");
  o = Articulated_figure_options();
  o.frame_rate = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS(Option_error, articulated_figure(o), "frame rate");
  o = Articulated_figure_options();
  o.period = -1;
  CHECK_THROWS(Option_error, articulated_figure(o), "period");
}

int main()
{
  test_cylinder_shape();
  test_cylinder_motion();
  test_cylinder_truth();
  test_figure_default();
  test_figure_sampling();
  test_options();
  return test_support::test_result();
}
