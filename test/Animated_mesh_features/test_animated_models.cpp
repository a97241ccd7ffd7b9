// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Animated models: keys, evaluation, choice of clips and frames, welding; glTF, HDF5, and formats through assimp where
// the libraries are. With arguments, "dump FILE CLIP FRAMES OUT", it writes what is read from a file, for comparison
// with an evaluation that shares nothing with the package (see test_gltf.sh).

#include "test_io_support.h"
#include "test_recording_memory.h"

#include <CGAL/Animated_mesh_features/IO/sample_clip.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  #include <CGAL/Animated_mesh_features/Evaluation/prominent_maxima.h>
  #include <CGAL/Animated_mesh_features/IO/joint_angles.h>
  #include <CGAL/Animated_mesh_features/IO/read_gltf.h>
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
  #include <CGAL/Animated_mesh_features/IO/read_assimp.h>
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
  #include <CGAL/Animated_mesh_features/IO/read_hdf5.h>
#endif

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/tags.h>

#ifndef _WIN32
  #include <sys/stat.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifndef ANIMATED_MESH_FEATURES_TEST_DATA
  #define ANIMATED_MESH_FEATURES_TEST_DATA ""
#endif

using namespace CGAL::Animated_mesh_features;
using namespace test_support;

namespace {

typedef IO::Keyframed_model Model;
typedef IO::Keyframe_track::Interpolation Interpolation;
typedef std::vector<std::array<std::size_t, 3>> Triangles;

IO::Keyframe_track track(Interpolation interpolation, const std::vector<double>& times,
                         const std::vector<double>& values, std::size_t width = 1)
{
  IO::Keyframe_track t;
  t.interpolation = interpolation;
  t.times = times;
  t.values = values;
  t.width = width;
  t.is_rotation = width == 4;
  return t;
}

double value(const IO::Keyframe_track& t, double time)
{
  double v;
  t.evaluate(time, &v);
  return v;
}

void test_tracks()
{
  const auto linear = track(Interpolation::LINEAR, {1, 2, 4}, {10, 20, 0});
  const auto step = track(Interpolation::STEP, {1, 2, 4}, {10, 20, 0});
  CHECK(linear.is_complete() && step.is_complete());
  for (double t : {0., 1., 1.25, 2., 3., 4., 9.}) {
    CHECK_NEAR(value(linear, t), t < 1 ? 10 : t < 2 ? 10 * t : t < 4 ? 40 - 10 * t : 0, 1e-14);
    CHECK(value(step, t) == (t < 2 ? 10 : t < 4 ? 20 : 0));
  }
  // t^3, whose tangents are 3 t^2, is its own spline.
  const auto spline = track(Interpolation::CUBICSPLINE, {0, 1, 3}, {99, 0, 0, 3, 1, 3, 27, 27, 99});
  CHECK(spline.is_complete());
  for (int i = 0; i <= 30; ++i) CHECK_NEAR(value(spline, 0.1 * i), std::pow(0.1 * i, 3), 1e-13);
  CHECK(value(spline, -1) == 0 && value(spline, 4) == 27);
  CHECK(!track(Interpolation::CUBICSPLINE, {0, 1}, {0, 1}).is_complete());
  CHECK(!track(Interpolation::LINEAR, {1, 0}, {0, 1}).is_complete());
  CHECK(!track(Interpolation::LINEAR, {}, {}).is_complete());

  // At constant speed, also where the arc is so short that its cosine is 1.
  for (double angle : {3., 1e-3, 1e-9}) {
    const auto turn =
        track(Interpolation::LINEAR, {0, 1}, {0, 0, 0, 2, 0, 0, 3 * std::sin(angle / 2), 3 * std::cos(angle / 2)}, 4);
    for (double t : {0., 0.25, 0.7, 1.}) {
      double q[4];
      turn.evaluate(t, q);
      CHECK_NEAR(2 * std::atan2(q[2], q[3]), angle * t, 1e-14);
      CHECK_NEAR(std::hypot(q[2], q[3]), 1, 1e-14);
    }
  }
}

Model::Channel channel(std::size_t node, Model::Path path, const IO::Keyframe_track& track)
{
  Model::Channel c;
  c.node = node;
  c.path = path;
  c.track = track;
  return c;
}

// A square of two triangles with the diagonal split, at a node that moves by `x` a second.
Model square(double x = 1)
{
  Model m;
  m.nodes.resize(1);
  Model::Geometry g;
  g.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
  g.triangles = {{{0, 1, 2}}, {{3, 4, 5}}};
  m.geometries.push_back(g);
  m.parts.push_back({0, 0, Model::none, {}, "square"});
  m.clips.push_back(
      {"move", {channel(0, Model::Path::TRANSLATION, track(Interpolation::LINEAR, {0, 1}, {0, 0, 0, x, 0, 0}, 3))}});
  return m;
}

void test_evaluation_errors()
{
  const auto evaluator = [](const Model& m) { IO::Keyframed_model_evaluator(m, 0, "file"); };
  Model m = square();
  m.nodes.resize(3);
  m.nodes[1].parent = 2;
  m.nodes[2].parent = 1;
  CHECK_THROWS(Input_error, (evaluator(m), 0), "file: node 1 is among its own ancestors");
  m = square();
  m.parts[0].skin = 0;
  CHECK_THROWS(Input_error, (evaluator(m), 0), "file: square refers to a skin that is not there");
  m = square();
  m.parts[0].weights = {1};
  CHECK_THROWS(Input_error, (evaluator(m), 0), "1 weights for 0 morph targets");
  m = square();
  m.clips[0].channels[0].track.values.pop_back();
  CHECK_THROWS(Input_error, (evaluator(m), 0), "clip \"move\", node 0");
  m = square(std::numeric_limits<double>::infinity());
  CHECK_THROWS(Input_error, IO::sample_clip<double>(m, {}, "file"),
               "file, clip \"move\", frame 0: the position of vertex 0");
  // a body that is scaled away at the end
  m = square();
  m.clips[0].channels.push_back(
      channel(0, Model::Path::SCALE, track(Interpolation::LINEAR, {0, 0.5, 1}, {1, 1, 1, 1, 1, 1, 0, 0, 0}, 3)));
  IO::Clip_sampling sampling;
  sampling.frames = 9;
  CHECK_THROWS(Input_error, IO::sample_clip<double>(m, sampling, "file.glb"), "file.glb, frame 8: has no extent");
  sampling.skip_bad_frames = true;
  const auto skipped = IO::sample_clip<double>(m, sampling, "file.glb");
  CHECK(skipped.frames == 9 && skipped.notices.size() == 1 && skipped.x(0, 8) == skipped.x(0, 7));
}

std::vector<double> times(const std::vector<std::vector<double>>& keys, IO::Clip_sampling sampling = {})
{
  Model::Clip clip;
  clip.name = "name";
  for (const auto& k : keys)
    clip.channels.push_back(
        channel(0, Model::Path::SCALE, track(Interpolation::LINEAR, k, std::vector<double>(3 * k.size()), 3)));
  return IO::frame_times(clip, sampling, "file");
}

void test_sampling()
{
  std::vector<double> film;
  for (int i = 0; i < 60; ++i) film.push_back(double(float(i / 24.)));
  CHECK(times({film}).size() == 60);                                  // the own rate
  CHECK(times({film, {0, 1, 2}}).size() == 60);                       // the commonest step
  CHECK(times({{0, 1}, {0, 1}, {0, 1}, {0, 0.1, 0.2}}).size() == 51); // but tracks alike count once
  CHECK(times({{0, 0.25}}).size() == 48);                             // few keys: enough frames
  CHECK(times({{0, 1, 2}}).size() == 49);                             // so that keys are met
  CHECK(times({{0, 1, 2}})[24] == 1);
  CHECK(times({{0, 5, 10}}).size() == 10 * 24 - 1); // and often enough: 119 in 5 s are 23.8 in a second
  CHECK(times({{3, 4}, {2, 3.5}}).front() == 2 && times({{3, 4}, {2, 3.5}}).back() == 4);
  IO::Clip_sampling sampling;
  sampling.frames = 3;
  CHECK((times({{1, 2}}, sampling) == std::vector<double>{1, 1.5, 2}));
  sampling.there_and_back = true;
  CHECK((times({{1, 2}}, sampling) == std::vector<double>{1, 1.5, 2, 1.5, 1}));
  sampling.there_and_back = false;
  sampling.frames = 1;
  CHECK_THROWS(Option_error, times({{1, 2}}, sampling), "at least 2 frames");
  sampling.frames.reset();
  sampling.frames_per_second = 10;
  CHECK(times({{0, double(0.3f)}}, sampling).size() == 4);
  CHECK(times({{0, 0.39}}, sampling).size() == 4 && std::abs(times({{0, 0.39}}, sampling)[3] - 0.3) < 1e-15);
  CHECK_THROWS(Option_error, times({{0, 0.05}}, sampling), "shorter than a frame");
  CHECK_THROWS(Input_error, times({{1}}), "file: clip \"name\" has no duration");
  CHECK_THROWS(Input_error, times({}), "no duration");
  sampling.frames_per_second = 1e300;
  CHECK_THROWS(Option_error, times({{0, 1}}, sampling), "frames; at most 10000000 are made");
  // Two keys that are a year apart make no year of frames, unless somebody says so; as many keys do.
  CHECK_THROWS(Input_error, times({{0, 3e7}}), "clip \"name\" lasts 3e+07 s and would have 7.128e+08 frames");
  CHECK_THROWS(Input_error, times({{0, 1e-6, 1}}), "would have 1e+06 frames");
  sampling.frames_per_second = 1;
  CHECK(times({{0, 500000}}, sampling).size() == 500001);
  std::vector<double> recorded(300000);
  for (std::size_t i = 0; i < recorded.size(); ++i) recorded[i] = double(i);
  sampling.frames_per_second.reset();
  CHECK_THROWS(Input_error, times({recorded}), "many more than it has keys"); // at 24 in a second
  for (double& t : recorded) t /= 24;
  CHECK(times({recorded}).size() == recorded.size());
  CHECK(times({{0}, {1}}).size() == 48); // no step at all

  typedef std::vector<std::size_t> Clips;
  CHECK((IO::find_clips({"a", "b", "c"}, "", "f") == Clips{0}) &&
        (IO::find_clips({"a", "b", "c"}, "c", "f") == Clips{2}));
  CHECK((IO::find_clips({"a", "b", "c"}, "c+0", "f") == Clips{2, 0}));
  CHECK((IO::find_clips({"a", "b", "a+b"}, "a+b", "f") == Clips{2})); // names come first
  CHECK((IO::find_clips({"a", "a", "b"}, "0+b", "f") == Clips{0, 2}));
  CHECK_THROWS(Option_error, IO::find_clips({"a", "b"}, "a+z", "f"), "there is no clip \"z\"");
  CHECK_THROWS(Option_error, IO::find_clips({"a", "b"}, "a+", "f"), "joins a clip with nothing");
  CHECK_THROWS(Option_error, IO::find_clips({"a", "b"}, "a+b+0", "f"), "names the clip \"a\" twice");
  CHECK_THROWS(Input_error, IO::find_clips({}, "a+b", "f"), "holds no animation");
  CHECK(IO::find_clip({"a", "b", "1"}, "", "f") == 0);
  CHECK(IO::find_clip({"a", "b", "1"}, "b", "f") == 1);
  CHECK(IO::find_clip({"a", "b", "1"}, "1", "f") == 2); // names come first
  CHECK(IO::find_clip({"a", "b", "c"}, "1", "f") == 1);
  CHECK_THROWS(Option_error, IO::find_clip({"a", "b"}, "c", "f"),
               "f: there is no clip \"c\"; clips are 0 \"a\", 1 \"b\"");
  CHECK_THROWS(Option_error, IO::find_clip({"a", "a"}, "a", "f"), "several clips");
  CHECK_THROWS(Option_error, IO::find_clip({"a", "b"}, "2", "f"), "no clip");
  CHECK_THROWS(Input_error, IO::find_clip({}, "", "f"), "f: holds no animation");
}

void test_sampled_clip()
{
  std::size_t told_vertices = 0, told_frames = 0;
  IO::Clip_sampling sampling;
  sampling.frames = 101;
  const auto memory = std::make_shared<Recording_memory>();
  const auto choose = [&](std::size_t n, std::size_t f) {
    told_vertices = n, told_frames = f;
    return memory;
  };
  const auto data = IO::sample_clip<double>(square(), sampling, "file", choose);
  CHECK(told_vertices == 4 && told_frames == 101);
  CHECK(data.x.memory() == memory && data.y.memory() == memory && data.z.memory() == memory);
  CHECK(data.frames == 101 && data.times.size() == 101 && data.mesh.points.size() == 4);
  CHECK((data.mesh.triangles == Triangles{{{0, 1, 2}}, {{1, 3, 2}}}));
  CHECK((data.origins.of(0) == std::vector<std::size_t>{0}) && (data.origins.of(1) == std::vector<std::size_t>{1, 3}));
  CHECK(data.origins.parts.size() == 1 && data.origins.parts[0].name == "square" &&
        data.origins.parts[0].vertices == 6);
  for (std::size_t f = 0; f < 101; ++f) {
    CHECK_NEAR(data.times[f], 0.01 * double(f), 1e-15);
    CHECK_NEAR(data.x(3, f), 1 + 0.01 * double(f), 1e-15);
    CHECK(data.y(3, f) == 1 && data.z(3, f) == 0);
  }
  // without the clip, the node is where it says itself
  typedef std::array<double, 3> P;
  CHECK((data.bind_points == std::vector<P>{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}}));
  Model resting = square();
  resting.nodes[0].translation = {{5, 0, 2}};
  const auto rest = IO::sample_clip<double>(resting, sampling, "file");
  CHECK((rest.bind_points == std::vector<P>{{{5, 0, 2}}, {{6, 0, 2}}, {{5, 1, 2}}, {{6, 1, 2}}}) && rest.x(3, 0) == 1);
  resting.nodes[0].translation[1] = std::numeric_limits<double>::infinity();
  CHECK(IO::sample_clip<double>(resting, sampling, "file").bind_points.empty());
  // before it is evaluated, asked about what is left at least
  std::vector<std::size_t> asked;
  const auto refuse = [&](std::size_t n, std::size_t f) -> std::shared_ptr<Field_memory> {
    asked = {n, f};
    throw Error("too much");
  };
  sampling.frames = IO::Clip_sampling::most_frames;
  CHECK_THROWS(Error, IO::sample_clip<double>(square(), sampling, "file", refuse), "too much");
  CHECK((asked == std::vector<std::size_t>{4, IO::Clip_sampling::most_frames}));
  CHECK(data.remarks.size() == 1 && data.remarks[0] == "6 vertices of the file became 4, 1 edge was sewn");
  CHECK(data.frame_name(7) == "file, frame 7");
  // Two clips together are what one with the channels of both is.
  Model two = square();
  two.clips.push_back(
      {"grow", {channel(0, Model::Path::SCALE, track(Interpolation::LINEAR, {0, 2}, {1, 1, 1, 1, 3, 1}, 3))}});
  Model one = two;
  one.clips[0].channels.push_back(one.clips[1].channels[0]);
  sampling.frames = 101;
  sampling.clip = "move+1";
  const auto together = IO::sample_clip<double>(two, sampling, "file");
  CHECK(together.clip == 0 && together.further_clips == std::vector<std::size_t>{1});
  sampling.clip.clear();
  const auto expected = IO::sample_clip<double>(one, sampling, "file");
  CHECK(together.times == expected.times && together.times.back() == 2);
  for (std::size_t v = 0; v < 4; ++v)
    for (std::size_t f = 0; f < 101; ++f)
      CHECK(together.x(v, f) == expected.x(v, f) && together.y(v, f) == expected.y(v, f) &&
            together.z(v, f) == expected.z(v, f));
  two.clips[1].channels[0] = two.clips[0].channels[0];
  sampling.clip = "0+1";
  CHECK_THROWS(Option_error, IO::sample_clip<double>(two, sampling, "file"),
               "file: the clips \"move\" and \"grow\" do not go together, both move node");
  sampling.clip.clear();
  // A part by the name of its node, of one above it, of its mesh, or by the number of its component.
  Model lid = square();
  lid.nodes[0].name = "box";
  lid.nodes.push_back(lid.nodes[0]);
  lid.nodes[1].name = "lid";
  lid.nodes[1].parent = 0;
  lid.nodes[1].translation = {{0, 0, 5}};
  lid.parts.push_back({0, 1, Model::none, {}, "lid, mesh 0", "board", 3});
  lid.parts[0].mesh = "board";
  for (const char* name : {"lid", "board/3", "box/3", "2"}) {
    sampling.part = name;
    const auto part = IO::sample_clip<double>(lid, sampling, "file");
    CHECK((part.part_names == std::vector<std::string>{"box", "board", "lid"}));
    CHECK(part.mesh.triangles == data.mesh.triangles && part.x.number_of_rows() == 4 && part.z(3, 50) == 5);
    CHECK((part.origins.of(1) == std::vector<std::size_t>{7, 9}) && part.origins.parts.size() == 2);
    CHECK((part.bind_points[3] == P{{1, 1, 5}}) && (part.mesh.points[3] == P{{1, 1, 5}}));
  }
  for (const char* name : {"", "box", "board"}) {
    sampling.part = name;
    CHECK(IO::sample_clip<double>(lid, sampling, "file").mesh.points.size() == 8);
  }
  for (const char* name : {"3", "0", "board/1", "lid/"}) {
    sampling.part = name;
    CHECK_THROWS(Option_error, IO::sample_clip<double>(lid, sampling, "file"),
                 "parts are \"box\", \"board\", \"lid\"; components 1 (4 vertices), 2 (4)");
  }
  sampling.part.clear();
  std::ostringstream map;
  IO::write_vertex_map(map, data.origins, 4);
  CHECK(map.str() == "file_vertex,part,part_vertex,vertex\n0,0,0,0\n1,0,1,1\n3,0,3,1\n2,0,2,2\n5,0,5,2\n4,0,4,3\n");
  std::ostringstream identity;
  IO::write_vertex_map(identity, IO::Vertex_origins(), 2);
  CHECK(identity.str() == "file_vertex,part,part_vertex,vertex\n0,0,0,0\n1,0,1,1\n");

