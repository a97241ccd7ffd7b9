// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_COLOUR_SCALES_H
#define PROGRAMS_SCENES_COLOUR_SCALES_H

#include "scenes/Scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Where each feature's tau lies on the scale of colours: between the shortest and the longest one, by ratio, from 0 to 1.
template <class Feature>
std::vector<double> relative_taus(const std::vector<Feature>& features)
{
  double least = (std::numeric_limits<double>::max)(), most = 0;
  for (const Feature& f : features)
    if (f.tau > 0) {
      least = (std::min)(least, f.tau);
      most = (std::max)(most, f.tau);
    }
  std::vector<double> result;
  for (const Feature& f : features)
    result.push_back(f.tau > 0 && most > least ? std::log(f.tau / least) / std::log(most / least)
                     : f.tau > 0               ? 0.5
                                               : 0);
  return result;
}

// The value that 99 % of a field do not exceed: the end of a scale of colours that a few spikes cannot stretch. 0 if the
// field is 0 nearly everywhere, or nowhere positive.
template <class FT>
double top_of_scale(const Spatio_temporal_field<FT>& field)
{
  constexpr double share = 0.99;
  constexpr std::size_t bins = 4096;
  double most = 0;
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) most = (std::max)(most, double(field(v, f)));
  if (!(most > 0)) return 0;
  std::vector<std::size_t> counts(bins + 1, 0);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      ++counts[std::size_t((std::max)(0., double(field(v, f)) / most * bins))];
  const double wanted = share * double(field.number_of_rows()) * double(field.number_of_frames());
  std::size_t bin = 0;
  double below = double(counts[0]);
  while (below < wanted) below += double(counts[++bin]);
  return bin == 0 ? 0 : (std::min)(most, most * double(bin + 1) / bins);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_COLOUR_SCALES_H
