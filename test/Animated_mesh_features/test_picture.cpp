// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures of scenes: the camera, what is seen and what is hidden, translucency, shadows, colours, panels, and files that an
// independent reader decodes to the same pixels.

#include "test_support.h"

#include "drawing/Canvas.h"
#include "pictures/picture_of_scene.h"
#include "pictures/strongest_frames.h"
#include "pictures/write_png.h"
#include "rendering/Contact_sheet.h"
#include "rendering/Depth_map.h"
#include "rendering/Ground.h"
#include "rendering/Illumination.h"
#include "rendering/Palette.h"
#include "rendering/Panel_cameras.h"
#include "rendering/Rasteriser.h"
#include "scenes/Shown_scene.h"
#include "views/Scene_views.h"
#include "views/View_choice.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/outer_sides.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <CGAL/Surface_mesh.h>

#ifdef ANIMATED_MESH_FEATURES_TEST_WITH_ZLIB
  #include <zlib.h>
#endif

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Animated_mesh_features;
using namespace Programs;
using namespace Programs::Rendering;
using namespace test_support;
using Eigen::Vector3d;

namespace {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Shown_feature Feature;

Surface triangle_soup(const std::vector<Vector3d>& points)
{
  Surface s;
  s.points = points;
  for (std::uint32_t i = 0; i + 2 < points.size(); i += 3) s.triangles.push_back({{i, i + 1, i + 2}});
  s.normals = vertex_normals(s.points, s.triangles);
  return s;
}

// A sphere of meridians and circles of latitude.
Surface sphere_surface(const Vector3d& centre, double radius, std::uint32_t n)
{
  Surface s;
  const auto vertex = [n](std::uint32_t i, std::uint32_t j) {
    return i == 0 ? 0 : i == n ? 1 : 2 + (i - 1) * 2 * n + j % (2 * n);
  };
  s.points = {centre + radius * Vector3d::UnitY(), centre - radius * Vector3d::UnitY()};
  for (std::uint32_t i = 1; i < n; ++i)
    for (std::uint32_t j = 0; j < 2 * n; ++j) {
      const double a = EIGEN_PI * i / n, b = EIGEN_PI * j / n;
      s.points.push_back(centre + radius * Vector3d(std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b)));
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < 2 * n; ++j) {
      if (i > 0) s.triangles.push_back({{vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)}});
      if (i + 1 < n) s.triangles.push_back({{vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)}});
    }
  s.normals = vertex_normals(s.points, s.triangles);
  return s;
}

// At (0, 0, 5), looking along -z.
Camera plain_camera(double width, double height, double focal_length)
{
  Camera c;
  c.eye = Vector3d(0, 0, 5);
  c.width = width;
  c.height = height;
  c.focal_length = focal_length;
  return c;
}

// -1: nothing.
long triangle_at(const Visible_surface& visible, std::size_t x, std::size_t y, long sample)
{
  long result = -1;
  for (std::size_t i = visible.first(x, y); i < visible.first(x + 1, y); ++i)
    if (visible.fragments()[i].samples >> sample & 1) {
      CHECK(result == -1); // one is the nearest
      result = long(visible.fragments()[i].triangle);
    }
  return result;
}

// use(x, y of the sample on the image, triangle or -1)
template <class Use>
void for_each_sample(const Visible_surface& visible, const Use& use)
{
  for (std::size_t y = 0; y < visible.height(); ++y)
    for (std::size_t x = 0; x < visible.width(); ++x)
      for (long s = 0; s < samples_per_pixel; ++s) {
        const Eigen::Array2d at = sample_offset(s);
        use(double(x) + at[0], double(y) + at[1], triangle_at(visible, x, y, s));
      }
}

void test_camera()
{
  const Camera c = plain_camera(100, 60, 80);
  const Vector3d p = c.project(Vector3d(1, 0.5, 1));
  CHECK_NEAR(p[0], 50 + 80. / 4, 1e-12);
  CHECK_NEAR(p[1], 30 - 80. / 8, 1e-12); // up is up
  CHECK_NEAR(p[2], 4, 1e-12);
  // twice as far, half as large
  CHECK_NEAR(c.project(Vector3d(1, 0.5, -3))[0], 50 + 80. / 8, 1e-12);
  CHECK_NEAR((c.eye + 4 * c.ray(p[0], p[1]) - Vector3d(1, 0.5, 1)).norm(), 0, 1e-12);

  View_direction view;
  view.up_axis = 2;
  CHECK_NEAR((view.to_camera() - Vector3d(1, 0, 0)).norm(), 0, 1e-12);
  view.azimuth = 90;
  CHECK_NEAR((view.to_camera() - Vector3d(0, 1, 0)).norm(), 0, 1e-12);
  view.elevation = 30;
  CHECK_NEAR(view.to_camera()[2], 0.5, 1e-12);
  view.up_axis = 1;
  view.azimuth = view.elevation = 0;
  CHECK_NEAR((view.to_camera() - Vector3d(0, 0, 1)).norm(), 0, 1e-12);

  // All points are inside of the room, and two opposite sides of it are touched.
  view.azimuth = 33;
  view.elevation = 21;
  const Surface body = sphere_surface(Vector3d(3, -2, 1), 0.7, 12);
  for (const double room_width : {60., 180.}) {
    const Camera fitted = fitted_camera(body.points, view, 200, 100, room_width, 80);
    double left = 200, right = 0, top = 100, bottom = 0;
    for (const Vector3d& q : body.points) {
      const Vector3d i = fitted.project(q);
      left = std::min(left, i[0]), right = std::max(right, i[0]);
      top = std::min(top, i[1]), bottom = std::max(bottom, i[1]);
    }
    CHECK(left > 100 - room_width / 2 - 1e-6 && right < 100 + room_width / 2 + 1e-6);
    CHECK(top > 10 - 1e-6 && bottom < 90 + 1e-6);
    if (room_width == 60)
      CHECK(std::abs(left - 70) < 1e-6 && std::abs(right - 130) < 1e-6);
    else
      CHECK(std::abs(top - 10) < 1e-6 && std::abs(bottom - 90) < 1e-6);
    CHECK_NEAR(fitted.right.dot(fitted.up), 0, 1e-12);
    CHECK(fitted.up[1] > 0);
  }
  CHECK(fitted_camera({Vector3d(1, 2, 3)}, view, 10, 10, 10, 10).project(Vector3d(1, 2, 3))[2] > 0);
}

