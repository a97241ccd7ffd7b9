// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_SUBTRACT_BASELINE_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_SUBTRACT_BASELINE_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

The least value of a vertex over the clip, the default; a model of `Baseline`.

An elbow that is bent all the time and bends a little more has a deformation that is high all the time. What never changes
hides what does: the difference in space outweighs the one in time, and the response has no minimum in \f$\tau\f$ at all.
What is left without it is what happens.

\cgalModels{Baseline}
*/
struct Least_value_baseline
{
  /// the least of `number_of_frames` values.
  template <class FT>
  FT operator()(const FT* row, std::size_t number_of_frames) const
  {
    return *std::min_element(row, row + number_of_frames);
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

Zero: the field stays as it was measured, as in the paper; a model of `Baseline`.

\cgalModels{Baseline}
*/
struct No_baseline
{
  /// 0
  template <class FT>
  FT operator()(const FT*, std::size_t) const
  {
    return FT(0);
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

subtracts from all values of each vertex a value that does not depend on time. `O(N F)`.

\param field `N x F`, with at least one frame.
\param baseline a model of `Baseline`.
*/
template <class FT, class Baseline>
void subtract_baseline(Spatio_temporal_field<FT>& field, const Baseline& baseline)
{
  const std::size_t frames = field.number_of_frames();
  for (std::size_t v = 0; v < field.number_of_rows(); ++v) {
    FT* const row = field.row(v);
    const FT base = baseline(static_cast<const FT*>(row), frames);
    for (std::size_t f = 0; f < frames; ++f) row[f] -= base;
  }
}

/// \cond SKIP_IN_MANUAL
template <class FT>
void subtract_baseline(Spatio_temporal_field<FT>&, const No_baseline&)
{}
/// \endcond

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_SUBTRACT_BASELINE_H
