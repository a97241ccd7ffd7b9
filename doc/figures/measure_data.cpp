// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers for the manual's figures on measures and on what can go wrong: strain measures, curvature under refinement, a
// mesh of varying density, bands around a tube, noise.
//
// measure_data FOLDER

#include "figures_support.h"

#include "generators/bending_cylinder.h"

#include <CGAL/Animated_mesh_features/Animation/rest_shape_of_mesh.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Scale_space/One_ring_average_filter.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using namespace figures;
typedef std::vector<std::vector<double>> Rows;

namespace {

// The same numbers everywhere, which those of <random>'s distributions need not be.
class Random
{
public:
  double uniform() // in (0, 1)
  {
    m_state = m_state * 6364136223846793005u + 1442695040888963407u; // D. Knuth's MMIX
    return (double(m_state >> 11) + 0.5) / 9007199254740992.;
  }
  double normal() // by the central limit theorem: bounded, and free of library functions that round in their own ways
  {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

private:
  std::uint64_t m_state = 2014;
};

// The measures of a triangle that is stretched in one direction.
void strain_measures(const std::string& path)
{
  std::vector<double> stretch, hencky, green_lagrange, principal, largest;
  for (int i = -40; i <= 40; ++i) {
    stretch.push_back(std::pow(2., i / 20.));
    const double squared = stretch.back() * stretch.back();
    const double a = (std::max)(squared, 1.), b = (std::min)(squared, 1.);
    hencky.push_back(AMF::Hencky_strain()(a, b));
    green_lagrange.push_back(AMF::Green_lagrange_strain()(a, b));
    principal.push_back(AMF::Principal_stretch_strain()(a, b));
    largest.push_back(AMF::Largest_eigenvalue_strain()(a, b));
  }
  Json_file json(path);
  json.add("stretch", stretch);
  json.add("hencky", hencky);
  json.add("green-lagrange", green_lagrange);
  json.add("stretch-measure", principal);
  json.add("largest-eigenvalue", largest);
}

template <class Measure>
double mean_curvature(const Frame_sequence& sphere, double radius, const Measure& measure)
{
  const auto field = AMF::curvature(sphere, AMF::geodesic_balls(sphere.rest_shape(), radius), measure);
  double sum = 0;
  for (std::size_t v = 0; v < field.number_of_rows(); ++v) sum += field(v, 0);
  return sum / double(field.number_of_rows());
}

// Spheres of radius 1 that are meshed ever finer: one and the same curvature.
void curvature_under_refinement(const std::string& path)
{
  std::vector<double> edge, density, dihedral;
  for (unsigned splits : {2, 3, 4, 5}) {
    Mesh mesh;
    CGAL::make_icosahedron<Mesh, Point_3>(mesh);
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(splits));
    for (Mesh::Vertex_index v : mesh.vertices()) {
      const auto x = mesh.point(v) - CGAL::ORIGIN;
      mesh.point(v) = CGAL::ORIGIN + x / std::sqrt(x.squared_length());
    }
    const Frame_sequence sphere = at_rest(mesh, 3, 1);
    const double radius = 0.45;
    const AMF::Mean_curvature_density measure;
    edge.push_back(sphere.rest_shape().mean_edge_length());
    density.push_back(mean_curvature(sphere, radius, measure) / measure.factor(sphere.rest_shape()));
    dihedral.push_back(mean_curvature(sphere, radius, AMF::Mean_dihedral_angle()));
  }
  Json_file json(path);
  json.add("edge", edge);
  json.add("density", density);
  json.add("dihedral", dihedral);
}

// A square of side 2, of which the density of vertices grows 8-fold from left to right: points that keep a distance.
Mesh square_of_varying_density()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Delaunay_triangulation_2<Kernel> Delaunay;
  Random random;
  Mesh mesh;
  Delaunay delaunay;
  std::map<Delaunay::Vertex_handle, Mesh::Vertex_index> vertex;
  const auto add = [&](double x, double y) {
    vertex[delaunay.insert(Kernel::Point_2(x, y))] = mesh.add_vertex(Point_3(x, y, 0));
  };
  // the border first, or triangles as long as a side would be along it
  const auto distance_at = [](double x) { return 0.045 * std::pow(8., -(x + 1) / 4); };
  for (double y : {-1., 1.})
    for (double x = -1; x < 1; x += distance_at(x)) add(x, y);
  for (double x : {-1., 1.}) {
    const int steps = int(2 / distance_at(x));
    for (int i = x < 0 ? 1 : 0; i <= (x < 0 ? steps - 1 : steps); ++i) add(x, -1 + 2. * i / steps);
  }
  for (int i = 0; i < 60000; ++i) {
    const double x = 2 * random.uniform() - 1, y = 2 * random.uniform() - 1;
    const double distance = distance_at(x);
    const Kernel::Point_2 p(x, y);
    const auto nearest = delaunay.nearest_vertex(p);
    if (CGAL::squared_distance(nearest->point(), p) > distance * distance) add(x, y);
  }
  for (auto f = delaunay.finite_faces_begin(); f != delaunay.finite_faces_end(); ++f)
    mesh.add_face(vertex[f->vertex(0)], vertex[f->vertex(1)], vertex[f->vertex(2)]);
  return mesh;
}

