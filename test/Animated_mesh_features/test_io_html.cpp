// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Scenes in HTML pages: decoded as the description of the format says, by code of its own, they are what was written.

#include "test_io_support.h"

#ifndef ANIMATED_MESH_FEATURES_TEST_WITH_ZLIB

int main()
{
  std::cout << "skipped: needs zlib" << std::endl;
  return test_support::skipped;
}

#else

  #include "page/write_html.h"
  #include "rendering/Palette.h"
  #include "scenes/Shown_scene.h"

  #include <nlohmann/json.hpp>

  #include <zlib.h>

  #define BOOST_BIND_GLOBAL_PLACEHOLDERS // asked for by property_tree in Boost 1.74, where it would warn of itself
  #include <boost/property_tree/json_parser.hpp>
  #include <boost/property_tree/ptree.hpp>

  #include <algorithm>
  #include <array>
  #include <cmath>
  #include <cstddef>
  #include <limits>
  #include <sstream>
  #include <string>
  #include <utility>
  #include <vector>

using namespace CGAL::Animated_mesh_features;
using namespace test_support;
using boost::property_tree::ptree;

namespace {

typedef Programs::Shown_sequence Sequence;
typedef Programs::Shown_feature Feature;
typedef Programs::Shown_scene Scene;
typedef Programs::Shown_values Values;
typedef Sequence::Triangle_mesh Mesh;
typedef Sequence::Point_3 Point;

const std::string page_head = "<html><title>a page</title>\n", page_tail = "<script>program</script></html>\n";
const std::string page = page_head + "<!--scene-->" + page_tail;

// A rectangle of triangles, with an isolated vertex between the others, so that not every vertex has a neighbour.
Mesh sheet(int columns, int rows)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      if (i == 2 && j == 1) mesh.add_vertex(Point(100, 100, 100));
      v.push_back(mesh.add_vertex(Point(i, j, 0)));
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.add_face(v[std::size_t(a)], v[std::size_t(b)], v[std::size_t(d)]);
      mesh.add_face(v[std::size_t(a)], v[std::size_t(d)], v[std::size_t(c)]);
    }
  return mesh;
}

// It waves, and walks off, many times its size.
std::vector<std::vector<Point>> wave(const Mesh& mesh, int frames, double travel)
{
  std::vector<std::vector<Point>> result;
  for (int f = 0; f < frames; ++f) {
    std::vector<Point> points;
    for (auto v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      points.emplace_back(p.x() + travel * f, p.y(), 0.7 * std::sin(0.5 * p.x() + 0.3 * f) - 1e-3 * travel * f);
    }
    result.push_back(points);
  }
  return result;
}

Feature feature(std::size_t vertex, double response)
{
  Feature f;
  f.vertex = Mesh::Vertex_index(unsigned(vertex));
  f.vertex_index = vertex;
  f.triangle = {{vertex, vertex, vertex}};
  f.frame = 1;
  f.time = 0.0512345678901;
  f.sigma = 1. / 3;
  f.tau = 0.07;
  f.response = response;
  f.strength = -response;
  return f;
}

// ------------------------------------------------------------------------------------------- a decoder of its own

std::string element(const std::string& html, const std::string& id)
{
  const std::size_t at = html.find("id=\"" + id + "\">");
  if (at == std::string::npos) return "";
  const std::size_t from = html.find('>', at) + 1;
  return html.substr(from, html.find("</script>", from) - from);
}

std::string from_base64(const std::string& text)
{
  std::string bytes;
  unsigned bits = 0, n = 0;
  for (char c : text) {
    const unsigned digit = c >= 'A' && c <= 'Z'   ? unsigned(c - 'A')
                           : c >= 'a' && c <= 'z' ? unsigned(c - 'a' + 26)
                           : c >= '0' && c <= '9' ? unsigned(c - '0' + 52)
                           : c == '+'             ? 62u
                           : c == '/'             ? 63u
                                                  : 64u;
    if (digit > 63) continue;
    bits = (bits << 6) | digit;
    n += 6;
    if (n >= 8) {
      n -= 8;
      bytes += char((bits >> n) & 255);
    }
  }
  return bytes;
}

