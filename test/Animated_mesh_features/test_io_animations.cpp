// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Animations in and out: point caches, sequences of meshes, and what is said about those that do not fit.

#include "test_io_support.h"
#include "test_recording_memory.h"

#include <CGAL/Animated_mesh_features/IO/Point_cache_reader.h>
#include <CGAL/Animated_mesh_features/IO/frame_files_in_folder.h>
#include <CGAL/Animated_mesh_features/IO/natural_order.h>
#include <CGAL/Animated_mesh_features/IO/numbered_series.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#ifdef __unix__
  #include <sys/stat.h>
  #include <thread>
#endif

using namespace CGAL::Animated_mesh_features;
using namespace test_support;

namespace {

const Temporary_folder folder;

// A number that tells frame, vertex and coordinate, exact in single precision; three vertices make a triangle.
float value(std::size_t frame, std::size_t vertex, std::size_t coordinate)
{
  return float(frame) * 16 + float(vertex + vertex * vertex * coordinate) + float(coordinate) / 4;
}

const auto frame_of_3 = [](std::size_t f, float* xyz) {
  for (std::size_t i = 0; i < 9; ++i) xyz[i] = value(f, i / 3, i % 3);
};

std::string pc2(std::size_t frames = 2)
{
  std::ostringstream os;
  IO::write_pc2(os, 3, frames, frame_of_3, 5, 0.5);
  return os.str();
}

std::string mdd(const std::vector<float>& times)
{
  std::ostringstream os;
  IO::write_mdd(os, 3, times, frame_of_3);
  return os.str();
}

// The text of an OBJ file for frame `f` of the same animation.
std::string obj(std::size_t f, const std::string& faces = "f 1 2 3\n")
{
  IO::Indexed_mesh mesh;
  for (std::size_t v = 0; v < 3; ++v) mesh.points.push_back({{value(f, v, 0), value(f, v, 1), value(f, v, 2)}});
  std::ostringstream os;
  IO::write_obj(os, mesh);
  return os.str() + faces;
}

void test_bytes()
{
  std::string expected = std::string("POINTCACHE2\0", 12) + little_endian(1u) + little_endian(3u) + little_endian(5.f) +
                         little_endian(0.5f) + little_endian(2u);
  std::string expected_mdd = big_endian(2u) + big_endian(3u) + big_endian(0.25f) + big_endian(0.75f);
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t i = 0; i < 9; ++i) {
      expected += little_endian(value(f, i / 3, i % 3));
      expected_mdd += big_endian(value(f, i / 3, i % 3));
    }
  CHECK(pc2() == expected);
  CHECK(pc2().substr(12, 8) == std::string("\1\0\0\0\3\0\0\0", 8));
  CHECK(mdd({0.25f, 0.75f}) == expected_mdd);
  CHECK(mdd({0.25f, 0.75f}).substr(0, 8) == std::string("\0\0\0\2\0\0\0\3", 8));

  std::ostringstream os;
  const std::size_t many = std::size_t(1) << 31;
  CHECK_THROWS(Output_error, IO::write_pc2(os, many, 1, frame_of_3), "cannot hold 2147483648 points");
  CHECK_THROWS(Output_error, IO::write_pc2(os, 1, many, frame_of_3), "cannot hold 2147483648 frames");
}

std::size_t number_of_right_values(IO::Point_cache_reader& cache)
{
  std::size_t n = 0, next = 0;
  cache.read_frames([&](std::size_t f, const float* xyz) {
    for (std::size_t i = 0; i < 9; ++i) n += f == next && xyz[i] == value(f, i / 3, i % 3);
    ++next;
  });
  return n;
}

void test_caches()
{
  IO::Point_cache_reader a(folder.write("a.pc2", pc2(7)));
  CHECK(a.number_of_points() == 3 && a.number_of_frames() == 7 && a.times().empty());
  CHECK(a.start_frame() == 5 && a.sample_rate() == 0.5);
  CHECK(number_of_right_values(a) == 63);
  IO::Point_cache_reader b(folder.write("b.MDD", mdd({0, 0.25f, 1})));
  CHECK(b.number_of_points() == 3 && b.number_of_frames() == 3);
  CHECK((b.times() == std::vector<double>{0, 0.25, 1}));
  CHECK(number_of_right_values(b) == 27);
  CHECK_THROWS(Input_error, b.check_number_of_points(4, "cow.obj"),
               folder.path("b.MDD") + ": has 3 points, but the mesh cow.obj has 4 vertices");
  b.check_number_of_points(3, "cow.obj");

  const auto error = [](const std::string& name, const std::string& content, const std::string& message) {
    const auto read = [&] {
      IO::Point_cache_reader cache(folder.write(name, content));
      cache.read_frames([](std::size_t, const float*) {});
    };
    CHECK_THROWS(Input_error, read(), folder.path(name) + message);
  };
  const std::string p = pc2(), m = mdd({0, 1});
  error("x.pc2", "", ": is empty");
  error("x.pc2", p.substr(0, 31), ": ends within the header");
  error("x.pc2", p.substr(0, 32),
        ": 3 points in 2 frames take 104 bytes, the file has 32: it is cut off after 0 whole frames");
  error("x.pc2", p.substr(0, 103),
        ": 3 points in 2 frames take 104 bytes, the file has 103: it is cut off after 1 whole frames");
  error("x.pc2", p + "ab", ": 3 points in 2 frames take 104 bytes, the file has 106: 2 too many");
  error("x.pc2", "POINTCACHE3" + p.substr(11), ": is no PC2 file");
  error("x.pc2", p.substr(0, 12) + little_endian(2u) + p.substr(16), ": is a PC2 file of version 2");
  error("x.pc2", p.substr(0, 16) + little_endian(0u) + p.substr(20), ": the header announces 0 points");
  error("x.pc2", p.substr(0, 28) + little_endian(0xffffffffu) + p.substr(32), ": the header announces -1 frames");
  // A header that asks for 2^63 bytes must neither overflow nor allocate.
  error("x.pc2", p.substr(0, 16) + little_endian(0x7fffffffu) + p.substr(20, 8) + little_endian(0x7fffffffu),
        ": 2147483647 points in 2147483647 frames take 18446744073709551615 bytes, the file has 32: it is cut off "
        "after 0");
  error("x.pc2", p.substr(0, 32 + 36 + 16) + little_endian(0x7f800000u) + p.substr(32 + 36 + 20),
        ": frame 1, vertex 1: the position is not finite");
  error("x.pc2", p.substr(0, 32 + 68) + little_endian(0xffc00001u) + p.substr(32 + 72),
        ": frame 1, vertex 2: the position");
  error("x.mdd", p, ": is no MDD file: this is a PC2 file, whose name should end in .pc2");
  error("x.pc2", m, ": is no PC2 file: it does not start with POINTCACHE2; this is an MDD file, whose name should end");
  error("x.mdd", m.substr(0, 7), ": ends within the header");
  error("x.mdd", m.substr(0, 15), ": 3 points in 2 frames take 88 bytes, the file has 15: it is cut off after 0 whole");
  error("x.mdd", m.substr(0, 87), ": 3 points in 2 frames take 88 bytes, the file has 87: it is cut off after 1 whole");
  error("x.mdd", m + "x", ": 3 points in 2 frames take 88 bytes, the file has 89: 1 too many");
  error("x.mdd", m.substr(0, 12) + big_endian(0x7fc00000u) + m.substr(16), ": frame 1: the time is not finite");
  error("x.mdd", m.substr(0, 84) + big_endian(0x7fc00000u), ": frame 1, vertex 2: the position is not finite");
  error("x.abc", m, ": unknown kind of point cache \".abc\"");
  CHECK_THROWS(Input_error, IO::Point_cache_reader(folder.path("none.pc2")), ": cannot read: No such file");
}

