// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_TAKEN_PARTS_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_TAKEN_PARTS_H

#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesModels

which parts of a model a name means: those at a node of that name or below one, those of a mesh of that name; of NAME/P only
its primitive `P`. All of them, if nothing has that name.

\return for each part of the model whether it is meant; nothing, if nothing is.
*/
inline std::vector<char> taken_parts(const Keyframed_model& model, const std::string& name)
{
  const auto is_at = [&](const Keyframed_model::Part& part, const std::string& wanted) {
    if (wanted.empty()) return false;
    if (part.mesh == wanted) return true;
    for (std::size_t node = part.node, steps = 0; node != Keyframed_model::none && steps < model.nodes.size();
         ++steps) {
      if (model.nodes[node].name == wanted) return true;
      node = model.nodes[node].parent;
    }
    return false;
  };
  const std::size_t slash = name.rfind('/');
  const auto is_meant = [&](const Keyframed_model::Part& part) {
    return is_at(part, name) ||
           (slash != std::string::npos && name.substr(slash + 1) == std::to_string(part.primitive) &&
            is_at(part, name.substr(0, slash)));
  };
  std::vector<char> taken;
  for (const Keyframed_model::Part& part : model.parts) taken.push_back(is_meant(part));
  if (std::find(taken.begin(), taken.end(), char(1)) == taken.end()) taken.clear();
  return taken;
}

/*!
\ingroup PkgAnimatedMeshFeaturesModels

the names of the nodes and meshes of a model that parts of it have, in its order, each once.
*/
inline std::vector<std::string> part_names(const Keyframed_model& model)
{
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const Keyframed_model::Part& part : model.parts)
    for (const std::string& name : {model.nodes[part.node].name, part.mesh})
      if (!name.empty() && known.insert(name).second) names.push_back(name);
  return names;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_TAKEN_PARTS_H