void test_triangles()
{
  const Camera c = plain_camera(40, 30, 50);
  // At different distances; no sample is on a border.
  const double x0 = 10.03, y0 = 25.01, x1 = 35.07, y1 = 20.02, x2 = 20.01, y2 = 2.04;
  const auto at = [&](double x, double y, double distance) { return Vector3d(c.eye + distance * c.ray(x, y)); };
  const std::vector<Vector3d> corners = {at(x0, y0, 3), at(x1, y1, 7), at(x2, y2, 4)};
  const Visible_surface visible(triangle_soup(corners), c);
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  std::size_t inside = 0;
  double worst = 0;
  for_each_sample(visible, [&](double x, double y, long t) {
    const auto side = [&](double ax, double ay, double bx, double by) {
      return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    };
    const bool expected = side(x0, y0, x1, y1) < 0 && side(x1, y1, x2, y2) < 0 && side(x2, y2, x0, y0) < 0;
    CHECK((t == 0) == expected);
    if (t != 0) return;
    ++inside;
    // what is seen there, by intersecting the ray with the plane
    const Vector3d ray = c.ray(x, y);
    const Vector3d hit = c.eye + (corners[0] - c.eye).dot(normal) / ray.dot(normal) * ray;
    const Eigen::Array3d b = visible.coordinates(0, x, y);
    worst = std::max(worst, (b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2] - hit).norm());
    worst = std::max(worst, std::abs(1 / visible.image(0).value(x, y) - (c.eye - hit)[2]));
  });
  CHECK_NEAR(worst, 0, 1e-12);
  CHECK(std::abs(double(inside) / 16 - ((x1 - x0) * (y0 - y2) - (y0 - y1) * (x2 - x0)) / 2) < 2); // its area

  // Around a vertex: no sample is left out or belongs to two.
  std::vector<Vector3d> fan;
  for (int i = 0; i < 7; ++i)
    for (const Vector3d& p : {at(20.37, 15.21, 5), at(20 + 14 * std::cos(0.9 * i), 15 + 14 * std::sin(0.9 * i), 5),
                              at(20 + 14 * std::cos(0.9 * i + 0.9), 15 + 14 * std::sin(0.9 * i + 0.9), 5)})
      fan.push_back(p);
  for_each_sample(Visible_surface(triangle_soup(fan), c), [&](double x, double y, long t) {
    if (std::hypot(x - 20, y - 15) < 12.5) CHECK(t >= 0);
    if (std::hypot(x - 20, y - 15) > 14) CHECK(t == -1);
  });

  // Two that cross each other: the nearer one is seen.
  const std::vector<Vector3d> crossing = {at(5, 5, 3), at(35, 5, 6),    at(20, 28, 4), //
                                          at(5, 5, 6), at(20, 28, 4.2), at(35, 5, 3)};
  const Visible_surface both(triangle_soup(crossing), c);
  std::set<long> seen;
  for_each_sample(both, [&](double x, double y, long t) {
    if (t < 0) return;
    seen.insert(t);
    const std::size_t other = std::size_t(1 - t);
    if (both.image(other).coordinates(x, y).minCoeff() > 0)
      CHECK(both.image(std::size_t(t)).value(x, y) >= both.image(other).value(x, y) - 1e-6);
  });
  CHECK(seen.size() == 2);

  // Behind the camera, and without area: nothing.
  const Visible_surface nothing(
      triangle_soup({at(5, 5, 3), at(35, 5, -6), at(20, 28, 4), at(1, 1, 2), at(1, 1, 2), at(9, 9, 2)}), c);
  CHECK(nothing.fragments().empty());
}

