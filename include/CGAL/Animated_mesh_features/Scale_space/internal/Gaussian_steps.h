// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_GAUSSIAN_STEPS_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_GAUSSIAN_STEPS_H

#include <CGAL/Animated_mesh_features/Scale_space/internal/Step_weights.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/discrete_gaussian.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The weights of steps of the discrete Gaussian for rows of a number of frames, in either precision: all of them, or a few
// at a stride, see Gaussian_temporal_filter.
class Gaussian_steps
{
public:
  struct Weights
  {
    Step_weights of_double, of_float;
  };

  // `circle`: the frames after which a row that goes on repeats.
  Gaussian_steps(std::size_t number_of_frames, std::size_t circle)
    : m_frames(number_of_frames)
    , m_circle(circle)
  {}

  // Of a step from the variance `before`, by `whole_step` (squared frames). With strides, if the row is as smooth as it is
  // after that variance.
  Weights operator()(double before, double whole_step, bool has_strides) const
  {
    const std::size_t parts = number_of_parts(whole_step);
    const double step = whole_step / double(parts);
    const std::vector<double> weights = step_weights(step);
    const auto thinned_to = [&](double error) {
      return thinned(weights, has_strides ? largest_stride(before, step, error) : 1, error, parts);
    };
    return {m_frames > longest_full_row ? thinned_to(double_error) : Step_weights{1, weights, 1},
            thinned_to(float_error)};
  }

private:
  // The right half of the weights by a sum over all frequencies of the circle, F for each weight.
  std::vector<double> weights_by_frequencies(double u) const
  {
    const std::size_t period = m_circle;
    std::vector<double> cosine(period), factor(period), values;
    for (std::size_t j = 0; j < period; ++j) {
      cosine[j] = std::cos(boost::math::constants::two_pi<double>() * double(j) / double(period));
      factor[j] = std::exp(u * (cosine[j] - 1)) / double(period);
    }
    for (std::size_t m = 0; 2 * m <= period; ++m) {
      double sum = 0;
      for (std::size_t j = 0; j < period; ++j) sum += factor[j] * cosine[(j * m) % period];
      if (m > 0 && sum < 1e-16) break;
      values.push_back(sum);
    }
    if (2 * (values.size() - 1) == period) values.back() /= 2; // opposite on the circle: reached from both sides
    return values;
  }

  // The right half of the weights of a step of variance u. For short rows on the circle; that of the opposite frame counts
  // half, since it is reached from both sides.
  std::vector<double> step_weights(double u) const
  {
    return m_frames <= longest_full_row ? weights_by_frequencies(u) : discrete_gaussian(u);
  }

  // Into how many equal steps one of long rows is divided, so that none reaches further than two rows: weights reach
  // some nine standard deviations.
  std::size_t number_of_parts(double u) const
  {
    if (m_frames <= longest_full_row) return 1;
    const double widest = double(m_frames) / 5;
    return (std::max)(std::size_t(1), std::size_t(std::ceil(u / (widest * widest))));
  }

  // Rows of up to that many frames are smoothed in double precision with a weight for every frame.
  static constexpr std::size_t longest_full_row = 1024;

  // Errors that a precision does not see, relative to the largest value of a row.
  static constexpr double float_error = double(std::numeric_limits<float>::epsilon()) / 8;
  static constexpr double double_error = std::numeric_limits<double>::epsilon() / 8;

  // How many frames apart the weights of a step of variance u may be, after one of variance v (squared frames), for an
  // error of that share of the largest value.
  //
  // With a weight every s frames, each s times as large, the factor g(w - 2 pi k / s) comes with g(w) for all k < s,
  // g(w) = exp(u (cos w - 1)). Before came exp(v (cos w - 1)); u cos(w - a) + v cos w is R cos(w - b) with
  // R^2 = u^2 + v^2 + 2 u v cos a. So a row takes on exp(R - u - v) times its smoothing by a discrete Gaussian of
  // variance R on a carrier wave, which is at most exp(R - u - v) of its largest value.
  std::ptrdiff_t largest_stride(double v, double u, double largest_error) const
  {
    const auto share = [&](std::ptrdiff_t k, std::ptrdiff_t s) {
      const double cosine = std::cos(boost::math::constants::two_pi<double>() * double(k) / double(s));
      return std::exp(std::sqrt((std::max)(0., u * u + v * v + 2 * u * v * cosine)) - u - v);
    };
    for (std::ptrdiff_t s = 2; s <= std::ptrdiff_t(m_frames); ++s) {
      double error = 0, last = 1;
      for (std::ptrdiff_t k = 1; 2 * k <= s && last > 1e-6 * largest_error; ++k) { // they decrease up to s / 2
        last = share(k, s);
        error += 2 * k == s ? last : 2 * last;
      }
      if (error > largest_error) return s - 1;
    }
    return std::ptrdiff_t(m_frames);
  }

  // What a precision sees of the weights of a step: what is left out sums up to less than its rounding.
  Step_weights thinned(const std::vector<double>& weights, std::ptrdiff_t stride, double error, std::size_t parts) const
  {
    std::size_t size = weights.size();
    double tail = 0;
    while (size > 1 && tail + 2 * weights[size - 1] < 2 * error) tail += 2 * weights[--size];
    // weights that were added up around the circle do not meet with strides
    if (m_frames <= longest_full_row && size == weights.size()) stride = 1;
    Step_weights result = {stride, {}, parts};
    for (std::size_t m = 0; m < size; m += std::size_t(stride)) result.weights.push_back(double(stride) * weights[m]);
    return result;
  }

  std::size_t m_frames, m_circle;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_GAUSSIAN_STEPS_H
