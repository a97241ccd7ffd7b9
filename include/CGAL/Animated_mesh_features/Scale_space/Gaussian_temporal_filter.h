// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_GAUSSIAN_TEMPORAL_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_GAUSSIAN_TEMPORAL_FILTER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Scale_space/Boundary_condition.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/discrete_gaussian.h>

#include <boost/math/constants/constants.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing in time by the discrete Gaussian with reflecting or joined ends; a model of `TemporalFilter`, the default.

The semigroup of the discrete heat equation: in the basis of the DCT-II, which continues a row by its mirror image, the
factors are \f$e^{u(\cos(\pi j/F) - 1)}\f$ for the variance u in squared frames \cgalCite{lindeberg1990}; in the Fourier
basis of a cyclic animation, which continues it by itself, \f$e^{u(\cos(2\pi j/F) - 1)}\f$. Variances add exactly, the mean
is kept exactly, and no new extrema appear, whatever the step.

A level costs F times the number of its weights. If steps grow with the variances, a row that has been smoothed needs a
weight every few frames only: two or three dozen of them altogether in single precision, however wide the Gaussian, and
twice as many in double precision, in which rows of up to 1,024 frames nevertheless get all of them. So time is linear
in F also where variances grow with the duration.

\cgalModels{TemporalFilter}
*/
class Gaussian_temporal_filter
{
public:
  /// rows may be those of several vertices at once, see `TemporalFilter`.
  static constexpr bool vectorized = true;

  /// \cond SKIP_IN_MANUAL
  // A row that is turned round comes out turned round, to the last bit: pairs of frames are added first.
  static constexpr bool is_mirror_symmetric = true;
  /// \endcond

  /// makes a filter without levels.
  /// \param ends what follows the last frame: `Boundary_condition::REFLECT`, or `PERIODIC` for cyclic animations.
  /// \throw Option_error if it is something else, of which this filter knows nothing.
  explicit Gaussian_temporal_filter(Boundary_condition ends = Boundary_condition::REFLECT)
    : m_is_periodic(ends == Boundary_condition::PERIODIC)
  {
    if (ends != Boundary_condition::REFLECT && ends != Boundary_condition::PERIODIC)
      throw Option_error("the Gaussian in time reflects a row or repeats it; other ends are those of boxes only");
  }

  /// the step where a sampling counts steps: the variance of a box of three frames (squared seconds).
  double unit_variance(std::size_t /* number_of_frames */, double frame_duration) const
  {
    return 2 * frame_duration * frame_duration / 3;
  }

  /// prepares the levels.
  /// \param number_of_frames of each row.
  /// \param frame_duration seconds.
  /// \param variances ascending; squared seconds.
  void initialize(std::size_t number_of_frames, double frame_duration, const std::vector<double>& variances)
  {
    m_frames = number_of_frames;
    m_frame_duration = frame_duration;
    m_variances = variances;
    m_weights.clear();
    m_float_weights.clear();
    const bool is_sparse = !has_equal_steps(); // errors are then measured by what equal steps have left of the row
    for (std::size_t l = 0; l < variances.size(); ++l) {
      internal::cancellation_point();
      const double before = (l > 0 ? variances[l - 1] : 0) / (frame_duration * frame_duration);
      const double whole_step = variances[l] / (frame_duration * frame_duration) - before;
      const std::size_t parts = number_of_parts(whole_step);
      const double step = whole_step / double(parts);
      const std::vector<double> weights = step_weights(step);
      const auto thinned_to = [&](double error) {
        return thinned(weights, is_sparse ? largest_stride(before, step, error) : 1, error, parts);
      };
      m_weights.push_back(number_of_frames > longest_full_row ? thinned_to(double_error) : Weights{1, weights, 1});
      m_float_weights.push_back(thinned_to(float_error));
    }
  }

  /// the variance of level `l`, exactly the one that was asked for.
  double variance(std::size_t l) const { return m_variances[l]; }

  /// whether every level from the second on is the level before it after one and the same operation.
  bool has_equal_steps() const
  {
    for (std::size_t l = 2; l < m_variances.size(); ++l) {
      const double first = m_variances[1] - m_variances[0], step = m_variances[l] - m_variances[l - 1];
      if (!(std::abs(step - first) <= 1e-12 * m_variances[l])) return false; // they may have been computed as multiples
    }
    return true;
  }

