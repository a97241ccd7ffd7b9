// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Viewpoint selection: directions and angles, what is hidden against rays, scores against what can be computed, the choice
// of views against all choices, paths of a camera against all paths.

#include "test_shapes.h"
#include "test_support.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/Area_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/Entropy_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/camera_path.h>
#include <CGAL/Animated_mesh_features/Applications/select_views.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

using namespace test_support;
using namespace CGAL::Animated_mesh_features;
typedef Frame_sequence<Mesh> Sequence;

// A shape that is moved in each frame.
struct Animated
{
  Mesh mesh;
  std::unique_ptr<Sequence> sequence;

  template <class Move>
  Animated(const Shape& shape, std::size_t frames, const Move& move, double frame_duration = 0.1)
    : mesh(mesh_of(shape))
  {
    std::vector<Points> points;
    for (std::size_t f = 0; f < frames; ++f)
      points.push_back(mapped(shape.points, [&](const Vec& p) { return Vec(move(p, f)); }));
    sequence = std::make_unique<Sequence>(mesh, frames_of(points), frame_duration);
    sequence->set_rest_shape(mesh.points(), Rest_unit::KEEP);
  }
  explicit Animated(const Shape& shape, std::size_t frames = 3)
    : Animated(shape, frames, [](const Vec& p, std::size_t) { return p; })
  {}
};

Shape sphere_shape(std::size_t subdivisions, double radius = 1, const Vec& centre = Vec::Zero())
{
  const View_sphere sphere(subdivisions);
  Shape s;
  for (const Vec& d : sphere.directions()) s.points.push_back(centre + radius * d);
  for (const auto& t : sphere.triangles()) s.faces.push_back({{int(t[0]), int(t[1]), int(t[2])}});
  return s;
}

// n x n squares across `normal`, of sides 2 `half_width`
Shape plate(const Vec& centre, const Vec& normal, double half_width, int n)
{
  const Vec u = normal.unitOrthogonal(), v = normal.cross(u);
  Shape s;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      s.points.push_back(centre + half_width * ((2. * i / n - 1) * u + (2. * j / n - 1) * v));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      s.faces.push_back({{a, a + 1, a + n + 2}});
      s.faces.push_back({{a, a + n + 2, a + n + 1}});
    }
  return s;
}

std::size_t nearest_vertex(const Shape& s, const Vec& place)
{
  std::size_t best = 0;
  for (std::size_t v = 0; v < s.points.size(); ++v)
    if ((s.points[v] - place).norm() < (s.points[best] - place).norm()) best = v;
  return best;
}

Feature_point feature(std::size_t vertex, double sigma, double amplitude = 1, std::size_t frame = 1, double tau = 0.1)
{
  Feature_point f;
  f.vertex_index = vertex;
  f.triangle = {{vertex, vertex, vertex}};
  f.frame = frame;
  f.time = 0.1 * double(frame);
  f.sigma = sigma;
  f.tau = tau;
  f.amplitude = f.strength = amplitude;
  return f;
}

// ----------------------------------------------------------------------------------------------------------- directions

void test_directions()
{
  for (std::size_t s : {0u, 1u, 2u, 3u, 4u}) {
    const View_sphere sphere(s);
    const std::size_t n = 10 * (std::size_t(1) << (2 * s)) + 2;
    CHECK(sphere.directions().size() == n);
    CHECK(sphere.triangles().size() == 2 * n - 4); // Euler
    double worst = 0, area = 0;
    for (const Vec& d : sphere.directions()) worst = (std::max)(worst, std::abs(d.norm() - 1));
    CHECK(worst < 1e-15 * 4);
    bool is_outward = true;
    for (const auto& t : sphere.triangles()) {
      const Vec &a = sphere.directions()[t[0]], &b = sphere.directions()[t[1]], &c = sphere.directions()[t[2]];
      const double volume = a.cross(b).dot(c);
      is_outward = is_outward && volume > 0;
      // the solid angle: A. van Oosterom, J. Strackee, 1983
      area += 2 * std::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    CHECK(is_outward);
    CHECK_NEAR(area, 4 * pi, 1e-9);
    // opposites to the last bit: one projection each
    CHECK(internal::view_pairs(sphere.directions()).size() == n / 2);
  }
  CHECK_NEAR(View_sphere(0).longest_edge(), std::atan(2), 1e-12); // of an icosahedron
  CHECK(View_sphere(2).longest_edge() < 21 * pi / 180 && View_sphere(3).longest_edge() < 10.5 * pi / 180);
  CHECK_THROWS(Option_error, View_sphere(7), "at most 6");
}

void test_angles()
{
  const Vec x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto is = [](const Vec& d, const Vec& up, double azimuth, double elevation) {
    const View_angles a = view_angles(d, up);
    CHECK_NEAR(a.azimuth, azimuth, 1e-12);
    CHECK_NEAR(a.elevation, elevation, 1e-12);
    CHECK_NEAR((view_direction(a, up) - d).norm(), 0, 1e-12);
  };
  is(z, y, 0, 0);
  is(x, y, 90, 0);
  is(x, z, 0, 0);
  is(y, z, 90, 0);
  is(y, x, 0, 0);
  is(-x, z, 180, 0);
  is(z, z, 0, 90);
  is(-z, z, 0, -90);
  is(Vec(0, -1, 1).normalized(), z, -90, 45);
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Vec up = random.vector().normalized(), d = random.vector().normalized();
    const View_angles a = view_angles(d, up);
    CHECK_NEAR((view_direction(a, up) - d).norm(), 0, 1e-12);
    CHECK_NEAR(std::sin(a.elevation * pi / 180), d.dot(up), 1e-12);
  }
}

