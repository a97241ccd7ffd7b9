// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_DEFORMATION_NOISE_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_DEFORMATION_NOISE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// A body that moves rigidly has a deformation of rounding errors. It has minima, and a relative threshold would make
// features of them. (Rounding in the smoothing is the business of the search.)

// Whether all coordinates are numbers of single precision, as those of point caches and of most meshes are.
template <class FT>
bool is_in_single_precision(const Spatio_temporal_field<FT>& field)
{
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      if (FT(float(field(v, f))) != field(v, f)) return false;
  return true;
}

// By how much strain and curvature change are wrong because coordinates are rounded, as a fraction of an edge: a hundred
// times the rounding in which they are computed; twice that with which they came. A deformation has several of the
// latter, of both ends of some edges, but smoothing has averaged them before there is a response.
template <class FT>
double deformation_noise(const Rest_shape& shape, const Vertex_trajectories<FT>& trajectories)
{
  FT largest = 0;
  for (std::size_t v = 0; v < shape.number_of_vertices(); ++v) {
    if (shape.is_isolated(v)) continue;
    for (const Spatio_temporal_field<FT>* c : {&trajectories.x, &trajectories.y, &trajectories.z})
      for (std::size_t f = 0; f < c->number_of_frames(); ++f) largest = (std::max)(largest, std::abs((*c)(v, f)));
  }
  const bool came_rounded = is_in_single_precision(trajectories.x) && is_in_single_precision(trajectories.y) &&
                            is_in_single_precision(trajectories.z);
  const double rounding = (std::max)(100 * double(std::numeric_limits<FT>::epsilon()),
                                     came_rounded ? 2 * double(std::numeric_limits<float>::epsilon()) : 0.);
  return rounding * double(largest) / shape.mean_edge_length();
}

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_DEFORMATION_NOISE_H