void test_sphere_outlines()
{
  // Off the axis, where the outline is no circle.
  const Camera c = plain_camera(120, 90, 100);
  const Vector3d centre(1.4, 0.9, 1);
  const double radius = 1;
  const auto is_hit = [&](double x, double y) {
    const Vector3d ray = c.ray(x, y).normalized(), to = centre - c.eye;
    return (to - to.dot(ray) * ray).norm() < radius;
  };
  std::size_t hits = 0, wrong = 0;
  for_each_sample(Visible_surface(sphere_surface(centre, radius, 60), c), [&](double x, double y, long t) {
    hits += is_hit(x, y);
    wrong += (t >= 0) != is_hit(x, y);
  });
  CHECK(hits > 16 * 1500);
  CHECK(double(wrong) < 0.004 * double(hits)); // the polyhedron is 0.1 % smaller

  // The translucent one has the outline, and nothing is painted outside.
  const Sphere glass{centre, radius, Colour(0, 0, 1), 1, 1};
  const Sphere_painter painter({glass}, c, Vector3d(0, 1, 0), 1);
  const double infinity = std::numeric_limits<double>::infinity();
  std::size_t painted = 0;
  for (std::size_t y = 0; y < 90; ++y)
    for (std::size_t x = 0; x < 120; ++x) {
      const double px = double(x) + 0.5, py = double(y) + 0.5;
      const bool changed = !painter({0}, px, py, infinity, Colour::Ones()).isApprox(Colour::Ones());
      CHECK(changed == is_hit(px, py));
      painted += changed;
      const std::vector<std::size_t> row = painter.in_row(y);
      if (changed) CHECK(row.size() == 1 && painter.is_near(0, x));
    }
  CHECK(painted > 1500);
}

void test_translucency()
{
  const Camera c = plain_camera(100, 100, 100);
  const Sphere blue{Vector3d(0, 0, 0), 1, Colour(0, 0, 1), 1, 1}, red{Vector3d(0, 0, 2), 0.5, Colour(1, 0, 0), 1, 1};
  Sphere half = blue;
  half.opacity = 0.5f;
  const Vector3d light = Vector3d(0, 1, 0);
  const double far = 100;
  const auto seen = [&](const std::vector<Sphere>& spheres, double distance) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < spheres.size(); ++i) all.push_back(i);
    return Sphere_painter(spheres, c, light, 1)(all, 50.2, 50.2, distance, Colour(0.5f, 0.5f, 0.5f));
  };
  const Colour whole = seen({blue}, far);
  CHECK(whole[2] > 0.55f && whole[0] < 0.35f && whole[0] > 0.1f); // both the glass and what is behind it
  CHECK((seen({half}, far) - (whole + Colour(0.5f, 0.5f, 0.5f)) / 2).abs().maxCoeff() < 1e-3f);
  // The surface is before the sphere, at a distance of 5 - 1 - 0.1.
  CHECK(seen({blue}, 3.9).isApprox(Colour(0.5f, 0.5f, 0.5f)));
  // The nearer one is painted last, in whatever order they come.
  const Colour both = seen({blue, red}, far);
  CHECK(both.isApprox(seen({red, blue}, far)));
  CHECK(both[0] > both[2]);
  CHECK(both[2] > seen({red}, far)[2]);
  // The line in which the sphere meets a surface: at (1, 0, 0), at a distance of 5.
  const double x = 50 + 100. / 5;
  const Sphere_painter painter({blue}, c, light, 2);
  CHECK(painter({0}, x, 50, 5, Colour::Ones())[0] < 0.3f);
  CHECK(painter({0}, x + 3, 50, 5, Colour::Ones()).isApprox(Colour::Ones()));
}

