// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where animations are looked at from: how much of the features the chosen views show, beside what others choose; whether
// the choice stays the same on other meshes of the same motion; what a depth map costs, and rays.

#include "animations.h"
#include "benchmark_support.h"
#include "best_triple.h"

#include <CGAL/Animated_mesh_features/Applications/Area_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/Entropy_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/camera_path.h>
#include <CGAL/Animated_mesh_features/Applications/select_views.h>
#include <CGAL/detect_spatio_temporal_features.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

using namespace Benchmark;

namespace {

namespace fs = std::filesystem;
typedef Amf::Frame_sequence<Mesh, double> Sequence;
typedef Amf::Spatio_temporal_feature<Mesh::Vertex_index> Feature;

Workload workload(const fs::path& mesh, const fs::path& cache, const fs::path& rest)
{
  const Amf::IO::Animation_file_data<double> data = Amf::IO::read_animation<double>({mesh.string(), cache.string()});
  Workload w;
  w.name = cache.stem().string();
  w.animation.mesh = Amf::IO::to_surface_mesh(data.mesh, data.sources.front());
  w.animation.frame_duration = 1. / 30;
  for (std::size_t f = 0; f < data.frames; ++f) {
    w.animation.frames.emplace_back();
    for (std::size_t v = 0; v < data.mesh.points.size(); ++v)
      w.animation.frames.back().emplace_back(data.x(v, f), data.y(v, f), data.z(v, f));
  }
  for (const auto& p : Amf::IO::read_mesh(rest.string()).points) w.rest.emplace_back(p[0], p[1], p[2]);
  return w;
}

// A workload of the folder, if it is there; otherwise without frames.
Workload named(const Arguments& a, const std::string& name, const std::string& rest)
{
  const fs::path mesh = fs::path(a.data) / (name + ".obj"), rest_mesh = fs::path(a.data) / (rest + ".obj");
  if (a.data.empty() || !fs::exists(mesh) || !fs::exists(rest_mesh)) return Workload();
  Workload w = workload(mesh, fs::path(mesh).replace_extension(".pc2"), rest_mesh);
  if (name == "horse-gallop-half") w.animation.frame_duration *= 2;
  if (name == "horse-gallop-double") w.animation.frame_duration /= 2;
  return w;
}

std::vector<Feature> features_of(const Sequence& sequence)
{
  std::vector<Feature> features;
  CGAL::detect_spatio_temporal_features(sequence, std::back_inserter(features));
  return features;
}

double percent(double x)
{
  return std::round(1000 * x) / 10;
}

double degrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::round(Amf::View_sphere::angle(a, b) * 1800 / double(EIGEN_PI)) / 10;
}

// -------------------------------------------------------------------------------------------------------- what is shown

