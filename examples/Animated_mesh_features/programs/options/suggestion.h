// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OPTIONS_SUGGESTION_H
#define PROGRAMS_OPTIONS_SUGGESTION_H

#include <string>
#include <vector>

namespace Programs {

// What was probably meant by a word that is not known: the only known one that begins with it, or the nearest by the number
// of letters that are missing, added, changed or swapped with their neighbour, if these are a third of the word at most
// (the first of several that are equally near). Empty if there is none.
std::string probable_word(const std::string& word, const std::vector<std::string>& known);

// The same as the end of a sentence: "; did you mean NAME?", or nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

} // namespace Programs

#endif // PROGRAMS_OPTIONS_SUGGESTION_H
