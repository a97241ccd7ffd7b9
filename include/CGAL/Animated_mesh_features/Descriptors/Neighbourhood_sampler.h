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
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

Takes the samples of a field around a feature, see `Feature_neighbourhood`: the vertices within \f$3\,\sigma\f$ on the
rest shape, by a discrete exponential map \cgalCite{schmidt2006}, and 25 times from \f$-3\,\tau\f$ to \f$3\,\tau\f$,
whatever the frame rate; between frames the field is linear, beyond the first and last one it is mirrored. The gradient
on the surface is the mean of the triangles' around a vertex, by area; that in time is the difference of the samples
before and after.

Keeps a few numbers for each vertex; the objects that it is made of are kept by reference. A call takes
`O(k log k + 25 k)` for `k` vertices around the feature, whatever the size of the mesh and the number of frames.

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
  \throw Option_error if the numbers of vertices differ, or the time between two frames is not positive.
  */
  Neighbourhood_sampler(const Rest_shape& shape, const Spatio_temporal_field<FT>& field, double frame_duration)
    : m_shape(&shape)
    , m_field(&field)
    , m_frame_duration(frame_duration)
    , m_areas(vertex_areas(shape))
    , m_normals(internal::vertex_normals(shape))
    , m_log_map(shape, m_normals)
    , m_row_of(shape.number_of_vertices(), none)
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
    const Place centre = place_of(feature);
    std::vector<Index> inside;
    for (Index v : reached) {
      const double x = (m_log_map.x(v) - centre.x) / feature.sigma, y = (m_log_map.y(v) - centre.y) / feature.sigma;
      if (std::hypot(x, y) > Feature_neighbourhood::reach) continue;
      inside.push_back(v);
      result.vertices.push_back({x, y, m_areas[v] / (feature.sigma * feature.sigma)});
    }
    sample(feature, inside, result.times.size());
    for (Index v : inside) append(feature, v, result);
    for (Index v : m_sampled) m_row_of[v] = none;
    return result;
  }

private:
  typedef Rest_shape::Index Index;
  typedef Rest_shape::Point Point;

  static constexpr std::size_t none = std::size_t(-1);
  static constexpr double margin = 0.5; // paths along edges are longer than straight ones

  struct Place
  {
    double x = 0, y = 0;
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

  // The field at vertices and their neighbours, and at one time more at both ends, for differences.
  void sample(const Feature_point& f, const std::vector<Index>& inside, std::size_t times)
  {
    m_sampled.clear();
    const auto add = [&](Index v) {
      if (m_row_of[v] != none) return;
      m_row_of[v] = m_sampled.size();
      m_sampled.push_back(v);
    };
    for (Index v : inside) {
      add(v);
      for (Index w : m_shape->neighbours()[v]) add(w);
    }
    m_width = times + 2;
    m_samples.resize(m_sampled.size() * m_width);
    for (std::size_t k = 0; k < m_width; ++k) {
      const double tau = (double(k) - double(m_width - 1) / 2) / double(samples_per_tau);
      const Interpolation at = interpolation((f.time + tau * f.tau) / m_frame_duration);
      for (std::size_t i = 0; i < m_sampled.size(); ++i) {
        const FT* row = m_field->row(m_sampled[i]);
        m_samples[i * m_width + k] =
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
    const double last = double(m_field->number_of_frames() - 1);
    if (last == 0) return {0, 0, 0};
    frame = std::abs(std::remainder(frame, 2 * last)); // mirrored at both ends
    const std::size_t before = (std::min)(std::size_t(frame), std::size_t(last) - 1);
    return {before, before + 1, frame - double(before)};
  }

  void append(const Feature_point& f, Index v, Feature_neighbourhood& result)
  {
    find_differences(v);
    const float* own = &m_samples[m_row_of[v] * m_width];
    const float sigma = float(f.sigma), per_tau = float(samples_per_tau) / 2;
    for (std::size_t k = 1; k + 1 < m_width; ++k) {
      float x = 0, y = 0;
      for (const Difference& d : m_differences) {
        const float value = m_samples[d.row * m_width + k];
        x += d.x * value;
        y += d.y * value;
      }
      result.values.push_back(own[k]);
      result.gradients.push_back({{x * sigma, y * sigma, (own[k + 1] - own[k - 1]) * per_tau}});
    }
  }

  // How much the value of a vertex counts in the gradient of another one.
  struct Difference
  {
    std::size_t row;
    float x, y;
  };

  // The gradient of a linear function on a triangle is the sum of n x e over the doubled area, times the values of the
  // corners, where e is the edge opposite of the corner; means by area over the triangles around v.
  void find_differences(Index v)
  {
    m_differences.clear();
    double area = 0;
    for (Index t : m_shape->incident_triangles()[v]) area += m_shape->areas()[t];
    if (!(area > 0)) return;
    const Point& first = m_log_map.first_axis(v);
    const Point second = m_log_map.second_axis(v);
    for (Index t : m_shape->incident_triangles()[v]) {
      const Rest_shape::Triangle& c = m_shape->triangles()[t];
      const double doubled = 2 * m_shape->areas()[t];
      if (!(doubled > 0)) continue;
      const auto point = [&](std::size_t i) -> const Point& { return m_shape->points()[c[i % 3]]; };
      const Point n = (point(1) - point(0)).cross(point(2) - point(0)) / doubled;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point g = n.cross(point(i + 2) - point(i + 1)) / doubled * (doubled / 2 / area);
        m_differences.push_back({m_row_of[c[i]], float(g.dot(first)), float(g.dot(second))});
      }
    }
  }

  const Rest_shape* m_shape;
  const Spatio_temporal_field<FT>* m_field;
  double m_frame_duration;
  std::vector<double> m_areas;
  std::vector<Point> m_normals;
  internal::Log_map m_log_map;
  std::vector<std::size_t> m_row_of; // of m_samples, for each vertex
  std::vector<Index> m_sampled;
  std::vector<float> m_samples; // of m_width times for each of m_sampled
  std::size_t m_width = 0;
  std::vector<Difference> m_differences;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_NEIGHBOURHOOD_SAMPLER_H
