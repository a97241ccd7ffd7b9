// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures as property maps of the mesh, one for each frame, to be drawn or to be used by other algorithms.

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/frame_property_map.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <iostream>

namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef AMF::Frame_sequence<Mesh> Frame_sequence;
typedef AMF::Deformation_measurement<Frame_sequence> Measurement;

int main()
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(options);
  const Mesh& mesh = cylinder.mesh;
  const Frame_sequence animation(mesh, cylinder.frames, cylinder.frame_duration);

  Measurement measurement(animation);
  const Measurement::Field& strain = measurement.strain();
  const Measurement::Field& deformation = measurement.deformation();

  for (std::size_t f = 0; f < animation.number_of_frames(); f += 6) {
    const auto strain_map = AMF::frame_property_map(animation, strain, f);
    const auto deformation_map = AMF::frame_property_map(animation, deformation, f);
    const Mesh::Vertex_index most =
        *std::max_element(mesh.vertices_begin(), mesh.vertices_end(), [&](Mesh::Vertex_index v, Mesh::Vertex_index w) {
          return get(deformation_map, v) < get(deformation_map, w);
        });
    std::cout << double(f) * animation.frame_duration() << " s: most deformed at height " << mesh.point(most).z()
              << ", strain " << get(strain_map, most) << ", deformation " << get(deformation_map, most) << std::endl;
  }
  return 0;
}
