// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Animated_mesh_features/Deformation/internal/curvature_rows.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/strain_fields.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/curvature_instances.inl>
#include <CGAL/Animated_mesh_features/Deformation/internal/strain_instances.inl>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(double, Hencky_strain);
CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(double, Largest_eigenvalue_strain);
CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(float, Hencky_strain);
CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(float, Largest_eigenvalue_strain);

CGAL_ANIMATED_MESH_FEATURES_CURVATURE_INSTANCE(double, Mean_curvature_density);
CGAL_ANIMATED_MESH_FEATURES_CURVATURE_INSTANCE(double, Mean_dihedral_angle);
CGAL_ANIMATED_MESH_FEATURES_CURVATURE_INSTANCE(float, Mean_curvature_density);
CGAL_ANIMATED_MESH_FEATURES_CURVATURE_INSTANCE(float, Mean_dihedral_angle);

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL
