// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_DETECTION_DATA_H
#define PYTHON_MODULE_DETECTION_DATA_H

#include "Animation_data.h"
#include "Arguments.h"
#include "Python_monitor.h"
#include "Shape_data.h"
#include "detect_features/Detection.h"
#include "output/Output_options.h"
#include "reading/Values.h"

#include <CGAL/Animated_mesh_features/IO/Result_description.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Python_module {

// What a detection found, and how.
class Detection_data
{
public:
  struct Field_values
  {
    Programs::Field kind;
    Programs::Values values;
  };

  // `kept`: fields that are to be had afterwards.
  Detection_data(std::shared_ptr<const Animation_data> animation, const Arguments& arguments,
                 std::set<Programs::Field> kept, Python_monitor& monitor);

  // in a field that was measured or made elsewhere
  Detection_data(std::shared_ptr<const Shape_data> shape, Programs::Values field, double frame_duration, double noise,
                 const Arguments& arguments, Python_monitor& monitor);

  const Detect_features::Detection& detection() const { return m_detection; }
  const Shape_data& shape() const { return *m_shape; }
  double frame_duration() const { return m_frame_duration; }
  const Animation_data* animation() const { return m_animation.get(); } // null if there is but a field

  // null if it was not kept
  const Programs::Values* field(Programs::Field kind) const;

  AMF::IO::Result_description description() const;

  // why there are no features, as the end of a sentence; empty if there are some, or it is not known
  std::string reason() const;

  // The files that the arguments tell, as the command line has them.
  // throws Output_error, Option_error.
  void write(const Arguments& arguments) const;

private:
  std::shared_ptr<const Shape_data> m_shape;
  std::shared_ptr<const Animation_data> m_animation; // the same, if it is one
  Detect_features::Method_options m_method;
  Detect_features::Detection m_detection;
  double m_frame_duration;
  std::size_t m_frames;
  std::vector<Field_values> m_fields;
};

// A single field of an animation, N x F. The deformation is that in which features are found.
// throws Option_error, Numerical_error, Cancelled.
Programs::Values measured_field(const Animation_data& animation, Programs::Field kind, const Arguments& arguments,
                                Python_monitor& monitor);

// of each vertex the vertices around it
AMF::Compressed_rows geodesic_balls(const Shape_data& shape, const Arguments& arguments, Python_monitor& monitor);

} // namespace Python_module

#endif // PYTHON_MODULE_DETECTION_DATA_H