  const auto parallel = IO::sample_clip<float, CGAL::Parallel_if_available_tag>(square(0.1), sampling, "file");
  const auto sequential = IO::sample_clip<float, CGAL::Sequential_tag>(square(0.1), sampling, "file");
  for (std::size_t f = 0; f < 101; ++f)
    for (std::size_t v = 0; v < 4; ++v) CHECK(parallel.x(v, f) == sequential.x(v, f));

  // what throws before there are frames
  struct Stop
  {
  };
  bool is_stopped = false;
  try {
    IO::sample_clip<double>(square(), sampling, "file",
                            [](std::size_t, std::size_t) -> std::shared_ptr<Field_memory> { throw Stop(); });
  } catch (const Stop&) {
    is_stopped = true;
  }
  CHECK(is_stopped);
}

void test_coincidence()
{
  IO::Coincident_vertices c(6);
  c.add_frame({{{0, 0, 0}}, {{-0., 0, 0}}, {{1, 0, 0}}, {{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}});
  CHECK((c.first_of_class() == std::vector<std::size_t>{0, 0, 2, 0, 2, 5}));
  CHECK(!c.all_apart());
  c.add_frame({{{5, 0, 0}}, {{6, 0, 0}}, {{5, 0, 0}}, {{6, 0, 0}}, {{5, 0, 0}}, {{5, 0, 0}}});
  CHECK((c.first_of_class() == std::vector<std::size_t>{0, 1, 2, 1, 2, 5}));
  // apart once is apart for good
  c.add_frame(std::vector<std::array<double, 3>>(6, {{7, 7, 7}}));
  CHECK((c.first_of_class() == std::vector<std::size_t>{0, 1, 2, 1, 2, 5}));
  c.add_frame({{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}}, {{4, 0, 0}}, {{5, 0, 0}}});
  CHECK(c.all_apart());
}

