// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the time of a detection goes, and what the clusters of the heat method save: the stages of both presets on the
// bending cylinder, and the balls of all policies, as ratios to the first of them. Usage: stages [vertices [frames]]

#include <CGAL/Animated_mesh_features/Dijkstra_geodesic_balls.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "generators/bending_cylinder.h"

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
typedef Animated_mesh_generators::Generated_animation Animation;
typedef Amf::Frame_sequence<Animation::Mesh> Sequence;

struct Timing_visitor : Amf::Default_visitor
{
  std::map<Amf::Stage, double> seconds;
  CGAL::Real_timer timer;
  void begin(Amf::Stage)
  {
    timer.reset();
    timer.start();
  }
  void end(Amf::Stage stage)
  {
    timer.stop();
    seconds[stage] += timer.time();
  }
};

template <class Options>
void time_stages(const std::string& preset, const Sequence& sequence, const Options& options)
{
  Timing_visitor visitor;
  Amf::Feature_detector<Sequence, Options> detector(sequence, options);
  std::vector<typename Amf::Feature_detector<Sequence, Options>::Feature> features;
  detector(std::back_inserter(features), visitor);
  double total = 0;
  for (const auto& s : visitor.seconds) total += s.second;
  std::cout << preset << ": " << detector.sigma_levels().size() << " x " << detector.tau_levels().size() << " levels, "
            << detector.number_of_minima() << " minima, " << features.size() << " features, " << total << " s\n";
  for (const auto& s : visitor.seconds)
    std::cout << "  " << std::setw(16) << std::left << name(s.first) << std::right << std::setw(9) << s.second << " s "
              << std::setw(5) << 100 * s.second / total << " %\n";
}

template <class Balls>
double time_balls(const std::string& name, const Sequence& sequence, const Balls& policy, double reference)
{
  CGAL::Real_timer timer;
  timer.start();
  const Amf::Compressed_rows rows = Amf::geodesic_balls<CGAL::Parallel_if_available_tag>(sequence, 0, policy);
  timer.stop();
  std::cout << "  " << std::setw(32) << std::left << name << std::right << std::setw(9)
            << 1e6 * timer.time() / double(rows.size()) << " us a vertex, "
            << double(rows.number_of_entries()) / double(rows.size()) << " vertices a ball";
  if (reference > 0) std::cout << ", ratio " << timer.time() / reference;
  std::cout << std::endl;
  return timer.time();
}

int main(int argc, char* argv[])
{
  Animated_mesh_generators::Bending_cylinder_options options;
  options.vertices_around =
      Animated_mesh_generators::vertices_around_for(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 4000, options);
  options.number_of_frames = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 60;
  options.frame_rate = double(options.number_of_frames) / 2;
  const Animation animation = Animated_mesh_generators::bending_cylinder(options);
  const Sequence sequence(animation.mesh, animation.frames, animation.frame_duration);
  std::cout << std::fixed << std::setprecision(3) << sequence.number_of_vertices() << " vertices, "
            << sequence.number_of_frames() << " frames\n";
  time_stages("calibrated", sequence, Amf::calibrated_options());
  time_stages("published", sequence,
              Amf::published_options(Amf::published_box_width(sequence.number_of_frames())));
  std::cout << "geodesic balls:\n";
  const double clusters = time_balls("heat method, clusters", sequence, Amf::Heat_method_geodesic_balls(), 0);
  Amf::Heat_method_geodesic_balls single;
  single.cluster_size = 1;
  time_balls("heat method, patch per vertex", sequence, single, clusters);
  time_balls("heat method, whole mesh", sequence, Amf::Global_heat_method_geodesic_balls(), clusters);
  time_balls("Dijkstra", sequence, Amf::Dijkstra_geodesic_balls(), clusters);
  return EXIT_SUCCESS;
}
