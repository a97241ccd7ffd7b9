// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Results in files: JSON that a parser gives back and that is read back, tables, point clouds, arrays; and the truths that
// they are compared with, paintings and events of rigs. In any locale.

#include "test_io_support.h"

#include <CGAL/Animated_mesh_features/IO/Result_description.h>
#include <CGAL/Animated_mesh_features/IO/joint_angles.h>
#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/IO/read_npy.h>
#include <CGAL/Animated_mesh_features/IO/read_painting.h>
#include <CGAL/Animated_mesh_features/IO/read_rig_events.h>
#include <CGAL/Animated_mesh_features/IO/write_csv.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/IO/write_npy.h>
#include <CGAL/Animated_mesh_features/IO/write_ply.h>
#include <CGAL/Animated_mesh_features/IO/write_rig_events.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#define BOOST_BIND_GLOBAL_PLACEHOLDERS // asked for by property_tree in Boost 1.74, where it would warn of itself
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <list>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
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
  a.amplitude = 0.75;
  a.fit = 0.5;
  a.strength = 0.375;
  a.place = 3;
  a.parent = 12;
  a.at_scale_limit = true;
  Feature b;
  b.response = -0.125;
  b.strength = 0.125;
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
                     "latin-1=caf\xef\xbf\xbd! count=1000000 negative=-5 threshold=0.2 single=0.5 whole=3.0 yes=true "
                     "no=false none=null infinite=null range= inputs= empty= ");
  CHECK(joined(p.get_child("range")) == "=0.012 =0.15 ");
  CHECK(joined(p.get_child("inputs")) == "=x,y = ");
  CHECK(text.find("\"yes\": true,") != std::string::npos); // not a string
  CHECK(text.find("\"preset\": \"calibrated\"") != std::string::npos);
  CHECK(text.find("\"none\": null") != std::string::npos);
  CHECK(text.find("\"count\": 1000000,") != std::string::npos);
  CHECK(text.find("\"empty\": []") != std::string::npos);

  const ptree& f = tree.get_child("features");
  CHECK(f.size() == 2);
  const ptree& a = f.front().second;
  CHECK(joined(a) == "rank=1 vertex=1234567 frame=1007 time=0.1 position= sigma=0.25 tau=1e+20 radius=0.3535533905932738 "
                     "response=-0.31 amplitude=0.75 fit=0.5 strength=0.375 place=4 parent=13 rest_position= triangle= barycentric_coordinates= "
                     "at_scale_limit=true ");
  CHECK(joined(a.get_child("position")) == "=-1.5 =1234.5 =1e-20 ");
  CHECK(joined(a.get_child("rest_position")) == "=2.0 =3.0 =0.3333333333333333 ");
  CHECK(joined(a.get_child("triangle")) == "=1234567 =1300000 =20 ");
  CHECK(joined(a.get_child("barycentric_coordinates")) == "=0.5 =0.25 =0.25 ");
  CHECK(f.back().second.get<std::string>("strength") == "0.125");
  CHECK(f.back().second.get<std::string>("parent") == "null");
  CHECK(f.back().second.get<std::string>("rank") == "2" && f.back().second.get<std::string>("place") == "1");

  const ptree empty = parsed(json({}, IO::Result_description()));
  CHECK(empty.count("features") == 1 && empty.get_child("features").empty());

  // Bytes that are no UTF-8 in ways that decoders have fallen for: overlong, half a surrogate pair, cut off, too large. A
  // sequence that is only cut off is one wrong character, of others each byte.
  const std::vector<std::pair<std::string, std::size_t>> bad_bytes = {
      {"\xc0\xaf", 2},         {"\xe0\x80\xaf", 3}, {"\xed\xa0\x80", 3}, {"\xe2\x82", 1},
      {"\xf4\x90\x80\x80", 4}, {"\x80", 1},         {"\xf8", 1}};
  for (const auto& bad : bad_bytes) {
    IO::Result_description names;
    names.add("name", bad.first);
    std::string expected;
    for (std::size_t i = 0; i < bad.second; ++i) expected += "\xef\xbf\xbd";
    CHECK(parsed(json({}, names)).get<std::string>("parameters.name") == expected);
  }
}

// ----------------------------------------------------------------------------------------------------- reading JSON