void test_light()
{
  // A large square at y = 0, and a small one above it, lit from straight above.
  const auto square = [](double size, double y) {
    return std::vector<Vector3d>{{-size, y, -size}, {size, y, size},  {size, y, -size},
                                 {-size, y, -size}, {-size, y, size}, {size, y, size}};
  };
  std::vector<Vector3d> points = square(2, 0);
  for (const Vector3d& p : square(0.5, 1)) points.push_back(p);
  const Surface s = triangle_soup(points);
  const Vector3d up = Vector3d::UnitY();
  CHECK_NEAR((s.normals[0] - up).norm(), 0, 1e-12);
  const Depth_map map(s, Vector3d(0, 0.5, 0), 3, up);
  CHECK(map.visibility(Vector3d(1.5, 0, 0.3), up) == 1);
  CHECK(map.visibility(Vector3d(0.2, 0, 0.3), up) == 0);
  CHECK(map.visibility(Vector3d(0.2, 1, 0.3), up) == 1);
  CHECK(map.visibility(Vector3d(9, -3, 0), up) == 1);
  const float at_border = map.visibility(Vector3d(0.5, 0, 0), up);
  CHECK(at_border >= 0 && at_border <= 1);

  // Lambert's law, and no light from below.
  const Vector3d slanted = Vector3d(3, 4, 0).normalized();
  const std::vector<Light> lights = {{slanted, Colour(1, 0.5f, 0), false}, {-up, Colour(9, 9, 9), false}};
  std::vector<Shading_point> at(3);
  at[0].point = Vector3d(-1.8, 0, 1.5);
  at[1].point = Vector3d(-0.75, 0, 0); // in the shadow of the small square, which moves by 3/4
  at[2] = at[0];
  for (Shading_point& p : at) p.normal = up;
  at[2].normal = slanted;
  const std::vector<Shading> shading = illuminated(at, s, Vector3d(0, 0.5, 0), 3, lights);
  CHECK((shading[0].diffuse - 0.8f * Colour(1, 0.5f, 0)).abs().maxCoeff() < 1e-5f);
  CHECK(shading[1].diffuse.isZero());
  CHECK((shading[2].diffuse - Colour(1, 0.5f, 0)).abs().maxCoeff() < 1e-5f);

  // The whole studio: about 1 on a surface that faces the key light.
  const std::vector<Light> studio = studio_lights(up, Vector3d::UnitZ());
  float facing = 0;
  for (const Light& l : studio) {
    CHECK_NEAR(l.direction.norm(), 1, 1e-9);
    facing += luminance(l.colour) * float(std::max(0., l.direction.dot(studio.front().direction)));
  }
  CHECK_NEAR(facing, 1, 0.15);

  // The ground is darkest under the body, light far away, and invisible from below.
  Ground ground(up, -0.5, Vector3d(0, 0.5, 0), 3);
  const std::vector<Shading_point> on_ground = ground.points();
  ground.set_light(illuminated(on_ground, s, Vector3d(0, 0.5, 0), 3, studio).data(), studio);
  const Vector3d eye(0, 3, 12);
  const auto light_at = [&](double x, double z) { return ground.light(eye, Vector3d(x, -0.5, z) - eye); };
  CHECK(light_at(0, 0) < 0.5f);
  CHECK(light_at(0, 0) < light_at(2.2, 0) && light_at(2.2, 0) < 1);
  CHECK(light_at(50, 0) == 1);
  CHECK(ground.light(eye, Vector3d(0, 1, -1)) == 1);
  CHECK(ground.light(Vector3d(0, -3, 5), Vector3d(0, 1, -1)) == 1);
}

// Where the outside is known, the far side of a body throws no shadow that its near side does not throw.
void test_outer_sides()
{
  const auto all = [](const Surface& s, int side) {
    const std::vector<std::int8_t> sides = outer_sides(s.points, s.triangles);
    return sides.size() == s.triangles.size() && std::count(sides.begin(), sides.end(), std::int8_t(side)) == std::ptrdiff_t(sides.size());
  };
  const std::uint32_t n = 24;
  Surface sphere = sphere_surface(Vector3d(5, 1, 0), 2, n), reversed = sphere;
  for (Surface::Triangle& t : reversed.triangles) std::swap(t[0], t[1]);
  CHECK(all(sphere, 1) && all(reversed, -1));
  Surface open = sphere;
  open.triangles.pop_back();
  CHECK(all(open, 1)); // a hole of an edge or two
  open.triangles.resize(open.triangles.size() / 2);
  CHECK(all(open, 0));
  // of two parts, each by itself
  Surface both = sphere;
  const std::uint32_t first = std::uint32_t(both.points.size());
  for (const Vector3d& p : open.points) both.points.push_back(p + Vector3d(0, 0, 5));
  for (const Surface::Triangle& t : open.triangles) both.triangles.push_back({{t[0] + first, t[1] + first, t[2] + first}});
  const std::vector<std::int8_t> sides = outer_sides(both.points, both.triangles);
  CHECK(sides.front() == 1 && sides[sphere.triangles.size() - 1] == 1 && sides[sphere.triangles.size()] == 0);

  for (Surface* s : {&sphere, &reversed}) {
    const Depth_map whole(*s, Vector3d(5, 1, 0), 4, Vector3d(1, 2, 2) / 3, 200);
    s->outer_sides = outer_sides(s->points, s->triangles);
    const Depth_map near(*s, Vector3d(5, 1, 0), 4, Vector3d(1, 2, 2) / 3, 200);
    std::size_t dark = 0;
    for (double x = 1.5; x < 8.5; x += 0.1)
      for (double z = -3.5; z < 3.5; z += 0.1) {
        const float lit = near.visibility(Vector3d(x, -1.2, z), Vector3d::UnitY());
        dark += lit == 0;
        CHECK(lit == whole.visibility(Vector3d(x, -1.2, z), Vector3d::UnitY()));
      }
    CHECK(dark > 500);
  }
}

void test_colours()
{
  for (int i = 0; i < 256; ++i) {
    const Srgb8 grey = {{std::uint8_t(i), std::uint8_t(255 - i), 7}};
    CHECK(encoded(linear(grey)) == grey);
  }
  CHECK_NEAR(luminance(linear({{188, 188, 188}})), 0.5, 0.01); // half of the light is not half of the number
  const Eigen::Array3d red = lab_from_linear(Colour(1, 0, 0));
  CHECK((red - Eigen::Array3d(53.24, 80.09, 67.20)).abs().maxCoeff() < 0.05); // as tables have it
  CHECK((linear_from_lab(red) - Colour(1, 0, 0)).abs().maxCoeff() < 1e-3f);
}

