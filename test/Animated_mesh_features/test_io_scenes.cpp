// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Scenes: when features live, folders of results, what does not fit; in any locale. What is in the files is tested by
// test_write_*.sh, with the programs that read them.

#include "test_io_support.h"

#include "scenes/Shown_scene.h"
#include "scenes/feature_in_frame.h"
#include "scenes/write_glb.h"
#include "scenes/write_vtk.h"

#include <CGAL/Animated_mesh_features/IO/Output_folder.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Animated_mesh_features;
using namespace test_support;

namespace {

typedef Programs::Shown_sequence Sequence;
typedef Programs::Shown_feature Feature;
typedef Programs::Shown_scene Scene;
typedef Programs::Shown_values Values;
typedef Sequence::Triangle_mesh Mesh;
typedef Sequence::Point_3 Point;

// Two triangles, of which vertex 3 rises; vertex 4 belongs to none.
struct Flap
{
  Mesh mesh;
  std::vector<std::vector<Point>> frames;
  std::vector<Feature> features;

  explicit Flap(double size = 1)
  {
    for (const Point& p : {Point(0, 0, 0), Point(size, 0, 0), Point(0, size, 0), Point(size, size, 0), Point(5, 5, 5)})
      mesh.add_vertex(p);
    const auto v = [](unsigned i) { return Mesh::Vertex_index(i); };
    mesh.add_face(v(0), v(1), v(2));
    mesh.add_face(v(1), v(3), v(2));
    for (int f = 0; f < 20; ++f) {
      frames.emplace_back();
      for (auto u : mesh.vertices()) frames.back().push_back(mesh.point(u));
      frames.back()[3] = Point(size, size, size * f);
    }
    Feature feature;
    feature.vertex = v(3);
    feature.vertex_index = 3;
    feature.frame = 10;
    feature.time = 1.04;
    feature.triangle = {{3, 2, 1}};
    feature.barycentric_coordinates = {{0.5, 0.25, 0.25}};
    feature.sigma = 0.5;
    feature.tau = 0.2;
    feature.strength = 0.3;
    features.push_back(feature);
  }

