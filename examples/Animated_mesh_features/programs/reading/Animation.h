// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_ANIMATION_H
#define PROGRAMS_READING_ANIMATION_H

#include "reading/Reading_options.h"
#include "reading/Sequence.h"
#include "reading/take_rest.h"

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Memory_chooser.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Programs {

// The animation and the rest shape that were asked for.
class Animation
{
public:
  // `visitor` is told of the average, if that becomes the rest shape, and of denoising.
  // throws Input_error and Option_error, and what `choose_memory` throws; Numerical_error, Cancelled.
  Animation(const Reading_options& options, const CGAL::Animated_mesh_features::IO::Memory_chooser& choose_memory,
            CGAL::Animated_mesh_features::Any_visitor visitor = CGAL::Animated_mesh_features::Any_visitor());

  // The same of an animation that was not read from files, but is checked, welded and repaired as if it were: `data` has
  // the points of its first frame as those of its mesh, two names as its sources, those of the faces and of the frames in
  // messages, and no clips. The rest shape is `rest`, a point for each vertex of the data, or, if that is empty, what the
  // options tell.
  // throws Input_error, Option_error, Numerical_error, Cancelled.
  Animation(const Reading_options& options, CGAL::Animated_mesh_features::IO::Animation_file_data<FT> data,
            const Rest_points& rest,
            CGAL::Animated_mesh_features::Any_visitor visitor = CGAL::Animated_mesh_features::Any_visitor());

  Animation(const Animation&) = delete;
  Animation& operator=(const Animation&) = delete;

  const Sequence& sequence() const { return *m_sequence; }
  std::size_t number_of_faces() const { return num_faces(m_mesh); }
  double frames_per_second() const { return m_frames_per_second; }

  // also of those that were not asked for
  std::size_t number_of_frames_read() const { return m_frames_read; }

  // names of all clips in the file; empty if it has none
  const std::vector<std::string>& clips() const { return m_clips; }

  // of the one that is taken: its name, or its number if there are others of that name
  const std::string& clip_name() const { return m_clip_name; }

  // what parts of the surface there are, or of the one that is taken, as --part takes them: a line
  const std::string& parts() const { return m_parts; }

  // whether the frames were made here, from keys
  bool is_sampled() const { return m_is_sampled; }

  // which vertices of the file the vertices are made of; empty if they are the same
  const CGAL::Animated_mesh_features::IO::Vertex_origins& origins() const { return m_origins; }

  // what was left out or changed on reading
  const std::vector<std::string>& remarks() const { return m_remarks; }

  // the files that were read: members of folders, buffers of models, the rest shape
  const std::vector<std::string>& files() const { return m_files; }

  // what the user is to be told of the reading in any case
  const std::vector<std::string>& notices() const { return m_notices; }

  // of the positions, that was taken out, a length; 0: none was
  double noise() const { return m_noise; }

  // which rest shape was taken, and why
  const Taken_rest& rest() const { return m_rest; }

private:
  typedef CGAL::Animated_mesh_features::IO::Animation_file_data<FT> File_data;

  void take(const Reading_options& options, File_data& data);

  Mesh m_mesh;
  std::optional<Sequence> m_sequence; // refers to the mesh
  double m_frames_per_second = 0, m_noise = 0;
  std::size_t m_frames_read = 0;
  bool m_is_sampled = false;
  std::vector<std::string> m_clips, m_remarks, m_notices, m_files;
  std::string m_clip_name, m_parts;
  CGAL::Animated_mesh_features::IO::Vertex_origins m_origins;
  Taken_rest m_rest;
};

} // namespace Programs

#endif // PROGRAMS_READING_ANIMATION_H
