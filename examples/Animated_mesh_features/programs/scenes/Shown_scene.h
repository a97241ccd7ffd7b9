// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_SHOWN_SCENE_H
#define PROGRAMS_SCENES_SHOWN_SCENE_H

#include "reading/Sequence.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <string>
#include <vector>

namespace Programs {

typedef Sequence Shown_sequence;
typedef Feature Shown_feature;
typedef Values Shown_values; // N x F

struct Scene_views; // views/Scene_views.h

// A field to be shown on the surface, under a name: "strain", "curvature", "deformation" or any other.
struct Scene_field
{
  std::string name;                     // what it is called in files and legends
  const Shown_values* values = nullptr; // not owned
};

// What is to be seen: a moving surface, its features, and fields on it. All writers of pictures, plots, scenes and pages
// take one, and are compiled for this one only. It refers to what it shows, which must live as long.
struct Shown_scene
{
  const Shown_sequence& sequence;             // the moving surface
  const std::vector<Shown_feature>& features; // strongest first
  std::vector<Scene_field> fields;            // as many as there are, the most interesting one first
  std::string title;                          // one line, UTF-8
  const Scene_views* views = nullptr;         // where it is looked at from, if that is known; not owned
  bool is_cyclic = false;                     // whether the last frame is followed by the first

  // the field of that name; null if there is none
  const Shown_values* field(const std::string& name) const;
};

// A vertex in whose place a vertex is drawn: itself, or, if it belongs to no triangle, one that does. What is not seen takes
// no room in a picture.
inline std::size_t shown_vertex(const CGAL::Animated_mesh_features::Rest_shape& shape, std::size_t v)
{
  return shape.is_isolated(v) ? shape.triangles().front()[0] : v;
}

// Checks that the parts of a scene belong together: for writers, before they write anything.
// throws Option_error if a field has not the shape N x F of the sequence; Input_error if a value of a field is not finite,
// or a feature is on a vertex or in a frame that is not there.
void check_scene(const Shown_scene& scene);

} // namespace Programs

#endif // PROGRAMS_SCENES_SHOWN_SCENE_H