// sigma that is found of blobs of one size, where the mesh is coarse and where it is fine.
template <class Options>
std::vector<double> sigma_of_blobs(const AMF::Rest_shape& shape, const std::vector<double>& places, double size,
                                   Options options)
{
  const double duration = 0.12, frame_duration = 1. / 30;
  options.sampling.sigma = {size / 4, size * 4};
  std::vector<double> result;
  for (double x : places) {
    AMF::Spatio_temporal_field<double> field(shape.number_of_vertices(), 48);
    for (std::size_t v = 0; v < field.number_of_rows(); ++v)
      for (std::size_t f = 0; f < field.number_of_frames(); ++f) {
        const double r = (shape.points()[v] - AMF::Rest_shape::Point(x, 0, 0)).squaredNorm();
        const double t = (double(f) * frame_duration - 0.8) / duration;
        field(v, f) = std::exp(-(r / (size * size) + t * t) / 2);
      }
    AMF::Feature_detector<double, Options> detector(shape, field, frame_duration, options);
    std::vector<typename AMF::Feature_detector<double, Options>::Feature> features;
    detector(std::back_inserter(features));
    result.push_back(features.empty() ? 0 : features.front().sigma / size);
  }
  return result;
}

void varying_density(const std::string& path)
{
  const Mesh mesh = square_of_varying_density();
  const AMF::Rest_shape shape = AMF::rest_shape_of_mesh(mesh);
  const double size = 0.12;
  const std::vector<double> places = {-0.6, -0.45, -0.3, -0.15, 0, 0.15, 0.3, 0.45, 0.6};
  const auto calibrated = AMF::calibrated_options();
  Json_file json(path);
  json.add("vertices", double(num_vertices(mesh)));
  json.add("size", size);
  json.add("places", places);
  json.add("heat", sigma_of_blobs(shape, places, size, calibrated));
  json.add("one_ring",
           sigma_of_blobs(shape, places, size, calibrated.with_spatial_filter(AMF::One_ring_average_filter(false))));
  json.add("one_ring_per_vertex",
           sigma_of_blobs(shape, places, size, calibrated.with_spatial_filter(AMF::One_ring_average_filter(true))));
  Rows edges;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Point_3 &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    edges.push_back({p.x(), p.y(), q.x(), q.y()});
  }
  json.add("edges", edges);
}

// Bands around a cylinder: all that a tube lets an event be, once it is wider than the tube.
void bands(const std::string& path)
{
  const Animated_mesh_generators::Bending_cylinder_options cylinder;
  const AMF::Rest_shape shape = AMF::rest_shape_of_mesh(Animated_mesh_generators::bending_cylinder(cylinder).mesh);
  const double frame_duration = 1. / 30;
  const std::vector<double> widths = {0.1, 0.14, 0.2, 0.28, 0.4, 0.56};
  Rows found;
  for (double width : widths) {
    AMF::Spatio_temporal_field<double> field(shape.number_of_vertices(), 48);
    for (std::size_t v = 0; v < field.number_of_rows(); ++v)
      for (std::size_t f = 0; f < field.number_of_frames(); ++f) {
        const double z = (shape.points()[v].z() - cylinder.height / 2) / width;
        const double t = (double(f) * frame_duration - 0.8) / 0.12;
        // a little stronger on one side: a field that is constant around has no strict minimum
        const double side = 1 + 0.01 * shape.points()[v].x() / cylinder.radius;
        field(v, f) = side * std::exp(-(z * z + t * t) / 2);
      }
    AMF::Feature_detector<double> detector(shape, field, frame_duration);
    std::vector<AMF::Feature_detector<double>::Feature> features;
    detector(std::back_inserter(features));
    found.emplace_back();
    for (const auto& f : features) found.back().insert(found.back().end(), {f.sigma, double(f.at_scale_limit)});
  }
  Json_file json(path);
  json.add("radius", cylinder.radius);
  json.add("widths", widths);
  json.add("found", found);
}

// The bending cylinder, whose four features are known, with noise on each coordinate of each frame.
void noise(const std::string& path)
{
  const Animated_mesh_generators::Bending_cylinder_options shape;
  const auto generated = Animated_mesh_generators::bending_cylinder(shape);
  const std::vector<double> levels = {0, 0.003, 0.01, 0.03, 0.1};
  Rows strengths;
  for (double level : levels) {
    auto frames = generated.frames;
    Frame_sequence straight(generated.mesh, frames, generated.frame_duration);
    straight.set_rest_shape(generated.mesh.points());
    const double deviation = level * straight.rest_shape().mean_edge_length();
    Random random;
    for (auto& frame : frames)
      for (auto& p : frame) {
        const double x = random.normal(), y = random.normal(), z = random.normal();
        p = Point_3(p.x() + deviation * x, p.y() + deviation * y, p.z() + deviation * z);
      }
    Frame_sequence animation(generated.mesh, frames, generated.frame_duration);
    animation.set_rest_shape(generated.mesh.points());
    auto options = AMF::calibrated_options();
    options.selection.relative_threshold = 0.02;
    std::vector<AMF::Spatio_temporal_feature<Mesh::Vertex_index>> features;
    CGAL::detect_spatio_temporal_features(animation, std::back_inserter(features), options);
    strengths.emplace_back();
    for (const auto& f : features) {
      // whether it is one of the known ones: sign tells
      const bool is_known = std::any_of(shape.bends.begin(), shape.bends.end(), [&](const auto& b) {
        return std::abs(f.rest_position[2] - b.axial_position) < b.axial_deviation() &&
               std::abs(f.time - b.centre_time) < b.temporal_deviation();
      });
      strengths.back().push_back(is_known ? f.strength : -f.strength);
    }
  }
  Json_file json(path);
  json.add("levels", levels);
  json.add("strengths", strengths);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "Usage: measure_data FOLDER" << std::endl;
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    strain_measures(folder + "strain_measures.json");
    curvature_under_refinement(folder + "refinement.json");
    varying_density(folder + "varying_density.json");
    bands(folder + "bands.json");
    noise(folder + "noise.json");
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "measure_data: " << e.what() << std::endl;
    return 1;
  }
}
