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
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Programs::Rendering {

namespace {

// Where the surface is seen, one point for each fragment: in the middle of its samples.
std::vector<Shading_point> points_of_fragments(const Visible_surface& visible, const Surface& surface,
                                               const Camera& camera, std::vector<float>& values,
                                               std::vector<Eigen::Array3d>& coordinates)
{
  std::vector<Shading_point> points(visible.fragments().size());
  values.assign(surface.values.empty() ? 0 : points.size(), 0);
  coordinates.resize(points.size());
  const auto shade = [&](std::size_t i, std::size_t x, std::size_t y) {
    const Fragment& fragment = visible.fragments()[i];
    Eigen::Array2d middle = Eigen::Array2d::Zero();
    int n = 0;
    for (long s = 0; s < samples_per_pixel; ++s)
      if (fragment.samples >> s & 1) middle += sample_offset(s), ++n;
    const Eigen::Array3d b =
        visible.coordinates(fragment.triangle, double(x) + middle[0] / n, double(y) + middle[1] / n);
    coordinates[i] = b;
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

// Which fragment lights a fragment: the first one of its pixel that faces about the same way, as neighbouring triangles that
// are smaller than a pixel do.
std::vector<std::size_t> lit_fragments(const Visible_surface& visible, const std::vector<Shading_point>& points)
{
  const double same = 0.95; // cosine
  std::vector<std::size_t> result(points.size());
  for (std::size_t y = 0; y < visible.height(); ++y)
    for (std::size_t x = 0; x < visible.width(); ++x)
      for (std::size_t first = visible.first(x, y), i = first; i < visible.first(x + 1, y); ++i) {
        result[i] = i;
        for (std::size_t j = first; j < i; ++j)
          if (result[j] == j && points[j].normal.dot(points[i].normal) > same) {
            result[i] = j;
            break;
          }
      }
  return result;
}

// The light of the soft lights on fragments: that at vertices, between which it hardly changes; or, where triangles are
// large, that at each fragment.
class Soft_light
{
public:
  Soft_light(const Visible_surface& visible, const Surface& surface, const std::vector<Shading_point>& fragments)
    : m_is_back(fragments.size(), 0)
    , m_rank(2 * surface.points.size(), none)
  {
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      const Surface::Triangle& t = surface.triangles[visible.fragments()[i].triangle];
      const Eigen::Vector3d flat =
          (surface.points[t[1]] - surface.points[t[0]]).cross(surface.points[t[2]] - surface.points[t[0]]);
      m_is_back[i] = flat.dot(fragments[i].to_eye) < 0;
      for (std::uint32_t v : t) {
        if (surface.normals[v].isZero()) continue;
        std::size_t& rank = m_rank[2 * v + std::size_t(m_is_back[i])];
        if (rank != none) continue;
        rank = m_points.size();
        Shading_point p;
        p.point = surface.points[v];
        p.normal = m_is_back[i] ? Eigen::Vector3d(-surface.normals[v]) : surface.normals[v];
        m_points.push_back(p);
      }
    }
    const std::size_t most_fragments = 40; // for a vertex
    m_is_at_vertices = fragments.size() <= most_fragments * m_points.size();
    if (m_is_at_vertices) return;
    m_points = fragments;
    for (Shading_point& p : m_points) p.to_eye.setZero();
  }

  // the points that have to be lit
  const std::vector<Shading_point>& points() const { return m_points; }

  Colour at(std::size_t fragment, const Surface::Triangle& t, const Eigen::Array3d& b, const Shading* shading) const
  {
    if (!m_is_at_vertices) return shading[fragment].diffuse;
    Colour sum = Colour::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t rank = m_rank[2 * t[i] + std::size_t(m_is_back[fragment])];
      if (rank == none) continue;
      sum += float(b[int(i)]) * shading[rank].diffuse;
      weight += b[int(i)];
    }
    return weight > 0 ? Colour(sum / float(weight)) : sum;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  std::vector<char> m_is_back;     // which side of the triangle a fragment shows
  std::vector<std::size_t> m_rank; // of each vertex's front and back among the points
  std::vector<Shading_point> m_points;
  bool m_is_at_vertices = true;
};

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

// The corners of a pixel if all samples are asked for; of others the first and the last one.
std::array<long, 4> probes(unsigned samples)
{
  if (samples == (1u << samples_per_pixel) - 1)
    return {{0, samples_per_side - 1, samples_per_pixel - samples_per_side, samples_per_pixel - 1}};
  long first = 0, last = samples_per_pixel - 1;
  while (!(samples >> first & 1)) ++first;
  while (!(samples >> last & 1)) --last;
  return {{first, first, last, last}};
}

// The mean of a pixel's samples, in linear light.
Colour resolved(const Visible_surface& visible, const std::vector<Colour>& colours, const Colour& background,
                const Sphere_painter& painter, const std::vector<std::size_t>& spheres, std::size_t x, std::size_t y)
{
  Colour sum = Colour::Zero();
  unsigned covered = 0;
  const unsigned all = (1u << samples_per_pixel) - 1;
  const auto add = [&](const Colour& colour, unsigned samples, const auto& distance) {
    covered |= samples;
    if (samples == 0) return;
    const std::size_t number = std::bitset<samples_per_pixel>(samples).count();
    const auto through = [&](long s) {
      const Eigen::Array2d at = sample_offset(s) + Eigen::Array2d(double(x), double(y));
      return painter(spheres, at[0], at[1], distance(at), colour);
    };
    if (spheres.empty()) {
      sum += float(number) * colour;
      return;
    }
    // Away from outlines and lines the glass changes little within a pixel: its corners tell.
    const std::array<long, 4> corners = probes(samples);
    Colour low = through(corners[0]), high = low, corner_sum = low;
    std::size_t different = 1;
    for (std::size_t k = 1; k < 4; ++k) {
      if (corners[k] == corners[k - 1]) continue;
      const Colour c = through(corners[k]);
      low = low.min(c), high = high.max(c), corner_sum += c;
      ++different;
    }
    if ((high - low).maxCoeff() < 1.f / 64) {
      sum += float(number) / float(different) * corner_sum;
      return;
    }
    for (long s = 0; s < samples_per_pixel; ++s)
      if (samples >> s & 1) sum += through(s);
  };
  for (std::size_t i = visible.first(x, y); i < visible.first(x + 1, y); ++i) {
    const Fragment& f = visible.fragments()[i];
    const Triangle_scan image = spheres.empty() ? Triangle_scan() : visible.image(f.triangle);
    add(colours[i], f.samples, [&](const Eigen::Array2d& at) { return 1 / image.value(at[0], at[1]); });
  }
  if (covered != all)
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
    std::vector<Eigen::Array3d> coordinates;
    const std::vector<Shading_point> points = points_of_fragments(visible, surface, camera, values, coordinates);
    std::vector<Light> hard, soft;
    for (const Light& l : lights) (l.is_soft ? soft : hard).push_back(l);
    const std::vector<Shading_point> on_ground = ground.points();

    // In soft light it is not seen what half a per cent of the body hides.
    const std::size_t large_maps = 360, small_maps = 192;

    // the lights whose shadows are sharp, on a fragment of each pixel
    const std::vector<std::size_t> lit = lit_fragments(visible, points);
    std::vector<Shading_point> at;
    std::vector<std::size_t> rank(points.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      if (lit[k] == k) rank[k] = at.size(), at.push_back(points[k]);
    const std::size_t number_lit = at.size();
    at.insert(at.end(), on_ground.begin(), on_ground.end());
    const std::vector<Shading> sharp = illuminated(at, surface, centre, radius, hard, large_maps);

    // those from all around
    const Soft_light soft_light(visible, surface, points);
    at = soft_light.points();
    const std::size_t number_soft = at.size();
    at.insert(at.end(), on_ground.begin(), on_ground.end());
    const std::vector<Shading> dim = illuminated(at, surface, centre, radius, soft, small_maps);

    colours.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Shading& key = sharp[rank[lit[k]]];
      const Surface::Triangle& t = surface.triangles[visible.fragments()[k].triangle];
      const Colour diffuse = key.diffuse + soft_light.at(k, t, coordinates[k], dim.data());
      const Colour colour = values.empty() ? set.clay : field_colours()(values[k]);
      colours.push_back(developed(colour * diffuse + key.highlight));
    }
    std::vector<Shading> ground_light(sharp.begin() + std::ptrdiff_t(number_lit), sharp.end());
    for (std::size_t k = 0; k < ground_light.size(); ++k) ground_light[k].diffuse += dim[number_soft + k].diffuse;
    ground.set_light(ground_light.data(), lights);
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