// a sphere that is stretched to half axes
Shape ellipsoid(const Vec& centre, const Vec& half_axes)
{
  Shape s = sphere_shape(2);
  for (Vec& p : s.points) p = centre + half_axes.cwiseProduct(p);
  return s;
}

// A body stands on its feet, whichever axis is up, and however its vertices are spread.
void test_up_axis()
{
  const auto up_of = [](const Shape& shape) { return probable_up_axis(Animated(shape).sequence->rest_shape()); };
  // a trunk on four legs; x is to the side, z ahead
  const auto animal = [](double length, double spread) {
    Shape s = ellipsoid(Vec(0, 1, 0), Vec(0.25, 0.3, length));
    for (double x : {-0.15, 0.15})
      for (double z : {-spread, spread}) s.add(ellipsoid(Vec(x, 0.45, z), Vec(0.06, 0.45, 0.06)));
    return s;
  };
  const Shape standing = animal(0.8, 0.6);
  // one whose hind legs are as far behind as its rump, and on whose hind parts are most vertices: on end it seems to stand
  Shape behind = animal(0.7, 0.6);
  for (int i = 0; i < 20; ++i) behind.add(ellipsoid(Vec(0, 0.5 + 0.02 * i, -0.5), Vec(0.15, 0.1, 0.05)));
  for (Shape s : {standing, behind}) {
    CHECK(up_of(s) == 1);
    for (Vec& p : s.points) p = Vec(p[2], p[0], p[1]);
    CHECK(up_of(s) == 2);
  }
  CHECK(up_of(sphere_shape(2, 1, Vec(5, 6, 7))) == 1);
  // what lies is as broad one way as the other
  CHECK(up_of(plate(Vec(0, 0, 0), Vec(0, 1, 0), 1, 4)) == 1);
  CHECK(up_of(plate(Vec(0, 0, 0), Vec(0, 0, 1), 1, 4)) == 2);
}

// ----------------------------------------------------------------------------------------------------------- visibility

// Of every vertex, for tests: an item each, of the same weight.
struct Visibility_score
{
  std::size_t n;
  std::size_t number_of_frames() const { return 1; }
  std::size_t first_item(std::size_t k) const { return k * n; }
  double weight(std::size_t) const { return 1; }
  void operator()(const Surface_view& view, float* seen) const
  {
    for (std::size_t v = 0; v < n; ++v) seen[v] = float(view.visibility(v));
    if (kept != nullptr) kept->assign(seen, seen + n);
  }
  std::vector<float>* kept = nullptr;
};

std::vector<float> visibility(const Animated& a, const Vec& direction, std::size_t resolution = 256)
{
  std::vector<float> result;
  score_views(*a.sequence, {0}, {direction}, Visibility_score{a.sequence->number_of_vertices(), &result}, Any_visitor(),
              resolution);
  return result;
}

// Does a ray meet a triangle beyond its start? (T. Möller, B. Trumbore, 1997)
bool meets(const Vec& from, const Vec& ray, const Vec& a, const Vec& b, const Vec& c)
{
  const Vec u = b - a, v = c - a, p = ray.cross(v);
  const double determinant = u.dot(p);
  if (std::abs(determinant) < 1e-14) return false;
  const Vec t = from - a, q = t.cross(u);
  const double s = t.dot(p) / determinant, r = ray.dot(q) / determinant;
  return s >= 0 && r >= 0 && s + r <= 1 && v.dot(q) / determinant > 0;
}