// The result must always be what to_surface_mesh() takes.
IO::Welded_surface welded(const Triangles& triangles, const std::vector<std::size_t>& place)
{
  IO::Welded_surface w = IO::weld_surface(triangles, place);
  IO::Indexed_mesh mesh;
  mesh.points.resize(w.number_of_vertices());
  mesh.triangles = w.triangles;
  CHECK(num_faces(IO::to_surface_mesh(mesh, "welded")) == w.triangles.size());
  return w;
}

void test_welding()
{
  // A square whose diagonal is split, and one of which a half is turned round.
  const std::vector<std::size_t> split = {0, 1, 2, 1, 4, 2};
  IO::Welded_surface w = welded({{{0, 1, 2}}, {{3, 4, 5}}}, split);
  CHECK(w.number_of_vertices() == 4 && w.welded_edges == 1 && w.open_edges == 0);
  w = welded({{{0, 1, 2}}, {{3, 5, 4}}}, split);
  CHECK(w.number_of_vertices() == 6 && w.welded_edges == 0 && w.open_edges == 1);

  // Two triangles that touch in a point: apart as they are, and taken apart if the file has one vertex there.
  CHECK(welded({{{0, 1, 2}}, {{3, 4, 5}}}, {0, 1, 2, 0, 4, 5}).number_of_vertices() == 6);
  w = welded({{{0, 1, 2}}, {{0, 3, 4}}}, {0, 1, 2, 3, 4});
  CHECK(w.number_of_vertices() == 6 && w.split_vertices == 1);
  CHECK((w.file_vertices == std::vector<std::size_t>{0, 0, 1, 2, 3, 4}));

  // Three borders at an edge, and the same with two of them joined by the file.
  w = welded({{{0, 1, 2}}, {{3, 4, 5}}, {{6, 7, 8}}}, {0, 1, 2, 1, 0, 5, 0, 1, 8});
  CHECK(w.number_of_vertices() == 9 && w.open_edges == 1);
  w = welded({{{0, 1, 2}}, {{1, 0, 3}}, {{4, 5, 6}}}, {0, 1, 2, 3, 0, 1, 6});
  CHECK(w.number_of_vertices() == 7 && w.welded_edges == 0);

  // The two sides of a sheet do not stick together.
  w = welded({{{0, 1, 2}}, {{3, 5, 4}}}, {0, 1, 2, 0, 1, 2});
  CHECK(w.number_of_vertices() == 6);

  // A triangle without area, between two others along a seam: left out, its neighbours are joined.
  w = welded({{{0, 1, 2}}, {{1, 3, 2}}, {{3, 4, 5}}}, {0, 1, 2, 1, 4, 2});
  CHECK(w.triangles.size() == 2 && w.collapsed_triangles == 1 && w.number_of_vertices() == 4);

  // A tetrahedron of single triangles becomes closed; vertices without triangles are left out.
  w = welded({{{0, 1, 2}}, {{3, 4, 5}}, {{6, 7, 8}}, {{9, 10, 11}}}, {0, 2, 1, 0, 1, 5, 1, 2, 5, 2, 0, 5, 12});
  CHECK(w.number_of_vertices() == 4 && w.welded_edges == 6 && w.unused_vertices == 1);

  // Two strips over the same four corners (0, 1, 2, 3) with the same diagonal (0, 2), but sides of their own in the
  // file: sewn along their border, the two diagonals would be one edge of four triangles.
  w = welded({{{0, 1, 2}}, {{0, 2, 3}}, {{4, 6, 5}}, {{4, 7, 6}}}, {0, 1, 2, 3, 0, 1, 2, 3});
  CHECK(w.number_of_vertices() == 8);
  // The same with the second side finer, so that no triangle has its like: vertex 8 is the middle of a triangle.
  w = welded({{{0, 1, 2}}, {{0, 2, 3}}, {{4, 8, 5}}, {{8, 6, 5}}, {{4, 6, 8}}, {{4, 9, 6}}, {{4, 7, 9}}, {{9, 7, 6}}},
             {0, 1, 2, 3, 0, 1, 2, 3, 8, 9});
  CHECK(w.triangles.size() == 8 && w.number_of_vertices() == 10 && w.open_edges == 4);
}

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
// A triangle whose points are in `buffer`; `more` are further members of the file.
std::string triangle_gltf(const std::string& buffer, const std::string& more = "")
{
  return "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{" + buffer +
         "\"byteLength\": 36}], \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}], \"accessors\": "
         "[{\"bufferView\": "
         "0, \"componentType\": 5126, \"type\": \"VEC3\", \"count\": 3}], \"nodes\": [{\"mesh\": 0}], \"meshes\": "
         "[{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}]" +
         more + "}";
}