void add_shown(const Workload& w, Table& shown, Table& plain_table, Table& triples, Table& paths)
{
  const auto sequence = w.sequence<double>();
  const std::vector<Feature> features = features_of(*sequence);
  const std::size_t n = sequence->number_of_frames();
  const double step = sequence->frame_duration();
  Amf::View_selection chosen = Amf::select_views(*sequence, features);
  double seconds = 0;
  for (int i = 0; i < 2; ++i) {
    const double s = seconds_of([&] { chosen = Amf::select_views(*sequence, features); });
    seconds = i == 0 ? s : (std::min)(s, seconds);
  }
  const Amf::View_options options;
  const std::vector<std::size_t> frames = chosen.scores.frames();
  const auto by_entropy = Amf::select_views(*sequence, frames, Amf::Entropy_view_score(frames.size()), options);
  const auto by_area = Amf::select_views(*sequence, frames, Amf::Area_view_score(frames.size()), options);
  const double front = chosen.up[2] > 0.5 ? -90 : 0;
  const std::vector<Eigen::Vector3d> compared = {chosen.views[0].direction, by_entropy.views[0].direction,
                                                 by_area.views[0].direction,
                                                 Amf::view_direction({front, 0}, chosen.up)};
  const auto is_upright = [&](const Eigen::Vector3d& d) {
    return std::abs(Amf::view_angles(d, chosen.up).elevation) <= options.highest_elevation;
  };
  const auto add = [&](const Amf::Feature_view_score& score, std::size_t subdivisions, Table& table) {
    std::vector<Eigen::Vector3d> directions;
    for (const auto& d : Amf::View_sphere(subdivisions).directions())
      if (is_upright(d)) directions.push_back(d);
    const Amf::View_scores all = Amf::score_views(*sequence, frames, directions, score);
    const Amf::View_scores some = Amf::score_views(*sequence, frames, compared, score);
    std::vector<double> sorted;
    for (std::size_t d = 0; d < directions.size(); ++d) sorted.push_back(all.score(d));
    std::sort(sorted.begin(), sorted.end());
    const double median = sorted[sorted.size() / 2];
    std::vector<Eigen::Vector3d> three;
    for (const auto& v : chosen.views) three.push_back(v.direction);
    const double covered = Amf::score_views(*sequence, frames, three, score).covered({0, 1, 2});
    table.add(w.name, features.size(), percent(some.score(0)), percent(sorted.back()), percent(median),
              percent(sorted.front()), some.score(0) / median, percent(covered), percent(some.score(1)),
              percent(some.score(2)), percent(some.score(3)), seconds);
  };
  const Amf::Rest_shape& shape = sequence->rest_shape();
  add(Amf::Feature_view_score(shape, frames, n, step, features), 4, shown);
  add(Amf::Feature_view_score(shape, frames, n, step, features, 0), 3, plain_table);

  // what three views could show
  for (const double full_cosine : {0.5, 0.}) {
    const Amf::View_scores some =
        Amf::score_views(*sequence, frames, chosen.scores.directions(),
                         Amf::Feature_view_score(shape, frames, n, step, features, full_cosine));
    const std::vector<Amf::Covering_view> views = Amf::covering_views(some, 3);
    const double covered = views.back().covered, all = some.covered_by_all();
    double of_frames = 0; // from where each frame shows most
    for (std::size_t k = 0; k < frames.size(); ++k) {
      double most = 0;
      for (std::size_t d = 0; d < some.directions().size(); ++d) most = (std::max)(most, some.score(d, k));
      of_frames += most;
    }
    triples.add(w.name, full_cosine, percent(some.score(views.front().rank)), percent(of_frames), percent(covered),
                percent(best_triple(some, covered)), percent(all), percent(covered / all));
  }

  // the choice, in all frames
  const std::vector<std::size_t> every = Amf::even_frames(n, n);
  const Amf::Feature_view_score full(shape, every, n, step, features);
  const double in_all = Amf::score_views(*sequence, every, {compared[0]}, full).score(0);
  const Amf::View_sphere sphere(2);
  std::vector<Eigen::Vector3d> directions;
  for (const auto& d : sphere.directions())
    if (is_upright(d)) directions.push_back(d);
  const std::vector<std::size_t> even = Amf::even_frames(n, 32);
  const Amf::View_scores course =
      Amf::score_views(*sequence, even, directions, Amf::Feature_view_score(shape, even, n, step, features));
  const double still = course.score(course.best([](const Eigen::Vector3d&) { return true; }));
  Amf::Camera_path_options path;
  path.is_cyclic = w.name.find("gallop") != std::string::npos;
  double seconds_of_path = 0;
  const auto moving = [&](double speed) {
    path.largest_speed = speed;
    double score = 0;
    seconds_of_path =
        seconds_of([&] { score = Amf::camera_path(course, sphere.longest_edge(), n, step, path).score(); });
    return percent(score);
  };
  paths.add(w.name, percent(chosen.views[0].score), percent(in_all), percent(still), moving(30), moving(45), moving(90),
            moving(180), seconds_of_path);
}

// ------------------------------------------------------------------------------------------------------------ visibility

