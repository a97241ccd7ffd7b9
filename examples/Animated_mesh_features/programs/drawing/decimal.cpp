// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "drawing/decimal.h"

#include <cmath>
#include <cstddef>

namespace Programs {

std::string decimal(long long n, int exponent)
{
  if (n < 0) return "-" + decimal(-n, exponent);
  std::string digits = std::to_string(n);
  if (n == 0 || exponent >= 0) return n == 0 ? "0" : digits + std::string(std::size_t(exponent), '0');
  const std::size_t places = std::size_t(-exponent);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, 1, '.');
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

std::string rounded(double x, int digits)
{
  if (!(std::abs(x) > 0) || !std::isfinite(x)) return "0";
  const int exponent = int(std::floor(std::log10(std::abs(x)))) - digits + 1;
  const long long n = std::llround(x / std::pow(10., exponent));
  const int leading = exponent + int(std::to_string(std::abs(n)).size()) - 1;
  const int most_places = 5;
  if (std::abs(leading) <= most_places) return decimal(n, exponent);
  return decimal(n, exponent - leading) + "e" + std::to_string(leading);
}

} // namespace Programs
