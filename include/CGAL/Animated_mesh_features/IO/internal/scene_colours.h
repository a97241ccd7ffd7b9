// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SCENE_COLOURS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SCENE_COLOURS_H

#include <CGAL/Animated_mesh_features/IO/Scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Red, green and blue in linear light, with the primaries of sRGB, from 0 to 1.
typedef std::array<double, 3> Linear_rgb;

inline double srgb_of_linear(double x)
{
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

// The colour of a place in Oklab (B. Ottosson, 2020), in which equal distances look equal, clamped to what sRGB has.
inline Linear_rgb rgb_of_oklab(double lightness, double a, double b)
{
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  Linear_rgb rgb = {{4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                     -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                     -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s}};
  for (double& x : rgb) x = (std::min)(1., (std::max)(0., x));
  return rgb;
}

// Of a field: from 0, the colour of sand, to 1, a deep blue-green. Lightness falls evenly, so that the order can be read
// without seeing hues; what does not deform looks like clay, and neither end is taken for a feature.
inline Linear_rgb field_colour(double t)
{
  const double degree = std::acos(-1.) / 180;
  const double chroma = 0.022 + 0.068 * t, hue = (85 + 165 * std::pow(t, 0.8)) * degree;
  return rgb_of_oklab(0.9 - 0.52 * t, chroma * std::cos(hue), chroma * std::sin(hue));
}

// Of a feature: from 0, a short event, red, over purple to 1, a long one, blue.
inline Linear_rgb tau_colour(double t)
{
  struct Oklab
  {
    double lightness, a, b;
  };
  constexpr Oklab red = {0.609, 0.190, 0.103}, purple = {0.610, 0.165, -0.088}, blue = {0.558, -0.025, -0.215};
  const bool is_short = t < 0.5;
  const Oklab &from = is_short ? red : purple, &to = is_short ? purple : blue;
  const double u = is_short ? 2 * t : 2 * t - 1;
  return rgb_of_oklab(from.lightness + u * (to.lightness - from.lightness), from.a + u * (to.a - from.a),
                      from.b + u * (to.b - from.b));
}

// Where each feature's tau lies between the shortest and the longest one, by ratio, from 0 to 1.
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

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SCENE_COLOURS_H