IO::Feature_file_data read_text(const std::string& text)
{
  std::istringstream is(text); // has the hostile locale
  return IO::read_json(is, "x.json");
}

std::string written(const IO::Feature_file_data& data)
{
  std::ostringstream os;
  IO::write_json(os, data);
  return os.str();
}

// Of numbers, zeros with their signs.
bool same_bits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(double)) == 0;
}

template <std::size_t n>
bool same_bits(const std::array<double, n>& a, const std::array<double, n>& b)
{
  return std::memcmp(a.data(), b.data(), sizeof(a)) == 0;
}

void check_same(const Feature_point& a, const Feature_point& b)
{
  CHECK(a.vertex_index == b.vertex_index && a.frame == b.frame && a.triangle == b.triangle);
  CHECK(same_bits(a.time, b.time) && same_bits(a.position, b.position) && same_bits(a.rest_position, b.rest_position));
  CHECK(same_bits(a.sigma, b.sigma) && same_bits(a.tau, b.tau) && same_bits(a.response, b.response));
  CHECK(same_bits(a.amplitude, b.amplitude) && same_bits(a.fit, b.fit) && same_bits(a.strength, b.strength));
  CHECK(a.place == b.place && a.parent == b.parent);
  CHECK(same_bits(a.barycentric_coordinates, b.barycentric_coordinates) && a.at_scale_limit == b.at_scale_limit);
}

// Any finite number there is, as likely as another.
template <class Random>
double any_number(Random& random)
{
  double x = std::numeric_limits<double>::quiet_NaN();
  while (!std::isfinite(x)) {
    const std::uint64_t bits = random();
    std::memcpy(&x, &bits, sizeof(x));
  }
  return x;
}

IO::Result_description some_animation()
{
  IO::Result_description d;
  d.vertices = 2000000;
  d.faces = 4000000;
  d.frames = 2000;
  d.frame_duration = 0.1;
  d.bounding_box_diagonal = 2.54;
  d.mean_edge_length = 1e-7;
  return d;
}

void test_json_read_back()
{
  std::mt19937_64 random(1);
  std::vector<Feature_point> many;
  for (std::size_t i = 0; i < 500; ++i) {
    Feature_point f;
    f.vertex_index = random() % 2000000;
    f.frame = random() % 2000;
    for (std::size_t& v : f.triangle) v = random() % 2000000;
    f.place = random() % 1000;
    if (i % 3 == 0) f.parent = random() % 1000;
    for (double* x : {&f.time, &f.sigma, &f.tau, &f.response, &f.amplitude, &f.fit, &f.strength}) *x = any_number(random);
    for (auto* p : {&f.position, &f.rest_position, &f.barycentric_coordinates})
      for (double& x : *p) x = any_number(random);
    f.at_scale_limit = i % 2 == 0;
    many.push_back(f);
  }
  many[0].time = 12.3;
  many[1].position = {{-0., 0, 5e-324}};
  many[2].sigma = (std::numeric_limits<double>::max)();

  IO::Result_description d = some_animation();
  d.add("z", "text \"\\\n\xc3\xa4");
  d.add("a", true);
  d.add("none", IO::Result_description::Value());
  d.add("whole", -5);
  d.add("largest", (std::numeric_limits<std::int64_t>::max)());
  d.add("real", 3.);
  d.add("infinite", std::numeric_limits<double>::infinity());
  d.add("numbers", std::vector<double>{1, 0.1, -std::numeric_limits<double>::infinity()});
  d.add("texts", std::vector<std::string>{"", "b"});
  d.add("nothing", std::vector<std::string>());
  std::ostringstream os;
  IO::write_json(os, many, d);
  const std::string text = os.str();
  const IO::Feature_file_data data = read_text(text);

  const IO::Result_description& e = data.description;
  CHECK(e.vertices == d.vertices && e.faces == d.faces && e.frames == d.frames);
  CHECK(same_bits(e.frame_duration, d.frame_duration) && same_bits(e.mean_edge_length, d.mean_edge_length));
  CHECK(same_bits(e.bounding_box_diagonal, d.bounding_box_diagonal) && e.origins.empty() && e.origins.parts.empty());
  CHECK(data.file_vertices.empty());
  CHECK(e.parameters.size() == d.parameters.size());
  for (std::size_t i = 0; i < 6; ++i) CHECK(e.parameters[i] == d.parameters[i]); // and their types
  CHECK(e.parameters[6].second == IO::Result_description::Value());
  const std::vector<double> numbers = std::get<std::vector<double>>(e.parameters[7].second);
  CHECK(numbers.size() == 3 && numbers[0] == 1 && numbers[1] == 0.1 && std::isnan(numbers[2]));
  CHECK(e.parameters[8] == d.parameters[8]);
  CHECK(std::get<std::vector<double>>(e.parameters[9].second).empty());

  CHECK(data.features.size() == many.size());
  for (std::size_t i = 0; i < many.size(); ++i) check_same(data.features[i], many[i]);
  CHECK_NEAR(data.features[0].refined_frame, 123, 1e-12);
  CHECK(written(data) == text);

  // the same from a file
  const Temporary_folder folder;
  CHECK(written(IO::read_json(folder.write("f.json", text))) == text);
  CHECK_THROWS(Input_error, IO::read_json(folder.path("none.json")), "none.json: cannot read");
  CHECK_THROWS(Input_error, IO::read_json(folder.path()), folder.path() + ": cannot read");
  std::istringstream broken(text);
  broken.setstate(std::ios::badbit);
  CHECK_THROWS(Input_error, IO::read_json(broken, "x.json"), "x.json: cannot read");

  // without features, and without anything
  CHECK(written(read_text(json({}, d))) == json({}, d));
  CHECK(written(read_text(json({}, IO::Result_description()))) == json({}, IO::Result_description()));
}

