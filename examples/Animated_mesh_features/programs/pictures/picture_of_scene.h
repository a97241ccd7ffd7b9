// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_PICTURE_OF_SCENE_H
#define PROGRAMS_PICTURES_PICTURE_OF_SCENE_H

#include "pictures/Picture_options.h"
#include "scenes/Scene.h"
#include "scenes/feature_in_frame.h"
#include "scenes/colour_scales.h"
#include "rendering/Body_view.h"
#include "rendering/Contact_sheet.h"
#include "rendering/Legend.h"
#include "rendering/Palette.h"
#include "rendering/Panel_cameras.h"
#include "rendering/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// Turns a scene, frame by frame, into what is drawn.
template <class Scene>
class Scene_pictures
{
  typedef Animated_mesh_features::Rendering::Surface Surface;
  typedef Animated_mesh_features::Rendering::Sphere Sphere;
  typedef Animated_mesh_features::Rendering::Legend_bar Legend_bar;
  typedef typename Scene::FT FT;

public:
  explicit Scene_pictures(const Scene& scene)
    : m_scene(scene)
    , m_places(relative_taus(scene.features))
  {
    for (const auto& t : scene.sequence.rest_shape().triangles())
      m_triangles.push_back({{std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])}});
    find_range_of_field();
    for (const auto& f : scene.features) {
      if (!(f.tau > 0)) continue;
      m_shortest = m_shortest > 0 ? (std::min)(m_shortest, f.tau) : f.tau;
      m_longest = (std::max)(m_longest, f.tau);
    }
  }

  Surface surface(std::size_t frame) const
  {
    Surface s;
    const auto& animation = m_scene.sequence.trajectories();
    for (std::size_t v = 0; v < m_scene.sequence.number_of_vertices(); ++v)
      s.points.emplace_back(double(animation.x(v, frame)), double(animation.y(v, frame)),
                            double(animation.z(v, frame)));
    s.triangles = m_triangles;
    s.normals = Animated_mesh_features::Rendering::vertex_normals(s.points, s.triangles);
    if (has_field())
      for (std::size_t v = 0; v < s.points.size(); ++v)
        s.values.push_back(float((double((*m_scene.fields.front().values)(v, frame)) - m_low) / (m_high - m_low)));
    return s;
  }

  std::vector<Sphere> spheres(std::size_t frame) const
  {
    const double step = m_scene.sequence.frame_duration();
    // What is inside of larger ones should be seen.
    const double largest_filled = 0.08 * m_scene.sequence.rest_shape().bounding_box_diagonal();
    std::vector<Sphere> result;
    for (std::size_t i = 0; i < m_scene.features.size(); ++i) {
      const auto& f = m_scene.features[i];
      if (!lives_in_frame(f, frame, step)) continue;
      const std::array<double, 3> p = position_in_frame(m_scene.sequence, f, frame);
      Sphere s;
      s.centre = Eigen::Vector3d(p[0], p[1], p[2]);
      s.radius = f.radius();
      s.opacity = float(opacity_in_frame(f, frame, step));
      s.filling = float((std::min)(1., largest_filled / s.radius));
      s.colour = Animated_mesh_features::Rendering::duration_colours()(m_places[i]);
      result.push_back(s);
    }
    return result;
  }

  std::vector<Legend_bar> legend() const
  {
    using namespace Animated_mesh_features::Rendering;
    std::vector<Legend_bar> bars;
    if (has_field())
      bars.push_back({m_scene.fields.front().name, short_number(m_low, 2),
                      (m_is_cut ? "\xe2\x89\xa5 " : "") + short_number(m_high, 2), &field_colours()});
    if (m_longest > 0)
      bars.push_back({"duration \xcf\x84", short_number(m_shortest, 2) + " s", short_number(m_longest, 2) + " s",
                      &duration_colours()});
    return bars;
  }

  std::string label(std::size_t frame) const
  {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.2f s", double(frame) * m_scene.sequence.frame_duration());
    std::replace(std::begin(seconds), std::end(seconds), ',', '.'); // whatever the locale
    return "frame " + std::to_string(frame) + "   " + seconds;
  }

  // The lowest coordinate of all frames.
  double lowest(int axis) const
  {
    const auto& animation = m_scene.sequence.trajectories();
    const auto& c = axis == 0 ? animation.x : axis == 1 ? animation.y : animation.z;
    double result = (std::numeric_limits<double>::max)();
    for (std::size_t v = 0; v < c.number_of_rows(); ++v)
      result = (std::min)(result, double(*std::min_element(c.row(v), c.row(v) + c.number_of_frames())));
    return result;
  }

