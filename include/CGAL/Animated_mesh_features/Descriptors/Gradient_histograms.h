// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_GRADIENT_HISTOGRAMS_H
#define CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_GRADIENT_HISTOGRAMS_H

#include <CGAL/Animated_mesh_features/Descriptors/Feature_neighbourhood.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// A position between the centres of bins: the two next to it, and how much of a sample falls into the second one.
struct Soft_bin
{
  std::size_t first, second;
  double fraction;
};

// In `bins` equal parts of [low, high]; what is beyond the outer centres belongs to them alone.
inline Soft_bin soft_bin(double x, double low, double high, std::size_t bins)
{
  const double last = double(bins - 1);
  const double at = (std::min)((std::max)((x - low) / (high - low) * double(bins) - 0.5, 0.), last);
  const std::size_t first = (std::min)(std::size_t(at), bins - 1);
  return {first, (std::min)(first + 1, bins - 1), at - double(first)};
}

// Of length 1, no number above 0.2, of length 1 (Lowe 2004); all zero if there is nothing.
inline void normalize_histogram(float* first, std::size_t n)
{
  const auto scale = [&] {
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) squares += double(first[i]) * double(first[i]);
    if (!(squares > 0)) return;
    const double factor = 1 / std::sqrt(squares);
    for (std::size_t i = 0; i < n; ++i) first[i] = float(double(first[i]) * factor);
  };
  const float largest = 0.2f;
  scale();
  for (std::size_t i = 0; i < n; ++i) first[i] = (std::min)(first[i], largest);
  scale();
}

