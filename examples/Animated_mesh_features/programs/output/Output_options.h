// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_OUTPUT_OUTPUT_OPTIONS_H
#define PROGRAMS_OUTPUT_OUTPUT_OPTIONS_H

#include "options/Names.h"
#include "pictures/Picture_options.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Programs {

class Option_group;

enum class Field
{
  STRAIN,
  CURVATURE,
  DEFORMATION
};
enum class Format
{
  JSON,
  CSV,
  PLY
};
enum class Scene_format
{
  HTML,
  VTK,
  GLB,
  PLOT,
  PNG,
  VIEWS,
  VIEW_MAP
}; // each has an option of its own

Names<Field> names(Field);
Names<Format> names(Format);
Names<Scene_format> names(Scene_format);

// "-" is the standard output.
template <class Kind>
struct Requested_file
{
  Kind kind;
  std::string path;
};

// Which files are written, and what they show.
struct Output_options
{
  std::vector<Requested_file<Format>> features;
  std::vector<Requested_file<Field>> fields;
  std::string vertex_map; // empty: none
  std::vector<Requested_file<Scene_format>> scenes;
  std::size_t html_frame_step = 0; // 0: as the size of the page allows
  Picture_options picture;
  bool is_table_shown = false; // to somebody at a terminal, who asks for no file
  bool no_sync = false; // do not wait for the disk

  // whether the curvature is part of the deformation. Who leaves it out does not want to wait for it: no scene shows it
  // then, unless it is written.
  bool is_curvature_used = true;

  bool is_written(Field field) const;

  // whether a scene shows it, so that it is kept until the features are known
  bool is_shown(Field field) const;

  // how many fields there are at a time besides those of every detection
  std::size_t extra_fields() const;

  bool has_scene(Scene_format format) const;

  // whether a scene is looked at from where the program chooses
  bool has_chosen_views() const;

  CGAL::Animated_mesh_features::IO::Output_sync sync() const;

  // the paths of all outputs, in their order
  std::vector<std::string> paths() const;
};

void add_output_options(Option_group& group, Output_options& options);

// To be called when all options are there: whoever asks for no file at all gets JSON on the standard output, or a table if
// that is a terminal.
// throws Option_error if options of pictures do not go together.
void complete(Output_options& options);

} // namespace Programs

#endif // PROGRAMS_OUTPUT_OUTPUT_OPTIONS_H
