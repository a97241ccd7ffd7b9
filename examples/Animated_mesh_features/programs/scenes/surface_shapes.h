// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_SURFACE_SHAPES_H
#define PROGRAMS_SCENES_SURFACE_SHAPES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <cstdint>
#include <vector>

// What a writer of surfaces needs besides the surface.

namespace Programs {

typedef std::vector<CGAL::Animated_mesh_features::Rest_shape::Triangle> Triangles;

// Unit normals, vertex by vertex: means of those of the triangles around, by area. Where there is none, any direction.
std::vector<float> vertex_normals(const std::vector<float>& xyz, const Triangles& triangles);

// A sphere of radius 1: an octahedron, of which each triangle is cut in four again and again.
struct Unit_sphere
{
  std::vector<float> xyz; // and the normals
  std::vector<std::uint32_t> corners;

  explicit Unit_sphere(int subdivisions);

private:
  void subdivide();
};

} // namespace Programs

#endif // PROGRAMS_SCENES_SURFACE_SHAPES_H
