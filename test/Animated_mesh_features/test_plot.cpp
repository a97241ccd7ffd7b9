// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Plots and what they are drawn with: numbers for people, ticks, letters, shapes, and files of each format; in any locale.
// What can be read off a plot is tested by test_write_plot.sh.

#include "test_io_support.h"

#include "drawing/Canvas.h"
#include "drawing/decimal.h"
#include "plots/ticks.h"
#include "plots/write_plot.h"
#include "rendering/Image.h"
#include "rendering/Palette.h"
#include "running/displayable_text.h"
#include "scenes/Shown_scene.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#ifndef DETECT_FEATURES_WITH_PICTURES

int main()
{
  std::cout << "skipped: the programs were built without cairo" << std::endl;
  return test_support::skipped;
}

#else

using namespace CGAL::Animated_mesh_features;
using namespace Programs;
using namespace Programs::Rendering;
using namespace test_support;

namespace {

std::string joined(const std::vector<Tick>& ticks)
{
  std::string text;
  for (const Tick& t : ticks) text += t.text + " ";
  return text;
}

void test_numbers_for_people()
{
  CHECK(decimal(-1234, -2) == "-12.34" && decimal(1200, -2) == "12" && decimal(5, -3) == "0.005" &&
        decimal(7, 2) == "700");
  CHECK(rounded(0.31678) == "0.317" && rounded(1. / 3, 1) == "0.3" && rounded(0) == "0" && rounded(-3.2504) == "-3.25");
  CHECK(rounded(1.5e-7) == "1.5e-7" && rounded(1234567) == "1.23e6" && rounded(9.9999e7) == "1e8");
  CHECK(rounded(0.073456, 2) == "0.073" && rounded(1.5) == "1.5");
  CHECK(joined(linear_ticks(0, 1.57, 8)) == "0 0.2 0.4 0.6 0.8 1 1.2 1.4 ");
  CHECK(joined(linear_ticks(0, 2, 5, true)) == "0 1 2 ");
  CHECK(joined(linear_ticks(-10, 47, 4)) == "0 20 40 ");
  CHECK(joined(linear_ticks(3, 3, 4)).empty());
  CHECK(joined(logarithmic_ticks(0.028, 0.11)) == "0.03 0.04 0.05 0.07 0.1 ");
  CHECK(joined(logarithmic_ticks(0.028, 0.4)) == "0.03 0.05 0.1 0.2 0.3 ");
  CHECK(joined(logarithmic_ticks(1, 1.2)) == "1 1.05 1.1 1.15 1.2 ");
  CHECK(joined(logarithmic_ticks(0.001, 100)) == "0.001 0.01 0.1 1 10 100 ");
}

void test_displayable_text()
{
  const std::string box = "\xef\xbf\xbd";
  // one, two, three and four bytes, the first and the last of each; what is next to surrogates and to controls
  const std::string good = " ~"
                           "\xc2\xa0\xe2\x80\xa7\xe2\x80\xaf\xe2\x81\xa5\xe2\x81\xaa\xdf\xbf\xe0\xa0\x80\xef\xbf\xbf"
                           "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf\xed\x9f\xbf\xee\x80\x80";
  CHECK(displayable_text(good) == good);
  CHECK(displayable_text("").empty());
  CHECK(displayable_text(std::string("a\0\t\n\x7fz", 6)) == "a" + box + box + box + box + "z");
  for (const char* control :
       {"\xc2\x80", "\xc2\x9b", "\xc2\x9f", "\xe2\x80\xa8", "\xe2\x80\xae", "\xe2\x81\xa6", "\xe2\x81\xa9"})
    CHECK(displayable_text(control) == box);
  CHECK(displayable_text("\xff") == box && displayable_text("\x80") == box);
  CHECK(displayable_text("\xe2\x82") == box + box); // cut off
  CHECK(displayable_text("\xe2\x82z") == box + box + "z");
  // longer than they must be, surrogates, beyond the last
  for (const char* text :
       {"\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf5\x80"}) {
    std::string boxes;
    for (const char* c = text; *c != '\0'; ++c) boxes += box;
    CHECK(displayable_text(text) == boxes);
  }
}

const Srgb8 white = {{255, 255, 255}}, black = {{0, 0, 0}};

Text_style style(double size, double anchor = 0)
{
  Text_style result;
  result.size = size;
  result.anchor = anchor;
  return result;
}

// Where something is drawn, in pixels: from before the first to after the last.
struct Bounds
{
  double left = 1e9, right = -1, top = 1e9, bottom = -1;

