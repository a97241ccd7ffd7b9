// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_INSTANCES_INL
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_INSTANCES_INL

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/Triangle_weights.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <CGAL/tags.h>

// Included by the header that defines what is declared here, and by `src/`; not on its own.
//
// What the compiled library has of this room: declared here, so that nobody else compiles it, defined in `src/`. Both
// presets, `float` and `double`, whatever the mesh.
#define CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(FT, Measure)                                                   \
  template Spatio_temporal_field<FT> vertex_strain_rows(                                                           \
      const Rest_shape&, const Vertex_trajectories<FT>&, const Measure&, Triangle_weights,                         \
      const Task_loop<CGAL::Parallel_if_available_tag, Any_visitor>&, Instruction_set)

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

extern CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(double, Hencky_strain);
extern CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(double, Largest_eigenvalue_strain);
extern CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(float, Hencky_strain);
extern CGAL_ANIMATED_MESH_FEATURES_STRAIN_INSTANCE(float, Largest_eigenvalue_strain);

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_STRAIN_INSTANCES_INL
