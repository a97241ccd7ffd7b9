// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_PLOT_AXIS_H
#define PROGRAMS_PLOTS_PLOT_AXIS_H

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// `n` times 10 to the power of `exponent` as a decimal number, exactly and whatever the locale.
inline std::string decimal(long long n, int exponent)
{
  if (n < 0) return "-" + decimal(-n, exponent);
  std::string digits = std::to_string(n);
  if (n == 0 || exponent >= 0) return n == 0 ? "0" : digits + std::string(std::size_t(exponent), '0');
  const std::size_t places = std::size_t(-exponent);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, 1, '.');
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

// A number for people: so many digits, without zeros that say nothing; very large and very small ones with a power of ten.
inline std::string rounded(double x, int digits = 3)
{
  if (!(std::abs(x) > 0) || !std::isfinite(x)) return "0";
  const int exponent = int(std::floor(std::log10(std::abs(x)))) - digits + 1;
  const long long n = std::llround(x / std::pow(10., exponent));
  const int leading = exponent + int(std::to_string(std::abs(n)).size()) - 1;
  const int most_places = 5;
  if (std::abs(leading) <= most_places) return decimal(n, exponent);
  return decimal(n, exponent - leading) + "e" + std::to_string(leading);
}

struct Plot_tick
{
  double value;
  std::string text;
};

// Round numbers, about `wanted` of them, from `min` to `max`.
inline std::vector<Plot_tick> linear_ticks(double min, double max, double wanted, bool whole_numbers = false)
{
  std::vector<Plot_tick> ticks;
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

// Those of a logarithmic axis: powers of ten, and as many numbers between them as there is room for.
inline std::vector<Plot_tick> logarithmic_ticks(double min, double max)
{
  const std::size_t least = 3, most = 7;
  for (const std::vector<double>& digits : {std::vector<double>{1, 1.5, 2, 3, 4, 5, 7}, {1, 2, 3, 5}, {1, 2, 5}, {1}}) {
    std::vector<Plot_tick> ticks;
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

// Values to pixels.
struct Plot_axis
{
  double min, max;   // of the values; both positive if the axis is logarithmic
  double begin, end; // in pixels
  bool is_logarithmic = false;

  double operator()(double x) const
  {
    const double u = is_logarithmic ? std::log(x / min) / std::log(max / min) : (x - min) / (max - min);
    return begin + u * (end - begin);
  }
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PLOTS_PLOT_AXIS_H
