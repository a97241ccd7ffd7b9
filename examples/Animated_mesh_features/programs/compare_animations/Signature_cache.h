// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_SIGNATURE_CACHE_H
#define COMPARE_ANIMATIONS_SIGNATURE_CACHE_H

#include "compare_animations/Item.h"
#include "compare_animations/Settings.h"

#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>

#include <string>

namespace Compare_animations {

// The file in which the signature of an animation is kept, in the folder of the cache, or beside the animation. Its
// name has a number in it that is made of the contents of all files of the animation and of all options that count:
// what has changed is not found. A file that cannot be understood is not found, either.
class Signature_cache
{
public:
  // throws Input_error if a file of the animation cannot be read.
  Signature_cache(const Item& item, const Settings& settings);

  bool find(CGAL::Animated_mesh_features::Animation_signature& signature) const;

  // throws Output_error.
  void keep(const CGAL::Animated_mesh_features::Animation_signature& signature) const;

private:
  std::string m_path; // empty: there is no cache
};

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_SIGNATURE_CACHE_H