std::vector<unsigned> numbers(const std::string& html, const std::string& id, std::size_t n, std::size_t width)
{
  const std::string packed = from_base64(element(html, id));
  std::vector<unsigned char> bytes(n * width + 1);
  uLongf size = uLongf(bytes.size());
  CHECK(uncompress(bytes.data(), &size, reinterpret_cast<const Bytef*>(packed.data()), uLong(packed.size())) == Z_OK);
  CHECK(size == n * width);
  std::vector<unsigned> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t b = 0; b < width; ++b) result[i] |= unsigned(bytes[b * n + i]) << (8 * b);
    result[i] = result[i] % 2 == 0 ? result[i] / 2 : ~(result[i] / 2);
  }
  return result;
}

// Not by property_tree's or the C library's own conversion, which follow the locale.
double number(const ptree& tree)
{
  std::istringstream text(tree.data());
  text.imbue(std::locale::classic());
  double x = std::numeric_limits<double>::quiet_NaN();
  text >> x;
  return x;
}

double number(const ptree& tree, const std::string& name)
{
  return number(tree.get_child(name));
}

struct Decoded
{
  ptree description;
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::vector<Point>> frames;
  std::vector<Point> rest; // wherever it is
  std::vector<std::vector<std::vector<double>>> fields;
  std::vector<std::size_t> vertices; // of the scene, that are in the page

  double operator[](const std::string& name) const { return number(description, name); }
};

std::vector<double> array(const ptree& tree)
{
  std::vector<double> result;
  for (const auto& x : tree) result.push_back(number(x.second));
  return result;
}

Decoded decoded(const std::string& html)
{
  Decoded d;
  std::istringstream text(element(html, "scene"));
  text.imbue(std::locale::classic());
  boost::property_tree::read_json(text, d.description);
  const std::size_t n = std::size_t(d["vertices"]), m = std::size_t(d["faces"]);
  const std::size_t kept = d.description.get_child("kept_frames").size();

  for (std::size_t v = 0; v < n; ++v) d.vertices.push_back(v);
  if (d.description.count("all_vertices") > 0) {
    std::vector<unsigned> names = numbers(html, "scene-vertices", n, 4);
    for (std::size_t i = 1; i < n; ++i) names[i] += names[i - 1];
    d.vertices.assign(names.begin(), names.end());
  }
  std::vector<unsigned> corners = numbers(html, "scene-faces", 3 * m, 4);
  for (std::size_t i = 1; i < corners.size(); ++i) corners[i] += corners[i - 1];
  for (std::size_t i = 0; i < m; ++i) d.faces.push_back({{corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]}});
  std::vector<std::size_t> parent(n, 0);
  std::vector<bool> has_parent(n, false);
  for (const auto& t : d.faces)
    for (std::size_t v : t)
      for (std::size_t w : t)
        if (w < v && (!has_parent[v] || w > parent[v])) {
          parent[v] = w;
          has_parent[v] = true;
        }
  for (std::size_t v = 1; v < n; ++v)
    if (!has_parent[v]) parent[v] = v - 1;

  // [frame][component][vertex]
  const auto unpredicted = [&](const std::vector<unsigned>& r, std::size_t components, unsigned mask,
                               std::size_t frames) {
    std::vector<std::vector<std::vector<unsigned>>> q(
        frames, std::vector<std::vector<unsigned>>(components, std::vector<unsigned>(n)));
    std::size_t i = 0;
    for (std::size_t k = 0; k < frames; ++k)
      for (std::size_t c = 0; c < components; ++c)
        for (std::size_t v = 0; v < n; ++v) {
          const auto before = [&](std::size_t w) { return k > 0 ? q[k - 1][c][w] : 0; };
          unsigned x = r[i++] + before(v);
          if (v > 0) x += q[k][c][parent[v]] - before(parent[v]);
          q[k][c][v] = x & mask;
        }
    return q;
  };
  const auto q = unpredicted(numbers(html, "scene-positions", 3 * n * kept, 2), 3, 0xffff, kept);
  const std::vector<double> origin = array(d.description.get_child("origin"));
  std::vector<std::vector<double>> corner;
  for (const auto& c : d.description.get_child("corners")) corner.push_back(array(c.second));
  const double step = d["step"];
  for (std::size_t k = 0; k < kept; ++k) {
    std::vector<Point> points;
    for (std::size_t v = 0; v < n; ++v)
      points.emplace_back(origin[0] + step * (corner[k][0] + q[k][0][v]),
                          origin[1] + step * (corner[k][1] + q[k][1][v]),
                          origin[2] + step * (corner[k][2] + q[k][2][v]));
    d.frames.push_back(points);
  }
  const auto rest = unpredicted(numbers(html, "scene-rest", 3 * n, 2), 3, 0xffff, 1).front();
  for (std::size_t v = 0; v < n; ++v)
    d.rest.emplace_back(d["rest_step"] * rest[0][v], d["rest_step"] * rest[1][v], d["rest_step"] * rest[2][v]);
  std::size_t index = 0;
  for (const auto& field : d.description.get_child("fields")) {
    const double min = number(field.second, "min"), max = number(field.second, "max");
    const double largest = number(field.second, "largest"), top = number(field.second, "top_level");
    const auto value = [&](double level) {
      return level <= top ? min + (max - min) * level / top : max + (largest - max) * (level - top) / (255 - top);
    };
    const auto levels =
        unpredicted(numbers(html, "scene-field-" + std::to_string(index++), n * kept, 1), 1, 0xff, kept);
    std::vector<std::vector<double>> values;
    for (const auto& frame : levels) {
      std::vector<double> row;
      for (unsigned level : frame[0]) row.push_back(value(level));
      values.push_back(row);
    }
    d.fields.push_back(values);
  }
  return d;
}

