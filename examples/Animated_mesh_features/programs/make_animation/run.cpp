// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_animation/run.h"

#include "make_animation/generate_figure.h"
#include "make_animation/set_frames.h"
#include "output/check_outputs.h"
#include "running/Interruption.h"
#include "running/tell.h"

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <string>

namespace IO = CGAL::Animated_mesh_features::IO;
using Animated_mesh_generators::Generated_animation;

namespace Make_animation {

namespace {

Generated_animation generate_cylinder(const Generation_options& o)
{
  Animated_mesh_generators::Bending_cylinder_options options;
  set_frames(o, options);
  if (o.vertices) options.vertices_around = Animated_mesh_generators::vertices_around_for(*o.vertices, options);
  return Animated_mesh_generators::bending_cylinder(options);
}

IO::Indexed_mesh rest_shape(const Generated_animation& animation)
{
  IO::Indexed_mesh result;
  // Neither generator leaves gaps in the numbering.
  for (const auto& p : animation.mesh.points()) result.points.push_back({{p.x(), p.y(), p.z()}});
  for (const auto f : faces(animation.mesh)) {
    std::array<std::size_t, 3> triangle;
    std::size_t corner = 0;
    for (const auto v : vertices_around_face(halfedge(f, animation.mesh), animation.mesh)) triangle[corner++] = v;
    result.triangles.push_back(triangle);
  }
  return result;
}

void write(const Generated_animation& animation, const std::string& base)
{
  Programs::check_outputs({base + ".obj", base + ".pc2"}, {});
  const Programs::Interruption interruption; // now that there is something to be left on a disk
  // Both are complete, down to the last byte, before either takes its place.
  IO::Output_file obj(base + ".obj"), pc2(base + ".pc2");
  IO::write_obj(obj.stream(), rest_shape(animation));
  obj.stream().flush();
  obj.check();
  IO::write_pc2(pc2.stream(), num_vertices(animation.mesh), animation.frames.size(), [&](std::size_t f, float* xyz) {
    Programs::Interruption::check();
    for (const auto& p : animation.frames[f])
      for (int i = 0; i < 3; ++i) *xyz++ = float(p[i]);
  });
  pc2.stream().flush();
  pc2.check();
  obj.commit();
  pc2.commit();
}

} // namespace

void run(const Generation_options& o)
{
  const Generated_animation animation = o.body == Body::FIGURE ? generate_figure(o) : generate_cylinder(o);
  write(animation, o.base);
  const std::string base = Programs::terminal_text(o.base);
  std::cout << base << ".obj: " << num_vertices(animation.mesh) << " vertices, " << num_faces(animation.mesh)
            << " triangles\n"
            << base << ".pc2: " << animation.frames.size() << " frames, " << o.frames_per_second << " in a second"
            << std::endl;
}

} // namespace Make_animation