void test_visibility()
{
  // a sphere hides what is on its other side; a second one what is behind it, within its radius
  Shape shape = sphere_shape(4);
  const std::size_t first = shape.points.size();
  shape.add(sphere_shape(3, 0.4), Vec(0, 0, 2));
  const Animated two(shape);
  const std::vector<float> seen = visibility(two, Vec(0, 0, 1));
  std::size_t wrong = 0, hidden_by_other = 0, counted = 0;
  for (std::size_t v = 0; v < shape.points.size(); ++v) {
    const Vec& p = shape.points[v];
    const double height = v < first ? p[2] : (p[2] - 2) / 0.4, away = std::hypot(p[0], p[1]);
    if (std::abs(height) < 0.15 || (v < first && std::abs(away - 0.4) < 0.04)) continue; // near an outline
    const bool is_hidden = height < 0 || (v < first && away < 0.4);
    hidden_by_other += v < first && height > 0 && away < 0.4;
    wrong += seen[v] != (is_hidden ? 0.f : 1.f);
    ++counted;
  }
  CHECK(wrong == 0 && counted > 2000 && hidden_by_other > 50);
  // the same if all triangles are turned over: either side may be the outer one
  Shape turned = shape;
  for (auto& t : turned.faces) std::swap(t[0], t[1]);
  const std::vector<float> again = visibility(Animated(turned), Vec(0, 0, 1));
  std::size_t other = 0;
  for (std::size_t v = 0; v < shape.points.size(); ++v)
    other += again[v] != seen[v] && std::abs(v < first ? shape.points[v][2] : shape.points[v][2] - 2) > 0.01;
  CHECK(other == 0); // but on the outline, of which both sides are seen

  // Rays through a heap of plates and an uneven sphere, whatever the direction. What is near an outline is uncertain, by a
  // texel.
  Shape heap = sphere_shape(2);
  for (Vec& p : heap.points) p *= 1 + 0.3 * std::sin(3 * p[0]) * std::cos(4 * p[1]);
  heap.add(plate(Vec(0, 0, 1.6), Vec(0.3, 0.2, 1).normalized(), 0.8, 6));
  heap.add(plate(Vec(1.5, 0.3, 0), Vec(1, 0, 0.4).normalized(), 0.7, 6));
  const Animated animated(heap);
  const Rest_shape& rest = animated.sequence->rest_shape();
  double error = 0, sum = 0;
  for (const Vec& d : View_sphere(0).directions()) {
    const std::vector<float> found = visibility(animated, d);
    for (std::size_t v = 0; v < heap.points.size(); ++v) {
      Vec normal = Vec::Zero();
      for (Rest_shape::Index t : rest.incident_triangles()[v]) {
        const auto& c = rest.triangles()[t];
        normal += (heap.points[c[1]] - heap.points[c[0]]).cross(heap.points[c[2]] - heap.points[c[0]]);
      }
      normal.normalize();
      const double cosine = normal.dot(d);
      const Vec from = heap.points[v] + (cosine < 0 ? -1e-6 : 1e-6) * normal;
      bool is_free = true;
      for (const auto& c : heap.faces)
        is_free = is_free && !meets(from, d, heap.points[std::size_t(c[0])], heap.points[std::size_t(c[1])],
                                    heap.points[std::size_t(c[2])]);
      const double weight = (std::min)(1., 2 * std::abs(cosine)); // as features are weighted
      error += weight * std::abs(double(found[v]) - double(is_free));
      sum += weight;
    }
  }
  CHECK_NEAR(error / sum, 0, 0.03);
  CHECK(sum > 1000);
}

// --------------------------------------------------------------------------------------------------------------- scores

void test_area_and_entropy()
{
  const std::vector<Vec> directions = View_sphere(1).directions();
  const Animated sphere(sphere_shape(4));
  const View_scores area = score_views(*sphere.sequence, {0, 2}, directions, Area_view_score(2));
  for (std::size_t d = 0; d < directions.size(); ++d) CHECK_NEAR(area.score(d), 1, 0.01);

  // A square of diagonal 2 in a circle: its image is cos * 2 of pi. Seen from both sides.
  const Animated square(plate(Vec(3, 4, 5), Vec(0, 0, 1), std::sqrt(0.5), 10));
  const View_scores flat = score_views(*square.sequence, {1}, directions, Area_view_score(1));
  for (std::size_t d = 0; d < directions.size(); ++d)
    CHECK_NEAR(flat.score(d), 2 / pi * std::abs(directions[d][2]), 0.01);

  const Animated halves(plate(Vec(0, 0, 0), Vec(0, 0, 1), std::sqrt(0.5), 1));
  const double half = 1 / pi, rest = 1 - 2 / pi; // two triangles and the background
  const View_scores entropy = score_views(*halves.sequence, {0}, {Vec(0, 0, 1), Vec(1, 0, 0)}, Entropy_view_score(1));
  CHECK_NEAR(entropy.score(0), (-2 * half * std::log(half) - rest * std::log(rest)) / std::log(3.), 1e-5);
  CHECK_NEAR(entropy.score(1), 0, 1e-5);
}

