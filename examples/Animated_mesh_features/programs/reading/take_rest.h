// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_TAKE_REST_H
#define PROGRAMS_READING_TAKE_REST_H

#include "reading/Reading_options.h"
#include "reading/Rest_comparison.h"
#include "reading/Sequence.h"
#include "reading/Values.h"

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>

#include <string>
#include <vector>

namespace Programs {

// Which shape an animation is measured against.
struct Taken_rest
{
  std::string text;       // as --rest takes it, to get the same again
  std::string name;       // for a sentence: "the mesh walk.obj"
  std::string reason;     // why, where nobody chose
  bool is_scaled = false; // to the frames' unit
  double factor = 1;      // by which it was multiplied
};

// Sets the rest shape of a sequence, as the options ask for it, or, if they do not, by the kind of input: the mesh that is
// given with a point cache or the bind pose of a model, scaled if it is in another unit than the frames; the average of
// all frames if there is none of these, or it is but one of the frames. `data`: what the sequence was made of, without its
// coordinates. `is_model`: of which frames were made. Adds to `notices` what the user is to be told in any case.
// throws Option_error if there is no such shape, Input_error if it does not fit the frames, Cancelled if the visitor, which
// is told of the average, asks for it.
Taken_rest take_rest(const Reading_options& options, const CGAL::Animated_mesh_features::IO::Animation_file_data<FT>& data,
                     bool is_model, Sequence& sequence, std::vector<std::string>& notices,
                     CGAL::Animated_mesh_features::Any_visitor visitor = CGAL::Animated_mesh_features::Any_visitor());

// The shape that comes with the input or is named as rest shape, a point for each vertex; empty if there is none.
// throws Input_error if a file cannot be read or is not of the same connectivity.
Rest_points given_shape(const Reading_options& options,
                        const CGAL::Animated_mesh_features::IO::Animation_file_data<FT>& data, bool is_model);

// Sets the rest shape to these points, a point for each vertex; returns `taken` with the factor by which they were scaled.
// throws Input_error if they do not fit the frames.
Taken_rest take_points(const Rest_points& points, Taken_rest taken, Sequence& sequence);

} // namespace Programs

#endif // PROGRAMS_READING_TAKE_REST_H
