// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_RESPONSE_EXTREMUM_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_RESPONSE_EXTREMUM_H

#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesExtrema

An extremum of the response, refined between the samples: where, when and at which scales. Lengths are in the unit of the
rest shape, times in seconds from the first frame.
*/
struct Response_extremum
{
  std::size_t vertex = 0;   ///< at which the response is extremal, from 0
  std::size_t frame = 0;    ///< likewise, from 0
  double refined_frame = 0; ///< between frames; within 1/2 of `frame`, where ends are joined perhaps across them; in [0, F)

  std::array<std::size_t, 3> triangle = {{0, 0, 0}};           ///< vertices of a triangle at `vertex`; all three are `vertex` if it has none
  std::array<double, 3> barycentric_coordinates = {{1, 0, 0}}; ///< of the place in it

  double sigma = 0;            ///< the spatial scale (length)
  double tau = 0;              ///< the temporal scale (s)
  double response = 0;         ///< the extremal value
  double amplitude = 0;        ///< of the Gaussian event that gives it, in the unit of the field, if the response knows; else `-response`
  bool at_scale_limit = false; ///< found at the smallest or largest searched `sigma` or `tau`
};

/*!
\ingroup PkgAnimatedMeshFeaturesExtrema

What `find_response_extrema()` returns.
*/
struct Response_extrema
{
  std::vector<Response_extremum> extrema; ///< in no particular order, but always in the same
  bool has_amplitudes = false;            ///< whether the response knows the amplitudes of events
  std::vector<double> sigma_levels;       ///< the \f$\sigma\f$ of all space levels (length)
  std::vector<double> tau_levels;         ///< the \f$\tau\f$ of all time levels (s)
  Scale_fade sigma_fade;                  ///< how much an extremum counts by its \f$\sigma\f$, see `Scale_levels`
  Scale_fade tau_fade;                    ///< likewise by its \f$\tau\f$
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_RESPONSE_EXTREMUM_H
