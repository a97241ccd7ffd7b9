// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The scale space of every smoothing count, against a pipeline that does what the paper says with Eigen's sparse and
// dense matrices, and against an isolated loop. Both find the same minima, which is checked.

#include "Naive_scale_space.h"
#include "animations.h"
#include "benchmark_support.h"
#include "isolated_loops.h"

#include <CGAL/Animated_mesh_features/Deformation/curvature.h>
#include <CGAL/Animated_mesh_features/Deformation/deformation.h>
#include <CGAL/Animated_mesh_features/Deformation/strain.h>
#include <CGAL/Animated_mesh_features/Extrema/find_response_extrema.h>
#include <CGAL/detect_spatio_temporal_features.h>

#ifdef _OPENMP
  #include <omp.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace Benchmark;

namespace {

struct Counts
{
  std::size_t box_width, space, time; // w, K, L
};

// A minimum of either side: where it is, and how strong.
struct Minimum
{
  std::size_t vertex, frame;
  double k, l; // refined or not
  double strength;
};

typedef std::map<std::string, double> Values;

Amf::Published_options options_for(const Counts& c)
{
  Amf::Published_options options = Amf::published_options(c.box_width);
  options.sampling.max_space_count = c.space;
  options.sampling.max_time_count = c.time;
  return options;
}

template <class FT>
Amf::Spatio_temporal_field<FT> converted(const Amf::Spatio_temporal_field<double>& field)
{
  Amf::Spatio_temporal_field<FT> result(field.number_of_rows(), field.number_of_frames());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f) result(v, f) = FT(field(v, f));
  return result;
}

template <class FT>
std::vector<Minimum> detect(const Amf::Frame_sequence<Mesh, FT>& sequence,
                            const Amf::Spatio_temporal_field<double>& field, const Counts& counts, double& seconds)
{
  const Amf::Spatio_temporal_field<FT> values = converted<FT>(field);
  const Amf::Published_options::Search options = options_for(counts);
  Amf::Response_extrema found;
  seconds = seconds_of([&] {
    found = Amf::find_response_extrema(sequence.rest_shape(), values, sequence.frame_duration(), options);
  });
  // A level is as many averages, and a scale is the square root of a variance.
  const auto level = [](const std::vector<double>& scales, double scale) {
    return scale * scale / (scales[1] * scales[1]);
  };
  std::vector<Minimum> minima;
  for (const Amf::Response_extremum& e : found.extrema)
    minima.push_back({e.vertex, e.frame, level(found.sigma_levels, e.sigma), level(found.tau_levels, e.tau), -e.response});
  return minima;
}

// The paper's weights, from the public policies as the detector puts them together.
Amf::Forward_difference_of_gaussians weights(const Amf::Rest_shape& shape, std::size_t frames, double duration,
                                             const Counts& counts)
{
  Amf::Published_options o = options_for(counts);
  const Amf::Scale_levels levels = o.sampling(shape, frames, duration, o.spatial_filter, o.temporal_filter);
  o.spatial_filter.initialize(shape, levels.space_variances, Policy_loop());
  o.temporal_filter.initialize(frames, duration, levels.time_variances);
  std::vector<double> sigma, tau;
  for (std::size_t k = 0; k < levels.space_variances.size(); ++k)
    sigma.push_back(levels.sigma_factor * std::sqrt(o.spatial_filter.variance(k)));
  for (std::size_t l = 0; l < levels.time_variances.size(); ++l)
    tau.push_back(levels.tau_factor * std::sqrt(o.temporal_filter.variance(l)));
  o.response.initialize(sigma, tau, levels);
  return o.response;
}

typedef Naive_scale_space<Amf::Forward_difference_of_gaussians> Naive;

std::vector<Minimum> converted(const std::vector<Naive::Minimum>& minima)
{
  std::vector<Minimum> result;
  for (const Naive::Minimum& m : minima) result.push_back({m.vertex, m.frame, double(m.k), double(m.l), -m.response});
  return result;
}

struct Agreement
{
  std::size_t strong = 0, again = 0;
  double strongest_missing = 0; // over the strongest of all
};

// The minima of `some` that are stronger than a millionth of the strongest, and how many of them are among `others`: at
// the same vertex and frame and within 3/4 of a level. (Refinement moves a minimum by at most half a level, and two
// minima at a vertex and frame are two levels apart, or one would be the other's neighbour.)
Agreement agreement(const std::vector<Minimum>& some, const std::vector<Minimum>& others)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<const Minimum*>> at;
  for (const Minimum& m : others) at[{m.vertex, m.frame}].push_back(&m);
  double strongest = 0;
  for (const Minimum& m : some) strongest = (std::max)(strongest, m.strength);
  Agreement result;
  for (const Minimum& m : some) {
    if (!(m.strength > 1e-6 * strongest)) continue;
    ++result.strong;
    const auto& here = at[{m.vertex, m.frame}];
    if (std::any_of(here.begin(), here.end(),
                    [&](const Minimum* o) { return std::abs(o->k - m.k) < 0.75 && std::abs(o->l - m.l) < 0.75; }))
      ++result.again;
    else
      result.strongest_missing = (std::max)(result.strongest_missing, m.strength / strongest);
  }
  return result;
}

