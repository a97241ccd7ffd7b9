// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_DISJOINT_SETS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Sets of the numbers from 0, over two arrays. Not over pointers, which are property maps as well: where Boost's compressed
// graphs were included before, boost::detail has a get() of its own, and clang finds none for pointers.
typedef boost::iterator_property_map<std::size_t*, boost::typed_identity_property_map<std::size_t>, std::size_t,
                                     std::size_t&>
    Disjoint_set_map;
typedef boost::disjoint_sets<Disjoint_set_map, Disjoint_set_map> Disjoint_sets;

inline Disjoint_sets disjoint_sets(std::size_t* ranks, std::size_t* parents)
{
  return Disjoint_sets(Disjoint_set_map(ranks), Disjoint_set_map(parents));
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_DISJOINT_SETS_H
