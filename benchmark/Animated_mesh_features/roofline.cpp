// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the machine can do at most, and what share of it the stages reach: operations that the method needs, and bytes
// that have to come from a cache or from memory, are counted from the formulas, not from the code.

#include "animations.h"
#include "benchmark_support.h"
#include "isolated_loops.h"

#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>
#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <Eigen/SparseCholesky>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace Benchmark;

namespace {

typedef Amf::Rest_shape Rest_shape;
typedef Amf::Frame_sequence<Mesh, double> Sequence;
typedef Amf::Frame_sequence<Mesh, float> Float_sequence;

// -------------------------------------------------------------------------------------------------------------- bounds

// Runs a loop for each of several threads at once; returns the time in which all of them are done.
template <class Loop>
double seconds_of_all(std::vector<std::unique_ptr<Loop>>& loops)
{
  std::atomic<std::size_t> ready(0);
  std::atomic<bool> go(false);
  std::vector<std::thread> threads;
  for (auto& loop : loops)
    threads.emplace_back([&] {
      ++ready;
      while (!go) std::this_thread::yield();
      run_widest(*loop);
    });
  while (ready < loops.size()) std::this_thread::yield();
  return seconds_of([&] {
    go = true;
    for (std::thread& t : threads) t.join();
  });
}

template <class Loop>
double least_seconds_of_all(std::vector<std::unique_ptr<Loop>>& loops, const Repetitions& r)
{
  double least = std::numeric_limits<double>::infinity(), total = 0;
  for (std::size_t i = 0; i < r.most && (i < r.least || total < r.seconds); ++i) {
    const double t = seconds_of_all(loops);
    least = (std::min)(least, t);
    total += t;
  }
  return least;
}

double bandwidth(std::size_t bytes_per_thread, std::size_t threads, const Arguments& arguments)
{
  const double moved = arguments.quick ? 2e8 : 2e9; // by each thread in a run
  std::vector<std::unique_ptr<Triad_loop>> loops;
  for (std::size_t i = 0; i < threads; ++i)
    loops.push_back(
        std::make_unique<Triad_loop>(bytes_per_thread, 1 + std::size_t(moved / double(bytes_per_thread))));
  double bytes = 0;
  for (const auto& k : loops) bytes += k->bytes_moved();
  return bytes / least_seconds_of_all(loops, repetitions(arguments));
}

template <class T>
double peak(std::size_t threads, const Arguments& arguments)
{
  std::vector<std::unique_ptr<Multiply_add_loop<T>>> loops;
  double flops = 0;
  for (std::size_t i = 0; i < threads; ++i) {
    loops.push_back(std::make_unique<Multiply_add_loop<T>>());
    loops.back()->steps = arguments.quick ? 1000000 : 20000000;
    flops += loops.back()->flops();
  }
  return flops / least_seconds_of_all(loops, repetitions(arguments));
}

std::size_t cache_size(int name, std::size_t usual)
{
  const long bytes = sysconf(name);
  return bytes > 0 ? std::size_t(bytes) : usual;
}

struct Bounds
{
  std::size_t threads;
  double float_peak, double_peak; // operations / s
  double l2, l3, memory;          // bytes / s
  double l2_size, l3_size;        // of all threads
};

Bounds measured_bounds(std::size_t threads, const Arguments& arguments)
{
  const std::size_t l2 = cache_size(_SC_LEVEL2_CACHE_SIZE, 1 << 20), l3 = cache_size(_SC_LEVEL3_CACHE_SIZE, 32 << 20);
  // all threads share L3
  const std::size_t in_l3 = (std::max)(2 * l2, l3 / 2 / threads);
  const std::size_t in_memory = (std::min)((std::max)(4 * l3, std::size_t(256) << 20), std::size_t(1) << 30) / threads;
  return {threads,
          peak<float>(threads, arguments),
          peak<double>(threads, arguments),
          bandwidth(l2 / 2, threads, arguments),
          bandwidth(in_l3, threads, arguments),
          bandwidth(arguments.quick ? in_l3 : in_memory, threads, arguments),
          double(l2 * threads),
          double(l3)};
}

// -------------------------------------------------------------------------------------------------------------- stages

// What one unit of a stage needs, of how many units there are.
struct Stage_cost
{
  std::string name, unit;
  bool in_double;
  double units;
  double operations, bytes; // a unit
  double working_set;       // bytes
};

void add_row(const Stage_cost& c, double seconds, const Bounds& b, Table& table)
{
  const double compute = c.in_double ? b.double_peak : b.float_peak;
  const bool in_l2 = c.working_set <= b.l2_size, in_l3 = c.working_set <= b.l3_size;
  const double bytes = in_l2 ? b.l2 : in_l3 ? b.l3 : b.memory;
  const double intensity = c.operations / c.bytes, rate = c.units * c.operations / seconds;
  const bool is_compute_bound = compute <= bytes * intensity;
  const double bound = is_compute_bound ? compute : bytes * intensity;
  table.add(c.name, b.threads, c.unit, c.operations, c.bytes, intensity, 1e-9 * rate, 1e-9 * bound,
            is_compute_bound ? "arithmetic"
            : in_l2          ? "L2"
            : in_l3          ? "L3"
                             : "memory",
            100 * rate / bound);
}

struct Factor
{
  double entries = 0;    // of the triangular factor
  double operations = 0; // of the factorisation
};

// The Cholesky factor of a matrix with the connectivity of some vertices, in Eigen's default order.
Factor factor(const Rest_shape& shape, const std::vector<Rest_shape::Index>& vertices)
{
  std::vector<int> number(shape.number_of_vertices(), -1);
  for (std::size_t i = 0; i < vertices.size(); ++i) number[vertices[i]] = int(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (Rest_shape::Index v : vertices) {
    entries.emplace_back(number[v], number[v], 1 + double(shape.neighbours()[v].size()));
    for (Rest_shape::Index w : shape.neighbours()[v])
      if (number[w] >= 0) entries.emplace_back(number[v], number[w], -1);
  }
  Eigen::SparseMatrix<double> matrix(Eigen::Index(vertices.size()), Eigen::Index(vertices.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(matrix);
  const Eigen::SparseMatrix<double> l = cholesky.matrixL();
  Factor result;
  for (Eigen::Index j = 0; j < l.outerSize(); ++j) {
    const double n = double(l.col(j).nonZeros());
    result.entries += n;
    result.operations += n * n;
  }
  return result;
}

// Two solves of the equations of a cluster's patch for each vertex, as Heat_method_geodesic_balls documents it.
Stage_cost balls_cost(const Rest_shape& shape, double radius)
{
  const double h = shape.mean_edge_length();
  const Amf::Heat_method_geodesic_balls policy;
  const double beyond = radius + policy.patch_margin * h;
  // Clusters are the cells of seeds some 1.2 times their radius apart, here discs of the same area of equilateral
  // triangles.
  const double pi = 3.14159265358979323846;
  const double cluster_radius = 0.63 * policy.cluster_radius * beyond;
  const double cluster = pi * cluster_radius * cluster_radius / (h * h * std::sqrt(0.75));
  const double reach = cluster_radius + beyond;
  const Amf::Compressed_rows patches = Amf::Dijkstra_geodesic_balls()(shape, reach, Policy_loop());
  const std::size_t samples = 20;
  double operations = 0, bytes = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto row = patches[i * patches.size() / samples];
    const std::vector<Rest_shape::Index> vertices(row.begin(), row.end());
    const Factor f = factor(shape, vertices);
    const double triangles = 2 * double(vertices.size());
    // Two factorisations for the cluster; for each source forward and back substitution in both, gradient, its norm and
    // its divergence in each triangle.
    operations += 2 * f.operations / cluster + 2 * 4 * f.entries + 50 * triangles;
    // Both factors, values and indices, in and out of the caches once for the cluster.
    bytes += 2 * 2 * 12 * f.entries / cluster;
  }
  return {"geodesic balls, heat method",
          "ball",
          true,
          double(shape.number_of_vertices()),
          operations / double(samples),
          bytes / double(samples),
          2 * bytes * cluster / double(samples)};
}

template <class Seq>
double engine_seconds(const Seq& sequence, const Amf::Spatio_temporal_field<typename Seq::FT>& field,
                      const Amf::Published_options& options, const Arguments& arguments)
{
  typedef Amf::Feature_detector<typename Seq::FT, Amf::Published_options> Detector;
  return least_seconds(
      [&] {
        Detector detector(sequence.rest_shape(), field, sequence.frame_duration(), options);
        std::vector<typename Detector::Feature> features;
        detector(std::back_inserter(features));
      },
      arguments.quick ? Repetitions{1, 1, 0} : Repetitions{2, 5, 3});
}

} // namespace

int main(int argc, char* argv[])
{
  return run("roofline", argc, argv, [](const Arguments& arguments, Report& report) {
    Table bounds(
        "Bounds of the machine",
        "Multiply-and-add in registers, twelve chains; STREAM's triad on doubles, 24 bytes an element, in half of "
        "the L2 cache, in half of L3 and in memory. Registers of " +
            std::to_string(8 * register_bytes()) + " bits.",
        {"threads", "float GF/s", "double GF/s", "L2 GB/s", "L3 GB/s", "memory GB/s"});
    std::vector<Bounds> measured;
    for (std::size_t threads : thread_counts()) {
      measured.push_back(measured_bounds(threads, arguments));
      const Bounds& b = measured.back();
      bounds.add(threads, 1e-9 * b.float_peak, 1e-9 * b.double_peak, 1e-9 * b.l2, 1e-9 * b.l3, 1e-9 * b.memory);
    }
    report.add(bounds);

    const Workload w = horse(arguments);
    const auto sequence = w.sequence<double>();
    const auto floats = w.sequence<float>();
    const Rest_shape& shape = sequence->rest_shape();
    const double n = double(shape.number_of_vertices()), f = double(sequence->number_of_frames());
    const double triangles = double(shape.triangles().size());
    const double radius = 3 * shape.mean_edge_length();

    Table table(
        "Shares of the bounds: " + w.name,
        "N = " + std::to_string(shape.number_of_vertices()) + ", F = " + std::to_string(sequence->number_of_frames()) +
            ". Operations: additions, multiplications, comparisons and square roots that the formulas need, one "
            "each. Bytes: what has to come from or go to the smallest cache that holds all of it, once. Bound: the "
            "smaller of the peak and of bandwidth times operations a byte. The peak needs as many additions as "
            "multiplications, in pairs, which no stage has: half of it is much.",
        {"stage", "threads", "unit", "operations", "bytes", "operations / byte", "1e9 operations / s", "bound",
         "bound by", "share of the bound %"});

    const std::size_t space = arguments.quick ? 8 : 64, time = arguments.quick ? 8 : 54;
    Amf::Published_options published = Amf::published_options(8);
    published.sampling.max_space_count = space;
    published.sampling.max_time_count = time;
    const Amf::Compressed_rows balls =
        Amf::geodesic_balls<CGAL::Parallel_if_available_tag>(sequence->rest_shape(), radius);
    const auto change = Amf::curvature_change<CGAL::Parallel_if_available_tag>(*sequence, balls);
    const auto float_change = Amf::curvature_change<CGAL::Parallel_if_available_tag>(*floats, balls);
    const double samples = n * f * double(space) * double(time);
    // Two box averages: 4 additions and 2 multiplications each for the value of an even width and the running sum;
    // weighted sum: 3; 8 scales and 2 frames: 10. One-ring average of two rows, once for all time levels.
    const double mean_ring = 2 * double(shape.edges().size()) / n;
    const double engine_operations = 2 * 6 + 3 + 10 + 2 * (mean_ring + 1) / double(time);
    // A level is written once and read twice, by the next level and by the responses.
    const auto engine_cost = [&](const char* name, bool in_double) {
      const double scalar = in_double ? 8 : 4;
      return Stage_cost{
          name, "sample", in_double, samples, engine_operations, 3 * 2 * scalar / double(time), 16 * n * f * scalar};
    };

    // The levels of the preset, on the horse some ten.
    std::vector<double> variances;
    for (std::size_t k = 0; k < 9; ++k)
      variances.push_back(std::pow(2., double(k)) * std::pow(0.01 * shape.diameter(), 2));
    std::vector<Rest_shape::Index> all;
    for (std::size_t v = 0; v < shape.number_of_vertices(); ++v) all.push_back(Rest_shape::Index(v));
    const Factor whole = factor(shape, all);
    const double width = double(register_bytes()) / sizeof(float);
    // Two solves a level, each forward and back; the factor (value and index) comes once a pass for as many frames as a
    // register holds. One factorisation a level.
    const Stage_cost diffusion = {"heat diffusion",
                                  "level, frame",
                                  false,
                                  double(variances.size()) * f,
                                  2 * 4 * whole.entries + whole.operations / f,
                                  2 * 2 * 8 * whole.entries / width + 2 * 2 * 2 * 4 * n,
                                  8 * whole.entries + 2 * n * f * 4};
    // Edges 6, in the rest frame 12, first fundamental form 15, eigenvalues 10, measure 1. Three coordinates of a
    // vertex, of which there are half as many as triangles, and the result.
    const auto strain_cost = [&](const char* name, bool in_double) {
      const double scalar = in_double ? 8 : 4;
      return Stage_cost{name,
                        "triangle, frame",
                        in_double,
                        triangles * f,
                        44,
                        (3 * n / triangles + 1) * scalar,
                        (3 * n + triangles) * f * scalar};
    };
    const Stage_cost ball = balls_cost(shape, radius);

    for (const Bounds& b : measured) {
      const Thread_limit limit(b.threads);
      add_row(engine_cost("engine, every smoothing count, float", false),
              engine_seconds(*floats, float_change, published, arguments), b, table);
      add_row(engine_cost("engine, every smoothing count, double", true),
              engine_seconds(*sequence, change, published, arguments), b, table);
      add_row(ball,
              least_seconds([&] { Amf::Heat_method_geodesic_balls()(shape, radius, Policy_loop()); },
                            arguments.quick ? Repetitions{1, 1, 0} : Repetitions{2, 5, 2}),
              b, table);
      add_row(diffusion,
              least_seconds(
                  [&] {
                    Amf::Heat_diffusion_filter filter;
                    filter.initialize(shape, variances, Policy_loop());
                    Amf::Spatio_temporal_field<float> now = float_change, next = now;
                    for (std::size_t k = 0; k < variances.size(); ++k) {
                      filter(k, now, next, Policy_loop());
                      now.swap(next);
                    }
                  },
                  repetitions(arguments)),
              b, table);
      const Amf::Largest_eigenvalue_strain measure;
      add_row(strain_cost("strain of triangles, float", false),
              least_seconds([&] { Amf::triangle_strain<CGAL::Parallel_if_available_tag>(*floats, measure); },
                            repetitions(arguments)),
              b, table);
      add_row(strain_cost("strain of triangles, double", true),
              least_seconds([&] { Amf::triangle_strain<CGAL::Parallel_if_available_tag>(*sequence, measure); },
                            repetitions(arguments)),
              b, table);
    }
    report.add(table);
  });
}
