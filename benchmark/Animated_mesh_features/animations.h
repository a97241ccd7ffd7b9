// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_ANIMATIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_ANIMATIONS_H

#include "benchmark_support.h"

// Before the generators, which bring Boost's compressed_sparse_row_graph.hpp, behind which Boost's disjoint_sets.hpp
// does not compile.
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>

#include "generators/articulated_figure.h"
#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// What is measured on.

namespace Benchmark {

namespace Amf = CGAL::Animated_mesh_features;

typedef Animated_mesh_generators::Generated_animation Animation;
typedef Animation::Mesh Mesh;
typedef Animation::Kernel::Point_3 Point_3;

struct Workload
{
  std::string name;
  Animation animation;
  std::vector<Point_3> rest; // empty: as the mesh

  template <class FT>
  std::unique_ptr<Amf::Frame_sequence<Mesh, FT>> sequence() const
  {
    auto s =
        std::make_unique<Amf::Frame_sequence<Mesh, FT>>(animation.mesh, animation.frames, animation.frame_duration);
    if (rest.empty())
      s->set_rest_shape(animation.mesh.points());
    else
      s->set_rest_shape(rest);
    return s;
  }
};

// The running figure: two steps in 1.6 s, or as many as there are frames for.
inline Workload figure(std::size_t vertices, std::size_t frames, double frames_per_second = 0)
{
  Animated_mesh_generators::Articulated_figure_options options;
  options.number_of_vertices = vertices;
  options.number_of_frames = frames;
  options.frame_rate = frames_per_second > 0 ? frames_per_second : double(frames) / (2 * options.period);
  return {"figure", articulated_figure(options), {}};
}

// The bending cylinder, two bends in 2 s; quick to make, whatever the size.
inline Workload cylinder(std::size_t vertices, std::size_t frames)
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = Animated_mesh_generators::vertices_around_for(vertices, options);
  options.number_of_frames = frames;
  options.frame_rate = double(frames) / 2;
  return {"cylinder", bending_cylinder(options), {}};
}

inline bool has_horse(const Arguments& a)
{
  return !a.data.empty() && std::filesystem::exists(a.data + "/horse-gallop.pc2");
}

// The galloping horse of Sumner and Popovic, with the standing horse as rest shape; where it is not, a figure of the
// same size.
inline Workload horse(const Arguments& a)
{
  if (!has_horse(a)) return figure(a.quick ? 1500 : 8431, 48);
  const Amf::IO::Animation_file_data<double> data =
      Amf::IO::read_animation<double>({a.data + "/horse-gallop.obj", a.data + "/horse-gallop.pc2"});
  Workload w;
  w.name = "horse-gallop";
  w.animation.mesh = Amf::IO::to_surface_mesh(data.mesh, data.sources.front());
  w.animation.frame_duration = 1. / 30;
  for (std::size_t f = 0; f < data.frames; ++f) {
    w.animation.frames.emplace_back();
    for (std::size_t v = 0; v < data.mesh.points.size(); ++v)
      w.animation.frames.back().emplace_back(data.x(v, f), data.y(v, f), data.z(v, f));
  }
  for (const auto& p : Amf::IO::read_mesh(a.data + "/horse-rest.obj").points) w.rest.emplace_back(p[0], p[1], p[2]);
  return w;
}

inline Amf::Rest_shape rest_shape(const Mesh& mesh)
{
  std::vector<Amf::Rest_shape::Point> points;
  for (const auto v : vertices(mesh)) points.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  Amf::Rest_shape shape(mesh, get(boost::vertex_index, mesh), points.size());
  shape.set_points(std::move(points));
  return shape;
}

// Every edge split at its midpoint, every triangle in four: a large mesh that is as irregular as a small one.
inline Mesh subdivided(const Mesh& coarse)
{
  Mesh fine;
  for (const auto v : vertices(coarse)) fine.add_vertex(coarse.point(v));
  std::vector<Mesh::Vertex_index> middle(num_edges(coarse));
  for (const auto e : edges(coarse))
    middle[e] = fine.add_vertex(CGAL::midpoint(coarse.point(coarse.vertex(e, 0)), coarse.point(coarse.vertex(e, 1))));
  for (const auto f : faces(coarse)) {
    Mesh::Vertex_index corner[3], side[3];
    int i = 0;
    for (const auto h : halfedges_around_face(halfedge(f, coarse), coarse)) {
      corner[i] = source(h, coarse);
      side[i++] = middle[edge(h, coarse)];
    }
    for (i = 0; i < 3; ++i) fine.add_face(corner[i], side[i], side[(i + 2) % 3]);
    fine.add_face(side[0], side[1], side[2]);
  }
  return fine;
}

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_ANIMATIONS_H