// The size of a pipe is not known before it has been read.
void test_pipe()
{
#ifdef __unix__
  const std::string path = folder.path("pipe.pc2");
  CHECK(mkfifo(path.c_str(), 0600) == 0);
  const auto read = [&](const std::string& content) {
    std::thread writer([&] { std::ofstream(path, std::ios::binary) << content; });
    std::size_t n = 0;
    std::string message;
    try {
      IO::Point_cache_reader cache(path);
      n = number_of_right_values(cache);
    } catch (const Input_error& e) {
      message = e.what();
    }
    writer.join();
    return std::to_string(n) + message.substr((std::min)(message.size(), path.size()));
  };
  CHECK(read(pc2()) == "18");
  CHECK(read(pc2().substr(0, 100)) ==
        "0: 3 points in 2 frames take 104 bytes, the file has 100: it is cut off after 1 whole frames");
  CHECK(read(pc2() + "x") == "0: goes on after the last frame");
#endif
}

void test_natural_order()
{
  const std::vector<std::string> sorted = {"",
                                           "-1",
                                           "0",
                                           "00",
                                           "1",
                                           "01",
                                           "001",
                                           "1.obj",
                                           "2",
                                           "10",
                                           "10a2",
                                           "10a10",
                                           "99999999999999999999998",
                                           "99999999999999999999999",
                                           "100000000000000000000000",
                                           "A1",
                                           "a",
                                           "a0",
                                           "a1",
                                           "a01",
                                           "a1_01",
                                           "a01_1",
                                           "a1b",
                                           "a2",
                                           "a09",
                                           "a10",
                                           "a10b",
                                           "aa",
                                           "b2/w1",
                                           "b2/w10",
                                           "b10/w2",
                                           "\xc3\xa4"};
  bool good = true;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = 0; j < sorted.size(); ++j)
      if (IO::natural_order(sorted[i], sorted[j]) != (i < j)) {
        report(false, __FILE__, __LINE__, "natural_order(\"" + sorted[i] + "\", \"" + sorted[j] + "\")");
        good = false;
      }
  CHECK(good);
}

typedef std::vector<std::string> Names;

// Names that are in order already are put in order whatever order they come in.
void check_series(const Names& names, const std::string& reading = "")
{
  Names shuffled = names;
  std::sort(shuffled.begin(), shuffled.end());
  std::reverse(shuffled.begin(), shuffled.end());
  try {
    const IO::Numbered_series series = IO::numbered_series(shuffled, false);
    report(series.files == names && series.others.empty() && series.reading == reading, __FILE__, __LINE__,
           names[0] + ", " + names[1] + "...: " + series.files[0] + " is first, as " + series.reading);
  } catch (const Input_error& e) {
    report(false, __FILE__, __LINE__, e.what());
  }
}

void test_numbered_series()
{
  Names unpadded, versions, hundredths;
  for (int i = 1; i <= 12; ++i) {
    unpadded.push_back("walk" + std::to_string(i) + ".obj");
    versions.push_back("v2." + std::to_string(i) + ".obj");
    hundredths.push_back("t" + std::to_string(i * 25 / 100) + "." + std::to_string(i * 25 % 100) + ".obj");
  }
  check_series(unpadded);
  check_series(versions);                      // 2.1 and 2.10 are one decimal number
  check_series(hundredths, "decimal numbers"); // .25, .50, .75, 1.0
  check_series({"walk_008.obj", "walk_009.OBJ", "Walk_010.obj"});
  check_series({"998.obj", "999.obj", "1000.obj"});
  check_series({"f01.obj", "f2.obj", "f03.obj"});
  check_series({"f0.obj", "f5.obj", "f10.obj"});              // every fifth
  check_series({"f0.obj", "f33.obj", "f67.obj", "f100.obj"}); // milliseconds
  check_series({"3.9.obj", "3.10.obj", "3.11.obj"});
  check_series({"seq7/a1.obj", "seq7/a2.obj", "./seq7/a3.obj"});
  check_series({"frame1/mesh.obj", "frame2/mesh.obj", "frame10/../frame3/mesh.obj"});
  check_series({"a1_f1.obj", "a1_f2.obj", "a2_f3.obj"}); // the second number counts
  // signs, or hyphens
  check_series({"sim-2.obj", "sim-1.obj", "sim0.obj", "sim1.obj"}, "numbers with signs");
  check_series({"sim-8.obj", "sim-9.obj", "sim-10.obj"});
  check_series({"sim.-0010.obj", "sim.-0005.obj", "sim.0000.obj"}, "numbers with signs");
  check_series({"x--1.obj", "x-0.obj", "x-1.obj"}, "numbers with signs");
  check_series({"x-1.obj", "x+0.obj", "x+1.obj"}, "numbers with signs");
  // fractions and exponents
  check_series({"t0.obj", "t0.5.obj", "t1.obj", "t1.5.obj"}, "decimal numbers");
  check_series({"t0,8.obj", "t0,9.obj", "t1,0.obj"}, "decimal numbers");
  check_series({"t-0.5.obj", "t0.0.obj", "t0.5.obj"}, "decimal numbers");
  check_series({"t0.0333333.obj", "t0.0666667.obj", "t0.1.obj", "t0.133333.obj"}, "decimal numbers");
  check_series({"t5e-3.obj", "t1e-2.obj", "t1.5e-2.obj", "t0.02.obj"}, "numbers with exponents");
  // dates
  check_series({"2023-12-31.obj", "2024-01-01.obj", "2024-01-02.obj"}, "dates (year, month, day)");
  check_series({"20240228.obj", "20240229.obj", "20240301.obj"}, "dates (year, month, day)");
  check_series({"29.02.2024.obj", "01.03.2024.obj", "02.03.2024.obj"}, "dates (day, month, year)");
  check_series({"12-31-2023.obj", "01-01-2024.obj", "01-02-2024.obj"}, "dates (month, day, year)");
  check_series({"scan_20231231_235959.obj", "scan_20240101_000000.obj", "scan_20240101_000001.obj"},
               "dates (year, month, day)");
  check_series({"2024-01-31T23-59-30_f.obj", "2024-02-01T00-00-00_f.obj", "2024-02-01T00-00-30_f.obj"},
               "dates (year, month, day)");
  check_series({"2024-01-31_f9.obj", "2024-01-31_f10.obj"});
}