  /// smooths a row of frames from level `l` - 1 (the unsmoothed row for `l` = 0) to level `l`; `in` and `out` do not
  /// overlap. Rows of `float`, or of more than 1,024 frames, have to be those of
  /// level `l` - 1, since not every frame of them is looked at.
  /// \tparam T `float`, `double`, or several of them that are computed with as one, see `vectorized`.
  template <class T>
  void operator()(std::size_t l, const T* in, T* out) const
  {
    typedef typename internal::Scalar_of<T>::type Scalar;
    const Weights& k = std::is_same<Scalar, float>::value ? m_float_weights[l] : m_weights[l];
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames), reach = k.reach();
    if constexpr (!std::is_arithmetic<T>::value)
      if (k.stride > 1) return convolve_thinned(in, n, k, out);
    // the row between its images
    static thread_local std::vector<T> continued;
    if (std::ptrdiff_t(continued.size()) < n + 2 * reach) continued.resize(std::size_t(n + 2 * reach));
    T* const row = continued.data() + reach;
    for (std::size_t part = 0; part < k.parts; ++part) {
      if (m_is_periodic)
        repeat(part == 0 ? in : out, n, reach, row);
      else
        mirror(part == 0 ? in : out, n, reach, row);
      if constexpr (std::is_arithmetic<T>::value)
        convolve_row(row, n, k, out);
      else
        convolve_every(row, n, k, 1, out);
    }
  }

  /// \name What Long Rows Need
  /// See `TemporalFilter`.
  /// @{

  /// whether a row is continued by its mirror image.
  bool reflects() const { return !m_is_periodic; }

  /// whether a row is continued by itself.
  bool is_periodic() const { return m_is_periodic; }

  /// the weights of level `l` with respect to the unsmoothed row, by distance on the circle of F frames, or of the 2 F on which
  /// the row and its mirror image live: those up to the opposite frame; those that are left out are zero. Linear in F.
  std::vector<double> weights_by_distance(std::size_t l) const
  {
    return internal::on_circle(internal::discrete_gaussian(m_variances[l] / (m_frame_duration * m_frame_duration)),
                               circle());
  }
  /// @}

