// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_MEMORY_PLAN_H
#define PROGRAMS_READING_MEMORY_PLAN_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Detection/Memory_estimate.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace Programs {

// Decides, as soon as the size of an animation is known, whether it is computed in memory or on the scratch directory.
class Memory_plan
{
public:
  // `limit` bytes, or what is available; `scratch_directory` is used only if there is a limit.
  Memory_plan(std::optional<std::size_t> limit, std::string scratch_directory);

  // Called before anything of the size of the animation is allocated. `fields` of the size of a coordinate are
  // kept besides those of every detection. The last call counts.
  // returns where coordinates are to live, and with them all fields.
  // throws Error if the memory will not do, with the estimate; Output_error if the scratch directory will not.
  std::shared_ptr<CGAL::Animated_mesh_features::Field_memory> decide(std::size_t number_of_vertices,
                                                                     std::size_t number_of_frames, std::size_t fields);

  // Called when the shape is known, whose geodesic balls may have more vertices than was thought. What lives where is
  // decided already; what changes are the report and the memory that is left for the space levels.
  void refine(const CGAL::Animated_mesh_features::Rest_shape& shape);

  // for the space levels
  std::size_t level_memory() const { return m_level_memory; }

  // one line, for --verbose
  const std::string& report() const { return m_report; }

private:
  CGAL::Animated_mesh_features::Memory_estimate with_fields(CGAL::Animated_mesh_features::Memory_estimate estimate) const;
  void plan_in_memory(const CGAL::Animated_mesh_features::Memory_estimate& estimate);

  std::optional<std::size_t> m_limit;
  std::string m_scratch_directory;
  std::size_t m_available = 0; // before anything was read
  std::size_t m_frames = 0, m_extra_fields = 0;
  bool m_is_in_memory = true;
  std::size_t m_level_memory = std::size_t(-1);
  std::string m_report;
};

} // namespace Programs

#endif // PROGRAMS_READING_MEMORY_PLAN_H
