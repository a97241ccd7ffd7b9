// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_ANIMATION_H
#define DETECT_FEATURES_ANIMATION_H

#include "detect_features/Command_line.h"

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/Detection/Spatio_temporal_feature.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <string>
#include <vector>

namespace Detect_features {

typedef double FT;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef CGAL::Animated_mesh_features::Frame_sequence<Mesh, FT> Sequence;
typedef CGAL::Animated_mesh_features::Spatio_temporal_feature<Sequence::vertex_descriptor> Feature;

// The animation and the rest shape that the command line names.
class Animation
{
public:
  // throws Input_error and Option_error, and what `choose_memory` throws.
  Animation(const Command_line& command_line, const CGAL::Animated_mesh_features::IO::Memory_chooser& choose_memory);
  Animation(const Animation&) = delete;
  Animation& operator=(const Animation&) = delete;

  const Sequence& sequence() const { return *m_sequence; }
  std::size_t number_of_faces() const { return num_faces(m_mesh); }
  double frames_per_second() const { return m_frames_per_second; }

  // names of all clips in the file; empty if it has none
  const std::vector<std::string>& clips() const { return m_clips; }

  // of the one that is taken: its name, or its number if there are others of that name
  const std::string& clip_name() const { return m_clip_name; }

  // whether the frames were made here, from keys
  bool is_sampled() const { return m_is_sampled; }

  // which vertices of the file the vertices are made of; empty if they are the same
  const CGAL::Animated_mesh_features::IO::Vertex_origins& origins() const { return m_origins; }

  // what was left out or changed on reading
  const std::vector<std::string>& remarks() const { return m_remarks; }

  // by which the rest shape was multiplied
  double rest_factor() const { return m_rest_factor; }

private:
  typedef CGAL::Animated_mesh_features::IO::Animation_file_data<FT> File_data;

  void take_notes(File_data& data);
  void set_frame_duration(const Command_line& command_line, const File_data& data);
  void set_rest(const Command_line& command_line, const File_data& data);

  Mesh m_mesh;
  std::optional<Sequence> m_sequence; // refers to the mesh
  double m_frames_per_second = 0;
  bool m_is_sampled = false;
  std::vector<std::string> m_clips, m_remarks;
  std::string m_clip_name;
  CGAL::Animated_mesh_features::IO::Vertex_origins m_origins;
  double m_rest_factor = 1;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_ANIMATION_H
