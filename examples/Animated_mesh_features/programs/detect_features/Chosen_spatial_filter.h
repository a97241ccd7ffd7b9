// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CHOSEN_SPATIAL_FILTER_H
#define DETECT_FEATURES_CHOSEN_SPATIAL_FILTER_H

#include "reading/Values.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace Detect_features {

namespace AMF = CGAL::Animated_mesh_features;

// A spatial filter of which the kind is chosen when the program runs: a model of SpatialFilter for the types of this
// program. It is asked for whole levels: finding the alternative costs nothing beside that, and each alternative is compiled
// once, whatever the number of searches. (Not so for temporal filters, which the search compiles into its inner loop.)
class Chosen_spatial_filter
{
  typedef std::variant<AMF::Heat_diffusion_filter, AMF::One_ring_average_filter> Filter;
  typedef AMF::Task_loop<CGAL::Parallel_if_available_tag, AMF::Any_visitor> Loop;

public:
  explicit Chosen_spatial_filter(Filter filter = AMF::Heat_diffusion_filter())
    : m_filter(std::move(filter))
  {}

  double unit_variance(const AMF::Rest_shape& shape) const;
  double smallest_variance(const AMF::Rest_shape& shape) const;
  void initialize(const AMF::Rest_shape& shape, const std::vector<double>& variances, const Loop& loop);
  double variance(std::size_t k) const;
  double variance(std::size_t k, std::size_t v) const;
  void operator()(std::size_t k, const Programs::Values& in, Programs::Values& out, const Loop& loop);

private:
  Filter m_filter;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_CHOSEN_SPATIAL_FILTER_H
