// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_MODULE_ANIMATION_DATA_H
#define PYTHON_MODULE_ANIMATION_DATA_H

#include "Arguments.h"
#include "Python_monitor.h"
#include "Shape_data.h"
#include "reading/Animation.h"
#include "reading/Memory_plan.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace Python_module {

// An animation, and how it came to be.
class Animation_data : public Shape_data
{
public:
  // An array in the form in which a Python file has checked it: float32 or float64, N x 3, whatever its strides.
  struct Frame
  {
    const char* first; // coordinate
    std::ptrdiff_t of_vertex, of_coordinate;
    bool is_single;
  };

  // from files; `inputs` as the command line has them
  Animation_data(const std::vector<std::string>& inputs, const Arguments& arguments, Python_monitor& monitor);

  // of arrays, which need not live any longer; of `rest` there may be none.
  Animation_data(const std::vector<Frame>& frames, std::size_t vertices, const Faces_array& faces,
                 const Points_array& rest, const Arguments& arguments, Python_monitor& monitor);

  const AMF::Rest_shape& shape() const override { return sequence().rest_shape(); }

  const Programs::Animation& animation() const { return *m_animation; }
  const Programs::Sequence& sequence() const { return m_animation->sequence(); }
  const Programs::Reading_options& reading() const { return m_reading; }
  std::size_t level_memory() const { return m_plan.level_memory(); }

  // how many vertices the input has, before any are welded
  std::size_t number_of_input_vertices() const { return m_input_vertices; }

private:
  Animation_data(Options options, const std::vector<std::string>& inputs);

  Programs::Reading_options m_reading;
  Programs::Memory_plan m_plan;
  std::size_t m_threads;
  std::unique_ptr<const Programs::Animation> m_animation;
  std::size_t m_input_vertices = 0;
};

} // namespace Python_module

#endif // PYTHON_MODULE_ANIMATION_DATA_H
