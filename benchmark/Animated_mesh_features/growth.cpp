// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How the time of each stage grows with the number of vertices N, of frames F, of space levels K and of time levels L,
// each over a factor of eight while the others stay the same.

#include "animations.h"
#include "benchmark_support.h"

#include <CGAL/detect_spatio_temporal_features.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#ifdef __GLIBC__
  #include <malloc.h>
#endif

using namespace Benchmark;

namespace {

typedef Amf::Frame_sequence<Mesh, double> Sequence;
typedef std::map<Amf::Stage, double> Stage_times;

struct Stage_timer : Amf::Default_visitor
{
  Stage_times seconds;
  std::chrono::steady_clock::time_point start;
  void begin(Amf::Stage) { start = std::chrono::steady_clock::now(); }
  void end(Amf::Stage stage)
  {
    seconds[stage] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

// The least time of each stage over some detections.
template <class Options>
Stage_times stage_times(const Sequence& sequence, const Options& options, const Repetitions& r)
{
  Stage_times least;
  double total = 0;
  for (std::size_t i = 0; i < r.most && (i < r.least || total < r.seconds); ++i) {
    Stage_timer timer;
    total += seconds_of([&] {
      Amf::Deformation_measurement<Sequence, Options> measurement(sequence, options);
      Amf::Feature_detector<double, Options> detector(sequence.rest_shape(), measurement.take_deformation(timer),
                                                      sequence.frame_duration(), options, measurement.noise());
      std::vector<typename Amf::Feature_detector<double, Options>::Feature> features;
      detector(std::back_inserter(features), timer);
    });
    for (const auto& s : timer.seconds) {
      double& t = least.emplace(s.first, s.second).first->second;
      t = (std::min)(t, s.second);
    }
  }
  return least;
}

// The slope of a line through the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y)
{
  double mean_x = 0, mean_y = 0, covariance = 0, variance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / double(x.size());
    mean_y += std::log(y[i]) / double(x.size());
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    covariance += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
    variance += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
  }
  return covariance / variance;
}

struct Run
{
  double size; // what is varied
  Stage_times seconds;
};

void add_row(const std::string& varied, const std::string& preset, const std::string& what,
             const std::vector<double>& x, const std::vector<double>& y, Table& table)
{
  table.add(varied, preset, what, x.front(), x.back(), y[0], y[1], y[2], y[3], exponent(x, y));
}

void add_rows(const std::string& varied, const std::string& preset, const std::vector<Run>& runs,
              const std::vector<Amf::Stage>& stages, Table& table)
{
  for (Amf::Stage stage : stages) {
    std::vector<double> x, y;
    for (const Run& r : runs) {
      x.push_back(r.size);
      y.push_back(r.seconds.at(stage));
    }
    add_row(varied, preset, name(stage), x, y, table);
  }
}

// Of all stages together.
void add_total(const std::string& varied, const std::string& preset, const std::vector<Run>& runs,
               const std::vector<Amf::Stage>& stages, Table& table)
{
  std::vector<double> x, y;
  for (const Run& r : runs) {
    double total = 0;
    for (Amf::Stage stage : stages) total += r.seconds.at(stage);
    x.push_back(r.size);
    y.push_back(total);
  }
  add_row(varied, preset, "all of them", x, y, table);
}

// Memory that was freed is used again rather than given back: to get a page from the operating system for the first time
// takes up to some microseconds, on a virtual machine more, and that would grow from nothing to more than the work as soon
// as arrays are large enough to be mapped one by one.
void keep_memory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1); // never
#endif
}

} // namespace