// A model names the files that are opened: only those of its buffers are, only beside it, and only regular ones.
void test_linked_files()
{
  const Temporary_folder folder;
  const std::string bytes(36, '\0');
  folder.write("secret.bin", bytes);
  folder.write("model/sub/a b.bin", bytes + "more");
  folder.write("current/here.bin", bytes);
  const auto read = [&](const std::string& uri, IO::Linked_files linked = IO::Linked_files::BESIDE_MODEL) {
    const std::string file = folder.write("model/m.gltf", triangle_gltf("\"uri\": \"" + uri + "\", "));
    const Model model = IO::read_gltf(file, linked);
    CHECK(model.geometries.at(0).triangles.size() == 1 && model.linked_files.size() == 1);
    return model.linked_files[0];
  };
  CHECK(std::filesystem::equivalent(read("sub/a%20b.bin"), folder.path("model/sub/a b.bin")));
  for (const std::string& uri : {std::string("../secret.bin"), std::string("sub/../../secret.bin"),
                                 std::string("%2e%2e/secret.bin"), folder.path("secret.bin")}) {
    CHECK_THROWS(Input_error, read(uri), "is not in the model's folder");
    CHECK(std::filesystem::equivalent(read(uri, IO::Linked_files::ANYWHERE), folder.path("secret.bin")));
  }
  CHECK_THROWS(Input_error, read("file:///etc/passwd", IO::Linked_files::ANYWHERE), "is no file beside the model");
  CHECK_THROWS(Input_error, read("http://a.b/c.bin"), "is no file beside the model");
  CHECK_THROWS(Input_error, read("sub"), "is no regular file");
  CHECK_THROWS(Input_error, read(""), "is no regular file");
  CHECK_THROWS(Input_error, read("away.bin"), "buffer 0: there is no file");
  folder.write("model/short.bin", "short");
  CHECK_THROWS(Input_error, read("short.bin"), "short.bin has 5 bytes, not 36");
  const std::filesystem::path current = std::filesystem::current_path();
  std::filesystem::current_path(folder.path("current"));
  CHECK_THROWS(Input_error, read("here.bin"), "buffer 0: there is no file");
  std::filesystem::current_path(current);
  #ifndef _WIN32
  std::filesystem::create_symlink("../secret.bin", folder.path("model/link.bin"));
  CHECK_THROWS(Input_error, read("link.bin"), "is not in the model's folder");
  read("link.bin", IO::Linked_files::ANYWHERE);
  CHECK(mkfifo(folder.path("model/pipe").c_str(), 0600) == 0); // whoever opens it waits for ever
  CHECK_THROWS(Input_error, read("pipe", IO::Linked_files::ANYWHERE), "pipe is no regular file");
  const std::string data = "\"uri\": \"data:application/octet-stream;base64," + std::string(48, 'A') + "\", ";
  const std::string images = ", \"images\": [{\"uri\": \"pipe\"}, {\"uri\": \"../secret.bin\"}, 7]";
  CHECK(IO::read_gltf(folder.write("model/i.gltf", triangle_gltf(data, images))).linked_files.empty());
  #endif
}