  explicit Bounds(const Srgb_image& image)
  {
    for (std::size_t y = 0; y < image.height(); ++y)
      for (std::size_t x = 0; x < image.width(); ++x) {
        if (image(x, y) == white) continue;
        left = (std::min)(left, double(x)), right = (std::max)(right, double(x + 1));
        top = (std::min)(top, double(y)), bottom = (std::max)(bottom, double(y + 1));
      }
  }
};

Srgb_image written(const std::string& text, double x, double y, const Text_style& style)
{
  Canvas canvas(Srgb_image(160, 120, white));
  canvas.text(x, y, text, style);
  return canvas.image();
}

void test_letters()
{
  const auto drawn = [](const std::string& text) {
    const Srgb_image image = written(text, 40, 80, style(30));
    std::string pixels;
    for (const Srgb8& p : image.pixels()) pixels += char(p[1]);
    return pixels;
  };
  std::set<std::string> all;
  std::string ascii;
  for (char c = '!'; c <= '~'; ++c) ascii += c;
  for (char c : ascii) {
    all.insert(drawn(std::string(1, c)));
    const Bounds b(written(std::string(1, c), 40, 80, style(30)));
    CHECK(b.left > 40 - 8 && b.right < 40 + 36 && b.top > 80 - 34 && b.bottom < 80 + 12);
  }
  CHECK(all.size() == ascii.size());
  const std::string box = drawn("\xef\xbf\xbd");
  CHECK(all.count(box) == 0 && drawn("\xff") == box && drawn("\xe2\x82") == drawn("\xff\xff"));
  for (const char* text : {"\xcf\x84", "\xcf\x83", "\xe2\x89\xa5", "\xc2\xb7"}) { // of legends
    CHECK(drawn(text) != box);
    CHECK(all.insert(drawn(text)).second);
  }
  CHECK(drawn(" ") == std::string(160 * 120, '\xff'));

  const Canvas canvas(Srgb_image(1, 1));
  const double width = canvas.text_width("HH", style(20));
  CHECK(width > 20 && width < 40);
  CHECK_NEAR(canvas.text_width("H", style(20)), width / 2, 1e-9);
  CHECK_NEAR(canvas.text_width("HH", style(40)), 2 * width, 1e-9);
  CHECK_NEAR(canvas.text_width("", style(40)), 0, 0);
  Text_style bold = style(20);
  bold.is_bold = true;
  CHECK(canvas.text_width("HH", bold) > width);

  // Capitals are as high as they are said to be, and stand on the base line; a stroke is black within, white beyond.
  const Srgb_image image = written("H", 40, 100, style(80));
  const Bounds h(image);
  CHECK_NEAR(h.bottom, 100, 1);
  CHECK_NEAR(h.top, 100 - 80 * capital_height, 3);
  CHECK(std::count(image.pixels().begin(), image.pixels().end(), black) > 500);
  CHECK(image(std::size_t((h.left + h.right) / 2), 90) == white);

  // where texts begin and end
  const Bounds begin(written("HH", 80, 60, style(20, 0))), middle(written("HH", 80, 60, style(20, 0.5))),
      end(written("HH", 80, 60, style(20, 1)));
  CHECK(begin.left >= 80 && begin.right <= 80 + width + 1);
  CHECK_NEAR((middle.left + middle.right) / 2, 80, 1);
  CHECK(end.left >= 80 - width - 1 && end.right <= 81);
  Text_style upward = style(20, 0.5);
  upward.is_upward = true;
  const Bounds turned(written("HHH", 80, 60, upward));
  CHECK(turned.right <= 81 && turned.left > 80 - 16 && turned.bottom - turned.top > turned.right - turned.left);
  CHECK_NEAR((turned.top + turned.bottom) / 2, 60, 1);
}

void test_shapes()
{
  const Srgb8 red = {{200, 10, 30}}, blue = {{20, 40, 220}};
  Canvas canvas(Srgb_image(100, 60, white));
  canvas.rectangle(10, 5, 20, 30, red);
  canvas.circle(60, 30, 10, {blue, 2}, red, 0.5);
  canvas.circle(60, 30, 3, {blue, 2});
  canvas.line(80, 40, 95, 40, {blue, 4});
  const Srgb_image image = canvas.image();
  CHECK(image(10, 5) == red && image(29, 34) == red && image(9, 20) == white && image(30, 20) == white &&
        image(20, 4) == white && image(20, 35) == white);
  CHECK(image(69, 29) == blue && image(72, 29) == white && image(59, 20) == blue);
  for (std::size_t i = 0; i < 3; ++i) CHECK_NEAR(int(image(65, 29)[i]), (int(red[i]) + 255) / 2, 1); // half of it
  CHECK(image(59, 29) == image(65, 29));                                                             // not filled twice
  CHECK(image(80, 38) == blue && image(94, 41) == blue && image(79, 40) == white && image(85, 37) == white);
  // A round pen reaches beyond the ends.
  canvas.line(80, 50, 95, 50, {blue, 4, true});
  CHECK(canvas.image()(79, 50)[0] < 200 && canvas.image()(96, 49)[0] < 200);

  // A legend has the colours of its map, to within a step of rounding.
  Canvas bar(Srgb_image(300, 3, white));
  bar.colour_bar(20, 1, 256, 1, field_colours());
  const Srgb_image colours = bar.image();
  for (std::size_t i = 0; i < 256; ++i) {
    const Srgb8 expected = encoded(field_colours()((double(i) + 0.5) / 256));
    for (std::size_t c = 0; c < 3; ++c) CHECK_NEAR(int(colours(20 + i, 1)[c]), int(expected[c]), 2);
  }
  CHECK(colours(19, 1) == white && colours(276, 1) == white && colours(100, 0) == white && colours(100, 2) == white);
}

// Two triangles, of which vertex 3 rises.
struct Flap
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  CGAL::Surface_mesh<Point> mesh;
  std::vector<std::vector<Point>> frames;
  std::vector<Shown_feature> features;