// Vertices that are made of several of the file.
void test_json_origins()
{
  IO::Result_description d = some_animation();
  d.vertices = 3;
  d.origins.parts = {{"node \"0\"", 0, 4}, {"", 4, 2}};
  d.origins.first = {0, 2, 3, 5};
  d.origins.file_vertices = {0, 5, 1, 2, 4};
  std::list<Feature> two = features();
  two.front().vertex_index = 2;
  two.front().triangle = {{2, 1, 0}};
  const std::string text = json(two, d);
  const IO::Feature_file_data data = read_text(text);
  CHECK(data.description.origins.parts.size() == 2);
  CHECK(data.description.origins.parts[0].name == "node \"0\"" && data.description.origins.parts[1].first_vertex == 4);
  CHECK(data.file_vertices == (std::vector<std::vector<std::size_t>>{{2, 4}, {0, 5}}));
  CHECK(written(data) == text);
  CHECK(written(read_text(json({}, d))) == json({}, d));

  // a selection of features
  IO::Feature_file_data last = data;
  last.features.erase(last.features.begin());
  last.file_vertices.erase(last.file_vertices.begin());
  CHECK(read_text(written(last)).file_vertices == last.file_vertices);

  const auto replaced = [&](const std::string& part, const std::string& by) {
    std::string changed = text;
    changed.replace(changed.find(part), part.size(), by);
    return changed;
  };
  CHECK_THROWS(Input_error, read_text(replaced("[0,5]", "[0,6]")),
               "x.json: features[1].file_vertices[1]: there is no vertex of the file 6, only 6");
  CHECK_THROWS(Input_error, read_text(replaced("[0,5]", "7")), "x.json: features[1].file_vertices: an array");
  CHECK_THROWS(Input_error, read_text(replaced(",\"file_vertices\":[0,5]", "")),
               "x.json: features[1].file_vertices: is missing");
  CHECK_THROWS(Input_error, read_text(replaced(",\"file_vertices\":[2,4]", "")),
               "x.json: features[1]: has file_vertices, the first feature has not");
  CHECK_THROWS(Input_error, read_text(replaced("\"first_vertex\":4,", "")),
               "x.json: animation.parts[1].first_vertex: is missing");
}

