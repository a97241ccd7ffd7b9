// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `MeshAnimation` describes what features are found on: a triangle mesh that does not change its connectivity,
the positions of its vertices in each of `F` frames, the time between two frames, and the shape from which deformation
is measured.

A model need not be default-constructible, copyable or assignable. What its functions return is read once:
by `CGAL::detect_spatio_temporal_features()`, when a `CGAL::Animated_mesh_features::Deformation_measurement` is
constructed, or by `CGAL::Animated_mesh_features::as_frame_sequence()`. Only its mesh has to live longer.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Frame_sequence}
\cgalHasModelsEnd
*/
class MeshAnimation
{
public:
  /// \name Types
  /// @{

  /// the mesh, a model of `FaceListGraph`, `VertexListGraph` and `EdgeListGraph` with dynamic vertex properties, as all
  /// models of `FaceGraph` in \cgal are. Its faces are triangles. Borders, several connected components, isolated
  /// vertices and degenerate triangles are allowed.
  typedef unspecified_type Triangle_mesh;

  /// `float` or `double`: the scalar of positions and of everything that is computed from them.
  typedef unspecified_type FT;

  /// a copy-constructible model of `ReadablePropertyMap` with the key
  /// `boost::graph_traits<Triangle_mesh>::%vertex_descriptor`. The value has functions `x()`, `y()` and `z()`, of types
  /// from which `CGAL::to_double()` makes a `double`; points of all \cgal kernels do.
  typedef unspecified_type Point_map;

  /// the same for the rest shape; may be another type.
  typedef unspecified_type Rest_point_map;

  /// @}

  /// \name Operations
  /// `Point_map` and `Rest_point_map` are not used by name: what matters is what the functions return.
  /// @{

  /// the connectivity.
  const Triangle_mesh& triangle_mesh() const;

  /// `F`, at least 3, since a feature has a frame before and a frame after it.
  std::size_t number_of_frames() const;

  /// the time between two frames, in seconds; positive.
  double frame_duration() const;

  /// the position of each vertex in frame `f`, from 0. The maps of all frames exist at the same time.
  Point_map point_map(std::size_t f) const;

  /// the position of each vertex in the undeformed shape, in the unit of length of the frames.
  Rest_point_map rest_point_map() const;

  /// @}
};
