// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// An animation at 3 % of its vertices, in the frame in which the mesh that was simplified at rest is farthest from the
// original: the original, that mesh, and the one that was simplified for all frames.
//
// simplification_pictures PICTURE.png                                       the running figure
// simplification_pictures PICTURE.png MESH.obj CACHE.pc2 REST.obj UP_AXIS AZIMUTH

#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>

#include "draw_surfaces.h"
#include "figures_support.h"

#include "generators/articulated_figure.h"

#include "drawing/decimal.h"

#include <CGAL/Animated_mesh_features/Applications/simplification_errors.h>
#include <CGAL/Animated_mesh_features/Applications/simplify_animation.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using namespace figures;
using Programs::Rendering::Surface;
typedef std::vector<AMF::Rest_shape::Point> Points;

namespace {

struct Input
{
  Mesh mesh;
  std::vector<std::vector<Point_3>> frames;
  std::vector<Point_3> rest;
};

std::vector<Point_3> points_of(const std::string& path)
{
  std::vector<Point_3> points;
  for (const auto& p : AMF::IO::read_mesh(path).points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Input read(const std::string& mesh, const std::string& cache, const std::string& rest)
{
  const AMF::IO::Animation_file_data<double> data = AMF::IO::read_animation<double>({mesh, cache});
  Input input = {AMF::IO::to_surface_mesh(data.mesh, mesh), {}, points_of(rest)};
  for (std::size_t f = 0; f < data.frames; ++f) {
    input.frames.emplace_back();
    for (std::size_t v = 0; v < data.mesh.points.size(); ++v)
      input.frames.back().emplace_back(data.x(v, f), data.y(v, f), data.z(v, f));
  }
  return input;
}

Input running_figure()
{
  Animated_mesh_generators::Articulated_figure_options options;
  options.number_of_vertices = 12000;
  const auto figure = Animated_mesh_generators::articulated_figure(options);
  return {figure.mesh, figure.frames, std::vector<Point_3>(figure.mesh.points().begin(), figure.mesh.points().end())};
}

// Each triangle with corners of its own, so that edges are seen.
Surface facets(const Points& points, const std::vector<AMF::Rest_shape::Triangle>& triangles)
{
  Surface s;
  for (const AMF::Rest_shape::Triangle& t : triangles) {
    const Eigen::Vector3d n = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    Surface::Triangle corners = {};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = std::uint32_t(s.points.size());
      s.points.push_back(points[t[k]]);
      s.normals.push_back(n.norm() > 0 ? Eigen::Vector3d(n.normalized()) : Eigen::Vector3d::Zero());
    }
    s.triangles.push_back(corners);
  }
  return s;
}

// At so many vertices, with the errors in all frames of `animation`.
struct Simplified
{
  AMF::Animation_level level;
  std::vector<AMF::Simplification_error> errors;

  Simplified(const Frame_sequence& of, const Frame_sequence& animation, std::size_t vertices)
  {
    AMF::Simplification_options options;
    options.vertices = {vertices};
    level = AMF::simplify_animation(of, options).levels.front();
    AMF::Simplification_error_options measured;
    measured.vertex_of = &level.vertex_of;
    errors = AMF::simplification_errors(
        animation.rest_shape(), animation.trajectories(), level.triangles,
        level.binding.positions(animation.rest_shape().points()),
        [&](std::size_t f) { return level.binding.positions(animation.trajectories().frame(f)); }, measured);
  }
};

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2 && argc != 7) {
    std::cerr << "Usage: simplification_pictures PICTURE.png [MESH.obj CACHE.pc2 REST.obj UP_AXIS AZIMUTH]"
              << std::endl;
    return 2;
  }
  try {
    const Input input = argc == 2 ? running_figure() : read(argv[2], argv[3], argv[4]);
    Frame_sequence animation(input.mesh, input.frames, 1. / 30);
    animation.set_rest_shape(input.rest);
    const Frame_sequence still(input.mesh, std::vector<std::vector<Point_3>>(3, input.rest), 1. / 30);
    const std::size_t n = animation.number_of_vertices(), left = n * 3 / 100;
    const Simplified at_rest(still, animation, left), in_all(animation, animation, left);
    const AMF::Simplification_error& worst = AMF::worst_frame(at_rest.errors);
    const auto shown = animation.trajectories().frame(worst.frame);
    const double unit = 100 / animation.rest_shape().bounding_box_diagonal();
    const auto label = [&](const std::string& name, const Simplified& s) {
      return name + ": " + Programs::rounded(unit * s.errors[worst.frame].mean(), 2) + " %";
    };
    Points original;
    for (std::size_t v = 0; v < n; ++v) original.push_back(shown[AMF::Rest_shape::Index(v)]);
    Programs::Rendering::View_direction view;
    view.up_axis = argc == 2 ? 2 : std::atoi(argv[5]);
    view.azimuth = argc == 2 ? 60 : std::atof(argv[6]);
    view.elevation = 10;
    draw_surfaces(argv[1],
                  {{std::to_string(n) + " vertices", facets(original, animation.rest_shape().triangles())},
                   {label(std::to_string(left) + ", at rest", at_rest),
                    facets(at_rest.level.binding.positions(shown), at_rest.level.triangles)},
                   {label(std::to_string(left) + ", in all frames", in_all),
                    facets(in_all.level.binding.positions(shown), in_all.level.triangles)}},
                  view, 480, {});
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "simplification_pictures: " << e.what() << std::endl;
    return 1;
  }
}
