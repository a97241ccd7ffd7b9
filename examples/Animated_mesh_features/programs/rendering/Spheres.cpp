// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Spheres.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Programs::Rendering {

namespace {

constexpr float line_opacity = 0.85f;

Colour dark(const Sphere& s)
{
  return 0.4f * s.colour;
}

struct Hit
{
  double distance;
  std::size_t sphere;
};

} // namespace

Sphere_painter::Sphere_painter(std::vector<Sphere> spheres, const Camera& camera, const Eigen::Vector3d& to_light,
                               double line_width)
  : m_spheres(std::move(spheres))
  , m_camera(camera)
  , m_to_light(to_light)
  , m_line_width(line_width)
{
  for (const Sphere& s : m_spheres) m_boxes.push_back(box(s));
}

std::vector<std::size_t> Sphere_painter::in_row(std::size_t y) const
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < m_spheres.size(); ++i)
    if (m_spheres[i].opacity > 0 && m_boxes[i][1] <= double(y + 1) && double(y) <= m_boxes[i][3]) result.push_back(i);
  return result;
}

Colour Sphere_painter::operator()(const std::vector<std::size_t>& spheres, double x, double y, double distance,
                                  const Colour& farther) const
{
  const Eigen::Vector3d ray = m_camera.ray(x, y);
  const double length = ray.norm();
  Colour result = farther;
  for (std::size_t i : spheres) draw_line(m_spheres[i], ray, distance, result);
  std::vector<Hit> hits;
  for (std::size_t i : spheres) {
    const double t = first_hit(m_spheres[i], ray / length) / length;
    if (t > 0 && t < distance) hits.push_back({t, i});
  }
  // the farthest first
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.sphere > b.sphere;
  });
  for (const Hit& h : hits) draw_glass(m_spheres[h.sphere], ray, h.distance, result);
  return result;
}

Sphere_painter::Box Sphere_painter::box(const Sphere& s) const
{
  const Eigen::Vector3d p = m_camera.project(s.centre);
  if (!(p[2] > s.radius)) return {{0, 0, m_camera.width, m_camera.height}}; // around the camera
  // The outline is an ellipse, longest away from the centre of the image.
  const Eigen::Vector3d to_centre = s.centre - m_camera.eye;
  const double slope = to_centre.norm() / p[2];
  const double r = m_camera.focal_length * s.radius / (p[2] - s.radius) * slope + m_line_width;
  return {{p[0] - r, p[1] - r, p[0] + r, p[1] + r}};
}

// Along a ray of length 1; negative: it misses.
double Sphere_painter::first_hit(const Sphere& s, const Eigen::Vector3d& ray) const
{
  const Eigen::Vector3d to_centre = s.centre - m_camera.eye;
  const double nearest = to_centre.dot(ray);
  const double beyond = s.radius * s.radius - (to_centre - nearest * ray).squaredNorm();
  return beyond >= 0 ? nearest - std::sqrt(beyond) : -1;
}

// Whether a place on an outline lies between two of twelve dashes.
bool Sphere_painter::is_gap(const Sphere& s, const Eigen::Vector3d& from_centre) const
{
  if (!s.is_dashed) return false;
  const double pi = double(EIGEN_PI), period = pi / 6;
  const double angle = std::atan2(from_centre.dot(m_camera.up), from_centre.dot(m_camera.right));
  return std::fmod(angle + 2 * pi, period) > 0.6 * period;
}

// Where the sphere meets the surface.
void Sphere_painter::draw_line(const Sphere& s, const Eigen::Vector3d& ray, double distance, Colour& colour) const
{
  if (!std::isfinite(distance)) return;
  const Eigen::Vector3d from_centre = m_camera.eye + distance * ray - s.centre;
  const double off = std::abs(from_centre.norm() - s.radius);
  const double half_width = m_line_width / 2 * distance / m_camera.focal_length;
  if (off < half_width && !is_gap(s, from_centre)) colour = mix(colour, dark(s), line_opacity * s.opacity);
}

void Sphere_painter::draw_glass(const Sphere& s, const Eigen::Vector3d& ray, double distance, Colour& colour) const
{
  const Eigen::Vector3d normal = (m_camera.eye + distance * ray - s.centre) / s.radius;
  const Eigen::Vector3d to_eye = -ray.normalized();
  const float grazing = float(1 - (std::max)(0., normal.dot(to_eye)));
  // as much glass as the ray passes, and more towards the outline
  const float glass = (0.55f + 0.35f * grazing * grazing) * s.filling;
  const float light = float(0.75 + 0.25 * normal.dot(m_to_light));
  colour = mix(colour, light * s.colour, glass * s.opacity);
  // the outline, as wide as a line whatever the size of the sphere
  const double pixels = m_camera.focal_length * s.radius / distance;
  const double inward = pixels * (1 - std::sqrt((std::max)(0., 1 - double((1 - grazing) * (1 - grazing)))));
  const double edge = (std::min)(1., (std::max)(0., m_line_width - inward));
  if (edge > 0 && !is_gap(s, normal)) colour = mix(colour, dark(s), line_opacity * s.opacity * float(edge));
  const Eigen::Vector3d half = (m_to_light + to_eye).normalized();
  const double mirrored = (std::max)(0., half.dot(normal)), m2 = mirrored * mirrored, m8 = m2 * m2 * m2 * m2;
  const double m16 = m8 * m8, m64 = m16 * m16 * m16 * m16;
  const float shine = float(m64 * m16 * m8 * m2); // to the power of 90
  colour = mix(colour, Colour::Ones(), 0.75f * shine * s.opacity);
}

} // namespace Programs::Rendering