// A matrix for linear colours from Machado, Oliveira, Fernandes (IEEE TVCG 15(6), 2009), severity 1.0.
Eigen::Matrix3f as_seen_without(char cones)
{
  Eigen::Matrix3f m;
  if (cones == 'L') // protanopia
    m << 0.152286f, 1.052583f, -0.204868f, 0.114503f, 0.786281f, 0.099216f, -0.003882f, -0.048116f, 1.051998f;
  else // 'M', deuteranopia
    m << 0.367322f, 0.860646f, -0.227968f, 0.280085f, 0.672501f, 0.047413f, -0.011820f, 0.042940f, 0.968881f;
  return m;
}

// CIELAB of n + 1 equidistant colours of a map, as somebody sees them.
std::vector<Eigen::Array3d> looks(const Colour_map& map, int n, const Eigen::Matrix3f& seen)
{
  std::vector<Eigen::Array3d> result;
  for (int i = 0; i <= n; ++i)
    result.push_back(lab_from_linear((seen * map(double(i) / n).matrix()).array().max(0.f).min(1.f)));
  return result;
}

double difference(const Eigen::Array3d& a, const Eigen::Array3d& b)
{
  return (a - b).matrix().norm();
}

void test_palette()
{
  const Eigen::Matrix3f fully = Eigen::Matrix3f::Identity();
  const int n = 32;
  // Equal steps, to within what rounding to the gamut and to a table cost; and no colour beyond the ends.
  for (const Colour_map* map : {&field_colours(), &duration_colours()}) {
    const std::vector<Eigen::Array3d> c = looks(*map, n, fully);
    double shortest = 1e9, longest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      shortest = std::min(shortest, difference(c[i], c[i + 1]));
      longest = std::max(longest, difference(c[i], c[i + 1]));
    }
    CHECK(longest < 1.1 * shortest);
    CHECK((*map)(-1).isApprox((*map)(0)) && (*map)(7).isApprox((*map)(1)));
  }

  // Fields can be read by lightness alone, whoever reads them: it falls, in even steps.
  for (const auto& [seen, evenness] : {std::make_pair(fully, 1.25), std::make_pair(as_seen_without('L'), 1.35),
                                       std::make_pair(as_seen_without('M'), 1.35)}) {
    const std::vector<Eigen::Array3d> c = looks(field_colours(), n, seen);
    double least = 1e9, most = 0;
    for (std::size_t i = 0; i < n; ++i) {
      least = std::min(least, c[i][0] - c[i + 1][0]);
      most = std::max(most, c[i][0] - c[i + 1][0]);
    }
    CHECK(least > 0 && most < evenness * least);
    CHECK(c.front()[0] > 90 && c.back()[0] < 35);
  }

  // Durations are told apart by everybody: quarters of the scale differ clearly, the longer the way the more, and there
  // is no place where nothing changes.
  for (const Eigen::Matrix3f& seen : {fully, as_seen_without('L'), as_seen_without('M')}) {
    const std::vector<Eigen::Array3d> c = looks(duration_colours(), n, seen);
    for (std::size_t i = 0; i < n; ++i) CHECK(difference(c[i], c[i + 1]) > 2);
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = i + n / 4; j <= n; ++j) {
        if (!(difference(c[i], c[j]) > 17))
          report(false, __FILE__, __LINE__,
                 "colours " + std::to_string(i) + ", " + std::to_string(j) + ": " +
                     std::to_string(difference(c[i], c[j])));
        CHECK(difference(c[i], c[j]) > 17);
      }
    CHECK(difference(c.front(), c.back()) > 90);
    // and no colour of a feature is one of the surface
    for (const Eigen::Array3d& feature : c)
      for (const Eigen::Array3d& surface : looks(field_colours(), n, seen))
        if ((seen - fully).isZero()) CHECK(difference(feature, surface) > 40);
  }
  CHECK(duration_colours()(0)[0] > 3 * duration_colours()(0)[2]); // red
  CHECK(duration_colours()(1)[2] > 3 * duration_colours()(1)[0]); // blue
}

void test_layout()
{
  // six wide ones in a wide picture: 3 x 2; upright ones: in one row
  CHECK(panels(6, 1600, 1000, 1.1)[5].left > 1000 && panels(6, 1600, 1000, 1.1)[5].top == 500);
  CHECK(panels(6, 1600, 500, 0.4)[5].top == 0);
  std::vector<char> covered(101 * 57, 0);
  for (const Panel& p : panels(6, 101, 57, 1.))
    for (std::size_t y = p.top; y < p.top + p.height; ++y)
      for (std::size_t x = p.left; x < p.left + p.width; ++x) ++covered[y * 101 + x];
  CHECK(std::set<char>(covered.begin(), covered.end()) == std::set<char>{1});

  const auto feature = [](std::size_t frame, double place, double strength) {
    Feature f;
    f.frame = frame;
    f.rest_position = {{place, 0, 0}};
    f.sigma = 0.1;
    f.strength = strength;
    return f;
  };
  // The second one is the first one again, the third is too near in time.
  const std::vector<Feature> features = {feature(30, 0, 9), feature(60, 0, 8), feature(31, 5, 7), feature(80, 5, 6)};
  CHECK(strongest_frames(features, 100, 2) == (std::vector<std::size_t>{30, 80}));
  CHECK(strongest_frames(features, 100, 3) == (std::vector<std::size_t>{30, 60, 80}));
  CHECK(strongest_frames(features, 100, 1) == (std::vector<std::size_t>{30}));
  CHECK(strongest_frames(std::vector<Feature>(), 100) == (std::vector<std::size_t>{50}));
  CHECK(strongest_frames(std::vector<Feature>{feature(1, 0, 1)}, 3) == (std::vector<std::size_t>{1}));
}