void test_json_errors()
{
  IO::Result_description d = some_animation();
  d.add("a", 1);
  d.add("b", 2);
  const std::string text = json(features(), d);
  CHECK(read_text(text).features.size() == 2);
  // of several such parts, the last
  const auto replaced = [&](const std::string& part, const std::string& by) {
    std::string changed = text;
    const std::size_t place = changed.rfind(part);
    CHECK(place != std::string::npos);
    changed.replace(place, part.size(), by);
    return changed;
  };
  const auto check = [&](const std::string& part, const std::string& by, const std::string& message) {
    CHECK_THROWS(Input_error, read_text(replaced(part, by)), "x.json: " + message);
  };

  // no JSON, with the place
  CHECK_THROWS(Input_error, read_text(""), "x.json: is no valid JSON: line 1, column 1");
  CHECK_THROWS(Input_error, read_text(text + "}"), "x.json: is no valid JSON: line");
  CHECK_THROWS(Input_error, read_text(text.substr(0, text.size() - 10)), "x.json: is no valid JSON: line 8, column");
  check("\"sigma\":0.5", "\"sigma\":NaN", "is no valid JSON: line 8, column 78, at features[1].sigma");
  check("\"sigma\":0.5", "\"sigma\":0,5", "is no valid JSON: line 8");
  check("\"sigma\":0.5", "\"sigma\":1e999", "a number is too large, at features[1].sigma");
  check("[1.0,0.0,0.0]", "[1.0,Infinity,0]", "is no valid JSON: line 8");
  check("[1.0,0.0,0.0]", "[1.0,1e999,0]", "a number is too large, at features[1].barycentric_coordinates[1]");
  check("\"b\"", "\"\xff\"", "is no valid JSON: line 5, column 4");
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  check("\"b\": 2", "\"b\": " + nested(100000), "is nested too deeply");
  check("\"version\"", "\"x\": " + nested(64) + ",\"version\"", "is nested too deeply");
  CHECK(read_text(replaced("\"version\"", "\"x\": " + nested(63) + ",\"version\"")).features.size() == 2);

  // another file, another version
  for (const char* other : {"[]", "{}", "null", "{\"format\": 1}", "{\"format\": \"animated-mesh-features-scene\"}"})
    CHECK_THROWS(Input_error, read_text(other), "x.json: is no file of features: it has no \"format\"");
  check("\"version\": 1", "\"version\": 2", "has version 2 of the format; known is version 1 only");
  check("\"version\": 1", "\"version\": \"1\"", "version: a whole number is expected");
  check("\"version\": 1,", "", "version: is missing");

  // members that are missing, one after the other
  for (const char* name : {"animation", "parameters", "features"})
    check("\"" + std::string(name) + "\"", "\"x\"", std::string(name) + ": is missing");
  for (const char* name :
       {"vertices", "faces", "frames", "frame_duration", "bounding_box_diagonal", "mean_edge_length"})
    check("\"" + std::string(name) + "\"", "\"x\"", "animation." + std::string(name) + ": is missing");
  for (const char* name : {"vertex", "frame", "time", "position", "sigma", "tau", "response", "rest_position",
                           "triangle", "barycentric_coordinates", "at_scale_limit"})
    check("\"" + std::string(name) + "\":", "\"x\":", "features[1]." + std::string(name) + ": is missing");

  // members of another type, or out of range
  check("\"vertices\":2000000", "\"vertices\":-1", "animation.vertices: a whole number is expected, 0 or more");
  check("\"frames\":2000", "\"frames\":2000.5", "animation.frames: a whole number is expected");
  check("\"frame_duration\":0.1", "\"frame_duration\":null", "animation.frame_duration: a finite number is expected");
  check("\"frame_duration\":0.1", "\"frame_duration\":-0.1", "animation.frame_duration: is negative");
  check("\"frame_duration\":0.1", "\"frame_duration\":0", "animation.frame_duration: is not positive");
  check("\"a\": 1", "\"a\": {}", "parameters.a: a truth value");
  check("\"a\": 1", "\"a\": [1, \"x\"]", "parameters.a: a truth value");
  check("\"a\": 1", "\"b\": 1", "parameters: two parameters have the same name");
  check("\"vertex\":0", "\"vertex\":2000000", "features[1].vertex: there is no vertex 2000000, only 2000000");
  check("\"vertex\":0", "\"vertex\":18446744073709551616", "features[1].vertex: a whole number is expected");
  check("\"frame\":0", "\"frame\":2000", "features[1].frame: there is no frame 2000, only 2000");
  check("\"frame\":0", "\"frame\":true", "features[1].frame: a whole number is expected");
  check("\"time\":0.0", "\"time\":\"0\"", "features[1].time: a finite number is expected");
  check("\"sigma\":0.5", "\"sigma\":null", "features[1].sigma: a finite number is expected");
  check("\"triangle\":[0,0,0]", "\"triangle\":[0,0,2000000]", "features[1].triangle[2]: there is no vertex 2000000");
  check("\"triangle\":[0,0,0]", "\"triangle\":[0,0]", "features[1].triangle: three values are expected");
  check("\"position\":[0.0,0.0,0.0]", "\"position\":{}", "features[1].position: an array is expected");
  check("[1.0,0.0,0.0]", "[1.0,0.0,null]", "features[1].barycentric_coordinates[2]: a finite number is expected");
  check("\"at_scale_limit\":false", "\"at_scale_limit\":0", "features[1].at_scale_limit: true or false is expected");

  // what is not known, and what follows from other members
  for (const char* more : {"\"x\":{\"sigma\":7},", "\"parts\":3,", "\"radius\":\"large\","}) {
    const IO::Feature_file_data data = read_text(replaced("\"sigma\":0.5", more + std::string("\"sigma\":0.5")));
    CHECK(data.features.size() == 2 && data.features[1].sigma == 0.5);
    CHECK(written(data) == text);
  }
  CHECK(written(read_text(replaced("\"radius\":0.7071067811865476,", ""))) == text);
  // what files of other programs need not have
  const IO::Feature_file_data few = read_text(replaced("\"amplitude\":0.0,\"fit\":1.0,", ""));
  CHECK(few.features[1].amplitude == 0 && few.features[1].fit == 1 && written(few) == text);
  CHECK(written(read_text(replaced("\"format\"", "\"x\": [null], \"format\""))) == text);
  CHECK(written(read_text(replaced("\"faces\"", "\"x\": 1, \"faces\""))) == text);
  check("\"place\":1", "\"place\":0", "features[1].place: is 0: ranks and places are counted from 1");
  // ranks of a selection: parents are found by them, or were not selected
  const auto selected = [&](const std::string& parent) {
    std::string changed = replaced("\"parent\":null", "\"parent\":" + parent);
    changed.replace(changed.find("\"rank\":1"), 8, "\"rank\":7");
    changed.replace(changed.find("\"rank\":2"), 8, "\"rank\":9");
    return read_text(changed).features[1].parent;
  };
  CHECK(selected("7") == 0 && selected("1") == Feature_point::none && selected("null") == Feature_point::none);
  CHECK(read_text(replaced("\"parent\":null", "\"parent\":1")).features[1].parent == 0);
}

