// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures of the manual that detect_features cannot draw, since what they compare are not the frames of one animation:
// measures, levels of smoothing, and rest shapes, side by side on the running figure.
//
// body_pictures FOLDER

#include "draw_surfaces.h"
#include "figures_support.h"

#include "generators/articulated_figure.h"

#include "drawing/decimal.h"
#include "rendering/Palette.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
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
  std::vector<Labelled_surface> surfaces;
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
    surfaces.push_back({body.label, s});
  }
  View_direction view;
  view.up_axis = 2;
  view.azimuth = 60;
  view.elevation = 10;
  draw_surfaces(path, surfaces, view, 480, {{name, "0", "\xe2\x89\xa5 " + rounded(most, 2), &field_colours()}});
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