void test_no_series()
{
  const auto error = [](const Names& names, const std::string& message) {
    CHECK_THROWS(Input_error, IO::numbered_series(names, false), message);
  };
  error({"f1.obj", "f2.obj", "f6.obj", "f7.obj"}, "f6.obj: follows f2.obj, but 3 of the series are missing between");
  error({"f1.obj", "f2.obj", "f4.obj", "f5.obj"}, "f4.obj: follows f2.obj, but 1 of the series is missing between");
  error({"f-2.obj", "f-1.obj", "f1.obj", "f2.obj"}, "f1.obj: follows f-1.obj, but 1 of the series is missing");
  error({"t0.25.obj", "t0.5.obj", "t1.0.obj", "t1.25.obj"}, "t1.0.obj: follows t0.5.obj, but 1 of the series is");
  error({"f0.obj", "f10.obj", "f20.obj", "f34.obj"}, "f34.obj: follows f20.obj at another distance than most");
  error({"f1.obj", "f01.obj", "f2.obj"}, "f01.obj: has the same number as f1.obj: a copy, or the frame of another");
  error({"f1.obj", "f2.obj", "f2.ply"}, "f2.ply: has the same number as f2.obj");
  error({"f1.obj", "f2.obj", "f1.obj"}, "f1.obj: is given twice");
  error({"a1_f1.obj", "a1_f2.obj", "a2_f1.obj", "a2_f2.obj"}, "a2_f1.obj: has the same number as a1_f1.obj");
  error({"a1.obj", "a2.obj", "b1.obj", "b2.obj", "b3.obj"},
        "a1.obj: is one of 2 files of another series than the series of b1.obj (3 files)");
  error({"f0.obj", "f1.obj", "f2.obj", "f1 (1).obj"}, "f1 (1).obj: its name does not belong to the series of f0.obj");
  error({"a.obj", "b.obj", "c.obj"}, "b.obj: its name does not belong to the series of a.obj (1 file); if the names do "
                                     "not tell the order, give the frames one by one with the option frames_as_given "
                                     "(command line: --as-given)");
  error({"f1_r2.obj", "f2_r1.obj"}, "two orders are possible");
  error({"01-02-2024.obj", "02-01-2024.obj"}, "two orders are possible");
  error({"f123456789012345678901.obj", "f123456789012345678902.obj"}, "has no number that tells its place");
}