void test_panel_cameras()
{
  Surface body = sphere_surface(Vector3d(0, 0, 0), 1, 24);
  for (Vector3d& p : body.points) p[0] *= 3;
  View_direction view;
  view.azimuth = 30;
  // Cameras of panels follow the body over the ground, and not its jumps.
  Surface moved = body;
  for (Vector3d& p : moved.points) p += Vector3d(100, 0.5, 7);
  const Panel_cameras cameras({body, moved}, {{}, {}}, view);
  const Vector3d difference = cameras.camera(1, 90, 60, 80, 50).eye - cameras.camera(0, 90, 60, 80, 50).eye;
  CHECK_NEAR((difference - Vector3d(100, 0, 7)).norm(), 0, 1e-9);
  CHECK(cameras.aspect() > 1.5 && cameras.aspect() < 3.5);

  // From two sides: at the same distance, so far that both fit, the long side as well.
  View_direction end = view;
  view.azimuth = 0;
  end.azimuth = 90;
  const Panel_cameras sides({body, body}, {{}, {}}, {view, end});
  const Camera from_side = sides.camera(0, 90, 60, 80, 50), from_end = sides.camera(1, 90, 60, 80, 50);
  CHECK_NEAR(from_side.eye.norm(), from_end.eye.norm(), 1e-6);
  CHECK(from_end.eye[0] > 3 && from_side.eye[2] > 3);
  double widest = 0;
  for (const Vector3d& p : body.points)
    for (const Camera& c : {from_side, from_end}) {
      const Vector3d q = c.project(p);
      CHECK(std::abs(q[0] - 45) <= 40 + 1e-9 && std::abs(q[1] - 30) <= 25 + 1e-9);
      widest = (std::max)(widest, std::abs(q[0] - 45));
    }
  CHECK_NEAR(widest, 40, 1e-6);
  CHECK(sides.aspect() > 2.5 && sides.aspect() < 3.5);
}

// A sphere that is stretched, four frames, with a feature on each side.
struct Test_scene
{
  Mesh mesh;
  std::optional<Shown_sequence> sequence;
  std::vector<Feature> features;
  Spatio_temporal_field<double> field;

  Test_scene()
  {
    const Surface s = sphere_surface(Vector3d(0, 0, 0), 1, 10);
    for (const Vector3d& p : s.points) mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
    for (const auto& t : s.triangles) {
      typedef Mesh::Vertex_index V;
      mesh.add_face(V(t[0]), V(t[1]), V(t[2]));
    }
    std::vector<std::vector<Mesh::Point>> frames(4);
    field = Spatio_temporal_field<double>(s.points.size(), 4);
    for (std::size_t f = 0; f < 4; ++f)
      for (std::size_t v = 0; v < s.points.size(); ++v) {
        const Vector3d& p = s.points[v];
        frames[f].emplace_back(p[0] * (1 + 0.3 * double(f)), p[1], p[2]);
        field(v, f) = 0.3 * double(f) * std::abs(p[0]);
      }
    sequence.emplace(mesh, frames, 0.1);
    for (std::size_t i = 0; i < 2; ++i) {
      Feature f;
      f.vertex_index = 40 + 11 * i;
      f.triangle = {{f.vertex_index, f.vertex_index, f.vertex_index}};
      f.frame = 1 + i;
      f.time = 0.1 * double(f.frame);
      f.sigma = 0.2;
      f.tau = 0.05 * double(i + 1);
      f.strength = 1 - 0.1 * double(i);
      features.push_back(f);
    }
  }

  Shown_scene scene() const { return Shown_scene{*sequence, features, {{"deformation", &field}}, "test"}; }
};

