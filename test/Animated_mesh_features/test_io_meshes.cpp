// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh files in and out: what is read, and what is said about files that cannot be.

#include "test_io_support.h"

#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/to_surface_mesh.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

using namespace CGAL::Animated_mesh_features;
using namespace test_support;
using IO::Indexed_mesh;
using IO::Mesh_reading_options;

namespace {

typedef std::array<std::size_t, 3> Triangle;

const Temporary_folder folder;

Indexed_mesh read(const std::string& name, const std::string& content, bool triangulate = false)
{
  Mesh_reading_options options;
  options.triangulate_faces = triangulate;
  return IO::read_mesh(folder.write(name, content), options);
}

// `message` follows the name of the file: ":4: face..." or ": is empty".
void check_error(const std::string& name, const std::string& content, const std::string& message)
{
  CHECK_THROWS(Input_error, read(name, content), folder.path(name) + message);
}

// Three points that show if coordinates are mixed up, and a triangle that shows if corners are.
const std::vector<std::array<double, 3>> points = {{{0, 0.5, -1}}, {{1.25, 0, 3}}, {{-2e3, 1, 1e-3}}};
const Triangle triangle = {{1, 2, 0}};

void check_the_triangle(const Indexed_mesh& mesh, const char* what)
{
  report(mesh.points.size() == 3 && mesh.triangles == std::vector<Triangle>{triangle}, __FILE__, __LINE__, what);
  if (mesh.points.size() != 3) return;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) check_near(mesh.points[i][c], points[i][c], 1e-7, what, __FILE__, __LINE__);
}

void test_obj()
{
  const std::string v = "v 0 0.5 -1\nv 1.25 0 3\nv -2000 1 1e-3\n";
  check_the_triangle(read("a.obj", v + "f 2 3 1\n"), "plain");
  check_the_triangle(read("A.OBJ", v + "f 2 3 1"), "no newline at the end, ending in capitals");
  check_the_triangle(read("a.obj", v + "f -2 -1 -3\n"), "negative indices");
  check_the_triangle(read("a.obj", v + "vt 0 0\nvn 0 0 1\nf 2/1 3/1 1/1\n"), "texture coordinates");
  check_the_triangle(read("a.obj", v + "f 2//1 3//1 1//1\n"), "normals");
  check_the_triangle(read("a.obj", v + "f 2/1/1 3/-1/1 1/1/-1\n"), "both");
  check_the_triangle(read("a.obj", "f 2 3 1\n" + v), "faces first");
  check_the_triangle(
      read("a.obj", "\xef\xbb\xbfv 0 .5 -1 1.0\r\nv +1.25 0 3 0.1 0.2 0.3\r\n\r\nv -2E+3 1 0.001\r\nf 2 3 1\r\n"),
      "byte order mark, CRLF, weight, colour, plus");
  check_the_triangle(read("a.obj",
                          "# v 9 9 9\\\n\tv 0 \\\n0.5\\\r\n -1#c\nv 1.25 0 3\\\n\nvn 1 \\\n  v 2\nv -2000 1 1e-3\n"
                          "g x\\\nf 1 1 1\ns 1\nusemtl f 1\nf  2 3 \\\n 1 # f 1 1 1\nl 1 2\np 1\n"),
                     "comments, continued lines, other statements");

  // Numbers that only just fit, or do not.
  CHECK(read("a.obj", "v 1e-400 0 0\nv 1 4.9406564584124654e-324 0\nv 0 1.7976931348623157e308 0\nf 1 2 3\n")
            .points[0][0] == 0);
  check_error("a.obj", "v 1 2 3\nv 1e400 0 0\n", ":2: vertex 1 has a coordinate that is not finite");
  check_error("a.obj", "v 1 2 3\nv 0 nan 0\n", ":2: vertex 1 has a coordinate that is not finite");
  check_error("a.obj", "v 1 2 -inf\n", ":1: vertex 0 has a coordinate that is not finite");

  check_error("a.obj", "", ": is empty");
  check_error("a.obj", "# nothing\n", ": holds no vertices");
  check_error("a.obj", v, ": holds no faces");
  check_error("a.obj", v + "f 1 2 4\nf 1 2 9\n",
              ":4: face 0 has a corner at vertex 3 (counted from 0), the mesh has 3 vertices");
  check_error("a.obj", "f 1 2 3\nf 1 9 2\n" + v + "f 1 8 2\n", ":2: face 1 has a corner at vertex 8");
  check_error("a.obj", v + "f 1 0 2\n", ":4: face 0 has the vertex index 0, OBJ counts from 1");
  check_error("a.obj", v + "f 1 -4 2\n", ":4: face 0 has the vertex index -4, there are 3 vertices before it");
  check_error("a.obj", v + "f 1 2 3\nf 1 2\n", ":5: face 1 has 2 corners only");
  check_error("a.obj", v + "f 1 2 3\nf 1 2 3 1\n",
              ":5: face 1 has 4 corners; the mesh must consist of triangles, or be "
              "read with the option triangulate_faces (command line: --triangulate)");
  check_error("a.obj", "v 1 2\nv 1 2 3\n", ":1: the line ends where a coordinate should follow");
  check_error("a.obj", "v 1 2 3\nv 1 2", ":2: the file ends where a coordinate should follow");
  check_error("a.obj", "v 1 2 3\nv 1,5 2 3\n", ":2: \"1,5\" is not a number");
  check_error("a.obj", "v 1 2 3\nv 1 x\x07y 3\n", ":2: \"x?y\" is not a number");
  check_error("a.obj", "v 1 \\\n2 3\nv 1 x 2\n", ":3: \"x\" is not a number");
  check_error("a.obj", "g a\\\nb\nv 1 x 2\n", ":3: \"x\" is not a number");
  check_error("a.obj", "v 1 2 +-3\n", ":1: \"+-3\" is not a number");
  check_error("a.obj", v + "f 1 2 3.5\n", ":4: \"3.5\" is not a whole number");
  check_error("a.obj", v + "f 1 2 99999999999999999999\n", ":4: \"99999999999999999999\" is not a whole number");
  check_error("a.xyz", v, ": unknown kind of mesh file \".xyz\"");
  CHECK_THROWS(Input_error, IO::read_mesh(folder.path("none.obj")),
               folder.path("none.obj") + ": cannot read: No such file");
  std::filesystem::create_directory(folder.path("folder.obj"));
  CHECK_THROWS(Input_error, IO::read_mesh(folder.path("folder.obj")), ": cannot read: Is a directory");
}

void test_triangulation()
{
  const std::string v = "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\n";
  const Indexed_mesh mesh = read("t.obj", v + "f 1 2 3 4 5\nf 3 2 1\n", true);
  CHECK((mesh.triangles == std::vector<Triangle>{{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 4}}, {{2, 1, 0}}}));
  CHECK_THROWS(Input_error, read("t.obj", v + "f 1 2 3 4 5\nf 1 2\n", true), ":7: face 1 has 2 corners");
}

void test_off()
{
  const std::string v = "0 0.5 -1\n1.25 0 3\n-2000 1 1e-3\n";
  check_the_triangle(read("a.off", "OFF\n3 1 0\n" + v + "3 1 2 0\n"), "plain");
  check_the_triangle(read("a.off", "# made by hand\nOFF 3 1 3 # counts\n\n#\n" + v + "\n# c\n3  1 2 0 255 0 0\n\n#\n"),
                     "comments, counts after the keyword, colour of the face");
  check_the_triangle(read("a.off", "OFF\r\n3 1\r\n0 0.5 -1 \r\n1.25 0 3\r\n-2000 1 1e-3\r\n3 1 2 0"), "CRLF, no edges");
  check_the_triangle(
      read("a.off", "STCNOFF\n3 1 0\n0 .5 -1 0 0 1 9 9 9 255 1 1\n1.25 0 3 4 4 4\n-2000 1 1e-3\n3 1 2 0\n"),
      "normals, colours, texture coordinates");

  check_the_triangle(read("a.off", "OFF3 1 0\n" + v + "3 1 2 0\n"), "counts joined to the keyword");
  check_the_triangle(read("a.off", "off\n3 1 0\n" + v + "3 1 2 0\n"), "small letters");
  check_the_triangle(read("a.off", "NCOFF\n3 1 0\n0 .5 -1 0 0 1 9 9 9\n1.25 0 3 1 1 1 4 4 4\n-2000 1 1e-3\n3 1 2 0\n"),
                     "prefixes in another order");
  check_the_triangle(read("a.off", "stcoff 3 1 0\n" + v + "3 1 2 0\n"), "prefixes in small letters");
  check_error("a.off", "nOFF\n2 3 1 0\n", ":1: the file starts with \"nOFF\" instead of OFF");
  check_error("a.off", "OFFS\n3 1 0\n", ":1: the file starts with \"OFFS\" instead of OFF");
  check_error("a.off", "OF\n", ":1: the file starts with \"OF\" instead of OFF");
  check_error("a.off", "4OFF\n1 1 0\n", ":1: the file starts with \"4OFF\" instead of OFF");
  check_error("a.off", "OFF BINARY\n", ":1: binary OFF is not supported");
  check_error("a.off", "OFF\n3\n1 0\n", ":4: the file ends after 0 of 3 vertices");
  check_error("a.off", "OFF\n-3 1 0\n", ":2: the number of vertices is negative");
  check_error("a.off", "OFF\n3 1 0\n" + v.substr(0, 18), ":5: the file ends after 2 of 3 vertices");
  check_error("a.off", "OFF\n3 1 0\n" + v.substr(0, 16), ":4: the file ends where a coordinate should follow");
  check_error("a.off", "OFF\n999999999999999999 1 0\n" + v, ":6: the file ends after 3 of 999999999999999999 vertices");
  check_error("a.off", "OFF\n3 2 0\n" + v + "3 1 2 0\n", ":7: the file ends after 1 of 2 faces");
  check_error("a.off", "OFF\n3 1 0\n" + v + "3 1 2 3\n", ":6: face 0 has a corner at vertex 3");
  check_error("a.off", "OFF\n3 1 0\n" + v + "3 1 2 -1\n", ":6: face 0 has a negative vertex index");
  check_error("a.off", "OFF\n3 1 0\n" + v + "4 0 1 2 0\n", ":6: face 0 has 4 corners");
  check_error("a.off", "OFF\n3 1 0\n" + v + "3 1 2\n", ":6: the line ends where a vertex should follow");
  check_error("a.off", "OFF\n3 1 0\n" + v + "3 1 2 0\n3 2 1 0\n",
              ":7: the file goes on after the 3 vertices and 1 faces");
  check_error("a.off", "OFF\n3 1 0\n0 0 inf\n" + v, ":3: vertex 0 has a coordinate that is not finite");
  check_error("a.off", "OFF\n0 0 0\n", ": holds no vertices");
}

