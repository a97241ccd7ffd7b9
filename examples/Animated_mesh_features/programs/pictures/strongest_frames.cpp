// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/strongest_frames.h"

#include <algorithm>
#include <cmath>

namespace Programs {

namespace {

typedef std::vector<Shown_feature>::const_iterator Iterator;

// Adds frames of features, strongest first, that are at least `apart` frames from all that are chosen.
void add_frames(const std::vector<Shown_feature>& features, std::size_t most, std::size_t apart, bool elsewhere,
                std::vector<Iterator>& chosen)
{
  for (Iterator f = features.begin(); f != features.end() && chosen.size() < most; ++f) {
    const bool is_new = std::all_of(chosen.begin(), chosen.end(), [&](const Iterator& g) {
      const std::size_t distance = f->frame > g->frame ? f->frame - g->frame : g->frame - f->frame;
      double squared = 0;
      for (std::size_t i = 0; i < 3; ++i)
        squared += (f->rest_position[i] - g->rest_position[i]) * (f->rest_position[i] - g->rest_position[i]);
      return distance >= apart && !(elsewhere && std::sqrt(squared) < (std::max)(f->radius(), g->radius()));
    });
    if (is_new) chosen.push_back(f);
  }
}

} // namespace

std::vector<std::size_t> strongest_frames(const std::vector<Shown_feature>& features, std::size_t number_of_frames,
                                          std::size_t most)
{
  std::vector<Iterator> chosen;
  // as far from each other as the number of frames allows, then half as far, and so on until there are enough
  const std::size_t widest = number_of_frames / (most + 1);
  for (bool elsewhere : {true, false})
    for (std::size_t apart = widest; apart > 0 && apart >= widest / 4; apart /= 2)
      add_frames(features, most, apart, elsewhere, chosen);
  add_frames(features, (std::min)(most, std::size_t(1)), 1, false, chosen); // of a few frames
  std::vector<std::size_t> frames;
  for (const Iterator& f : chosen) frames.push_back(f->frame);
  if (frames.empty()) frames.push_back(number_of_frames / 2);
  std::sort(frames.begin(), frames.end());
  return frames;
}

} // namespace Programs
