// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace Programs::Rendering {

namespace {

// A channel, 0 to 1.
float linear_from_srgb(float s)
{
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

float srgb_from_linear(float l)
{
  return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f;
}

// The number of a channel, rounded, without a power for each: where in linear light each number begins, and with which
// one to begin to look.
class Srgb_steps
{
public:
  Srgb_steps()
  {
    for (std::size_t i = 0; i < 255; ++i) m_end[i] = linear_from_srgb((float(i) + 0.5f) / 255);
    for (std::size_t i = 0; i < m_first.size(); ++i)
      m_first[i] = std::uint8_t(srgb_from_linear(float(i) / float(m_first.size())) * 255);
  }

  std::uint8_t operator()(float l) const
  {
    if (!(l > 0)) return 0;
    if (l >= 1) return 255;
    std::size_t i = m_first[std::size_t(l * float(m_first.size()))];
    while (i < 255 && l >= m_end[i]) ++i;
    return std::uint8_t(i);
  }

private:
  std::array<float, 255> m_end;
  std::array<std::uint8_t, 4096> m_first;
};

// The white point D65 of sRGB, in CIE XYZ.
Eigen::Array3d white_point()
{
  return Eigen::Array3d(0.95047, 1, 1.08883);
}

} // namespace

Colour linear(const Srgb8& c)
{
  return Colour(linear_from_srgb(float(c[0]) / 255), linear_from_srgb(float(c[1]) / 255),
                linear_from_srgb(float(c[2]) / 255));
}

Srgb8 encoded(const Colour& c)
{
  static const Srgb_steps steps;
  return {{steps(c[0]), steps(c[1]), steps(c[2])}};
}

std::string hexadecimal(const Srgb8& c)
{
  const char* const digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t x : c) {
    text += digits[x / 16];
    text += digits[x % 16];
  }
  return text;
}

Eigen::Array3d lab_from_linear(const Colour& c)
{
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Eigen::Array3d xyz = (to_xyz * c.cast<double>().matrix()).array() / white_point();
  const auto f = [](double t) { return t > 216. / 24389 ? std::cbrt(t) : (24389. / 27 * t + 16) / 116; };
  const Eigen::Array3d g(f(xyz[0]), f(xyz[1]), f(xyz[2]));
  return Eigen::Array3d(116 * g[1] - 16, 500 * (g[0] - g[1]), 200 * (g[1] - g[2]));
}

Colour linear_from_lab(const Eigen::Array3d& lab)
{
  const double y = (lab[0] + 16) / 116;
  const auto f = [](double t) { return t > 6. / 29 ? t * t * t : (116 * t - 16) * 27 / 24389; };
  const Eigen::Array3d xyz = Eigen::Array3d(f(y + lab[1] / 500), f(y), f(y - lab[2] / 200)) * white_point();
  Eigen::Matrix3d from_xyz;
  from_xyz << 3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252;
  return (from_xyz * xyz.matrix()).array().cast<float>().max(0.f).min(1.f);
}

} // namespace Programs::Rendering