void test_folder()
{
  for (const char* name : {"walk_10.obj", "walk_9.OBJ", "walk_8.obj", ".walk_0.obj", "rest.ply", "walk_9 copy.obj",
                           "notes.txt", "walk.pc2"})
    folder.write(std::string("walk/") + name, obj(0));
  std::filesystem::create_directory(folder.path("walk/walk_3.obj"));
  const std::string walk = folder.path("walk");
  const auto in_walk = [&](const char* name) { return (std::filesystem::path(walk) / name).string(); };
  const IO::Numbered_series series = IO::frame_files_in_folder(walk);
  CHECK((series.files == Names{in_walk("walk_8.obj"), in_walk("walk_9.OBJ"), in_walk("walk_10.obj")}));
  CHECK((series.others == Names{in_walk("rest.ply"), in_walk("walk_9 copy.obj")}));
  const std::vector<std::string> told = {
      "not among the 3 frames, to whose series the name does not belong: rest.ply, walk_9 copy.obj"};
  CHECK(IO::read_animation<double>({walk}).notices == told);
  const IO::Numbered_series with_template = IO::numbered_series({"f-1.obj", "f1.obj", "f0.obj", "f.obj"}, true);
  CHECK((with_template.files == Names{"f-1.obj", "f0.obj", "f1.obj"} && with_template.others == Names{"f.obj"}));
  IO::Mesh_reading_options as_given;
  as_given.frames_as_given = true;
  const Names reversed = {in_walk("walk_10.obj"), in_walk("walk_8.obj"), in_walk("rest.ply")};
  folder.write("walk/rest.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                "property float z\nelement face 1\nproperty list int int vertex_index\nend_header\n"
                                "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  CHECK(IO::read_animation<double>(reversed, as_given).sources == reversed);
  CHECK_THROWS(Input_error, IO::read_animation<double>({walk}, as_given),
               walk + ": the files of a folder are in no order");

  folder.write("tie/1.obj", "");
  folder.write("tie/1.off", "");
  CHECK_THROWS(Input_error, IO::frame_files_in_folder(folder.path("tie")),
               ": the folder has as many .obj as .off files");
  folder.write("empty/.hidden.obj", "");
  CHECK_THROWS(Input_error, IO::frame_files_in_folder(folder.path("empty")), "empty: the folder has no mesh files");
  CHECK_THROWS(Input_error, IO::frame_files_in_folder(folder.path("none")),
               "none: cannot read the folder: No such file");
}

template <class FT>
bool is_right(const IO::Animation_file_data<FT>& data, std::size_t frames)
{
  if (data.frames != frames || data.mesh.points.size() != 3 || data.mesh.triangles.size() != 1) return false;
  const Spatio_temporal_field<FT>* fields[] = {&data.x, &data.y, &data.z};
  for (std::size_t c = 0; c < 3; ++c) {
    if (fields[c]->number_of_rows() != 3 || fields[c]->number_of_frames() != frames) return false;
    for (std::size_t v = 0; v < 3; ++v)
      for (std::size_t f = 0; f < frames; ++f)
        if ((*fields[c])(v, f) != FT(value(f, v, c))) return false;
  }
  return true;
}

// Numbers of frames around those that are gathered before they are written to the fields.
template <class FT>
void test_animation_of()
{
  const std::string mesh = folder.write("m.obj", obj(0));
  for (std::size_t frames : {2u, 7u, 8u, 9u, 16u, 17u, 40u}) {
    const std::string cache = folder.write("m.pc2", pc2(frames));
    CHECK(is_right(IO::read_animation<FT>({mesh, cache}), frames));
  }
  const std::string cache = folder.write("m.mdd", mdd({0, 0.5f}));
  const auto data = IO::read_animation<FT>({cache, mesh});
  CHECK(is_right(data, 2));
  CHECK((data.times == std::vector<double>{0, 0.5}));
  CHECK((data.sources == std::vector<std::string>{mesh, cache}));
  CHECK(data.frame_name(1) == cache + ", frame 1");

  std::vector<std::string> files;
  for (std::size_t f = 0; f < 11; ++f) files.push_back(folder.write("seq/f" + std::to_string(f) + ".obj", obj(f)));
  std::vector<std::string> as_of_shell = files;
  std::sort(as_of_shell.begin(), as_of_shell.end());
  CHECK(as_of_shell != files);
  const auto sequence = IO::read_animation<FT>(as_of_shell);
  CHECK(is_right(sequence, 11));
  CHECK(sequence.sources == files && sequence.times.empty());
  CHECK(sequence.frame_name(10) == files[10]);
  CHECK(is_right(IO::read_animation<FT>({folder.path("seq")}), 11));

  // Coordinates live where the one says that is told their number before there are any.
  for (const std::vector<std::string>& inputs : {std::vector<std::string>{mesh, cache}, files}) {
    const std::size_t frames = inputs.size() == 2 ? 2 : 11;
    const auto memory = std::make_shared<Recording_memory>();
    std::size_t calls = 0;
    const auto choose = [&](std::size_t n, std::size_t f) {
      CHECK(n == 3 && f == frames && memory->allocations() == 0);
      ++calls;
      return memory;
    };
    const auto chosen = IO::read_animation<FT>(inputs, IO::Mesh_reading_options(), choose);
    CHECK(is_right(chosen, frames) && calls == 1 && memory->in_use() == 3 && memory->allocations() == 3);
    CHECK(chosen.x.memory() == memory && chosen.y.memory() == memory && chosen.z.memory() == memory);
    struct Stop
    {
    };
    bool is_stopped = false;
    try {
      IO::read_animation<FT>(inputs, IO::Mesh_reading_options(),
                             [](std::size_t, std::size_t) -> std::shared_ptr<Field_memory> { throw Stop(); });
    } catch (const Stop&) {
      is_stopped = true;
    }
    CHECK(is_stopped);
  }
}

void test_animation_errors()
{
  const auto error = [](const std::vector<std::string>& inputs, const std::string& message) {
    CHECK_THROWS(Input_error, IO::read_animation<float>(inputs), message);
  };
  const std::string mesh = folder.write("m.obj", obj(0)), cache = folder.write("m.pc2", pc2());
  const std::string mesh4 = folder.write("m4.obj", "v 1 1 1\n" + obj(0));
  error({}, "no input: give a mesh and a point cache");
  error({cache}, cache + ": a point cache holds positions only; give the mesh file");
  error({mesh}, mesh + ": one mesh is no animation");
  error({mesh, folder.path("none.pc2")}, folder.path("none.pc2") + ": cannot read: No such file");
  error({mesh, folder.path("none.obj")}, folder.path("none.obj") + ": cannot read: No such file");
  error({mesh, cache, cache}, cache + ": a second point cache");
  error({mesh, mesh4, cache}, mesh4 + ": a second mesh");
  error({mesh, folder.path()}, folder.path() + ": a folder of frames must be the only input");
  error({mesh4, cache}, cache + ": has 3 points, but the mesh " + mesh4 + " has 4 vertices");
  error({mesh, folder.write("one.pc2", pc2(1))}, "one.pc2: one frame is no animation");
  error({mesh, folder.write("x.txt", "")}, "x.txt: unknown kind of file \".txt\"; known are meshes (.obj, ");
  error({mesh, folder.write("x.abc", "")}, "x.abc: Alembic files (.abc) are not read; known are meshes (.obj, ");
  error({folder.write("ending", "")}, "ending: unknown kind of file, without an ending");

  folder.write("s/f1.obj", obj(0));
  const std::string second = folder.write("s/f2.obj", obj(1, "f 1 2 3\nf 3 2 1\n"));
  error({folder.path("s")}, second + ": has 2 triangles, but the first frame, ");
  folder.write("s/f2.obj", "v 0 0 0\n" + obj(1));
  error({folder.path("s")}, second + ": has 4 vertices, but the first frame, ");
  folder.write("s/f2.obj", obj(1, "f 2 1 3\n"));
  error({folder.path("s")}, second + ": triangle 0 is (1, 0, 2), but (0, 1, 2) in the first frame, ");
  folder.write("s4/f1.obj", "v 1 1 1\n" + obj(0));
  const std::string other = folder.write("s4/f2.obj", "v 1 1 1\n" + obj(1, "f 1 2 4\n"));
  error({folder.path("s4")}, other + ": triangle 0 is (0, 1, 3), but (0, 1, 2) in the first frame, ");
  folder.write("s/f2.obj", "v 0 0 nan\n");
  error({folder.path("s")}, second + ":1: vertex 0 has a coordinate that is not finite");
  const std::string large = "v 0 0 0\nv 0 0 1e198\nv 1e200 0 0\nf 1 2 3\n";
  folder.write("s/f2.obj", large);
  error({folder.path("s")}, second + ": vertex 1 has a coordinate too large for the precision");
  folder.write("s/f1.obj", large);
  CHECK(IO::read_animation<double>({folder.path("s")}).x(2, 1) == 1e200);

  // quads
  folder.write("q/f1.obj", "v 0 0 0\n" + obj(0, "f 1 2 3 4\n"));
  folder.write("q/f2.obj", "v 0 0 0\n" + obj(1, "f 1 2 3 4\n"));
  error({folder.path("q")}, "face 0 has 4 corners");
  IO::Mesh_reading_options options;
  options.triangulate_faces = true;
  CHECK(IO::read_animation<float>({folder.path("q")}, options).mesh.triangles.size() == 2);
}

// A tube that was cut open along a line: its first and last columns are at the same places in all frames.
struct Cut_tube
{
  std::size_t columns = 6, rings = 4;

  std::array<double, 3> point(std::size_t column, std::size_t ring, std::size_t frame) const
  {
    const double angle = 2 * 3.14159265358979 * double(column % columns) / double(columns);
    return {{std::cos(angle) * (1 + 0.1 * double(frame * ring)), std::sin(angle), double(ring)}};
  }

  // `more`: lines after those of the tube
  std::string obj(std::size_t frame, const std::string& more = "") const
  {
    std::ostringstream os;
    os.imbue(std::locale::classic());
    for (std::size_t c = 0; c <= columns; ++c)
      for (std::size_t r = 0; r < rings; ++r) {
        const auto p = point(c, r, frame);
        os << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
      }
    for (std::size_t c = 0; c < columns; ++c)
      for (std::size_t r = 0; r + 1 < rings; ++r) {
        const std::size_t a = 1 + c * rings + r, b = a + rings;
        os << "f " << a << ' ' << b << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << a + 1 << '\n';
      }
    return os.str() + more;
  }

  std::vector<std::string> write(const std::string& name, const std::string& more = "") const
  {
    std::vector<std::string> files;
    for (std::size_t f = 0; f < 3; ++f) files.push_back(folder.write(name + std::to_string(f) + ".obj", obj(f, more)));
    return files;
  }
};

template <class FT>
IO::Animation_file_data<FT> read_with(const std::vector<std::string>& files, IO::Welding welding, bool repair = false)
{
  IO::Mesh_reading_options options;
  options.welding = welding;
  options.repair = repair;
  return IO::read_animation<FT>(files, options);
}

template <class FT>
void test_welding()
{
  const Cut_tube tube;
  const std::size_t n = tube.columns * tube.rings;
  const std::vector<std::string> files = tube.write("tube/f");
  for (IO::Welding welding : {IO::Welding::AUTO, IO::Welding::ALWAYS}) {
    const auto data = read_with<FT>(files, welding);
    const auto surface = IO::to_surface_mesh(data.mesh, "tube");
    CHECK(num_vertices(surface) == n && num_faces(surface) == 2 * tube.columns * (tube.rings - 1));
    const auto halfedges = surface.halfedges();
    CHECK(std::count_if(halfedges.begin(), halfedges.end(), [&](auto h) { return surface.is_border(h); }) ==
          std::ptrdiff_t(2 * tube.columns));
    CHECK(data.file_mesh.points.size() == n + tube.rings && data.x.number_of_rows() == n);
    CHECK(data.notices.size() == 2 && data.notices[0] == "4 vertices lie where another one does in all frames: welded");
    bool good = true;
    for (std::size_t v = 0; v < n; ++v) {
      std::vector<std::size_t> origins = {v}; // those of the first column have a twin in the last
      if (v < tube.rings) origins.push_back(n + v);
      good = good && data.origins.of(v) == origins;
      for (std::size_t f = 0; f < 3; ++f) {
        const auto p = tube.point(v / tube.rings, v % tube.rings, f);
        good = good && std::abs(double(data.x(v, f)) - p[0]) + std::abs(double(data.y(v, f)) - p[1]) +
                               std::abs(double(data.z(v, f)) - p[2]) <
                           1e-4;
      }
    }
    CHECK(good);
  }
  const auto cut = read_with<FT>(files, IO::Welding::NEVER);
  CHECK(cut.mesh.points.size() == n + tube.rings && cut.origins.empty() && cut.notices.empty());
  CHECK(cut.file_mesh.points.empty());

  // A flap at the seam: three borders meet there, of which no two belong together.
  std::string flap = "v 3 0 0\n";
  for (std::size_t r = 0; r < tube.rings; ++r) {
    std::ostringstream line;
    line << "v 1 0 " << r << '\n'; // where the seam is in the first frame, but not later
    flap += line.str();
  }
  flap += "f 29 30 31\nf 29 31 32\nf 29 32 33\n";
  CHECK(read_with<FT>(tube.write("parting/f", flap), IO::Welding::AUTO).mesh.points.size() == n + 5);
  std::vector<std::string> flaps;
  for (std::size_t f = 0; f < 3; ++f) {
    std::string text = tube.obj(f) + "v 3 0 0\n";
    std::istringstream lines(tube.obj(f));
    std::string line;
    for (std::size_t r = 0; r < tube.rings && std::getline(lines, line); ++r) text += line + '\n';
    flaps.push_back(folder.write("flap/f" + std::to_string(f) + ".obj", text + "f 29 30 31\nf 29 31 32\nf 29 32 33\n"));
  }
  const auto open = read_with<FT>(flaps, IO::Welding::AUTO);
  CHECK(open.mesh.points.size() == n + tube.rings + 5 && open.origins.empty());
  CHECK(open.notices ==
        std::vector<std::string>{"8 vertices lie where another one does in all frames, but welding would "
                                 "not make a manifold: left as they are"});
  CHECK_THROWS(Input_error, read_with<FT>(flaps, IO::Welding::ALWAYS), "would not make a manifold at 3 edges");
}

void test_repair()
{
  const Cut_tube tube;
  const auto repaired = [&](const std::string& name, const std::string& more) {
    const std::vector<std::string> files = tube.write(name + "/f", more);
    const auto data = read_with<double>(files, IO::Welding::AUTO, true);
    IO::to_surface_mesh(data.mesh, name);
    // without, the file is what is wrong
    const auto as_it_is = read_with<double>(files, IO::Welding::AUTO);
    CHECK_THROWS(Input_error, IO::to_surface_mesh(as_it_is.mesh, files[0]), files[0] + ": ");
    return data;
  };
  const auto is_told = [](const IO::Animation_file_data<double>& data, const std::string& notice) {
    return std::find(data.notices.begin(), data.notices.end(), notice) != data.notices.end();
  };
  const std::size_t n = tube.columns * tube.rings, faces = 2 * tube.columns * (tube.rings - 1);
  const auto twice = repaired("twice", "f 1 2 2\nf 6 1 5\nf 1 5 6\n");
  CHECK(is_told(twice, "repair: 1 face with the same vertex twice left out"));
  CHECK(is_told(twice, "repair: 2 faces with the vertices of another face left out"));
  CHECK(twice.mesh.points.size() == n && twice.mesh.triangles.size() == faces);
  const auto turned = repaired("turned", "v 0 0 9\nv 9 0 0\nf 1 5 29\n"); // walks along (1, 5) as face (1, 5, 6) does
  CHECK(is_told(turned, "repair: 1 face turned round to agree with their neighbours"));
  CHECK((turned.mesh.triangles.back() == std::array<std::size_t, 3>{{0, n, 4}}));
  CHECK(turned.origins.of(n) == std::vector<std::size_t>{28} && is_told(turned, "1 vertex in no triangle left out"));
  const auto bow = repaired("bow", "v 0 0 9\nv 9 0 9\nf 9 29 30\n"); // touches the border in vertex 9
  CHECK(is_told(bow, "1 vertex split where the surface meets in a point only"));
  CHECK(bow.mesh.points.size() == n + 3);
  const auto third = repaired("third", "v 0 0 9\nf 6 1 29\n");
  CHECK(is_told(third, "repair: 1 edge cut open where more than two faces meet"));
  std::vector<std::string> strip;
  for (std::size_t f = 0; f < 3; ++f)
    strip.push_back(folder.write("moebius/f" + std::to_string(f) + ".obj",
                                 "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\n"
                                 "f 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 6\nf 5 6 2\nf 6 2 1\n"));
  CHECK_THROWS(Input_error, read_with<double>(strip, IO::Welding::AUTO, true),
               strip[0] + ": the surface has one side only");
}

// A sheet of 20 x 20 vertices, or a closed tube of as many, that bends; `order` are the vertices as the cache has them.
struct Sheet
{
  bool is_tube;
  std::size_t n = 20;

  std::array<double, 3> point(std::size_t v, double bending) const
  {
    const double i = double(v / n), j = double(v % n), angle = 2 * 3.14159265358979 * i / double(n);
    if (is_tube) return {{4 * std::cos(angle) + bending * j, 4 * std::sin(angle), j}};
    const double x = std::pow(i, 1.3), y = std::pow(j, 1.6) + 0.3 * std::sin(7 * i); // no two edges are alike
    return {{x * std::cos(bending * y / 100), y, x * std::sin(bending * y / 100)}};
  }

  std::vector<std::string> write(const std::vector<std::size_t>& order, double scale = 1, double noise = 0) const
  {
    std::mt19937 generator(7);
    std::normal_distribution<double> normal;
    IO::Indexed_mesh mesh;
    for (std::size_t v = 0; v < n * n; ++v) mesh.points.push_back(point(v, 0));
    for (std::size_t i = 0; i + 1 < (is_tube ? n + 1 : n); ++i)
      for (std::size_t j = 0; j + 1 < n; ++j) {
        const std::size_t a = i * n + j, b = (i + 1) % n * n + j;
        mesh.triangles.push_back({{a, b, b + 1}});
        mesh.triangles.push_back({{a, b + 1, a + 1}});
      }
    std::ostringstream obj, pc2;
    IO::write_obj(obj, mesh);
    IO::write_pc2(pc2, n * n, 8, [&](std::size_t f, float* xyz) {
      for (std::size_t v : order)
        for (double x : point(v, double(f))) *xyz++ = float(scale * (x + noise * normal(generator)));
    });
    return {folder.write("sheet.obj", obj.str()), folder.write("sheet.pc2", pc2.str())};
  }
};

void test_cache_fits()
{
  const auto notices = [](const std::vector<std::string>& inputs) {
    return IO::read_animation<double>(inputs).notices;
  };
  const Sheet sheet = {false}, tube = {true};
  std::vector<std::size_t> same(400), backwards, by_column, turned;
  std::iota(same.begin(), same.end(), std::size_t(0));
  backwards.assign(same.rbegin(), same.rend());
  for (std::size_t v = 0; v < 400; ++v) by_column.push_back(v % 20 * 20 + v / 20);
  std::vector<std::size_t> random = same, tenth = same;
  std::mt19937 generator(1);
  std::shuffle(random.begin(), random.end(), generator);
  for (std::size_t v = 0; v + 50 < 400; v += 20) std::swap(tenth[v], tenth[v + 50]);
  CHECK(notices(sheet.write(same)).empty() && notices(tube.write(same)).empty());
  for (const auto& order : {backwards, by_column, random})
    for (double scale : {1., 100.}) {
      const std::vector<std::string> inputs = sheet.write(order, scale);
      CHECK_THROWS(Input_error, notices(inputs),
                   inputs[1] + ": its vertices are in another order than those of the mesh " + inputs[0]);
    }
  CHECK_THROWS(Input_error, notices(sheet.write(tenth)), "its vertices are in another order");
  // Noise makes edges longer and shorter, but is neither another order nor, where it leaves them recognisable, another unit.
  for (const double noise : {0.1, 0.3, 0.6}) {
    CHECK(notices(sheet.write(same, 1, noise)).empty());
    const std::vector<std::string> of_other_unit = notices(sheet.write(same, 3, noise));
    CHECK(noise > 0.5 || (of_other_unit.size() == 1 &&
                          of_other_unit[0].find("times smaller than the frames") != std::string::npos));
    CHECK_THROWS(Input_error, notices(sheet.write(random, 1, noise)), "its vertices are in another order");
  }
  for (const auto& order : {backwards, by_column}) // where neighbours stay neighbours, little noise hides it
    CHECK_THROWS(Input_error, notices(sheet.write(order, 1, 0.1)), "its vertices are in another order");
  const std::vector<std::string> larger = sheet.write(same, 25.4);
  CHECK(notices(larger) ==
        std::vector<std::string>{"the mesh " + larger[0] + " is 25.4 times smaller than the frames of " + larger[1] +
                                 ", as in another unit; positions and lengths are those "
                                 "of the cache"});
  CHECK(notices(sheet.write(same, 0.5)).size() == 1 && notices(sheet.write(same, 1.1)).empty());

  // Regular meshes: exchanging a few vertices changes a few edges; a turned tube is the same tube.
  std::vector<std::size_t> exchanged = same;
  std::swap(exchanged[5], exchanged[207]);
  CHECK_THROWS(Input_error, notices(tube.write(exchanged)), "though the points are the same");
  for (std::size_t v = 0; v < 400; ++v) turned.push_back((v + 60) % 400);
  CHECK(notices(tube.write(turned)).empty());
}

// Frames that cannot be true: named, refused or bridged.
struct Faulty_sheet
{
  Sheet sheet = {false};
  std::size_t frames = 9;

  // `change(f, v, position)` makes the fault.
  template <class Change>
  IO::Animation_file_data<double> read(const Change& change, bool skip = false) const
  {
    std::vector<std::size_t> same(400);
    std::iota(same.begin(), same.end(), std::size_t(0));
    std::vector<std::string> inputs = sheet.write(same);
    std::ostringstream os;
    IO::write_pc2(os, 400, frames, [&](std::size_t f, float* xyz) {
      for (std::size_t v = 0; v < 400; ++v) {
        std::array<double, 3> p = sheet.point(v, double(f));
        change(f, v, p);
        for (double x : p) *xyz++ = float(x);
      }
    });
    inputs[1] = folder.write("faulty.pc2", os.str());
    IO::Mesh_reading_options options;
    options.skip_bad_frames = skip;
    return IO::read_animation<double>(inputs, options);
  }
};

void test_faulty_frames()
{
  typedef std::array<double, 3> P;
  const Faulty_sheet sheet;
  const auto none = [](std::size_t, std::size_t, P&) {};
  const auto good = sheet.read(none);
  CHECK(good.notices.empty());
  const auto at_zero = [](std::size_t first, std::size_t last) {
    return [=](std::size_t f, std::size_t, P& p) {
      if (f >= first && f <= last) p = {{3, 4, 5}};
    };
  };
  const auto is_between = [&](const IO::Animation_file_data<double>& data, std::size_t f, std::size_t g,
                              std::size_t h) {
    const double share = g == h ? 0 : double(f - g) / double(h - g);
    bool is_right = true;
    for (std::size_t v = 0; v < 400; ++v)
      is_right = is_right && std::abs(data.x(v, f) - (1 - share) * good.x(v, g) - share * good.x(v, h)) < 1e-12 &&
                 std::abs(data.z(v, f) - (1 - share) * good.z(v, g) - share * good.z(v, h)) < 1e-12;
    for (std::size_t v = 0; v < 400; ++v) // others stay as they are
      is_right = is_right && data.z(v, h) == good.z(v, h) && data.z(v, g) == good.z(v, g);
    return is_right;
  };

  // one frame without extent between good ones, but for rounding, or with all vertices on a line
  const auto rounded = sheet.read([](std::size_t f, std::size_t v, P& p) {
    if (f == 4) p = {{1e3 * (1 + 1e-7 * double(v % 3)), 0, double(v % 2) * 1e-5}};
  });
  CHECK(is_between(rounded, 4, 3, 5));
  for (double width : {0., 1.}) {
    const auto lone = sheet.read([&](std::size_t f, std::size_t, P& p) {
      if (f == 4) p = {{width * p[0], 0, 0}};
    });
    CHECK(lone.frames == 9 && is_between(lone, 4, 3, 5) && lone.notices.size() == 1);
    CHECK(lone.notices[0].find(width == 0 ? "faulty.pc2, frame 4: has no extent" : "frame 4: has no surface") !=
          std::string::npos);
  }
  CHECK_THROWS(Input_error, sheet.read(at_zero(0, 0)), "faulty.pc2, frame 0: has no extent: all vertices are at one");
  CHECK_THROWS(Input_error, sheet.read(at_zero(8, 8)), "faulty.pc2, frame 8: has no extent");
  CHECK_THROWS(Input_error, sheet.read(at_zero(3, 5)), "broken are 3 of 9 frames: 3-5; leaving out bad frames");
  CHECK_THROWS(Input_error, sheet.read(at_zero(2, 8), true), "only 2 of the 9 frames are good");
  CHECK_THROWS(Input_error, sheet.read(at_zero(0, 8), true),
               "frame 0: has no extent: all vertices are at one point, as");
  const auto inner = sheet.read(at_zero(3, 5), true), first = sheet.read(at_zero(0, 1), true),
             last = sheet.read(at_zero(6, 8), true);
  CHECK(is_between(inner, 3, 2, 6) && is_between(inner, 4, 2, 6) && is_between(inner, 5, 2, 6));
  CHECK(is_between(first, 0, 2, 2) && is_between(first, 1, 2, 2) && is_between(last, 8, 5, 5));
  CHECK(first.notices.size() == 1 &&
        first.notices[0].find("2 frames are left out, bridged in time: 0-1") != std::string::npos);

  // a vertex that explodes, for a frame or from then on; whole bodies that do
  for (double distance : {1e4, 1e9, 1e30})
    for (std::size_t until : {5u, 8u}) {
      const auto explode = [&](std::size_t f, std::size_t v, P& p) {
        if (v == 77 && f >= 5 && f <= until) p[1] = distance;
      };
      CHECK_THROWS(Input_error, sheet.read(explode), "faulty.pc2, frame 5: vertex 77 is ");
      CHECK(is_between(sheet.read(explode, true), 5, 4, until == 5 ? 6 : 4));
    }
  CHECK_THROWS(Input_error, sheet.read([](std::size_t f, std::size_t v, P& p) {
    if (f > 5) p[v % 3] = 1e30 * std::sin(double(v));
  }),
               "broken are 3 of 9 frames: 6-8");

  // no faults: growth as a whole, a body that is small for long, flies away, or is flat
  CHECK(sheet
            .read([](std::size_t f, std::size_t, P& p) {
              for (double& x : p) x *= std::pow(10., double(f) / 2 - 4);
            })
            .notices.size() <= 1); // of the unit
  CHECK(sheet
            .read([](std::size_t f, std::size_t, P& p) {
              for (double& x : p) x *= f == 8 ? 1 : 1e-5;
            })
            .frames == 9);
  CHECK(sheet.read([](std::size_t f, std::size_t, P& p) { p[2] += f == 8 ? 3000. : 0.; }).notices.empty());
  CHECK(sheet.read([](std::size_t f, std::size_t, P& p) { p[2] *= f == 4 ? 0 : 1; }).notices.empty());
}

// Far from the origin, single precision leaves little of a surface.
void test_coarse_precision()
{
  typedef std::array<double, 3> P;
  const Faulty_sheet sheet;
  const auto away = [&](double distance) {
    return sheet.read([=](std::size_t, std::size_t, P& p) { p[1] += distance; });
  };
  const IO::Indexed_mesh mesh = away(0).mesh;
  double edge = 0; // mean
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const P &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]];
      edge += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / double(3 * mesh.triangles.size());
    }
  const double power = std::exp2(std::floor(std::log2(edge)) + 23); // where numbers are an edge, or half of it, apart
  CHECK(away(power / 256).notices.empty());
  const auto noted = away(power / 32).notices;
  CHECK(noted.size() == 1 && noted[0].find("in single precision are multiples of") != std::string::npos);
  for (double lost : {power / 4, 4 * power})
    CHECK_THROWS(Input_error, away(lost), "what deforms is lost in rounding");
}