void set_openmp_threads(std::size_t n)
{
#ifdef _OPENMP
  omp_set_num_threads(int(n));
  Eigen::setNbThreads(int(n));
#else
  (void)n;
#endif
}

class Engine_benchmark
{
public:
  Engine_benchmark(const Arguments& arguments, const Workload& workload, const Counts& counts)
    : m_arguments(arguments)
    , m_counts(counts)
    , m_double(workload.sequence<double>())
    , m_float(workload.sequence<float>())
  {
    const Amf::Compressed_rows balls = Amf::geodesic_balls<CGAL::Sequential_tag>(m_double->rest_shape());
    m_field = Amf::deformation(
        Amf::strain<CGAL::Sequential_tag>(*m_double, Amf::Largest_eigenvalue_strain(), Amf::Triangle_weights::UNIFORM),
        Amf::curvature_change<CGAL::Sequential_tag>(*m_double, balls, Amf::Mean_dihedral_angle()),
        Amf::default_curvature_weight);
    m_samples = double(m_field.number_of_rows()) * double(m_field.number_of_frames()) * double(counts.space) *
                double(counts.time);
  }

  void run(const std::string& name, Report& report) const
  {
    const std::size_t n = m_field.number_of_rows(), f = m_field.number_of_frames();
    Table table(
        "Scale space of every smoothing count: " + name,
        "N = " + std::to_string(n) + " vertices, F = " + std::to_string(f) +
            " frames, K = " + std::to_string(m_counts.space) + ", L = " + std::to_string(m_counts.time) + ", box of " +
            std::to_string(m_counts.box_width) +
            " frames; a sample is a vertex, frame, k and l. The naive pipeline makes level (k, l) from (k-1, l) by a "
            "product with a sparse matrix, as the paper describes it, or from (k, l-1) by running means. Memory: the "
            "peak over the input and what the program had before; arrays: counted. Share of the loop: the rate over "
            "that of as many cores that run the isolated loop in their L1 caches.",
        {"pipeline", "threads", "s", "1e9 samples/s", "naive / this", "memory MB", "arrays MB", "share of the loop"});
    Table same(
        "The same minima: " + name,
        "Those of the naive pipeline, in double precision, that are stronger than 1e-6 of the strongest; of them, "
        "those that are more than what rounding the field to single precision can make at their level, which the "
        "detector leaves out; of these, what it finds without thresholds and suppression. Those that only the "
        "detector has. The strongest that is missing, over the strongest of all.",
        {"detector", "naive minima", "above rounding", "found", "only the detector", "strongest missing"});
    const double loop = loop_rate();
    for (std::size_t threads : thread_counts()) {
      const bool is_last = threads == thread_counts().back();
      const Values naive = naive_values(Naive::SPACE_FIRST, threads, is_last);
      const auto add = [&](const std::string& pipeline, const Values& v) {
        const double rate = m_samples / v.at("seconds");
        table.add(pipeline, threads, v.at("seconds"), 1e-9 * rate, naive.at("seconds") / v.at("seconds"),
                  1e-6 * v.at("memory"), v.count("arrays") ? Cell(1e-6 * v.at("arrays")) : Cell(),
                  rate / (loop * double(threads)));
      };
      add("naive, (k, l) from (k-1, l)", naive);
      add("naive, (k, l) from (k, l-1)", naive_values(Naive::TIME_FIRST, threads, false));
      add("find_response_extrema, double", detector_values(*m_double, threads));
      add("find_response_extrema, float", detector_values(*m_float, threads));
      if (!is_last) continue;
      for (const std::string scalar : {"double", "float"})
        same.add(scalar, std::size_t(naive.at("minima")), std::size_t(naive.at(scalar + "_expected")),
                 std::size_t(naive.at(scalar + "_found")), std::size_t(naive.at(scalar + "_others")),
                 naive.at(scalar + "_missing"));
    }
    report.add(table);
    report.add(same);
  }

private:
  double loop_rate() const
  {
    Scale_space_loop loop(m_counts.box_width, m_arguments.quick ? 2000 : 20000);
    return loop.samples() / least_seconds([&] { run_widest(loop); }, Repetitions{5, 50, 1});
  }

  Naive naive(const Amf::Forward_difference_of_gaussians& response, Naive::Order order) const
  {
    return Naive(m_double->rest_shape(), m_field.number_of_frames(), m_counts.box_width, m_counts.space, m_counts.time,
                 response, order);
  }

  Amf::Forward_difference_of_gaussians response() const
  {
    return weights(m_double->rest_shape(), m_field.number_of_frames(), m_double->frame_duration(), m_counts);
  }

