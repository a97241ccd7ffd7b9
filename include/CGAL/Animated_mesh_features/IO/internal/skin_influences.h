// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SKIN_INFLUENCES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SKIN_INFLUENCES_H

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Appends those of the next vertex, brought to the form in which equal ones are equal bit for bit: ascending by joint,
// without zeros, with sum 1. If all weights are zero, the vertex moves with the first joint named, as renderers have
// it.
inline void append_influences(std::vector<Keyframed_model::Influence> influences, Keyframed_model::Geometry& geometry)
{
  typedef Keyframed_model::Influence Influence;
  if (geometry.first_influence.empty()) geometry.first_influence.push_back(0);
  const std::size_t first_joint = influences.empty() ? 0 : influences.front().joint;
  influences.erase(
      std::remove_if(influences.begin(), influences.end(), [](const Influence& i) { return !(i.weight > 0); }),
      influences.end());
  if (influences.empty()) influences.push_back({first_joint, 1});
  std::sort(influences.begin(), influences.end(), [](const Influence& a, const Influence& b) {
    return a.joint != b.joint ? a.joint < b.joint : a.weight < b.weight;
  });
  double sum = 0;
  for (const Influence& i : influences) sum += i.weight;
  for (Influence& i : influences) i.weight /= sum;
  geometry.influences.insert(geometry.influences.end(), influences.begin(), influences.end());
  geometry.first_influence.push_back(geometry.influences.size());
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SKIN_INFLUENCES_H
