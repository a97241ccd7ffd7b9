// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_POSITION_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_POSITION_ROWS_H

#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Packed_vector.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The values of one simplex in as many frames as fit into a cache line are computed with together: never with a
// remainder, since rows of a field are padded.
template <class FT>
struct Frame_pack
{
  static constexpr std::size_t size = 64 / sizeof(FT);

  // that many frames are a block
  static std::size_t number_of_blocks(std::size_t number_of_frames) { return (number_of_frames + size - 1) / size; }
};

// The coordinates of all vertices in the frames of a block.
template <class FT>
struct Position_rows
{
  const FT *x, *y, *z;
  std::size_t stride; // from a vertex to the next

  Position_rows(const Vertex_trajectories<FT>& a, std::size_t block)
    : x(a.x.row(0) + block * Frame_pack<FT>::size)
    , y(a.y.row(0) + block * Frame_pack<FT>::size)
    , z(a.z.row(0) + block * Frame_pack<FT>::size)
    , stride(a.x.stride())
  {}
  Position_rows(const FT* x, const FT* y, const FT* z, std::size_t stride)
    : x(x)
    , y(y)
    , z(z)
    , stride(stride)
  {}
};

// Calls a function of the user's, which takes Eigen arrays of a cache line, with packs.
template <class L, class Function, class... Arguments>
CGAL_ANIMATED_MESH_FEATURES_INLINE L call_with_arrays(const Function& function, const Arguments&... arguments)
{
  typedef Eigen::Array<typename L::Scalar, int(L::size), 1> Array;
  const auto array = [](const L& x) {
    Array result;
    x.store(result.data());
    return result;
  };
  const Array result = function(array(arguments)...);
  return L::load(result.data());
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_INTERNAL_POSITION_ROWS_H
