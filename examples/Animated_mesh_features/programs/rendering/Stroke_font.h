// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_STROKE_FONT_H
#define PROGRAMS_RENDERING_STROKE_FONT_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

The letters of a small built-in font, drawn with a round pen: ASCII, and what formulas in a legend need. Capitals are 20
units high, small letters 14; the base line is at 0, y points up. Other characters are shown as a box. Made for this
package.
*/
class Stroke_font
{
public:
  typedef std::vector<Eigen::Vector2d> Stroke; ///< a polyline; a point is two equal ones.

  /// A letter.
  struct Glyph
  {
    std::vector<Stroke> strokes; ///< what the pen draws
    double width = 0;            ///< from the left end of the pen's path, which is at 0, to the right end.
  };

  static constexpr double capital_height = 20; ///< units
  static constexpr double pen_width = 2.3;     ///< units
  static constexpr double gap = 6;             ///< between the paths of two letters.
  static constexpr double space = 8;           ///< from the start of a space to that of what follows.

  /// the characters of a text.
  /// \param text UTF-8; bytes that are none are shown as boxes.
  static std::u32string characters(const std::string& text)
  {
    std::u32string result;
    for (std::size_t i = 0; i < text.size();) {
      const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
      const unsigned lead = byte(i);
      const std::size_t following = lead < 0x80 ? 0 : lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 4;
      char32_t c = following == 0 ? lead : lead & (0x3fu >> following);
      bool is_good = following < 4;
      for (std::size_t k = 1; is_good && k <= following; ++k) {
        is_good = (byte(i + k) & 0xc0u) == 0x80;
        c = c << 6 | (byte(i + k) & 0x3fu);
      }
      result.push_back(is_good ? c : 0xfffd);
      i += is_good ? following + 1 : 1;
    }
    return result;
  }

  /// the letter of a character; a box if the font has none.
  static const Glyph& glyph(char32_t c)
  {
    static const std::map<char32_t, Glyph> all = glyphs();
    static const Glyph box = parsed("0,0 0,20 11,20 11,0 0,0");
    const auto found = all.find(c);
    return found != all.end() ? found->second : box;
  }

  /// the width of a text, in units, without the pen's own.
  static double width(const std::u32string& text)
  {
    double x = 0;
    for (char32_t c : text) x += advance(c);
    return (std::max)(0., x - gap);
  }

  /// from the start of a letter to that of the next one.
  static double advance(char32_t c) { return c == U' ' ? space : glyph(c).width + gap; }

private:
  // Strokes are separated by |. "x,y" is a point, "ax,y,rx,ry,from,to" an arc of an ellipse around (x, y), with angles
  // in degrees, counterclockwise from the right.
  static Glyph parsed(const char* path)
  {
    Glyph glyph;
    glyph.strokes.emplace_back();
    const char* p = path;
    const auto number = [&p] {
      char* end = nullptr;
      const double x = std::strtod(p, &end);
      p = *end == ',' ? end + 1 : end;
      return x;
    };
    while (*p != '\0') {
      Stroke& stroke = glyph.strokes.back();
      if (*p == '|') {
        glyph.strokes.emplace_back();
        ++p;
      } else if (*p == ' ') {
        ++p;
      } else if (*p == 'a') {
        ++p;
        const double x = number(), y = number(), rx = number(), ry = number(), from = number(), to = number();
        const int pieces = (std::max)(1, int(std::abs(to - from) / 7.5));
        for (int i = 0; i <= pieces; ++i) {
          const double a = (from + (to - from) * i / pieces) * EIGEN_PI / 180;
          stroke.emplace_back(x + rx * std::cos(a), y + ry * std::sin(a));
        }
      } else {
        const double x = number(), y = number();
        stroke.emplace_back(x, y);
      }
    }
    double left = glyph.strokes.front().front()[0], right = left;
    for (const Stroke& s : glyph.strokes)
      for (const Eigen::Vector2d& q : s) left = (std::min)(left, q[0]), right = (std::max)(right, q[0]);
    for (Stroke& s : glyph.strokes)
      for (Eigen::Vector2d& q : s) q[0] -= left;
    glyph.width = right - left;
    return glyph;
  }