// nlohmann-json finds what makes an object of a feature.
void test_json_objects()
{
  const nlohmann::ordered_json all = std::vector<Feature>(2, features().front());
  CHECK(all.size() == 2 && all[1].size() == 17 && all[1].begin().key() == "vertex");
  CHECK(all[0]["sigma"] == 0.25 && all[0]["triangle"][1] == 1300000 && all[0]["at_scale_limit"] == true);
  CHECK(json(features(), IO::Result_description()).find("{\"rank\":1," + all[0].dump().substr(1)) != std::string::npos);
}

void test_csv()
{
  std::ostringstream os;
  IO::write_csv(os, features());
  CHECK(os.str() == "rank,vertex,frame,time,x,y,z,sigma,tau,radius,response,amplitude,fit,strength,place,parent,rest_x,rest_y,rest_z,"
                    "triangle_0,triangle_1,triangle_2,barycentric_0,barycentric_1,barycentric_2,at_scale_limit\n"
                    "1,1234567,1007,0.1,-1.5,1234.5,1e-20,0.25,1e+20,0.3535533905932738,-0.31,0.75,0.5,0.375,4,13,2,3,"
                    "0.3333333333333333,1234567,1300000,20,0.5,0.25,0.25,true\n"
                    "2,0,0,0,0,0,0,0.5,0,0.7071067811865476,-0.125,0,1,0.125,1,,0,0,0,0,0,0,1,0,0,false\n");
}

