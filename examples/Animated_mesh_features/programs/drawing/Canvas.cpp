// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "drawing/Canvas.h"

#include "running/displayable_text.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

#if CAIRO_VERSION < CAIRO_VERSION_ENCODE(1, 16, 0) || !CAIRO_HAS_PNG_FUNCTIONS
  #error "cairo 1.16 or newer is needed, with PNG"
#endif

namespace Programs {

namespace {

constexpr double full_turn = 6.283185307179586;

// Errors of cairo stay with what they happened to, which ignores all that follows.
void check(cairo_status_t status)
{
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw CGAL::Animated_mesh_features::Output_error(std::string("cannot draw: ") + cairo_status_to_string(status));
}

// Called by cairo, which is C: no exception may pass.
cairo_status_t append_bytes(void* file, const unsigned char* data, unsigned length) noexcept
{
  try {
    static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

std::uint32_t packed(const Rendering::Srgb8& c)
{
  return std::uint32_t(c[0]) << 16 | std::uint32_t(c[1]) << 8 | c[2];
}

} // namespace

struct Canvas::Drawing
{
  Drawing(Drawing_format f, double width, double height, double scale)
    : format(f)
  {
    switch (format) {
    case Drawing_format::SVG:
      surface = cairo_svg_surface_create_for_stream(append_bytes, &bytes, width * scale, height * scale);
      cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
      break;
    case Drawing_format::PDF:
      surface = cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width * scale, height * scale);
      // the oldest one that has translucent colours
      cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_4);
      // no date, or no two files would be the same
      cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
      break;
    case Drawing_format::PNG:
      surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(std::lround(width * scale)),
                                           int(std::lround(height * scale)));
      break;
    }
    context = cairo_create(surface);
    cairo_scale(context, scale, scale);
    cairo_font_options_t* const options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
  }

  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  ~Drawing()
  {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }

  void set_font(const Text_style& style) const
  {
    cairo_select_font_face(context, "sans", CAIRO_FONT_SLANT_NORMAL,
                           style.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size);
  }

  void set_colour(const Srgb8& c, double opacity = 1) const
  {
    cairo_set_source_rgba(context, c[0] / 255., c[1] / 255., c[2] / 255., opacity);
  }