void test_ply()
{
  const std::string counts = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string ascii = "ply\nformat ascii 1.0\ncomment hello\n" + counts;
  const std::string v = "0 0.5 -1\n1.25 0 3\n-2000 1 1e-3\n";
  check_the_triangle(read("a.ply", ascii + v + "3 1 2 0\n"), "plain");
  check_the_triangle(read("a.ply",
                          "ply\r\nformat ascii 1.0\r\nobj_info o\r\nelement thing 1\r\nproperty list int8 float32 l\r\n"
                          "element vertex 3\r\nproperty uchar red\r\nproperty double z\r\nproperty double y\r\n"
                          "property double x\r\nelement face 1\r\nproperty list uint16 float64 w\r\n"
                          "property list uint8 uint16 vertex_index\r\nproperty uint8 q\r\nend_header\r\n"
                          "2 7 7\r\n9 -1 .5 0\r\n9 3 0 1.25\r\n9 1e-3 1 -2e3\r\n1 0.5 3 1 2 0 8\r\n"),
                     "other elements, properties and types, CRLF");

  std::string little, big;
  for (const auto& p : points)
    for (double x : p) {
      little += little_endian(float(x));
      big += big_endian(float(x));
    }
  little += '\3';
  big += '\3';
  for (std::size_t i : triangle) {
    little += little_endian(std::uint32_t(i));
    big += big_endian(std::uint32_t(i));
  }
  const std::string little_header = "ply\nformat binary_little_endian 1.0\n" + counts;
  check_the_triangle(read("a.ply", little_header + little), "little-endian");
  check_the_triangle(read("a.ply", "ply\nformat binary_big_endian 1.0\n" + counts + big), "big-endian");

  check_error("a.ply", "plx\n", ":1: the file does not start with \"ply\"");
  check_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", ":4: the file ends within the header");
  check_error("a.ply", "ply\nelement vertex 3\nend_header\n", ":3: the header names no format");
  check_error("a.ply", "ply\nformat ebcdic 1.0\n", ":2: unknown format \"ebcdic\"");
  check_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", ":4: \"half\" is no type");
  check_error("a.ply", "ply\nformat ascii 1.0\nproperty int x\n", ":3: a property before the first element");
  check_error("a.ply", "ply\nformat ascii 1.0\nelement vertex x\n", ":3: \"x\" is not a whole number");
  check_error("a.ply", "ply\nfromat ascii 1.0\n", ":2: unknown keyword \"fromat\"");
  check_error("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
              ": the vertices lack a property x, y or z");
  check_error("a.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list int int corners\nend_header\n0\n",
              ": the faces lack a list vertex_indices");
  check_error("a.ply", ascii + v.substr(0, 18), ":13: vertex 2: the file ends here, its header announces 3 of them");
  check_error("a.ply", ascii + v, ":14: face 0: the file ends here, its header announces 1 of them");
  check_error("a.ply", ascii + v + "3 1 2 3\n", ":14: face 0 has a corner at vertex 3");
  check_error("a.ply", ascii + v + "3 1 2 -3\n", ":14: face 0: a vertex index is negative");
  check_error("a.ply", ascii + v + "3 1 2 0.5\n", ":14: face 0: a vertex index is negative, too large or not a whole");
  check_error("a.ply", ascii + v + "4 1 2 0 1\n", ":14: face 0 has 4 corners");
  check_error("a.ply", ascii + v + "3 1 2 0\n7\n", ":15: the file goes on after all elements");
  check_error("a.ply", ascii + "0 nan 0\n", ":11: vertex 0 has a coordinate that is not finite");
  check_error("a.ply", little_header + little.substr(0, 35), ": vertex 2: the file ends here");
  check_error("a.ply", little_header + little.substr(0, 48), ": face 0: the file ends here");
  for (const char* end : {"\n", "\r\n", "\n\n"}) {
    const Indexed_mesh mesh = read("a.ply", little_header + little + end);
    check_the_triangle(mesh, "ends of lines after a binary file");
    CHECK(mesh.remarks == std::vector<std::string>{"an end of a line follows the last element, which says nothing"});
  }
  CHECK(read("a.ply", little_header + little).remarks.empty());
  // In ASCII a line is an element: nothing slides from one to the next.
  check_error("a.ply", ascii + "0 0.5 -1 255 0 0\n1.25 0 3 255 0 0\n",
              ": line 11 has 6 values, the header announces 3 (vertex 0)");
  check_error("a.ply", ascii + "0 0.5 -1\n1.25 0\n3\n", ": line 12 has 2 values, the header announces 3 (vertex 1)");
  check_error("a.ply", ascii + v + "3 1 2 0 255\n", ": line 14 has 5 values, the header announces 4 (face 0)");
  check_error("a.ply", ascii + v + "3 1 2\n0\n", ": line 14 has 3 values, the header announces 4 (face 0)");
  check_error("a.ply", little_header + little + "x", ": the file goes on after all elements");
  check_error("a.ply", little_header + little_endian(0x7fc00000u) + little.substr(4),
              ": vertex 0 has a coordinate that is not finite");
  check_error("a.ply",
              "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
              "property float z\nend_header\nabc",
              ": vertex 0: the file ends here");
}

