// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_FILTER_TRAITS_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_FILTER_TRAITS_H

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Whether a temporal filter takes rows of several vertices at once.
template <class Filter, class = void>
struct Is_vectorized_filter : std::false_type
{
};
template <class Filter>
struct Is_vectorized_filter<Filter, std::enable_if_t<Filter::vectorized>> : std::true_type
{
};

// Whether a temporal filter tells its weights by distance.
template <class Filter, class = void>
struct Has_weights_by_distance : std::false_type
{
};
template <class Filter>
struct Has_weights_by_distance<Filter, std::void_t<decltype(std::declval<const Filter&>().weights_by_distance(0))>>
  : std::true_type
{
};

// Whether a temporal filter does to a row that is turned round the same as to the row, to the last bit.
template <class Filter, class = void>
struct Is_mirror_symmetric : std::false_type
{
};
template <class Filter>
struct Is_mirror_symmetric<Filter, std::enable_if_t<Filter::is_mirror_symmetric>> : std::true_type
{
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_TEMPORAL_FILTER_TRAITS_H
