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
#include "rendering/Contact_sheet.h"
#include "rendering/Depth_map.h"
#include "rendering/Panel_cameras.h"
#include "rendering/render.h"
#include "views/Scene_views.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
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

// Where each frame is seen from; and the ranks of those that are chosen, from 0.
std::vector<Rendering::View_direction> views_of_frames(const Shown_scene& scene, const Picture_options& options,
                                                       const std::vector<std::size_t>& frames,
                                                       std::vector<std::size_t>& ranks)
{
  std::optional<Scene_views> own;
  const Scene_views* views = nullptr;
  if (options.view.kind == View_kind::AUTO) {
    if (scene.views == nullptr) own = scene_views(scene, options.up_axis);
    views = own ? &*own : scene.views;
  }
  std::vector<Rendering::View_direction> result;
  for (std::size_t f : frames) {
    Rendering::View_direction view;
    view.up_axis = views != nullptr ? views->up_axis : scene_up_axis(scene, options.up_axis);
    ranks.push_back(views != nullptr ? views->view_of_frame(f) : 0);
    const AMF::View_angles angles =
        views != nullptr ? views->selection.views[ranks.back()].angles : told_angles(options.view, view.up_axis);
    view.azimuth = angles.azimuth;
    view.elevation = angles.elevation;
    result.push_back(view);
  }
  return result;
}

// Writes the ranks of features on their spheres, the strongest first, as far as there is room: of those that are present
// and not behind the body.
void draw_ranks(Canvas& canvas, const Rendering::Surface& body, const std::vector<Rendering::Sphere>& spheres,
                const Rendering::Camera& camera, const Rendering::Panel& panel, const Text_style& style,
                const Rendering::Srgb8& halo)
{
  const float present = 0.5f; // opacity
  const std::size_t most = 15;
  const double text = style.size * capital_height;
  Eigen::Vector3d low = body.points.front(), high = low;
  for (const Eigen::Vector3d& p : body.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Rendering::Depth_map depth(body, (low + high) / 2, (high - low).norm() / 2, -camera.forward);
  std::vector<Eigen::Vector2d> places;
  for (const Rendering::Sphere& s : spheres) {
    if (s.rank == 0 || s.opacity < present || places.size() == most) continue;
    if (!(depth.visibility(s.centre, -camera.forward) > 0)) continue;
    const Eigen::Vector2d p = camera.project(s.centre).head<2>();
    if (p[0] < text || p[0] > double(panel.width) - text || p[1] < text || p[1] > double(panel.height) - text) continue;
    const auto is_near = [&](const Eigen::Vector2d& q) {
      return std::abs(p[0] - q[0]) < 2.2 * text && std::abs(p[1] - q[1]) < 1.5 * text;
    };
    if (std::any_of(places.begin(), places.end(), is_near)) continue;
    places.push_back(p);
    Text_style small = style;
    small.anchor = 0.5;
    small.is_bold = true;
    const std::string number = std::to_string(s.rank);
    const double x = double(panel.left) + p[0], y = double(panel.top) + p[1] + text / 2, around = 0.14 * text;
    small.colour = halo;
    for (int i = 0; i < 8; ++i) {
      const double turn = i * double(EIGEN_PI) / 4;
      canvas.text(x + around * std::cos(turn), y + around * std::sin(turn), number, small);
    }
    small.colour = style.colour;
    canvas.text(x, y, number, small);
  }
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

  std::vector<std::size_t> view_ranks;
  const std::vector<Rendering::View_direction> views = views_of_frames(scene, options, frames, view_ranks);
  const bool has_several_views = *std::max_element(view_ranks.begin(), view_ranks.end()) > 0;
  const Rendering::Panel_cameras cameras(bodies, spheres, views);

  const double text = text_height(options.width, options.height);
  const double legend_height = 3.6 * text, margin = 2.2 * text; // a line of text and the space around it
  const double side_margin = 0.7 * text;
  const std::size_t legend_top = options.height - std::size_t(legend_height);
  Rendering::Srgb_image picture(options.width, options.height, options.background);
  const std::vector<Rendering::Panel> panels =
      Rendering::panels(frames.size(), options.width, legend_top, cameras.aspect());
  Rendering::Stage_set set;
  set.up = views.front().up();
  set.ground = pictures.lowest(views.front().up_axis);
  set.background = Rendering::linear(options.background);
  set.line_width = 0.14 * text;
  std::vector<Rendering::Camera> set_cameras;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Rendering::Panel& panel = panels[i];
    if (panel.width == 0 || panel.height == 0)
      throw AMF::Option_error("the picture is too narrow for " + std::to_string(panels.size()) + " frames");
    const double width = double(panel.width), height = double(panel.height);
    set.spheres = spheres[i];
    set_cameras.push_back(cameras.camera(i, width, height, (std::max)(width / 2, width - 2 * side_margin),
                                         (std::max)(height / 2, height - 2 * margin)));
    copy(render(bodies[i], set_cameras.back(), set), panel, picture);
  }

  Canvas canvas(picture);
  Text_style style;
  style.size = text / capital_height;
  style.colour = ink_on(set.background);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const std::string label = pictures.label(frames[i]) +
                              (has_several_views ? "   view " + std::to_string(view_ranks[i] + 1) : std::string());
    Text_style fitting = style;
    fitting.size *= (std::min)(1., (double(panels[i].width) - 2 * text) / canvas.text_width(label, style));
    if (fitting.size > 0) canvas.text(double(panels[i].left) + text, double(panels[i].top) + 2 * text, label, fitting);
  }
  Text_style number = style;
  number.size *= 0.8;
  for (std::size_t i = 0; i < panels.size(); ++i)
    draw_ranks(canvas, bodies[i], spheres[i], set_cameras[i], panels[i], number, options.background);
  draw_legend(canvas, pictures.legend(), double(options.width), double(legend_top), legend_height, style);
  return canvas.image();
}

} // namespace Programs
