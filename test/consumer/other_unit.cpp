// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <algorithm>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

double largest_strength(const std::vector<Feature>& features)
{
  double largest = 0.;
  for (const Feature& f : features) largest = (std::max)(largest, f.strength);
  return largest;
}
