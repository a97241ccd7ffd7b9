// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Features of detectors of static shapes, as a file that evaluate_features reads: what the package's own detector is
// compared with. Either the interest points of each frame on its own; or the features that the package's detector
// finds in what the static one sees, a field over the surface and time.

#include "Harris_3d.h"
#include "Heat_kernel_signature.h"
#include "Mesh_dog.h"
#include "Mesh_saliency.h"
#include "One_ring_scale_space.h"
#include "options/Names.h"
#include "options/Option_groups.h"
#include "output/check_outputs.h"
#include "reading/Animation.h"
#include "reading/animation_report.h"
#include "running/Interruption.h"
#include "running/Thread_limit.h"
#include "running/run_program.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_detector.h>
#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;
using namespace Static_detectors;
using Programs::Argument;

namespace {

struct Options
{
  Programs::Reading_options reading;
  std::string detector, points, of_field; // files; empty: none
  bool quiet = false, help = false;
  double threshold = 0.02;
  std::size_t threads = 0;
};

const char* const names = "saliency, mesh-dog, harris, one-ring or hks";

std::unique_ptr<Static_detector> static_detector(const std::string& name)
{
  if (name == "saliency") return std::make_unique<Mesh_saliency>();
  if (name == "mesh-dog") return std::make_unique<Mesh_dog>();
  if (name == "harris") return std::make_unique<Harris_3d>();
  if (name == "one-ring") return std::make_unique<One_ring_scale_space>();
  if (name == "hks") return std::make_unique<Heat_kernel_signature>();
  throw AMF::Option_error("there is no detector \"" + name + "\"; choose " + names);
}

std::string usage(const Programs::Option_groups& groups)
{
  std::ostringstream os;
  os << R"(Usage: static_features DETECTOR [options] INPUT... [--points FEATURES.json] [--field FEATURES.json]

Finds the interest points of each frame of an animation by a detector of static shapes: mesh saliency (saliency),
MeshDOG on mean curvature (mesh-dog), Harris 3D (harris), the one-ring scale space of Darom and Keller (one-ring), or
maxima of the heat kernel signature (hks); tau is the time between two frames (--points). Or takes what the detector
sees at each vertex and frame, minus the least at each vertex, as the field in which features are found as
detect_features finds them in the deformation (--field).

)" << Programs::input_help()
     << groups;
  return os.str();
}

std::vector<Static_response> responses(Static_detector& detector, const Programs::Sequence& sequence,
                                       const Connectivity& connectivity)
{
  const double diagonal = sequence.rest_shape().bounding_box_diagonal();
  detector.prepare({connectivity, sequence.rest_shape().points(), diagonal});
  std::vector<Static_response> result(sequence.number_of_frames());
  AMF::parallel_for<CGAL::Parallel_if_available_tag>(0, result.size(), [&](std::size_t f) {
    Programs::Interruption::check();
    result[f] = detector({connectivity, sequence.trajectories().frame(f).points(), diagonal});
  });
  detector.finish({connectivity, sequence.rest_shape().points(), diagonal}, result);
  return result;
}

std::vector<AMF::Feature_point> points_of_frames(const std::vector<Static_response>& responses,
                                                 const Programs::Sequence& sequence)
{
  const AMF::Rest_shape& shape = sequence.rest_shape();
  std::vector<AMF::Feature_point> features;
  for (std::size_t f = 0; f < responses.size(); ++f)
    for (const Interest_point& p : responses[f].points) {
      AMF::Feature_point feature;
      feature.vertex_index = p.vertex;
      feature.frame = f;
      feature.refined_frame = double(f);
      feature.time = double(f) * sequence.frame_duration();
      const auto& triangle = shape.triangles()[shape.incident_triangles()[p.vertex][0]];
      for (std::size_t i = 0; i < 3; ++i) {
        feature.triangle[i] = triangle[i];
        feature.barycentric_coordinates[i] = triangle[i] == p.vertex ? 1 : 0;
      }
      const Point now = sequence.trajectories().frame(f)[p.vertex];
      for (std::size_t i = 0; i < 3; ++i) {
        feature.position[i] = now[Eigen::Index(i)];
        feature.rest_position[i] = shape.points()[p.vertex][Eigen::Index(i)];
      }
      feature.sigma = p.sigma;
      feature.tau = sequence.frame_duration();
      feature.amplitude = feature.strength = p.strength;
      feature.response = -p.strength;
      features.push_back(feature);
    }
  std::stable_sort(features.begin(), features.end(),
                   [](const auto& a, const auto& b) { return a.strength > b.strength; });
  return features;
}