// What is much larger than the file is refused before memory is taken for it.
void test_swollen_gltf()
{
  const Temporary_folder folder;
  const auto read = [&](const std::string& text) { return IO::read_gltf(folder.write("s.gltf", text)); };
  const std::string data = "\"uri\": \"data:application/octet-stream;base64," + std::string(48, 'A') + "\", ";
  const auto nested = [&](std::size_t levels) {
    return triangle_gltf(data, ", \"extras\": " + std::string(levels, '[') + "\"]\\\"[\"" + std::string(levels, ']'));
  };
  CHECK(read(nested(63)).geometries.size() == 1);
  CHECK_THROWS(Input_error, read(nested(64)), "is nested too deeply");
  CHECK_THROWS(Input_error, read(nested(200000)), "is nested too deeply");
  CHECK_THROWS(Input_error, read(std::string(200000, '[')), "is nested too deeply");

  const auto with_skin = [&](const std::string& accessor) {
    std::string text = triangle_gltf(data, ", \"skins\": [{\"joints\": [0], \"inverseBindMatrices\": 1}]");
    return text.replace(text.find("}], \"nodes\""), 2, "}, {" + accessor + "}]");
  };
  const std::string sparse = ", \"sparse\": {\"count\": 1, \"indices\": {\"bufferView\": 0, \"componentType\": 5121}, "
                             "\"values\": {\"bufferView\": 0}}";
  const std::string matrices = "\"componentType\": 5126, \"type\": \"MAT4\", \"count\": ";
  CHECK_THROWS(Input_error, read(with_skin(matrices + "67108864" + sparse)),
               "has more elements than the file has bytes");
  CHECK_THROWS(Input_error, read(with_skin("\"bufferView\": 0, " + matrices + "36")), "exceeds its buffer");
  // what many refer to
  std::string uses = "{\"mesh\": 0}";
  for (int i = 0; i < 11; ++i) uses += ", " + uses;
  folder.write("points.bin", std::string(36000, '\0'));
  std::string many = triangle_gltf("\"uri\": \"points.bin\", ");
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t i; (i = many.find(from)) != std::string::npos;) many.replace(i, from.size(), to);
  };
  replace("\"byteLength\": 36}", "\"byteLength\": 36000}");
  replace("\"count\": 3}", "\"count\": 3000}");
  CHECK(read(many).geometries.at(0).points.size() == 3000);
  replace("[{\"mesh\": 0}]", "[ " + uses + "]");
  CHECK_THROWS(Input_error, read(many), "takes more memory than its 36000 bytes of data account for");
}

void test_binary_gltf()
{
  const Temporary_folder folder;
  const auto chunk = [](const char* kind, const std::string& data) {
    return little_endian(std::uint32_t(data.size())) + std::string(kind, 4) + data;
  };
  const auto file = [](const std::string& chunks) {
    return "glTF" + little_endian(std::uint32_t(2)) + little_endian(std::uint32_t(12 + chunks.size())) + chunks;
  };
  const auto read = [&](const std::string& content) { return IO::read_gltf(folder.write("m.glb", content)); };
  std::string text = triangle_gltf("");
  text += std::string((4 - text.size() % 4) % 4, ' ');
  const std::string json = chunk("JSON", text), other = chunk("abcd", "1234"), bytes(36, '\0');
  CHECK(read(file(json + other + chunk("BIN\0", bytes))).geometries.at(0).triangles.size() == 1);
  CHECK_THROWS(Input_error, read(file(json)), "buffer 0 has no data");
  CHECK_THROWS(Input_error, read(file(json + chunk("BIN\0", bytes.substr(4)))), "buffer 0 has 36 bytes, the file 32");
  CHECK_THROWS(Input_error, read(file(chunk("BIN\0", bytes) + json)), "its first chunk, and no other, holds JSON");
  CHECK_THROWS(Input_error, read(file(json + chunk("BIN\0", bytes)).substr(0, 300)), "its header announces");
  CHECK_THROWS(Input_error, read(file(json + little_endian(std::uint32_t(0xfffffff0)) + "BIN?")), "exceeds it");
  // the data of the file is that of one buffer: a thousand others do not copy it
  text = triangle_gltf("\"byteLength\": 36}, {");
  text += std::string((4 - text.size() % 4) % 4, ' ');
  CHECK_THROWS(Input_error, read(file(chunk("JSON", text) + chunk("BIN\0", bytes))), "buffer 1 has no data");
}

// The angles of all joints in all clips of a character, against those that another program computed: degrees with one
// decimal. A joint that a clip leaves alone has no list there.
void test_angles_of_character()
{
  const std::string folder = std::string(ANIMATED_MESH_FEATURES_TEST_DATA) + "/clips/";
  if (!std::filesystem::exists(folder + "truth.json")) {
    std::cout << "SKIPPED: no characters in \"" << folder << "\" (ANIMATED_MESH_FEATURES_TEST_DATA)" << std::endl;
    return;
  }
  std::ifstream file(folder + "truth.json");
  const nlohmann::json truth = nlohmann::json::parse(file);
  const std::string name = folder + "Knight.glb";
  const Model model = IO::read_gltf(name);
  const std::vector<std::string> names = IO::clip_names(model);
  std::size_t compared = 0, maxima = 0;
  for (const auto& [clip_name, expected] : truth["clips"].items()) {
    const Model::Clip& clip = model.clips[IO::find_clip(names, clip_name, name)];
    IO::Clip_sampling sampling;
    sampling.frames = expected["frames"].get<std::size_t>();
    if (*sampling.frames < 2) continue;
    std::map<std::string, IO::Joint_angles> joints;
    for (const IO::Joint_angles& j : IO::joint_angles(model, clip, IO::frame_times(clip, sampling, name)))
      joints[j.name] = j;
    for (const auto& joint : expected["joints"]) {
      if (!joint.contains("angle_deg")) continue;
      const std::vector<double> angles = joint["angle_deg"];
      const std::vector<double>& ours = joints.at(joint["name"]).angles;
      CHECK(ours.size() == angles.size());
      for (std::size_t f = 0; f < angles.size(); ++f) CHECK_NEAR(ours[f], angles[f], 0.0501);
      compared += angles.size();
      // all that stand out by 10 degrees, whatever the rounding
      std::vector<std::pair<double, double>> expected_maxima; // frame, prominence
      if (joint.contains("maxima"))
        for (const auto& m : joint["maxima"])
          expected_maxima.emplace_back(m["time"].get<double>() * expected["fps"].get<double>(),
                                       m["prominence_deg"].get<double>());
      // Of a plateau, and of two peaks of one height, the last digit decides which frame it is, and which is the higher.
      const auto angle = [&](double frame) { return ours[std::size_t(std::lround(frame))]; };
      const auto is_there = [&](double frame, const auto& list) {
        return std::any_of(list.begin(), list.end(),
                           [&](const auto& m) { return std::abs(angle(m.first) - angle(frame)) < 0.1; });
      };
      std::vector<std::pair<double, double>> our_maxima;
      for (const Prominent_maximum& m : prominent_maxima(ours, 0))
        our_maxima.emplace_back(double(m.place), m.prominence);
      for (const auto& m : expected_maxima) CHECK(m.second < 10.1 || is_there(m.first, our_maxima));
      for (const auto& m : our_maxima) CHECK(m.second < 10.1 || is_there(m.first, expected_maxima));
      maxima += expected_maxima.size();
    }
  }
  CHECK(compared > 1000 && maxima > 10);
}

