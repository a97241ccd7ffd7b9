// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERS_H

#include <algorithm>
#include <cfloat>
#include <charconv>
#include <cstddef>
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

// Reads the digits at `p`, moves `p` after them and appends them to the decimal number `m`, modulo 2^64.
inline std::size_t parse_digits(const char*& p, const char* end, std::uint64_t& m)
{
  const char* const begin = p;
  for (; p != end; ++p) {
    const unsigned digit = static_cast<unsigned char>(*p) - unsigned('0');
    if (digit > 9) break;
    m = 10 * m + digit;
  }
  return std::size_t(p - begin);
}

// What nearly all coordinates are: few digits and no exponent. If the digits without their point are an integer that a
// double holds, and the power of ten of the digits after the point is such a one too, a single division rounds correctly
// (W. D. Clinger, How to read floating point numbers accurately, PLDI 1990). `false`, with `p` unmoved, if it is
// something else, which may be a number all the same.
inline bool parse_plain_decimal(const char*& p, const char* end, double& x)
{
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD == 0 || FLT_EVAL_METHOD == 1)
  static constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::uint64_t largest = std::uint64_t(1) << std::numeric_limits<double>::digits;
  constexpr std::size_t most_digits = std::numeric_limits<std::uint64_t>::digits10; // `m` cannot have overflowed
  static_assert(most_digits < sizeof(powers_of_ten) / sizeof(double), "a power for each number of decimals");

  const char* q = p;
  const bool is_negative = q != end && *q == '-';
  if (is_negative) ++q;
  std::uint64_t m = 0;
  std::size_t digits = parse_digits(q, end, m), decimals = 0;
  if (q != end && *q == '.') {
    ++q;
    decimals = parse_digits(q, end, m);
    digits += decimals;
  }
  if (digits == 0 || digits > most_digits || m > largest) return false;
  if (q != end && (*q == 'e' || *q == 'E')) return false;
  const double magnitude = double(m) / powers_of_ten[decimals];
  x = is_negative ? -magnitude : magnitude;
  p = q;
  return true;
#else // the division would be rounded twice
  (void)p, (void)end, (void)x;
  return false;
#endif
}

// parse_number() for what is not plain.
inline bool parse_any_number(const char*& p, const char* end, double& x)
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

// Reads a number that starts at `p` and moves `p` after it; `false`, with `p` unmoved, if none starts there.
// "nan", "inf" and what exceeds the range of a double are numbers too: the caller says which vertex is not finite.
inline bool parse_number(const char*& p, const char* end, double& x)
{
  return parse_plain_decimal(p, end, x) || parse_any_number(p, end, x);
}

// The same for an integer, whose range is that of its type.
template <class Integer>
bool parse_integer(const char*& p, const char* end, Integer& i)
{
  constexpr std::size_t most_digits = std::numeric_limits<Integer>::digits10; // that always fit
  std::uint64_t m = 0;
  const char* q = p;
  const std::size_t digits = parse_digits(q, end, m);
  if (digits > 0 && digits <= most_digits) {
    i = static_cast<Integer>(m);
    p = q;
    return true;
  }
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
