// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers for the manual's figures on scales, computed with the package's own filters and responses: a Gaussian in time
// against tau, a blob on a surface against sigma and tau, and the levels of a bending cylinder.
//
// scale_data FOLDER

#include "figures_support.h"

#include "generators/bending_cylinder.h"

#include "rendering/Palette.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Scale_space/Difference_of_gaussians.h>
#include <CGAL/Animated_mesh_features/Scale_space/Gaussian_temporal_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_sampling.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using namespace figures;
typedef AMF::Spatio_temporal_field<double> Field;
typedef AMF::Feature_detector<double> Detector;
typedef std::vector<std::vector<double>> Rows;

namespace {

// `count` scales at a fixed ratio.
std::vector<double> scales(double first, double ratio, std::size_t count)
{
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(first * std::pow(ratio, double(i)));
  return result;
}

std::vector<double> squares(std::vector<double> list)
{
  for (double& x : list) x *= x;
  return list;
}

// The time levels of a row, the first one first.
Rows time_levels(const AMF::Gaussian_temporal_filter& filter, std::size_t levels, std::vector<double> row)
{
  Rows result;
  for (std::size_t l = 0; l < levels; ++l) {
    std::vector<double> next(row.size());
    filter(l, row.data(), next.data());
    row = next;
    result.push_back(row);
  }
  return result;
}

// A Gaussian in time, constant over the surface: what the temporal term of the response makes of it, in the middle.
void gaussians_in_time(const std::string& path)
{
  const std::size_t frames = 181, middle = 90;
  const double step = 1. / 60;
  const std::vector<double> tau = scales(0.02, std::pow(2., 0.125), 45), sigma(3, 1.);
  AMF::Gaussian_temporal_filter filter;
  filter.initialize(frames, step, squares(tau));
  AMF::Central_difference_of_gaussians response;
  response.initialize(sigma, tau, AMF::Scale_levels());

  Json_file json(path);
  json.add("tau", std::vector<double>(tau.begin() + 1, tau.end() - 1));
  const std::vector<double> widths = {0.06, 0.12, 0.24};
  json.add("widths", widths);
  Rows signals, responses, smoothed;
  for (double width : widths) {
    std::vector<double> row;
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = (double(f) - double(middle)) * step / width;
      row.push_back(std::exp(-t * t / 2));
    }
    const Rows levels = time_levels(filter, tau.size(), row);
    signals.push_back(row);
    responses.emplace_back();
    for (std::size_t l = 1; l + 1 < tau.size(); ++l)
      responses.back().push_back(response.time_weight(1, l) * (levels[l + 1][middle] - levels[l - 1][middle]));
    if (width == widths[1])
      for (std::size_t l : {13, 21, 29}) smoothed.push_back(levels[l]);
  }
  json.add("smoothed_tau", {tau[13], tau[21], tau[29]});
  json.add("step", step);
  json.add("signals", signals);
  json.add("smoothed", smoothed);
  json.add("responses", responses);
}

// A square in equilateral triangles of edge length h, around the origin, which is a vertex: its rank is given back.
Mesh square(double side, double h, std::size_t& middle)
{
  const long rows = 2 * long(side / 2 / (h * std::sqrt(0.75))), columns = 2 * long(side / 2 / h);
  Mesh mesh;
  for (long i = -rows / 2; i <= rows / 2; ++i)
    for (long j = -columns / 2; j <= columns / 2; ++j) {
      if (i == 0 && j == 0) middle = num_vertices(mesh);
      mesh.add_vertex(Point_3((double(j) + (i % 2 ? 0.5 : 0)) * h, double(i) * h * std::sqrt(0.75), 0));
    }
  for (long i = 0; i < rows; ++i)
    for (long j = 0; j < columns; ++j) {
      const bool is_shifted = (i - rows / 2) % 2 != 0;
      const auto vertex = [&](long row, long column) {
        return Mesh::Vertex_index(unsigned(row * (columns + 1) + column));
      };
      const auto a = vertex(i, j), b = vertex(i, j + 1), c = vertex(i + 1, j), d = vertex(i + 1, j + 1);
      mesh.add_face(a, b, is_shifted ? d : c);
      if (is_shifted)
        mesh.add_face(a, d, c);
      else
        mesh.add_face(b, d, c);
    }
  return mesh;
}

