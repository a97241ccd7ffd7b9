// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers in files, as text and as bytes: the quick ways against those of the C library, bit for bit.

#include "test_support.h"

#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>
#include <CGAL/Animated_mesh_features/Animation/transpose_frames.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace test_support;
namespace IO = CGAL::Animated_mesh_features::IO;

namespace {

std::mt19937_64 generator(2026);

std::uint64_t random_below(std::uint64_t n)
{
  return generator() % n;
}

template <class To, class From>
To same_bits(From from)
{
  static_assert(sizeof(To) == sizeof(From), "");
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

// What is wrong with the number that is read from `text`, which the C library reads as well; empty if nothing is. It
// must end where it does there, also if more text follows, and must not look behind the end that it is told.
std::string mistake(const std::string& text)
{
  char* c_end = nullptr;
  const double expected = std::strtod(text.c_str(), &c_end);
  const std::size_t length = std::size_t(c_end - text.c_str());
  for (const char* follows : {"", " ", "\n", ",5", "/", "x"}) {
    const std::string all = text + follows;
    for (const char* end : {all.data() + all.size(), all.data() + text.size()}) {
      const char* p = all.data();
      double x = 42;
      if (!IO::internal::parse_number(p, end, x)) return "is no number";
      if (p != all.data() + length) return "ends after " + std::to_string(p - all.data());
      // that a number is not finite is all that the readers want to know about such a one
      const bool same = std::isfinite(expected) ? same_bits<std::uint64_t>(x) == same_bits<std::uint64_t>(expected)
                                                : !std::isfinite(x);
      if (!same) return "is read as " + std::to_string(x);
    }
  }
  return "";
}

void check_number(const std::string& text)
{
  const std::string m = mistake(text);
  if (!m.empty()) report(false, __FILE__, __LINE__, "\"" + text + "\" " + m);
}

void test_nasty_numbers()
{
  const int before = failures();
  std::istringstream texts(
      "0 -0 0. .0 -.0 00 000.000 5. .5 -5. -.5 +1 +.5 +0 1e5 1E5 1e+5 1.e5 .1e-5 1e-05 1e0005 0e400 0e-400 "
      "-0e999999 1e308 1.7976931348623157e308 1.7976931348623158e308 1.7976931348623159e308 1e309 -1e309 1e400 "
      "1e99999 2.2250738585072014e-308 2.2250738585072011e-308 2.2250738585072012e-308 4.9406564584124654e-324 "
      "2.4703282292062328e-324 2.4703282292062327e-324 1e-400 -1e-400 1e-99999 9007199254740992 "
      "9007199254740993 9007199254740992.0 9007199254740993.0 9007199254740994.5 900719925474099.25 "
      "0.9007199254740993 0.1 0.2 0.3 123456789012345678 1234567890123456789 12345678901234567890 "
      "18446744073709551615 18446744073709551616 184467440737095516160000 99999999999999999999999999 "
      "0.000000000000000000001 0.0000000000000000000001 0.00000000000000000000001 1.0000000000000000000000001 "
      "100000000000000016777215 100000000000000016777216 8.5 0.5000000000000001 0.30000000000000004 "
      "1.00000000000000011102230246251565404236316680908203125 "
      "1.00000000000000011102230246251565404236316680908203124 "
      "1.00000000000000011102230246251565404236316680908203126 inf -inf INF Inf +inf nan -nan NaN NAN infinity "
      "-Infinity");
  for (std::string text; texts >> text;) check_number(text);
  for (std::size_t zeros : {1u, 17u, 18u, 19u, 20u, 21u, 22u, 23u, 40u, 800u}) {
    check_number("1" + std::string(zeros, '0'));
    check_number("1" + std::string(zeros, '0') + ".5");
    check_number("0." + std::string(zeros, '0') + "1");
    check_number("-0." + std::string(zeros, '0'));
    check_number(std::string(zeros, '0') + "7.25");
    check_number("7." + std::string(zeros, '9'));
    check_number("7.25" + std::string(zeros, '0') + "e3");
  }
  report(failures() == before, __FILE__, __LINE__, "nasty numbers");

  const auto refused = [](const std::string& text) {
    const char* p = text.data();
    double x = 0;
    return !IO::internal::parse_number(p, text.data() + text.size(), x) && p == text.data();
  };
  for (const char* text :
       {"", "-", "+", ".", "-.", "+.", "e5", ".e5", "-e", "x", "--1", "+-1", "-+1", "++1", " 1", ",5"})
    report(refused(text), __FILE__, __LINE__, "\"" + std::string(text) + "\" passes for a number");
}

// As exporters write them, and any digits with any exponent.
void test_random_numbers()
{
  const int before = failures();
  char text[2000];
  for (int i = 0; i < 200000; ++i) {
    const int decimals = int(random_below(12));
    const double x = (double(random_below(2000001)) - 1000000) / double(1 + random_below(1000));
    std::snprintf(text, sizeof(text), i % 3 == 0 ? "%.*f" : i % 3 == 1 ? "%.*g" : "%.*e", decimals, x);
    check_number(text);
  }
  for (int i = 0; i < 200000; ++i) {
    std::string digits = random_below(4) == 0 ? "-" : "";
    const std::uint64_t before_point = random_below(24), behind_point = random_below(24);
    for (std::uint64_t k = 0; k < before_point; ++k) digits += char('0' + random_below(10));
    if (behind_point > 0 || before_point == 0) digits += '.';
    for (std::uint64_t k = 0; k < behind_point + (before_point == 0); ++k) digits += char('0' + random_below(10));
    if (random_below(3) == 0) digits += "e" + std::to_string(int(random_below(700)) - 350);
    check_number(digits);
  }
  // any double, with the digits that tell it from all others, with fewer and with more
  for (int i = 0; i < 100000; ++i) {
    const double x = same_bits<double>(std::uint64_t(generator()));
    if (!std::isfinite(x)) continue;
    for (int digits : {9, 16, 17, 18, 19, 20, 25}) {
      std::snprintf(text, sizeof(text), "%.*g", digits, x);
      check_number(text);
    }
  }
  report(failures() == before, __FILE__, __LINE__, "random numbers");
}

// Halfway between two doubles, and so little beside that it takes the last of hundreds of digits to know.
void test_halfway_numbers()
{
  if (std::numeric_limits<long double>::digits <= std::numeric_limits<double>::digits) return;
  const int before = failures();
  std::vector<char> text(3000);
  for (int i = 0; i < 20000; ++i) {
    // of moderate size, for which fewer digits do
    const double x = std::ldexp(double((std::uint64_t(1) << 52) + random_below(std::uint64_t(1) << 52)),
                                int(random_below(120)) - 100);
    const long double middle = (static_cast<long double>(x) + static_cast<long double>(std::nextafter(x, 1e300))) / 2;
    std::snprintf(text.data(), text.size(), "%.150Lf", middle);
    const std::string s = text.data();
    check_number(s);
    check_number(s + "1");
    check_number(s.substr(0, s.find_last_not_of('0')));
    check_number(s.substr(0, 17 + random_below(8)));
  }
  report(failures() == before, __FILE__, __LINE__, "numbers halfway between two doubles");
}

void test_integers()
{
  const auto same = [](const std::string& text) {
    const char *p = text.data(), *const end = text.data() + text.size();
    long long i = 42, expected = 42;
    const bool good = IO::internal::parse_integer(p, end, i);
    const char* const begin = !text.empty() && text[0] == '+' ? text.data() + 1 : text.data();
    const std::from_chars_result r = std::from_chars(begin, end, expected);
    return good == (r.ec == std::errc()) && (!good || (i == expected && p == r.ptr)) && (good || p == text.data());
  };
  for (const char* text : {"",
                           "-",
                           "+",
                           "0",
                           "-0",
                           "+0",
                           "7",
                           "-7",
                           "+7",
                           "007",
                           "1/2/3",
                           "12//",
                           "3.5",
                           "1e5",
                           "x",
                           "999999999999999999",
                           "1000000000000000000",
                           "9223372036854775807",
                           "9223372036854775808",
                           "-9223372036854775808",
                           "-9223372036854775809",
                           "18446744073709551616",
                           "18446744073709551617",
                           "99999999999999999999",
                           "000000000000000000000000001",
                           "-000000000000000000000000001",
                           "123456789 1"})
    report(same(text), __FILE__, __LINE__, text);
  bool good = true;
  for (int i = 0; i < 100000; ++i) {
    std::string text = std::to_string(static_cast<long long>(generator() >> random_below(64)));
    if (random_below(3) == 0) text += "/2";
    good = good && same(text);
  }
  CHECK(good);
}

template <class FT, class Bits>
void test_all_finite()
{
  bool good = true;
  for (std::size_t n = 0; n < 40; ++n) {
    std::vector<FT> x(n);
    for (FT& value : x) do {
        value = same_bits<FT>(Bits(generator()));
      } while (!std::isfinite(value));
    good = good && CGAL::Animated_mesh_features::internal::all_finite(x.data(), n);
    for (std::size_t i = 0; i < n; ++i)
      for (FT bad : {std::numeric_limits<FT>::infinity(), -std::numeric_limits<FT>::infinity(),
                     std::numeric_limits<FT>::quiet_NaN(), -std::numeric_limits<FT>::quiet_NaN()}) {
        std::vector<FT> y = x;
        y[i] = bad;
        good = good && !CGAL::Animated_mesh_features::internal::all_finite(y.data(), n) && !IO::internal::is_finite(bad);
      }
    std::fill(x.begin(), x.end(), (std::numeric_limits<FT>::max)());
    good = good && CGAL::Animated_mesh_features::internal::all_finite(x.data(), n);
  }
  CHECK(good);
}

template <class T>
void test_bytes()
{
  using IO::internal::Byte_order;
  bool good = true;
  for (int i = 0; i < 1000; ++i) {
    char bytes[sizeof(T)];
    std::uint64_t little = 0, big = 0;
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      const std::uint64_t byte = random_below(256);
      bytes[k] = static_cast<char>(static_cast<unsigned char>(byte));
      little |= byte << (8 * k);
      big = big << 8 | byte;
    }
    for (Byte_order order : {Byte_order::LITTLE_ENDIAN_ORDER, Byte_order::BIG_ENDIAN_ORDER}) {
      const std::uint64_t bits = order == Byte_order::LITTLE_ENDIAN_ORDER ? little : big;
      const T x = IO::internal::load<T>(bytes, order);
      typename IO::internal::Unsigned_of_size<sizeof(T)>::type loaded,
          expected = static_cast<typename IO::internal::Unsigned_of_size<sizeof(T)>::type>(bits);
      std::memcpy(&loaded, &x, sizeof(T));
      T in_place[3];
      for (T& value : in_place) std::memcpy(&value, bytes, sizeof(T));
      IO::internal::convert_from(order, in_place, 3);
      good = good && loaded == expected;
      for (const T& value : in_place) good = good && std::memcmp(&value, &x, sizeof(T)) == 0;
    }
  }
  CHECK(good);
}

template <class FT, class Number>
void test_transposition()
{
  using CGAL::Animated_mesh_features::Spatio_temporal_field;
  bool good = true;
  for (std::size_t frames : {1u, 3u, 4u, 7u, 17u})
    for (std::size_t vertices : {1u, 2u, 29u}) {
      const std::size_t first_vertex = 5, first_frame = 3, behind = 2;
      std::vector<std::vector<Number>> xyz(frames, std::vector<Number>(3 * vertices));
      for (std::vector<Number>& frame : xyz)
        for (Number& x : frame) x = Number(random_below(1000)) / 7;
      Spatio_temporal_field<FT> fields[3];
      for (auto& field : fields)
        field = Spatio_temporal_field<FT>(first_vertex + vertices + behind, first_frame + frames + behind);
      CGAL::Animated_mesh_features::internal::transpose_frames<FT>(CGAL::Animated_mesh_features::internal::Frame_piece{first_vertex, vertices, first_frame, frames},
                                         [&](std::size_t f) { return static_cast<const Number*>(xyz[f].data()); },
                                         {{&fields[0], &fields[1], &fields[2]}});
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t v = 0; v < fields[c].number_of_rows(); ++v)
          for (std::size_t f = 0; f < fields[c].number_of_frames(); ++f) {
            const bool is_inside =
                v >= first_vertex && v < first_vertex + vertices && f >= first_frame && f < first_frame + frames;
            const FT expected = is_inside ? FT(xyz[f - first_frame][3 * (v - first_vertex) + c]) : FT(0);
            good = good && fields[c](v, f) == expected;
          }
    }
  CHECK(good);
}

} // namespace

int main()
{
  test_nasty_numbers();
  test_random_numbers();
  test_halfway_numbers();
  test_integers();
  test_all_finite<float, std::uint32_t>();
  test_all_finite<double, std::uint64_t>();
  test_bytes<std::int8_t>();
  test_bytes<std::uint16_t>();
  test_bytes<std::uint32_t>();
  test_bytes<float>();
  test_bytes<double>();
  test_transposition<float, float>();
  test_transposition<double, float>();
  test_transposition<double, double>();
  return test_result();
}
