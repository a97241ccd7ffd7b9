// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/parse_picture_options.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace Programs {

void parse_picture_frame(const Argument& argument, Picture_options& options)
{
  options.frames.push_back(argument.count());
}

void parse_picture_size(const Argument& argument, Picture_options& options)
{
  const std::size_t by = argument.text().find('x');
  if (by == std::string::npos) argument.refuse("is no size such as 1600x1000");
  options.width = argument.part(0, by).count();
  options.height = argument.part(by + 1).count();
}

void parse_picture_background(const Argument& argument, Picture_options& options)
{
  const std::string& text = argument.text();
  const std::string hex = text[0] == '#' ? text.substr(1) : text;
  if (hex.size() != 6 || hex.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
    argument.refuse("is no colour such as ffffff");
  for (std::size_t i = 0; i < 3; ++i)
    options.background[i] = std::uint8_t(std::strtoul(hex.substr(2 * i, 2).c_str(), nullptr, 16));
}

void parse_picture_view(const Argument& argument, Picture_options& options)
{
  const std::size_t comma = argument.text().find(',');
  if (comma == std::string::npos) argument.refuse("is no pair of angles such as 30,10");
  options.azimuth = argument.part(0, comma).number();
  options.elevation = argument.part(comma + 1).number();
}

void parse_picture_up_axis(const Argument& argument, Picture_options& options)
{
  const std::string& text = argument.text();
  if (text != "x" && text != "y" && text != "z")
    throw CGAL::Animated_mesh_features::Option_error(argument.option() + ": there is no \"" + text +
                                                     "\"; choose among x, y, z");
  options.up_axis = text[0] - 'x';
}

} // namespace Programs