// What is hidden, by rays: as many items as a Feature_view_score of all vertices would have.
void add_visibility(const Workload& w, Table& table)
{
  typedef Animation::Kernel Kernel;
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
  const auto sequence = w.sequence<double>();
  const Amf::Rest_shape& shape = sequence->rest_shape();
  const std::size_t frame = sequence->number_of_frames() / 3;
  const std::vector<Eigen::Vector3d> directions = Amf::View_sphere(1).directions();

  // a score that only asks, and keeps what it is told
  struct Every_vertex
  {
    std::size_t n;
    std::vector<std::vector<float>>* kept;
    const std::vector<Eigen::Vector3d>* directions;
    std::size_t number_of_frames() const { return 1; }
    std::size_t first_item(std::size_t k) const { return k * n; }
    double weight(std::size_t) const { return 1; }
    void operator()(const Amf::Surface_view& view, float* seen) const
    {
      const std::size_t d =
          std::size_t(std::find(directions->begin(), directions->end(), view.direction()) - directions->begin());
      for (std::size_t v = 0; v < n; ++v) (*kept)[d].push_back(seen[v] = float(view.visibility(v)));
    }
  };

  const Thread_limit limit(1);
  Mesh mesh = w.animation.mesh;
  for (const auto v : vertices(mesh)) mesh.point(v) = w.animation.frames[frame][v];
  std::vector<Eigen::Vector3d> points = sequence->trajectories().frame(frame).points();
  std::vector<Eigen::Vector3d> normals(points.size(), Eigen::Vector3d::Zero());
  for (const auto& t : shape.triangles())
    for (std::size_t v : t) normals[v] += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
  std::vector<std::vector<char>> free(directions.size());
  double cosines = 0;
  const double by_rays = seconds_of([&] {
    Tree tree(faces(mesh).first, faces(mesh).second, mesh);
    tree.build();
    for (std::size_t d = 0; d < directions.size(); ++d)
      for (std::size_t v = 0; v < points.size(); ++v) {
        const double cosine = normals[v].dot(directions[d]);
        const Eigen::Vector3d p = points[v] + (cosine < 0 ? -1 : 1) * 1e-5 * shape.diameter() * normals[v].normalized();
        const Eigen::Vector3d& r = directions[d];
        free[d].push_back(
            !tree.do_intersect(Kernel::Ray_3(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(r[0], r[1], r[2]))));
      }
  });
  for (std::size_t size : {128u, 256u, 512u}) {
    std::vector<std::vector<float>> kept(directions.size());
    const Every_vertex score{points.size(), &kept, &directions};
    const double by_map =
        seconds_of([&] { Amf::score_views(*sequence, {frame}, directions, score, Amf::Any_visitor(), size); });
    double wrong = 0, sum = 0;
    for (std::size_t d = 0; d < directions.size(); ++d)
      for (std::size_t v = 0; v < points.size(); ++v) {
        if (shape.is_isolated(v)) continue;
        const double weight = (std::min)(1., 2 * std::abs(normals[v].normalized().dot(directions[d])));
        wrong += weight * std::abs(double(kept[d][v]) - double(free[d][v]));
        sum += weight;
      }
    cosines = sum;
    const double views = double(directions.size());
    table.add(w.name, points.size(), size, 1e3 * by_map / views, 1e3 * by_rays / views, by_rays / by_map,
              percent(wrong / cosines));
  }
}

// ------------------------------------------------------------------------------------------------------------- stability

void add_twins(const Arguments& a, Table& table)
{
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();
  const std::vector<std::vector<std::string>> twins = {{"horse-gallop", "horse-rest"},
                                                       {"horse-gallop-half", "horse-rest"},
                                                       {"horse-gallop-double", "horse-rest"},
                                                       {"horse-gallop-dec4200", "horse-rest-dec4200"},
                                                       {"horse-gallop-irregular", "horse-rest-irregular"},
                                                       {"horse-gallop-subdiv", "horse-rest-subdiv"}};
  for (const auto& names : twins) {
    const Workload w = named(a, names[0], names[1]);
    if (w.animation.frames.empty()) continue;
    const auto sequence = w.sequence<double>();
    const std::vector<Feature> features = features_of(*sequence);
    const Amf::View_selection s = Amf::select_views(*sequence, features);
    if (reference.isZero()) reference = s.views[0].direction;
    Eigen::Vector3d mirrored = reference; // the horse is, nearly
    mirrored[0] *= -1;
    table.add(w.name, sequence->number_of_vertices(), sequence->number_of_frames(), features.size(),
              s.views[0].angles.azimuth, s.views[0].angles.elevation, percent(s.views[0].score),
              degrees(reference, s.views[0].direction), degrees(mirrored, s.views[0].direction));
  }
}

} // namespace

