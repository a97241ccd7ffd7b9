// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// simplification MESH.obj CACHE.pc2 [--rest REST.obj] [--features FEATURES.json] [--shares 0.5,0.1,0.03] [--step N]
//   [--only NAME,...] [--line W] [--cosine C] [--support K] [--refinements R] [--guidance 4,16] [--write FOLDER]
//
// Simplifies an animation by several methods and prints how far each is from the original: CGAL's Garland-Heckbert and
// meshoptimizer on the rest shape, quadrics of a random pose, of all frames, of chosen poses, with guidance by
// features. Means over frames and the worst frame, in % of the diagonal; the most triangles in any frame that look away from
// the original around their corners, from the original nearest to them, and that do so in the original.

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Applications/simplification_errors.h>
#include <CGAL/Animated_mesh_features/Applications/simplify_animation.h>
#include <CGAL/Animated_mesh_features/Evaluation/Random_numbers.h>
#include <CGAL/Animated_mesh_features/Evaluation/feature_regions.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#ifdef BENCHMARK_WITH_MESHOPTIMIZER
  #include <meshoptimizer.h>
#endif

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
namespace SMS = CGAL::Surface_mesh_simplification;

namespace {

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Amf::Frame_sequence<Mesh, float> Sequence;
typedef Amf::Rest_shape::Point Point;
typedef std::vector<Point> Points;

// A coarse surface and where it is in a frame.
struct Coarse
{
  std::vector<Amf::Rest_shape::Triangle> triangles;
  std::vector<Amf::Rest_shape::Index> vertex_of; // if it is known
  Points rest;
  std::function<Points(std::size_t)> frame;
  double seconds = 0;
};

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Coarse coarse_of(const Sequence& s, Amf::Animation_level level)
{
  Coarse c;
  c.triangles = level.triangles;
  c.vertex_of = level.vertex_of;
  c.rest = level.binding.positions(s.rest_shape().points());
  c.frame = [&s, level](std::size_t f) { return level.binding.positions(s.trajectories().frame(f)); };
  return c;
}

// A vertex near a rest shape follows the triangle nearest to it: its place in it and its distance along the normal,
// which becomes longer as the triangle does; what a wrap deformer does.
Coarse wrapped(const Sequence& s, std::vector<Amf::Rest_shape::Triangle> triangles, const Points& points)
{
  struct Place
  {
    Amf::Rest_shape::Triangle t;
    Eigen::Vector3d b;
    double height;
  };
  const Amf::Rest_shape& rest = s.rest_shape();
  const Amf::internal::Triangle_tree tree(rest.triangles(), rest.points());
  std::vector<Place> places;
  for (const Point& p : points) {
    const auto nearest = tree.nearest(p, Amf::Rest_shape::none);
    const Amf::Rest_shape::Triangle t = rest.triangles()[nearest.triangle];
    const Point a = rest.points()[t[0]], u = rest.points()[t[1]] - a, v = rest.points()[t[2]] - a;
    const Point n = u.cross(v);
    // in the basis of two sides and the normal of the length of the root of the area
    const Point q = p - a;
    const double nn = n.squaredNorm();
    const double bu = q.cross(v).dot(n) / nn, bv = u.cross(q).dot(n) / nn;
    places.push_back({t, {1 - bu - bv, bu, bv}, q.dot(n) / std::pow(nn, .75)});
  }
  Coarse c;
  c.triangles = std::move(triangles);
  c.rest = points;
  c.frame = [&s, places](std::size_t f) {
    Points all;
    for (const Place& p : places) {
      const Point a = s.trajectories().point(p.t[0], f), b = s.trajectories().point(p.t[1], f),
                  d = s.trajectories().point(p.t[2], f);
      const Point n = (b - a).cross(d - a);
      const double length = n.norm();
      Point x = p.b[0] * a + p.b[1] * b + p.b[2] * d;
      if (length > 0) x += p.height / std::sqrt(length) * n;
      all.push_back(x);
    }
    return all;
  };
  return c;
}

Mesh copy_at(const Sequence& s, const Points& points)
{
  Mesh mesh = s.triangle_mesh();
  for (std::size_t v = 0; v < points.size(); ++v)
    mesh.point(Mesh::Vertex_index(Mesh::size_type(v))) = {points[v][0], points[v][1], points[v][2]};
  return mesh;
}

// CGAL's on the rest shape, with its filter against turned normals.
Coarse garland_heckbert(const Sequence& s, std::size_t vertices)
{
  Mesh mesh = copy_at(s, s.rest_shape().points());
  typedef SMS::GarlandHeckbert_plane_policies<Mesh, CGAL::Simple_cartesian<double>> Policies;
  const Policies policies(mesh);
  const SMS::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
  std::size_t left = mesh.number_of_vertices();
  for (auto v : mesh.vertices()) left -= mesh.is_isolated(v) ? 1 : 0;
  struct Count : SMS::Edge_collapse_visitor_base<Mesh>
  {
    std::size_t* left;
    explicit Count(std::size_t* l)
      : left(l)
    {}
    void OnCollapsed(const Profile&, const vertex_descriptor&) { --*left; }
  };
  SMS::edge_collapse(mesh, Amf::internal::Vertex_count_stop(left, vertices),
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement).visitor(Count(&left)));
  std::vector<Amf::Rest_shape::Triangle> triangles;
  Points points;
  std::map<Mesh::Vertex_index, Amf::Rest_shape::Index> number;
  for (auto v : mesh.vertices())
    if (!mesh.is_isolated(v)) {
      number[v] = Amf::Rest_shape::Index(points.size());
      points.emplace_back(mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]);
    }
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back(
        {{number[mesh.target(h)], number[mesh.target(mesh.next(h))], number[mesh.target(mesh.prev(h))]}});
  }
  return wrapped(s, triangles, points);
}

