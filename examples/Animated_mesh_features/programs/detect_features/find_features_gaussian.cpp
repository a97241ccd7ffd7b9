// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/find_features_with.h"

namespace Detect_features {

Search_result find_features(Search search, const AMF::Gaussian_temporal_filter& filter,
                            const AMF::Fixed_ratio_sampling& sampling)
{
  return find_features_with<AMF::Central_difference_of_gaussians>(search, filter, sampling);
}

Search_result find_features(Search search, const AMF::Gaussian_temporal_filter& filter,
                            const AMF::Every_smoothing_count& sampling)
{
  return find_features_with<AMF::Forward_difference_of_gaussians>(search, filter, sampling);
}

} // namespace Detect_features