  void stroke(const Pen& pen) const
  {
    set_colour(pen.colour);
    cairo_set_line_width(context, pen.width);
    cairo_set_line_cap(context, pen.is_round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_stroke(context);
  }

  Drawing_format format;
  std::string bytes; // of the file, as far as it is written
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;
};

Canvas::Canvas(Drawing_format format, double width, double height, const std::string& title)
  // in PDF a unit is 1/72 inch
  : m_drawing(std::make_unique<Drawing>(format, width, height,
                                        format == Drawing_format::PDF   ? 0.75
                                        : format == Drawing_format::PNG ? 2
                                                                        : 1))
{
  if (format == Drawing_format::PDF)
    cairo_pdf_surface_set_metadata(m_drawing->surface, CAIRO_PDF_METADATA_TITLE, displayable_text(title).c_str());
  rectangle(0, 0, width, height, {{255, 255, 255}});
}

Canvas::Canvas(const Rendering::Srgb_image& image)
  : m_drawing(std::make_unique<Drawing>(Drawing_format::PNG, double(image.width()), double(image.height()), 1))
{
  cairo_surface_t* const surface = m_drawing->surface;
  check(cairo_surface_status(surface));
  for (std::size_t y = 0; y < image.height(); ++y) {
    unsigned char* const row = cairo_image_surface_get_data(surface) + int(y) * cairo_image_surface_get_stride(surface);
    for (std::size_t x = 0; x < image.width(); ++x) reinterpret_cast<std::uint32_t*>(row)[x] = packed(image(x, y));
  }
  cairo_surface_mark_dirty(surface);
}

Canvas::Canvas(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

void Canvas::text(double x, double y, const std::string& text, const Text_style& style)
{
  cairo_t* const context = m_drawing->context;
  const double width = text_width(text, style);
  m_drawing->set_colour(style.colour);
  cairo_save(context);
  cairo_translate(context, x, y);
  if (style.is_upward) cairo_rotate(context, -full_turn / 4);
  cairo_move_to(context, -style.anchor * width, 0);
  const std::string shown = displayable_text(text);
  if (m_drawing->format == Drawing_format::PNG) {
    // Among pixels, letters as such would be moved to whole ones, and would stand unevenly.
    cairo_text_path(context, shown.c_str());
    cairo_fill(context);
  } else {
    cairo_show_text(context, shown.c_str());
  }
  cairo_restore(context);
}

double Canvas::text_width(const std::string& text, const Text_style& style) const
{
  m_drawing->set_font(style);
  cairo_text_extents_t extents;
  cairo_text_extents(m_drawing->context, displayable_text(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::line(double from_x, double from_y, double to_x, double to_y, const Pen& pen)
{
  cairo_move_to(m_drawing->context, from_x, from_y);
  cairo_line_to(m_drawing->context, to_x, to_y);
  m_drawing->stroke(pen);
}

void Canvas::polyline(const std::vector<std::pair<double, double>>& points, const Pen& pen)
{
  cairo_new_path(m_drawing->context); // texts leave a point behind
  for (const auto& p : points) cairo_line_to(m_drawing->context, p.first, p.second);
  cairo_set_line_join(m_drawing->context, CAIRO_LINE_JOIN_ROUND);
  m_drawing->stroke(pen);
}

void Canvas::rectangle(double x, double y, double width, double height, const Srgb8& colour)
{
  cairo_rectangle(m_drawing->context, x, y, width, height);
  m_drawing->set_colour(colour);
  cairo_fill(m_drawing->context);
}

void Canvas::circle(double x, double y, double radius, const Pen& pen, const std::optional<Srgb8>& filling,
                    double opacity)
{
  cairo_new_sub_path(m_drawing->context);
  cairo_arc(m_drawing->context, x, y, radius, 0, full_turn);
  cairo_close_path(m_drawing->context);
  if (filling) {
    m_drawing->set_colour(*filling, opacity);
    cairo_fill_preserve(m_drawing->context);
  }
  m_drawing->stroke(pen);
}

void Canvas::colour_bar(double x, double y, double width, double height, const Rendering::Colour_map& colours)
{
  const int stops = 64; // between them, cairo goes straight from number to number
  cairo_pattern_t* const pattern = cairo_pattern_create_linear(x, y, x + width, y);
  for (int i = 0; i <= stops; ++i) {
    const Srgb8 c = Rendering::encoded(colours(double(i) / stops));
    cairo_pattern_add_color_stop_rgb(pattern, double(i) / stops, c[0] / 255., c[1] / 255., c[2] / 255.);
  }
  cairo_rectangle(m_drawing->context, x, y, width, height);
  cairo_set_source(m_drawing->context, pattern);
  cairo_fill(m_drawing->context);
  cairo_pattern_destroy(pattern);
}

std::string Canvas::file()
{
  check(cairo_status(m_drawing->context));
  if (m_drawing->format == Drawing_format::PNG)
    check(cairo_surface_write_to_png_stream(m_drawing->surface, append_bytes, &m_drawing->bytes));
  cairo_surface_finish(m_drawing->surface);
  check(cairo_surface_status(m_drawing->surface));
  return std::move(m_drawing->bytes);
}

Rendering::Srgb_image Canvas::image() const
{
  cairo_surface_t* const surface = m_drawing->surface;
  check(cairo_status(m_drawing->context));
  cairo_surface_flush(surface);
  const std::size_t width = std::size_t(cairo_image_surface_get_width(surface));
  const std::size_t height = std::size_t(cairo_image_surface_get_height(surface));
  Rendering::Srgb_image result(width, height);
  for (std::size_t y = 0; y < height; ++y) {
    const unsigned char* const row =
        cairo_image_surface_get_data(surface) + int(y) * cairo_image_surface_get_stride(surface);
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint32_t p = reinterpret_cast<const std::uint32_t*>(row)[x];
      result(x, y) = {{std::uint8_t(p >> 16), std::uint8_t(p >> 8), std::uint8_t(p)}};
    }
  }
  return result;
}

} // namespace Programs
