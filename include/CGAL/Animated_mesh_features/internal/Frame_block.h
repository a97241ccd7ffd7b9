// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FRAME_BLOCK_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FRAME_BLOCK_H

#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// The values of one simplex in as many frames as fit into a cache line. Kernels are written for blocks: of fixed size,
// so that every compiler uses vector registers for them, and never with a remainder, since rows of a field are padded.
template <class FT>
struct Frame_block
{
  static constexpr std::size_t size = 64 / sizeof(FT);
  typedef Eigen::Array<FT, int(size), 1> Array;

  static std::size_t number_of_blocks(std::size_t number_of_frames) { return (number_of_frames + size - 1) / size; }

  static Eigen::Map<const Array> load(const Spatio_temporal_field<FT>& field, std::size_t row, std::size_t block)
  {
    return Eigen::Map<const Array>(field.row(row) + block * size);
  }

  static Eigen::Map<Array> at(Spatio_temporal_field<FT>& field, std::size_t row, std::size_t block)
  {
    return Eigen::Map<Array>(field.row(row) + block * size);
  }
};

// Three-dimensional vectors, one for each frame of a block.
template <class FT>
struct Vector_block
{
  typedef typename Frame_block<FT>::Array Array;
  Array x, y, z;

  Array dot(const Vector_block& b) const { return x * b.x + y * b.y + z * b.z; }

  Vector_block cross(const Vector_block& b) const
  {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
};

// (position of `to` minus position of `from`) * scale, in each frame of the block
template <class Animation, class FT>
Vector_block<FT> difference(const Animation& a, std::size_t from, std::size_t to, std::size_t block, FT scale)
{
  typedef Frame_block<FT> B;
  return {(B::load(a.x, to, block) - B::load(a.x, from, block)) * scale,
          (B::load(a.y, to, block) - B::load(a.y, from, block)) * scale,
          (B::load(a.z, to, block) - B::load(a.z, from, block)) * scale};
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_FRAME_BLOCK_H