void test_features()
{
  const Shape shape = sphere_shape(3);
  const Animated a(shape, 5);
  const Rest_shape& rest = a.sequence->rest_shape();
  const std::size_t vertex = nearest_vertex(shape, Vec(1, 2, -1).normalized());
  const Vec place = shape.points[vertex], other = Vec(-2, 0.5, 1).normalized();
  const std::vector<Feature_point> one = {feature(vertex, 0.2)};
  const std::vector<Feature_point> both = {one[0], feature(nearest_vertex(shape, other), 0.2, 0.5, 3)};

  // projected size: straight above is best, and by the cosine less beside it
  const Feature_view_score projected(rest, {0, 1, 2}, 5, 0.1, one, 1);
  const Vec across = place.unitOrthogonal();
  std::vector<Vec> directions = {place, -place};
  for (double degrees : {20., 50., 70.})
    directions.push_back(std::cos(degrees * pi / 180) * place + std::sin(degrees * pi / 180) * across);
  const View_scores s = score_views(*a.sequence, {0, 1, 2}, directions, projected);
  CHECK_NEAR(s.score(0), 1, 0.02);
  CHECK_NEAR(s.score(1), 0, 1e-6);
  CHECK_NEAR(s.score(2) / s.score(0), std::cos(20 * pi / 180), 0.02);
  CHECK_NEAR(s.score(3) / s.score(0), std::cos(50 * pi / 180), 0.02);
  CHECK_NEAR(s.weight(0) + s.weight(1) + s.weight(2), 1, 1e-12);
  // what is in frame 3 counts in the nearest of those that are looked at
  double in_time = 0, in_third = 0;
  for (int m = 0; m < 4; ++m) { // within two tau of frame 1
    const double g = std::exp(-0.5 * (m - 1) * (m - 1));
    in_time += g;
    if (m >= 2) in_third += g;
  }
  CHECK_NEAR(s.weight(2), in_third / in_time, 1e-9);

  // as a whole up to 60 degrees; all that is not hidden
  const View_scores whole = score_views(*a.sequence, {1}, directions, Feature_view_score(rest, {1}, 5, 0.1, one));
  CHECK_NEAR(whole.score(2), 1, 1e-3);
  CHECK_NEAR(whole.score(4), 2 * std::cos(70 * pi / 180), 0.04);
  const View_scores plain = score_views(*a.sequence, {1}, directions, Feature_view_score(rest, {1}, 5, 0.1, one, 0));
  CHECK_NEAR(plain.score(4), 1, 1e-3);
  CHECK_NEAR(plain.score(1), 0, 1e-6);

  // The chosen view is above a single feature; of two on opposite sides it shows the stronger one, and the next one both.
  View_options options;
  options.lowest_elevation = -90, options.highest_elevation = 90;
  options.subdivisions = 1;
  const View_selection single = select_views(*a.sequence, one, options);
  CHECK(View_sphere::angle(single.views[0].direction, place) < 55 * pi / 180);
  CHECK_NEAR(single.views[0].score, 1, 0.01);
  const Vec opposite = -place;
  const std::vector<Feature_point> facing = {one[0], feature(nearest_vertex(shape, opposite), 0.2, 0.5, 3)};
  const View_selection pair = select_views(*a.sequence, facing, options);
  CHECK_NEAR(pair.views[0].score, 2. / 3, 0.01);
  CHECK(pair.views.size() >= 2 && pair.views[0].direction.dot(place) > 0 && pair.views[1].direction.dot(place) < 0);
  CHECK_NEAR(pair.views[1].covered, 1, 0.01);
  CHECK_NEAR(pair.scores.covered({pair.views[0].rank, pair.views[1].rank}), pair.views[1].covered, 1e-12);

  // Of two that are as good, the one nearer to the front comes first, whichever has a little more: here z points up.
  const Vec front(0, -1, 0);
  for (double more : {1.04, 1 / 1.04}) {
    const std::vector<Feature_point> alike = {feature(nearest_vertex(shape, front), 0.2, more),
                                              feature(nearest_vertex(shape, Vec(-front)), 0.2)};
    View_options upright = options;
    upright.up = Vec(0, 0, 1);
    upright.tie = 0.1;
    CHECK(select_views(*a.sequence, alike, upright).views[0].direction.dot(front) > 0);
    upright.tie = 0;
    CHECK((select_views(*a.sequence, alike, upright).views[0].direction.dot(front) > 0) == (more > 1));
  }

  // A plate before the feature: looked at from beside it.
  Shape hidden = shape;
  hidden.add(plate(1.5 * place, place, 0.5, 8));
  const Animated behind(hidden, 5);
  const View_selection around = select_views(*behind.sequence, one, options);
  CHECK(View_sphere::angle(around.views[0].direction, place) > 35 * pi / 180);
  CHECK(around.views[0].score > 0.9);

  // Elevations are kept, and the up direction.
  options.lowest_elevation = 5, options.highest_elevation = 30;
  options.up = Vec(0, 0, 3);
  const View_selection band = select_views(*a.sequence, both, options);
  CHECK_NEAR((band.up - Vec(0, 0, 1)).norm(), 0, 1e-12);
  for (const Vec& d : band.scores.directions())
    CHECK(d[2] > std::sin(4.9 * pi / 180) && d[2] < std::sin(30.1 * pi / 180));
  // Without features there is a view as well.
  CHECK(select_views(*a.sequence, std::vector<Feature_point>(), options).views.size() >= 1);
}

