// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CHECK_FIELD_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CHECK_FIELD_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// Throws unless a field that comes from outside has a row for each vertex and finite values.
template <class FT>
void check_field(const Spatio_temporal_field<FT>& field, std::size_t number_of_vertices)
{
  if (field.number_of_rows() != number_of_vertices)
    throw Option_error("the field has " + std::to_string(field.number_of_rows()) + " rows, the rest shape " +
                       std::to_string(number_of_vertices) + " vertices");
  for (std::size_t v = 0; v < number_of_vertices; ++v) {
    if (all_finite(field.row(v), field.number_of_frames())) continue;
    std::size_t f = 0;
    while (std::isfinite(field(v, f))) ++f;
    throw Input_error("frame " + std::to_string(f) + ": the field is not finite at vertex " + std::to_string(v));
  }
}

// The same for a field of an animation, whose frames are known, too.
template <class FT>
void check_field(const Spatio_temporal_field<FT>& field, std::size_t number_of_vertices, std::size_t number_of_frames)
{
  if (field.number_of_rows() != number_of_vertices || field.number_of_frames() != number_of_frames)
    throw Option_error("the field is " + std::to_string(field.number_of_rows()) + " x " +
                       std::to_string(field.number_of_frames()) + ", the animation " +
                       std::to_string(number_of_vertices) + " x " + std::to_string(number_of_frames));
  check_field(field, number_of_vertices);
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_CHECK_FIELD_H