// Strips of triangles, in which every second one is turned round; -1 ends a strip, a vertex twice joins two.
void test_ply_strips()
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
  const auto header = [](const std::string& format) {
    return "ply\nformat " + format + " 1.0\nelement vertex 5\nproperty float x\nproperty float y\n" +
           "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  };
  const std::vector<Triangle> strip = {{{0, 1, 2}}, {{2, 1, 3}}, {{2, 3, 4}}};
  const std::string ascii = header("ascii") + points;
  CHECK(read("s.ply", ascii + "5 0 1 2 3 4\n").triangles == strip);
  CHECK(
      (read("s.ply", ascii + "9 0 1 2 -1 4 2 3 -1 0\n").triangles == std::vector<Triangle>{{{0, 1, 2}}, {{4, 2, 3}}}));
  CHECK((read("s.ply", ascii + "7 0 1 2 2 4 2 3\n").triangles == std::vector<Triangle>{{{0, 1, 2}}, {{4, 2, 3}}}));
  std::string binary = header("binary_little_endian");
  for (float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 1.f, 1.f, 0.f, 0.f, 2.f, 0.f})
    binary += little_endian(x);
  for (std::uint32_t i : {6u, 0u, 1u, 2u, 3u, 4u, 0xffffffffu}) binary += little_endian(i);
  CHECK(read("s.ply", binary).triangles == strip);
  check_error("s.ply", ascii + "4 0 1 2 -2\n", ":15: tristrips 0: a vertex index is negative");
  check_error("s.ply", ascii + "3 0 1 7\n", ":15: face 0 has a corner at vertex 7");
}