  Flap()
  {
    for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)}) mesh.add_vertex(p);
    const auto v = [](unsigned i) { return CGAL::Surface_mesh<Point>::Vertex_index(i); };
    mesh.add_face(v(0), v(1), v(2));
    mesh.add_face(v(1), v(3), v(2));
    for (int f = 0; f < 20; ++f) {
      frames.emplace_back();
      for (auto u : mesh.vertices()) frames.back().push_back(mesh.point(u));
      frames.back()[3] = Point(1, 1, f);
    }
    for (unsigned i = 0; i < 3; ++i) {
      Shown_feature feature;
      feature.vertex = v(i);
      feature.vertex_index = i;
      feature.frame = 5 * i;
      feature.time = 0.5 * i;
      feature.triangle = {{3, 2, 1}};
      feature.sigma = 0.5 + 0.1 * i;
      feature.tau = 0.2 + 0.1 * i;
      feature.strength = 0.3;
      features.push_back(feature);
    }
  }

  Shown_sequence sequence() const { return Shown_sequence(mesh, frames, 0.1); }
};

std::string plot(const Shown_scene& scene, Drawing_format format = Drawing_format::SVG)
{
  std::ostringstream os; // has the hostile locale, if there is one
  write_plot(os, scene, format);
  return os.str();
}