// STL names no vertices: corners that are together in all frames are one, whether others meet them in some frame or not.
void test_stl_series()
{
  // two triangles with an edge in common; the two vertices beside it meet in frame `meeting`
  const auto stl = [](int frame, int meeting) {
    const std::string a = "vertex 0 0 0\n", b = "vertex 1 0 " + std::to_string(frame) + "\n";
    const std::string c = frame == meeting ? "vertex 5 5 5\n" : "vertex 0 1 0\n";
    const std::string d = frame == meeting ? "vertex 5 5 5\n" : "vertex 0 -1 0\n";
    const std::string begin = "facet normal 0 0 0\nouter loop\n", end = "endloop\nendfacet\n";
    return "solid\n" + begin + a + b + c + end + begin + b + a + d + end + "endsolid\n";
  };
  for (int meeting : {-1, 0, 1, 2}) {
    std::vector<std::string> files;
    for (int f = 0; f < 3; ++f) files.push_back(folder.write("stl/" + std::to_string(f) + ".stl", stl(f, meeting)));
    const auto data = IO::read_animation<double>(files);
    CHECK(data.mesh.points.size() == 4 && data.frames == 3 && data.origins.empty());
    CHECK((data.mesh.triangles == std::vector<std::array<std::size_t, 3>>{{{0, 1, 2}}, {{1, 0, 3}}}));
    for (int f = 0; f < 3; ++f) {
      CHECK(data.z(1, std::size_t(f)) == f);
      CHECK(data.y(2, std::size_t(f)) == (f == meeting ? 5 : 1) &&
            data.y(3, std::size_t(f)) == (f == meeting ? 5 : -1));
    }
  }
  folder.write("stl/1.stl", "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                            "endfacet\nendsolid\n");
  CHECK_THROWS(Input_error, IO::read_animation<double>({folder.path("stl")}),
               folder.path("stl/1.stl") + ": has 1 triangles, but the first frame, ");
}

// An animation large enough to be read in several pieces, by several threads: a strip of triangles whose vertices jump
// about. Coordinates are exact in single precision and have several digits behind the point.
struct Strip
{
  std::size_t vertices, frames;

  float value(std::size_t f, std::size_t v, std::size_t c) const
  {
    return float((f * 7919 + v * 104729 + c * 1299709) % 65521) / 1024 - 32;
  }

  std::vector<float> frame(std::size_t f) const
  {
    std::vector<float> xyz;
    for (std::size_t v = 0; v < vertices; ++v)
      for (std::size_t c = 0; c < 3; ++c) xyz.push_back(value(f, v, c));
    return xyz;
  }

  IO::Indexed_mesh mesh(std::size_t f) const
  {
    IO::Indexed_mesh m;
    for (std::size_t v = 0; v < vertices; ++v) m.points.push_back({{value(f, v, 0), value(f, v, 1), value(f, v, 2)}});
    for (std::size_t v = 0; v + 2 < vertices; ++v) m.triangles.push_back({{v, v + 1 + v % 2, v + 2 - v % 2}});
    return m;
  }

  std::string obj(std::size_t f) const
  {
    std::ostringstream os;
    IO::write_obj(os, mesh(f));
    return os.str();
  }

  std::string cache(bool is_pc2) const
  {
    std::ostringstream os;
    const auto get = [&](std::size_t f, float* xyz) {
      const std::vector<float> values = frame(f);
      std::copy(values.begin(), values.end(), xyz);
    };
    if (is_pc2)
      IO::write_pc2(os, vertices, frames, get);
    else
      IO::write_mdd(os, vertices, std::vector<float>(frames, 0), get);
    return os.str();
  }

  template <class FT>
  bool is_in(const Spatio_temporal_field<FT>& x, const Spatio_temporal_field<FT>& y,
             const Spatio_temporal_field<FT>& z) const
  {
    const Spatio_temporal_field<FT>* fields[] = {&x, &y, &z};
    bool good = true;
    for (std::size_t c = 0; c < 3; ++c) {
      if (fields[c]->number_of_rows() != vertices || fields[c]->number_of_frames() != frames) return false;
      for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t f = 0; f < frames; ++f) good = good && (*fields[c])(v, f) == FT(value(f, v, c));
    }
    return good;
  }
};