void test_stl()
{
  // Two triangles with an edge in common; a negative zero is a zero.
  const std::string start = "solid two triangles\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
                            "   vertex 0 1 0\n  endloop\n endfacet\n";
  const std::string ascii = start + " facet normal 0 0 1\n  outer loop\n   vertex 1 0 -0\n   vertex 1 1.5 0\n"
                                    "   vertex -0.0 1 0\n  endloop\n endfacet\nendsolid two triangles\n";
  const auto check_two = [](const Indexed_mesh& mesh, const char* what) {
    report(mesh.points == std::vector<std::array<double, 3>>{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1.5, 0}}} &&
               mesh.triangles == std::vector<Triangle>{{{0, 1, 2}}, {{1, 3, 2}}},
           __FILE__, __LINE__, what);
  };
  check_two(read("a.stl", ascii), "ASCII");
  const std::size_t second = start.size();
  check_two(read("a.stl", start + "endsolid\nsolid other\n" + ascii.substr(second)), "two solids");

  std::string capitals = ascii;
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  check_two(read("a.stl", capitals), "in capitals");

  const float corners[2][9] = {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, -0.f, 1, 1.5, 0, -0.f, 1, 0}};
  std::string binary = "solid, or so it says" + std::string(60, ' ') + little_endian(std::uint32_t(2));
  for (const auto& t : corners) {
    binary += std::string(12, '\1'); // a normal that nobody should look at
    for (float x : t) binary += little_endian(x);
    binary += std::string(2, '\0');
  }
  check_two(read("a.stl", binary), "binary");

  std::string header(80, 'h');
  check_error("a.stl", "  \n", ": is empty");
  check_error("a.stl", "hello", ": is neither ASCII STL");
  check_error("a.stl", header + binary.substr(80, 60), ": binary STL of 2 triangles takes 184 bytes, the file has 140");
  check_error("a.stl", header + binary.substr(80) + "x",
              ": binary STL of 2 triangles takes 184 bytes, the file has 185");
  check_error("a.stl", start, ":9: the file ends within a solid, after face 1");
  check_error("a.stl", start.substr(0, 60), ":4: ");
  check_error("a.stl", start.substr(0, start.find("endloop")), ":7: the file ends within face 0");
  check_error("a.stl", "solid\nfacet\nouter ring\n", ":3: \"ring\" where \"loop\" should follow");
  check_error("a.stl", "solid\nfacet\nouter loop\nvertex 1 2 nan\n",
              ":4: vertex 0 has a coordinate that is not finite");
  check_error("a.stl",
              "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n",
              ":2: face 0 has 4 corners");
}

void test_write_obj()
{
  Indexed_mesh mesh;
  mesh.points = {{{0.1, -1. / 3, 1e-310}}, {{1234567.5, 1e300, 2}}, {{-0., 3, 1e22}}};
  mesh.triangles = {{{2, 0, 1}}};
  std::ostringstream os; // has the hostile locale
  IO::write_obj(os, mesh);
  CHECK(os.str() == "v 0.1 -0.3333333333333333 1e-310\nv 1234567.5 1e+300 2\nv -0 3 1e+22\nf 3 1 2\n");

  std::mt19937_64 random(1);
  mesh.points.clear();
  for (int i = 0; i < 20000; ++i) { // more than one block of output
    std::array<double, 3> p;
    for (double& x : p) {
      const std::uint64_t bits = random();
      std::memcpy(&x, &bits, 8);
      if (!(std::abs(x) <= 1e308)) x = 0;
    }
    mesh.points.push_back(p);
  }
  os.str("");
  IO::write_obj(os, mesh);
  const Indexed_mesh back = read("round.obj", os.str());
  CHECK(back.points == mesh.points);
  CHECK(back.triangles == mesh.triangles);
}

