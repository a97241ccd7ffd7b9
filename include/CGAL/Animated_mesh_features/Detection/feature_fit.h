// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_FIT_H
#define CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_FIT_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

How well a field is described by a feature found in it, see `Feature_fit_measure`.
*/
struct Feature_fit
{
  /// the correlation of the field around the feature with the feature's Gaussian, from -1 to 1, less where a part of the
  /// disc is missing; 0 where one of them does not vary.
  double fit = 0;

  /// the area of the disc of radius \f$\sqrt2\,\sigma\f$ on the surface over that of a flat one, \f$2\pi\sigma^2\f$: near 1
  /// where a blob of this size is a patch of a surface, small where it takes in all of a limb or a tip.
  double area_ratio = 0;
};

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

Measures how well a field is described by features found in it.

A feature at vertex \f$v_0\f$ and time \f$t_0\f$ says that the field around it looks like
\f$g(v, t) = e^{-d(v)^2/2\sigma^2}\,e^{-(t-t_0)^2/2\tau^2}\f$, up to a factor and a constant, where \f$d(v)\f$ is the length
of the shortest path along edges of the rest shape from \f$v_0\f$ to \f$v\f$. Its fit is the correlation of the field with
\f$g\f$ over the vertices with \f$d \le 2.5\,\sigma\f$ and the frames with \f$|t - t_0| \le 2.5\,\tau\f$, each sample weighted
by the area of its vertex: 1 for a Gaussian event, near 0 for a place whose field has nothing of one. Where \f$\tau\f$ is
`frames_per_tau` frames or more, times n, only every n-th frame is compared, counted from that of the feature: a Gaussian is
told by a thousand frames as well as by all of them.

A cyclic animation goes on on either side of its frames.

The fit is that of the vertex and not of the refined place, from which it differs by less than an edge.

Where the surface has less than half of the flat disc that a blob of this size claims, as at the tip of a leg that is thinner
than \f$\sigma\f$, the correlation is multiplied by \f$2A/(2\pi\sigma^2)\f$, A the area of the disc of radius
\f$\sqrt2\,\sigma\f$ on the surface: a foot that stretches as a whole is no blob as large as the leg. Half of a disc is
left at a border; paths along edges are longer than straight ones, by which it is a bit less. Of the features of people's
bodies none has as little.

Keeps `N` distances; the objects that it is made of are kept by reference. For `k` vertices around a feature and `m` frames,
of which there are at most some 2,560, whatever \f$\tau\f$, a call takes `O(k log k + k m)`.

\tparam FT `float` or `double`, the scalar of the field.
*/
template <class FT>
class Feature_fit_measure
{
public:
  /// within how many \f$\sigma\f$ and \f$\tau\f$ of a feature the field is compared: beyond, the Gaussian is below 5 % of
  /// its height.
  static constexpr double reach = 2.5;

  /// at least that many frames for a \f$\tau\f$ are compared, unless it has fewer: so all of them in rows of up to 1,024
  /// frames, whose \f$\tau\f$ is a third of the duration at most by default.
  static constexpr double frames_per_tau = 256;

  /// the `Feature_fit::area_ratio` below which a feature's fit is less in proportion: what is left of a disc at a border.
  static constexpr double least_area_ratio = 0.5;

  /*!
  refers to a field and the surface it is on.
  \param shape the surface at rest.
  \param areas of its `N` vertices, see `vertex_areas()`.
  \param field `N x F`, finite.
  \param frame_duration the time between two frames (s), positive.
  \param is_cyclic whether the last frame is followed by the first.
  \throw Option_error if the numbers of vertices differ or the time between two frames is not positive.
  */
  Feature_fit_measure(const Rest_shape& shape, const std::vector<double>& areas, const Spatio_temporal_field<FT>& field,
                      double frame_duration, bool is_cyclic = false)
    : m_areas(&areas)
    , m_field(&field)
    , m_frame_duration(frame_duration)
    , m_is_cyclic(is_cyclic)
    , m_paths(shape)
  {
    const std::size_t n = shape.number_of_vertices();
    if (field.number_of_rows() != n || areas.size() != n)
      throw Option_error("the field has " + std::to_string(field.number_of_rows()) + " rows, there are " +
                         std::to_string(areas.size()) + " areas, and the rest shape has " + std::to_string(n) +
                         " vertices");
    if (!(frame_duration > 0)) throw Option_error("the time between two frames must be positive");
  }

