// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/Argument.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

double Argument::number() const
{
  char* end = nullptr;
  const bool is_blank = m_text.empty() || std::isspace(static_cast<unsigned char>(m_text[0]));
  const double x = is_blank ? 0 : std::strtod(m_text.c_str(), &end);
  if (end == nullptr || *end != '\0' || !std::isfinite(x)) refuse("is no number");
  return x;
}

double Argument::positive_number() const
{
  const double x = number();
  if (!(x > 0)) refuse("is not positive");
  return x;
}

double Argument::non_negative_number() const
{
  const double x = number();
  if (!(x >= 0)) refuse("is negative");
  return x;
}

std::size_t Argument::count() const
{
  const std::size_t most_digits = 9;
  const bool digits = std::all_of(m_text.begin(), m_text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (m_text.empty() || !digits || m_text.size() > most_digits) refuse("is no number from 0 to 999999999");
  return std::size_t(std::strtoul(m_text.c_str(), nullptr, 10));
}

std::size_t Argument::bytes() const
{
  std::size_t length = m_text.size();
  double unit = 1;
  const std::string units = "KMGT";
  const std::size_t power =
      m_text.empty() ? std::string::npos : units.find(char(std::toupper(static_cast<unsigned char>(m_text.back()))));
  if (power != std::string::npos) {
    --length;
    unit = std::ldexp(1., 10 * (int(power) + 1));
  }
  const double bytes = unit * part(0, length).positive_number();
  if (!(bytes < std::ldexp(1., 62))) refuse("is too much");
  return std::size_t(bytes);
}

void Argument::refuse(const std::string& reason) const
{
  throw Option_error(m_option + ": \"" + m_text + "\" " + reason);
}

} // namespace Programs