int main(int argc, char* argv[])
{
  return run("growth", argc, argv, [](const Arguments& arguments, Report& report) {
    const Thread_limit limit(1);
    keep_memory();
    const Repetitions r = arguments.quick ? Repetitions{1, 1, 0} : Repetitions{2, 3, 1};
    // fields that do not fit into the caches: on the way out of them everything seems to grow faster
    const std::size_t n = arguments.quick ? 2000 : 64000, f = arguments.quick ? 24 : 48, width = 8;
    const double frames_per_second = 30;
    const std::size_t k = arguments.quick ? 4 : 8, l = arguments.quick ? 4 : 8; // the least counts
    const std::vector<std::size_t> factors = {1, 2, 4, 8};
    typedef Amf::Stage S;

    const auto published = [&](const Sequence& s, std::size_t space, std::size_t time) {
      Amf::Published_options o = Amf::published_options(width);
      o.sampling.max_space_count = space;
      o.sampling.max_time_count = time;
      o.ball_radius = 3 * s.rest_shape().mean_edge_length();
      return o;
    };
    // The same levels, in length and seconds, whatever the resolution.
    const auto calibrated = [&](const Sequence& s) {
      Amf::Calibrated_options o;
      o.sampling.sigma = {0.05 * s.rest_shape().diameter(), 0.2 * s.rest_shape().diameter()};
      o.sampling.tau = {0.07, 0.25};
      return o;
    };

    std::vector<Run> by_vertices, by_vertices_calibrated, by_frames, by_frames_calibrated, by_space, by_time;
    for (std::size_t factor : factors) {
      const Workload w = cylinder(n * factor, f);
      const auto s = w.sequence<double>();
      const double size = double(s->number_of_vertices());
      by_vertices.push_back({size, stage_times(*s, published(*s, 2 * k, 2 * l), r)});
      by_vertices_calibrated.push_back({size, stage_times(*s, calibrated(*s), r)});
    }
    for (std::size_t factor : factors) {
      const Workload w = figure(n, f * factor, frames_per_second);
      const auto s = w.sequence<double>();
      const double size = double(s->number_of_frames());
      by_frames.push_back({size, stage_times(*s, published(*s, 2 * k, 2 * l), r)});
      by_frames_calibrated.push_back({size, stage_times(*s, calibrated(*s), r)});
    }
    const Workload w = figure(n, f);
    const auto s = w.sequence<double>();
    for (std::size_t factor : factors) {
      by_space.push_back({double(k * factor), stage_times(*s, published(*s, k * factor, 2 * l), r)});
      by_time.push_back({double(l * factor), stage_times(*s, published(*s, 2 * k, l * factor), r)});
    }

    Table table(
        "Growth of the stages",
        "Seconds on one thread, while one size goes up to eightfold and the others stay the same. N: cylinder; "
        "otherwise figure; N = " +
            std::to_string(n) + ", F = " + std::to_string(f) +
            ". F: longer animations, of as many frames in a second. K = " + std::to_string(2 * k) +
            ", L = " + std::to_string(2 * l) +
            "; radius of balls with published 3 mean edge lengths, with calibrated the default, and the same levels "
            "throughout. Exponent: the slope of a line through the logarithms of the four times. Heat diffusion (the "
            "scale space of calibrated) factors a matrix, the one thing that grows faster than what it works on: with "
            "N to the power of 1.5, for all frames at once.",
        {"varied", "preset", "stage", "from", "to", "x 1: s", "x 2: s", "x 4: s", "x 8: s", "exponent"});
    const std::vector<Amf::Stage> stages = {S::GEODESIC_BALLS, S::CURVATURE, S::STRAIN, S::SCALE_SPACE, S::EXTREMA};
    add_rows("N", "published", by_vertices, stages, table);
    add_total("N", "published", by_vertices, stages, table);
    add_rows("N", "calibrated", by_vertices_calibrated, stages, table);
    add_total("N", "calibrated", by_vertices_calibrated, stages, table);
    add_rows("F", "published", by_frames, {S::CURVATURE, S::STRAIN, S::SCALE_SPACE, S::EXTREMA}, table);
    add_total("F", "published", by_frames, stages, table);
    add_rows("F", "calibrated", by_frames_calibrated, {S::CURVATURE, S::STRAIN, S::SCALE_SPACE, S::EXTREMA}, table);
    add_total("F", "calibrated", by_frames_calibrated, stages, table);
    add_rows("K", "published", by_space, {S::SCALE_SPACE, S::EXTREMA}, table);
    add_rows("L", "published", by_time, {S::EXTREMA}, table);
    report.add(table);
  });
}