#ifdef BENCHMARK_WITH_MESHOPTIMIZER
Coarse meshoptimizer(const Sequence& s, std::size_t vertices)
{
  const Amf::Rest_shape& rest = s.rest_shape();
  std::vector<float> points;
  for (const Point& p : rest.points()) points.insert(points.end(), {float(p[0]), float(p[1]), float(p[2])});
  std::vector<unsigned int> indices, out;
  for (const auto& t : rest.triangles()) indices.insert(indices.end(), t.begin(), t.end());
  std::vector<Amf::Rest_shape::Index> number;
  std::vector<std::size_t> kept;
  // it is told a number of indices: the one that leaves so many vertices
  std::size_t low = 0, high = indices.size() / 3;
  for (int round = 0; round < 24 && low + 1 < high; ++round) {
    const std::size_t middle = (low + high) / 2;
    out.resize(indices.size());
    out.resize(meshopt_simplify(out.data(), indices.data(), indices.size(), points.data(), rest.number_of_vertices(),
                                12, 3 * middle, 1.f, 0, nullptr));
    number.assign(rest.number_of_vertices(), Amf::Rest_shape::none);
    kept.clear();
    for (unsigned int v : out)
      if (number[v] == Amf::Rest_shape::none) {
        number[v] = Amf::Rest_shape::Index(kept.size());
        kept.push_back(v);
      }
    (kept.size() > vertices ? high : low) = middle;
  }
  Coarse c;
  for (std::size_t i = 0; i < out.size(); i += 3)
    c.triangles.push_back({{number[out[i]], number[out[i + 1]], number[out[i + 2]]}});
  for (std::size_t v : kept) c.rest.push_back(rest.points()[v]);
  c.frame = [&s, kept](std::size_t f) {
    Points all;
    for (std::size_t v : kept) all.push_back(s.trajectories().point(v, f));
    return all;
  };
  return c;
}
#endif

struct Summary
{
  std::size_t vertices = 0, worst = 0, turned = 0, from_nearest = 0, in_original = 0;
  double mean = 0, worst_mean = 0, hausdorff = 0, in_regions = 0, elsewhere = 0, angle = 0, seconds = 0;
};

