// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_DRAWING_CANVAS_H
#define PROGRAMS_DRAWING_CANVAS_H

#include "drawing/Drawing_format.h"
#include "rendering/Colour.h"
#include "rendering/Colour_map.h"
#include "rendering/Image.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Programs {

struct Text_style
{
  double size = 13; // of the font; see `capital_height`
  Rendering::Srgb8 colour = {};
  double anchor = 0; // how much of its width is left of its place: 0 starts there, 1 ends there
  bool is_bold = false;
  bool is_upward = false; // turned by a quarter, to be read from the right
};

// of capitals, in units of the size of the font, as most fonts without serifs have it
constexpr double capital_height = 0.73;

struct Pen
{
  Rendering::Srgb8 colour = {};
  double width = 1;
  bool is_round = false; // at the ends of lines
};

// What texts, axes and legends are drawn on, by cairo, which writes it as a file: the only one who knows cairo. Places are
// measured from the top left corner. Letters are those of the machine's default font without serifs; without any font, of
// one that is built into cairo. Like cairo's, they are anti-aliased, and not fitted to pixels: a text is as wide in all
// formats. The same bytes for the same drawing, but for the numbers of elements in SVG: cairo counts all drawings that a
// program has made.
class Canvas
{
public:
  typedef Rendering::Srgb8 Srgb8;

  // A white page. A unit is a pixel of a browser, 1/96 inch; PNG has two pixels for it, for screens that have them, and
  // for print. The title is that of a PDF.
  Canvas(Drawing_format format, double width, double height, const std::string& title);

  // An image to be drawn on; a unit is a pixel.
  explicit Canvas(const Rendering::Srgb_image& image);

  Canvas(Canvas&&) noexcept;
  ~Canvas();

  // `y` is that of the base line.
  void text(double x, double y, const std::string& text, const Text_style& style);
  double text_width(const std::string& text, const Text_style& style) const;

  void line(double from_x, double from_y, double to_x, double to_y, const Pen& pen);
  void polyline(const std::vector<std::pair<double, double>>& points, const Pen& pen);
  void rectangle(double x, double y, double width, double height, const Srgb8& colour);

  // filled, if there is a colour for it
  void circle(double x, double y, double radius, const Pen& pen, const std::optional<Srgb8>& filling = std::nullopt,
              double opacity = 1);

  // the colours of a map, from left to right
  void colour_bar(double x, double y, double width, double height, const Rendering::Colour_map& colours);

  // The file. It ends the drawing.
  // throws Output_error if cairo cannot draw it, bad_alloc.
  std::string file();

  // What an image has become. The same exceptions.
  Rendering::Srgb_image image() const;

private:
  struct Drawing;

  std::unique_ptr<Drawing> m_drawing;
};

} // namespace Programs

#endif // PROGRAMS_DRAWING_CANVAS_H