void test_surface_mesh()
{
  // A grid on which faces are joined in any order, and an isolated vertex in front.
  const std::size_t n = 12;
  Indexed_mesh mesh;
  mesh.points.push_back({{9, 9, 9}});
  for (std::size_t i = 0; i < n * n; ++i) mesh.points.push_back({{double(i % n), double(i / n), 0}});
  for (std::size_t y = 0; y + 1 < n; ++y)
    for (std::size_t x = 0; x + 1 < n; ++x) {
      const std::size_t v = 1 + y * n + x;
      mesh.triangles.push_back({{v, v + 1, v + n}});
      mesh.triangles.push_back({{v + n + 1, v + n, v + 1}});
    }
  std::mt19937 random(7);
  bool good = true;
  for (int i = 0; i < 50 && good; ++i) {
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    const auto surface = IO::to_surface_mesh(mesh, "grid");
    good = surface.is_valid(false) && num_vertices(surface) == n * n + 1 && num_faces(surface) == mesh.triangles.size();
    std::size_t f = 0;
    for (const auto face : faces(surface)) {
      std::array<std::size_t, 3> corners = {{0, 0, 0}};
      std::size_t c = 0;
      for (const auto v : vertices_around_face(surface.halfedge(face), surface)) corners[c++ % 3] = v;
      const Triangle& t = mesh.triangles[f++];
      good = good && c == 3 && std::is_permutation(corners.begin(), corners.end(), t.begin());
    }
    for (std::size_t v = 0; v < mesh.points.size() && good; ++v) {
      const auto p = surface.point(CGAL::SM_Vertex_index(unsigned(v)));
      good = p.x() == mesh.points[v][0] && p.y() == mesh.points[v][1] && p.z() == mesh.points[v][2];
    }
    good = good && surface.is_isolated(CGAL::SM_Vertex_index(0));
  }
  CHECK(good);

  const auto error = [](const std::vector<Triangle>& triangles, const std::string& message) {
    Indexed_mesh bad;
    bad.points.assign(7, {{0, 0, 0}});
    bad.triangles = triangles;
    CHECK_THROWS(Input_error, IO::to_surface_mesh(bad, "walk.obj"), "walk.obj: " + message);
  };
  error({{{0, 1, 2}}, {{3, 4, 3}}}, "face 1 has vertex 3 twice");
  error({{{0, 1, 2}}, {{3, 4, 7}}}, "face 1 has a corner at vertex 7, there are 7 vertices");
  error({{{0, 1, 2}}, {{2, 3, 4}}, {{1, 0, 3}}, {{5, 1, 0}}}, "edge (0, 1) belongs to 3 faces, among them 0, 2 and 3");
  error({{{0, 1, 2}}, {{3, 0, 1}}}, "faces 0 and 1 both run along edge (0, 1) from 0 to 1");
  error({{{0, 1, 2}}, {{0, 1, 2}}}, "faces 0 and 1 both run along edge (0, 1)");
  error({{{5, 0, 1}}, {{5, 1, 2}}, {{5, 3, 4}}}, "vertex 5 joins parts of the surface that share no edge there, with "
                                                 "faces ");
  // two closed surfaces that touch in a vertex
  error({{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 1}}, {{1, 3, 2}}, {{0, 5, 4}}, {{0, 6, 5}}, {{0, 4, 6}}, {{4, 5, 6}}},
        "vertex 0 joins parts");
}

