// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_SVG_OUTPUT_H
#define PROGRAMS_PLOTS_SVG_OUTPUT_H

#include "plots/Plot_axis.h"
#include "scenes/append_xml_text.h"
#include "rendering/Colour.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A hundredth of a pixel is enough.
inline std::string pixels(double x)
{
  return decimal(std::llround(100 * x), -2);
}

// The elements of a drawing. Classes refer to its style sheet.
class Svg_output
{
public:
  void raw(std::string_view svg) { m_svg += svg; }

  void text(double x, double y, std::string_view text, const char* classes, const char* attributes = "")
  {
    m_svg += "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" class=\"" + classes + "\"" + attributes + ">";
    append_xml_text(m_svg, text);
    m_svg += "</text>\n";
  }

  void line(double x_0, double y_0, double x_1, double y_1, const char* classes)
  {
    m_svg += "<line x1=\"" + pixels(x_0) + "\" y1=\"" + pixels(y_0) + "\" x2=\"" + pixels(x_1) + "\" y2=\"" +
             pixels(y_1) + "\" class=\"" + classes + "\"/>\n";
  }

  void rectangle(double x, double y, double width, double height, const std::string& attributes)
  {
    m_svg += "<rect x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" width=\"" + pixels(width) + "\" height=\"" +
             pixels(height) + "\" " + attributes + "/>\n";
  }

  void circle(double x, double y, double radius, const std::string& attributes)
  {
    m_svg +=
        "<circle cx=\"" + pixels(x) + "\" cy=\"" + pixels(y) + "\" r=\"" + pixels(radius) + "\" " + attributes + "/>\n";
  }

  // the tooltip of the group in which it comes first
  void title(std::string_view text)
  {
    m_svg += "<title>";
    append_xml_text(m_svg, text);
    m_svg += "</title>\n";
  }

  const std::string& svg() const { return m_svg; }

private:
  std::string m_svg;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PLOTS_SVG_OUTPUT_H
