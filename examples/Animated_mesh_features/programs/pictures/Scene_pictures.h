// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_SCENE_PICTURES_H
#define PROGRAMS_PICTURES_SCENE_PICTURES_H

#include "drawing/Legend.h"
#include "rendering/Spheres.h"
#include "rendering/Surface.h"
#include "scenes/Shown_scene.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace Programs {

// Turns a scene, frame by frame, into what is drawn.
class Scene_pictures
{
public:
  explicit Scene_pictures(const Shown_scene& scene); // is referred to

  Rendering::Surface surface(std::size_t frame) const;
  std::vector<Rendering::Sphere> spheres(std::size_t frame) const;
  std::vector<Legend_bar> legend() const;
  std::string label(std::size_t frame) const;

  // the lowest coordinate of all frames
  double lowest(int axis) const;

private:
  bool has_field() const { return !m_scene.fields.empty() && m_high > m_low; }
  void find_range_of_field();

  const Shown_scene& m_scene;
  std::vector<double> m_places; // of tau, on the scale of colours
  std::vector<Rendering::Surface::Triangle> m_triangles;
  std::vector<std::int8_t> m_outer_sides; // of the triangles
  double m_low = 0, m_high = 0;         // of the field
  bool m_is_cut = false;                // whether there are greater values
  double m_shortest = 0, m_longest = 0; // tau
};

} // namespace Programs

#endif // PROGRAMS_PICTURES_SCENE_PICTURES_H
