// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_NAMES_H
#define PROGRAMS_OPTIONS_NAMES_H

#include "options/suggestion.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <string>
#include <utility>
#include <vector>

// What the user chooses by name. Beside each such enumeration stands a function `names()`, which takes any of its values
// and returns all of them with their names, in the order in which they are told.

namespace Programs {

template <class Choice>
using Names = std::vector<std::pair<std::string, Choice>>;

template <class Choice>
std::string name(Choice choice)
{
  for (const auto& n : names(choice))
    if (n.second == choice) return n.first;
  return "";
}

// The choice of a name.
// throws Option_error, with all that could be chosen and what was probably meant, if there is none.
template <class Choice>
Choice chosen(const std::string& option, const std::string& text)
{
  std::string all;
  std::vector<std::string> known;
  for (const auto& n : names(Choice())) {
    if (n.first == text) return n.second;
    all += (all.empty() ? "" : ", ") + n.first;
    known.push_back(n.first);
  }
  throw CGAL::Animated_mesh_features::Option_error(option + ": there is no \"" + text + "\"; choose among " + all +
                                                   suggestion(text, known));
}

} // namespace Programs

#endif // PROGRAMS_OPTIONS_NAMES_H
