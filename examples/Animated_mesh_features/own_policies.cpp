// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every step of the method replaced by a small class of one's own. Each could be used without the others: the options say
// which class does what, see main().

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef AMF::Frame_sequence<Mesh> Frame_sequence;

// StrainMeasure: the change of area only; shear counts nothing.
//! [strain]
struct Area_strain
{
  double operator()(double lambda_1, double lambda_2) const { return std::abs(std::log(lambda_1 * lambda_2)) / 2; }
};
//! [strain]

// CurvatureMeasure: how much the surface is bent, no matter to which side, in 1 / length.
struct Absolute_bending
{
  static constexpr AMF::Ball_membership membership = AMF::Ball_membership::FRACTION;
  double factor(const AMF::Rest_shape& shape) const { return 0.005 * shape.bounding_box_diagonal(); }
  template <class Array>
  Array edge_numerator(const Array& angle, const Array& length) const
  {
    return angle.abs() * length;
  }
  template <class Array>
  Array edge_denominator(const Array& angle, const Array&) const
  {
    return Array::Zero(angle.size());
  }
  template <class Array>
  Array triangle_denominator(const Array& area) const
  {
    return 2 * area;
  }
};

// GeodesicBalls: a number of rings around each vertex, whatever the radius.
struct Rings
{
  std::size_t number;

  template <class Loop>
  AMF::Compressed_rows operator()(const AMF::Rest_shape& shape, double /* radius */, const Loop& loop) const
  {
    std::vector<std::vector<AMF::Rest_shape::Index>> balls(shape.number_of_vertices());
    loop(balls.size(), [&](std::size_t v) {
      std::vector<AMF::Rest_shape::Index>& ball = balls[v];
      ball.assign(1, AMF::Rest_shape::Index(v));
      for (std::size_t i = 0; i < number; ++i) {
        const std::vector<AMF::Rest_shape::Index> inner = ball;
        for (AMF::Rest_shape::Index w : inner)
          ball.insert(ball.end(), shape.neighbours()[w].begin(), shape.neighbours()[w].end());
        std::sort(ball.begin(), ball.end());
        ball.erase(std::unique(ball.begin(), ball.end()), ball.end());
      }
    });
    return AMF::Compressed_rows(std::move(balls));
  }
};

// SpatialFilter: steps half way to the mean of the neighbours.
class Half_way_filter
{
public:
  template <class Loop>
  void initialize(const AMF::Rest_shape& shape, const std::vector<double>& variances, const Loop&)
  {
    m_shape = &shape;
    // half of the mean of |w - v|^2 / 2 per axis
    m_step = shape.mean_edge_length() * shape.mean_edge_length() / 4;
    m_counts.clear();
    for (double s : variances) m_counts.push_back(std::size_t(std::lround(s / m_step)));
  }
  double variance(std::size_t k) const { return double(m_counts[k]) * m_step; }
  double variance(std::size_t k, std::size_t) const { return variance(k); }

  template <class FT, class Loop>
  void operator()(std::size_t k, const AMF::Spatio_temporal_field<FT>& in, AMF::Spatio_temporal_field<FT>& out,
                  const Loop& loop) const
  {
    const std::size_t steps = m_counts[k] - (k > 0 ? m_counts[k - 1] : 0);
    AMF::Spatio_temporal_field<FT> from = in;
    out = in;
    for (std::size_t i = 0; i < steps; ++i) {
      from.swap(out);
      loop.part(i, steps)(in.number_of_rows(), [&](std::size_t v) {
        const auto ring = m_shape->neighbours()[v];
        for (std::size_t f = 0; f < in.number_of_frames(); ++f) {
          FT sum = 0;
          for (AMF::Rest_shape::Index w : ring) sum += from(w, f);
          out(v, f) = ring.empty() ? from(v, f) : (from(v, f) + sum / FT(ring.size())) / 2;
        }
      });
    }
  }

private:
  const AMF::Rest_shape* m_shape = nullptr;
  double m_step = 0;
  std::vector<std::size_t> m_counts;
};

// TemporalFilter: binomial, (1, 2, 1) / 4 again and again; the first and the last frame stand for those beyond.
class Binomial_filter
{
public:
  void initialize(std::size_t number_of_frames, double frame_duration, const std::vector<double>& variances)
  {
    m_frames = number_of_frames;
    m_step = frame_duration * frame_duration / 2;
    m_counts.clear();
    for (double u : variances) m_counts.push_back(std::size_t(std::lround(u / m_step)));
  }
  double variance(std::size_t l) const { return double(m_counts[l]) * m_step; }

