// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_LENGTH_H
#define PROGRAMS_OPTIONS_LENGTH_H

#include "options/Argument.h"

namespace Programs {

// A length of the mesh, or a fraction of an extent: the diameter of the rest shape where features are detected, which does
// not change when the mesh is turned.
struct Length
{
  double value = 0;
  bool is_percentage = false;

  double on(double extent) const { return is_percentage ? value / 100 * extent : value; }
};

// throws Option_error if it is not positive.
inline Length length(const Argument& argument)
{
  const std::string& text = argument.text();
  if (text.empty() || text.back() != '%') return {argument.positive_number(), false};
  return {argument.part(0, text.size() - 1).positive_number(), true};
}

} // namespace Programs

#endif // PROGRAMS_OPTIONS_LENGTH_H