// The score of a direction is that of the turned direction on the turned body, wherever it walks and however large it is.
void test_invariance()
{
  Shape shape = sphere_shape(3);
  for (Vec& p : shape.points) p = Vec(2 * p[0], p[1] * (1 + 0.5 * p[0]), 0.7 * p[2]);
  shape.add(plate(Vec(0, 1.5, 0.5), Vec(0, 1, 0.3).normalized(), 0.6, 5));
  Random random(3);
  const Eigen::Matrix3d turn = random.rotation().toRotationMatrix();
  const Animated still(shape);
  Shape moved = shape;
  for (Vec& p : moved.points) p = 7 * (turn * p);
  const Animated walking(moved, 3, [](const Vec& p, std::size_t f) { return Vec(p + double(f) * Vec(30, 20, -50)); });
  std::vector<Feature_point> features, scaled;
  for (std::size_t v : {30u, 200u, 500u, 661u}) features.push_back(feature(v, 0.4, 1 + 0.001 * double(v)));
  scaled = features;
  for (Feature_point& f : scaled) f.sigma *= 7;
  std::vector<Vec> directions = View_sphere(1).directions(), turned;
  for (const Vec& d : directions) turned.push_back((turn * d).normalized());
  const View_scores a = score_views(*still.sequence, {0, 1, 2}, directions,
                                    Feature_view_score(still.sequence->rest_shape(), {0, 1, 2}, 3, 0.1, features));
  const View_scores b = score_views(*walking.sequence, {0, 1, 2}, turned,
                                    Feature_view_score(walking.sequence->rest_shape(), {0, 1, 2}, 3, 0.1, scaled));
  double most = 0, spread = 0, least = 1;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    most = (std::max)(most, std::abs(a.score(d) - b.score(d)));
    spread = (std::max)(spread, a.score(d));
    least = (std::min)(least, a.score(d));
  }
  CHECK_NEAR(most, 0, 0.03);
  CHECK(spread - least > 0.4);

#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1u, 3u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const View_scores c = score_views(*still.sequence, {0, 1, 2}, directions,
                                      Feature_view_score(still.sequence->rest_shape(), {0, 1, 2}, 3, 0.1, features));
    bool is_same = true;
    for (std::size_t d = 0; d < directions.size(); ++d) is_same = is_same && c.score(d) == a.score(d);
    CHECK(is_same);
  }
#endif
}

void test_frames()
{
  CHECK((even_frames(10, 5) == std::vector<std::size_t>{1, 3, 5, 7, 9}));
  CHECK((even_frames(3, 5) == std::vector<std::size_t>{0, 1, 2}));
  // where the features are
  std::vector<Feature_point> features;
  for (std::size_t f : {20u, 21u, 70u}) features.push_back(feature(0, 1, f == 70 ? 2 : 1, f, 0));
  CHECK((view_frames(features, 100, 0.1, 4) == std::vector<std::size_t>{20, 21, 70}));
  CHECK(view_frames(features, 100, 0.1, 200).size() == 100);
  CHECK(view_frames(std::vector<Feature_point>(), 100, 0.1, 4) == even_frames(100, 4));
  CHECK_THROWS(Option_error, even_frames(10, 0), "at least one frame");
  features[0].frame = 100;
  CHECK_THROWS(Input_error, view_frames(features, 100, 0.1, 4), "frame 100");
}