  Sequence sequence() const { return Sequence(mesh, frames, 0.1); }
};

void test_features_in_frames()
{
  const Flap flap;
  const Sequence sequence = flap.sequence();
  Feature f = flap.features[0];
  // within 0.4 s of 1.04 s
  for (std::size_t frame = 0; frame < 20; ++frame) {
    CHECK(Programs::lives_in_frame(f, frame, 0.1) == (frame >= 7 && frame <= 14));
    const double expected =
        frame >= 7 && frame <= 14 ? std::exp(-std::pow((0.1 * double(frame) - 1.04) / 0.2, 2) / 2) : 0;
    CHECK_NEAR(Programs::opacity_in_frame(f, frame, 0.1), expected, 1e-12);
  }
  // in a cyclic animation of 1.2 s across the end
  for (std::size_t frame = 0; frame < 12; ++frame) {
    CHECK(Programs::lives_in_frame(f, frame, 0.1, 1.2) == (frame <= 2 || frame >= 7));
    const double away = std::abs(0.1 * double(frame) - 1.04), shorter = (std::min)(away, 1.2 - away);
    const double expected = frame <= 2 || frame >= 7 ? std::exp(-shorter * shorter / (2 * 0.2 * 0.2)) : 0;
    CHECK_NEAR(Programs::opacity_in_frame(f, frame, 0.1, 1.2), expected, 1e-12);
  }
  // shorter than the time between frames
  f.tau = 0.001;
  CHECK(Programs::lives_in_frame(f, 10, 0.1) && !Programs::lives_in_frame(f, 9, 0.1) &&
        !Programs::lives_in_frame(f, 11, 0.1));
  f.tau = 0;
  CHECK_NEAR(Programs::opacity_in_frame(f, 10, 0.1), 1, 0);
  CHECK_NEAR(Programs::opacity_in_frame(f, 11, 0.1), 0, 0);
  const std::array<double, 3> p = Programs::position_in_frame(sequence, f, 8);
  CHECK_NEAR(p[0], 0.75, 1e-12);
  CHECK_NEAR(p[1], 0.75, 1e-12);
  CHECK_NEAR(p[2], 4, 1e-12);
}

std::string glb(const Scene& scene)
{
  std::ostringstream os; // has the hostile locale
  Programs::write_glb(os, scene);
  return os.str();
}

void test_checks()
{
  const Flap flap;
  const Sequence sequence = flap.sequence();
  Values small(5, 19), field(5, 20);
  const Scene good{sequence, flap.features, {{"a", &field}}, "title"};
  CHECK(good.field("a") == &field && good.field("b") == nullptr);
  CHECK(glb(good).size() > 1000);
  CHECK_THROWS(Option_error, glb({sequence, flap.features, {{"a", &small}}, ""}), "5 x 19");
  field(2, 7) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS(Input_error, glb(good), "frame 7");
  CHECK_THROWS(Input_error, glb(good), "vertex 2");
  field(2, 7) = 1e200;
  CHECK_THROWS(Output_error, glb(good), "single precision");

  std::vector<Feature> features = flap.features;
  features.push_back(features[0]);
  features[1].vertex_index = 5;
  const Scene bad{sequence, features, {}, ""};
  CHECK_THROWS(Input_error, glb(bad), "feature 1 has the vertex 5");
  features[1].vertex_index = 3;
  features[1].triangle[2] = 7;
  CHECK_THROWS(Input_error, glb(bad), "vertex 7");
  features[1].triangle[2] = 0;
  features[1].frame = 20;
  CHECK_THROWS(Input_error, glb(bad), "frame 20");
}

void test_text_of_files()
{
  const Flap flap;
  const Sequence sequence = flap.sequence();
  const std::string title = "a <b> & \"c\" \x01\xff";
  const Scene scene{sequence, flap.features, {}, title};
  CHECK(glb(scene).find("\"name\":\"a <b> & \\\"c\\\" \\u0001\xef\xbf\xbd\"") != std::string::npos);
  CHECK(glb(scene).find("\"frame_duration\":0.1}") != std::string::npos);
}

void test_vtk_folder()
{
  const Temporary_folder folder;
  const Flap flap;
  const Sequence sequence = flap.sequence();
  Values field(5, 20);
  const std::vector<Feature> none;
  const Scene scene{sequence, none, {{"a <field> & \"b\" \x01\xff", &field}}, ""};
  {
    IO::Output_folder output(folder.path("new"));
    Programs::write_vtk(output, scene);
    CHECK(!std::filesystem::exists(folder.path("new")));
    output.commit();
  }
  CHECK(folder.number_of_entries() == 1);
  CHECK(folder.read("new/surface_0019.vtp")
            .find("Name=\"a &lt;field&gt; &amp; &quot;b&quot; \xef\xbf\xbd\xef\xbf\xbd\"") != std::string::npos);
  CHECK(folder.read("new/show_in_paraview.py").find("\"a <field> & \\\"b\\\" \\ufffd\\ufffd\"") != std::string::npos);
  CHECK(folder.read("new/features_0003.vtp").find("NumberOfPoints=\"0\"") != std::string::npos);
  CHECK(folder.read("new/surface.pvd").find("timestep=\"0.5\"") != std::string::npos);

  // What is thrown midway leaves nothing.
  field(0, 17) = 1e200;
  CHECK_THROWS(
      Output_error,
      [&] {
        IO::Output_folder output(folder.path("other"));
        Programs::write_vtk(output, scene);
      }(),
      "frame 17");
  CHECK(folder.number_of_entries() == 1);
  CHECK(Programs::vtp_name("surface", 7, 123456) == "surface_000007.vtp");
}

void put(IO::Output_folder& output, const std::string& file, const std::string& text)
{
  output.write(file, [&](std::ostream& os) { os << text; });
}

void test_output_folder()
{
  const Temporary_folder folder;
  {
    IO::Output_folder output(folder.path("a") + "/");
    put(output, "1", "first");
    CHECK(folder.number_of_entries() == 1); // the temporary one
    output.commit();
  }
  CHECK(folder.read("a/1") == "first");
  folder.write("a/mine", "mine");
  for (bool is_committed : {false, true}) {
    {
      IO::Output_folder output(folder.path("a"));
      put(output, "1", "second");
      put(output, "2", "new");
      if (is_committed) output.commit();
    }
    CHECK(folder.read("a/1") == (is_committed ? "second" : "first"));
    CHECK(folder.read("a/2") == (is_committed ? "new" : ""));
    CHECK(folder.read("a/mine") == "mine");
    CHECK(std::size_t(std::distance(std::filesystem::directory_iterator(folder.path("a")),
                                    std::filesystem::directory_iterator())) == (is_committed ? 3u : 2u));
  }
  CHECK(folder.number_of_entries() == 1);
  CHECK_THROWS(Output_error, IO::Output_folder(folder.path("nowhere/a")), "nowhere/a: cannot write");
  CHECK_THROWS(Output_error, IO::Output_folder(folder.path("a/1")), "a/1: cannot write");
  CHECK(folder.number_of_entries() == 1);
  // a message names the place to which the file would have come
  folder.write("a/sub/file", "");
  CHECK_THROWS(
      Output_error,
      [&] {
        IO::Output_folder output(folder.path("a"));
        output.write("x", [](std::ostream& os) { os.setstate(std::ios::badbit); });
      }(),
      folder.path("a/x"));
}

// Two processes that both found no folder of that name.
void test_two_into_one_new_folder()
{
  const Temporary_folder folder;
  IO::Output_folder first(folder.path("a")), second(folder.path("a"), IO::Output_sync::NEVER);
  put(first, "1", "first");
  put(first, "2", "first");
  put(second, "1", "second");
  put(second, "3", "second");
  first.commit();
  CHECK(folder.read("a/1") == "first" && folder.read("a/2") == "first");
  second.commit();
  CHECK(folder.read("a/1") == "second" && folder.read("a/2") == "first" && folder.read("a/3") == "second");
  CHECK(folder.number_of_entries() == 1);
  // what a killed process has left, within the folder and beside it
  folder.write("a/.a.5.tmp/1", "left");
  folder.write(".a.6.tmp/1", "left");
  {
    IO::Output_folder third(folder.path("a"));
    put(third, "1", "third");
    IO::Output_folder fourth(folder.path("a")); // leaves the third alone
    third.commit();
  }
  CHECK(folder.read("a/1") == "third" && folder.number_of_entries() == 1);
  CHECK(!std::filesystem::exists(folder.path("a/.a.5.tmp")));
}

} // namespace

int main()
{
  use_hostile_locale();
  test_features_in_frames();
  test_checks();
  test_text_of_files();
  test_vtk_folder();
  test_output_folder();
  test_two_into_one_new_folder();
  return test_result();
}
