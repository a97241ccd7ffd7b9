// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_DRAW_SURFACES_H
#define ANIMATED_MESH_FEATURES_DRAW_SURFACES_H

#include "drawing/Canvas.h"
#include "drawing/Legend.h"
#include "rendering/Contact_sheet.h"
#include "rendering/Panel_cameras.h"
#include "rendering/render.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace figures {

struct Labelled_surface
{
  std::string label;
  Programs::Rendering::Surface surface;
};

/// draws surfaces beside each other, each with its label above it and all from the same direction, with a legend below if
/// it has bars. A PNG.
inline void draw_surfaces(const std::string& path, const std::vector<Labelled_surface>& bodies,
                          const Programs::Rendering::View_direction& view, std::size_t height,
                          const std::vector<Programs::Legend_bar>& legend)
{
  using namespace Programs;
  using namespace Programs::Rendering;
  std::vector<Surface> surfaces;
  double ground = 0;
  for (const Labelled_surface& body : bodies) {
    for (const Eigen::Vector3d& p : body.surface.points) ground = (std::min)(ground, p.dot(view.up()));
    surfaces.push_back(body.surface);
  }
  const Panel_cameras cameras(surfaces, std::vector<std::vector<Sphere>>(bodies.size()), view);
  const std::size_t width = 1280, legend_top = height - (legend.empty() ? 0 : 44);
  const double text = 11;
  Srgb_image picture(width, height, {{255, 255, 255}});
  const std::vector<Panel> all = panels(bodies.size(), width, legend_top, cameras.aspect());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Panel& panel = all[i];
    Stage_set set;
    set.up = view.up();
    set.ground = ground;
    const double w = double(panel.width), h = double(panel.height);
    const Image image = render(surfaces[i], cameras.camera(i, w, h, w - 20, h - 60), set);
    for (std::size_t y = 0; y < panel.height; ++y)
      for (std::size_t x = 0; x < panel.width; ++x) picture(panel.left + x, panel.top + y) = encoded(image(x, y));
  }
  Canvas canvas(picture);
  Text_style style;
  style.size = text / capital_height;
  style.colour = ink_on(Colour::Ones());
  style.anchor = 0.5;
  for (std::size_t i = 0; i < all.size(); ++i)
    canvas.text(double(all[i].left) + double(all[i].width) / 2, double(all[i].top) + 2 * text, bodies[i].label, style);
  style.anchor = 0;
  if (!legend.empty())
    draw_legend(canvas, legend, double(width), double(legend_top), double(height - legend_top), style);

  std::ofstream out(path, std::ios::binary);
  const std::string png = canvas.file();
  out.write(png.data(), std::streamsize(png.size()));
  if (!out) throw std::runtime_error("cannot write " + path);
}

} // namespace figures

#endif // ANIMATED_MESH_FEATURES_DRAW_SURFACES_H
