// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_DESCRIBE_FEATURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_DESCRIBE_FEATURES_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Descriptors/Gradient_histograms.h>
#include <CGAL/Animated_mesh_features/Descriptors/Neighbourhood_sampler.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

The descriptors of a list of features: `M x L` numbers, those of a feature next to one another, in the order of the
features.
*/
class Feature_descriptors
{
public:
  /// none.
  Feature_descriptors() = default;

  /// `size` descriptors of `length` zeros.
  Feature_descriptors(std::size_t size, std::size_t length)
    : m_size(size)
    , m_length(length)
    , m_values(size * length, 0.f)
  {}

  std::size_t size() const { return m_size; }     ///< `M`
  std::size_t length() const { return m_length; } ///< `L`

  float* operator[](std::size_t i) { return m_values.data() + i * m_length; }             ///< the `i`-th, `L` numbers
  const float* operator[](std::size_t i) const { return m_values.data() + i * m_length; } ///< the same, to look at

private:
  std::size_t m_size = 0, m_length = 0;
  std::vector<float> m_values;
};

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

the Euclidean distance between two descriptors of the same length; of the histograms of the package, whose length is 1
and whose numbers are not negative, it is between 0 and \f$\sqrt2\f$.
*/
inline double descriptor_distance(const float* a, const float* b, std::size_t length)
{
  double squares = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const double d = double(a[i]) - double(b[i]);
    squares += d * d;
  }
  return std::sqrt(squares);
}

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

describes features by what the field around them is like.

Linear in the number of samples around all features, see `Neighbourhood_sampler`; `O(N)` memory for each thread.

\tparam FT `float` or `double`, the scalar of the field.
\tparam Descriptor a model of `FeatureDescriptor`.
\tparam Loop a model of `TaskLoop`.
\param shape the surface at rest.
\param field in which the features were found, `N x F`: not another one, as of what is described the field is all.
\param frame_duration the time between two frames (s).
\param features are described in their order.
\param descriptor by what.
\param loop runs the tasks, one for each feature.
\param is_cyclic whether the last frame is followed by the first.
\throw Input_error if a feature does not belong to the shape; Option_error if the field does not.
*/
template <class FT, class Descriptor, class Loop>
Feature_descriptors describe_features(const Rest_shape& shape, const Spatio_temporal_field<FT>& field,
                                      double frame_duration, const std::vector<Feature_point>& features,
                                      const Descriptor& descriptor, const Loop& loop, bool is_cyclic = false)
{
  Feature_descriptors result(features.size(), descriptor.length());
  internal::Thread_local<Neighbourhood_sampler<FT>> samplers;
  loop(features.size(), [&](std::size_t i) {
    Neighbourhood_sampler<FT>& sampler = samplers.get(
        [&] { return std::make_unique<Neighbourhood_sampler<FT>>(shape, field, frame_duration, is_cyclic); });
    descriptor(sampler(features[i]), result[i]);
  });
  return result;
}

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

the same on all threads, without progress, by default with `Rotation_free_gradient_histogram`.
*/
template <class FT, class Descriptor = Rotation_free_gradient_histogram>
Feature_descriptors describe_features(const Rest_shape& shape, const Spatio_temporal_field<FT>& field,
                                      double frame_duration, const std::vector<Feature_point>& features,
                                      const Descriptor& descriptor = Descriptor())
{
  return describe_features(shape, field, frame_duration, features, descriptor, [](std::size_t n, const auto& task) {
    parallel_for<CGAL::Parallel_if_available_tag>(0, n, task);
  });
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_DESCRIBE_FEATURES_H
