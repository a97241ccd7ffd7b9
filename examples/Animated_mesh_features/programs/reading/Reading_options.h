// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_READING_OPTIONS_H
#define PROGRAMS_READING_READING_OPTIONS_H

#include "options/Names.h"

#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace Programs {

class Option_group;

// Which shape is the undeformed one.
enum class Rest
{
  BY_INPUT, // what suits the kind of input
  FRAME,    // one of the animation
  MESH,     // the mesh that is given with a point cache
  BIND,     // an animated model without any clip
  AVERAGE,  // the canonical shape of all frames
  FILE      // another mesh
};

struct Rest_choice
{
  Rest kind = Rest::BY_INPUT;
  std::string text;      // as it was given
  std::string file;      // of FILE
  std::size_t frame = 0; // of FRAME, counted from 0
  bool rescale = false;  // scale it so that its edges are as long as those of the frames
};

// Frames that are taken of an animation, counted from 0.
struct Frame_range
{
  std::string text; // as it was given
  std::size_t first = 0;
  std::optional<std::size_t> last; // with it; none: to the end
};

// What is done with coincident vertices of a mesh.
enum class Weld
{
  AUTO,
  ALWAYS,
  NEVER
};

Names<Weld> names(Weld);

// Whether noise of the positions is taken out.
enum class Denoise
{
  AUTO, // where it is large
  ALWAYS,
  NEVER
};

Names<Denoise> names(Denoise);

// Which animation is read, and as what.
struct Reading_options
{
  std::vector<std::string> inputs; // files and folders, as input_help() tells
  std::optional<double> frames_per_second;
  std::optional<Frame_range> frame_range; // none: all
  bool as_given = false;    // frames are in the order of the inputs
  bool triangulate = false; // cut faces with more than three corners
  bool repair = false;      // mend what is no oriented manifold
  Weld weld = Weld::AUTO;
  bool skip_bad_frames = false; // bridge broken frames in time
  Denoise denoise = Denoise::AUTO;

  std::string part; // of the surface, by name or by the number of a component, from 1; empty: all
  bool is_cyclic = false; // leave out a last frame that repeats the first; no option of the reading

  // of files with clips
  std::string clip; // by name or number; empty: the first
  std::optional<std::size_t> clip_frames;
  bool there_and_back = false;
  std::string faces_dataset; // of HDF5; empty: the usual one
  bool allow_outside = false; // also read buffers of a model that are not in its folder

  Rest_choice rest;

  // files and folders that are named: the inputs and the rest shape
  std::vector<std::string> paths() const;
};

// Adds the options; the inputs themselves are no options. `all_clips`: what a program says of --clip all, if it takes it.
void add_reading_options(Option_group& group, Reading_options& options, const std::string& all_clips = "");

// From a frame in eleven days to a million in a second: beyond, squares of times leave the range of numbers.
bool is_usable_rate(double frames_per_second);

// What reads meshes is told of them.
CGAL::Animated_mesh_features::IO::Mesh_reading_options mesh_reading_options(const Reading_options& options);

// To be called when all options are there.
// throws Option_error if there is no input, or options do not go together.
void check(const Reading_options& options);

// What inputs may be: lines for the help text of a program.
std::string input_help();

} // namespace Programs

#endif // PROGRAMS_READING_READING_OPTIONS_H
