// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_ANIMATION_H
#define DETECT_FEATURES_ANIMATION_H

#include "Command_line.h"

#include <CGAL/Animated_mesh_features/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_feature.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>

namespace Detect_features {

typedef double FT;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT> Sequence;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Sequence::vertex_descriptor> Feature;

// The animation and the rest shape that the command line names.
class Animation
{
public:
  // `observe_size` is told the size before the memory is taken.
  // throws Input_error and Option_error, and what `observe_size` throws.
  Animation(const Command_line& command_line, const CGAL::Animated_mesh_features::IO::Size_observer& observe_size);
  Animation(const Animation&) = delete;
  Animation& operator=(const Animation&) = delete;

  const Sequence& sequence() const { return *m_sequence; }
  std::size_t number_of_faces() const { return num_faces(m_mesh); }
  double frames_per_second() const { return m_frames_per_second; }

  // by which the rest shape was multiplied
  double rest_factor() const { return m_rest_factor; }

private:
  typedef CGAL::Animated_mesh_features::IO::Animation_file_data<FT> File_data;

  void set_clock(const Command_line& command_line, const File_data& data);
  void set_rest(const Command_line& command_line, const File_data& data);

  Mesh m_mesh;
  std::optional<Sequence> m_sequence; // refers to the mesh
  double m_frames_per_second = 0;
  double m_rest_factor = 1;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_ANIMATION_H