void test_bad_gltf()
{
  const Temporary_folder folder;
  const auto read = [&](const std::string& text) { return IO::read_gltf(folder.write("bad.gltf", text)); };
  const auto gltf = [](const std::string& text) { return "{\"asset\": {\"version\": \"2.0\"}" + text + "}"; };
  CHECK_THROWS(Input_error, IO::read_gltf(folder.path("missing.glb")), "missing.glb: cannot read");
  CHECK_THROWS(Input_error, read(""), "bad.gltf: is no readable glTF 2.0");
  CHECK_THROWS(Input_error, read("{\"asset\": "), "bad.gltf: is no readable glTF 2.0");
  CHECK_THROWS(Input_error, read("glTF\1\0\0\0"), "bad.gltf: is no readable glTF 2.0");
  CHECK_THROWS(Input_error, read("{\"asset\": {\"version\": \"1.0\"}}"), "is glTF 1.0");
  CHECK_THROWS(Input_error, read(gltf(", \"extensionsRequired\": [\"KHR_draco_mesh_compression\"]")),
               "needs KHR_draco_mesh_compression, which is not supported");
  CHECK_THROWS(Input_error, read(gltf(", \"extensionsRequired\": [\"EXT_meshopt_compression\"]")),
               "needs EXT_meshopt_compression, which is not supported");
  CHECK_THROWS(Input_error, read(gltf(", \"extensionsRequired\": [\"ABC_xyz\"]")), "needs the extension ABC_xyz");
  // by name also where it is not said to be required
  CHECK_THROWS(
      Input_error,
      read(gltf(", \"accessors\": [{\"count\": 3}], \"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, "
                "\"extensions\": {\"KHR_draco_mesh_compression\": {}}}]}]")),
      "needs KHR_draco_mesh_compression");
  CHECK_THROWS(Input_error,
               read(gltf(", \"buffers\": [{\"byteLength\": 4, \"extensions\": {\"EXT_meshopt_compression\": {}}}]")),
               "buffer 0 has no data; it needs EXT_meshopt_compression");
  CHECK(read(gltf(", \"extensionsRequired\": [\"KHR_materials_unlit\"]")).nodes.empty());
  CHECK_THROWS(Input_error, read(gltf(", \"buffers\": [{\"uri\": \"away.bin\", \"byteLength\": 4}]")), "away.bin");
  CHECK_THROWS(Input_error, read(gltf(", \"nodes\": [{\"children\": [1]}]")), "child 1 is not there");
  CHECK_THROWS(Input_error, read(gltf(", \"nodes\": [{\"name\": \"a\", \"children\": [1]}, {\"children\": [1]}]")),
               "two parents");
  CHECK_THROWS(Input_error, read(gltf(", \"nodes\": [{\"scale\": [1, 1]}]")), "node 0: the scale has 2 numbers");

  // Everything whose place is told by the file: outside of the buffer by a byte, or by so much that it comes round.
  const auto accessor = [&](const std::string& accessor, const std::string& view, const std::string& more = "") {
    return gltf(", \"buffers\": [{\"uri\": \"data:application/octet-stream;base64," + std::string(48, 'A') +
                "\", \"byteLength\": 36}], \"bufferViews\": [{\"buffer\": 0, " + view + "}], \"accessors\": [{" +
                accessor +
                "}], \"nodes\": [{\"mesh\": 0}], \"scenes\": [{\"nodes\": [0]}], \"meshes\": [{\"primitives\": "
                "[{\"attributes\": {\"POSITION\": 0}" +
                more + "}]}]");
  };
  const std::string points = "\"bufferView\": 0, \"componentType\": 5126, \"type\": \"VEC3\", \"count\": ";
  CHECK(read(accessor(points + "3", "\"byteLength\": 36")).geometries.at(0).triangles.size() == 1);
  CHECK_THROWS(Input_error, read(accessor(points + "4", "\"byteLength\": 36")),
               "primitive 0, positions: accessor 0 exceeds its buffer");
  CHECK_THROWS(Input_error, read(accessor(points + "3", "\"byteLength\": 37")), "exceeds its buffer");
  CHECK_THROWS(Input_error, read(accessor(points + "3", "\"byteLength\": 36, \"byteOffset\": 4")),
               "exceeds its buffer");
  CHECK_THROWS(Input_error, read(accessor(points + "3, \"byteOffset\": 4", "\"byteLength\": 36")),
               "exceeds its buffer");
  CHECK_THROWS(Input_error, read(accessor(points + "3", "\"byteLength\": 36, \"byteStride\": 16")),
               "exceeds its buffer");
  CHECK_THROWS(Input_error, read(accessor(points + "4000000000000000", "\"byteLength\": 36")), "accessor 0");
  CHECK_THROWS(Input_error,
               read(accessor("\"bufferView\": 0, \"componentType\": 5126, \"type\": \"VEC2\", \"count\": 3",
                             "\"byteLength\": 36")),
               "2 numbers in an element, not 3");
  const std::string nowhere = "\"bufferView\": 9, \"componentType\": 5126, \"type\": \"VEC3\", \"count\": 3";
  CHECK_THROWS(Input_error, read(accessor(nowhere, "\"byteLength\": 36")), "there is no buffer view 9");
  // of a binary file: tinygltf looks for its first byte
  std::string empty = gltf(", \"buffers\": [{\"byteLength\": 0}]");
  empty.resize((empty.size() + 3) / 4 * 4, ' ');
  const auto size = [](std::size_t n) { return std::string{char(n), char(n >> 8), 0, 0}; };
  CHECK_THROWS(Input_error,
               read("glTF" + size(2) + size(empty.size() + 32) + size(empty.size()) + "JSON" + empty + size(4) +
                    std::string("BIN\0\0\0\0", 8)),
               "bad.gltf: ");
  CHECK_THROWS(Input_error, read(accessor(points + "2", "\"byteLength\": 36")),
               "has 2 corners, which do not make triangles");
  CHECK_THROWS(Input_error, read(accessor(points + "3", "\"byteLength\": 36", ", \"indices\": 7")),
               "accessor out of bounds");
  CHECK_THROWS(Input_error, read(accessor(points + "3", "\"byteLength\": 36", ", \"indices\": 0")),
               "does not hold whole numbers");
}
#endif

