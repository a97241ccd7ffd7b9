// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_HTML_SCENE_H
#define PROGRAMS_PAGE_HTML_SCENE_H

#include "page/Html_options.h"
#include "page/Page_surface.h"
#include "page/Quantized_field.h"
#include "page/Quantized_positions.h"
#include "page/Surface_prediction.h"
#include "scenes/Shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace Programs {

// The scripts of a page that hold a scene: a description in JSON, and numbers. What is in them is told at write_html().
class Html_scene
{
public:
  // Keeps at most so many vertices, every `frame_step`-th frame, and the last one. `options` tell where the page opens.
  Html_scene(const Shown_scene& scene, const Html_sampling& sampling, const Html_options& options);

  std::size_t number_of_vertices() const { return m_surface.vertices().size(); }

  // in bounding-box diagonals of the rest shape
  double largest_error() const;

  // The ids of all scripts begin with `name`.
  void write(std::ostream& os, const std::string& name = "scene") const;

private:
  nlohmann::ordered_json description() const;
  nlohmann::ordered_json corners() const;
  nlohmann::ordered_json view() const;
  nlohmann::ordered_json places() const;
  std::string faces() const;
  std::string vertices() const;
  std::string positions(const Quantized_positions& positions, const std::vector<std::size_t>& frames) const;
  std::vector<std::uint8_t> residuals(const Quantized_field& field) const;

  const Shown_scene& m_scene;
  const Html_options m_options;
  const Page_surface m_surface;
  std::vector<std::size_t> m_frames; // that are kept
  Quantized_positions m_positions;
  const Quantized_positions::Trajectories m_rest; // the rest shape, as an animation of one frame
  Quantized_positions m_rest_positions;
  Surface_prediction m_prediction;
  std::vector<Quantized_field> m_fields;
};

} // namespace Programs

#endif // PROGRAMS_PAGE_HTML_SCENE_H