Summary summary(const Sequence& s, const Coarse& c, const Amf::Spatio_temporal_field<float>* regions, std::size_t step)
{
  Amf::Simplification_error_options o;
  o.regions = regions;
  if (!c.vertex_of.empty()) o.vertex_of = &c.vertex_of;
  for (std::size_t f = 0; f < s.number_of_frames(); f += step) o.frames.push_back(f);
  const auto errors = Amf::simplification_errors(s.rest_shape(), s.trajectories(), c.triangles, c.rest, c.frame, o);
  Summary r;
  const double unit = 100 / s.rest_shape().bounding_box_diagonal(), n = double(errors.size());
  double in = 0, share = 0;
  for (const Amf::Simplification_error& e : errors) {
    r.mean += e.mean() * unit / n;
    r.hausdorff = (std::max)(r.hausdorff, e.hausdorff() * unit);
    in += e.mean_in_regions * e.share_in_regions * unit;
    share += e.share_in_regions;
    r.elsewhere += e.mean_elsewhere * unit / n;
    r.angle += e.normal_angle / n;
    r.turned = (std::max)(r.turned, e.turned);
    r.from_nearest = (std::max)(r.from_nearest, e.turned_from_nearest);
    r.in_original = (std::max)(r.in_original, e.turned_in_original);
  }
  r.in_regions = share > 0 ? in / share : 0;
  r.worst_mean = Amf::worst_frame(errors).mean() * unit;
  r.worst = Amf::worst_frame(errors).frame;
  r.vertices = c.rest.size();
  r.seconds = c.seconds;
  return r;
}

// A mesh and a point cache, to be looked at.
void write(const std::string& base, const Sequence& s, const Coarse& c)
{
  if (base.empty()) return;
  Amf::IO::Indexed_mesh mesh;
  for (const Point& p : c.rest) mesh.points.push_back({{p[0], p[1], p[2]}});
  for (const auto& t : c.triangles) mesh.triangles.push_back({{t[0], t[1], t[2]}});
  Amf::IO::Output_file obj(base + ".obj"), pc2(base + ".pc2");
  Amf::IO::write_obj(obj.stream(), mesh);
  Amf::IO::write_pc2(pc2.stream(), c.rest.size(), s.number_of_frames(), [&](std::size_t f, float* xyz) {
    for (const Point& p : c.frame(f))
      for (int k = 0; k < 3; ++k) *xyz++ = float(p[k]);
  });
  obj.commit();
  pc2.commit();
}

