// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_ANIMATIONS_ANALYSED_ANIMATION_H
#define COMPARE_ANIMATIONS_ANALYSED_ANIMATION_H

#include "compare_animations/Item.h"
#include "compare_animations/Settings.h"
#include "detect_features/Detection.h"
#include "output/Result_files.h"
#include "output/Wanted_fields.h"
#include "reading/Animation.h"
#include "reading/Memory_plan.h"
#include "running/Stage_log.h"
#include "scenes/Shown_scene.h"

#include <CGAL/Animated_mesh_features/Applications/Animation_signature.h>

#include <cstddef>
#include <vector>

namespace Compare_animations {

// An animation that was read, with its deformation and the features in it.
class Analysed_animation
{
public:
  // throws Error.
  Analysed_animation(const Item& item, const Settings& settings);

  Analysed_animation(const Analysed_animation&) = delete;
  Analysed_animation& operator=(const Analysed_animation&) = delete;

  CGAL::Animated_mesh_features::Animation_signature signature(const Settings& settings) const;

  // The moving surface with the `most` strongest features. It refers to this.
  // To be called once.
  Programs::Shown_scene scene(std::size_t most);

private:
  std::string m_name;
  bool m_is_cyclic;
  Programs::Memory_plan m_plan;
  Programs::Animation m_animation;
  Programs::Stage_log m_log;
  Programs::Output_options m_outputs; // of nothing, but the deformation is kept as for a page
  Programs::Result_files m_files;
  Programs::Wanted_fields m_fields;
  Detect_features::Detection m_detection;
};

} // namespace Compare_animations

#endif // COMPARE_ANIMATIONS_ANALYSED_ANIMATION_H
