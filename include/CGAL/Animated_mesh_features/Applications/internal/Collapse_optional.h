// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_COLLAPSE_OPTIONAL_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_COLLAPSE_OPTIONAL_H

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
  #include <optional>
#else
  #include <boost/optional.hpp>
#endif

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// what CGAL's simplification takes and returns
#if CGAL_VERSION_NR >= 1060000000
template <class T>
using Collapse_optional = std::optional<T>;
#else
template <class T>
using Collapse_optional = boost::optional<T>;
#endif

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_COLLAPSE_OPTIONAL_H
