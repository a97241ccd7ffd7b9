// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_NEIGHBOURHOOD_SAMPLER_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_NEIGHBOURHOOD_SAMPLER_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Descriptors/Feature_neighbourhood.h>
#include <CGAL/Animated_mesh_features/Descriptors/internal/Log_map.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

Takes the samples of a field around a feature, see `Feature_neighbourhood`: at 127 places, on six rings up to
\f$3\,\sigma\f$, in a discrete exponential map of the rest shape \cgalCite{schmidt2006}, and 25 times from
\f$-3\,\tau\f$ to \f$3\,\tau\f$, whatever the mesh and the frame rate. Between frames the field is linear; beyond the
first and last one it is mirrored, or that of a loop goes on.

The value and the gradient on the surface are those of the linear function that fits the vertices within
\f$2\,\sigma\f$ best, each by its area times \f$(1 - d^2 / 4 \sigma^2)^2\f$ (moving least squares): smoothed at the
feature's own scale, as gradients of images are in descriptors \cgalCite{lowe2004}, for those of single triangles depend
on the mesh. Vertices up to \f$3.5\,\sigma\f$ from the feature count; the rings are turned to where the field is
larger. The gradient in time is the difference of the samples before and after; it is not smoothed, as \f$\tau\f$ is often
hardly more than a frame. A place without surface around it is left out.

Keeps a few numbers for each vertex; the objects that it is made of are kept by reference. A call takes
`O(k log k + 25 48 k)` for `k` vertices around the feature, each of which counts at 48 places, whatever the size of the
mesh and the number of frames.

\tparam FT `float` or `double`, the scalar of the field.
*/
template <class FT>
class Neighbourhood_sampler
{
public:
  /// samples for one \f$\tau\f$.
  static constexpr std::size_t samples_per_tau = 4;

  /*!
  refers to a field and the surface it is on.
  \param shape the surface at rest.
  \param field `N x F`, finite.
  \param frame_duration the time between two frames (s), positive.
  \param is_cyclic whether the last frame is followed by the first.
  \throw Option_error if the numbers of vertices differ, or the time between two frames is not positive.
  */
  Neighbourhood_sampler(const Rest_shape& shape, const Spatio_temporal_field<FT>& field, double frame_duration,
                        bool is_cyclic = false)
    : m_shape(&shape)
    , m_field(&field)
    , m_frame_duration(frame_duration)
    , m_is_cyclic(is_cyclic)
    , m_areas(vertex_areas(shape))
    , m_normals(internal::vertex_normals(shape))
    , m_log_map(shape, m_normals)
  {
    if (field.number_of_rows() != shape.number_of_vertices() || field.number_of_frames() == 0)
      throw Option_error("the field is " + std::to_string(field.number_of_rows()) + " x " +
                         std::to_string(field.number_of_frames()) + ", the rest shape has " +
                         std::to_string(shape.number_of_vertices()) + " vertices");
    if (!(frame_duration > 0)) throw Option_error("the time between two frames must be positive");
  }

  Neighbourhood_sampler(const Neighbourhood_sampler&) = delete;
  Neighbourhood_sampler& operator=(const Neighbourhood_sampler&) = delete;

  /// the samples around a feature; of it the vertex, the place in its triangle, the time, \f$\sigma\f$ and \f$\tau\f$
  /// are used.
  /// \throw Input_error if its vertex is not of the rest shape, or \f$\sigma\f$ or \f$\tau\f$ is not positive.
  Feature_neighbourhood operator()(const Feature_point& feature)
  {
    check(feature);
    const std::vector<Index>& reached =
        m_log_map.run(Index(feature.vertex_index), (Feature_neighbourhood::reach + margin) * feature.sigma);
    Feature_neighbourhood result;
    const std::ptrdiff_t half = std::ptrdiff_t(samples_per_tau * std::size_t(Feature_neighbourhood::reach));
    for (std::ptrdiff_t k = -half; k <= half; ++k) result.times.push_back(double(k) / double(samples_per_tau));
    find_samples(feature, reached, result.times.size());
    const double first = steepest_angle();
    for (int ring = 0; ring <= rings; ++ring) {
      const int places = (std::max)(6 * ring, 1);
      const double pi = 3.14159265358979323846, r = double(ring) / rings_per_sigma;
      for (int i = 0; i < places; ++i) {
        const double angle = first + 2 * pi * (i + 0.5 * (ring % 2)) / places;
        append(Place{r * std::cos(angle), r * std::sin(angle)}, result);
      }
    }
    return result;
  }

private:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;

