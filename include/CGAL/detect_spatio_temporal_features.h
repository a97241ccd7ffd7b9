// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DETECT_SPATIO_TEMPORAL_FEATURES_H
#define CGAL_DETECT_SPATIO_TEMPORAL_FEATURES_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/as_frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>

#include <CGAL/tags.h>

#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

detects the spatio-temporal feature points of an animated mesh: where, when, how large and how long its surface deforms
in a distinctive way.

From the positions follow the strain of the triangles and the change of curvature over geodesic balls, both with respect
to the rest shape; together they are a deformation for each vertex and frame. What never changes is taken from it. Smoothed over the surface and over time by
Gaussians of many widths, it becomes a scale space, of which the scale-normalised difference of Gaussians has a minimum
wherever something of just that size and duration happens. The method starts from that of
Mykhalchuk, Seo and Cordier \cgalCite{mykhalchuk2014}.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` (with oneTBB) or `CGAL::Sequential_tag`. The result is the
same, bit for bit.
\tparam Animation a model of `MeshAnimation`, for instance `Frame_sequence`.
\tparam OutputIterator an output iterator of `Spatio_temporal_feature<vertex_descriptor>`.
\tparam Options a `Detection_options`.
\tparam Visitor a model of `DetectionVisitor`.

\param animation the mesh, its frames, the time between them, and the rest shape. The rest shape of a `Frame_sequence` is
  its first frame; `set_canonical_rest_shape(animation)` takes the average of all frames instead, in about as long as the
  detection takes: better for what begins in the middle of a motion, if there is no mesh of the body at rest.
\param out receives the features, strongest first.
\param options by default `calibrated_options()`.
\param visitor is told of the progress and may cancel.

\returns the end of the output.

\throw Animated_mesh_features::Option_error if an option makes no sense for this animation;
\throw Animated_mesh_features::Numerical_error if a factorisation fails;
\throw Animated_mesh_features::Cancelled if the visitor asked for it. In each case nothing has been written to `out`.

Linear in `N F` times the number of pairs of levels, plus the geodesic balls and the spatial filter.

It is made of two stages, each of which can be used alone: `Animated_mesh_features::Deformation_measurement` makes the
field of an animation, and `Animated_mesh_features::Feature_detector` finds features in a field over a rest shape - also in
a field of your own, and again with other thresholds at next to no cost.

\sa `Animated_mesh_features::Deformation_measurement`
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
  namespace Amf = Animated_mesh_features;
  typedef typename Animation::FT FT;
  typedef typename Options::Search Search;
  typedef Amf::Frame_sequence<typename Animation::Triangle_mesh, FT> Sequence;
  options.selection.check();
  const Sequence& sequence = Amf::as_frame_sequence(animation);
  Amf::Spatio_temporal_field<FT> deformation;
  double noise = 0;
  { // the geodesic balls are not needed any longer than this
    Amf::Deformation_measurement<Sequence, typename Options::Measurement, ConcurrencyTag> measurement(sequence, options);
    deformation = measurement.take_deformation(visitor);
    noise = measurement.noise();
  }
  Amf::subtract_baseline(deformation, options.baseline);
  Amf::Feature_detector<FT, Search, ConcurrencyTag> detector(sequence.rest_shape(), std::move(deformation),
                                                             sequence.frame_duration(), options, noise);
  detector.selection() = options.selection;
  std::vector<Amf::Spatio_temporal_feature<Amf::Rest_shape::Index>> features;
  detector(std::back_inserter(features), visitor);
  for (const auto& feature : features) *out++ = Amf::place_on_animation(feature, sequence);
  return out;
}

} // namespace CGAL

#endif // CGAL_DETECT_SPATIO_TEMPORAL_FEATURES_H
