// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Detections: small meshes, motions and options made of the bytes.

#include "fuzz_support.h"

#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <fuzzer/FuzzedDataProvider.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Amf::Frame_sequence<Mesh> Sequence;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;
using fuzz::require;

namespace {

struct Animation
{
  Amf::IO::Indexed_mesh mesh;
  std::vector<std::vector<std::array<double, 3>>> frames;
  double frame_duration;
};

// A grid of up to 6 x 6 vertices, open, a tube or a torus; without some of its triangles, so that there are holes, loose
// parts, vertices in no triangle; sometimes with one that fits nowhere.
Amf::IO::Indexed_mesh make_mesh(FuzzedDataProvider& bytes)
{
  const std::size_t n = bytes.ConsumeIntegralInRange<std::size_t>(2, 6);
  const std::size_t m = bytes.ConsumeIntegralInRange<std::size_t>(2, 6);
  const bool tube = n > 2 && bytes.ConsumeBool(), torus = tube && m > 2 && bytes.ConsumeBool();
  const std::uint32_t holes = bytes.ConsumeIntegral<std::uint32_t>();
  Amf::IO::Indexed_mesh mesh;
  const double turn = 2 * 3.14159265358979323846 / double(n);
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i)
      mesh.points.push_back(tube ? std::array<double, 3>{{std::cos(turn * double(i)), std::sin(turn * double(i)), double(j)}}
                                 : std::array<double, 3>{{double(i), double(j), 0}});
  std::size_t triangle = 0;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if ((holes >> (triangle++ % 32) & 1) == 0) mesh.triangles.push_back({{a, b, c}});
  };
  for (std::size_t j = 0; j < (torus ? m : m - 1); ++j)
    for (std::size_t i = 0; i < (tube ? n : n - 1); ++i) {
      const std::size_t right = (i + 1) % n, up = (j + 1) % m;
      add(j * n + i, j * n + right, up * n + right);
      add(j * n + i, up * n + right, up * n + i);
    }
  if (bytes.ConsumeIntegralInRange(0, 15) == 15)
    mesh.triangles.push_back({{0, n * m - 1, bytes.ConsumeIntegralInRange<std::size_t>(0, n * m - 1)}});
  return mesh;
}

// Each vertex is displaced by bytes in each frame, all of it is scaled, and a coordinate may be anything.
Animation make_animation(FuzzedDataProvider& bytes)
{
  Animation a = {make_mesh(bytes), {}, 1. / 32};
  const std::size_t frames = bytes.ConsumeIntegralInRange<std::size_t>(2, 12);
  const int exponent = bytes.ConsumeBool() ? 0 : bytes.ConsumeIntegralInRange(-40, 40);
  a.frame_duration = std::ldexp(a.frame_duration, bytes.ConsumeBool() ? 0 : bytes.ConsumeIntegralInRange(-30, 30));
  const std::size_t odd_frame = bytes.ConsumeIntegral<std::uint8_t>(), odd_vertex = bytes.ConsumeIntegral<std::uint8_t>();
  for (std::size_t f = 0; f < frames; ++f) {
    a.frames.push_back(a.mesh.points);
    for (auto& point : a.frames.back())
      for (double& x : point) x = std::ldexp(x + double(bytes.ConsumeIntegral<std::int8_t>()) / 64, exponent);
    if (f == odd_frame && odd_vertex < a.mesh.points.size())
      for (double& x : a.frames.back()[odd_vertex]) x = bytes.ConsumeFloatingPoint<double>();
  }
  return a;
}