template <class FT, class ConcurrencyTag>
void test_strip()
{
  for (const Strip& strip : {Strip{2111, 70}, Strip{1024, 33}, Strip{257, 5}}) {
    const std::string mesh = folder.write("strip/0.obj", strip.obj(0));
    for (bool is_pc2 : {true, false}) {
      const std::string cache = folder.write(is_pc2 ? "strip/c.pc2" : "strip/c.mdd", strip.cache(is_pc2));
      const auto data = IO::read_animation<FT, ConcurrencyTag>({mesh, cache});
      CHECK(strip.is_in(data.x, data.y, data.z));
    }
  }
  for (std::size_t frames : {2u, 15u, 16u, 17u, 32u, 35u}) {
    const Strip strip = {523, frames};
    std::filesystem::remove_all(folder.path("strip"));
    for (std::size_t f = 0; f < frames; ++f) folder.write("strip/" + std::to_string(f) + ".obj", strip.obj(f));
    const auto data = IO::read_animation<FT, ConcurrencyTag>({folder.path("strip")});
    CHECK(strip.is_in(data.x, data.y, data.z));
    CHECK(data.mesh.points == strip.mesh(0).points);
    CHECK(data.mesh.triangles == strip.mesh(0).triangles);
  }
}

// The message of the error, or an empty string.
template <class ConcurrencyTag>
std::string error_of(const std::vector<std::string>& inputs)
{
  try {
    IO::read_animation<float, ConcurrencyTag>(inputs);
  } catch (const Input_error& e) {
    return e.what();
  }
  return "";
}