std::size_t occurrences(const std::string& what, const std::string& text)
{
  std::size_t n = 0;
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + 1)) ++n;
  return n;
}

// Features are the only thing that is half translucent; newer versions of cairo write attributes instead of styles.
std::size_t features_in(const std::string& svg)
{
  return occurrences("fill-opacity:0.35", svg) + occurrences("fill-opacity=\"0.35\"", svg);
}

void test_files(const std::string& title)
{
  const Flap flap;
  const Shown_sequence sequence = flap.sequence();
  const Shown_scene scene{sequence, flap.features, {}, title};

  // a circle for each feature
  std::istringstream svg(plot(scene));
  boost::property_tree::ptree tree;
  read_xml(svg, tree);
  CHECK(tree.get<std::string>("svg.<xmlattr>.width") == "960px" &&
        tree.get<std::string>("svg.<xmlattr>.viewBox") == "0 0 960 760");
  CHECK(features_in(svg.str()) == flap.features.size());
  const std::vector<Shown_feature> none;
  CHECK(features_in(plot({sequence, none, {}, title})) == 0);

  const std::string pdf = plot(scene, Drawing_format::PDF);
  CHECK(pdf.substr(0, 8) == "%PDF-1.4" && pdf.find("/Count 1\n") != std::string::npos);
  CHECK(pdf.find("/CreationDate") == std::string::npos && pdf == plot(scene, Drawing_format::PDF));
  CHECK(occurrences("/Title", pdf) == 1);

  const std::string png = plot(scene, Drawing_format::PNG);
  CHECK(png.substr(0, 24) == std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x07\x80\0\0\x05\xf0", 24)); // 1920 x 1520
  CHECK(png == plot(scene, Drawing_format::PNG));
}

void test_checks()
{
  const Flap flap;
  const Shown_sequence sequence = flap.sequence();
  Spatio_temporal_field<double> small(4, 19), field(4, 20);
  const Shown_scene good{sequence, flap.features, {{"a", &field}}, "title"};
  CHECK(plot(good).size() > 1000);
  CHECK_THROWS(Option_error, plot({sequence, flap.features, {{"a", &small}}, ""}), "4 x 19");
  field(2, 7) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS(Input_error, plot(good), "vertex 2");
  std::vector<Shown_feature> features = flap.features;
  features[1].vertex_index = 4;
  const Shown_scene bad{sequence, features, {}, ""};
  CHECK_THROWS(Input_error, plot(bad), "feature 1 has the vertex 4");
  features[1].vertex_index = 3;
  features[1].triangle[2] = 7;
  CHECK_THROWS(Input_error, plot(bad), "vertex 7");
  features[1].triangle[2] = 0;
  features[1].frame = 20;
  CHECK_THROWS(Input_error, plot(bad), "frame 20");

  // what cairo cannot do is no crash
  CHECK_THROWS(Output_error, Canvas(Drawing_format::PNG, 1e5, 10, "too wide for cairo").file(), "cannot draw");
}

// The locale changes nothing.
void test_locale()
{
  const Flap flap;
  const Shown_sequence sequence = flap.sequence();
  const Shown_scene scene{sequence, flap.features, {}, "title"};
  std::vector<std::string> files[2];
  for (auto& f : files) {
    f = {plot(scene, Drawing_format::PDF), plot(scene, Drawing_format::PNG)};
    use_hostile_locale();
  }
  CHECK(files[0] == files[1]);
  test_numbers_for_people();
  test_files("title");
}

} // namespace

int main()
{
  test_numbers_for_people();
  test_displayable_text();
  test_letters();
  test_shapes();
  test_files("a <b> & \"c\" \x01\xff");
  test_files("");
  test_checks();
  test_locale();
  return test_result();
}

#endif
