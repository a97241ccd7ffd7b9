// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_RANGE_H
#define PROGRAMS_OPTIONS_RANGE_H

#include "options/Argument.h"

#include <cstddef>
#include <optional>
#include <string>

namespace Programs {

// MIN:MAX, of which either may be left out.
template <class T>
struct Range
{
  std::string text; // as it was given, or empty
  std::optional<T> min, max;
};

// A range of what `bound(argument)` makes of either side.
// throws Option_error, and what `bound` throws.
template <class Bound>
auto range(const Argument& argument, const Bound& bound) -> Range<decltype(bound(argument))>
{
  const std::string& text = argument.text();
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || text.size() == 1 || text.find(':', colon + 1) != std::string::npos)
    argument.refuse("is no range MIN:MAX, MIN: or :MAX");
  Range<decltype(bound(argument))> r;
  r.text = text;
  if (colon > 0) r.min = bound(argument.part(0, colon));
  if (colon + 1 < text.size()) r.max = bound(argument.part(colon + 1));
  return r;
}

} // namespace Programs

#endif // PROGRAMS_OPTIONS_RANGE_H