  /// measures a feature; of it the vertex, the time, \f$\sigma\f$ and \f$\tau\f$ are used.
  /// \throw Input_error if its vertex is not of the rest shape, or \f$\sigma\f$ or \f$\tau\f$ is not positive.
  Feature_fit operator()(const Feature_point& feature)
  {
    check(feature);
    const std::vector<Rest_shape::Index>& around =
        m_paths.run(std::array<Rest_shape::Index, 1>{{Rest_shape::Index(feature.vertex_index)}}, reach * feature.sigma);
    measure_disc(feature, around);
    if (m_is_cyclic)
      measure_frames_around(feature);
    else
      measure_frames(feature);
    Feature_fit result;
    result.area_ratio = m_disc_area / (2 * 3.14159265358979323846 * feature.sigma * feature.sigma);
    if (m_area > 0 && !m_in_time.values.empty())
      result.fit = correlation(around) * (std::min)(1., result.area_ratio / least_area_ratio);
    return result;
  }

private:
  // One of the two factors of the Gaussian: its values, their weighted mean and variance.
  struct Factor
  {
    std::vector<double> values;
    double mean = 0, variance = 0;

    double mean_of_squares() const { return variance + mean * mean; }
  };

  void check(const Feature_point& f) const
  {
    if (f.vertex_index >= m_areas->size())
      throw Input_error("a feature is at vertex " + std::to_string(f.vertex_index) + ", the rest shape has " +
                        std::to_string(m_areas->size()) + " vertices");
    if (!(f.sigma > 0) || !(f.tau > 0))
      throw Input_error("the feature at vertex " + std::to_string(f.vertex_index) + " has sigma " +
                        std::to_string(f.sigma) + " and tau " + std::to_string(f.tau) + "; both must be positive");
  }

  static double gaussian(double x, double deviation) { return std::exp(-x * x / (2 * deviation * deviation)); }

