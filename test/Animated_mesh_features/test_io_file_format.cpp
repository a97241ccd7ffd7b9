// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Formats of files: by the endings of their names, by their first bytes.

#include "test_io_support.h"

#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Animated_mesh_features;
using namespace test_support;
using IO::File_format;

namespace {

void test_endings()
{
  const std::vector<std::pair<std::string, File_format>> files = {{"a.obj", File_format::OBJ},
                                                                  {"a/b.c/Walk.OFF", File_format::OFF},
                                                                  {"a.b.Ply", File_format::PLY},
                                                                  {"a.stl", File_format::STL},
                                                                  {"a.pc2", File_format::PC2},
                                                                  {"a.MDD", File_format::MDD},
                                                                  {"a.gltf", File_format::GLTF},
                                                                  {"a.glb", File_format::GLTF},
                                                                  {"a.fbx", File_format::FBX},
                                                                  {"a.dae", File_format::COLLADA},
                                                                  {"a.x", File_format::X},
                                                                  {"a.h5", File_format::HDF5},
                                                                  {"a.hdf5", File_format::HDF5},
                                                                  {"a.json", File_format::UNKNOWN},
                                                                  {"a", File_format::UNKNOWN},
                                                                  {"obj", File_format::UNKNOWN},
                                                                  {".obj", File_format::UNKNOWN},
                                                                  {"a.obj.gz", File_format::UNKNOWN},
                                                                  {"a.obj/b", File_format::UNKNOWN},
                                                                  {"", File_format::UNKNOWN},
                                                                  {"a.\xd6"
                                                                   "bj",
                                                                   File_format::UNKNOWN}};
  for (const auto& file : files) {
    CHECK(IO::file_format_by_ending(file.first) == file.second);
    CHECK(IO::file_format(file.first) == file.second); // there is no such file, and none is needed
  }
  std::size_t meshes = 0, caches = 0;
  for (std::size_t i = 0; i < 13; ++i) {
    meshes += IO::is_mesh(files[i].second);
    caches += IO::is_point_cache(files[i].second);
    CHECK(!IO::is_mesh(files[i].second) || i < 4);
  }
  CHECK(meshes == 4 && caches == 2);
  CHECK(IO::is_point_cache(File_format::PC2) && IO::is_point_cache(File_format::MDD));
  CHECK(IO::file_ending("a/Walk.OBJ") == ".obj" && IO::file_ending("a.b/c").empty());
}

void test_content()
{
  const Temporary_folder folder;
  const std::string binary_fbx = "Kaydara FBX Binary  ", hdf5 = "\x89HDF\r\n\x1a\n";
  CHECK(IO::file_format(folder.write("a", "glTF and more")) == File_format::GLTF);
  CHECK(IO::file_format(folder.write("b.data", hdf5)) == File_format::HDF5);
  CHECK(IO::file_format(folder.write("c", binary_fbx)) == File_format::FBX);
  CHECK(IO::file_format(folder.write("d", "Kaydara FBX Ascii  ")) == File_format::UNKNOWN);
  CHECK(IO::file_format(folder.write("e", "glT")) == File_format::UNKNOWN);
  CHECK(IO::file_format(folder.write("f", "")) == File_format::UNKNOWN);
  CHECK(IO::file_format(folder.path()) == File_format::UNKNOWN); // a folder
  // an ending that is known has the say
  CHECK(IO::file_format(folder.write("g.obj", "glTF")) == File_format::OBJ);
  CHECK(IO::file_format_by_ending(folder.path("a")) == File_format::UNKNOWN);
}

void test_readable()
{
  const Temporary_folder folder;
  IO::check_readable(folder.write("a", ""));
  CHECK_THROWS(Input_error, IO::check_readable(folder.path("b")), folder.path("b") + ": cannot read: ");
  CHECK_THROWS(Input_error, IO::check_readable(folder.path()), folder.path() + ": cannot read: ");
}

} // namespace

int main()
{
  use_hostile_locale();
  test_endings();
  test_content();
  test_readable();
  return test_result();
}
