// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_POINT_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_POINT_H

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

A spatio-temporal feature point: where, when, how large, how long and how strongly a surface deforms in a
distinctive way.

Lengths are in the unit of the mesh's coordinates, times in seconds from the first frame.

Everything that can be told without a mesh; `Spatio_temporal_feature` adds the mesh's own vertex.
*/
struct Feature_point
{
  /// the vertex at which the response is minimal: its rank in `vertices(mesh)`, from 0; its id in a file, its row in a
  /// `Spatio_temporal_field`.
  std::size_t vertex_index = 0;

  /// the frame at which the response is minimal, from 0.
  std::size_t frame = 0;

  /// the time of the minimum (seconds), refined between frames; within half a frame of `frame`. In a cyclic animation from 0
  /// to below the period, so that the first frame may have a time half a frame before the end.
  double time = 0;

  /// the same as a number of frames: `time` over the time between two frames.
  double refined_frame = 0;

  /// \name The place on the surface
  /// A point in a triangle incident to the vertex, in a form that holds for every frame: the ranks of its three
  /// vertices in `vertices(mesh)` and the barycentric coordinates (non-negative, sum 1). For a vertex without
  /// faces all three ranks are its own.
  /// @{
  std::array<std::size_t, 3> triangle = {{0, 0, 0}};           ///< ranks of vertices
  std::array<double, 3> barycentric_coordinates = {{1, 0, 0}}; ///< without unit
  /// @}

  /// the place on the animated surface at `time`, linear between frames (see `place_on_animation()`); that on the rest shape, if no animation is known
  /// (see `Feature_detector`).
  std::array<double, 3> position = {{0, 0, 0}};

  /// the place on the rest shape, on which `sigma` is measured.
  std::array<double, 3> rest_position = {{0, 0, 0}};

  /// the spatial scale \f$\sigma\f$ (length on the rest shape): standard deviation of the Gaussian blob that gives
  /// the strongest response at this scale.
  double sigma = 0;

  /// the temporal scale \f$\tau\f$ (seconds).
  double tau = 0;

  /// the scale-normalised space-time difference of Gaussians at the feature; negative. Its unit is the business of the
  /// `SpaceTimeResponse`.
  double response = 0;

  /// the amplitude, in the unit of the field, of the Gaussian event of this \f$\sigma\f$ and \f$\tau\f$ that gives the
  /// response: of a deformation, how much more than at its rest the surface is deformed there. It depends neither on the
  /// range of scales nor on the length of the clip nor on its frame rate.
  double amplitude = 0;

  /// the correlation of the field around the feature with the feature's Gaussian, see `Feature_fit`: 1 for a Gaussian
  /// event, near 0 for a place whose field has nothing of one.
  double fit = 1;

  /// by what features are sorted and selected: `amplitude` times `fit`, the part of the amplitude that the field bears
  /// out, in the unit of the field; less where the ranges of the scales begin, see `Scale_fade`. With a response that knows
  /// of no amplitude, such as the paper's, it is `-response`.
  double strength = 0;

  /// features at the same place, at whatever time, have the same number; that of the strongest feature is 0. The same
  /// place: nearer to the strongest feature there than the larger of the two sigmas, which are within a factor of 1.5.
  std::size_t place = 0;

  /// the rank of the strongest feature of another scale in which this one lies, in space and time; `none` if there is none.
  std::size_t parent = none;

  /// the `parent` of a feature that has none.
  static constexpr std::size_t none = std::size_t(-1);

  /// `true` if the feature was found at the smallest or largest searched \f$\sigma\f$ or \f$\tau\f$, as happens on
  /// bands and tubes, of which the scale runs away: its true scale may lie outside of the range.
  bool at_scale_limit = false;

  /// the radius \f$\sqrt2\,\sigma\f$ of the blob, at which a two-dimensional Gaussian's Laplacian changes sign.
  double radius() const { return std::sqrt(2.) * sigma; }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_POINT_H