// In a cycle it does not matter where it begins: a feature near an end lives on at the other one.
void test_cycle()
{
  const Animated a(sphere_shape(2));
  const Rest_shape& rest = a.sequence->rest_shape();
  const auto worth = [&](std::size_t frame, const std::vector<std::size_t>& frames, bool is_cyclic) {
    const std::vector<Feature_point> one = {feature(0, 0.2, 3, frame)};
    const Feature_view_score score(rest, frames, 10, 0.1, one, 0.5, is_cyclic);
    std::vector<double> sums;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      sums.push_back(0);
      for (std::size_t i = score.first_item(k); i < score.first_item(k + 1); ++i) sums.back() += score.weight(i);
    }
    return sums;
  };
  const std::vector<std::size_t> all = even_frames(10, 10);
  const std::vector<double> middle = worth(5, all, false), end = worth(9, all, true), cut = worth(9, all, false);
  for (std::size_t f = 0; f < 10; ++f) CHECK_NEAR(end[(f + 4) % 10], middle[f], 1e-12);
  CHECK(middle[3] > 0.1 && middle[2] == 0 && end[0] > 0.1 && end[1] > 0.1 && end[2] == 0 && cut[0] == 0);
  CHECK_NEAR(std::accumulate(cut.begin(), cut.end(), 0.), 3, 1e-12);
  // frames 7, 8 and 9 are no farther from 6, 0 and 1 nearer to 2
  const std::vector<double> few = worth(9, {2, 6}, true);
  CHECK_NEAR(few[0], end[0] + end[1], 1e-12);
  CHECK_NEAR(few[1], end[7] + end[8] + end[9], 1e-12);
  CHECK(worth(9, {2, 6}, false)[0] == 0 && worth(0, {2, 6}, false)[1] == 0);
  CHECK_NEAR(worth(0, {2, 6}, true)[1], end[7] + end[8], 1e-12); // those of frames 8 and 9
  const std::vector<Feature_point> features = {feature(0, 0.2, 1, 9)};
  CHECK((view_frames(features, 10, 0.1, 5, true) == std::vector<std::size_t>{0, 7, 8, 9}));
  CHECK((view_frames(features, 10, 0.1, 5) == std::vector<std::size_t>{8, 9}));
}

// ------------------------------------------------------------------------------------------------- several views, paths

// What is seen of some targets, which move with the frames: the cosine.
struct Target_score
{
  std::vector<std::vector<Vec>> targets; // of each frame
  std::vector<double> weights;           // of the targets of a frame

  std::size_t number_of_frames() const { return targets.size(); }
  std::size_t first_item(std::size_t k) const { return k * weights.size(); }
  double weight(std::size_t i) const { return weights[i % weights.size()]; }
  void operator()(const Surface_view& view, float* seen) const
  {
    for (const Vec& t : targets[view.frame_rank()]) *seen++ = float((std::max)(0., t.dot(view.direction())));
  }
};

