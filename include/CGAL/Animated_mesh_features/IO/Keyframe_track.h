// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAME_TRACK_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAME_TRACK_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

A value that changes with time, given at keys: a translation, a rotation, a scale, or the weights of morph targets.

Between keys it is interpolated as in the specification of glTF 2.0, Appendix C. Before the first key and after the
last one it is constant. Evaluation takes time logarithmic in the number of keys.
*/
struct Keyframe_track
{
  /// What the value is between two keys.
  enum class Interpolation
  {
    STEP,       ///< the value of the last key.
    LINEAR,     ///< between the two keys; for rotations along the shorter arc at constant speed (slerp).
    CUBICSPLINE ///< a cubic Hermite spline with given tangents.
  };

  /// the same between all keys.
  Interpolation interpolation = Interpolation::LINEAR;

  /// whether values are quaternions (x, y, z, w). Interpolated ones are normalised.
  bool is_rotation = false;

  /// numbers in a value: 3 for translations and scales, 4 for rotations, as many as there are targets for weights.
  std::size_t width = 0;

  /// the times of the `K` keys (s), ascending.
  std::vector<double> times;

  /// `K x width`; for cubic splines `K x 3 x width`: of each key the in-tangent, the value, the out-tangent.
  std::vector<double> values;

  /// whether there is at least one key, and as many values as keys ask for.
  bool is_complete() const
  {
    return width > 0 && !times.empty() && values.size() == times.size() * width * numbers_per_component() &&
           std::is_sorted(times.begin(), times.end());
  }

  /// writes the `width` numbers at `time`. The track must be complete.
  void evaluate(double time, double* value) const
  {
    const std::size_t next = std::size_t(std::upper_bound(times.begin(), times.end(), time) - times.begin());
    if (next == 0 || next == times.size() || interpolation == Interpolation::STEP) {
      const double* const v = key(next == 0 ? 0 : next - 1);
      std::copy(v, v + width, value);
    } else {
      const double duration = times[next] - times[next - 1];
      const double t = (time - times[next - 1]) / duration;
      if (interpolation == Interpolation::CUBICSPLINE)
        evaluate_spline(next, t, duration, value);
      else if (is_rotation)
        evaluate_slerp(next, t, value);
      else
        for (std::size_t i = 0; i < width; ++i) value[i] = (1 - t) * key(next - 1)[i] + t * key(next)[i];
    }
    if (is_rotation) normalize(value);
  }

private:
  std::size_t numbers_per_component() const { return interpolation == Interpolation::CUBICSPLINE ? 3 : 1; }

  const double* key(std::size_t k) const
  {
    return interpolation == Interpolation::CUBICSPLINE ? &values[(3 * k + 1) * width] : &values[k * width];
  }

  void evaluate_spline(std::size_t next, double t, double duration, double* value) const
  {
    const double* const from = key(next - 1);
    const double* const out_tangent = from + width;
    const double* const to = key(next);
    const double* const in_tangent = to - width;
    const double t2 = t * t, t3 = t2 * t;
    for (std::size_t i = 0; i < width; ++i)
      value[i] = (2 * t3 - 3 * t2 + 1) * from[i] + duration * (t3 - 2 * t2 + t) * out_tangent[i] +
                 (3 * t2 - 2 * t3) * to[i] + duration * (t3 - t2) * in_tangent[i];
  }

  void evaluate_slerp(std::size_t next, double t, double* value) const
  {
    double from[4], to[4];
    std::copy(key(next - 1), key(next - 1) + 4, from);
    std::copy(key(next), key(next) + 4, to);
    normalize(from); // those of files are integers or single precision
    normalize(to);
    double cosine = 0;
    for (int i = 0; i < 4; ++i) cosine += from[i] * to[i];
    if (cosine < 0) // q and -q are the same rotation; the other way round is longer
      for (double& x : to) x = -x;
    // The angle from its half: the arc cosine loses half of the digits where the two are close.
    double difference = 0, sum = 0;
    for (int i = 0; i < 4; ++i) {
      difference += (to[i] - from[i]) * (to[i] - from[i]);
      sum += (to[i] + from[i]) * (to[i] + from[i]);
    }
    const double angle = 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
    const double sine = std::sin(angle);
    double a = 1 - t, b = t;
    if (sine > 0) {
      a = std::sin((1 - t) * angle) / sine;
      b = std::sin(t * angle) / sine;
    }
    for (int i = 0; i < 4; ++i) value[i] = a * from[i] + b * to[i];
  }

  static void normalize(double* q)
  {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 0)) return; // no rotation at all, which whoever builds a model refuses
    for (int i = 0; i < 4; ++i) q[i] /= length;
  }
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_KEYFRAME_TRACK_H