// A number that makes sense; sometimes one that does not.
double number(FuzzedDataProvider& bytes, double usual, double least, double largest)
{
  const double odd[] = {0, -1, 1e-300, 1e300, std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  const std::uint8_t choice = bytes.ConsumeIntegral<std::uint8_t>();
  if (choice < 96) return usual;
  if (choice < 240) return least + (largest - least) * double(bytes.ConsumeIntegral<std::uint8_t>()) / 255;
  return odd[choice % 6];
}

template <class Options>
void choose_numbers(FuzzedDataProvider& bytes, Options& options)
{
  options.ball_radius = number(bytes, 0, 0, 4);
  options.alpha = number(bytes, options.alpha, 0, 2);
  options.triangle_weights = bytes.ConsumeBool() ? Amf::Triangle_weights::UNIFORM : Amf::Triangle_weights::REST_AREA;
  options.selection.relative_threshold = number(bytes, 0, 0, 1);
  options.selection.absolute_threshold = number(bytes, 0, 0, 1);
  options.selection.suppress_non_maxima = bytes.ConsumeBool();
  options.selection.accept_border_vertices = bytes.ConsumeBool();
}

// Cancels after a number of calls: options can ask for work without end.
struct Patience
{
  std::size_t calls_left;
  void begin(Amf::Stage) {}
  bool progress(Amf::Stage, double) { return calls_left-- > 0; }
  void end(Amf::Stage) {}
};

template <class Options>
std::optional<std::vector<Feature>> detect(const Animation& a, const Options& options, Patience patience = {1000000})
{
  try {
    const Mesh mesh = Amf::IO::to_surface_mesh<Point>(a.mesh, "mesh");
    std::vector<std::vector<Point>> frames;
    for (const auto& frame : a.frames) {
      frames.emplace_back();
      for (const auto& p : frame) frames.back().emplace_back(p[0], p[1], p[2]);
    }
    const Sequence sequence(mesh, frames, a.frame_duration);
    std::vector<Feature> features;
    CGAL::detect_spatio_temporal_features(sequence, std::back_inserter(features), options, patience);
    return features;
  } catch (const Amf::Error&) {
    return std::nullopt;
  }
}

void check(const Animation& a, const std::vector<Feature>& features)
{
  const std::size_t vertices = a.mesh.points.size(), frames = a.frames.size();
  const auto finite = [](const std::array<double, 3>& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  double last = std::numeric_limits<double>::infinity();
  for (const Feature& f : features) {
    require(f.vertex_index < vertices && f.vertex.idx() == f.vertex_index, "the vertex is one of the mesh");
    require(f.frame < frames && f.refined_frame >= 0 && f.refined_frame <= double(frames - 1), "the frame is one of them");
    require(std::abs(f.refined_frame - double(f.frame)) <= 0.5 + 1e-9, "the time is within half a frame");
    require(std::isfinite(f.time) && finite(f.position) && finite(f.rest_position), "places are finite");
    require(std::isfinite(f.sigma) && f.sigma > 0 && std::isfinite(f.tau) && f.tau > 0, "scales are positive");
    require(std::isfinite(f.response) && f.response < 0, "the response is negative");
    require(f.strength <= last, "the strongest come first");
    last = f.strength;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      require(f.triangle[k] < vertices && f.barycentric_coordinates[k] >= 0, "the place is in a triangle");
      sum += f.barycentric_coordinates[k];
    }
    require(std::abs(sum - 1) < 1e-9, "barycentric coordinates sum up to 1");
  }
}

// Equal bit for bit.
bool same(const std::vector<Feature>& a, const std::vector<Feature>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Feature& f, const Feature& g) {
    return f.vertex_index == g.vertex_index && f.frame == g.frame && f.time == g.time && f.sigma == g.sigma &&
           f.tau == g.tau && f.response == g.response && f.position == g.position &&
           f.rest_position == g.rest_position && f.triangle == g.triangle &&
           f.barycentric_coordinates == g.barycentric_coordinates && f.at_scale_limit == g.at_scale_limit;
  });
}

// In one thread, which takes less time to compile than the sequential detection would, once more, beside the parallel one.
template <class Options>
std::optional<std::vector<Feature>>
detect_in_one_thread(const Animation& a, const Options& options, Patience patience = {1000000})
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
#endif
  return detect(a, options, patience);
}

template <class Options>
void run(const Animation& a, const Options& options)
{
  const auto features = detect_in_one_thread(a, options, Patience{5000});
  if (!features) return;
  check(a, *features);
  const auto parallel = detect(a, options);
  require(parallel && same(*features, *parallel), "the number of threads changes nothing");
  Options little_memory = options;
  little_memory.level_memory = 1;
  const auto in_batches = detect_in_one_thread(a, little_memory);
  require(in_batches && same(*features, *in_batches), "the memory for levels changes nothing");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  if (bytes.ConsumeBool()) {
    Amf::Calibrated_options options;
    choose_numbers(bytes, options);
    options.sampling.sigma_ratio = number(bytes, options.sampling.sigma_ratio, 1.1, 3);
    options.sampling.tau_ratio = number(bytes, options.sampling.tau_ratio, 1.1, 3);
    options.sampling.sigma = {number(bytes, 0, 0.1, 2), number(bytes, 0, 0.5, 8)};
    options.sampling.tau = {number(bytes, 0, 0.01, 0.1), number(bytes, 0, 0.05, 1)};
    run(make_animation(bytes), options);
  } else {
    Amf::Published_options options = Amf::published_options(bytes.ConsumeIntegralInRange<std::size_t>(0, 12));
    choose_numbers(bytes, options);
    options.sampling.max_space_count = bytes.ConsumeIntegralInRange<std::size_t>(0, 20);
    options.sampling.max_time_count = bytes.ConsumeIntegralInRange<std::size_t>(0, 20);
    run(make_animation(bytes), options);
  }
  return 0;
}
