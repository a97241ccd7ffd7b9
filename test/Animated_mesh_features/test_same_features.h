// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_SAME_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_SAME_FEATURES_H

#include "test_bumpy_sphere.h"
#include "test_support.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// Detection on the bumpy sphere, whatever the mesh that carries it, and comparison of what is found.

namespace test_support {

// Which vertex of the sphere each vertex of a mesh is, by its coordinates.
template <class Mesh>
std::vector<std::size_t> sphere_indices(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  std::map<Point_3, std::size_t> index;
  for (std::size_t i = 0; i < sphere.rest.size(); ++i) index[sphere.rest[i]] = i;
  const auto points = get(CGAL::vertex_point, mesh);
  std::vector<std::size_t> result;
  for (auto v : vertices(mesh)) {
    const auto p = get(points, v);
    result.push_back(index.at(Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()))));
  }
  return result;
}

// The frames as ranges of points in the order of the mesh's vertices.
template <class Point>
std::vector<std::vector<Point>> frames_in_order(const Bumpy_sphere& sphere, const std::vector<std::size_t>& order)
{
  std::vector<std::vector<Point>> frames;
  for (const std::vector<Point_3>& frame : sphere.frames) {
    std::vector<Point> points;
    for (std::size_t i : order) points.emplace_back(frame[i].x(), frame[i].y(), frame[i].z());
    frames.push_back(points);
  }
  return frames;
}

// The animation of the sphere on this mesh; the rest shape is the mesh's own, by its own point map.
template <class FT = double, class Point = Point_3, class Mesh>
CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT> animated(const Bumpy_sphere& sphere, const Mesh& mesh)
{
  CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT> sequence(
      mesh, frames_in_order<Point>(sphere, sphere_indices(sphere, mesh)), sphere.frame_duration);
  sequence.set_rest_shape(get(CGAL::vertex_point, mesh));
  return sequence;
}

// A feature without its descriptor, so that those of different meshes can be compared; vertices are the sphere's.
struct Found
{
  std::size_t vertex, frame;
  std::vector<double> numbers; // time, scales, response, places
};

template <class Feature>
Found found(const Feature& f, const std::vector<std::size_t>& order)
{
  Found r = {order[f.vertex_index], f.frame, {f.time, f.sigma, f.tau, f.response}};
  r.numbers.insert(r.numbers.end(), f.position.begin(), f.position.end());
  r.numbers.insert(r.numbers.end(), f.rest_position.begin(), f.rest_position.end());
  return r;
}

// Detects, and checks that each descriptor belongs to its rank.
template <class ConcurrencyTag = CGAL::Sequential_tag, class Mesh, class FT,
          class Options = CGAL::Animated_mesh_features::Calibrated_options>
std::vector<Found> detect(const Bumpy_sphere& sphere,
                          const CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT>& sequence,
                          const Options& options = Options())
{
  typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT> Sequence;
  std::vector<CGAL::Animated_mesh_features::Spatio_temporal_feature<typename Sequence::vertex_descriptor>> features;
  CGAL::detect_spatio_temporal_features<ConcurrencyTag>(sequence, std::back_inserter(features), options);
  const std::vector<std::size_t> order = sphere_indices(sphere, sequence.triangle_mesh());
  std::vector<Found> result;
  for (const auto& f : features) {
    CHECK(get(sequence.vertex_index_map(), f.vertex) == f.vertex_index);
    CHECK(sequence.vertex_descriptors()[f.vertex_index] == f.vertex);
    result.push_back(found(f, order));
  }
  return result;
}

// With tolerance 0 the same bits. Otherwise numbers may differ by that fraction of the larger of 1 and themselves.
inline void check_same(const std::vector<Found>& a, const std::vector<Found>& b, double tolerance,
                       const std::string& what)
{
  report(!a.empty(), __FILE__, __LINE__, what + ": no features to compare with");
  report(a.size() == b.size(), __FILE__, __LINE__,
         what + ": " + std::to_string(a.size()) + " features against " + std::to_string(b.size()));
  double largest = 0;
  bool same = true;
  for (std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i) {
    same = same && a[i].vertex == b[i].vertex && a[i].frame == b[i].frame;
    for (std::size_t j = 0; j < a[i].numbers.size(); ++j) {
      const double x = a[i].numbers[j], y = b[i].numbers[j];
      const double d = std::abs(x - y) / (std::max)(1., std::abs(x));
      if (!(d <= largest)) largest = d;
    }
  }
  report(same, __FILE__, __LINE__, what + ": other vertices or frames");
  std::ostringstream difference;
  difference << ", largest difference " << largest;
  report(largest <= tolerance, __FILE__, __LINE__, what + difference.str());
  std::cout << what << ": " << b.size() << " features" << difference.str() << std::endl;
}

// Detection by default options, and once more with balls by shortest paths, from which nothing is read off that would
// depend on the order of vertices: the patches of the heat method's balls are other ones for another order, and with them
// a few vertices at the rims of balls.
class Model_test
{
public:
  explicit Model_test(const Bumpy_sphere& sphere)
    : m_sphere(sphere)
    , m_options(CGAL::Animated_mesh_features::calibrated_options().with_balls(
          CGAL::Animated_mesh_features::Dijkstra_geodesic_balls()))
  {
    CGAL::Surface_mesh<Point_3> mesh;
    add_sphere(sphere, mesh);
    m_features = detect(sphere, animated(sphere, mesh));
    m_features_by_paths = detect(sphere, animated(sphere, mesh), m_options);
  }

  // what Surface_mesh finds
  const std::vector<Found>& features() const { return m_features; }

  // Checks that a mesh that carries the sphere and nothing else finds the same: the same bits if its vertices are in the
  // sphere's order.
  template <class Mesh>
  void operator()(const Mesh& mesh, bool same_order, const std::string& name) const
  {
    const std::vector<std::size_t> order = sphere_indices(m_sphere, mesh);
    report(order.size() == m_sphere.rest.size(), __FILE__, __LINE__, name + ": number of vertices");
    report(std::is_sorted(order.begin(), order.end()) == same_order, __FILE__, __LINE__, name + ": order of vertices");
    const auto sequence = animated(m_sphere, mesh);
    const auto shape = CGAL::Animated_mesh_features::rest_shape_of_mesh(mesh); // which is the mesh's own
    report(shape.triangles() == sequence.rest_shape().triangles() && shape.points() == sequence.rest_shape().points() &&
               shape.lengths() == sequence.rest_shape().lengths(),
           __FILE__, __LINE__, name + ": rest shape without an animation");
    check_same(m_features, detect(m_sphere, sequence), same_order ? 0 : 1e-3, name);
    // heat diffusion solves in single precision, and eliminates the vertices in another order
    check_same(m_features_by_paths, detect(m_sphere, sequence, m_options), same_order ? 0 : 1e-6,
               name + ", balls by paths");
  }

private:
  typedef decltype(CGAL::Animated_mesh_features::calibrated_options().with_balls(
      CGAL::Animated_mesh_features::Dijkstra_geodesic_balls())) Options_by_paths;
  Bumpy_sphere m_sphere;
  Options_by_paths m_options;
  std::vector<Found> m_features, m_features_by_paths;
};

} // namespace test_support

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_SAME_FEATURES_H