std::string written(const Scene& scene, const Programs::Html_options& options = Programs::Html_options())
{
  std::ostringstream os; // has the hostile locale
  Programs::write_html(os, scene, page, options);
  return os.str();
}

// ---------------------------------------------------------------------------------------------------------- the tests

// Colours at equal distances, between which the page interpolates, as near to the map as eight bits can be.
void check_colours(const ptree& colours, const Programs::Rendering::Colour_map& map)
{
  std::vector<std::array<double, 3>> table;
  for (const auto& c : colours) {
    const std::string text = c.second.get_value<std::string>();
    CHECK(text.size() == 7 && text[0] == '#');
    table.push_back({});
    for (std::size_t i = 0; i < 3; ++i) table.back()[i] = double(std::stoul(text.substr(1 + 2 * i, 2), nullptr, 16));
  }
  CHECK(table.size() > 2);
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000. * double(table.size() - 1);
    const std::size_t k = std::min(std::size_t(x), table.size() - 2);
    const auto expected = Programs::Rendering::encoded(map(i / 1000.));
    for (std::size_t c = 0; c < 3; ++c)
      CHECK_NEAR(table[k][c] + (x - double(k)) * (table[k + 1][c] - table[k][c]), expected[c], 2);
  }
}

// What is in no triangle is not seen, and must not make the grid coarser: it is put where a vertex is that is seen.
std::size_t shown(const Sequence& sequence, std::size_t v)
{
  const bool is_seen = !sequence.triangle_mesh().is_isolated(Mesh::Vertex_index(unsigned(v)));
  return is_seen ? v : sequence.rest_shape().triangles().front()[0];
}

