// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_INSTANCES_INL
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_INSTANCES_INL

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Extrema/Extremum_options.h>
#include <CGAL/Animated_mesh_features/Extrema/Response_extremum.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Difference_cascade.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Level_cascade.h>
#include <CGAL/Animated_mesh_features/Extrema/internal/Vectorized_candidate_detector.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Scale_space/Box_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Planar_normalization.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

// Included by the header that defines what is declared here, and by `src/`; not on its own.
//
// What the compiled library has of this room: declared here, so that nobody else compiles it, defined in `src/`. The
// candidate detectors of the package's temporal filters, whatever the other policies; searches with the policies of both
// presets, `float` and `double`.
#define CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(...)                                                         \
  template void Vectorized_candidate_detector<__VA_ARGS__>::operator()(std::size_t, std::size_t,                   \
                                                                       std::vector<Candidate>&) const

#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(FT, Options)                                                  \
  template Response_extrema find_response_extrema<CGAL::Parallel_if_available_tag>(                                \
      const Rest_shape&, const Spatio_temporal_field<FT>&, double, Options, double, Any_visitor)

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

typedef Extremum_options<> Calibrated_search;
typedef Extremum_options<One_ring_average_filter, Box_temporal_filter, Every_smoothing_count,
                         Forward_difference_of_gaussians, Difference_of_gaussians_minima, Planar_normalization>
    Published_search;

extern CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(Difference_cascade<Gaussian_temporal_filter>);
extern CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(Level_cascade<float, Gaussian_temporal_filter>);
extern CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(Level_cascade<double, Gaussian_temporal_filter>);
extern CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(Difference_cascade<Box_temporal_filter>);
extern CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(Level_cascade<float, Box_temporal_filter>);
extern CGAL_ANIMATED_MESH_FEATURES_DETECTOR_INSTANCE(Level_cascade<double, Box_temporal_filter>);

} // namespace internal

extern CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(double, internal::Calibrated_search);
extern CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(float, internal::Calibrated_search);
extern CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(double, internal::Published_search);
extern CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INSTANCE(float, internal::Published_search);

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_INTERNAL_INSTANCES_INL
