// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/Painters.h"

#include <CGAL/Animated_mesh_features/IO/read_painting.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;

namespace Evaluate_features {

Painters::Painters(const std::vector<std::string>& files, const Feature_file& features)
{
  const auto& d = features.data.description;
  for (const std::string& file : files) {
    const AMF::IO::Painting_file_data painting = AMF::IO::read_painting(file);
    const double tolerance = 1e-3; // files may have rounded the time between two frames
    if (painting.vertices != d.vertices || painting.frames != d.frames ||
        !(std::abs(painting.frame_duration - d.frame_duration) <= tolerance * d.frame_duration))
      throw AMF::Input_error(file + ": was painted on " + std::to_string(painting.vertices) + " vertices in " +
                             std::to_string(painting.frames) + " frames, the features of " + features.path +
                             " were found on " + std::to_string(d.vertices) + " in " + std::to_string(d.frames));
    const auto place = m_ranks.emplace(painting.painter, m_maps.size());
    if (place.second) {
      m_maps.emplace_back(d.vertices, d.frames);
      m_files.push_back(file);
    }
    for (const AMF::IO::Painting_file_data::Stroke& s : painting.strokes)
      for (std::size_t v : s.vertices)
        std::fill(m_maps[place.first->second].row(v) + s.first_frame,
                  m_maps[place.first->second].row(v) + s.last_frame + 1, 1.f);
  }
  check();
}

std::vector<Painters::Map> Painters::shadows() const
{
  std::vector<Map> result;
  for (const Map& map : m_maps) {
    Map shadow(map.number_of_rows(), 1);
    for (std::size_t v = 0; v < map.number_of_rows(); ++v)
      shadow(v, 0) = *std::max_element(map.row(v), map.row(v) + map.number_of_frames());
    bool is_everywhere = true;
    for (std::size_t v = 0; v < map.number_of_rows(); ++v) is_everywhere = is_everywhere && shadow(v, 0) > 0;
    if (is_everywhere) return {};
    result.push_back(std::move(shadow));
  }
  return result;
}

void Painters::check() const
{
  for (std::size_t i = 0; i < m_maps.size(); ++i) {
    bool is_painted = false, is_left = false; // somewhere
    for (std::size_t v = 0; v < m_maps[i].number_of_rows(); ++v)
      for (std::size_t f = 0; f < m_maps[i].number_of_frames(); ++f)
        (m_maps[i](v, f) > 0 ? is_painted : is_left) = true;
    if (!is_painted) throw AMF::Input_error(m_files[i] + ": its painter has painted nothing");
    if (!is_left) throw AMF::Input_error(m_files[i] + ": its painter has painted everything");
  }
}

} // namespace Evaluate_features