// A blob in space and time: the response at its centre, against sigma and tau.
void blob(const std::string& path)
{
  const double size = 0.2, duration = 0.1, step = 1. / 60;
  const std::size_t frames = 145, middle_frame = 72;
  std::size_t middle = 0;
  const Mesh mesh = square(4, 0.06, middle);
  const AMF::Rest_shape shape = AMF::rest_shape_of_mesh(mesh);
  Field field(num_vertices(mesh), frames);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < frames; ++f) {
      const double r = (mesh.point(Mesh::Vertex_index(unsigned(v))) - CGAL::ORIGIN).squared_length() / (size * size);
      const double t = (double(f) - double(middle_frame)) * step / duration;
      field(v, f) = std::exp(-(r + t * t) / 2);
    }

  const double ratio = std::pow(2., 0.25);
  const std::vector<double> sigma = scales(size / 4 / ratio, ratio, 19), tau = scales(duration / 4 / ratio, ratio, 19);
  AMF::Heat_diffusion_filter in_space;
  AMF::Gaussian_temporal_filter in_time;
  in_space.initialize(shape, squares(sigma), Plain_loop());
  in_time.initialize(frames, step, squares(tau));
  std::vector<Rows> levels; // of the vertex in the middle
  Field from = field, to(num_vertices(mesh), frames);
  for (std::size_t k = 0; k < sigma.size(); ++k) {
    in_space(k, from, to, Plain_loop());
    levels.push_back(time_levels(in_time, tau.size(), std::vector<double>(to.row(middle), to.row(middle) + frames)));
    from.swap(to);
  }
  AMF::Central_difference_of_gaussians response;
  AMF::Scale_levels units;
  units.unit_length = size;
  units.unit_time = duration;
  response.initialize(sigma, tau, units);
  Rows values;
  for (std::size_t k = 1; k + 1 < sigma.size(); ++k) {
    values.emplace_back();
    for (std::size_t l = 1; l + 1 < tau.size(); ++l) {
      const auto at = [&](std::size_t i, std::size_t j) { return levels[i][j][middle_frame]; };
      values.back().push_back(response.space_weight(k, l) * (at(k + 1, l) - at(k - 1, l)) +
                              response.time_weight(k, l) * (at(k, l + 1) - at(k, l - 1)));
    }
  }

  AMF::Extremum_options<> options;
  options.sampling.sigma = {size / 4, size * 4};
  options.sampling.tau = {duration / 4, duration * 4};
  Detector detector(shape, field, step, options);
  std::vector<Detector::Feature> features;
  detector(std::back_inserter(features));

  Json_file json(path);
  json.add("size", size);
  json.add("duration", duration);
  json.add("sigma", std::vector<double>(sigma.begin() + 1, sigma.end() - 1));
  json.add("tau", std::vector<double>(tau.begin() + 1, tau.end() - 1));
  json.add("response", values);
  Rows found;
  for (const auto& f : features) found.push_back({f.sigma, f.tau, f.response});
  json.add("found", found);
}

