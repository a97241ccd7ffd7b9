// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Strain and curvature, against what CGAL and Eigen have for one triangle or edge in one frame; both compute the same,
// which is checked.

#include "animations.h"
#include "benchmark_support.h"

#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/geodesic_balls.h>

#include <CGAL/Kernel/global_functions_3.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace Benchmark;

namespace {

typedef Amf::Rest_shape Rest_shape;
typedef Amf::Frame_sequence<Mesh, double> Sequence;
typedef Amf::Frame_sequence<Mesh, float> Float_sequence;
typedef Amf::Spatio_temporal_field<double> Field;

// What does nothing for a ball: rows that hold the centre only.
Amf::Compressed_rows single_vertices(std::size_t n)
{
  Amf::Compressed_rows rows;
  for (std::size_t i = 0; i < n; ++i) {
    const Rest_shape::Index v = Rest_shape::Index(i);
    rows.push_back(&v, &v + 1);
  }
  return rows;
}

Eigen::Vector3d to_eigen(const Point_3& p)
{
  return Eigen::Vector3d(p.x(), p.y(), p.z());
}

// The edges of a triangle and its unit normal.
Eigen::Matrix3d edges_and_normal(const Point_3& p, const Point_3& q, const Point_3& r)
{
  Eigen::Matrix3d m;
  m.col(0) = to_eigen(q) - to_eigen(p);
  m.col(1) = to_eigen(r) - to_eigen(p);
  m.col(2) = m.col(0).cross(m.col(1)).normalized();
  return m;
}

// The largest eigenvalue of F^T F, where F maps a triangle at rest and its unit normal to those of the frame.
template <bool direct>
void naive_strain(const Workload& w, const Rest_shape& shape, Field& strain)
{
  std::vector<Eigen::Matrix3d> inverse;
  for (const Rest_shape::Triangle& t : shape.triangles()) {
    const auto point = [&](int i) {
      const Rest_shape::Point& p = shape.points()[t[std::size_t(i)]];
      return Point_3(p[0], p[1], p[2]);
    };
    inverse.push_back(edges_and_normal(point(0), point(1), point(2)).inverse());
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  for (std::size_t f = 0; f < w.animation.frames.size(); ++f) {
    const std::vector<Point_3>& points = w.animation.frames[f];
    for (std::size_t t = 0; t < shape.triangles().size(); ++t) {
      if (!(shape.areas()[t] > 0)) continue;
      const Rest_shape::Triangle& c = shape.triangles()[t];
      const Eigen::Matrix3d gradient = edges_and_normal(points[c[0]], points[c[1]], points[c[2]]) * inverse[t];
      const Eigen::Matrix3d tensor = gradient.transpose() * gradient;
      if (direct)
        solver.computeDirect(tensor, Eigen::EigenvaluesOnly);
      else
        solver.compute(tensor, Eigen::EigenvaluesOnly);
      strain(t, f) = solver.eigenvalues()[2];
    }
  }
}

// The signed dihedral angle at an edge, positive where convex: CGAL's is between the two triangles, in degrees.
double naive_angle(const std::vector<Point_3>& points, const Rest_shape::Edge& e)
{
  const double between =
      CGAL::approximate_dihedral_angle(points[e.source], points[e.target], points[e.left], points[e.right]);
  const double pi = 3.14159265358979323846;
  return (between > 0 ? pi : -pi) - between * (pi / 180);
}

void naive_angles(const Workload& w, const Rest_shape& shape, Field& angles)
{
  for (std::size_t f = 0; f < w.animation.frames.size(); ++f)
    for (std::size_t e = 0; e < shape.edges().size(); ++e)
      angles(e, f) = shape.edges()[e].is_border() ? 0 : naive_angle(w.animation.frames[f], shape.edges()[e]);
}

// The edges with both ends in each ball.
Amf::Compressed_rows edges_in_balls(const Rest_shape& shape, const Amf::Compressed_rows& balls)
{
  Amf::Compressed_rows result;
  std::vector<char> is_in(shape.number_of_vertices(), 0);
  for (std::size_t v = 0; v < balls.size(); ++v) {
    std::vector<Rest_shape::Index> row;
    for (Rest_shape::Index w : balls[v]) is_in[w] = 1;
    for (Rest_shape::Index w : balls[v])
      for (Rest_shape::Index e : shape.incident_edges()[w])
        if (shape.edges()[e].source == w && is_in[shape.edges()[e].target] && !shape.edges()[e].is_border())
          row.push_back(e);
    for (Rest_shape::Index w : balls[v]) is_in[w] = 0;
    result.push_back(row.begin(), row.end());
  }
  return result;
}

// The mean dihedral angle of the edges in each ball, from the angles of all edges: frames contiguous, too.
void naive_curvature(const Workload& w, const Rest_shape& shape, const Amf::Compressed_rows& edges, Field& angles,
                     Field& curvature)
{
  naive_angles(w, shape, angles);
  const std::size_t frames = angles.number_of_frames();
  for (std::size_t v = 0; v < edges.size(); ++v) {
    double* const sum = curvature.row(v);
    std::fill(sum, sum + frames, 0.);
    for (Rest_shape::Index e : edges[v])
      for (std::size_t f = 0; f < frames; ++f) sum[f] += angles(e, f);
    for (std::size_t f = 0; f < frames; ++f) sum[f] /= double((std::max)(std::size_t(1), edges[v].size()));
  }
}

template <class A, class B>
double largest_difference(const A& a, const B& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.number_of_rows(); ++i)
    for (std::size_t f = 0; f < a.number_of_frames(); ++f)
      largest = (std::max)(largest, std::abs(double(a(i, f)) - double(b(i, f))));
  return largest;
}

struct Method
{
  std::string name;
  std::size_t threads;
  std::function<void()> run;
  Cell difference; // from the first of them
};

void add_rows(const std::vector<Method>& methods, double size, const Arguments& arguments, Table& table)
{
  std::vector<std::function<void()>> functions;
  for (const Method& m : methods) functions.push_back(m.run);
  const std::vector<double> seconds = least_seconds(functions, repetitions(arguments));
  for (std::size_t i = 0; i < methods.size(); ++i)
    table.add(methods[i].name, methods[i].threads, 1e9 * seconds[i] / size, seconds[0] / seconds[i],
              methods[i].difference);
}

std::vector<std::string> columns(const std::string& unit)
{
  return {"method", "threads", "ns / " + unit, "first / this", "largest difference from the first"};
}

// Runs a function of the sequential or the parallel version of what the package has.
template <class Function>
std::function<void()> with_threads(std::size_t threads, const Function& f)
{
  return [threads, f] {
    if (threads == 1) {
      f(CGAL::Sequential_tag());
    } else {
      const Thread_limit limit(threads);
      f(CGAL::Parallel_if_available_tag());
    }
  };
}

void compare_strain(const Workload& w, const Sequence& sequence, const Float_sequence& floats, const std::string& size,
                    const Arguments& arguments, Report& report)
{
  const Rest_shape& shape = sequence.rest_shape();
  const Amf::Largest_eigenvalue_strain largest;
  const Amf::Hencky_strain hencky;
  Field reference(shape.triangles().size(), sequence.number_of_frames()), other = reference;
  naive_strain<false>(w, shape, reference);
  naive_strain<true>(w, shape, other);
  // On a sliver eigenvalues are so large that their rounding errors, too, are: relative to 1 + the eigenvalue.
  const auto difference = [&](const auto& field) {
    double worst = 0;
    for (std::size_t t = 0; t < field.number_of_rows(); ++t)
      for (std::size_t f = 0; f < field.number_of_frames(); ++f)
        if (shape.areas()[t] > 0)
          worst = (std::max)(worst, std::abs(double(field(t, f)) - reference(t, f)) / (1 + reference(t, f)));
    return Cell(worst);
  };
  std::vector<Method> methods = {
      {"Eigen, 3 x 3, iterative", 1, [&] { naive_strain<false>(w, shape, other); }, Cell()},
      {"Eigen, 3 x 3, closed form", 1, [&] { naive_strain<true>(w, shape, other); }, difference(other)}};
  for (std::size_t threads : thread_counts()) {
    methods.push_back({"triangle_strain(), the same measure, double", threads,
                       with_threads(threads, [&](auto tag) { Amf::triangle_strain<decltype(tag)>(sequence, largest); }),
                       difference(Amf::triangle_strain(sequence, largest))});
    methods.push_back({"triangle_strain(), the same measure, float", threads,
                       with_threads(threads, [&](auto tag) { Amf::triangle_strain<decltype(tag)>(floats, largest); }),
                       difference(Amf::triangle_strain(floats, largest))});
    methods.push_back({"triangle_strain(), Hencky, double", threads,
                       with_threads(threads, [&](auto tag) { Amf::triangle_strain<decltype(tag)>(sequence, hencky); }),
                       Cell()});
  }
  Table table("Strain of triangles: " + w.name,
              size +
                  " Largest eigenvalue of the Cauchy-Green tensor of each triangle in each frame; what is written to "
                  "memory included. Difference: relative to 1 + the eigenvalue.",
              columns("(triangle, frame)"));
  add_rows(methods, double(shape.triangles().size()) * double(sequence.number_of_frames()), arguments, table);
  report.add(table);
}

void compare_curvature(const Workload& w, const Sequence& sequence, const Float_sequence& floats,
                       const std::string& size, const Arguments& arguments, Report& report)
{
  const Rest_shape& shape = sequence.rest_shape();
  const Amf::Mean_dihedral_angle angle;
  const Amf::Mean_curvature_density density;
  Field angles(shape.edges().size(), sequence.number_of_frames());
  {
    const Amf::Compressed_rows none = single_vertices(shape.number_of_vertices());
    std::vector<Method> methods = {
        {"CGAL::approximate_dihedral_angle()", 1, [&] { naive_angles(w, shape, angles); }, Cell()}};
    for (std::size_t threads : thread_counts()) {
      methods.push_back({"curvature(), angles, double", threads,
                         with_threads(threads, [&](auto tag) { Amf::curvature<decltype(tag)>(sequence, none, angle); }),
                         Cell()});
      methods.push_back({"curvature(), angles, float", threads,
                         with_threads(threads, [&](auto tag) { Amf::curvature<decltype(tag)>(floats, none, angle); }),
                         Cell()});
      methods.push_back(
          {"curvature(), angles, lengths and areas, double", threads,
           with_threads(threads, [&](auto tag) { Amf::curvature<decltype(tag)>(sequence, none, density); }), Cell()});
    }
    Table table("Dihedral angles of edges: " + w.name,
                size +
                    " The package computes the angles of edges on the way to curvatures: curvature() with balls that "
                    "hold their centre only, which leaves nothing to sum but memory to write.",
                columns("(edge, frame)"));
    add_rows(methods, double(shape.edges().size()) * double(sequence.number_of_frames()), arguments, table);
    report.add(table);
  }
  const double radius = 3 * shape.mean_edge_length();
  const Amf::Compressed_rows balls =
      Amf::geodesic_balls<CGAL::Parallel_if_available_tag>(sequence.rest_shape(), radius);
  const Amf::Compressed_rows edges = edges_in_balls(shape, balls);
  Field reference(shape.number_of_vertices(), sequence.number_of_frames()), other = reference;
  naive_curvature(w, shape, edges, angles, reference);
  std::vector<Method> methods = {{"CGAL::approximate_dihedral_angle(), plain sums", 1,
                                  [&] { naive_curvature(w, shape, edges, angles, other); }, Cell()}};
  for (std::size_t threads : thread_counts()) {
    methods.push_back({"curvature(), the same measure, double", threads,
                       with_threads(threads, [&](auto tag) { Amf::curvature<decltype(tag)>(sequence, balls, angle); }),
                       Cell(largest_difference(Amf::curvature(sequence, balls, angle), reference))});
    methods.push_back({"curvature(), the same measure, float", threads,
                       with_threads(threads, [&](auto tag) { Amf::curvature<decltype(tag)>(floats, balls, angle); }),
                       Cell(largest_difference(Amf::curvature(floats, balls, angle), reference))});
    methods.push_back(
        {"curvature(), density of mean curvature, double", threads,
         with_threads(threads, [&](auto tag) { Amf::curvature<decltype(tag)>(sequence, balls, density); }), Cell()});
  }
  Table table("Curvature of vertices: " + w.name,
              size + " Mean dihedral angle of the edges in each ball of 3 mean edge lengths (" +
                  shown(double(balls.number_of_entries()) / double(balls.size())) + " vertices, " +
                  shown(double(edges.number_of_entries()) / double(edges.size())) +
                  " edges); angles of edges included.",
              columns("(vertex, frame)"));
  add_rows(methods, double(shape.number_of_vertices()) * double(sequence.number_of_frames()), arguments, table);
  report.add(table);
}

} // namespace

int main(int argc, char* argv[])
{
  return run("measures", argc, argv, [](const Arguments& arguments, Report& report) {
    const Workload w = horse(arguments);
    const auto sequence = w.sequence<double>();
    const auto floats = w.sequence<float>();
    const std::string size = "N = " + std::to_string(sequence->number_of_vertices()) +
                             ", F = " + std::to_string(sequence->number_of_frames()) + ".";
    compare_strain(w, *sequence, *floats, size, arguments, report);
    compare_curvature(w, *sequence, *floats, size, arguments, report);
  });
}