#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
void write_dataset(const std::string& file, const std::string& name, std::vector<hsize_t> extent,
                   const std::vector<float>& values)
{
  using IO::internal::Hdf5_handle;
  const bool exists = std::filesystem::exists(file);
  const Hdf5_handle f(exists ? H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)
                             : H5Fcreate(file.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, H5P_DEFAULT),
                      H5Fclose);
  const Hdf5_handle space(H5Screate_simple(int(extent.size()), extent.data(), nullptr), H5Sclose);
  const Hdf5_handle groups(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(groups.id(), 1);
  // faces are whole numbers, as D-FAUST's are
  const hid_t type = extent.size() == 2 ? H5T_STD_U32LE : H5T_IEEE_F32BE;
  const Hdf5_handle d(H5Dcreate2(f.id(), name.c_str(), type, space.id(), groups.id(), H5P_DEFAULT, H5P_DEFAULT),
                      H5Dclose);
  CHECK(H5Dwrite(d.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
}

// Coordinates of triangles that have an area.
std::vector<float> scattered(std::size_t n)
{
  std::vector<float> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(float(i * 7919 % 101));
  return values;
}

// A dataset into which nothing was written, and which takes no place in the file.
void announce_dataset(const std::string& file, const std::string& name, const std::vector<hsize_t>& extent)
{
  using IO::internal::Hdf5_handle;
  const Hdf5_handle f(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  const Hdf5_handle space(H5Screate_simple(int(extent.size()), extent.data(), nullptr), H5Sclose);
  const Hdf5_handle d(H5Dcreate2(f.id(), name.c_str(), H5T_STD_I8LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                      H5Dclose);
  CHECK(d.is_open());
}

// What a file announces and does not hold is refused before memory is taken for it; other files are left alone.
void test_hdf5_content()
{
  const Temporary_folder folder;
  const std::string file = folder.path("hollow.h5"), other = folder.path("other.h5");
  write_dataset(file, "faces", {1, 3}, {0, 1, 2});
  write_dataset(file, "walk", {3, 3, 4}, scattered(36));
  announce_dataset(file, "vast", {hsize_t(1) << 59, 3});
  announce_dataset(file, "no faces", {0, 3});
  announce_dataset(file, "nothing", {3, 3, 4});
  announce_dataset(file, "long", {3, 3, hsize_t(1) << 40});
  announce_dataset(file, "no vertices", {0, 3, 4});
  CHECK(IO::read_hdf5<double>(file, "walk").frames == 4);
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "walk", "vast"), "dataset vast has no content");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "walk", "no faces"), "dataset no faces has no triangles");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "nothing"), "dataset nothing has no content");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "long"), "dataset long has no content");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "no vertices"), "dataset no vertices is 0 x 3 x 4, neither");

  write_dataset(other, "walk", {3, 3, 4}, scattered(36));
  {
    using IO::internal::Hdf5_handle;
    const Hdf5_handle f(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    CHECK(H5Lcreate_external(other.c_str(), "walk", f.id(), "elsewhere", H5P_DEFAULT, H5P_DEFAULT) >= 0);
    const Hdf5_handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    CHECK(H5Pset_external(how.id(), other.c_str(), 0, 36) >= 0);
    const hsize_t extent[] = {3, 3, 4};
    const Hdf5_handle space(H5Screate_simple(3, extent, nullptr), H5Sclose);
    const Hdf5_handle d(H5Dcreate2(f.id(), "outside", H5T_STD_I8LE, space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT),
                        H5Dclose);
    CHECK(d.is_open());
  }
  CHECK_THROWS(Option_error, IO::read_hdf5<double>(file, "elsewhere"), "there is no clip");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "outside"), "dataset outside keeps its numbers in other files");
}

void test_hdf5()
{
  const Temporary_folder folder;
  const std::string file = folder.path("bodies.h5");
  const std::size_t n = 5, frames = 7;
  const auto x = [](std::size_t v, std::size_t k, std::size_t f) { return float(v + v * v * k + 100 * k + 1000 * f); };
  std::vector<float> by_vertex, by_frame;
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t f = 0; f < frames; ++f) by_vertex.push_back(x(v, k, f));
  for (std::size_t f = 0; f < frames; ++f)
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t k = 0; k < 3; ++k) by_frame.push_back(x(v, k, f));
  write_dataset(file, "50002_punching", {n, 3, frames}, by_vertex);
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file), "has no dataset \"faces\"");
  write_dataset(file, "faces", {2, 3}, {0, 1, 2, 2, 1, 4});
  write_dataset(file, "group/walking", {frames, n, 3}, by_frame);
  write_dataset(file, "short", {4, 3, frames}, std::vector<float>(12 * frames));
  write_dataset(file, "doubtful", {5, 5, 3}, scattered(75));
  write_dataset(file, "unclear", {6, 3, 3}, scattered(54));
  write_dataset(file, "bad", {n, 3, 2}, std::vector<float>(30, std::numeric_limits<float>::quiet_NaN()));
  write_dataset(file, "one", {n, 3, 1}, std::vector<float>(15));
  write_dataset(file, "other faces", {1, 3}, {0, 1, 2});
  write_dataset(file, "triples", {3, 3, 3}, std::vector<float>(27));

  std::size_t told_vertices = 0, told_frames = 0;
  const auto memory = std::make_shared<Recording_memory>();
  const auto choose = [&](std::size_t v, std::size_t f) {
    told_vertices = v, told_frames = f;
    return memory;
  };
  for (const char* name : {"", "50002_punching", "group/walking"}) {
    const auto data = IO::read_hdf5<double>(file, name, "faces", choose);
    CHECK(data.x.memory() == memory && data.y.memory() == memory && data.z.memory() == memory);
    CHECK(told_vertices == n && told_frames == frames && data.frames == frames);
    CHECK((data.mesh.triangles == Triangles{{{0, 1, 2}}, {{2, 1, 4}}}) && data.mesh.points.size() == n);
    CHECK(data.origins.empty());
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t f = 0; f < frames; ++f)
        CHECK(data.x(v, f) == x(v, 0, f) && data.y(v, f) == x(v, 1, f) && data.z(v, f) == x(v, 2, f));
  }
  // faces from 1, as those of MATLAB: the largest is the number of vertices
  write_dataset(file, "faces of MATLAB", {2, 3}, {1, 2, 3, 3, 2, 5});
  const auto from_one = IO::read_hdf5<double>(file, "", "faces of MATLAB");
  CHECK((from_one.mesh.triangles == Triangles{{{0, 1, 2}}, {{2, 1, 4}}}) && from_one.notices.size() == 1);
  CHECK(from_one.notices[0].find("count vertices from 1") != std::string::npos);
  // the first sequence that has the vertices of the faces
  write_dataset(file, "faces of six", {2, 3}, {0, 1, 2, 2, 1, 5});
  const auto fitting = IO::read_hdf5<double>(file, "", "faces of six");
  CHECK(fitting.clips[fitting.clip] == "unclear" && fitting.notices.empty());
  const auto by_number = IO::read_hdf5<float>(file, "3");
  CHECK(by_number.clip == 3 && by_number.clips[3] == "group/walking" && by_number.frames == frames);
  CHECK_THROWS(Option_error, IO::read_hdf5<double>(file, "swimming"), "there is no clip \"swimming\"");
  CHECK_THROWS(Option_error, IO::read_hdf5<double>(file, "swimming"), "0 \"50002_punching\"");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "short"), "dataset short is 4 x 3 x 7, neither");
  CHECK(IO::read_hdf5<double>(file, "doubtful").frames == 5); // 5 x 5 x 3 can be read in one way only
  CHECK(IO::read_hdf5<double>(file, "unclear").mesh.points.size() == 6);
  // frames that cannot be true
  write_dataset(file, "empty", {n, 3, frames}, std::vector<float>(3 * n * frames));
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "empty"), "bodies.h5, frame 0: has no extent");
  for (std::size_t i = 0; i < 3 * n; ++i) by_vertex[i * frames] = 0;
  write_dataset(file, "late", {n, 3, frames}, by_vertex);
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "late"), "bodies.h5, frame 0: has no extent");
  IO::Mesh_reading_options skip;
  skip.skip_bad_frames = true;
  const auto late = IO::read_hdf5<double>(file, "late", "faces", IO::Memory_chooser(), skip);
  CHECK(late.y(3, 0) == x(3, 1, 1) && late.mesh.points[3][1] == x(3, 1, 1) && late.notices.size() == 1);
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "triples", "other faces"), "would be possible");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "bad"), "dataset bad, frame 0, vertex 0");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "one"), "one frame");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(file, "", "triples"), "not triangles x 3");
  CHECK_THROWS(Input_error, IO::read_hdf5<double>(folder.write("text.h5", "text")),
               "text.h5: is no readable HDF5 file");
}
#endif