void test_ply()
{
  const std::string start = " 1.0\ncomment spatio-temporal features of an animated mesh\nelement vertex 2\n"
                            "property float x\nproperty float y\nproperty float z\nproperty float sigma\n"
                            "property float tau\nproperty float time\nproperty float strength\n"
                            "property float radius\nproperty float amplitude\nproperty float fit\nproperty int frame\nproperty int vertex\n"
                            "property int rank\nproperty int place\nproperty int parent\n"
                            "property uchar at_scale_limit\n";
  const std::string plain = start + "end_header\n";
  std::ostringstream ascii;
  IO::write_ply(ascii, features(), false);
  CHECK(ascii.str() == "ply\nformat ascii" + plain +
                           "-1.5 1234.5 1e-20 0.25 1e+20 0.1 0.375 0.35355338 0.75 0.5 1007 1234567 1 4 13 1\n"
                           "0 0 0 0.5 0 0 0.125 0.70710677 0 1 0 0 2 1 0 0\n");
  const std::vector<std::array<std::uint8_t, 3>> colours = {{{255, 0, 7}}, {{1, 2, 3}}};
  std::ostringstream coloured;
  IO::write_ply(coloured, features(), false, colours);
  CHECK(coloured.str() == "ply\nformat ascii" + start +
                              "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
                              "-1.5 1234.5 1e-20 0.25 1e+20 0.1 0.375 0.35355338 0.75 0.5 1007 1234567 1 4 13 1 255 0 7\n"
                              "0 0 0 0.5 0 0 0.125 0.70710677 0 1 0 0 2 1 0 0 1 2 3\n");
  CHECK_THROWS(Option_error, IO::write_ply(coloured, features(), false, {{{1, 2, 3}}}), "1 colours for 2 features");
  std::string expected = "ply\nformat binary_little_endian" + plain;
  std::uint32_t rank = 0;
  for (const Feature& f : features()) {
    for (double x : {f.position[0], f.position[1], f.position[2], f.sigma, f.tau, f.time, f.strength, f.radius(), f.amplitude, f.fit})
      expected += little_endian(float(x));
    expected += little_endian(std::uint32_t(f.frame)) + little_endian(std::uint32_t(f.vertex_index));
    expected += little_endian(++rank) + little_endian(std::uint32_t(f.place + 1));
    expected += little_endian(f.parent == Feature::none ? std::uint32_t(0) : std::uint32_t(f.parent + 1));
    expected += f.at_scale_limit ? '\1' : '\0';
  }
  std::ostringstream binary;
  IO::write_ply(binary, features());
  CHECK(binary.str() == expected);
  std::ostringstream both;
  IO::write_ply(both, features(), true, colours);
  CHECK(both.str().size() == expected.size() + std::string("property uchar red\nproperty uchar green\nproperty uchar blue\n").size() + 6);
  CHECK(both.str().substr(both.str().size() - 3) == "\1\2\3");

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

void test_npy_read_back()
{
  const Temporary_folder folder;
  Spatio_temporal_field<float> field(3, 5);
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t f = 0; f < 5; ++f) field(v, f) = float(v) + 0.1f * float(f) - 1e-20f;
  field(1, 1) = std::numeric_limits<float>::infinity();
  std::ostringstream os;
  IO::write_npy(os, field);
  const std::string npy = os.str();
  const auto same = [&](const auto& read) {
    bool is_same = read.number_of_rows() == 3 && read.number_of_frames() == 5;
    for (std::size_t v = 0; is_same && v < 3; ++v)
      for (std::size_t f = 0; f < 5; ++f) is_same = is_same && read(v, f) == field(v, f);
    return is_same;
  };
  CHECK(same(IO::read_npy<float>(folder.write("a.npy", npy))));
  CHECK(same(IO::read_npy<double>(folder.write("a.npy", npy))));

  // double precision, and the longer header of version 2
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }\n", values(16, '\0');
  const double two[] = {0.1, -2e300};
  std::memcpy(&values[0], two, 16);
  const std::string second =
      std::string("\x93NUMPY\2\0", 8) + char(header.size()) + std::string(3, '\0') + header + values;
  const auto read = IO::read_npy<double>(folder.write("b.npy", second));
  CHECK(read.number_of_rows() == 1 && read.number_of_frames() == 2 && read(0, 0) == 0.1 && read(0, 1) == -2e300);

  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = npy;
    text.replace(text.find(what), what.size(), by);
    return IO::read_npy<float>(folder.write("c.npy", text));
  };
  CHECK_THROWS(Input_error, replaced("NUMPY", "NUMPI"), "no NumPy file");
  CHECK_THROWS(Input_error, replaced("<f4", "<i4"), "float32");
  CHECK_THROWS(Input_error, replaced("<f4", ">f4"), "float32");
  CHECK_THROWS(Input_error, replaced("False", "True "), "C order");
  CHECK_THROWS(Input_error, replaced("(3, 5)", "(5, 5)"), "60 bytes");
  CHECK_THROWS(Input_error, replaced("(3, 5)", "(15,) "), "N x F");
  CHECK_THROWS(Input_error, replaced("(3, 5)", "(3, 0)"), "no frames");
  CHECK_THROWS(Input_error, replaced("'shape'", "'shade'"), "without shape");
  CHECK_THROWS(Input_error, replaced("(3, 5)", "(-3,5)"), "N x F");
  for (std::size_t length : {std::size_t(0), std::size_t(9), std::size_t(30), npy.size() - 1})
    CHECK_THROWS(Input_error, IO::read_npy<float>(folder.write("d.npy", npy.substr(0, length))), "d.npy: ");
  CHECK_THROWS(Input_error, IO::read_npy<float>(folder.path("none.npy")), "none.npy");
}

