// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PROMINENT_MAXIMA_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PROMINENT_MAXIMA_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

A local maximum of a series.
*/
struct Prominent_maximum
{
  std::size_t place = 0; ///< the index of the value; of a plateau the middle one, the earlier of two
  double value = 0;      ///< the value there

  /// how far one has to go down from it, to either side, before the series rises above it: the less of the two descents. To
  /// a side where it never does, the series' end counts.
  double prominence = 0;
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

finds the local maxima of a series that stand out: an extreme of a joint's angle, against small wavering. The first and the
last value are no maxima, as it is not known whether the series would have gone on rising.

\param series at least 0 values, finite.
\param least the least prominence that counts.
\returns the maxima in their order.

For `n` values and `m` maxima \f$O(n m)\f$ at most.
*/
inline std::vector<Prominent_maximum> prominent_maxima(const std::vector<double>& series, double least)
{
  const auto descent = [&](std::size_t place, std::ptrdiff_t step) {
    double lowest = series[place];
    for (std::ptrdiff_t i = std::ptrdiff_t(place); i >= 0 && i < std::ptrdiff_t(series.size()); i += step) {
      if (series[std::size_t(i)] > series[place]) break;
      lowest = (std::min)(lowest, series[std::size_t(i)]);
    }
    return series[place] - lowest;
  };
  std::vector<Prominent_maximum> maxima;
  for (std::size_t i = 1, end; i < series.size(); i = end) {
    for (end = i + 1; end < series.size() && series[end] == series[i];) ++end; // a plateau
    if (!(series[i - 1] < series[i]) || end == series.size() || !(series[end] < series[i])) continue;
    const std::size_t place = (i + end - 1) / 2;
    const double prominence = (std::min)(descent(place, -1), descent(place, 1));
    if (prominence >= least) maxima.push_back({place, series[i], prominence});
  }
  return maxima;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_PROMINENT_MAXIMA_H
