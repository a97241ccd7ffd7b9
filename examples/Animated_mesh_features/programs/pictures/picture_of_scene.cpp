// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/picture_of_scene.h"

#include "drawing/Canvas.h"
#include "drawing/Legend.h"
#include "pictures/Scene_pictures.h"
#include "pictures/strongest_frames.h"
#include "rendering/Body_view.h"
#include "rendering/Contact_sheet.h"
#include "rendering/Panel_cameras.h"
#include "rendering/render.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

// The height of capitals, pixels: readable also when the picture is shown at half its size.
double text_height(std::size_t width, std::size_t height)
{
  return (std::max)(6., 0.0145 * std::sqrt(double(width) * double(height)));
}

void copy(const Rendering::Image& image, const Rendering::Panel& panel, Rendering::Srgb_image& picture)
{
  for (std::size_t y = 0; y < panel.height; ++y)
    for (std::size_t x = 0; x < panel.width; ++x)
      picture(panel.left + x, panel.top + y) = Rendering::encoded(image(x, y));
}

// Of the rest shape: where what moves would stand.
std::vector<Eigen::Vector3d> measured_points(const Shown_scene& scene)
{
  const AMF::Rest_shape& shape = scene.sequence.rest_shape();
  std::vector<Eigen::Vector3d> result;
  for (AMF::Rest_shape::Index v : shape.measured_vertices()) result.push_back(shape.points()[v]);
  return result;
}

} // namespace

Rendering::Srgb_image picture_of_scene(const Shown_scene& scene, const Picture_options& options)
{
  check_picture_options(options);
  check_picture_frames(options, scene.sequence.number_of_frames());
  check_scene(scene);
  if (scene.sequence.number_of_vertices() == 0) throw AMF::Input_error("there is no surface to be shown");
  const Scene_pictures pictures(scene);
  const std::vector<std::size_t> frames =
      options.frames.empty() ? strongest_frames(scene.features, scene.sequence.number_of_frames()) : options.frames;

  std::vector<Rendering::Surface> bodies;
  std::vector<std::vector<Rendering::Sphere>> spheres;
  for (std::size_t f : frames) {
    bodies.push_back(pictures.surface(f));
    spheres.push_back(pictures.spheres(f));
  }

  Rendering::View_direction view;
  view.up_axis = options.up_axis ? *options.up_axis : Rendering::probable_up_axis(measured_points(scene));
  view.elevation = options.elevation;
  view.azimuth = options.azimuth ? *options.azimuth : Rendering::good_azimuth(bodies, spheres, view);

  const Rendering::Panel_cameras cameras(bodies, spheres, view);

  const double text = text_height(options.width, options.height);
  const double legend_height = 3.6 * text, margin = 2.2 * text; // a line of text and the space around it
  const std::size_t legend_top = options.height - std::size_t(legend_height);
  Rendering::Srgb_image picture(options.width, options.height, options.background);
  const std::vector<Rendering::Panel> panels =
      Rendering::panels(frames.size(), options.width, legend_top, cameras.aspect());
  Rendering::Stage_set set;
  set.up = view.up();
  set.ground = pictures.lowest(view.up_axis);
  set.background = Rendering::linear(options.background);
  set.line_width = 0.14 * text;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Rendering::Panel& panel = panels[i];
    if (panel.width == 0 || panel.height == 0)
      throw AMF::Option_error("the picture is too narrow for " + std::to_string(panels.size()) + " frames");
    const double width = double(panel.width), height = double(panel.height);
    set.spheres = spheres[i];
    copy(render(bodies[i],
                cameras.camera(i, width, height, (std::max)(width / 2, width - 2 * margin),
                               (std::max)(height / 2, height - 2 * margin)),
                set),
         panel, picture);
  }

  Canvas canvas(picture);
  Text_style style;
  style.size = text / capital_height;
  style.colour = ink_on(set.background);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::string label = pictures.label(frames[i]);
    Text_style fitting = style;
    fitting.size *= (std::min)(1., (double(panels[i].width) - 2 * text) / canvas.text_width(label, style));
    if (fitting.size > 0) canvas.text(double(panels[i].left) + text, double(panels[i].top) + 2 * text, label, fitting);
  }
  draw_legend(canvas, pictures.legend(), double(options.width), double(legend_top), legend_height, style);
  return canvas.image();
}

} // namespace Programs