int main(int argc, char* argv[])
{
  return run("viewpoints", argc, argv, [](const Arguments& a, Report& report) {
    const std::vector<std::string> columns = {"animation", "features",    "chosen",  "best", "median", "worst",
                                              "x median",  "three views", "entropy", "area", "front",  "seconds"};
    Table shown("What views show of the features",
                "Per cent of the amplitude, of regions turned away by up to 60 degrees as a whole. Chosen: by "
                "select_views(), of 162 directions and refinement, in so many seconds on all threads; best, median and "
                "worst of 2,562 directions; three views: chosen ones together; and what the best view by entropy, by "
                "area and that from the front show.",
                columns);
    Table plain("What views show of the features, however much it is turned away",
                "The same, of what is not hidden; best, median and worst of 642 directions.", columns);
    Table triples(
        "Three views together",
        "Per cent of the amplitude that the best view shows, that in each frame another one, the best there, would "
        "show, the "
        "three of covering_views(), the best three of all triples of the directions that were scored, and all of these "
        "directions, which nothing exceeds; and the part of that which the three show. Regions seen as a whole from a "
        "cosine of 0.5, and of 0, that is wherever they are not hidden.",
        {"animation", "cosine", "one", "one a frame", "three", "best three", "all directions", "three of all"});
    Table paths(
        "Cameras that move",
        "Per cent of the amplitude: the chosen view, in its frames and in all; a still camera of 162 directions, "
        "and one that may turn by 30 to 180 degrees a second, in 32 frames; the seconds of the last path.",
        {"animation", "chosen", "all frames", "still", "30/s", "45/s", "90/s", "180/s", "seconds"});
    Table visibility(
        "What is hidden",
        "Milliseconds of a thread for the visibility of all vertices in a direction: by a depth map, of 42 "
        "directions in opposite pairs, and by rays through an AABB tree. Wrong: per cent of the vertices, "
        "weighted by what they count in a view.",
        {"animation", "vertices", "texels", "map: ms", "rays: ms", "ratio", "wrong"});
    Table twins(
        "The same motion on other meshes",
        "The best view, and degrees from that of the first mesh, and from its mirror image.",
        {"animation", "vertices", "frames", "features", "azimuth", "elevation", "shown", "degrees", "mirrored"});

    std::vector<Workload> workloads;
    for (const auto& names : std::vector<std::vector<std::string>>{
             {"horse-gallop", "horse-rest"}, {"camel-gallop-manifold", "camel-rest-manifold"}, {"pcow", "pcow"}}) {
      Workload w = named(a, names[0], names[1]);
      if (!w.animation.frames.empty()) workloads.push_back(std::move(w));
    }
    // bodies: BODY__MOTION.pc2, with the mesh at rest in BODY.obj
    std::vector<fs::path> files;
    if (!a.data.empty())
      for (const auto& file : fs::directory_iterator(a.data)) files.push_back(file.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& cache : files) {
      const std::string name = cache.stem().string();
      const fs::path mesh = cache.parent_path() / (name.substr(0, name.find("__")) + ".obj");
      if (cache.extension() == ".pc2" && name.find("__") != std::string::npos && fs::exists(mesh))
        workloads.push_back(workload(mesh, cache, mesh));
    }
    if (!a.hand.empty()) {
      workloads.push_back(workload(a.hand, fs::path(a.hand).replace_extension(".pc2"), a.hand));
      workloads.back().name = "hand";
    }
    if (workloads.empty() || has_horse(a)) workloads.push_back(figure(a.quick ? 1500 : 9000, 48));
    for (const Workload& w : workloads) {
      add_shown(w, shown, plain, triples, paths);
      shown.print(std::cerr); // it takes long
    }
    add_visibility(workloads.front(), visibility);
    add_twins(a, twins);
    for (const Table* t : {&shown, &plain, &triples, &paths, &visibility, &twins}) report.add(*t);
  });
}