void test_views()
{
  const auto direction = [](View_kind kind, int up) {
    View_choice choice;
    choice.kind = kind;
    return view_direction(told_angles(choice, up), Vector3d(Vector3d::Unit(up)));
  };
  CHECK_NEAR((direction(View_kind::FRONT, 1) - Vector3d(0, 0, 1)).norm(), 0, 1e-12);
  CHECK_NEAR((direction(View_kind::FRONT, 2) - Vector3d(0, -1, 0)).norm(), 0, 1e-12);
  CHECK_NEAR((direction(View_kind::BACK, 2) - Vector3d(0, 1, 0)).norm(), 0, 1e-12);
  for (int up : {1, 2}) { // the left of who looks at you is at your right
    CHECK_NEAR((direction(View_kind::LEFT, up) - Vector3d(1, 0, 0)).norm(), 0, 1e-12);
    CHECK_NEAR((direction(View_kind::RIGHT, up) - Vector3d(-1, 0, 0)).norm(), 0, 1e-12);
    CHECK(direction(View_kind::TOP, up)[up] > 0.99 && direction(View_kind::BOTTOM, up)[up] < -0.99);
  }
  CHECK(names(View_kind()).size() == 7);

  // A feature at a time, on opposite sides: seen from where the stronger one is; the other one from the other side.
  Test_scene data;
  const auto place = [&](std::size_t i) {
    const std::size_t v = data.features[i].vertex_index;
    return Vector3d(data.sequence->trajectories().point(v, 1));
  };
  std::size_t opposite = 0; // in the middle of the sphere's height
  double least = 0;
  for (std::size_t v = 0; v < data.sequence->number_of_vertices(); ++v) {
    const double cosine = data.sequence->trajectories().point(v, 0).dot(data.sequence->trajectories().point(
        data.features[0].vertex_index, 0));
    if (cosine < least) least = cosine, opposite = v;
  }
  data.features[1].vertex_index = opposite;
  data.features[1].frame = 3;
  data.features[1].time = 0.3;
  for (Feature& f : data.features) f.tau = 0.02;
  const Scene_views views = scene_views(data.scene(), 2);
  CHECK(views.up_axis == 2);
  CHECK(views.selection.views[0].direction.dot(place(0)) > 0);
  for (const auto& v : views.selection.views) CHECK(v.angles.elevation > 5 - 1e-6 && v.angles.elevation < 50 + 1e-6);
  CHECK(views.view_of_frame(1) == 0);
  CHECK(views.selection.views[views.view_of_frame(3)].direction.dot(place(1)) > 0);
}

#ifdef DETECT_FEATURES_WITH_PICTURES

void test_scene_pictures()
{
  const Test_scene data;
  const Shown_scene scene = data.scene();
  Picture_options options;
  options.width = 320;
  options.height = 200;
  options.frames = {1, 2};
  const Srgb_image picture = picture_of_scene(scene, options);
  CHECK(picture.width() == 320 && picture.height() == 200);
  const Srgb8 white = {{255, 255, 255}};
  CHECK(picture(0, 0) == white && picture(319, 199) == white);
  CHECK(picture(80, 90) != white && picture(240, 90) != white); // bodies
  std::size_t dark = 0;                                         // letters: nothing else is there
  for (std::size_t x = 0; x < 80; ++x)
    for (std::size_t y = 0; y < 13; ++y) dark += picture(x, y)[0] < 190;
  CHECK(dark > 20);

  #ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1u, 3u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(picture_of_scene(scene, options).pixels() == picture.pixels());
  }
  #endif

  const auto differs = [&](const Picture_options& o) {
    return picture_of_scene(scene, o).pixels() != picture.pixels();
  };
  Picture_options other = options;
  other.frames = {1, 3};
  CHECK(differs(other));
  other = options;
  other.view.kind = View_kind::ANGLES;
  other.view.azimuth = 100;
  CHECK(differs(other));
  // the views that a scene has are those that it is seen from
  Shown_scene with_views = scene;
  const Scene_views views = scene_views(scene, std::nullopt);
  with_views.views = &views;
  CHECK(picture_of_scene(with_views, options).pixels() == picture.pixels());
  other = options;
  other.up_axis = 0;
  CHECK(differs(other));
  other = options;
  other.background = {{20, 30, 40}};
  const Srgb_image night = picture_of_scene(scene, other);
  CHECK(night(0, 0) == (Srgb8{{20, 30, 40}}));
  // Without a field or features there is still a picture.
  const std::vector<Feature> none;
  other.frames.clear();
  CHECK(picture_of_scene(Shown_scene{*data.sequence, none, {}, ""}, other)(160, 90) != other.background);

  // The legend: red, short, is left of blue, long.
  const auto reddest = [&](int channel) {
    std::size_t best = 0;
    int most = -1000;
    for (std::size_t x = 160; x < 320; ++x) {
      const Srgb8 p = picture(x, 191);
      const int excess = 2 * p[std::size_t(channel)] - p[1] - p[std::size_t(2 - channel)];
      if (excess > most) most = excess, best = x;
    }
    return best;
  };
  CHECK(reddest(0) < reddest(2));

  const auto check_refused = [&](auto change, const std::string& message) {
    Picture_options o = options;
    change(o);
    CHECK_THROWS(Option_error, picture_of_scene(scene, o), message);
  };
  check_refused([](auto& o) { o.frames = {4}; }, "there is no frame 4 to be shown; frames are 0 to 3");
  check_refused([](auto& o) { o.frames.assign(101, 0); }, "at most 100");
  check_refused([](auto& o) { o.frames.assign(100, 0); }, "too small for 100 frames");
  check_refused([](auto& o) { o.width = 63; }, "64 to 16384");
  check_refused([](auto& o) { o.height = 16385; }, "64 to 16384");
  check_refused([](auto& o) { o.width = o.height = 16384; }, "too large");
  check_refused([](auto& o) { o.view.elevation = 90; }, "elevation");
  check_refused([](auto& o) { o.view.azimuth = std::numeric_limits<double>::quiet_NaN(); }, "azimuth");
  check_refused([](auto& o) { o.up_axis = 3; }, "axis 3");
}

