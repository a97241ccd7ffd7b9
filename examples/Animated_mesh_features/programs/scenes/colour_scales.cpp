// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/colour_scales.h"

#include "rendering/Palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Programs {

std::vector<double> relative_taus(const std::vector<Shown_feature>& features)
{
  double least = (std::numeric_limits<double>::max)(), most = 0;
  for (const Shown_feature& f : features)
    if (f.tau > 0) {
      least = (std::min)(least, f.tau);
      most = (std::max)(most, f.tau);
    }
  std::vector<double> result;
  for (const Shown_feature& f : features)
    result.push_back(f.tau > 0 && most > least ? std::log(f.tau / least) / std::log(most / least)
                     : f.tau > 0               ? 0.5
                                               : 0);
  return result;
}

std::vector<std::array<std::uint8_t, 3>> duration_colours_of(const std::vector<Shown_feature>& features)
{
  std::vector<std::array<std::uint8_t, 3>> result;
  for (double place : relative_taus(features))
    result.push_back(Rendering::encoded(Rendering::duration_colours()(place)));
  return result;
}

double top_of_scale(const Shown_values& field)
{
  constexpr double share = 0.99;
  constexpr std::size_t bins = 4096;
  double most = 0;
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) most = (std::max)(most, field(v, f));
  if (!(most > 0)) return 0;
  std::vector<std::size_t> counts(bins + 1, 0);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      ++counts[std::size_t((std::max)(0., field(v, f) / most * bins))];
  const double wanted = share * double(field.number_of_rows()) * double(field.number_of_frames());
  std::size_t bin = 0;
  double below = double(counts[0]);
  while (below < wanted) below += double(counts[++bin]);
  return bin == 0 ? 0 : (std::min)(most, most * double(bin + 1) / bins);
}

} // namespace Programs