void test_covering()
{
  const Animated a(sphere_shape(1));
  const std::vector<Vec> directions = View_sphere(1).directions();
  Random random(5);
  for (int repeat = 0; repeat < 5; ++repeat) {
    Target_score score;
    score.targets.resize(2);
    for (int i = 0; i < 6; ++i) {
      score.weights.push_back(random(0.2, 1));
      for (auto& frame : score.targets) frame.push_back(random.vector().normalized());
    }
    const View_scores s = score_views(*a.sequence, {0, 2}, directions, score);
    const std::vector<Covering_view> views = covering_views(s, 3);
    CHECK(views.size() == 3 && views[0].covered < views[1].covered && views[1].covered < views[2].covered);
    double best = 0, best_pair = 0, best_added = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      double direct = 0, sum = 0;
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t t = 0; t < 6; ++t) {
          direct += score.weights[t] * (std::max)(0., score.targets[k][t].dot(directions[i]));
          sum += score.weights[t];
        }
      CHECK_NEAR(s.score(i), direct / sum, 1e-6);
      best = (std::max)(best, s.score(i));
      best_added = (std::max)(best_added, s.covered({views[0].rank, i}));
      for (std::size_t j = 0; j < i; ++j) best_pair = (std::max)(best_pair, s.covered({i, j}));
    }
    CHECK_NEAR(views[0].score, best, 1e-12);
    std::vector<std::size_t> all(directions.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    CHECK_NEAR(s.covered_by_all(), s.covered(all), 1e-12);
    CHECK(s.covered_by_all() >= views[2].covered && s.covered_by_all() <= 1 + 1e-12);
    const std::vector<Covering_view> two = covering_views(s, 2);
    CHECK_NEAR(two[1].covered, best_added, 1e-12);
    CHECK(two[1].covered >= (1 - std::exp(-1.)) * best_pair && two[1].covered <= best_pair + 1e-12);
    // no other third view, nor second one, shows more; both in the order of what they add
    double third = 0, exchanged = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      third = (std::max)(third, s.covered({two[0].rank, two[1].rank, i}));
      exchanged = (std::max)(
          {exchanged, s.covered({views[0].rank, views[1].rank, i}), s.covered({views[0].rank, i, views[2].rank})});
    }
    CHECK(views[0].rank == two[0].rank && views[2].covered >= third - 1e-12);
    CHECK_NEAR(views[2].covered, exchanged, 1e-8);
    CHECK(views[1].covered >= s.covered({views[0].rank, views[2].rank}));
  }
  // nobody adds anything to the first one
  Target_score one;
  one.targets = {{directions[7]}};
  one.weights = {1};
  const View_scores s = score_views(*a.sequence, {0}, directions, one);
  CHECK(covering_views(s, 3).size() == 1 && covering_views(s, 3)[0].rank == 7);
  CHECK(covering_views(s, 3, [&](const Vec& d) { return d.dot(directions[7]) < 0; }).size() <= 1);
}

// The best of all paths of so many directions, each within an angle of the one before.
double best_of_all_paths(const View_scores& s, const std::vector<std::vector<std::size_t>>& layers, double angle,
                         double cost, bool is_cyclic, std::vector<std::size_t>& path)
{
  const std::size_t j = path.size(), n = s.directions().size();
  const auto step = [&](std::size_t a, std::size_t b) {
    return View_sphere::angle(s.directions()[a], s.directions()[b]);
  };
  if (j == layers.size())
    return !is_cyclic                                        ? 0
           : step(path.back(), path.front()) <= angle + 1e-9 ? -cost * step(path.back(), path.front())
                                                             : -1e9;
  double best = -1e9;
  for (std::size_t d = 0; d < n; ++d) {
    if (j > 0 && step(path.back(), d) > angle + 1e-9) continue;
    double value = j > 0 ? -cost * step(path.back(), d) : 0;
    for (std::size_t k : layers[j]) value += s.score(d, k);
    path.push_back(d);
    best = (std::max)(best, value + best_of_all_paths(s, layers, angle, cost, is_cyclic, path));
    path.pop_back();
  }
  return best;
}

void test_camera_path()
{
  const std::size_t frames = 41;
  const Animated a(sphere_shape(1), frames);
  const View_sphere sphere(0);
  Target_score score;
  for (std::size_t f = 0; f < frames; ++f) {
    const double t = 2 * pi * double(f) / double(frames);
    score.targets.push_back({Vec(std::cos(t), std::sin(t), 0.3).normalized()});
  }
  score.weights = {1};
  const std::vector<std::size_t> all = even_frames(frames, frames);
  const View_scores s = score_views(*a.sequence, all, sphere.directions(), score);
  for (bool is_cyclic : {false, true})
    for (double cost : {0., 0.05}) {
      Camera_path_options options;
      options.is_cyclic = is_cyclic;
      options.cost_of_turning = cost;
      options.largest_speed = 64; // 63.4 degrees from one to the next: 4 intervals in 4 s
      const Camera_path path = camera_path(s, sphere.longest_edge(), frames, 0.1, options);
      const double duration = is_cyclic ? 4.1 : 4;
      const std::size_t keys = is_cyclic ? 4 : 5;
      CHECK(path.directions().size() == 5);
      CHECK_NEAR(path.interval(), duration / 4, 1e-12);
      std::vector<std::vector<std::size_t>> layers(keys);
      for (std::size_t f = 0; f < frames; ++f)
        layers[std::size_t(std::floor(double(f) * 0.1 / path.interval() + 0.5)) % (is_cyclic ? keys : 100)].push_back(
            f);
      std::vector<std::size_t> trial;
      const double best = best_of_all_paths(s, layers, 64 * pi / 180 * path.interval(), cost, is_cyclic, trial);
      double turned = 0;
      for (std::size_t i = 1; i < 5; ++i) turned += View_sphere::angle(path.directions()[i - 1], path.directions()[i]);
      CHECK_NEAR(path.score() - cost * turned, best, 1e-9);
      CHECK(!is_cyclic || path.directions().front() == path.directions().back());
      // nowhere faster than allowed, and unit vectors
      double fastest = 0;
      for (double t = -0.1; t < duration + 0.1; t += 0.01) {
        CHECK_NEAR(path.direction(t).norm(), 1, 1e-12);
        fastest = (std::max)(fastest, View_sphere::angle(path.direction(t), path.direction(t + 0.01)) / 0.01);
      }
      CHECK(fastest <= 64 * pi / 180 * (1 + 1e-6) && fastest > 0.5);
    }

  // A fast camera shows more than a still one, which a slow one is.
  Camera_path_options options;
  const double still = s.score(s.best([](const Vec&) { return true; }));
  options.largest_speed = 5;
  const Camera_path slow = camera_path(s, sphere.longest_edge(), frames, 0.1, options);
  CHECK(slow.directions().size() == 1);
  CHECK_NEAR(slow.score(), still, 1e-12);
  options.largest_speed = 300;
  CHECK(camera_path(s, sphere.longest_edge(), frames, 0.1, options).score() > 1.3 * still);
  options.cost_of_turning = 10;
  CHECK_NEAR(camera_path(s, sphere.longest_edge(), frames, 0.1, options).score(), still, 1e-9);
  options.cost_of_turning = -1;
  CHECK_THROWS(Option_error, camera_path(s, 1, frames, 0.1, options), "cost of turning");
  options.largest_speed = 0;
  CHECK_THROWS(Option_error, camera_path(s, 1, frames, 0.1, options), "largest speed");
}