const char* const painting = R"({"format": "animated-mesh-features-painting", "version": 1,
 "animation": {"vertices": 10, "frames": 5, "frame_duration": 0.04}, "painter": "A", "more": 1,
 "strokes": [{"frame": 2, "frames": [1, 3], "vertices": [9, 0, 9]}, {"frames": [4, 4], "vertices": []}]})";

void test_painting()
{
  const Temporary_folder folder;
  const IO::Painting_file_data data = IO::read_painting(folder.write("a.json", painting));
  CHECK(data.vertices == 10 && data.frames == 5 && data.frame_duration == 0.04 && data.painter == "A");
  CHECK(data.strokes.size() == 2);
  CHECK(data.strokes[0].first_frame == 1 && data.strokes[0].last_frame == 3);
  CHECK(data.strokes[0].vertices == std::vector<std::size_t>({9, 0, 9}));
  CHECK(data.strokes[1].first_frame == 4 && data.strokes[1].vertices.empty());

  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = painting;
    text.replace(text.find(what), what.size(), by);
    return IO::read_painting(folder.write("b.json", text));
  };
  CHECK_THROWS(Input_error, replaced("-painting", ""), "b.json: is no painting");
  CHECK_THROWS(Input_error, replaced("\"version\": 1", "\"version\": 2"), "version 2");
  CHECK_THROWS(Input_error, replaced("0.04", "0"), "animation.frame_duration: is not positive");
  CHECK_THROWS(Input_error, replaced("\"A\"", "7"), "painter: a text");
  CHECK_THROWS(Input_error, replaced("\"painter\"", "\"by\""), "painter: is missing");
  CHECK_THROWS(Input_error, replaced("[9, 0, 9]", "[9, 10]"), "strokes[0].vertices[1]: there is no vertex 10, only 10");
  CHECK_THROWS(Input_error, replaced("[9, 0, 9]", "[-1]"), "strokes[0].vertices[0]: a whole number");
  CHECK_THROWS(Input_error, replaced("[1, 3]", "[1, 5]"), "strokes[0].frames[1]: there is no frame 5");
  CHECK_THROWS(Input_error, replaced("[1, 3]", "[3, 1]"), "strokes[0].frames: the last frame is before");
  CHECK_THROWS(Input_error, replaced("[1, 3]", "[1]"), "strokes[0].frames: the first and the last");
  CHECK_THROWS(Input_error, replaced("\"frame\": 2", "\"frame\": 0"), "strokes[0].frame: is not within");
  CHECK_THROWS(Input_error, replaced("}]}", "}]"), "no valid JSON");
}