#else

void test_scene_pictures()
{
  std::cout << "skipped: pictures of scenes, which need cairo" << std::endl;
}

#endif

#if defined(ANIMATED_MESH_FEATURES_TEST_WITH_ZLIB) && defined(DETECT_FEATURES_WITH_PICTURES)

std::uint32_t big_endian(const std::string& s, std::size_t i)
{
  std::uint32_t x = 0;
  for (std::size_t k = 0; k < 4; ++k) x = x << 8 | static_cast<unsigned char>(s[i + k]);
  return x;
}

// A reader of PNG of its own, for 8 bits RGB without interlace.
std::vector<Srgb8> decoded(const std::string& png, std::size_t& width, std::size_t& height)
{
  CHECK(png.substr(0, 8) == std::string("\x89PNG\r\n\x1a\n"));
  std::string data;
  std::vector<std::string> types;
  for (std::size_t i = 8; i < png.size();) {
    const std::uint32_t length = big_endian(png, i);
    const std::string type = png.substr(i + 4, 4), content = png.substr(i + 8, length);
    if (types.empty() || types.back() != type) types.push_back(type);
    CHECK(big_endian(png, i + 8 + length) ==
          crc32(0, reinterpret_cast<const Bytef*>(png.data() + i + 4), uInt(length + 4)));
    if (type == "IHDR") {
      width = big_endian(content, 0);
      height = big_endian(content, 4);
      CHECK(content.substr(8) == std::string("\x08\x02\0\0\0", 5));
    }
    if (type == "IDAT") data += content;
    i += 12 + length;
  }
  CHECK(types == std::vector<std::string>({"IHDR", "bKGD", "IDAT", "IEND"}));
  std::vector<unsigned char> raw(height * (3 * width + 1));
  uLongf size = uLongf(raw.size());
  CHECK(uncompress(raw.data(), &size, reinterpret_cast<const Bytef*>(data.data()), uLong(data.size())) == Z_OK);
  CHECK(size == raw.size());
  std::vector<std::vector<int>> rows(height + 1,
                                     std::vector<int>(3 * width + 3, 0)); // a row and a pixel of zeros before
  std::vector<Srgb8> pixels;
  for (std::size_t y = 0; y < height; ++y) {
    const unsigned char* const in = &raw[y * (3 * width + 1)];
    for (std::size_t i = 0; i < 3 * width; ++i) {
      const int a = rows[y + 1][i], b = rows[y][i + 3], c = rows[y][i];
      int predicted = 0;
      if (in[0] == 1) predicted = a;
      if (in[0] == 2) predicted = b;
      if (in[0] == 3) predicted = (a + b) / 2;
      if (in[0] == 4) {
        const int pa = std::abs(b - c), pb = std::abs(a - c), pc = std::abs(a + b - 2 * c);
        predicted = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      }
      CHECK(in[0] <= 4);
      rows[y + 1][i + 3] = (in[i + 1] + predicted) & 255;
    }
    for (std::size_t x = 0; x < width; ++x) {
      const int* const p = &rows[y + 1][3 * x + 3];
      pixels.push_back({{std::uint8_t(p[0]), std::uint8_t(p[1]), std::uint8_t(p[2])}});
    }
  }
  return pixels;
}

void test_png()
{
  // rows for which each of the filters is best, noise among them
  Srgb_image image(37, 25);
  std::uint32_t random = 1;
  for (std::size_t y = 0; y < 25; ++y)
    for (std::size_t x = 0; x < 37; ++x)
      for (std::size_t i = 0; i < 3; ++i) {
        random = random * 1664525 + 1013904223;
        const std::size_t kinds[] = {random >> 24, 5 * x + i, 7 * y + 91 * i + (x * x) % 5, 3 * x + 4 * y,
                                     x * y + (random >> 31)};
        image(x, y)[i] = std::uint8_t(kinds[y / 5]);
      }
  std::size_t width = 0, height = 0;
  CHECK(decoded(Canvas(image).file(), width, height) == image.pixels());
  CHECK(width == 37 && height == 25);
  CHECK(Canvas(image).image().pixels() == image.pixels());
  CHECK(Canvas(image).file() == Canvas(image).file());

  const Test_scene data;
  Picture_options options;
  options.width = 128;
  options.height = 100;
  options.frames = {2};
  std::ostringstream os;
  write_png(os, data.scene(), options);
  CHECK(decoded(os.str(), width, height) == picture_of_scene(data.scene(), options).pixels());
}

#else

void test_png()
{
  std::cout << "skipped: files, which need cairo, and zlib to be read" << std::endl;
}

#endif

} // namespace

int main()
{
  test_scene_pictures();
#ifndef ANIMATED_MESH_FEATURES_TEST_THREADS_ONLY
  test_camera();
  test_triangles();
  test_sphere_outlines();
  test_translucency();
  test_light();
  test_outer_sides();
  test_colours();
  test_palette();
  test_layout();
  test_panel_cameras();
  test_views();
  test_png();
#endif
  return test_result();
}