// --------------------------------------------------------------------------------------------------------------- errors

struct Impatient : Default_visitor
{
  bool progress(Stage stage, double)
  {
    CHECK(stage == Stage::VIEWS);
    return false;
  }
};

void test_errors()
{
  const Shape shape = sphere_shape(1);
  const Animated a(shape);
  const Rest_shape& rest = a.sequence->rest_shape();
  const Vec z(0, 0, 1);
  const std::vector<Feature_point> one = {feature(3, 0.2)};
  CHECK_THROWS(Option_error, score_views(*a.sequence, {0, 1}, {z}, Area_view_score(1)), "for 1 frames, not for 2");
  CHECK_THROWS(Option_error, score_views(*a.sequence, {3}, {z}, Area_view_score(1)), "below 3");
  CHECK_THROWS(Option_error, score_views(*a.sequence, {1, 0}, {z}, Area_view_score(2)), "ascend");
  CHECK_THROWS(Option_error, score_views(*a.sequence, {0}, {2 * z}, Area_view_score(1)), "no unit vector");
  CHECK_THROWS(Option_error, score_views(*a.sequence, {0}, {z}, Area_view_score(1), Any_visitor(), 8), "16 to 4096");
  CHECK_THROWS(Option_error, Feature_view_score(rest, {}, 3, 0.1, one), "at least one frame");
  CHECK_THROWS(Option_error, Feature_view_score(rest, {4}, 3, 0.1, one), "below 3");
  CHECK_THROWS(Option_error, Feature_view_score(rest, {1}, 3, 0.1, one, 2), "from 0 to 1");
  const std::vector<Feature_point> bad = {feature(1000, 0.2)}, flat = {feature(3, 0)};
  CHECK_THROWS(Input_error, Feature_view_score(rest, {1}, 3, 0.1, bad), "vertex 1000");
  CHECK_THROWS(Input_error, Feature_view_score(rest, {1}, 3, 0.1, flat), "sigma 0");
  View_options options;
  options.up = Vec::Zero();
  CHECK_THROWS(Option_error, select_views(*a.sequence, one, options), "points up");
  options.up.reset();
  options.lowest_elevation = 50, options.highest_elevation = 40;
  CHECK_THROWS(Option_error, select_views(*a.sequence, one, options), "no elevation from");
  options = View_options();
  options.tie = -1;
  CHECK_THROWS(Option_error, select_views(*a.sequence, one, options), "a tie of");
  Impatient visitor;
  CHECK_THROWS(Cancelled, select_views(*a.sequence, one, View_options(), visitor), "cancelled");
}

int main()
{
  test_directions();
  test_angles();
  test_up_axis();
  test_visibility();
  test_area_and_entropy();
  test_features();
  test_invariance();
  test_frames();
  test_covering();
  test_cycle();
  test_camera_path();
  test_errors();
  return test_result();
}
