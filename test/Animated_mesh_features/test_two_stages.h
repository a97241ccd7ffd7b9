// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_TEST_TWO_STAGES_H
#define CGAL_ANIMATED_MESH_FEATURES_TEST_TWO_STAGES_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Detection/Detection_options.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_support {

// A whole detection that can be asked again: the measurement of an animation, the detector of its deformation as soon as
// that is there, and features on the mesh. What was done before an exception is not done again.
template <class Animation, class Options = CGAL::Animated_mesh_features::Calibrated_options,
          class ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Two_stages
{
public:
  typedef CGAL::Animated_mesh_features::Deformation_measurement<Animation, Options, ConcurrencyTag> Measurement;
  typedef CGAL::Animated_mesh_features::Feature_detector<typename Animation::FT, Options, ConcurrencyTag> Detector;
  typedef CGAL::Animated_mesh_features::Frame_sequence<typename Animation::Triangle_mesh, typename Animation::FT>
      Sequence;
  typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<typename Sequence::vertex_descriptor> Feature;

  explicit Two_stages(const Animation& animation, const Options& options = Options())
    : m_measurement(animation, options)
    , m_selection(options.selection)
  {}
  Two_stages(const Two_stages&) = delete;
  Two_stages& operator=(const Two_stages&) = delete;

  Measurement& measurement() { return m_measurement; }
  const Sequence& sequence() const { return m_measurement.sequence(); }
  CGAL::Animated_mesh_features::Feature_selection& selection() { return m_selection; }
  std::size_t number_of_minima() const { return m_detector ? m_detector->number_of_minima() : 0; }

  template <class OutputIterator, class Visitor>
  OutputIterator operator()(OutputIterator out, Visitor& visitor)
  {
    if (!m_detector) {
      typename Measurement::Field field = m_measurement.deformation(visitor);
      CGAL::Animated_mesh_features::subtract_baseline(field, m_measurement.options().baseline);
      m_detector.emplace(sequence().rest_shape(), std::move(field), sequence().frame_duration(), m_measurement.options(),
                         m_measurement.noise());
    }
    m_detector->selection() = m_selection;
    std::vector<typename Detector::Feature> features;
    (*m_detector)(std::back_inserter(features), visitor);
    for (const auto& feature : features) *out++ = CGAL::Animated_mesh_features::place_on_animation(feature, sequence());
    return out;
  }

  template <class OutputIterator>
  OutputIterator operator()(OutputIterator out)
  {
    CGAL::Animated_mesh_features::Default_visitor visitor;
    return operator()(out, visitor);
  }

private:
  Measurement m_measurement;
  CGAL::Animated_mesh_features::Feature_selection m_selection;
  std::optional<Detector> m_detector;
};

template <class Some_detector>
std::vector<typename std::decay_t<Some_detector>::Feature> detect_with(Some_detector&& detector)
{
  std::vector<typename std::decay_t<Some_detector>::Feature> features;
  detector(std::back_inserter(features));
  return features;
}

// The same features, bit for bit.
template <class Feature>
bool same(const std::vector<Feature>& a, const std::vector<Feature>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Feature& f, const Feature& g) {
    const auto members = [](const Feature& x) {
      return std::tie(x.vertex, x.vertex_index, x.frame, x.time, x.refined_frame, x.triangle, x.barycentric_coordinates,
                      x.position, x.rest_position, x.sigma, x.tau, x.response, x.at_scale_limit);
    };
    return members(f) == members(g);
  });
}

} // namespace test_support

#endif // CGAL_ANIMATED_MESH_FEATURES_TEST_TWO_STAGES_H
