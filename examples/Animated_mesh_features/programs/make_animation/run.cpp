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

#include <CGAL/Animated_mesh_features/Evaluation/prominent_maxima.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/Rig_file_data.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>
#include <CGAL/Animated_mesh_features/IO/write_rig_events.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

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

// Angles are known between the frames, too: maxima are found 16 times more finely than frames are made.
IO::Rig_file_data figure_events(const Generated_animation& animation)
{
  const std::size_t finer = 16;
  IO::Rig_file_data data;
  data.vertices = num_vertices(animation.mesh);
  data.frames = animation.frames.size();
  data.frame_duration = animation.frame_duration;
  std::vector<double> times;
  for (std::size_t i = 0; i <= finer * (data.frames - 1); ++i)
    times.push_back(double(i) / double(finer) * data.frame_duration);
  for (const Animated_mesh_generators::Figure_joint& joint : joints_of_figure(animation, times)) {
    data.joints.push_back({joint.name, joint.region, {}});
    for (const auto& m : CGAL::Animated_mesh_features::prominent_maxima(joint.angles, 0))
      data.joints.back().maxima.push_back({times[m.place], m.value, m.prominence});
  }
  return data;
}

void write(const Generated_animation& animation, const std::string& base, const std::string& events_file)
{
  std::vector<std::string> paths = {base + ".obj", base + ".pc2"};
  if (!events_file.empty()) paths.push_back(events_file);
  Programs::check_outputs(paths, {});
  const Programs::Interruption interruption; // now that there is something to be left on a disk
  // All are complete, down to the last byte, before one of them takes its place.
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
  std::optional<IO::Output_file> events;
  if (!events_file.empty()) {
    events.emplace(events_file);
    IO::write_rig_events(events->stream(), figure_events(animation));
    events->stream().flush();
    events->check();
  }
  obj.commit();
  pc2.commit();
  if (events) events->commit();
}

} // namespace

void run(const Generation_options& o)
{
  const Generated_animation animation = o.body == Body::FIGURE ? generate_figure(o) : generate_cylinder(o);
  write(animation, o.base, o.events);
  const std::string base = Programs::terminal_text(o.base);
  std::cout << base << ".obj: " << num_vertices(animation.mesh) << " vertices, " << num_faces(animation.mesh)
            << " triangles\n"
            << base << ".pc2: " << animation.frames.size() << " frames, " << o.frames_per_second << " in a second"
            << std::endl;
}

} // namespace Make_animation
