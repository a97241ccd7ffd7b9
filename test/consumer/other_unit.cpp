// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>

#include <cstddef>

double sum_of_field(const CGAL::Animated_mesh_features::Spatio_temporal_field<double>& field)
{
  double sum = 0.;
  for (std::size_t row = 0; row < field.number_of_rows(); ++row)
    for (std::size_t frame = 0; frame < field.number_of_frames(); ++frame) sum += field(row, frame);
  return sum;
}
