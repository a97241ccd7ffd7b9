// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_WITH_TEMPORAL_FILTER_H
#define DETECT_FEATURES_WITH_TEMPORAL_FILTER_H

#include "detect_features/Method_options.h"
#include "detect_features/Method_values.h"

#include <CGAL/Animated_mesh_features/Scale_space/Boundary_condition.h>
#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>

namespace Detect_features {

// Calls `use` with the temporal filter.
template <class Use>
auto with_temporal_filter(const Method_options& o, const Method_values& values, const Use& use)
{
  namespace AMF = CGAL::Animated_mesh_features;
  const AMF::Boundary_condition ends =
      o.is_cyclic ? AMF::Boundary_condition::PERIODIC : AMF::Boundary_condition::REFLECT;
  return o.temporal_filter == Temporal_filter::BOX ? use(AMF::Box_temporal_filter(values.box_width, ends))
                                                   : use(AMF::Gaussian_temporal_filter(ends));
}

} // namespace Detect_features

#endif // DETECT_FEATURES_WITH_TEMPORAL_FILTER_H
