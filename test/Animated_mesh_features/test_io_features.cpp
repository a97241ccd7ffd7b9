// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Results in files: JSON that a parser gives back, tables, point clouds, arrays; in any locale.

#include "test_io_support.h"

#include <CGAL/Animated_mesh_features/IO/Result_description.h>
#include <CGAL/Animated_mesh_features/IO/write_csv.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/IO/write_npy.h>
#include <CGAL/Animated_mesh_features/IO/write_ply.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // asked for by property_tree in Boost 1.74, where it would warn of itself
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cmath>
#include <limits>
#include <list>
#include <sstream>
#include <string>
#include <vector>

using namespace CGAL::Animated_mesh_features;
using namespace test_support;
using boost::property_tree::ptree;

namespace {

// Whatever a vertex descriptor is, it does not appear in files.
struct Opaque_vertex
{
};

typedef Spatio_temporal_feature<Opaque_vertex> Feature;

// A forward range, not a vector.
std::list<Feature> features()
{
  Feature a;
  a.vertex_index = 1234567;
  a.frame = 1007;
  a.time = 0.1;
  a.triangle = {{1234567, 1300000, 20}};
  a.barycentric_coordinates = {{0.5, 0.25, 0.25}};
  a.position = {{-1.5, 1234.5, 1e-20}};
  a.rest_position = {{2, 3, 1. / 3}};
  a.sigma = 0.25;
  a.tau = 1e20;
  a.response = -0.31;
  a.at_scale_limit = true;
  Feature b;
  b.response = -0.125;
  b.sigma = 0.5;
  return {a, b};
}

std::string json(const std::list<Feature>& f, const IO::Result_description& d)
{
  std::ostringstream os; // has the hostile locale
  IO::write_json(os, f, d);
  return os.str();
}

// Parsed by somebody else; numbers stay the text that they are.
ptree parsed(const std::string& text)
{
  std::istringstream is(text);
  is.imbue(std::locale::classic());
  ptree tree;
  boost::property_tree::read_json(is, tree);
  return tree;
}

std::string joined(const ptree& tree)
{
  std::string s;
  for (const auto& member : tree) s += member.first + "=" + member.second.data() + " ";
  return s;
}

void test_json()
{
  IO::Result_description d;
  d.vertices = 8431;
  d.faces = 1234567;
  d.frames = 48;
  d.frame_duration = 1. / 30;
  d.bounding_box_diagonal = 2.54;
  d.mean_edge_length = 1e-7;
  d.add("preset", "calibrated");
  d.add("file", std::string("a \"b\" \\ /\n\t\x01\x1f \xc3\xa4\xe2\x82\xac\xf0\x9f\x90\xb4.obj"));
  d.add("latin-1", "caf\xe9!");
  d.add("count", 1000000u);
  d.add("negative", -5L);
  d.add("threshold", 0.2);
  d.add("single", 0.5f);
  d.add("whole", 3.);
  d.add("yes", true);
  d.add("no", false);
  d.add("none", IO::Result_description::Value());
  d.add("infinite", std::numeric_limits<double>::infinity());
  d.add("range", std::vector<double>{0.012, 0.15});
  d.add("inputs", std::vector<std::string>{"x,y", ""});
  d.add("empty", std::vector<double>());
  const std::string text = json(features(), d);
  const ptree tree = parsed(text);

  std::string members;
  for (const auto& member : tree) members += member.first + " ";
  CHECK(members == "format version animation parameters features ");
  CHECK(tree.get<std::string>("format") == "animated-mesh-features");
  CHECK(text.find("\"version\": 1,") != std::string::npos);
  CHECK(joined(tree.get_child("animation")) ==
        "vertices=8431 faces=1234567 frames=48 frame_duration=0.03333333333333333 bounding_box_diagonal=2.54 "
        "mean_edge_length=1e-07 ");

  const ptree& p = tree.get_child("parameters");
  CHECK(joined(p) == "preset=calibrated file=a \"b\" \\ /\n\t\x01\x1f \xc3\xa4\xe2\x82\xac\xf0\x9f\x90\xb4.obj "
                     "latin-1=caf\xef\xbf\xbd! count=1000000 negative=-5 threshold=0.2 single=0.5 whole=3 yes=true "
                     "no=false none=null infinite=null range= inputs= empty= ");
  CHECK(joined(p.get_child("range")) == "=0.012 =0.15 ");
  CHECK(joined(p.get_child("inputs")) == "=x,y = ");
  CHECK(text.find("\"yes\": true") != std::string::npos); // not a string
  CHECK(text.find("\"preset\": \"calibrated\"") != std::string::npos);
  CHECK(text.find("\"none\": null") != std::string::npos);
  CHECK(text.find("\"count\": 1000000,") != std::string::npos);
  CHECK(text.find("\"empty\": []") != std::string::npos);

  const ptree& f = tree.get_child("features");
  CHECK(f.size() == 2);
  const ptree& a = f.front().second;
  CHECK(joined(a) == "vertex=1234567 frame=1007 time=0.1 position= sigma=0.25 tau=1e+20 radius=0.3535533905932738 "
                     "response=-0.31 strength=0.31 rest_position= triangle= barycentric_coordinates= "
                     "at_scale_limit=true ");
  CHECK(joined(a.get_child("position")) == "=-1.5 =1234.5 =1e-20 ");
  CHECK(joined(a.get_child("rest_position")) == "=2 =3 =0.3333333333333333 ");
  CHECK(joined(a.get_child("triangle")) == "=1234567 =1300000 =20 ");
  CHECK(joined(a.get_child("barycentric_coordinates")) == "=0.5 =0.25 =0.25 ");
  CHECK(f.back().second.get<std::string>("strength") == "0.125");

  const ptree empty = parsed(json({}, IO::Result_description()));
  CHECK(empty.count("features") == 1 && empty.get_child("features").empty());

  // Bytes that are no UTF-8 in ways that decoders have fallen for: overlong, half a surrogate pair, cut off, too large.
  for (const char* bad : {"\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xe2\x82", "\xf4\x90\x80\x80", "\x80", "\xf8"}) {
    IO::Result_description names;
    names.add("name", bad);
    std::string expected;
    for (const char* c = bad; *c != '\0'; ++c) expected += "\xef\xbf\xbd";
    CHECK(parsed(json({}, names)).get<std::string>("parameters.name") == expected);
  }
}

void test_csv()
{
  std::ostringstream os;
  IO::write_csv(os, features());
  CHECK(os.str() == "vertex,frame,time,x,y,z,sigma,tau,radius,response,strength,rest_x,rest_y,rest_z,"
                    "triangle_0,triangle_1,triangle_2,barycentric_0,barycentric_1,barycentric_2,at_scale_limit\n"
                    "1234567,1007,0.1,-1.5,1234.5,1e-20,0.25,1e+20,0.3535533905932738,-0.31,0.31,2,3,"
                    "0.3333333333333333,1234567,1300000,20,0.5,0.25,0.25,true\n"
                    "0,0,0,0,0,0,0.5,0,0.7071067811865476,-0.125,0.125,0,0,0,0,0,0,1,0,0,false\n");
}

void test_ply()
{
  const std::string start = " 1.0\ncomment spatio-temporal features of an animated mesh\nelement vertex 2\n"
                            "property float x\nproperty float y\nproperty float z\nproperty float sigma\n"
                            "property float tau\nproperty float time\nproperty float strength\n"
                            "property float radius\nproperty int frame\nproperty int vertex\nend_header\n";
  std::ostringstream ascii;
  IO::write_ply(ascii, features(), false);
  CHECK(ascii.str() == "ply\nformat ascii" + start +
                           "-1.5 1234.5 1e-20 0.25 1e+20 0.1 0.31 0.35355338 1007 1234567\n"
                           "0 0 0 0.5 0 0 0.125 0.70710677 0 0\n");
  std::string expected = "ply\nformat binary_little_endian" + start;
  for (const Feature& f : features()) {
    for (double x : {f.position[0], f.position[1], f.position[2], f.sigma, f.tau, f.time, f.strength(), f.radius()})
      expected += little_endian(float(x));
    expected += little_endian(std::uint32_t(f.frame)) + little_endian(std::uint32_t(f.vertex_index));
  }
  std::ostringstream binary;
  IO::write_ply(binary, features());
  CHECK(binary.str() == expected);

  std::list<Feature> large = features();
  large.front().vertex_index = std::size_t(1) << 31;
  CHECK_THROWS(Output_error, IO::write_ply(binary, large), "PLY cannot hold the index 2147483648");
}

template <class FT>
void test_npy_of()
{
  for (std::size_t frames : {0u, 3u, 17u, 100000u}) {
    Spatio_temporal_field<FT> field(2, frames);
    std::string values;
    for (std::size_t v = 0; v < 2; ++v)
      for (std::size_t f = 0; f < frames; ++f) {
        field(v, f) = FT(f) / 8 - FT(v);
        values += little_endian(float(f) / 8 - float(v));
      }
    std::ostringstream os;
    IO::write_npy(os, field);
    const std::string npy = os.str();
    const std::size_t header = (unsigned char)npy[8] + 256 * (unsigned char)npy[9];
    CHECK(npy.substr(0, 8) == std::string("\x93NUMPY\1\0", 8));
    CHECK((10 + header) % 64 == 0 && npy[9 + header] == '\n');
    const std::string dictionary =
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, " + std::to_string(frames) + "), }";
    CHECK(npy.substr(10, dictionary.size()) == dictionary);
    CHECK(npy.substr(10 + dictionary.size(), header - dictionary.size() - 1).find_first_not_of(' ') ==
          std::string::npos);
    CHECK(npy.substr(10 + header) == values);
  }
}

} // namespace

int main()
{
  use_hostile_locale();
  test_json();
  test_csv();
  test_ply();
  test_npy_of<float>();
  test_npy_of<double>();
  return test_result();
}