// Several frames are wrong, each in its way, and those behind the first one are quicker to read: the first one is told.
void test_first_error()
{
  const Strip strip = {3001, 40};
  std::vector<std::string> good, files;
  for (std::size_t f = 0; f < strip.frames; ++f) {
    good.push_back(strip.obj(f));
    files.push_back(folder.write("err/" + std::to_string(f) + ".obj", good[f]));
  }
  const auto check = [&](std::size_t first_bad, const std::string& message) {
    for (int i = 0; i < 5; ++i) {
      const std::string parallel = error_of<CGAL::Parallel_if_available_tag>(files);
      report(parallel.compare(0, files[first_bad].size(), files[first_bad]) == 0 &&
                 parallel.find(message) != std::string::npos,
             __FILE__, __LINE__, "error of frame " + std::to_string(first_bad) + ": " + parallel);
      CHECK(parallel == error_of<CGAL::Sequential_tag>(files));
    }
  };
  folder.write("err/39.obj", "");
  check(39, ": is empty");
  folder.write("err/33.obj", "v 1 2 x\n");
  check(33, ":1: \"x\" is not a number");
  const std::string swapped = "f 3001 3000 2999\n";
  const auto without_last_face = [&](std::size_t f) { return good[f].substr(0, good[f].rfind("f ")); };
  folder.write("err/20.obj", without_last_face(20) + swapped);
  check(20, ": triangle 2998 is (3000, 2999, 2998), but (2998, ");
  folder.write("err/18.obj", good[18] + swapped);
  check(18, ": has 3000 triangles, but the first frame, ");
  folder.write("err/17.obj", without_last_face(17));
  check(17, ": has 2998 triangles, but the first frame, ");
  folder.write("err/16.obj", "v 0 0 0\n" + good[16]);
  check(16, ": has 3002 vertices, but the first frame, ");
  folder.write("err/9.obj", without_last_face(9) + "f 1 2 3002\n");
  check(9, " has a corner at vertex 3001");
  folder.write("err/3.obj", good[3].substr(0, good[3].size() - 6));
  check(3, ":");
  folder.write("err/2.obj", "v 1e200 0 0\n" + good[2].substr(good[2].find('\n') + 1));
  check(2, ": vertex 0 has a coordinate too large for the precision");
  folder.write("err/0.obj", good[0].substr(0, good[0].size() / 2));
  check(0, ":");
}

