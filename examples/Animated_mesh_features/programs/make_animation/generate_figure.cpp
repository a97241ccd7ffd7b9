// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_animation/generate_figure.h"

#include "make_animation/set_frames.h"

#include "generators/articulated_figure.h"

namespace Make_animation {

Animated_mesh_generators::Generated_animation generate_figure(const Generation_options& o)
{
  Animated_mesh_generators::Articulated_figure_options options;
  set_frames(o, options);
  if (o.vertices) options.number_of_vertices = *o.vertices;
  return Animated_mesh_generators::articulated_figure(options);
}

std::vector<Animated_mesh_generators::Figure_joint>
joints_of_figure(const Animated_mesh_generators::Generated_animation& figure, const std::vector<double>& times)
{
  // set_frames() leaves the pace as it is
  return Animated_mesh_generators::figure_joints(figure.mesh,
                                                 Animated_mesh_generators::Articulated_figure_options().period, times);
}

} // namespace Make_animation