void test_rig_events()
{
  IO::Rig_file_data data;
  data.vertices = 100;
  data.frames = 48;
  data.frame_duration = 1. / 30;
  data.joints = {{"left \"knee\"", {1, 99}, {{0.1, 45.25, 1. / 3}, {0.7, 1e-3, 0}}}, {"tail", {}, {}}};
  std::ostringstream os;
  IO::write_rig_events(os, data);
  const Temporary_folder folder;
  const IO::Rig_file_data read = IO::read_rig_events(folder.write("rig.json", os.str()));
  CHECK(read.vertices == 100 && read.frames == 48 && read.frame_duration == data.frame_duration);
  CHECK(read.joints.size() == 2 && read.joints[0].name == data.joints[0].name && read.joints[1].name == "tail");
  CHECK(read.joints[0].region == data.joints[0].region && read.joints[1].maxima.empty());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto &a = read.joints[0].maxima.at(i), &b = data.joints[0].maxima[i];
    CHECK(a.time == b.time && a.angle == b.angle && a.prominence == b.prominence);
  }
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = os.str();
    text.replace(text.find(what), what.size(), by);
    return IO::read_rig_events(folder.write("b.json", text));
  };
  CHECK_THROWS(Input_error, replaced("-rig-events", ""), "b.json: holds no events");
  CHECK_THROWS(Input_error, replaced("99", "100"), "joints[0].region[1]: there is no vertex 100");
  CHECK_THROWS(Input_error, replaced("45.25", "-4"), "joints[0].maxima[0].angle_deg: is negative");
  CHECK_THROWS(Input_error, replaced("\"time\"", "\"when\""), "joints[0].maxima[0].time: is missing");
  CHECK_THROWS(Input_error, replaced("\"tail\"", "null"), "joints[1].name: a text");
}

// An arm of two bones on a node that is none: the upper one turns by 90 degrees and back, the lower one rests. At rest, both
// are turned already.
void test_joint_angles()
{
  const double half = std::sqrt(0.5);
  IO::Keyframed_model model;
  model.nodes.resize(4);
  model.nodes[0].name = "arm";
  model.nodes[1].name = "upper";
  model.nodes[1].parent = 0;
  model.nodes[1].rotation = {{0, half, 0, half}};
  model.nodes[2].name = "lower";
  model.nodes[2].parent = 1;
  model.nodes[2].rotation = {{half, 0, 0, half}};
  IO::Keyframed_model::Geometry geometry;
  geometry.points.resize(4);
  // all of the upper bone; a third of the lower one; all of the lower one; a twentieth of it
  geometry.influences = {{0, 1.}, {0, 2. / 3}, {1, 1. / 3}, {1, 1.}, {0, 0.95}, {1, 0.05}};
  geometry.first_influence = {0, 1, 3, 4, 6};
  model.geometries.push_back(geometry);
  model.skins.push_back({{1, 2}, {Eigen::Affine3d::Identity(), Eigen::Affine3d::Identity()}});
  IO::Keyframed_model::Part part;
  part.geometry = 0;
  part.node = 3;
  model.parts.push_back(part); // without a skin: its vertices are counted, too
  part.skin = 0;
  model.parts.push_back(part);
  IO::Keyframed_model::Clip clip;
  clip.channels.resize(1);
  clip.channels[0].node = 1;
  clip.channels[0].path = IO::Keyframed_model::Path::ROTATION;
  IO::Keyframe_track& track = clip.channels[0].track;
  track.is_rotation = true;
  track.width = 4;
  track.times = {0, 1, 2};
  // from rest by 90 degrees about the y axis, and back; the last key is the other quaternion of the same rotation
  track.values = {0, half, 0, half, 0, 1, 0, 0, 0, -half, 0, -half};

  const std::vector<IO::Joint_angles> joints = IO::joint_angles(model, clip, {0, 0.5, 1, 1.25, 2});
  CHECK(joints.size() == 2);
  CHECK(joints[0].name == "upper" && joints[1].name == "lower");
  const std::vector<double> expected = {0, 45, 90, 67.5, 0};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK_NEAR(joints[0].angles[i], expected[i], 1e-5);
    CHECK(joints[1].angles[i] == 0);
  }
  CHECK(joints[0].region.empty());                          // it moves all of every vertex
  CHECK(joints[1].region == std::vector<std::size_t>({5})); // 4 vertices of the first part before
}

} // namespace

int main()
{
  use_hostile_locale();
  test_json();
  test_json_read_back();
  test_json_origins();
  test_json_errors();
  test_json_objects();
  test_csv();
  test_ply();
  test_npy_of<float>();
  test_npy_of<double>();
  test_npy_read_back();
  test_painting();
  test_rig_events();
  test_joint_angles();
  return test_result();
}