// The same mesh as if its triangles were added one by one, down to the halfedges.
bool is_as_added(const Indexed_mesh& mesh)
{
  const auto surface = IO::to_surface_mesh(mesh, "mesh");
  typedef std::decay_t<decltype(surface)> Surface;
  Surface expected;
  for (const auto& p : mesh.points) expected.add_vertex(Surface::Point(p[0], p[1], p[2]));
  for (const Triangle& t : mesh.triangles) {
    std::vector<Surface::Vertex_index> corners;
    for (std::size_t v : t) corners.emplace_back(unsigned(v));
    if (CGAL::Euler::add_face(corners, expected) == Surface::null_face()) return false;
  }
  if (num_vertices(surface) != num_vertices(expected) || num_faces(surface) != num_faces(expected) ||
      num_halfedges(surface) != num_halfedges(expected))
    return false;
  bool good = surface.is_valid(false);
  for (auto h : halfedges(expected))
    good = good && surface.target(h) == expected.target(h) && surface.face(h) == expected.face(h) &&
           surface.next(h) == expected.next(h) && surface.prev(h) == expected.prev(h);
  for (auto v : vertices(expected))
    good = good && surface.halfedge(v) == expected.halfedge(v) && surface.point(v) == expected.point(v);
  for (auto f : faces(expected)) good = good && surface.halfedge(f) == expected.halfedge(f);
  return good;
}

void test_surface_mesh_as_added()
{
  std::mt19937 random(11);
  const auto number = [&](std::size_t n) { return std::size_t(random() % n); };
  bool good = true;

  // Two triangles back to back, and a tetrahedron beside an isolated vertex.
  Indexed_mesh small;
  small.points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{7, 7, 7}}};
  small.triangles = {{{0, 1, 2}}, {{0, 2, 1}}};
  good = good && is_as_added(small);
  small.triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}};
  good = good && is_as_added(small);
  CHECK(good);

  // Tori with holes, in any order; the parts come together only after a while.
  for (int i = 0; i < 100; ++i) {
    const std::size_t m = 3 + number(6), n = 3 + number(6);
    Indexed_mesh torus;
    std::vector<std::size_t> name(m * n + 1); // one vertex is isolated
    std::iota(name.begin(), name.end(), std::size_t(0));
    std::shuffle(name.begin(), name.end(), random);
    for (std::size_t v = 0; v < name.size(); ++v) torus.points.push_back({{double(v), 0, 0}});
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < m; ++x) {
        const std::size_t a = name[y * m + x], b = name[y * m + (x + 1) % m], c = name[(y + 1) % n * m + (x + 1) % m],
                          d = name[(y + 1) % n * m + x];
        torus.triangles.push_back({{a, b, c}});
        torus.triangles.push_back({{c, d, a}});
      }
    for (Triangle& t : torus.triangles) std::rotate(t.begin(), t.begin() + std::ptrdiff_t(number(3)), t.end());
    std::shuffle(torus.triangles.begin(), torus.triangles.end(), random);
    good = good && is_as_added(torus);
    if (i % 2 == 0) { // holes where they leave a manifold
      torus.triangles.resize(torus.triangles.size() - number(m));
      try {
        IO::internal::check_manifold(torus, "torus");
      } catch (const Input_error&) {
        continue;
      }
      good = good && is_as_added(torus);
    }
  }
  CHECK(good);

  // Any triangles: what is no surface is found by the quick way if and only if the thorough one says why.
  std::size_t surfaces = 0, others = 0, different = 0;
  for (int i = 0; i < 20000; ++i) {
    Indexed_mesh any;
    any.points.assign(4 + number(4), {{0, 0, 0}});
    any.triangles.resize(1 + number(8));
    for (Triangle& t : any.triangles)
      for (std::size_t& v : t) v = number(any.points.size());
    bool is_surface = true;
    try {
      IO::internal::check_manifold(any, "any");
    } catch (const Input_error&) {
      is_surface = false;
    }
    different += IO::internal::Corner_adjacency(any).is_manifold() != is_surface;
    if (is_surface) different += !is_as_added(any);
    (is_surface ? surfaces : others) += 1;
  }
  CHECK(different == 0);
  CHECK(surfaces > 1000 && others > 1000);
}

} // namespace

int main()
{
  use_hostile_locale();
  test_obj();
  test_triangulation();
  test_off();
  test_ply();
  test_ply_strips();
  test_stl();
  test_write_obj();
  test_surface_mesh();
  test_surface_mesh_as_added();
  return test_result();
}
