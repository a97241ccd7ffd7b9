// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_ITEM_H
#define COMPARE_ANIMATIONS_ITEM_H

#include "reading/Reading_options.h"

#include <string>
#include <vector>

namespace Compare_animations {

// Something that can be compared: an animation, or a file of features.
struct Item
{
  std::string name;
  std::string feature_file;          // empty: an animation
  Programs::Reading_options reading; // of an animation
};

// What one word of the command line stands for: a file of features (.json), a point cache with its mesh nearby or
// before a comma, a model, a folder of frames.
// throws Input_error if there is no such file; Option_error.
Item item(const std::string& word, const Programs::Reading_options& common);

// Two of the same name get their paths as names, unless these are the same, too.
void tell_apart(Item& a, Item& b);

// What a collection consists of: a folder with any of these, a list of them (.txt), a model of which all clips are
// asked for. Names are unique.
// throws Input_error, also if there is nothing in it; Option_error.
std::vector<Item> collection(const std::vector<std::string>& words, const Programs::Reading_options& common);

// The files that they are made of, for checks of outputs.
std::vector<std::string> paths(const std::vector<Item>& items);

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_ITEM_H
