// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_IS_PERIODIC_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_IS_PERIODIC_H

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

template <class TemporalFilter, class = void>
struct Tells_is_periodic : std::false_type
{
};
template <class TemporalFilter>
struct Tells_is_periodic<TemporalFilter, std::void_t<decltype(std::declval<const TemporalFilter&>().is_periodic())>>
  : std::true_type
{
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

whether a temporal filter joins the ends of a row: after the last frame comes the first, as of a cyclic animation. `false` if
it does not tell.

\tparam TemporalFilter a model of the concept of this name.
\sa `Boundary_condition::PERIODIC`
*/
template <class TemporalFilter>
bool is_periodic(const TemporalFilter& filter)
{
  if constexpr (internal::Tells_is_periodic<TemporalFilter>::value)
    return filter.is_periodic();
  else
    return (void)filter, false;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_IS_PERIODIC_H
