// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/Chosen_spatial_filter.h"

namespace Detect_features {

double Chosen_spatial_filter::unit_variance(const AMF::Rest_shape& shape) const
{
  return std::visit([&](const auto& filter) { return filter.unit_variance(shape); }, m_filter);
}

double Chosen_spatial_filter::smallest_variance(const AMF::Rest_shape& shape) const
{
  return std::visit([&](const auto& filter) { return filter.smallest_variance(shape); }, m_filter);
}

void Chosen_spatial_filter::initialize(const AMF::Rest_shape& shape, const std::vector<double>& variances,
                                       const Loop& loop)
{
  std::visit([&](auto& filter) { filter.initialize(shape, variances, loop); }, m_filter);
}

double Chosen_spatial_filter::variance(std::size_t k) const
{
  return std::visit([&](const auto& filter) { return filter.variance(k); }, m_filter);
}

double Chosen_spatial_filter::variance(std::size_t k, std::size_t v) const
{
  return std::visit([&](const auto& filter) { return filter.variance(k, v); }, m_filter);
}

void Chosen_spatial_filter::operator()(std::size_t k, const Programs::Values& in, Programs::Values& out,
                                       const Loop& loop)
{
  std::visit([&](auto& filter) { filter(k, in, out, loop); }, m_filter);
}

} // namespace Detect_features