  template <class FT>
  void operator()(std::size_t l, const FT* in, FT* out) const
  {
    std::copy(in, in + m_frames, out);
    for (std::size_t i = l > 0 ? m_counts[l - 1] : 0; i < m_counts[l]; ++i) {
      FT before = out[0];
      for (std::size_t f = 0; f < m_frames; ++f) {
        const FT same = out[f], after = out[(std::min)(f + 1, m_frames - 1)];
        out[f] = (before + 2 * same + after) / 4;
        before = same;
      }
    }
  }

private:
  std::size_t m_frames = 0;
  double m_step = 0;
  std::vector<std::size_t> m_counts;
};

// ScaleSampling: a list of scales.
struct Listed_scales
{
  std::vector<double> sigma, tau;

  template <class SpatialFilter, class TemporalFilter>
  AMF::Scale_levels operator()(const AMF::Rest_shape&, std::size_t, double, const SpatialFilter&,
                               const TemporalFilter&) const
  {
    AMF::Scale_levels levels;
    for (double s : sigma) levels.space_variances.push_back(s * s);
    for (double t : tau) levels.time_variances.push_back(t * t);
    return levels;
  }
};

// SpaceTimeResponse: differences between neighbouring levels by the logarithm of scale, weighted against each other.
struct Weighted_differences
{
  static constexpr std::size_t below = 1, above = 1;
  double share_of_time;
  std::vector<double> sigma = {}, tau = {};

  void initialize(const std::vector<double>& s, const std::vector<double>& t, const AMF::Scale_levels&)
  {
    sigma = s;
    tau = t;
  }
  double space_weight(std::size_t k, std::size_t) const
  {
    return (1 - share_of_time) / std::log(sigma[k + 1] / sigma[k - 1]);
  }
  double time_weight(std::size_t, std::size_t l) const { return share_of_time / std::log(tau[l + 1] / tau[l - 1]); }
};

// ExtremumSearch: minima in time and in each of the two scales, but not across them; on the surface in the same frame.
struct Minima_along_axes
{
  template <class FT>
  bool at_vertex(const AMF::Response_window<FT>& d) const
  {
    const FT c = d(0, 0, 0);
    return c < 0 && c < d(-1, 0, 0) && c < d(1, 0, 0) && c < d(0, -1, 0) && c < d(0, 1, 0) && c < d(0, 0, -1) &&
           c < d(0, 0, 1);
  }
  template <class FT>
  bool at_neighbour(FT centre, FT /* before */, FT same, FT /* after */) const
  {
    return centre < same;
  }
};

// DetectionVisitor
struct Stage_names
{
  void begin(AMF::Stage stage) { std::cout << name(stage) << std::endl; }
  bool progress(AMF::Stage, double) { return true; }
  void end(AMF::Stage) {}
};

int main()
{
  Animated_mesh_generators::Bending_cylinder_options cylinder_options;
  cylinder_options.vertices_around = 18;
  const auto cylinder = Animated_mesh_generators::bending_cylinder(cylinder_options);
  Frame_sequence animation(cylinder.mesh, cylinder.frames, cylinder.frame_duration);
  animation.set_rest_shape(cylinder.mesh.points());

  //! [options]
  const auto options = AMF::calibrated_options()
                           .with_strain(Area_strain())
                           .with_curvature(Absolute_bending())
                           .with_balls(Rings{3})
                           .with_spatial_filter(Half_way_filter())
                           .with_temporal_filter(Binomial_filter())
                           .with_sampling(Listed_scales{{0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8},
                                                        {0.03, 0.04, 0.06, 0.08, 0.12, 0.16, 0.24, 0.32, 0.4}})
                           .with_response(Weighted_differences{0.4})
                           .with_search(Minima_along_axes());
  std::vector<AMF::Spatio_temporal_feature<Mesh::Vertex_index>> features;
  CGAL::detect_spatio_temporal_features(animation, std::back_inserter(features), options, Stage_names());
  //! [options]
  for (const auto& f : features)
    std::cout << (f.rest_position[0] < 0 ? "left" : "right") << ", height " << f.rest_position[2] << ", time " << f.time
              << " s, sigma " << f.sigma << ", tau " << f.tau << " s, strength " << f.strength << std::endl;
  return features.empty() ? 1 : 0;
}
