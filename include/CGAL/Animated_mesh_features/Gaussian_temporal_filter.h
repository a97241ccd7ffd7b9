// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_GAUSSIAN_TEMPORAL_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_GAUSSIAN_TEMPORAL_FILTER_H

#include <boost/math/constants/constants.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing in time by the discrete Gaussian with reflecting ends; a model of `TemporalFilter`, the default.

The semigroup of the discrete heat equation: in the basis of the DCT-II, which continues a row by its mirror image, the
factors are \f$e^{u(\cos(\pi j/F) - 1)}\f$ for the variance u in squared frames (Lindeberg 1990). Variances add exactly,
the mean is kept exactly, and no new extrema appear, whatever the step. A level costs F times the width of its kernel.
*/
class Gaussian_temporal_filter
{
public:
  /// the step where a sampling counts steps: the variance of a box of three frames (squared seconds).
  double unit_variance(std::size_t /* number_of_frames */, double frame_duration) const
  {
    return 2 * frame_duration * frame_duration / 3;
  }

  /// prepares the levels.
  /// \param variances ascending; squared seconds.
  void initialize(std::size_t number_of_frames, double frame_duration, const std::vector<double>& variances)
  {
    m_frames = number_of_frames;
    m_variances = variances;
    m_kernels.clear();
    for (std::size_t l = 0; l < variances.size(); ++l)
      m_kernels.push_back(
          kernel((variances[l] - (l > 0 ? variances[l - 1] : 0)) / (frame_duration * frame_duration)));
  }

  /// the variance of level `l`, exactly the one that was asked for.
  double variance(std::size_t l) const { return m_variances[l]; }

  /// smooths a row of frames from level `l` - 1 (the unsmoothed row for `l` = 0) to level `l`; `in` and `out` do not
  /// overlap.
  template <class FT>
  void operator()(std::size_t l, const FT* in, FT* out) const
  {
    const std::vector<double>& k = m_kernels[l];
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames), reach = std::ptrdiff_t(k.size()) - 1;
    // the row between its two mirror images; the kernel reaches at most once around
    static thread_local std::vector<FT> mirrored;
    mirrored.resize(std::size_t(n + 2 * reach));
    FT* row = mirrored.data() + reach;
    std::copy(in, in + n, row);
    for (std::ptrdiff_t i = 0; i < reach; ++i) {
      row[-1 - i] = in[i];
      row[n + i] = in[n - 1 - i];
    }
    typedef Eigen::Array<FT, Eigen::Dynamic, 1> Row;
    const auto pair = [&](std::ptrdiff_t m) {
      return FT(k[std::size_t(m)]) * (Eigen::Map<const Row>(row - m, n) + Eigen::Map<const Row>(row + m, n));
    };
    Eigen::Map<Row> sum(out, n);
    sum = FT(k[0]) * Eigen::Map<const Row>(row, n);
    std::ptrdiff_t m = 1;
    // two at a time: half of the loads and stores of the sum
    for (; m + 1 <= reach; m += 2) sum += pair(m) + pair(m + 1);
    if (m <= reach) sum += pair(m);
  }

private:
  // The right half of the kernel on a circle of 2 F frames, where a row and its mirror image live, up to where it
  // vanishes in double precision.
  std::vector<double> kernel(double u) const
  {
    const std::size_t period = 2 * m_frames;
    std::vector<double> cosine(period), factor(period), values;
    for (std::size_t j = 0; j < period; ++j) {
      cosine[j] = std::cos(boost::math::constants::two_pi<double>() * double(j) / double(period));
      factor[j] = std::exp(u * (cosine[j] - 1)) / double(period);
    }
    for (std::size_t m = 0; m <= m_frames; ++m) {
      double sum = 0;
      for (std::size_t j = 0; j < period; ++j) sum += factor[j] * cosine[(j * m) % period];
      if (m > 0 && sum < 1e-16) break;
      values.push_back(sum);
    }
    if (values.size() == m_frames + 1) values.back() /= 2; // opposite on the circle: reached from both sides
    return values;
  }

  std::size_t m_frames = 0;
  std::vector<double> m_variances;
  std::vector<std::vector<double>> m_kernels;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_GAUSSIAN_TEMPORAL_FILTER_H
