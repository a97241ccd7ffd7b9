// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/Shown_scene.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <cstddef>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

void check_field(const Shown_values& field, std::size_t number_of_vertices, std::size_t number_of_frames)
{
  const auto size = [](std::size_t rows, std::size_t columns) {
    return std::to_string(rows) + " x " + std::to_string(columns);
  };
  if (field.number_of_rows() != number_of_vertices || field.number_of_frames() != number_of_frames)
    throw AMF::Option_error("the field is " + size(field.number_of_rows(), field.number_of_frames()) +
                            ", the animation " + size(number_of_vertices, number_of_frames));
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    for (std::size_t f = 0; f < number_of_frames; ++f)
      if (!std::isfinite(field(v, f)))
        throw AMF::Input_error("frame " + std::to_string(f) + ": the field is not finite at vertex " +
                               std::to_string(v));
}

} // namespace

const Shown_values* Shown_scene::field(const std::string& name) const
{
  for (const Scene_field& f : fields)
    if (f.name == name) return f.values;
  return nullptr;
}

void check_scene(const Shown_scene& scene)
{
  const std::size_t n = scene.sequence.number_of_vertices(), frames = scene.sequence.number_of_frames();
  for (const Scene_field& f : scene.fields) check_field(*f.values, n, frames);
  const auto check = [](std::size_t rank, const char* what, std::size_t i, std::size_t size) {
    if (i < size) return;
    throw AMF::Input_error("feature " + std::to_string(rank) + " has the " + what + " " + std::to_string(i) +
                           "; the animation has " + std::to_string(size));
  };
  for (std::size_t i = 0; i < scene.features.size(); ++i) {
    const Shown_feature& f = scene.features[i];
    check(i, "vertex", f.vertex_index, n);
    for (std::size_t v : f.triangle) check(i, "vertex", v, n);
    check(i, "frame", f.frame, frames);
  }
}

} // namespace Programs
