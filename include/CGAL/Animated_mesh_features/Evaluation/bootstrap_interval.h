// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_BOOTSTRAP_INTERVAL_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_BOOTSTRAP_INTERVAL_H

#include <CGAL/Animated_mesh_features/Evaluation/Random_numbers.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

A range in which a figure lies, as far as the sample behind it can tell.
*/
struct Interval
{
  double low = 0;  ///< its lower end
  double high = 0; ///< its upper end
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

How intervals are made by resampling.
*/
struct Bootstrap_options
{
  std::size_t resamples = 1000; ///< enough for two digits of the ends of a 95 % interval
  double confidence = 0.95;     ///< the share of resamples within the interval, above 0 and below 1
  std::uint64_t seed = 1;       ///< the same seed gives the same interval
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

the mean of a sample; 0 of an empty one.
*/
inline double sample_mean(const std::vector<double>& sample)
{
  double sum = 0;
  for (double x : sample) sum += x;
  return sample.empty() ? 0 : sum / double(sample.size());
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

the median of a sample, the mean of the two middle values if their number is even; 0 of an empty one.
*/
inline double sample_median(std::vector<double> sample)
{
  if (sample.empty()) return 0;
  const auto middle = sample.begin() + std::ptrdiff_t(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  if (sample.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(sample.begin(), middle)) / 2;
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

computes the percentile bootstrap interval of a statistic (B. Efron, R. J. Tibshirani, An Introduction to the Bootstrap,
1993, sect. 13.3): the statistic of as many values, drawn with replacement, is computed again and again; the interval
leaves out as many of the results at either end. Between two results it is linear.

The interval of a share that is 0 or 1 has no width. The values must be independent for the interval to mean what it says;
neighbouring features of one animation are less so than they look, and the interval is then too short.

\param sample the values; of a share, 1 for what counts and 0 for what does not.
\param statistic a function of `std::vector<double>`, such as `sample_mean()` or `sample_median()`.
\param options see there.
\returns both ends; 0 and 0 of an empty sample.
\throw Option_error if there are no resamples or the confidence is not between 0 and 1.

The statistic is computed `resamples` times.
*/
template <class Statistic>
Interval bootstrap_interval(const std::vector<double>& sample, const Statistic& statistic,
                            Bootstrap_options options = Bootstrap_options())
{
  if (options.resamples == 0) throw Option_error("a bootstrap interval needs at least one resample");
  if (!(options.confidence > 0 && options.confidence < 1))
    throw Option_error("the confidence of an interval must be between 0 and 1");
  if (sample.empty()) return Interval();
  Random_numbers random(options.seed);
  std::vector<double> results, drawn(sample.size());
  results.reserve(options.resamples);
  for (std::size_t i = 0; i < options.resamples; ++i) {
    for (double& x : drawn) x = sample[random.below(sample.size())];
    results.push_back(statistic(drawn));
  }
  std::sort(results.begin(), results.end());
  const auto quantile = [&](double q) {
    const double place = q * double(results.size() - 1), below = std::floor(place);
    const std::size_t i = std::size_t(below), next = (std::min)(i + 1, results.size() - 1);
    return results[i] + (place - below) * (results[next] - results[i]);
  };
  return {quantile((1 - options.confidence) / 2), quantile((1 + options.confidence) / 2)};
}

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

the same for the mean.
*/
inline Interval bootstrap_interval(const std::vector<double>& sample, Bootstrap_options options = Bootstrap_options())
{
  return bootstrap_interval(sample, sample_mean, options);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_BOOTSTRAP_INTERVAL_H
