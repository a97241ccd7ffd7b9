// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERED_NAME_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERED_NAME_H

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What counts as a number in the name of a file; each form has the ones before it.
enum class Number_form
{
  WHOLE,     // sim-1: the number 1 after "sim-"
  SIGNED,    // sim-1: -1 after "sim"
  DECIMAL,   // t0.25, t0,25
  SCIENTIFIC // t2.5e-3
};

// A number as it is written.
struct Written_number
{
  char sign = 0;      // 0: none
  std::string digits; // those of the fraction too
  int exponent = 0;   // of ten
};

// A name as text and numbers.
struct Numbered_name
{
  std::string text; // with '#' for each number; in small letters
  std::vector<Written_number> numbers;
};

inline std::size_t end_of_digits(const std::string& s, std::size_t i)
{
  while (i < s.size() && s[i] >= '0' && s[i] <= '9') ++i;
  return i;
}

// Reads the number whose digits begin at `i`, which moves after it.
inline Written_number written_number(const std::string& name, std::size_t& i, Number_form form)
{
  Written_number number;
  std::size_t end = end_of_digits(name, i);
  number.digits = name.substr(i, end - i);
  i = end;
  if (form < Number_form::DECIMAL) return number;
  if (i < name.size() && (name[i] == '.' || name[i] == ',') && (end = end_of_digits(name, i + 1)) > i + 1) {
    number.digits += name.substr(i + 1, end - i - 1);
    number.exponent = -int(end - i - 1);
    i = end;
  }
  if (form < Number_form::SCIENTIFIC || i == name.size() || (name[i] != 'e' && name[i] != 'E')) return number;
  std::size_t begin = i + 1;
  const bool is_signed = begin < name.size() && (name[begin] == '-' || name[begin] == '+');
  if (is_signed) ++begin;
  end = end_of_digits(name, begin);
  const std::size_t most_digits = 3; // of an exponent
  if (end == begin || end - begin > most_digits) return number;
  const int exponent = std::stoi(name.substr(begin, end - begin));
  number.exponent += is_signed && name[begin - 1] == '-' ? -exponent : exponent;
  i = end;
  return number;
}

// Whether a hyphen stands before some number that has a sign of its own, as in `sim--1`.
inline bool has_hyphen_before_sign(const std::string& name)
{
  for (std::size_t i = name.find("--"); i != std::string::npos; i = name.find("--", i + 1))
    if (end_of_digits(name, i + 2) > i + 2) return true;
  return false;
}

// `are_after_hyphens`: of two hyphens one is a sign, and one alone is none.
inline Numbered_name numbered_name(const std::string& name, Number_form form, bool are_after_hyphens)
{
  Numbered_name result;
  for (std::size_t i = 0; i < name.size();) {
    if (end_of_digits(name, i) == i) {
      const char c = name[i++];
      result.text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      continue;
    }
    Written_number number = written_number(name, i, form);
    std::string& text = result.text;
    const bool has_sign = !text.empty() && (text.back() == '-' || text.back() == '+') &&
                          (!are_after_hyphens || (text.size() > 1 && text[text.size() - 2] == '-'));
    if (form != Number_form::WHOLE && has_sign) {
      number.sign = text.back();
      text.pop_back();
    }
    text += '#';
    result.numbers.push_back(std::move(number));
  }
  return result;
}

// The numbers at one place of several names, as multiples of the smallest unit that is written; nothing if they are
// too long. A sign that all of them have is a hyphen.
inline std::optional<std::vector<long long>> values(const std::vector<Written_number>& numbers)
{
  const auto less = [](const Written_number& a, const Written_number& b) { return a.exponent < b.exponent; };
  const int unit = std::min_element(numbers.begin(), numbers.end(), less)->exponent;
  const bool has_signs = std::any_of(numbers.begin(), numbers.end(),
                                     [&](const Written_number& n) { return n.sign != numbers.front().sign; });
  std::vector<long long> values;
  for (const Written_number& n : numbers) {
    const std::size_t zeros = (std::min)(n.digits.find_first_not_of('0'), n.digits.size());
    const std::size_t most_digits = 17; // so that differences fit, too
    const std::size_t appended = zeros == n.digits.size() ? 0 : std::size_t(n.exponent - unit);
    if (n.digits.size() - zeros + appended > most_digits) return std::nullopt;
    const std::string digits = "0" + n.digits.substr(zeros) + std::string(appended, '0');
    const long long value = std::stoll(digits);
    values.push_back(has_signs && n.sign == '-' ? -value : value);
  }
  return values;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_NUMBERED_NAME_H
