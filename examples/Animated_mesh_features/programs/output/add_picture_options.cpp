// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/add_picture_options.h"

#include "options/Option_groups.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

namespace {

void set_frame(const Argument& argument, Picture_options& options)
{
  options.frames.push_back(argument.count());
}

void set_size(const Argument& argument, Picture_options& options)
{
  const std::size_t by = argument.text().find('x');
  if (by == std::string::npos) argument.refuse("is no size such as 1600x1000");
  options.width = argument.part(0, by).count();
  options.height = argument.part(by + 1).count();
}

void set_background(const Argument& argument, Picture_options& options)
{
  const std::string& text = argument.text();
  const std::string hex = text[0] == '#' ? text.substr(1) : text;
  if (hex.size() != 6 || hex.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
    argument.refuse("is no colour such as ffffff");
  for (std::size_t i = 0; i < 3; ++i)
    options.background[i] = std::uint8_t(std::strtoul(hex.substr(2 * i, 2).c_str(), nullptr, 16));
}

void set_view(const Argument& argument, Picture_options& options)
{
  std::string all;
  for (const auto& n : names(View_kind())) {
    if (n.first == argument.text()) {
      options.view.kind = n.second;
      return;
    }
    all += n.first + ", ";
  }
  const std::size_t comma = argument.text().find(',');
  if (comma == std::string::npos) argument.refuse("is no view: " + all + "or a pair of angles such as 30,10");
  options.view.kind = View_kind::ANGLES;
  options.view.azimuth = argument.part(0, comma).number();
  options.view.elevation = argument.part(comma + 1).number();
}

void set_up_axis(const Argument& argument, Picture_options& options)
{
  const std::string& text = argument.text();
  if (text != "x" && text != "y" && text != "z")
    throw Option_error(argument.option() + ": there is no \"" + text + "\"; choose among x, y, z");
  options.up_axis = text[0] - 'x';
}

// A use of an argument: it sets an option of the picture, if there is one.
Option_group::Use of_picture(Output_options& o, void (*set)(const Argument&, Picture_options&))
{
  return [&o, set](const Argument& a) {
    if (!o.has_scene(Scene_format::PNG))
      throw Option_error(a.option() + " goes with --png, the picture that it is about");
    set(a, o.picture);
  };
}

// The same of what pages and views have, too.
Option_group::Use of_view(Output_options& o, void (*set)(const Argument&, Picture_options&), bool is_for_views)
{
  return [&o, set, is_for_views](const Argument& a) {
    const bool is_used = o.has_scene(Scene_format::PNG) || o.has_scene(Scene_format::HTML) ||
                         (is_for_views && (o.has_scene(Scene_format::VIEWS) || o.has_scene(Scene_format::VIEW_MAP)));
    if (!is_used)
      throw Option_error(a.option() + " goes with --png or --html" + (is_for_views ? ", --views or --view-map" : "") +
                         ", the scenes that are looked at from somewhere");
    set(a, o.picture);
  };
}

} // namespace

void add_picture_options(Option_group& group, Output_options& o)
{
  group.add_repeatable(
      "frame", "N",
      "a frame to be shown in the picture, counted from 0; repeatable: several are shown beside each other",
      of_picture(o, set_frame));
  group.add("png-size", "WxH", "the size of the picture in pixels (default: 1600x1000)", of_picture(o, set_size));
  group.add("png-background", "RRGGBB", "its background, hexadecimal (default: ffffff, white)",
            of_picture(o, set_background));
  group.add("view", "VIEW",
            "where the picture is taken from, and the page opens: auto, front, back, left, right, top, bottom, or "
            "AZIMUTH,ELEVATION in degrees: around the vertical axis, counterclockwise seen from above, from +z if y "
            "points up and from +x if z does; above the horizon, -89 to 89. The front is at +z, or at -y if z points "
            "up (default: auto, from where most of the features is seen, 5 to 50 degrees above the horizon)",
            of_view(o, set_view, false));
  group.add("up", "AXIS",
            "the axis that points up in the picture: x, y or z (default: y or z, on which the body stands)",
            of_view(o, set_up_axis, true));
}

} // namespace Programs