// The bending cylinder: its deformation along the side at x = +radius, at some levels of scale, and the response there.
void cylinder(const std::string& path)
{
  const Animated_mesh_generators::Bending_cylinder_options shape;
  const auto generated = Animated_mesh_generators::bending_cylinder(shape);
  Frame_sequence animation(generated.mesh, generated.frames, generated.frame_duration);
  animation.set_rest_shape(generated.mesh.points());
  AMF::Deformation_measurement<Frame_sequence> measurement(animation);
  Detector detector(animation.rest_shape(), measurement.take_deformation(), animation.frame_duration(),
                    AMF::Extremum_options<>(), measurement.noise());
  std::vector<Detector::Feature> features;
  detector(std::back_inserter(features));

  // on each circle the vertex that is nearest to that side
  std::vector<std::size_t> line;
  std::vector<double> height;
  for (std::size_t v = 0; v < animation.number_of_vertices(); ++v) {
    const Point_3& p = generated.mesh.point(Mesh::Vertex_index(unsigned(v)));
    if (p.x() < 0.98 * shape.radius || p.y() < -1e-9) continue;
    if (!height.empty() && std::abs(height.back() - p.z()) < 1e-9) continue;
    line.push_back(v);
    height.push_back(p.z());
  }
  Json_file json(path);
  json.add("height", height);
  json.add("step", generated.frame_duration);
  const auto rows = [&](const Field& field) {
    Rows result;
    for (std::size_t v : line) result.emplace_back(field.row(v), field.row(v) + field.number_of_frames());
    return result;
  };
  json.add("deformation", rows(detector.field()));

  // the levels of the detection, by the same filters
  const std::vector<double>& sigma = detector.sigma_levels();
  const std::vector<double>& tau = detector.tau_levels();
  AMF::Heat_diffusion_filter in_space;
  AMF::Gaussian_temporal_filter in_time;
  in_space.initialize(animation.rest_shape(), squares(sigma), Plain_loop());
  in_time.initialize(animation.number_of_frames(), animation.frame_duration(), squares(tau));
  std::vector<std::vector<Rows>> levels; // k, vertex, l
  Field from = detector.field(), to(from.number_of_rows(), from.number_of_frames());
  for (std::size_t k = 0; k < sigma.size(); ++k) {
    in_space(k, from, to, Plain_loop());
    levels.emplace_back();
    for (const std::vector<double>& row : rows(to)) levels.back().push_back(time_levels(in_time, tau.size(), row));
    from.swap(to);
  }
  AMF::Central_difference_of_gaussians response;
  const auto options = detector.options();
  const AMF::Scale_levels units = options.sampling(animation.rest_shape(), animation.number_of_frames(),
                                                   animation.frame_duration(), in_space, in_time);
  response.initialize(sigma, tau, units);
  std::vector<double> shown_sigma, shown_tau;
  for (std::size_t k : {3, 5, 7}) {
    shown_sigma.push_back(sigma[k]);
    for (std::size_t l : {4, 8, 12}) {
      if (k == 3) shown_tau.push_back(tau[l]);
      Rows smoothed, difference;
      for (std::size_t v = 0; v < line.size(); ++v) {
        smoothed.push_back(levels[k][v][l]);
        difference.emplace_back();
        for (std::size_t f = 0; f < animation.number_of_frames(); ++f)
          difference.back().push_back(response.space_weight(k, l) * (levels[k + 1][v][l][f] - levels[k - 1][v][l][f]) +
                                      response.time_weight(k, l) * (levels[k][v][l + 1][f] - levels[k][v][l - 1][f]));
      }
      const std::string name = std::to_string(shown_sigma.size() - 1) + "_" + std::to_string(l / 4 - 1);
      json.add("smoothed_" + name, smoothed);
      json.add("response_" + name, difference);
    }
  }
  json.add("sigma", shown_sigma);
  json.add("tau", shown_tau);
  Rows found;
  for (const auto& f : features)
    found.push_back({f.rest_position[0], f.rest_position[2], f.time, f.sigma, f.tau, f.strength});
  json.add("found", found);
  Rows known;
  for (const auto& b : shape.bends)
    known.push_back({b.angle, b.axial_position, b.centre_time, b.axial_deviation(), b.temporal_deviation()});
  json.add("known", known);
}

// The colours of the package's pictures, for plots that show the same field.
void colours(const std::string& path)
{
  Rows field;
  for (int i = 0; i <= 32; ++i) {
    const Programs::Rendering::Srgb8 c = Programs::Rendering::encoded(Programs::Rendering::field_colours()(i / 32.));
    field.push_back({double(c[0]), double(c[1]), double(c[2])});
  }
  Json_file(path).add("field", field);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "Usage: scale_data FOLDER" << std::endl;
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    colours(folder + "colours.json");
    gaussians_in_time(folder + "gaussians_in_time.json");
    blob(folder + "blob.json");
    cylinder(folder + "cylinder.json");
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "scale_data: " << e.what() << std::endl;
    return 1;
  }
}