std::vector<AMF::Feature_point> features_of_field(const std::vector<Static_response>& responses,
                                                  const Programs::Sequence& sequence, double threshold)
{
  typedef AMF::Feature_detector<double> Detector;
  Detector::Field field(sequence.rest_shape().number_of_vertices(), responses.size());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < responses.size(); ++f) field(v, f) = responses[f].values[v];
  AMF::subtract_baseline(field, AMF::Least_value_baseline());
  Detector detector(sequence.rest_shape(), std::move(field), sequence.frame_duration());
  detector.selection().relative_threshold = threshold;
  std::vector<Detector::Feature> found;
  detector(std::back_inserter(found));
  std::vector<AMF::Feature_point> features;
  for (const Detector::Feature& f : found) features.push_back(AMF::place_on_animation(f, sequence));
  return features;
}

void write(const std::string& path, const std::vector<AMF::Feature_point>& features, bool is_of_field, const Options& o,
           const Programs::Animation& animation)
{
  AMF::IO::Result_description description = Programs::animation_description(animation);
  description.add("program", "static_features");
  description.add("detector", o.detector);
  description.add("as_field", is_of_field);
  Programs::add_if(is_of_field, description, "relative_threshold", o.threshold);
  Programs::add_reading_parameters(description, o.reading, animation);
  AMF::IO::Output_file file(path);
  AMF::IO::write_json(file.stream(), features, description);
  file.stream().flush();
  file.check();
  file.commit();
  if (!o.quiet) Programs::tell(path + ": " + std::to_string(features.size()) + " features\n");
}

void run(const Options& o)
{
  const Programs::Thread_limit limit(o.threads);
  const std::unique_ptr<Static_detector> detector = static_detector(o.detector);
  const Programs::Animation animation(o.reading, [](std::size_t, std::size_t) { return AMF::Field_memory::heap(); });
  const Programs::Sequence& sequence = animation.sequence();
  std::vector<std::string> outputs;
  for (const std::string& path : {o.points, o.of_field})
    if (!path.empty()) outputs.push_back(path);
  if (outputs.empty()) throw AMF::Option_error("say what to write: --points FILE, --field FILE or both");
  Programs::check_outputs(outputs, animation.files());
  if (!o.quiet) Programs::tell(Programs::reading_notices(o.reading, animation));
  const Programs::Interruption interruption;
  std::vector<Triangle> triangles;
  for (const AMF::Rest_shape::Triangle& t : sequence.rest_shape().triangles())
    triangles.push_back({{t[0], t[1], t[2]}});
  const Connectivity connectivity(sequence.rest_shape().number_of_vertices(), std::move(triangles));

  const std::vector<Static_response> seen = responses(*detector, sequence, connectivity);
  if (!o.points.empty()) write(o.points, points_of_frames(seen, sequence), false, o, animation);
  if (!o.of_field.empty()) write(o.of_field, features_of_field(seen, sequence, o.threshold), true, o, animation);
}

} // namespace

int main(int argc, char* argv[])
{
  return Programs::run_program("static_features", [&] {
    Options o;
    std::vector<std::string> arguments;
    Programs::Option_groups groups;
    Programs::add_reading_options(groups.add_group("Input"), o.reading);
    Programs::Option_group& group = groups.add_group("Detection");
    group.add("points", "FILE", "write the interest points of each frame, JSON",
              [&](const Argument& a) { o.points = a.text(); });
    group.add("field", "FILE", "write the features that are found in what the detector sees",
              [&](const Argument& a) { o.of_field = a.text(); });
    group.add("relative-threshold", "T", "with --field: the least strength, of the strongest (default: 0.02)",
              [&](const Argument& a) { o.threshold = a.non_negative_number(); });
    group.add("threads", "N", "at most that many threads (default: all)",
              [&](const Argument& a) { o.threads = a.count(); });
    group.add_switch("quiet,q", o.quiet, "say nothing");
    group.add_switch("help,h", o.help, "show this text");
    groups.add_positional("inputs", arguments, -1);
    groups.parse(argc, argv);
    if (o.help) {
      std::cout << usage(groups) << std::flush;
      return;
    }
    if (arguments.empty()) throw AMF::Option_error(std::string("say which detector: ") + names);
    o.detector = arguments.front();
    o.reading.inputs.assign(arguments.begin() + 1, arguments.end());
    groups.use();
    Programs::check(o.reading);
    run(o);
  });
}