void print(const char* name, const Summary& r)
{
  std::printf("  %-26s %6zu  %8.4f  %8.4f (%3zu) %8.3f  %8.4f %8.4f  %6.2f  %4zu %4zu %4zu  %6.2f\n", name, r.vertices,
              r.mean, r.worst_mean, r.worst, r.hausdorff, r.in_regions, r.elsewhere, r.angle, r.turned, r.from_nearest,
              r.in_original, r.seconds);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc < 3) {
    std::cerr
        << "simplification MESH.obj CACHE.pc2 [--rest REST.obj] [--features FEATURES.json] [--shares 0.5,0.1,0.03] "
           "[--step N] [--only NAME,...] [--line W] [--cosine C] [--support K] [--refinements R] [--guidance 4,16] "
           "[--write FOLDER]\n";
    return 2;
  }
  std::map<std::string, std::string> options = {{"--shares", "0.5,0.1,0.03"}, {"--step", "1"}, {"--guidance", "4,16"}};
  for (int i = 3; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
  const Amf::IO::Animation_file_data<float> data = Amf::IO::read_animation<float>({argv[1], argv[2]});
  const Mesh mesh = Amf::IO::to_surface_mesh(data.mesh, argv[1]);
  Sequence s(mesh, data.x, data.y, data.z, 1. / 30);
  if (!options["--rest"].empty()) {
    std::vector<Mesh::Point> rest;
    for (const auto& p : Amf::IO::read_mesh(options["--rest"]).points) rest.emplace_back(p[0], p[1], p[2]);
    s.set_rest_shape(rest);
  }
  std::vector<Amf::Feature_point> features;
  Amf::Spatio_temporal_field<float> regions;
  if (!options["--features"].empty()) {
    features = Amf::IO::read_json(options["--features"]).features;
    regions = Amf::feature_regions(s.rest_shape(), s.number_of_frames(), s.frame_duration(), features,
                                   Amf::Region_course::PRESENT);
  }
  const auto* const r = features.empty() ? nullptr : &regions;
  const std::size_t step = std::size_t(std::stoul(options["--step"]));
  const std::string only = options["--only"];
  const auto wanted = [&](const std::string& name) {
    std::istringstream names(only);
    bool is_wanted = only.empty();
    for (std::string part; std::getline(names, part, ',');)
      is_wanted = is_wanted || name.find(part) != std::string::npos;
    return is_wanted;
  };

  Amf::Simplification_options base;
  const auto number = [&](const char* name, double& to) {
    if (!options[name].empty()) to = std::stod(options[name]);
  };
  number("--line", base.line_weight);
  number("--cosine", base.least_cosine);
  if (!options["--support"].empty()) base.support = std::stoul(options["--support"]);
  if (!options["--refinements"].empty()) base.refinements = std::stoul(options["--refinements"]);
  std::istringstream shares(options["--shares"]);
  std::vector<double> ratios;
  for (std::string share; std::getline(shares, share, ',');) ratios.push_back(std::stod(share));
  for (double ratio : ratios) base.vertices.push_back(std::size_t(ratio * double(s.number_of_vertices())));

  std::printf("%s: %zu vertices, %zu frames, %zu features\n", argv[1], s.number_of_vertices(), s.number_of_frames(),
              features.size());
  std::printf("  %-26s %6s  %8s  %8s       %8s  %8s %8s  %6s  %4s %4s %4s  %6s\n", "% of the diagonal", "vert.", "mean",
              "worst", "Hausd.", "in reg.", "else", "angle", "turn", "near", "orig", "s");
  const auto file_of = [&](std::string name, const Coarse& c) {
    if (options["--write"].empty()) return std::string();
    for (char& letter : name)
      if (letter == ' ' || letter == ',') letter = '_';
    return options["--write"] + "/" + name + "_" + std::to_string(c.rest.size());
  };
  const auto ours = [&](const std::string& name, Amf::Simplification_options o, const auto& guidance) {
    if (!wanted(name + " " + std::to_string(o.poses))) return;
    const double start = now();
    const Amf::Simplified_animation result = Amf::simplify_animation(s, o, guidance);
    const double seconds = now() - start;
    for (const Amf::Animation_level& level : result.levels) {
      Coarse c = coarse_of(s, level);
      c.seconds = seconds;
      write(file_of(name, c), s, c);
      print((name + " " + std::to_string(result.poses.size())).c_str(), summary(s, c, r, step));
    }
  };
  const auto theirs = [&](const std::string& name, const auto& method) {
    if (!wanted(name)) return;
    for (std::size_t vertices : base.vertices) {
      const double start = now();
      Coarse c = method(s, vertices);
      c.seconds = now() - start;
      write(file_of(name, c), s, c);
      print(name.c_str(), summary(s, c, r, step));
    }
  };
  theirs("Garland-Heckbert, rest", garland_heckbert);
#ifdef BENCHMARK_WITH_MESHOPTIMIZER
  theirs("meshoptimizer, rest", meshoptimizer);
#endif
  Amf::Simplification_options o = base;
  o.poses = s.number_of_frames();
  ours("all", o, Amf::Plain_guidance());
  for (std::size_t poses : {1, 4, 8, 16, 32}) {
    if (poses > s.number_of_frames()) continue;
    o.poses = poses;
    ours("farthest", o, Amf::Plain_guidance());
  }
  Amf::Random_numbers random(1);
  for (std::size_t poses : {1, 8}) {
    o.poses = poses;
    for (std::size_t p = 0; p < poses; ++p) o.preferred_poses.push_back(random.below(s.number_of_frames()));
    ours("random", o, Amf::Plain_guidance());
    o.preferred_poses.clear();
  }
  if (!features.empty()) {
    for (const Amf::Feature_point& f : features) o.preferred_poses.push_back(f.frame);
    for (std::size_t poses : {8, 16}) {
      o.poses = poses;
      ours("feature times", o, Amf::Plain_guidance());
    }
    o.preferred_poses.clear();
    o.poses = s.number_of_frames();
    std::istringstream strengths(options["--guidance"]);
    for (std::string strength; std::getline(strengths, strength, ',');)
      ours("guided " + strength + ", all", o,
           Amf::Feature_guidance(s.rest_shape(), s.number_of_frames(), s.frame_duration(), features,
                                 std::stod(strength)));
  }
  return 0;
}
