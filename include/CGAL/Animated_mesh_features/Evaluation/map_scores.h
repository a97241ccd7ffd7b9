// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MAP_SCORES_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MAP_SCORES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

How well a map tells what people marked, by three measures that are usual for maps of visual saliency (Z. Bylinskii,
T. Judd, A. Oliva, A. Torralba, F. Durand, What do different evaluation metrics tell us about saliency models?, 2019).
*/
struct Map_scores
{
  /// the area under the ROC curve: the probability that the map is greater at a place that is marked than at one that is
  /// not, equal values counting as half. From 0 to 1; 0.5 is chance.
  double auc = 0;

  /// the normalised scanpath saliency: the mean, over what is marked, of the map in standard deviations from its mean. 0
  /// is chance, and a map that is constant.
  double nss = 0;

  /// the linear correlation of map and marks, from -1 to 1; 0 of a map that is constant.
  double correlation = 0;

  /// for means over several maps.
  Map_scores& operator+=(const Map_scores& other)
  {
    auc += other.auc;
    nss += other.nss;
    correlation += other.correlation;
    return *this;
  }

  /// for means over several maps.
  Map_scores& operator*=(double factor)
  {
    auc *= factor;
    nss *= factor;
    correlation *= factor;
    return *this;
  }
};

namespace internal {

// A value of a map, and how much of the surface that has it is marked and is not.
struct Marked_value
{
  float value;
  double marked, unmarked;
};

// The area under the ROC curve of values that are not yet sorted.
inline double area_under_curve(std::vector<Marked_value>& values)
{
  std::sort(values.begin(), values.end(),
            [](const Marked_value& a, const Marked_value& b) { return a.value < b.value; });
  double below = 0, marked = 0, area = 0; // what is not marked and has smaller values
  for (std::size_t i = 0, end; i < values.size(); i = end) {
    double m = 0, u = 0;
    for (end = i; end < values.size() && values[end].value == values[i].value; ++end) {
      m += values[end].marked;
      u += values[end].unmarked;
    }
    area += m * (below + u / 2);
    below += u;
    marked += m;
  }
  return area / (marked * below);
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

compares a map with marks. Each vertex counts by its area, each frame the same.

\param map `N x F`, finite; `N x 1` for what does not depend on time.
\param marks `N x F`, from 0 to 1: which share of those who were asked marked a vertex in a frame.
\param areas `N`, see `vertex_areas()`.
\throw Option_error if the sizes differ.
\throw Input_error if nothing is marked, or everything.

\f$O(N F)\f$, and sorting of the values that are not 0.
*/
inline Map_scores map_scores(const Spatio_temporal_field<float>& map, const Spatio_temporal_field<float>& marks,
                             const std::vector<double>& areas)
{
  const std::size_t n = map.number_of_rows(), frames = map.number_of_frames();
  if (marks.number_of_rows() != n || marks.number_of_frames() != frames || areas.size() != n)
    throw Option_error("a map, the marks it is compared with and the areas are not of the same size");
  double all = 0, of_map = 0, of_marks = 0;
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t m = 0; m < frames; ++m) {
      all += areas[v];
      of_map += areas[v] * double(map(v, m));
      of_marks += areas[v] * double(marks(v, m));
    }
  if (!(of_marks > 0)) throw Input_error("nothing is marked: there is nothing to compare with");
  if (!(of_marks < all)) throw Input_error("everything is marked: there is nothing to compare with");

  const double mean = of_map / all, mean_mark = of_marks / all;
  double variance = 0, mark_variance = 0, covariance = 0;
  internal::Marked_value zero = {0, 0, 0};
  std::vector<internal::Marked_value> values;
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t m = 0; m < frames; ++m) {
      const double x = double(map(v, m)) - mean, y = double(marks(v, m)) - mean_mark;
      variance += areas[v] * x * x;
      mark_variance += areas[v] * y * y;
      covariance += areas[v] * x * y;
      const double marked = areas[v] * double(marks(v, m)), unmarked = areas[v] - marked;
      if (map(v, m) == 0) {
        zero.marked += marked;
        zero.unmarked += unmarked;
      } else {
        values.push_back({map(v, m), marked, unmarked});
      }
    }
  values.push_back(zero);
  Map_scores scores;
  scores.auc = internal::area_under_curve(values);
  const double rounding = 1e-14 * mean; // of a map that is constant
  if (variance > all * rounding * rounding) {
    // the mean of x over what is marked is the covariance over the marks
    scores.nss = covariance / of_marks / std::sqrt(variance / all);
    scores.correlation = covariance / std::sqrt(variance * mark_variance);
  }
  return scores;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_MAP_SCORES_H