#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
// A file for the program: a sheet of 20 x 20 vertices on which a bump rises and falls, in 30 frames.
int write_sheet(const std::string& file)
{
  const std::size_t n = 20, frames = 30;
  std::vector<float> positions, faces;
  for (std::size_t v = 0; v < n * n; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t f = 0; f < frames; ++f) {
        const double x = double(v % n) - 9.5, y = double(v / n) - 9.5, t = double(f) - 14.5;
        positions.push_back(float(k == 0 ? x : k == 1 ? y : 5 * std::exp(-(x * x + y * y) / 8 - t * t / 18)));
      }
  for (std::size_t v = 0; v < n * n; ++v)
    if (v % n + 1 < n && v / n + 1 < n)
      for (std::size_t c : {v, v + 1, v + n, v + 1, v + n + 1, v + n}) faces.push_back(float(c));
  write_dataset(file, "50002_sheet", {n * n, 3, frames}, positions);
  write_dataset(file, "triangles", {faces.size() / 3, 3}, faces);
  return failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
#endif

#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
// Debian's models for testing assimp (package assimp-testmodels, BSD-3-clause).
void test_assimp()
{
  const Temporary_folder folder;
  CHECK_THROWS(Input_error, IO::read_assimp(folder.write("text.fbx", "text")),
               "text.fbx: cannot be read through assimp");
  const std::string models = "/usr/share/assimp/models/";
  if (!std::filesystem::exists(models + "FBX/animation_with_skeleton.fbx")) {
    std::cout << "SKIPPED: FBX and X, since Debian's package assimp-testmodels is not here" << std::endl;
    return;
  }
  const auto fbx = IO::sample_clip<double>(IO::read_assimp(models + "FBX/animation_with_skeleton.fbx"), {}, "fbx");
  CHECK(fbx.frames == 61 && fbx.mesh.points.size() == 1058 && fbx.mesh.triangles.size() == 2112 &&
        fbx.clips.size() == 1);
  CHECK_NEAR(fbx.times.back(), 0.8333, 1e-4);
  CHECK(CGAL::is_closed(IO::to_surface_mesh(fbx.mesh, "fbx")));

  const auto x = IO::sample_clip<double>(IO::read_assimp(models + "X/BCN_Epileptic.X"), {}, "x");
  CHECK(x.mesh.points.size() == 2633 && x.origins.parts.size() == 3 && x.frames == 100);
  auto surface = IO::to_surface_mesh(x.mesh, "x");
  std::size_t borders = 0;
  for (auto h : halfedges(surface)) borders += is_border(h, surface) ? 1 : 0;
  CHECK(borders == 130);
  auto component = surface.add_property_map<decltype(surface)::Face_index, std::size_t>("f:component").first;
  // Head, torso and legs meet to six decimals only, which is not coincidence; in the head are eyes and a mouth.
  CHECK_NEAR(CGAL::Polygon_mesh_processing::connected_components(surface, component), 6, 0);
}
#endif

Model read_model(const std::string& file)
{
  const std::string ending = std::filesystem::path(file).extension().string();
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  if (ending == ".gltf" || ending == ".glb") return IO::read_gltf(file);
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
  if (ending != ".gltf" && ending != ".glb") return IO::read_assimp(file);
#endif
  throw Input_error(file + ": no library for files " + ending);
}

int dump(const std::string& file, const std::string& clip, const std::string& frames, const std::string& to)
{
  IO::Clip_sampling sampling;
  sampling.clip = clip;
  sampling.frames = std::stoul(frames);
  const auto data = IO::sample_clip<double>(read_model(file), sampling, file);
  std::ofstream map(to + ".csv"), numbers(to + ".bin", std::ios::binary);
  IO::write_vertex_map(map, data.origins, data.mesh.points.size());
  const auto write = [&](auto x) { numbers.write(reinterpret_cast<const char*>(&x), sizeof(x)); };
  write(std::uint64_t(data.frames));
  write(std::uint64_t(data.mesh.points.size()));
  write(std::uint64_t(data.mesh.triangles.size()));
  for (const auto& triangle : data.mesh.triangles)
    for (std::size_t v : triangle) write(std::uint64_t(v));
  for (double t : data.times) write(t);
  for (std::size_t f = 0; f < data.frames; ++f)
    for (std::size_t v = 0; v < data.mesh.points.size(); ++v) {
      write(data.x(v, f));
      write(data.y(v, f));
      write(data.z(v, f));
    }
  numbers.close();
  return numbers ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc > 1) {
    try {
      if (argc == 6 && argv[1] == std::string("dump")) return dump(argv[2], argv[3], argv[4], argv[5]);
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
      if (argc == 3 && argv[1] == std::string("sheet")) return write_sheet(argv[2]);
#endif
    } catch (const std::exception& e) {
      std::cerr << e.what() << std::endl;
    }
    return EXIT_FAILURE;
  }
  use_hostile_locale();
  test_tracks();
  test_evaluation_errors();
  test_sampling();
  test_sampled_clip();
  test_coincidence();
  test_welding();
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  test_angles_of_character();
  test_bad_gltf();
  test_linked_files();
  test_swollen_gltf();
  test_binary_gltf();
#else
  std::cout << "SKIPPED: glTF, since tinygltf is not here" << std::endl;
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_HDF5
  test_hdf5();
  test_hdf5_content();
#else
  std::cout << "SKIPPED: HDF5, since its library is not here" << std::endl;
#endif
#ifdef ANIMATED_MESH_FEATURES_WITH_ASSIMP
  test_assimp();
#else
  std::cout << "SKIPPED: FBX and X, since assimp is not here" << std::endl;
#endif
  return test_result();
}
