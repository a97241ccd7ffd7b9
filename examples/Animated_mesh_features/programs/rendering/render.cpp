// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/render.h"

#include "rendering/Ground.h"
#include "rendering/Illumination.h"
#include "rendering/Lights.h"
#include "rendering/Palette.h"
#include "rendering/Rasteriser.h"
#include "running/Interruption.h"

#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Programs::Rendering {

namespace {

// Where the surface is seen, one point for each fragment: in the middle of its samples.
std::vector<Shading_point> points_of_fragments(const Visible_surface& visible, const Surface& surface,
                                               const Camera& camera, std::vector<float>& values)
{
  std::vector<Shading_point> points(visible.fragments().size());
  values.assign(surface.values.empty() ? 0 : points.size(), 0);
  const auto shade = [&](std::size_t i, std::size_t x, std::size_t y) {
    const Fragment& fragment = visible.fragments()[i];
    Eigen::Array2d middle = Eigen::Array2d::Zero();
    int n = 0;
    for (long s = 0; s < samples_per_pixel; ++s)
      if (fragment.samples >> s & 1) middle += sample_offset(s), ++n;
    const Eigen::Array3d b =
        visible.coordinates(fragment.triangle, double(x) + middle[0] / n, double(y) + middle[1] / n);
    const Surface::Triangle& t = surface.triangles[fragment.triangle];
    const auto interpolated = [&](const std::vector<Eigen::Vector3d>& v) {
      return Eigen::Vector3d(b[0] * v[t[0]] + b[1] * v[t[1]] + b[2] * v[t[2]]);
    };
    Shading_point& p = points[i];
    p.point = interpolated(surface.points);
    p.to_eye = (camera.eye - p.point).normalized();
    const Eigen::Vector3d flat =
        (surface.points[t[1]] - surface.points[t[0]]).cross(surface.points[t[2]] - surface.points[t[0]]);
    p.normal = interpolated(surface.normals);
    const double length = p.normal.norm();
    p.normal = length > 0 ? Eigen::Vector3d(p.normal / length) : flat.normalized();
    // Both sides are seen alike: a surface with a border has an inside, and which side is out is not known.
    if (flat.dot(p.to_eye) < 0) p.normal = -p.normal;
    if (!values.empty())
      values[i] =
          float(b[0]) * surface.values[t[0]] + float(b[1]) * surface.values[t[1]] + float(b[2]) * surface.values[t[2]];
  };
  CGAL::Animated_mesh_features::parallel_for<CGAL::Parallel_if_available_tag>(0, visible.height(), [&](std::size_t y) {
    Interruption::check();
    for (std::size_t x = 0; x < visible.width(); ++x)
      for (std::size_t i = visible.first(x, y); i < visible.first(x + 1, y); ++i) shade(i, x, y);
  });
  return points;
}

// Leaves what is not too bright as it is, and lets highlights run smoothly into white.
Colour developed(const Colour& c)
{
  const float shoulder = 0.8f;
  return c.unaryExpr(
      [=](float x) { return x <= shoulder ? x : 1 - (1 - shoulder) * std::exp(-(x - shoulder) / (1 - shoulder)); });
}

// 0 at the border of an image, 1 inside: shadows fade, so that panels beside each other have no visible border.
float inwardness(double x)
{
  const double fading = 0.1; // of the image
  const double t = (std::min)(1., (std::min)(x, 1 - x) / fading);
  return float(t * t * (3 - 2 * t));
}

// The mean of a pixel's samples, in linear light.
Colour resolved(const Visible_surface& visible, const std::vector<Colour>& colours, const Colour& background,
                const Sphere_painter& painter, const std::vector<std::size_t>& spheres, std::size_t x, std::size_t y)
{
  Colour sum = Colour::Zero();
  unsigned covered = 0;
  const auto add = [&](const Colour& colour, unsigned samples, const auto& distance) {
    for (long s = 0; s < samples_per_pixel; ++s) {
      if (!(samples >> s & 1)) continue;
      if (spheres.empty()) {
        sum += colour;
        continue;
      }
      const Eigen::Array2d at = sample_offset(s) + Eigen::Array2d(double(x), double(y));
      sum += painter(spheres, at[0], at[1], distance(at), colour);
    }
    covered |= samples;
  };
  for (std::size_t i = visible.first(x, y); i < visible.first(x + 1, y); ++i) {
    const Fragment& f = visible.fragments()[i];
    const Triangle_scan image = visible.image(f.triangle);
    add(colours[i], f.samples, [&](const Eigen::Array2d& at) { return 1 / image.value(at[0], at[1]); });
  }
  const unsigned all = (1u << samples_per_pixel) - 1;
  add(background, all & ~covered, [](const Eigen::Array2d&) { return std::numeric_limits<double>::infinity(); });
  return sum / float(samples_per_pixel);
}

} // namespace

Image render(const Surface& surface, const Camera& camera, const Stage_set& set)
{
  const std::size_t width = std::size_t(camera.width), height = std::size_t(camera.height);
  Eigen::Vector3d low = Eigen::Vector3d::Constant((std::numeric_limits<double>::max)()), high = -low;
  for (const Eigen::Vector3d& p : surface.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector3d centre = (low + high) / 2;
  const double radius = (high - low).norm() / 2;
  const std::vector<Light> lights = studio_lights(set.up, -camera.forward);

  const Visible_surface visible(surface, camera);
  Ground ground(set.up, set.ground, centre, radius);
  std::vector<Colour> colours;
  {
    std::vector<float> values;
    std::vector<Shading_point> points = points_of_fragments(visible, surface, camera, values);
    const std::size_t on_surface = points.size();
    const std::vector<Shading_point> on_ground = ground.points();
    points.insert(points.end(), on_ground.begin(), on_ground.end());
    const std::vector<Shading> shading = illuminated(points, surface, centre, radius, lights);
    colours.reserve(on_surface);
    for (std::size_t i = 0; i < on_surface; ++i) {
      const Colour colour = values.empty() ? set.clay : field_colours()(values[i]);
      colours.push_back(developed(colour * shading[i].diffuse + shading[i].highlight));
    }
    ground.set_light(shading.data() + on_surface, lights);
  }
  const Sphere_painter painter(set.spheres, camera, lights.front().direction, set.line_width);

  Image image(width, height, Colour::Zero());
  CGAL::Animated_mesh_features::parallel_for<CGAL::Parallel_if_available_tag>(0, height, [&](std::size_t y) {
    Interruption::check();
    const std::vector<std::size_t> row = painter.in_row(y);
    std::vector<std::size_t> spheres;
    for (std::size_t x = 0; x < width; ++x) {
      spheres.clear();
      for (std::size_t i : row)
        if (painter.is_near(i, x)) spheres.push_back(i);
      const double px = double(x) + 0.5, py = double(y) + 0.5;
      const float shadow = 1 - ground.light(camera.eye, camera.ray(px, py));
      const float light = 1 - shadow * inwardness(px / camera.width) * inwardness(py / camera.height);
      const Colour background = light * set.background;
      image(x, y) = resolved(visible, colours, background, painter, spheres, x, y);
    }
  });
  return image;
}

} // namespace Programs::Rendering
