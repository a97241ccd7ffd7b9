// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EVALUATE_FEATURES_PAINTERS_H
#define EVALUATE_FEATURES_PAINTERS_H

#include "evaluate_features/Feature_file.h"

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace Evaluate_features {

// What each of several people painted: 1 where and when it is painted, 0 elsewhere. A painter may have several files.
class Painters
{
public:
  typedef CGAL::Animated_mesh_features::Spatio_temporal_field<float> Map;

  // throws Input_error if a file was painted on another animation, or a painter has painted nothing, or everything.
  Painters(const std::vector<std::string>& files, const Feature_file& features);

  // in space and time, N x F each
  const std::vector<Map>& maps() const { return m_maps; }

  // in space, N x 1 each: whether a vertex is painted in any frame; none if somebody has painted all of them
  std::vector<Map> shadows() const;

private:
  void check() const;

  std::map<std::string, std::size_t> m_ranks; // of the painters
  std::vector<std::string> m_files;           // the first of each
  std::vector<Map> m_maps;
};

} // namespace Evaluate_features

#endif // EVALUATE_FEATURES_PAINTERS_H
