// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plots/ticks.h"

#include "drawing/decimal.h"

#include <cmath>
#include <cstddef>

namespace Programs {

std::vector<Tick> linear_ticks(double min, double max, double wanted, bool whole_numbers)
{
  std::vector<Tick> ticks;
  if (!(max > min)) return ticks;
  const double least = (max - min) / wanted;
  int exponent = int(std::floor(std::log10(least)));
  long long step = 10;
  for (long long s : {5, 2, 1})
    if (double(s) * std::pow(10., exponent) >= least) step = s;
  if (whole_numbers && exponent < 0) {
    exponent = 0;
    step = 1;
  }
  const double unit = std::pow(10., exponent), rounding = 1e-9 * (max - min);
  for (long long i = std::llround(std::ceil((min - rounding) / unit / double(step))) * step;
       double(i) * unit <= max + rounding; i += step)
    ticks.push_back({double(i) * unit, decimal(i, exponent)});
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double min, double max)
{
  const std::size_t least = 3, most = 7;
  for (const std::vector<double>& digits : {std::vector<double>{1, 1.5, 2, 3, 4, 5, 7}, {1, 2, 3, 5}, {1, 2, 5}, {1}}) {
    std::vector<Tick> ticks;
    for (int exponent = int(std::floor(std::log10(min))); std::pow(10., exponent) <= max; ++exponent)
      for (double digit : digits) {
        const double value = digit * std::pow(10., exponent);
        if (value >= min && value <= max) ticks.push_back({value, rounded(value)});
      }
    if (ticks.size() < least) break;
    if (ticks.size() <= most || digits.size() == 1) return ticks;
  }
  return linear_ticks(min, max, 6);
}

} // namespace Programs
