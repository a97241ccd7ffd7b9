// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_POSITION_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_POSITION_H

#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

typedef std::array<double, 3> Position;

template <class FT>
Position position(const Animation_file_data<FT>& data, std::size_t v, std::size_t f)
{
  return {{double(data.x(v, f)), double(data.y(v, f)), double(data.z(v, f))}};
}

inline double distance(const Position& a, const Position& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FRAME_POSITION_H
