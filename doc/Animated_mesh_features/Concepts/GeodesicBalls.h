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

  \tparam Loop its type is not documented, what can be done with it is this:
  - `loop(n, task)` calls `task(i)` for each `i` in `[0, n)`, in any order and, if the detector was told so, on several
    threads, and returns when all of them are done. The tasks must not depend on one another. Meanwhile the visitor is
    told of the progress, from none to all of what `loop` stands for; if it cancels, `loop()` throws
    `CGAL::Animated_mesh_features::Cancelled`, which is to be let through.
  - `loop.part(i, n)` is the loop that stands for the `i`-th of `n` equal parts of the work, for those who need several
    passes.

  A model that does not use it works as well; nobody is told of its progress, nor can it be cancelled.

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
