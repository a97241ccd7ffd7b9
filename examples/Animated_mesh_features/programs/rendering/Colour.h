// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_COLOUR_H
#define PROGRAMS_RENDERING_COLOUR_H

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>

namespace Programs::Rendering {

// A colour in linear light, with the primaries of sRGB: what light adds up in.
typedef Eigen::Array3f Colour;

// 8 bits a channel, encoded as sRGB (IEC 61966-2-1): what screens and files have.
typedef std::array<std::uint8_t, 3> Srgb8;

Colour linear(const Srgb8& c);

// Clamped to what sRGB has, and rounded.
Srgb8 encoded(const Colour& c);

// `#rrggbb`, as style sheets have it.
std::string hexadecimal(const Srgb8& c);

// The colour a fraction `t` of the way from `a` to `b`, in linear light. Inline, as what is called for every sample.
inline Colour mix(const Colour& a, const Colour& b, float t)
{
  return a + t * (b - a);
}

// Relative luminance, 0 to 1.
inline float luminance(const Colour& c)
{
  return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
}

// CIELAB (D65) of a colour: distances in it are about what people see.
Eigen::Array3d lab_from_linear(const Colour& c);

// The colour of a place in CIELAB (D65), clamped to what sRGB has.
Colour linear_from_lab(const Eigen::Array3d& lab);

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_COLOUR_H