void test_what_is_written(double travel)
{
  const Mesh mesh = sheet(9, 5);
  const auto points = wave(mesh, 5, travel);
  const Sequence sequence(mesh, points, 1. / 25);
  const std::vector<Feature> features = {feature(7, -0.75), feature(3, -1. / 3)};
  Values field(mesh.num_vertices(), 5), zero(mesh.num_vertices(), 5);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < 5; ++f) field(v, f) = std::cos(0.1 * double(v) + double(f)) - 3;
  field(4, 2) = 1000; // above nearly all others: cut
  const Scene scene{sequence, features, {{"strain", &field}, {"none", &zero}}, "</script><script>alert(\"a & b\")"};
  std::ostringstream os;
  const Programs::Html_report report = Programs::write_html(os, scene, page);
  const std::string html = os.str();
  CHECK(html.compare(0, page_head.size(), page_head) == 0);
  CHECK(html.compare(html.size() - page_tail.size(), page_tail.size(), page_tail) == 0);
  CHECK(html.find("</script><script>alert") == std::string::npos);

  const Decoded d = decoded(html);
  CHECK(d.description.get<std::string>("format") == "animated-mesh-features-scene");
  CHECK(d.description.get<std::string>("title") == scene.title);
  CHECK(d["frame_duration"] == 1. / 25);
  CHECK(d["frames"] == 5);
  CHECK_NEAR(d["bounding_box_diagonal"], sequence.rest_shape().bounding_box_diagonal(), 0);
  CHECK(report.frame_step == 1);
  check_colours(d.description.get_child("colours.field"), Programs::Rendering::field_colours());
  check_colours(d.description.get_child("colours.duration"), Programs::Rendering::duration_colours());

  CHECK(d.faces.size() == mesh.num_faces());
  std::size_t i = 0;
  for (const auto& t : sequence.rest_shape().triangles()) {
    for (std::size_t c = 0; c < 3; ++c) CHECK(d.faces[i][c] == t[c]);
    ++i;
  }

  // lengths at rest, which no frame has
  const auto rest = sequence.rest_shape().points();
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const auto w = shown(sequence, v), first = shown(sequence, 0);
    CHECK_NEAR(std::sqrt(CGAL::squared_distance(d.rest[v], d.rest[0])), (rest[w] - rest[first]).norm(), 1e-3);
  }

  double largest = 0;
  CHECK(d.frames.size() == 5);
  for (std::size_t f = 0; f < 5; ++f)
    for (std::size_t v = 0; v < points[f].size(); ++v)
      largest = (std::max)(largest, std::sqrt(CGAL::squared_distance(points[f][shown(sequence, v)], d.frames[f][v])));
  const double stated = d["largest_error"];
  CHECK_NEAR(stated, report.largest_error, 0);
  CHECK(stated < 1e-4);
  CHECK(largest / sequence.rest_shape().bounding_box_diagonal() <= stated * (1 + 1e-6));
  CHECK(largest / sequence.rest_shape().bounding_box_diagonal() > stated / 10); // the bound means something

  const auto& described = d.description.get_child("fields").front().second;
  const double min = number(described, "min"), max = number(described, "max");
  CHECK(described.get<std::string>("name") == "strain");
  CHECK(number(described, "largest") == 1000);
  CHECK(max < -1.9 && max > -2.1);
  double largest_of_field = 0;
  for (std::size_t f = 0; f < 5; ++f)
    for (std::size_t v = 0; v < field.number_of_rows(); ++v) {
      if (field(v, f) <= max) largest_of_field = (std::max)(largest_of_field, std::abs(field(v, f) - d.fields[0][f][v]));
      CHECK(d.fields[1][f][v] == 0);
    }
  CHECK(largest_of_field <= (max - min) / 446 * (1 + 1e-9));
  CHECK_NEAR(d.fields[0][2][4], 1000, 1e-9); // and in coarser steps above
  CHECK_NEAR(d["mean_edge_length"], sequence.rest_shape().mean_edge_length(), 0);

  CHECK(d.description.get_child("features").size() == 2);
  const ptree& second = d.description.get_child("features").back().second;
  CHECK(number(second, "vertex") == 3);
  CHECK(number(second, "strength") == 1. / 3);
  CHECK(number(second, "time") == 0.0512345678901);
  CHECK_NEAR(number(second, "radius"), std::sqrt(2.) / 3, 1e-15);
}

void test_fewer_frames()
{
  const Mesh mesh = sheet(9, 5);
  const auto points = wave(mesh, 30, 0.1);
  const Sequence sequence(mesh, points, 1. / 25);
  const std::vector<Feature> features;
  const Scene scene{sequence, features, {}, ""};
  Programs::Html_options options;
  options.frame_step = 4;
  const Decoded d = decoded(written(scene, options));
  const std::vector<double> kept = array(d.description.get_child("kept_frames"));
  const std::vector<double> expected = {0, 4, 8, 12, 16, 20, 24, 28, 29};
  CHECK(kept == expected);
  CHECK(d["frames"] == 30);
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (std::size_t v = 0; v < mesh.num_vertices(); ++v)
      CHECK(CGAL::squared_distance(points[std::size_t(kept[k])][shown(sequence, v)], d.frames[k][v]) < 1e-3);

  // as the limits tell
  options = Programs::Html_options();
  CHECK(Programs::html_sampling(9346, 48, options).frame_step == 1);
  options.most_positions = 100 * 50;
  options.fewest_frames = 24;
  CHECK(Programs::html_sampling(100, 50, options).frame_step == 1);
  CHECK(Programs::html_sampling(100, 51, options).frame_step == 2);
  CHECK(Programs::html_sampling(100, 151, options).frame_step == 4);
  CHECK(Programs::html_sampling(208, 1000, options).frame_step == 42);
  CHECK_THROWS(Option_error, Programs::html_sampling(209, 1000, options),
               "209 vertices leave room for 23 of its 1000 frames");
  CHECK_THROWS(Option_error, Programs::html_sampling(5001, 3, options), "leave room for 0 of its 3 frames");
  CHECK(Programs::html_sampling(1000, 5, options).frame_step == 1);
  options.frame_step = 3;
  CHECK(Programs::html_sampling(5001, 30, options).frame_step == 3);
  options = Programs::Html_options();
  options.most_positions = mesh.num_vertices() * 12;
  CHECK_THROWS(Option_error, written(scene, options), "too large for a page");
  options.fewest_frames = 10;
  CHECK(decoded(written(scene, options)).frames.size() == 11); // every third one, and the last
}

