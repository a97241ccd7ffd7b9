// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh files. The first byte is a digit: 0 OBJ, 1 OFF, 2 PLY, 3 STL; 4 to 7 the same with faces cut into triangles; 8 a
// number, as a coordinate of an OBJ file.

#include "fuzz_support.h"

#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/IO/weld_animation.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

namespace Amf = CGAL::Animated_mesh_features;
using fuzz::require;

namespace {

void check(const Amf::IO::Indexed_mesh& mesh)
{
  require(!mesh.points.empty() && !mesh.triangles.empty(), "a mesh has points and triangles");
  for (const auto& point : mesh.points)
    for (double x : point) require(std::isfinite(x), "positions are finite");
  for (const auto& triangle : mesh.triangles)
    for (std::size_t v : triangle) require(v < mesh.points.size(), "corners are points");
}

void check_surface(const Amf::IO::Indexed_mesh& mesh)
{
  try {
    const auto surface = Amf::IO::to_surface_mesh(mesh, "mesh");
    require(surface.is_valid(), "a surface is valid");
    require(surface.number_of_vertices() == mesh.points.size(), "each point is a vertex");
    require(surface.number_of_faces() == mesh.triangles.size(), "each triangle is a face");
  } catch (const Amf::Input_error&) {
  }
}

// Seams closed and the rest mended, it is a surface, or refused; each vertex keeps its row.
void check_repair(const Amf::IO::Indexed_mesh& mesh)
{
  const std::size_t n = mesh.points.size(), frames = 2;
  Amf::IO::Animation_file_data<double> data;
  data.mesh = mesh;
  data.frames = frames;
  data.sources = {"a.obj", "b.obj"};
  Amf::Spatio_temporal_field<double>* const fields[] = {&data.x, &data.y, &data.z};
  for (std::size_t k = 0; k < 3; ++k) {
    *fields[k] = Amf::Spatio_temporal_field<double>(n, frames);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t f = 0; f < frames; ++f) (*fields[k])(v, f) = mesh.points[v][k];
  }
  try {
    Amf::IO::weld_animation(Amf::IO::Welding::AUTO, true, data);
  } catch (const Amf::Input_error&) {
    return;
  }
  check(data.mesh);
  require(Amf::IO::to_surface_mesh(data.mesh, "mesh").is_valid(), "what was mended is a surface");
  for (std::size_t v = 0; v < data.mesh.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      require((*fields[k])(v, 0) == data.mesh.points[v][k], "vertices keep their positions");
}

// Written and read again, it is the same, bit for bit.
void check_copy(const Amf::IO::Indexed_mesh& mesh)
{
  std::ostringstream text;
  Amf::IO::write_obj(text, mesh);
  const std::string bytes = text.str();
  const Amf::IO::Indexed_mesh copy = Amf::IO::read_mesh(fuzz::files().write("_copy.obj", bytes.data(), bytes.size()));
  require(copy.points == mesh.points && copy.triangles == mesh.triangles, "an OBJ file holds the mesh");
}

void read_mesh_file(const std::string& ending, bool triangulate, const std::uint8_t* data, std::size_t size)
{
  Amf::IO::Mesh_reading_options options;
  options.triangulate_faces = triangulate;
  try {
    const Amf::IO::Indexed_mesh mesh = Amf::IO::read_mesh(fuzz::files().write(ending, data, size), options);
    check(mesh);
    check_surface(mesh);
    check_repair(mesh);
    check_copy(mesh);
  } catch (const Amf::Input_error&) {
  }
}

// What is read as a number is the number that the C library reads, whole.
void read_number(const std::string& text)
{
  if (text.find_first_of(std::string("\0 \t\r\n\v\f#\\", 9)) != std::string::npos) return; // more than one word
  const std::string obj = "v " + text + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  try {
    const Amf::IO::Indexed_mesh mesh = Amf::IO::read_mesh(fuzz::files().write(".obj", obj.data(), obj.size()));
    char* end = nullptr;
    const double expected = std::strtod(text.c_str(), &end);
    require(!text.empty() && *end == '\0', "a coordinate is a number");
    require(mesh.points[0][0] == expected, "it is the nearest one");
  } catch (const Amf::Input_error&) {
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0) return 0;
  const unsigned kind = static_cast<std::uint8_t>(data[0] - '0') % 9u;
  const char* const endings[] = {".obj", ".off", ".ply", ".stl"};
  if (kind == 8)
    read_number(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  else
    read_mesh_file(endings[kind % 4], kind >= 4, data + 1, size - 1);
  return 0;
}
