// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/Chosen_normalization.h"

#include <CGAL/Animated_mesh_features/Scale_space/Heat_kernel_normalization.h>

namespace Detect_features {

std::vector<float>
Chosen_normalization::operator()(const AMF::Rest_shape& shape, const std::vector<double>& variances,
                                 const AMF::Task_loop<CGAL::Parallel_if_available_tag, AMF::Any_visitor>& loop) const
{
  if (!is_of_surface) return {};
  return AMF::Heat_kernel_normalization()(shape, variances, loop);
}

} // namespace Detect_features