// A sheet that folds along its middle, with fewer vertices.
void test_fewer_vertices()
{
  const int columns = 80, rows = 40;
  const Mesh mesh = sheet(columns, rows);
  std::vector<std::vector<Point>> points;
  for (int f = 0; f < 6; ++f) {
    points.emplace_back();
    for (auto v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      const double off = p.x() - columns / 2, angle = 0.25 * f;
      points.back().emplace_back(off > 0 ? columns / 2 + off * std::cos(angle) : p.x(), p.y(),
                                 off > 0 ? off * std::sin(angle) : 0);
    }
  }
  const Sequence sequence(mesh, points, 1. / 25);
  std::vector<Feature> features = {feature(1000, -0.5), feature(2222, -0.25)};
  for (Feature& f : features) {
    for (const auto& t : sequence.rest_shape().triangles())
      if (t[0] == f.vertex_index || t[1] == f.vertex_index || t[2] == f.vertex_index)
        std::copy(t.begin(), t.end(), f.triangle.begin());
    f.barycentric_coordinates = {{0.25, 0.25, 0.5}};
  }
  Values field(mesh.num_vertices(), 6);
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < 6; ++f) field(v, f) = double(v);
  const Scene scene{sequence, features, {{"strain", &field}}, ""};
  Programs::Html_options options;
  options.fewest_vertices = 600;
  options.fewest_frames = 3;
  options.most_positions = 600 * 6;
  const Decoded d = decoded(written(scene, options));
  const std::size_t n = d.vertices.size();
  CHECK(d["vertices"] == double(n) && n <= 600 && n > 500);
  CHECK(d["all_vertices"] == double(mesh.num_vertices()) && d["all_faces"] == double(mesh.num_faces()));
  CHECK(d.description.get_child("kept_frames").size() == 6);

  // vertices of the sheet, exactly where they are
  for (std::size_t f = 0; f < 6; ++f)
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(i == 0 || d.vertices[i] > d.vertices[i - 1]);
      const double largest = d["largest_error"] * sequence.rest_shape().bounding_box_diagonal();
      CHECK(CGAL::squared_distance(points[f][d.vertices[i]], d.frames[f][i]) <= largest * largest * 1.001);
      CHECK_NEAR(d.fields[0][f][i], double(d.vertices[i]), double(mesh.num_vertices()) / 223);
    }

  // still a disc of the same shape, in all frames: its area is that of the sheet, no triangle is turned over
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t f = 0; f < 6; ++f) {
    double area = 0;
    for (const auto& t : d.faces) {
      const auto normal = CGAL::cross_product(d.frames[f][t[1]] - d.frames[f][t[0]], d.frames[f][t[2]] - d.frames[f][t[0]]);
      area += std::sqrt(normal.squared_length()) / 2;
      if (f == 0) CHECK(normal.z() > 0);
    }
    CHECK_NEAR(area, columns * rows, 1e-3 * columns * rows);
  }
  for (const auto& t : d.faces)
    for (std::size_t c = 0; c < 3; ++c) edges.emplace_back(t[c], t[(c + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end()); // an oriented manifold
  std::size_t border = 0;
  for (const auto& e : edges)
    border += std::binary_search(edges.begin(), edges.end(), std::make_pair(e.second, e.first)) ? 0 : 1;
  CHECK(border == 2 * (columns + rows)); // borders stay
  CHECK(n + d.faces.size() - (edges.size() + border) / 2 == 1); // Euler's characteristic of a disc

  // places of features on what is left
  std::size_t i = 0;
  CHECK(d.description.get_child("places").size() == 2);
  for (const auto& place : d.description.get_child("places")) {
    const std::vector<double> triangle = array(place.second.get_child("triangle"));
    const std::vector<double> weights = array(place.second.get_child("barycentric_coordinates"));
    CHECK_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-12);
    for (std::size_t f = 0; f < 6; ++f) {
      Eigen::Vector3d there(0, 0, 0), here(0, 0, 0);
      for (std::size_t c = 0; c < 3; ++c) {
        const Point& p = points[f][features[i].triangle[c]];
        const Point& q = d.frames[f][std::size_t(triangle[c])];
        there += features[i].barycentric_coordinates[c] * Eigen::Vector3d(p.x(), p.y(), p.z());
        here += weights[c] * Eigen::Vector3d(q.x(), q.y(), q.z());
      }
      CHECK_NEAR((there - here).norm(), 0, 0.02);
    }
    ++i;
  }
  CHECK(written(scene, options) == written(scene, options));
  options.fewest_vertices = mesh.num_vertices(); // frames are left out before vertices
  options.most_positions = mesh.num_vertices() * 4;
  const Decoded all = decoded(written(scene, options));
  CHECK(all.vertices.size() == mesh.num_vertices() && all.description.get_child("kept_frames").size() == 4);

  // as the limits tell
  options = Programs::Html_options();
  const Programs::Html_sampling large = Programs::html_sampling(100000, 300), larger = Programs::html_sampling(1000000, 1000);
  CHECK(large.vertices == 21666 && large.frame_step == 1);
  CHECK(larger.vertices == 20000 && larger.frame_step == 4);
  CHECK(Programs::html_sampling(8000, 1000).vertices == 8000);
  options.frame_step = 1;
  CHECK(Programs::html_sampling(100000, 300, options).vertices == 100000);
}