  // The Gaussian in space, weighted by area, and the area within the feature's radius.
  void measure_disc(const Feature_point& f, const std::vector<Rest_shape::Index>& around)
  {
    m_in_space.values.clear();
    m_area = m_disc_area = 0;
    double sum = 0;
    for (Rest_shape::Index v : around) {
      const double d = m_paths.distance(v), area = (*m_areas)[v];
      m_in_space.values.push_back(gaussian(d, f.sigma));
      m_area += area;
      sum += area * m_in_space.values.back();
      if (d <= f.radius()) m_disc_area += area;
    }
    m_in_space.mean = m_area > 0 ? sum / m_area : 0;
    double squares = 0;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const double x = m_in_space.values[i] - m_in_space.mean;
      squares += (*m_areas)[around[i]] * x * x;
    }
    m_in_space.variance = m_area > 0 ? squares / m_area : 0;
  }

  // The Gaussian in time; all frames that are compared weigh the same.
  void measure_frames(const Feature_point& f)
  {
    const auto time = [&](std::size_t frame) { return double(frame) * m_frame_duration - f.time; };
    m_in_time.values.clear();
    const std::size_t frames = m_field->number_of_frames();
    const double middle = f.time / m_frame_duration, tau = f.tau / m_frame_duration;
    const auto frame_at = [&](double x) { return std::size_t((std::min)(double(frames), (std::max)(0., x))); };
    m_step = frame_at((std::max)(1., tau / frames_per_tau));
    // one more on either side, as these are rounded
    std::size_t first = frame_at(middle - reach * tau - 1);
    first += (frame_at(middle + 0.5) - first) % m_step;
    const std::size_t last = frame_at(middle + reach * tau + 2);
    double sum = 0;
    for (std::size_t m = first; m < last; m += m_step) {
      if (!(std::abs(time(m)) <= reach * f.tau)) continue;
      if (m_in_time.values.empty()) m_first_frame = m;
      m_in_time.values.push_back(gaussian(time(m), f.tau));
      sum += m_in_time.values.back();
    }
    measure_moments(sum);
  }

  // The same in an animation that goes on on either side.
  void measure_frames_around(const Feature_point& f)
  {
    m_in_time.values.clear();
    m_compared.clear();
    const double middle = f.time / m_frame_duration, tau = f.tau / m_frame_duration,
                 frames = double(m_field->number_of_frames());
    const double step = std::floor((std::max)(1., tau / frames_per_tau)), nearest = std::floor(middle + 0.5);
    double sum = 0;
    for (double n = std::ceil((middle - reach * tau - nearest) / step - 1);
         n <= (middle + reach * tau - nearest) / step + 1; ++n) {
      const double frame = nearest + n * step, distance = frame * m_frame_duration - f.time;
      if (!(std::abs(distance) <= reach * f.tau)) continue;
      m_compared.push_back(
          (std::min)(std::size_t(frame - frames * std::floor(frame / frames)), m_field->number_of_frames() - 1));
      m_in_time.values.push_back(gaussian(distance, f.tau));
      sum += m_in_time.values.back();
    }
    measure_moments(sum);
  }

  // Of the Gaussian in time, whose values have that sum.
  void measure_moments(double sum)
  {
    const double n = (std::max)(1., double(m_in_time.values.size()));
    m_in_time.mean = sum / n;
    double squares = 0;
    for (double b : m_in_time.values) squares += (b - m_in_time.mean) * (b - m_in_time.mean);
    m_in_time.variance = squares / n;
  }

  // The frames of a vertex that are compared, each `m_step` after the one before.
  const FT* compared_frames(std::size_t v)
  {
    const FT* const row = m_field->row(v);
    if (!m_is_cyclic) return row + m_first_frame;
    m_gathered.resize(m_compared.size());
    for (std::size_t m = 0; m < m_compared.size(); ++m) m_gathered[m] = row[m_compared[m]];
    return m_gathered.data();
  }

  double correlation(const std::vector<Rest_shape::Index>& around)
  {
    const std::size_t frames = m_in_time.values.size();
    const double weight = 1 / (m_area * double(frames));
    double mean = 0;
    for (Rest_shape::Index v : around) {
      const FT* const x = compared_frames(v);
      double sum = 0;
      for (std::size_t m = 0; m < frames; ++m) sum += double(x[m * m_step]);
      mean += weight * (*m_areas)[v] * sum;
    }
    // The mean is rounded: what is left of it is taken out below.
    double left = 0, variance = 0, covariance = 0;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const FT* const x = compared_frames(around[i]);
      double sum = 0, squares = 0, products = 0;
      for (std::size_t m = 0; m < frames; ++m) {
        const double y = double(x[m * m_step]) - mean;
        sum += y;
        squares += y * y;
        products += y * m_in_time.values[m];
      }
      const double w = weight * (*m_areas)[around[i]];
      left += w * sum;
      variance += w * squares;
      covariance += w * products * m_in_space.values[i];
    }
    variance -= left * left;
    covariance -= left * m_in_space.mean * m_in_time.mean;
    const double rounding = 64 * std::numeric_limits<double>::epsilon() * mean; // of a field that is constant
    if (!(variance > rounding * rounding)) return 0;
    // of a product of two factors, without the difference of squares in which digits would cancel
    const double of_gaussian =
        m_in_space.variance * m_in_time.mean_of_squares() + m_in_space.mean * m_in_space.mean * m_in_time.variance;
    if (!(of_gaussian > 0)) return 0;
    return (std::max)(-1., (std::min)(1., covariance / (std::sqrt(variance) * std::sqrt(of_gaussian))));
  }

  const std::vector<double>* m_areas;
  const Spatio_temporal_field<FT>* m_field;
  double m_frame_duration;
  bool m_is_cyclic;
  internal::Bounded_dijkstra m_paths;

  // of the feature that is being measured
  Factor m_in_space, m_in_time;
  double m_area = 0, m_disc_area = 0;
  std::size_t m_first_frame = 0, m_step = 1; // the frames that are compared, each so many after the one before
  std::vector<std::size_t> m_compared;       // of a cyclic animation those frames themselves,
  std::vector<FT> m_gathered;                // and their values at a vertex, one after the other
};

/*!
\ingroup PkgAnimatedMeshFeaturesDetection

measures a single feature; for several, a `Feature_fit_measure` saves what they share.

\param shape, areas, field, frame_duration, is_cyclic see `Feature_fit_measure`.
\param feature a feature of the field.
\throw Option_error, Input_error as `Feature_fit_measure` does.
*/
template <class FT>
Feature_fit feature_fit(const Rest_shape& shape, const std::vector<double>& areas,
                        const Spatio_temporal_field<FT>& field, double frame_duration, const Feature_point& feature,
                        bool is_cyclic = false)
{
  return Feature_fit_measure<FT>(shape, areas, field, frame_duration, is_cyclic)(feature);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DETECTION_FEATURE_FIT_H