// A file that was cut off anywhere is read as it is without threads: no matter what becomes of it.
void test_truncated()
{
  const std::string first = folder.write("cut/0.obj", obj(0)), second = folder.path("cut/1.obj");
  const std::string whole = "#\r\n" + obj(1) + "\r\n";
  std::size_t errors = 0;
  for (std::size_t n = 0; n <= whole.size(); ++n) {
    folder.write("cut/1.obj", whole.substr(0, n));
    const std::string message = error_of<CGAL::Parallel_if_available_tag>({first, second});
    CHECK(message == error_of<CGAL::Sequential_tag>({first, second}));
    CHECK(message.empty() || message.compare(0, second.size(), second) == 0);
    errors += !message.empty();
  }
  CHECK(errors == whole.size() - 3); // without the end of the last lines it is complete
}

// What the threads find out in any order is told as if there were none; and a file may shrink, or grow, after its size
// was looked at.
template <class FT, class ConcurrencyTag>
void test_cache_errors()
{
  const Strip strip = {2500, 40};
  const std::string content = strip.cache(true);
  const std::size_t frame = 12 * strip.vertices;
  const auto error = [&](const std::string& text, const std::string& message, std::uintmax_t resize_to = 0) {
    const std::string path = folder.write("e.pc2", text);
    IO::Point_cache_reader cache(path);
    if (resize_to != 0) std::filesystem::resize_file(path, resize_to);
    Spatio_temporal_field<FT> x, y, z;
    CHECK_THROWS(Input_error, (cache.read_fields<ConcurrencyTag>(x, y, z), 0), path + message);
  };
  std::string bad = content;
  const auto spoil = [&](std::size_t f, std::size_t v, std::size_t c, std::uint32_t bits) {
    bad.replace(32 + f * frame + 12 * v + 4 * c, 4, little_endian(bits));
  };
  spoil(39, 2499, 2, 0x7f800000u);
  error(bad, ": frame 39, vertex 2499: the position is not finite");
  spoil(32, 0, 0, 0xff800000u);
  error(bad, ": frame 32, vertex 0: the position is not finite");
  spoil(7, 1030, 1, 0x7fc00000u);
  error(bad, ": frame 7, vertex 1030: the position is not finite");
  spoil(6, 2400, 0, 0x7f800001u);
  error(bad, ": frame 6, vertex 2400: the position is not finite");

  const std::string sizes = ": 2500 points in 40 frames take 1200032 bytes, the file has ";
#ifndef _WIN32 // where an open file keeps its size
  error(content, sizes + "1200031: it is cut off after 39 whole frames", content.size() - 1);
  error(content, sizes + "90033: it is cut off after 3 whole frames", 32 + 3 * frame + 1);
  error(content, sizes + "29999: it is cut off after 0 whole frames", 29999);
  error(content, ": goes on after the last frame", content.size() + 1);
#endif
}

#ifdef __unix__
// Pipes have no size and cannot be read in any order.
template <class ConcurrencyTag>
void test_pipes()
{
  const Strip strip = {1500, 37};
  const auto make_pipe = [](const std::string& name) {
    const std::string path = folder.path(name);
    CHECK(mkfifo(path.c_str(), 0600) == 0);
    return path;
  };
  std::filesystem::create_directory(folder.path("pipes"));
  const std::string mesh = make_pipe("pipes/m1.obj"), second = make_pipe("pipes/m2.obj");
  const auto write = [](const std::string& path, const std::string& content) {
    return std::thread([path, content] { std::ofstream(path, std::ios::binary) << content; });
  };
  for (bool is_pc2 : {true, false}) {
    const std::string cache = make_pipe(is_pc2 ? "pipes/c.pc2" : "pipes/c.mdd");
    std::thread a = write(mesh, strip.obj(0)), b = write(cache, strip.cache(is_pc2));
    const auto data = IO::read_animation<double, ConcurrencyTag>({mesh, cache});
    CHECK(strip.is_in(data.x, data.y, data.z));
    a.join();
    b.join();
  }
  std::thread a = write(mesh, strip.obj(0)), b = write(second, strip.obj(1));
  const auto data = IO::read_animation<double, ConcurrencyTag>({mesh, second});
  CHECK((Strip{strip.vertices, 2}.is_in(data.x, data.y, data.z)));
  a.join();
  b.join();
  std::filesystem::remove_all(folder.path("pipes"));
}
#endif

} // namespace

int main()
{
  use_hostile_locale();
  test_bytes();
  test_caches();
  test_pipe();
  test_natural_order();
  test_numbered_series();
  test_no_series();
  test_folder();
  test_animation_of<float>();
  test_animation_of<double>();
  test_animation_errors();
  test_welding<float>();
  test_welding<double>();
  test_repair();
  test_stl_series();
  test_cache_fits();
  test_faulty_frames();
  test_coarse_precision();
  test_strip<float, CGAL::Parallel_if_available_tag>();
  test_strip<double, CGAL::Parallel_if_available_tag>();
  test_strip<float, CGAL::Sequential_tag>();
  test_strip<double, CGAL::Sequential_tag>();
  test_first_error();
  test_truncated();
  test_cache_errors<float, CGAL::Sequential_tag>();
  test_cache_errors<double, CGAL::Parallel_if_available_tag>();
#ifdef __unix__
  test_pipes<CGAL::Sequential_tag>();
  test_pipes<CGAL::Parallel_if_available_tag>();
#endif
  return test_result();
}
