// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DETECT_SPATIO_TEMPORAL_FEATURES_H
#define CGAL_DETECT_SPATIO_TEMPORAL_FEATURES_H

#include <CGAL/Animated_mesh_features/Detection_options.h>
#include <CGAL/Animated_mesh_features/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Visitor.h>

#include <CGAL/tags.h>

namespace CGAL {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

detects the spatio-temporal feature points of an animated mesh: where, when, how large and how long its surface deforms
in a distinctive way.

From the positions follow the strain of the triangles and the change of curvature over geodesic balls, both with respect
to the rest shape; together they are a deformation for each vertex and frame. Smoothed over the surface and over time by
Gaussians of many widths, it becomes a scale space, of which the scale-normalised difference of Gaussians has a minimum
wherever something of just that size and duration happens. The method starts from that of
Mykhalchuk, Seo and Cordier \cgalCite{mykhalchuk2014}.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` (with oneTBB) or `CGAL::Sequential_tag`. The result is the
same, bit for bit.
\tparam Animation a model of `MeshAnimation`, for instance `Frame_sequence`.
\tparam OutputIterator an output iterator of `Spatio_temporal_feature<vertex_descriptor>`.
\tparam Options a `Detection_options`.
\tparam Visitor a model of `DetectionVisitor`.

\param animation the mesh, its frames, the time between them, and the rest shape.
\param out receives the features, strongest first.
\param options by default `calibrated_options()`.
\param visitor is told of the progress and may cancel.

\returns the end of the output.

\throw Animated_mesh_features::Option_error if an option makes no sense for this animation;
\throw Animated_mesh_features::Numerical_error if a factorisation fails;
\throw Animated_mesh_features::Cancelled if the visitor asked for it. In each case nothing has been written to `out`.

Linear in `N F` times the number of pairs of levels, plus the geodesic balls and the spatial filter; see
`Animated_mesh_features::Feature_detector`, which is for repeated use.

\sa `Animated_mesh_features::Feature_detector`
*/
template <class ConcurrencyTag = Parallel_if_available_tag,
          class Animation,
          class OutputIterator,
          class Options = Animated_mesh_features::Calibrated_options,
          class Visitor = Animated_mesh_features::Default_visitor>
OutputIterator detect_spatio_temporal_features(const Animation& animation,
                                               OutputIterator out,
                                               Options options = Options(),
                                               Visitor visitor = Visitor())
{
  Animated_mesh_features::Feature_detector<Animation, Options, ConcurrencyTag> detector(animation, options);
  return detector(out, visitor);
}

} // namespace CGAL

#endif // CGAL_DETECT_SPATIO_TEMPORAL_FEATURES_H