private:
  bool has_field() const { return !m_scene.fields.empty() && m_high > m_low; }

  // From 0, or the least value, to a round number that few values exceed: those of the whole animation, so that
  // pictures of different frames can be compared.
  void find_range_of_field()
  {
    if (m_scene.fields.empty()) return;
    const double shown = 0.995;         // of the values
    const std::size_t enough = 1000003; // values to estimate that; prime, against regular meshes
    const auto& field = *m_scene.fields.front().values;
    const std::size_t frames = field.number_of_frames(), n = field.number_of_rows() * frames;
    const std::size_t step = n / enough + 1;
    std::vector<double> values;
    for (std::size_t i = 0; i < n; i += step) values.push_back(double(field(i / frames, i % frames)));
    if (values.empty()) return;
    const auto at = values.begin() + std::ptrdiff_t(shown * double(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    const double high = *at;
    m_low = (std::min)(0., *std::min_element(values.begin(), values.end()));
    const double most = *std::max_element(values.begin(), values.end());
    if (!(high > m_low)) return;
    const double unit = std::pow(10., std::floor(std::log10(high - m_low)) - 1); // two digits
    m_high = m_low + std::ceil((high - m_low) / unit - 1e-9) * unit;
    m_is_cut = most > m_high;
  }

  const Scene& m_scene;
  std::vector<double> m_places; // of tau, on the scale of colours
  std::vector<Surface::Triangle> m_triangles;
  double m_low = 0, m_high = 0;         // of the field
  bool m_is_cut = false;                // whether there are greater values
  double m_shortest = 0, m_longest = 0; // tau
};

// The height of capitals, pixels: readable also when the picture is shown at half its size.
inline double text_height(std::size_t width, std::size_t height)
{
  return (std::max)(6., 0.0145 * std::sqrt(double(width) * double(height)));
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

draws a scene in some frames: the surface, coloured by the first of the scene's fields, and the features that live in
the frame as translucent spheres of radius \f$\sqrt2\,\sigma\f$, blue where \f$\tau\f$ is long and red where it is
short, as faint as `opacity_in_frame()` tells. Each frame has a panel of its own, with its number and time; a legend
stands below.

The pictures are drawn by the package's own renderer (perspective, hidden parts by z-buffer, 16 samples a pixel averaged
in linear light, soft shadows and ambient occlusion of 184 lights), without a display or a graphics processor. The same
bits whatever the number of threads. Takes O(frames (pixels + triangles)) time: about a second of a core for a frame of
9,000 vertices in 250,000 pixels; and 150 bytes for each pixel of the largest panel.

\throws Option_error if an option has a value that makes no sense for the scene, or a field has another shape
\throws Input_error as `check_scene()`, or if there are no vertices
*/
template <class Sequence, class Feature>
Rendering::Srgb_image picture_of_scene(const Scene<Sequence, Feature>& scene,
                                       const Picture_options& options = Picture_options())
{
  using namespace Animated_mesh_features::Rendering;
  check_picture_options(options);
  check_picture_frames(options, scene.sequence.number_of_frames());
  check_scene(scene);
  if (scene.sequence.number_of_vertices() == 0) throw Input_error("there is no surface to be shown");
  const internal::Scene_pictures<Scene<Sequence, Feature>> pictures(scene);
  const std::vector<std::size_t> frames =
      options.frames.empty() ? strongest_frames(scene.features, scene.sequence.number_of_frames()) : options.frames;

  std::vector<Surface> bodies;
  std::vector<std::vector<Sphere>> spheres;
  for (std::size_t f : frames) {
    bodies.push_back(pictures.surface(f));
    spheres.push_back(pictures.spheres(f));
  }

  View_direction view;
  view.up_axis = options.up_axis ? *options.up_axis : probable_up_axis(scene.sequence.rest_shape().points());
  view.elevation = options.elevation;
  view.azimuth = options.azimuth ? *options.azimuth : good_azimuth(bodies, spheres, view);

  const Panel_cameras cameras(bodies, spheres, view);

  const double text = internal::text_height(options.width, options.height);
  const double legend_height = 3.6 * text, margin = 2.2 * text; // a line of text and the space around it
  const std::size_t legend_top = options.height - std::size_t(legend_height);
  const Colour background = linear(options.background);
  Srgb_image picture(options.width, options.height, options.background);
  const std::vector<Panel> all = panels(frames.size(), options.width, legend_top, cameras.aspect());
  Stage_set set;
  set.up = view.up();
  set.ground = pictures.lowest(view.up_axis);
  set.background = background;
  set.line_width = 0.14 * text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Panel& panel = all[i];
    if (panel.width == 0 || panel.height == 0)
      throw Option_error("the picture is too narrow for " + std::to_string(all.size()) + " frames");
    const double width = double(panel.width), height = double(panel.height);
    set.spheres = spheres[i];
    const Image image = render(bodies[i],
                               cameras.camera(i, width, height, (std::max)(width / 2, width - 2 * margin),
                                              (std::max)(height / 2, height - 2 * margin)),
                               set);
    for (std::size_t y = 0; y < panel.height; ++y)
      for (std::size_t x = 0; x < panel.width; ++x) picture(panel.left + x, panel.top + y) = encoded(image(x, y));
    draw_text(picture, pictures.label(frames[i]), double(panel.left) + text, double(panel.top) + 2 * text, text,
              ink_on(background));
  }
  draw_legend(picture, pictures.legend(), double(legend_top), legend_height, text, ink_on(background));
  return picture;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PICTURES_PICTURE_OF_SCENE_H