  static constexpr int rings_per_sigma = 2, rings = 6;
  static constexpr double margin = 0.5; // paths along edges are longer than straight ones
  static constexpr double window = 2;   // sigma: how far vertices count at a place

  struct Place
  {
    double x = 0, y = 0;
  };

  // A vertex around the feature.
  struct Sample
  {
    double x, y, area;
  };

  void check(const Feature_point& f) const
  {
    if (f.vertex_index >= m_areas.size())
      throw Input_error("a feature is at vertex " + std::to_string(f.vertex_index) + ", the rest shape has " +
                        std::to_string(m_areas.size()) + " vertices");
    if (!(f.sigma > 0) || !(f.tau > 0))
      throw Input_error("the feature at vertex " + std::to_string(f.vertex_index) + " has sigma " +
                        std::to_string(f.sigma) + " and tau " + std::to_string(f.tau) + "; both must be positive");
  }

  // The refined place in the map around the feature's vertex; the vertex itself, if its triangle is not in the map.
  Place place_of(const Feature_point& f) const
  {
    Place place;
    const auto neighbours = m_shape->neighbours()[f.vertex_index];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = f.triangle[i];
      if (v == f.vertex_index) continue;
      if (!std::binary_search(neighbours.begin(), neighbours.end(), Index(v))) return Place();
      // not by the map, whose reach may be shorter than an edge
      const Point step = m_shape->points()[v] - m_shape->points()[f.vertex_index];
      const Index c = Index(f.vertex_index);
      place.x += f.barycentric_coordinates[i] * step.dot(m_log_map.first_axis(c));
      place.y += f.barycentric_coordinates[i] * step.dot(m_log_map.second_axis(c));
    }
    return place;
  }

  // The field at vertices, and at one time more at both ends, for differences.
  void find_samples(const Feature_point& f, const std::vector<Index>& reached, std::size_t times)
  {
    const Place centre = place_of(f);
    m_samples.clear();
    for (Index v : reached)
      m_samples.push_back({(m_log_map.x(v) - centre.x) / f.sigma, (m_log_map.y(v) - centre.y) / f.sigma,
                           m_areas[v] / (f.sigma * f.sigma)});
    m_width = times + 2;
    m_values.resize(reached.size() * m_width);
    for (std::size_t k = 0; k < m_width; ++k) {
      const double tau = (double(k) - double(m_width - 1) / 2) / double(samples_per_tau);
      const Interpolation at = interpolation((f.time + tau * f.tau) / m_frame_duration);
      for (std::size_t i = 0; i < reached.size(); ++i) {
        const FT* row = m_field->row(reached[i]);
        m_values[i * m_width + k] =
            float((1 - at.fraction) * double(row[at.frame]) + at.fraction * double(row[at.next]));
      }
    }
  }

  struct Interpolation
  {
    std::size_t frame, next;
    double fraction;
  };

  Interpolation interpolation(double frame) const
  {
    const std::size_t frames = m_field->number_of_frames();
    if (m_is_cyclic) {
      const double within = frame - std::floor(frame / double(frames)) * double(frames);
      const std::size_t before = (std::min)(std::size_t(within), frames - 1);
      return {before, (before + 1) % frames, (std::min)(within - double(before), 1.)};
    }
    const double last = double(frames - 1);
    if (last == 0) return {0, 0, 0};
    frame = std::abs(std::remainder(frame, 2 * last)); // mirrored at both ends
    const std::size_t before = (std::min)(std::size_t(frame), std::size_t(last) - 1);
    return {before, before + 1, frame - double(before)};
  }

  // Where the field is larger at the feature's time: the direction from which places are counted, so that they are the
  // same ones however the axes of the map lie.
  double steepest_angle() const
  {
    const double limit = Feature_neighbourhood::reach + margin;
    double sum = 0, mean = 0, x = 0, y = 0;
    const auto add = [&](const auto& what) {
      for (std::size_t i = 0; i < m_samples.size(); ++i) {
        const Sample& s = m_samples[i];
        const double far = (std::max)(1 - (s.x * s.x + s.y * s.y) / (limit * limit), 0.);
        what(s, s.area * far * far, double(m_values[i * m_width + m_width / 2]));
      }
    };
    add([&](const Sample&, double weight, double value) {
      sum += weight;
      mean += weight * value;
    });
    if (!(sum > 0)) return 0;
    mean /= sum;
    add([&](const Sample& s, double weight, double value) {
      x += weight * (value - mean) * s.x;
      y += weight * (value - mean) * s.y;
    });
    return std::atan2(y, x);
  }

  // The linear functions that fit best around a place, one for each time.
  void append(const Place& p, Feature_neighbourhood& result)
  {
    const double pi = 3.14159265358979323846;
    m_weights.clear();
    double sum = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
      const Sample& s = m_samples[i];
      const double squares = ((s.x - p.x) * (s.x - p.x) + (s.y - p.y) * (s.y - p.y)) / (window * window);
      if (squares >= 1) continue;
      const double weight = s.area * (1 - squares) * (1 - squares);
      m_weights.emplace_back(i, weight);
      sum += weight;
      x += weight * s.x;
      y += weight * s.y;
    }
    if (!(sum > 0)) return;
    x /= sum;
    y /= sum;
    double xx = 0, xy = 0, yy = 0;
    m_means.assign(m_width, 0);
    m_slopes_x.assign(m_width, 0);
    m_slopes_y.assign(m_width, 0);
    for (const auto& [i, weight] : m_weights) {
      const double u = m_samples[i].x - x, v = m_samples[i].y - y;
      xx += weight * u * u;
      xy += weight * u * v;
      yy += weight * v * v;
      const float* values = &m_values[i * m_width];
      for (std::size_t k = 0; k < m_width; ++k) {
        const double f = weight * double(values[k]);
        m_means[k] += f;
        m_slopes_x[k] += u * f;
        m_slopes_y[k] += v * f;
      }
    }
    const double least = 1e-9 * sum * window * window; // of vertices on a line there is no slope across it
    xx += least;
    yy += least;
    const double det = xx * yy - xy * xy;
    for (std::size_t k = 0; k < m_width; ++k) {
      const double u = m_slopes_x[k], v = m_slopes_y[k];
      m_slopes_x[k] = (yy * u - xy * v) / det;
      m_slopes_y[k] = (xx * v - xy * u) / det;
      m_means[k] = m_means[k] / sum + m_slopes_x[k] * (p.x - x) + m_slopes_y[k] * (p.y - y);
    }
    // the places share the plane equally; each has as much of the surface as there is around it
    const double share = pi / 3 / double(rings_per_sigma * rings_per_sigma);
    result.places.push_back({p.x, p.y, share * sum / (pi * window * window / 3)});
    const double per_tau = double(samples_per_tau) / 2;
    for (std::size_t k = 1; k + 1 < m_width; ++k) {
      result.values.push_back(float(m_means[k]));
      result.gradients.push_back(
          {{float(m_slopes_x[k]), float(m_slopes_y[k]), float((m_means[k + 1] - m_means[k - 1]) * per_tau)}});
    }
  }

  const Rest_shape* m_shape;
  const Spatio_temporal_field<FT>* m_field;
  double m_frame_duration;
  bool m_is_cyclic;
  std::vector<double> m_areas;
  std::vector<Point> m_normals;
  internal::Log_map m_log_map;
  std::vector<Sample> m_samples;
  std::vector<float> m_values; // of m_width times for each of m_samples
  std::size_t m_width = 0;
  std::vector<std::pair<std::size_t, double>> m_weights; // of samples at a place
  std::vector<double> m_means, m_slopes_x, m_slopes_y;   // m_width
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_NEIGHBOURHOOD_SAMPLER_H