// The weight of a sample: its area, under a Gaussian as wide as half of the neighbourhood.
inline double sample_weight(const Feature_neighbourhood::Place& v, double time)
{
  const double width = Feature_neighbourhood::reach / 2;
  return v.area * std::exp(-(v.x * v.x + v.y * v.y + time * time) / (2 * width * width));
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

The histogram of a field's gradients around a feature, without any direction on the surface: 4 bins in distance, 5 in
time, 5 in the direction of the gradient - outward, inward, along the circle around the feature, forward and backward in
time -, 100 numbers in all.

A sample at \f$(x, y, t)\f$ with gradient \f$g\f$ counts by \f$|g|\f$ times its area under a Gaussian of standard
deviation 1.5 (in units of \f$\sigma\f$ and \f$\tau\f$); it is divided among the two nearest bins in distance and in
time, and among directions by the squares of the cosines, which have the sum 1. The result is normalised to length 1,
clipped at 0.2 and normalised again, as by Lowe \cgalCite{lowe2004} and, with time, by Scovanner, Ali and Shah
\cgalCite{scovanner2007}.

It does not change when the body is moved, scaled, or mirrored, when vertices are numbered anew, nor when the field is
multiplied by a factor or something constant is added; frame rate and resampling change it as far as they change the
field.

Linear in the number of samples.

\cgalModels{FeatureDescriptor}
*/
struct Rotation_free_gradient_histogram
{
  static constexpr std::size_t radii = 4;      ///< bins in distance
  static constexpr std::size_t slices = 5;     ///< bins in time
  static constexpr std::size_t directions = 5; ///< bins in direction

  /// 100.
  std::size_t length() const { return radii * slices * directions; }

  /// writes `length()` numbers, not negative, of length 1; those of a distance next to one another, of a time within.
  void operator()(const Feature_neighbourhood& n, float* out) const
  {
    std::fill(out, out + length(), 0.f);
    const double reach = Feature_neighbourhood::reach;
    const std::size_t T = n.times.size();
    for (std::size_t v = 0; v < n.places.size(); ++v) {
      const Feature_neighbourhood::Place& p = n.places[v];
      const double r = std::hypot(p.x, p.y);
      const double cosine = r > 0 ? p.x / r : 1, sine = r > 0 ? p.y / r : 0;
      const internal::Soft_bin radius = internal::soft_bin(r, 0, reach, radii);
      for (std::size_t k = 0; k < T; ++k) {
        const Feature_neighbourhood::Gradient& g = n.gradients[v * T + k];
        const double radial = g[0] * cosine + g[1] * sine, along = g[1] * cosine - g[0] * sine, temporal = g[2];
        const double size = std::sqrt(radial * radial + along * along + temporal * temporal);
        if (!(size > 0)) continue;
        const double weight = internal::sample_weight(p, n.times[k]) / size; // size times squares of cosines
        // at the feature itself no direction is outward: the mean over all
        const double squares = radial * radial + along * along;
        const double outward = r > 0 ? (radial > 0 ? radial * radial : 0) : squares / 4;
        const double inward = r > 0 ? (radial < 0 ? radial * radial : 0) : squares / 4;
        const std::array<double, directions> parts = {{outward, inward, squares - outward - inward,
                                                       temporal > 0 ? temporal * temporal : 0,
                                                       temporal < 0 ? temporal * temporal : 0}};
        const internal::Soft_bin time = internal::soft_bin(n.times[k], -reach, reach, slices);
        const auto add = [&](std::size_t i, std::size_t j, double share) {
          for (std::size_t d = 0; d < directions; ++d)
            out[(i * slices + j) * directions + d] += float(share * weight * parts[d]);
        };
        add(radius.first, time.first, (1 - radius.fraction) * (1 - time.fraction));
        add(radius.first, time.second, (1 - radius.fraction) * time.fraction);
        add(radius.second, time.first, radius.fraction * (1 - time.fraction));
        add(radius.second, time.second, radius.fraction * time.fraction);
      }
    }
    internal::normalize_histogram(out, length());
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesDescriptors

The histogram of a field's gradients around a feature, in a frame of the feature's own: 2 bins in distance, 4 sectors, 4
bins in time, 6 directions of the gradient - along both axes, either way, forward and backward in time -, 192 numbers in
all. Weights and normalisation are those of `Rotation_free_gradient_histogram`.

The first axis is the dominant direction of the gradients on the surface: the eigenvector of the larger eigenvalue of
their structure tensor \f$\sum w\,g g^T\f$, pointing to where the field is larger. Where gradients have no dominant
direction, as around a round blob, the frame is arbitrary and the descriptor means little.

Of a mirrored body it is mirrored: `mirrored()` exchanges the bins of the two sides.

Linear in the number of samples.

\cgalModels{FeatureDescriptor}
*/
struct Oriented_gradient_histogram
{
  static constexpr std::size_t radii = 2;      ///< bins in distance
  static constexpr std::size_t sectors = 4;    ///< around the first axis, the second, and opposite of both
  static constexpr std::size_t slices = 4;     ///< bins in time
  static constexpr std::size_t directions = 6; ///< x, -x, y, -y, t, -t

  /// 192.
  std::size_t length() const { return radii * sectors * slices * directions; }

  /// writes `length()` numbers, not negative, of length 1.
  void operator()(const Feature_neighbourhood& n, float* out) const
  {
    std::fill(out, out + length(), 0.f);
    const double pi = 3.14159265358979323846, reach = Feature_neighbourhood::reach;
    const std::array<double, 2> axis = dominant_direction(n);
    const std::size_t T = n.times.size();
    for (std::size_t v = 0; v < n.places.size(); ++v) {
      const Feature_neighbourhood::Place& p = n.places[v];
      const double px = p.x * axis[0] + p.y * axis[1], py = p.y * axis[0] - p.x * axis[1];
      const internal::Soft_bin radius = internal::soft_bin(std::hypot(px, py), 0, reach, radii);
      const bool is_aside = std::hypot(px, py) > 1e-9;
      const double turn = (std::atan2(py, px) / (2 * pi) + 1) * double(sectors);
      const std::size_t sector = std::size_t(turn);
      const double turn_fraction = turn - double(sector);
      for (std::size_t k = 0; k < T; ++k) {
        const Feature_neighbourhood::Gradient& g = n.gradients[v * T + k];
        const std::array<double, 3> h = {{g[0] * axis[0] + g[1] * axis[1], g[1] * axis[0] - g[0] * axis[1], g[2]}};
        const double size = std::sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
        if (!(size > 0)) continue;
        const double weight = internal::sample_weight(p, n.times[k]) / size;
        const internal::Soft_bin time = internal::soft_bin(n.times[k], -reach, reach, slices);
        const auto add_to = [&](float* bin, double share) {
          for (std::size_t d = 0; d < 3; ++d) bin[2 * d + (h[d] < 0 ? 1 : 0)] += float(share * weight * h[d] * h[d]);
        };
        const auto add = [&](std::size_t r, std::size_t s, std::size_t t, double share) {
          if (is_aside) {
            add_to(out + bin_of(r, s % sectors, t), share);
            return;
          }
          // at the feature itself, in no direction from it: in all sectors
          for (std::size_t all = 0; all < sectors; ++all) add_to(out + bin_of(r, all, t), share / double(sectors));
        };
        for (int i = 0; i < 8; ++i)
          add(i & 1 ? radius.second : radius.first, i & 2 ? sector + 1 : sector, i & 4 ? time.second : time.first,
              (i & 1 ? radius.fraction : 1 - radius.fraction) * (i & 2 ? turn_fraction : 1 - turn_fraction) *
                  (i & 4 ? time.fraction : 1 - time.fraction));
      }
    }
    internal::normalize_histogram(out, length());
  }

  /// writes the descriptor of the mirrored body: the second axis the other way round.
  void mirrored(const float* in, float* out) const
  {
    for (std::size_t r = 0; r < radii; ++r)
      for (std::size_t s = 0; s < sectors; ++s)
        for (std::size_t t = 0; t < slices; ++t)
          for (std::size_t d = 0; d < directions; ++d)
            out[bin_of(r, (sectors - s) % sectors, t) + (d == 2 ? 3 : d == 3 ? 2 : d)] = in[bin_of(r, s, t) + d];
  }

private:
  static std::size_t bin_of(std::size_t r, std::size_t s, std::size_t t)
  {
    return ((r * sectors + s) * slices + t) * directions;
  }

  static std::array<double, 2> dominant_direction(const Feature_neighbourhood& n)
  {
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0, sum = 0, mean = 0;
    const std::size_t T = n.times.size();
    for (std::size_t v = 0; v < n.places.size(); ++v)
      for (std::size_t k = 0; k < T; ++k) {
        const double w = internal::sample_weight(n.places[v], n.times[k]);
        const Feature_neighbourhood::Gradient& g = n.gradients[v * T + k];
        xx += w * g[0] * g[0];
        xy += w * g[0] * g[1];
        yy += w * g[1] * g[1];
        sum += w;
        mean += w * n.values[v * T + k];
      }
    if (sum > 0) mean /= sum;
    for (std::size_t v = 0; v < n.places.size(); ++v)
      for (std::size_t k = 0; k < T; ++k) {
        const double w = internal::sample_weight(n.places[v], n.times[k]) * (n.values[v * T + k] - mean);
        x += w * n.places[v].x;
        y += w * n.places[v].y;
      }
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    const std::array<double, 2> axis = {{std::cos(angle), std::sin(angle)}};
    return x * axis[0] + y * axis[1] < 0 ? std::array<double, 2>{{-axis[0], -axis[1]}} : axis;
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DESCRIPTORS_GRADIENT_HISTOGRAMS_H
