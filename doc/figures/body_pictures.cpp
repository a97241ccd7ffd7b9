// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures of the manual that detect_features cannot draw, since what they compare are not the frames of one animation:
// measures, levels of smoothing, and rest shapes, side by side on the running figure.
//
// body_pictures FOLDER

#include "figures_support.h"

#include "generators/articulated_figure.h"

#include "drawing/Canvas.h"
#include "drawing/Legend.h"
#include "drawing/decimal.h"
#include "rendering/Contact_sheet.h"
#include "rendering/Palette.h"
#include "rendering/Panel_cameras.h"
#include "rendering/render.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using namespace figures;
using namespace Programs;
using namespace Programs::Rendering;
typedef AMF::Spatio_temporal_field<double> Field;
typedef AMF::Deformation_measurement<Frame_sequence> Measurement;

namespace {

const std::size_t shown_frame = 12; // both ears and the tail are bent, one foot has just left the ground

// One body with its values.
struct Body
{
  std::string label;
  std::size_t frame;
  std::vector<double> values;
};

std::vector<double> column(const Field& field, std::size_t frame, double factor = 1)
{
  std::vector<double> result;
  for (std::size_t v = 0; v < field.number_of_rows(); ++v) result.push_back(factor * field(v, frame));
  return result;
}

// Bodies beside each other, coloured from 0 to `most` alike.
void draw(const std::string& path, const Animated_mesh_generators::Generated_animation& animation,
          const std::vector<Body>& bodies, double most, const std::string& name)
{
  std::vector<Surface> surfaces;
  double ground = 0;
  for (const Body& body : bodies) {
    Surface s;
    for (const Point_3& p : animation.frames[body.frame]) s.points.emplace_back(p.x(), p.y(), p.z());
    for (Mesh::Face_index f : animation.mesh.faces()) {
      Surface::Triangle t = {};
      std::size_t i = 0;
      for (Mesh::Vertex_index v : animation.mesh.vertices_around_face(animation.mesh.halfedge(f)))
        t[i++] = std::uint32_t(v);
      s.triangles.push_back(t);
    }
    s.normals = vertex_normals(s.points, s.triangles);
    for (double x : body.values) s.values.push_back(float(x / most));
    for (const Eigen::Vector3d& p : s.points) ground = (std::min)(ground, p.z());
    surfaces.push_back(s);
  }
  View_direction view;
  view.up_axis = 2;
  view.azimuth = 60;
  view.elevation = 10;
  const Panel_cameras cameras(surfaces, std::vector<std::vector<Sphere>>(bodies.size()), view);
  const std::size_t width = 1280, height = 480;
  const double text = 11;
  const std::size_t legend_top = height - 44;
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
  draw_legend(canvas, {{name, "0", "\xe2\x89\xa5 " + rounded(most, 2), &field_colours()}}, double(width),
              double(legend_top), double(height - legend_top), style);

  std::ofstream out(path, std::ios::binary);
  const std::string png = canvas.file();
  out.write(png.data(), std::streamsize(png.size()));
  if (!out) throw std::runtime_error("cannot write " + path);
}

// What 99.5 % of the values do not exceed, to two digits.
double range(std::vector<double> values)
{
  const auto at = values.begin() + std::ptrdiff_t(0.995 * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  const double unit = std::pow(10., std::floor(std::log10(*at)) - 1);
  return std::ceil(*at / unit) * unit;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "Usage: body_pictures FOLDER" << std::endl;
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    Animated_mesh_generators::Articulated_figure_options options;
    options.number_of_vertices = 20000;
    const auto figure = Animated_mesh_generators::articulated_figure(options);
    const std::vector<Point_3> standing(figure.mesh.points().begin(), figure.mesh.points().end());
    Frame_sequence animation(figure.mesh, figure.frames, figure.frame_duration);
    AMF::set_canonical_rest_shape(animation);
    Measurement measurement(animation);
    const std::vector<double> deformation = column(measurement.deformation(), shown_frame);
    const double most = range(deformation);

    draw(folder + "measures.png", figure,
         {{"strain", shown_frame, column(measurement.strain(), shown_frame)},
          {"7 \xc2\xb7 change of curvature", shown_frame,
           column(measurement.curvature_change(), shown_frame, AMF::default_curvature_weight)},
          {"deformation, their sum", shown_frame, deformation}},
         most, "measure");

    // levels of smoothing in space
    std::vector<Body> levels = {{"not smoothed", shown_frame, deformation}};
    const double unit = animation.rest_shape().diameter() / 100;
    const std::vector<double> sigma = {1.4 * unit, 2.8 * unit, 5.6 * unit};
    AMF::Heat_diffusion_filter filter;
    filter.initialize(animation.rest_shape(), {sigma[0] * sigma[0], sigma[1] * sigma[1], sigma[2] * sigma[2]},
                      Plain_loop());
    Field from = measurement.deformation(), to(from.number_of_rows(), from.number_of_frames());
    for (std::size_t k = 0; k < sigma.size(); ++k) {
      filter(k, from, to, Plain_loop());
      levels.push_back({"\xcf\x83 = " + rounded(sigma[k], 2), shown_frame, column(to, shown_frame)});
      from.swap(to);
    }
    draw(folder + "smoothing_in_space.png", figure, levels, most, "deformation");

    // in the same frame, what counts as deformed
    std::vector<Body> shapes = {{"rest: average", shown_frame, deformation}};
    const auto add = [&](const std::string& label) {
      shapes.push_back({"rest: " + label, shown_frame, column(Measurement(animation).deformation(), shown_frame)});
    };
    animation.set_rest_shape(standing);
    add("standing");
    animation.set_rest_frame(0);
    add("frame 0");
    std::vector<Point_3> smaller;
    for (const Point_3& p : standing) smaller.push_back(CGAL::ORIGIN + (p - CGAL::ORIGIN) * 0.5);
    animation.set_rest_shape(smaller, AMF::Rest_unit::KEEP);
    add("half as large");
    draw(folder + "rest_shapes.png", figure, shapes, most, "deformation");
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "body_pictures: " << e.what() << std::endl;
    return 1;
  }
}