private:
  // weights[i] is that of the frames i strides away, on either side; to be applied so many times.
  struct Weights
  {
    std::ptrdiff_t stride;
    std::vector<double> weights;
    std::size_t parts;
    std::ptrdiff_t reach() const { return stride * std::ptrdiff_t(weights.size() - 1); }
  };

  // A row of n frames and, on either side, as many of its periodic mirror images as the weights reach.
  template <class T>
  static void mirror(const T* in, std::ptrdiff_t n, std::ptrdiff_t reach, T* row)
  {
    std::copy(in, in + n, row);
    for (std::ptrdiff_t first = 0; first < reach; first += n) {
      const std::ptrdiff_t last = (std::min)(reach, first + n);
      const bool is_turned = first / n % 2 == 0;
      for (std::ptrdiff_t i = first; i < last; ++i) {
        const std::ptrdiff_t j = i - first;
        row[-1 - i] = in[is_turned ? j : n - 1 - j];
        row[n + i] = in[is_turned ? n - 1 - j : j];
      }
    }
  }

  // The same with the row again and again on either side.
  template <class T>
  static void repeat(const T* in, std::ptrdiff_t n, std::ptrdiff_t reach, T* row)
  {
    std::copy(in, in + n, row);
    for (std::ptrdiff_t first = 0; first < reach; first += n) {
      const std::ptrdiff_t count = (std::min)(reach - first, n);
      std::copy(in + n - count, in + n, row - first - count);
      std::copy(in, in + count, row + n + first);
    }
  }

  // Values of single vertices: the registers hold successive frames.
  template <class FT>
  static void convolve_row(const FT* row, std::ptrdiff_t n, const Weights& k, FT* out)
  {
    typedef Eigen::Array<FT, Eigen::Dynamic, 1> Row;
    const std::ptrdiff_t size = std::ptrdiff_t(k.weights.size());
    const auto pair = [&](std::ptrdiff_t i) {
      const std::ptrdiff_t m = i * k.stride;
      return FT(k.weights[std::size_t(i)]) * (Eigen::Map<const Row>(row - m, n) + Eigen::Map<const Row>(row + m, n));
    };
    Eigen::Map<Row> sum(out, n);
    sum = FT(k.weights[0]) * Eigen::Map<const Row>(row, n);
    std::ptrdiff_t i = 1;
    // two at a time: half of the loads and stores of the sum
    for (; i + 1 < size; i += 2) sum += pair(i) + pair(i + 1);
    if (i < size) sum += pair(i);
  }

  // Values of several vertices, with weights several frames apart: frames that are weighted together, and their images, are
  // brought together, so that they meet in the caches however long the row is.
  template <class T>
  void convolve_thinned(const T* in, std::ptrdiff_t n, const Weights& k, T* out) const
  {
    static thread_local std::vector<T> before, gathered;
    const std::ptrdiff_t s = k.stride, reach = std::ptrdiff_t(k.weights.size()) - 1;
    const auto inner = [&](std::ptrdiff_t f) { return f >= 0 && f < n; };
    for (std::size_t part = 0; part < k.parts; ++part) {
      if (part > 0) before.assign(out, out + n);
      const T* const row = part == 0 ? in : before.data();
      for (std::ptrdiff_t first = 0; first < (std::min)(n, s); ++first) {
        const std::ptrdiff_t count = (n - first + s - 1) / s, size = count + 2 * reach;
        if (std::ptrdiff_t(gathered.size()) < size) gathered.resize(std::size_t(size));
        std::ptrdiff_t i = 0, f = first - reach * s;
        for (; i < size && !inner(f); ++i, f += s) gathered[std::size_t(i)] = row[original_frame(f, n)];
        for (; i < size && inner(f); ++i, f += s) gathered[std::size_t(i)] = row[f];
        for (; i < size; ++i, f += s) gathered[std::size_t(i)] = row[original_frame(f, n)];
        convolve_every(gathered.data() + reach, count, k, s, out + first);
      }
    }
  }

  // The frame of the row of which frame f, anywhere, is an image.
  std::ptrdiff_t original_frame(std::ptrdiff_t f, std::ptrdiff_t n) const
  {
    const std::ptrdiff_t period = std::ptrdiff_t(circle());
    f = (f % period + period) % period;
    return f < n ? f : 2 * n - 1 - f;
  }

  // Values of several vertices in n frames one after the other, all of whose weights there are; written `spacing` apart.
  template <class T>
  static void convolve_every(const T* row, std::ptrdiff_t n, const Weights& k, std::ptrdiff_t spacing, T* out)
  {
    std::ptrdiff_t f = 0;
    // several frames at a time: their sums do not wait for one another
    for (; f + 3 < n; f += 4) convolve<4>(row + f, k, spacing, out + f * spacing);
    for (; f < n; ++f) convolve<1>(row + f, k, spacing, out + f * spacing);
  }

  // A register holds one frame of all vertices.
  template <int frames, class T>
  static void convolve(const T* row, const Weights& k, std::ptrdiff_t spacing, T* out)
  {
    typedef typename T::Scalar Scalar;
    T sum[frames];
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (int f = 0; f < frames; ++f) sum[f] = row[f] * Scalar(k.weights[0]);
    for (std::size_t i = 1; i < k.weights.size(); ++i) {
      const std::ptrdiff_t m = std::ptrdiff_t(i);
      const Scalar weight = Scalar(k.weights[i]);
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (int f = 0; f < frames; ++f) sum[f] = sum[f] + (row[f - m] + row[f + m]) * weight;
    }
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (int f = 0; f < frames; ++f) out[f * spacing] = sum[f];
  }

  // The frames after which a row that goes on repeats: a cyclic one itself, another one after its mirror image.
  std::size_t circle() const { return m_is_periodic ? m_frames : 2 * m_frames; }

  // The right half of the weights by a sum over all frequencies of the circle, F for each weight.
  std::vector<double> weights_by_frequencies(double u) const
  {
    const std::size_t period = circle();
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
    return m_frames <= longest_full_row ? weights_by_frequencies(u) : internal::discrete_gaussian(u);
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
  Weights thinned(const std::vector<double>& weights, std::ptrdiff_t stride, double error, std::size_t parts) const
  {
    std::size_t size = weights.size();
    double tail = 0;
    while (size > 1 && tail + 2 * weights[size - 1] < 2 * error) tail += 2 * weights[--size];
    // weights that were added up around the circle do not meet with strides
    if (m_frames <= longest_full_row && size == weights.size()) stride = 1;
    Weights result = {stride, {}, parts};
    for (std::size_t m = 0; m < size; m += std::size_t(stride)) result.weights.push_back(double(stride) * weights[m]);
    return result;
  }

  bool m_is_periodic;
  std::size_t m_frames = 0;
  double m_frame_duration = 0; // seconds
  std::vector<double> m_variances;
  std::vector<Weights> m_weights, m_float_weights; // of the step to level l: [l]
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_GAUSSIAN_TEMPORAL_FILTER_H