  static std::map<char32_t, Glyph> glyphs()
  {
    const std::pair<char32_t, const char*> paths[] = {
        {U'!', "0,20 0,6|0,0 0,0"},
        {U'"', "0,20 0,15|5,20 5,15"},
        {U'#', "3,20 0,0|10,20 7,0|0,13.5 11.5,13.5|-1,6.5 10.5,6.5"},
        {U'$', "a6,14,5,3.6,30,270 a6,6.4,5.4,4,90,-150|6,22.5 6,-2"},
        {U'%', "a3.5,16,3.5,4,0,360|a12.5,4,3.5,4,0,360|13.5,20 2.5,0"},
        {U'&', "14,0 a6.2,15.6,4.2,4.4,215,-40 a6,5.2,6,5.2,100,315 14,9"},
        {U'\'', "0,20 0,15"},
        {U'(', "4,23 a9,9,9,14,125,235"},
        {U')', "0,23 a-5,9,9,14,55,-55"},
        {U'*', "5,19 5,9|0.6,16.5 9.4,11.5|0.6,11.5 9.4,16.5"},
        {U'+', "6,13 6,1|0,7 12,7"},
        {U',', "1,0.5 -0.5,-4"},
        {U'-', "0,7 7,7"},
        {U'.', "0,0 0,0"},
        {U'/', "0,-3 9,22"},
        {U'0', "a6,10,6,10,90,450"},
        {U'1', "0,16 5,20 5,0"},
        {U'2', "a6,14,6,6,165,-35 0,0 12,0"},
        {U'3', "a6,14.8,5.2,5.2,150,-90 a5.8,4.8,6.2,4.8,90,-155"},
        {U'4', "9,0 9,20 0,6 12.5,6"},
        {U'5', "11,20 2,20 1,11 a5.6,6.4,6.5,6.4,135,-150"},
        {U'6', "a11,6.2,11,13.8,95,180|a6,6.2,6,6.2,0,360"},
        {U'7', "0,20 12,20 4.5,0"},
        {U'8', "a6,15.1,5,4.9,270,630 a6,5.1,6,5.1,90,450"},
        {U'9', "a1,13.8,11,13.8,-85,0|a6,13.8,6,6.2,0,360"},
        {U':', "0,12 0,12|0,0 0,0"},
        {U';', "1,12 1,12|1,0.5 -0.5,-4"},
        {U'<', "10,13 0,7 10,1"},
        {U'=', "0,10 12,10|0,4 12,4"},
        {U'>', "0,13 10,7 0,1"},
        {U'?', "a5,14.6,5,5.4,165,-40 5,8 5,6|5,0 5,0"},
        {U'@', "14,6.5 14,13|a9.5,9.5,4.5,4.5,0,360|14,9 a16.5,9,2.5,3.5,180,360 a9.5,9,9.5,10.5,0,310"},
        {U'A', "0,0 7,20 14,0|2.3,6.5 11.7,6.5"},
        {U'B', "6.5,10.4 a6.5,15.2,4.8,4.8,270,450 0,20 0,0 6.8,0 a6.8,5.2,5.7,5.2,-90,90 0,10.4"},
        {U'C', "a8,10,8,10,50,310"},
        {U'D', "0,0 0,20 5,20 a5,10,9,10,90,-90 0,0"},
        {U'E', "11,20 0,20 0,0 11,0|0,10.4 9.5,10.4"},
        {U'F', "11,20 0,20 0,0|0,10.2 9.5,10.2"},
        {U'G', "a8,10,8,10,50,340 15.5,9.5 9.5,9.5"},
        {U'H', "0,20 0,0|13,20 13,0|0,10.4 13,10.4"},
        {U'I', "0,20 0,0"},
        {U'J', "8,20 8,5 a4,5,4,5,0,-165"},
        {U'K', "0,20 0,0|12,20 0,8|4.6,12.4 12.5,0"},
        {U'L', "0,20 0,0 10.5,0"},
        {U'M', "0,0 0,20 8,5 16,20 16,0"},
        {U'N', "0,0 0,20 13,0 13,20"},
        {U'O', "a8.5,10,8.5,10,90,450"},
        {U'P', "0,0 0,20 6.5,20 a6.5,14.7,5.7,5.3,90,-90 0,9.4"},
        {U'Q', "a8.5,10,8.5,10,90,450|10.5,5 16,-1.5"},
        {U'R', "0,0 0,20 6.5,20 a6.5,14.8,5.5,5.2,90,-90 0,9.6|6,9.6 12.5,0"},
        {U'S', "a6,15,5.5,5,30,270 a6,5,6.2,5,90,-150"},
        {U'T', "0,20 14,20|7,20 7,0"},
        {U'U', "0,20 0,6.5 a6.5,6.5,6.5,6.5,180,360 13,20"},
        {U'V', "0,20 7,0 14,20"},
        {U'W', "0,20 5,0 10,18 15,0 20,20"},
        {U'X', "0,20 13,0|13,20 0,0"},
        {U'Y', "0,20 7,9 14,20|7,9 7,0"},
        {U'Z', "0,20 12.5,20 0,0 12.5,0"},
        {U'[', "4,23 0,23 0,-5 4,-5"},
        {U'\\', "0,22 9,-3"},
        {U']', "0,23 4,23 4,-5 0,-5"},
        {U'^', "0,13 5,20 10,13"},
        {U'_', "0,-4 12,-4"},
        {U'`', "0,20 4,17"},
        {U'a', "a5.5,7,5.5,7,0,360|11,14 11,0"},
        {U'b', "0,20 0,0|a5.5,7,5.5,7,0,360"},
        {U'c', "a6,7,6,7,48,312"},
        {U'd', "11,20 11,0|a5.5,7,5.5,7,0,360"},
        {U'e', "0,7 11.3,7 a5.7,7,5.7,7,0,318"},
        {U'f', "2.5,0 2.5,15.5 a6.5,15.5,4,4.5,180,75|-0.5,13.5 6.5,13.5"},
        {U'g', "a5.5,7,5.5,7,0,360|11,14 11,-0.5 a5.6,-0.5,5.4,5.5,0,-150"},
        {U'h', "0,20 0,0|0,8.8 a5.1,8.8,5.1,5.2,180,0 10.2,0"},
        {U'i', "0,14 0,0|0,19 0,19"},
        {U'j', "2.5,14 2.5,-3 a-0.5,-3,3,3,0,-80|2.5,19 2.5,19"},
        {U'k', "0,20 0,0|9,14 0,5.5|3.6,9 9.8,0"},
        {U'l', "0,20 0,3.4 a3.4,3.4,3.4,3.4,180,275"},
        {U'm', "0,14 0,0|0,9.2 a4.2,9.2,4.2,4.8,180,0 8.4,0|8.4,9.2 a12.6,9.2,4.2,4.8,180,0 16.8,0"},
        {U'n', "0,14 0,0|0,8.8 a5.1,8.8,5.1,5.2,180,0 10.2,0"},
        {U'o', "a5.8,7,5.8,7,90,450"},
        {U'p', "0,14 0,-6|a5.5,7,5.5,7,0,360"},
        {U'q', "11,14 11,-6|a5.5,7,5.5,7,0,360"},
        {U'r', "0,14 0,0|0,8.2 a5.3,8.2,5.3,5.8,180,65"},
        {U's', "a4.7,10.5,4.2,3.5,30,270 a4.7,3.5,4.7,3.5,90,-150"},
        {U't', "3,19 3,4 a6.8,4,3.8,4,180,285|0,14 7.5,14"},
        {U'u', "0,14 0,5.2 a5.1,5.2,5.1,5.2,180,360 10.2,14|10.2,14 10.2,0"},
        {U'v', "0,14 5.5,0 11,14"},
        {U'w', "0,14 4.2,0 8.4,13 12.6,0 16.8,14"},
        {U'x', "0,14 10.2,0|10.2,14 0,0"},
        {U'y', "0,14 5.6,0|11,14 3,-6"},
        {U'z', "0,14 9.8,14 0,0 9.8,0"},
        {U'{', "5,23 a5,20,2.5,3,90,180 2.5,12 a0,12,2.5,3,0,-90 a0,6,2.5,3,90,0 2.5,-2 a5,-2,2.5,3,180,270"},
        {U'|', "0,23 0,-5"},
        {U'}', "0,23 a0,20,2.5,3,90,0 2.5,12 a5,12,2.5,3,180,270 a5,6,2.5,3,90,180 2.5,-2 a0,-2,2.5,3,0,-90"},
        {U'~', "0,6 a3.2,6,3.2,3,180,10 a9.6,8,3.2,3,190,360"},
        {U'\u00b1', "6,14 6,4|0,9 12,9|0,1 12,1"},
        {U'\u00b7', "0,8 0,8"},
        {U'\u03c3', "a5.6,6.5,5.6,6.5,0,360|5.6,13 12.5,13"},
        {U'\u03c4', "0,13 10.5,13|5,13 5,3.6 a8.6,3.6,3.6,3.6,180,275"},
        {U'\u2265', "0,16 10,11 0,6|0,1 10,1"},
        {U'\u221a', "0,8 2,9 5.5,-1 10,20 18,20"},
    };
    std::map<char32_t, Glyph> result;
    for (const auto& p : paths) result.emplace(p.first, parsed(p.second));
    return result;
  }
};

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_STROKE_FONT_H