  // The naive pipeline takes seconds to minutes, so that it runs once.
  Values naive_values(Naive::Order order, std::size_t threads, bool compares) const
  {
    return in_child_process([&] {
      set_openmp_threads(threads);
      const Amf::Forward_difference_of_gaussians r =
          weights(m_double->rest_shape(), m_field.number_of_frames(), m_double->frame_duration(), m_counts);
      const Peak_memory memory;
      const Naive pipeline(m_double->rest_shape(), m_field.number_of_frames(), m_counts.box_width, m_counts.space,
                           m_counts.time, r, order);
      std::vector<Naive::Minimum> minima;
      Values v;
      v["seconds"] = seconds_of([&] { minima = pipeline(m_field); });
      v["memory"] = memory.bytes();
      v["arrays"] = pipeline.memory();
      if (compares) {
        v["minima"] = double(agreement(converted(minima), {}).strong);
        std::vector<Naive::Minimum> certain;
        const double rounding = std::ldexp(1., -30) * largest_value();
        std::copy_if(minima.begin(), minima.end(), std::back_inserter(certain), [&](const Naive::Minimum& m) {
          return -m.response > rounding * (r.space_weight(m.k, m.l) + r.time_weight(m.k, m.l));
        });
        compare(converted(minima), converted(certain), *m_double, "double", v);
        compare(converted(minima), converted(certain), *m_float, "float", v);
      }
      return v;
    });
  }

  double largest_value() const
  {
    double largest = 0;
    for (std::size_t v = 0; v < m_field.number_of_rows(); ++v)
      for (std::size_t f = 0; f < m_field.number_of_frames(); ++f)
        largest = (std::max)(largest, std::abs(m_field(v, f)));
    return largest;
  }

  template <class FT>
  void compare(const std::vector<Minimum>& naive, const std::vector<Minimum>& certain,
               const Amf::Frame_sequence<Mesh, FT>& sequence, const std::string& scalar, Values& v) const
  {
    double seconds;
    const std::vector<Minimum> minima = detect(sequence, m_field, m_counts, seconds);
    const Agreement found = agreement(certain, minima), back = agreement(minima, naive);
    v[scalar + "_expected"] = double(found.strong);
    v[scalar + "_found"] = double(found.again);
    v[scalar + "_missing"] = found.strongest_missing;
    v[scalar + "_others"] = double(back.strong - back.again);
  }

  template <class FT>
  Values detector_values(const Amf::Frame_sequence<Mesh, FT>& sequence, std::size_t threads) const
  {
    return in_child_process([&] {
      const Thread_limit limit(threads);
      const Peak_memory memory;
      Values result;
      detect(sequence, m_field, m_counts, result["seconds"]);
      result["memory"] = memory.bytes();
      for (int i = 1; i < (m_arguments.quick ? 1 : 5) && result["seconds"] < 20; ++i) {
        double seconds;
        detect(sequence, m_field, m_counts, seconds);
        result["seconds"] = (std::min)(result["seconds"], seconds);
      }
      return result;
    });
  }

  Arguments m_arguments;
  Counts m_counts;
  std::unique_ptr<Amf::Frame_sequence<Mesh, double>> m_double;
  std::unique_ptr<Amf::Frame_sequence<Mesh, float>> m_float;
  Amf::Spatio_temporal_field<double> m_field;
  double m_samples;
};

void print_loop(const Arguments& arguments, Report& report)
{
  Table table(
      "Isolated loop of the scale space",
      "Two box averages, their weighted sum, comparison with 8 scales and 2 frames, in the L1 cache of one core; "
      "registers of " +
          std::to_string(8 * register_bytes()) + " bits.",
      {"box width", "1e9 samples/s"});
  for (std::size_t width : {5, 8, 10, 20}) {
    Scale_space_loop loop(width, arguments.quick ? 2000 : 20000);
    table.add(width, 1e-9 * loop.samples() / least_seconds([&] { run_widest(loop); }, Repetitions{5, 50, 1}));
  }
  report.add(table);
}

} // namespace

int main(int argc, char* argv[])
{
  return run("engine", argc, argv, [](const Arguments& arguments, Report& report) {
    limit_before_child_processes() = std::make_unique<Thread_limit>(1);
    set_openmp_threads(1);
    print_loop(arguments, report);
    const Counts p = {10, 72, 150}, h = {8, 77, 54}, small = {8, 12, 16};
    const Workload woman = figure(arguments.quick ? 1200 : 4250, arguments.quick ? 40 : 100);
    Engine_benchmark(arguments, woman, arguments.quick ? small : p)
        .run("workload P, of the size of the paper's woman (" + woman.name + ")", report);
    const Workload gallop = horse(arguments);
    Engine_benchmark(arguments, gallop, arguments.quick ? small : h)
        .run("workload H, of the size of the paper's horse (" + gallop.name + ")", report);
  });
}
