// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERS_H

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>

// Numbers to text and back, whatever the locale: what std::strtod, printf and default streams print and accept depends
// on it, and a German desktop would write JSON with decimal commas.

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Bits rather than std::isfinite(), which -ffast-math folds to `true`.
inline bool is_finite(float x)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return (bits & 0x7f800000u) != 0x7f800000u;
}

inline bool is_finite(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return (bits & 0x7ff0000000000000u) != 0x7ff0000000000000u;
}

// Reads a number that starts at `p` and moves `p` behind it; `false`, with `p` unmoved, if none starts there.
// "nan", "inf" and what exceeds the range of a double are numbers too: the caller says which vertex is not finite.
inline bool parse_number(const char*& p, const char* end, double& x)
{
  const char* begin = p;
  if (begin != end && *begin == '+') {
    ++begin; // std::from_chars knows no plus sign
    if (begin != end && *begin == '-') return false;
  }
#ifdef __cpp_lib_to_chars
  const std::from_chars_result r = std::from_chars(begin, end, x);
  if (r.ec == std::errc::invalid_argument) return false;
  p = r.ptr;
  if (r.ec == std::errc()) return true;
  const std::string digits(begin, r.ptr); // too large or too small, std::from_chars does not tell which
#else
  const char* word = begin;
  if (word != end && *word == '-') ++word;
  for (const char* not_finite : {"nan", "inf", "NaN", "Inf", "NAN", "INF"})
    if (end - word >= 3 && std::equal(word, word + 3, not_finite)) {
      p = word + 3;
      x = std::numeric_limits<double>::infinity(); // which of them is all the same
      return true;
    }
  const char* last = begin;
  while (last != end && *last != '\0' && std::strchr("0123456789+-.eE", *last) != nullptr) ++last;
  if (last == begin) return false;
  p = last;
  const std::string digits(begin, last);
#endif
  std::istringstream stream(digits);
  stream.imbue(std::locale::classic());
  if (!(stream >> x)) x = std::numeric_limits<double>::infinity();
  return true;
}

template <class Integer>
bool parse_integer(const char*& p, const char* end, Integer& i)
{
  const char* begin = (p != end && *p == '+') ? p + 1 : p;
  const std::from_chars_result r = std::from_chars(begin, end, i);
  if (r.ec != std::errc()) return false;
  p = r.ptr;
  return true;
}

// The shortest text that reads back as the same number.
template <class Number>
void append_number(std::string& text, Number x)
{
  char buffer[64];
#ifdef __cpp_lib_to_chars
  text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), x).ptr);
#else
  if constexpr (std::is_integral<Number>::value) {
    text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), x).ptr);
  } else {
    for (int digits = std::numeric_limits<Number>::digits10; digits <= std::numeric_limits<Number>::max_digits10;
         ++digits) {
      std::ostringstream out;
      out.imbue(std::locale::classic());
      out.precision(digits);
      out << x;
      Number back = 0;
      std::istringstream in(out.str());
      in.imbue(std::locale::classic());
      in >> back;
      if (back == x || digits == std::numeric_limits<Number>::max_digits10) {
        text += out.str();
        return;
      }
    }
  }
#endif
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERS_H
