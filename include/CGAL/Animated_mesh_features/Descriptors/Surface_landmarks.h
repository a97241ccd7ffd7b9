// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_SURFACE_LANDMARKS_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_SURFACE_LANDMARKS_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

Tells where on a body a place is without a word about other bodies: by how much of the surface lies how far from it.

A number of landmarks are spread over the rest shape, each the vertex that is farthest from those before it
(farthest-point sampling, Gonzalez 1985), and each stands for the vertices nearest to it. Of them are known, for any
vertex \f$v\f$:
- the mean distance \f$e(v) = \sum_l a_l\,d(v,l) / (\ell \sum_l a_l)\f$ to all of the surface, in units of its own mean
  \f$\ell\f$ over the surface \cgalCite{hilaga2001}: some 0.7 in the middle of a body, 1.7 at the tips of its limbs;
- the profile, the shares of the surface within eight distances, from 0.15 to 2 \f$\ell\f$, of which small ones tell how
  thick the limb is and large ones how far out on it.

Neither changes when the body is moved, scaled or mirrored; a bend of a limb changes them little. Left and right are the
same. Distances are those along edges, and straight ones between components that are not connected.

`O(S N log N)` time, `4 S N` bytes for `S` landmarks.
*/
class Surface_landmarks
{
public:
  typedef Rest_shape::Index Index; ///< of a vertex

  /// the number of distances of a profile.
  static constexpr std::size_t profile_length = 8;

  /// spreads landmarks.
  /// \param shape the surface at rest; is kept by reference.
  /// \param count their number; on a body 64 give mean distances to within some 1 %. Fewer, if there are not as many
  ///   vertices.
  explicit Surface_landmarks(const Rest_shape& shape, std::size_t count = 64)
    : m_shape(&shape)
    , m_areas(vertex_areas(shape))
  {
    spread(count);
    weigh();
    measure();
  }

  /// the landmarks, in the order in which they were spread.
  const std::vector<Index>& vertices() const { return m_landmarks; }

  /// \f$\ell\f$, the mean distance between two points of the surface (length): a size of the body that does not depend
  /// on its pose.
  double mean_distance() const { return m_unit; }

  /// the area of each vertex (squared length), see `vertex_areas()`.
  const std::vector<double>& areas() const { return m_areas; }

  /// \f$e(v)\f$, without unit.
  double eccentricity(std::size_t v) const { return m_eccentricities[v]; }

  /// writes the profile of a vertex: `profile_length` numbers from 0 to 1, ascending.
  void profile(std::size_t v, float* out) const
  {
    const std::array<double, profile_length> radii = {{0.15, 0.3, 0.5, 0.75, 1, 1.3, 1.6, 2}};
    const double width = 0.1; // of the edge of a disc, so that a landmark does not fall in all at once
    for (std::size_t i = 0; i < radii.size(); ++i) {
      double sum = 0;
      for (std::size_t l = 0; l < m_landmarks.size(); ++l) {
        const double inside = (radii[i] - double(m_distances[l][v]) / m_unit) / width + 0.5;
        sum += m_weights[l] * (std::min)((std::max)(inside, 0.), 1.);
      }
      out[i] = float(sum);
    }
  }

private:
  typedef Rest_shape::Point Point;

  void spread(std::size_t count)
  {
    const std::vector<Point>& points = m_shape->points();
    Point centre(0, 0, 0);
    double area = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
      centre += m_areas[v] * points[v];
      area += m_areas[v];
    }
    if (area > 0) centre /= area;
    std::vector<float> nearest(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) nearest[v] = float((points[v] - centre).norm());
    internal::Bounded_dijkstra paths(*m_shape);
    while (m_landmarks.size() < count) {
      const Index next = farthest(nearest);
      if (m_shape->is_isolated(next) || !(nearest[next] > 0)) break;
      if (m_landmarks.empty()) std::fill(nearest.begin(), nearest.end(), std::numeric_limits<float>::infinity());
      m_landmarks.push_back(next);
      m_distances.push_back(distances_from(next, paths));
      for (std::size_t v = 0; v < nearest.size(); ++v) nearest[v] = (std::min)(nearest[v], m_distances.back()[v]);
    }
  }

  Index farthest(const std::vector<float>& nearest) const
  {
    Index best = m_shape->measured_vertices().front();
    for (std::size_t v = 0; v < nearest.size(); ++v)
      if (!m_shape->is_isolated(v) && nearest[v] > nearest[best]) best = Index(v);
    return best;
  }

  std::vector<float> distances_from(Index l, internal::Bounded_dijkstra& paths) const
  {
    paths.run(std::array<Index, 1>{{l}}, std::numeric_limits<double>::max());
    std::vector<float> d(m_areas.size());
    for (std::size_t v = 0; v < d.size(); ++v) {
      const double along = paths.distance(Index(v));
      d[v] = float(std::isfinite(along) ? along : (m_shape->points()[v] - m_shape->points()[l]).norm());
    }
    return d;
  }

  // Each landmark by the area of the vertices that are nearest to it.
  void weigh()
  {
    m_weights.assign(m_landmarks.size(), 0);
    double sum = 0;
    for (std::size_t v = 0; v < m_areas.size(); ++v) {
      std::size_t best = 0;
      for (std::size_t l = 1; l < m_landmarks.size(); ++l)
        if (m_distances[l][v] < m_distances[best][v]) best = l;
      if (m_landmarks.empty()) break;
      m_weights[best] += m_areas[v];
      sum += m_areas[v];
    }
    if (sum > 0)
      for (double& w : m_weights) w /= sum;
  }

  void measure()
  {
    m_eccentricities.assign(m_areas.size(), 0);
    double sum = 0, area = 0;
    for (std::size_t v = 0; v < m_areas.size(); ++v) {
      for (std::size_t l = 0; l < m_landmarks.size(); ++l)
        m_eccentricities[v] += m_weights[l] * double(m_distances[l][v]);
      sum += m_areas[v] * m_eccentricities[v];
      area += m_areas[v];
    }
    m_unit = area > 0 && sum > 0 ? sum / area : 1;
    for (double& e : m_eccentricities) e /= m_unit;
  }

  const Rest_shape* m_shape;
  std::vector<double> m_areas;
  std::vector<Index> m_landmarks;
  std::vector<std::vector<float>> m_distances; // from each of them to all vertices (length)
  std::vector<double> m_weights, m_eccentricities;
  double m_unit = 1;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_SURFACE_LANDMARKS_H
