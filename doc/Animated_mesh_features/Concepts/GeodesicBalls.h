// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `GeodesicBalls` describes how the neighbourhood of each vertex is found in which curvature is measured.

A model is copy-constructible.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Heat_method_geodesic_balls}
\cgalHasModels{CGAL::Animated_mesh_features::CGAL_heat_method_geodesic_balls}
\cgalHasModels{CGAL::Animated_mesh_features::Global_heat_method_geodesic_balls}
\cgalHasModels{CGAL::Animated_mesh_features::Dijkstra_geodesic_balls}
\cgalHasModelsEnd
*/
class GeodesicBalls
{
public:
  /*!
  collects for each vertex of a shape the vertices within a geodesic distance of it.

  \tparam Loop a model of `TaskLoop`. A model of `GeodesicBalls` that does not use it works as well; nobody is told of its
    progress, nor can it be cancelled.

  \param shape the rest shape.
  \param radius positive; length.
  \param loop runs tasks.

  \returns a row for each vertex: the indices of vertices in its ball, ascending and without duplicates. It is the
    model's own business what a distance is, and whether a vertex is in its own ball (with the models of the library it
    is).
  */
  template <class Loop>
  CGAL::Animated_mesh_features::Compressed_rows
  operator()(const CGAL::Animated_mesh_features::Rest_shape& shape, double radius, const Loop& loop) const;
};