void test_bad_input()
{
  const Mesh mesh = sheet(4, 3);
  const Sequence sequence(mesh, wave(mesh, 4, 0), 0.1);
  std::ostringstream os;
  const std::vector<Feature> none, elsewhere = {feature(1000, -1)};
  CHECK_THROWS(Option_error, Programs::write_html(os, Scene{sequence, none, {}, ""}, "<html></html>"),
               "not the viewer");
  CHECK_THROWS(Input_error, Programs::write_html(os, Scene{sequence, elsewhere, {}, ""}, page), "1000");
  Values bad(3, 4), infinite(mesh.num_vertices(), 4);
  CHECK_THROWS(Option_error, Programs::write_html(os, Scene{sequence, none, {{"strain", &bad}}, ""}, page), "");
  infinite(2, 1) = std::numeric_limits<double>::infinity();
  CHECK_THROWS(Input_error, Programs::write_html(os, Scene{sequence, none, {{"strain", &infinite}}, ""}, page), "");
  CHECK(os.str().empty());
}

// Two scenes in one page are those that either has alone, under other names.
void test_pair()
{
  const Mesh mesh = sheet(4, 3), other_mesh = sheet(3, 2);
  const Sequence sequence(mesh, wave(mesh, 4, 0), 0.1), other_sequence(other_mesh, wave(other_mesh, 5, 1), 0.2);
  const std::vector<Feature> none;
  const Scene a{sequence, none, {}, "a"}, b{other_sequence, none, {}, "b"};
  const nlohmann::ordered_json comparison = {{"distance", 0.25}, {"name", "</script>"}};
  std::ostringstream os;
  const auto reports = Programs::write_html_pair(os, a, b, comparison, page);
  const std::string html = os.str(), alone[] = {written(a), written(b)};
  CHECK(reports[0].vertices == mesh.num_vertices() && reports[1].vertices == other_mesh.num_vertices());
  for (const std::string what : {"", "-faces", "-positions", "-rest"}) {
    CHECK(!element(html, "scene" + what).empty() && element(html, "scene" + what) == element(alone[0], "scene" + what));
    CHECK(element(html, "scene-b" + what) == element(alone[1], "scene" + what));
  }
  CHECK(nlohmann::ordered_json::parse(element(html, "comparison")) == comparison);
  std::ostringstream nothing;
  CHECK_THROWS(Option_error, Programs::write_html_pair(nothing, a, b, comparison, "<html></html>"), "not the viewer");
  CHECK(nothing.str().empty());
}

// All in one place: no extent, no step, no division by zero.
void test_a_point()
{
  Mesh mesh = sheet(1, 1);
  for (auto v : mesh.vertices()) mesh.point(v) = Point(3, 4, 5);
  const Sequence sequence(mesh, std::vector<std::vector<Point>>(3, std::vector<Point>(4, Point(3, 4, 5))), 1);
  const std::vector<Feature> none;
  const Decoded d = decoded(written(Scene{sequence, none, {}, "p"}));
  for (const auto& frame : d.frames)
    for (const Point& p : frame) CHECK(p == Point(3, 4, 5));
}

} // namespace

int main()
{
  use_hostile_locale();
  test_what_is_written(0);
  test_what_is_written(5000);
  test_fewer_frames();
  test_fewer_vertices();
  test_pair();
  test_bad_input();
  test_a_point();
  return test_result();
}

#endif
