// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_POINT_CACHE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_POINT_CACHE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

inline std::int32_t cache_count(std::size_t n, const char* of_what)
{
  if (n > std::size_t((std::numeric_limits<std::int32_t>::max)()))
    throw Output_error("a point cache cannot hold " + std::to_string(n) + " " + of_what);
  return static_cast<std::int32_t>(n);
}

template <class T>
void put_scalar(std::ostream& os, T value, Byte_order order)
{
  char bytes[sizeof(T)];
  store(bytes, value, order);
  os.write(bytes, sizeof(T));
}

template <class Frame_source>
void put_frames(std::ostream& os, std::size_t number_of_points, std::size_t number_of_frames, Frame_source& frame,
                Byte_order order)
{
  std::vector<float> xyz(3 * number_of_points);
  std::vector<char> bytes(xyz.size() * sizeof(float));
  for (std::size_t f = 0; f < number_of_frames && os; ++f) {
    frame(f, xyz.data());
    for (std::size_t i = 0; i < xyz.size(); ++i) store(bytes.data() + i * sizeof(float), xyz[i], order);
    os.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes the positions of an animation as PC2 point cache (3ds Max, Blender, Maya): little-endian, single precision, no
connectivity.

\param os a binary stream; errors are left in its state, `Output_file` reports them
\param number_of_points `N`
\param number_of_frames `F`
\param frame a callable `void(std::size_t f, float* xyz)` that fills in the `3 N` coordinates of frame `f`, vertex by
       vertex. Called once for each frame, in their order.
\param start_frame number of the first frame in the program that will show it
\param sample_rate distance of the samples, in frames

\throws Output_error if `N` or `F` exceeds 2^31 - 1.
*/
template <class Frame_source>
void write_pc2(std::ostream& os, std::size_t number_of_points, std::size_t number_of_frames, Frame_source frame,
               float start_frame = 0, float sample_rate = 1)
{
  const internal::Byte_order order = internal::Byte_order::LITTLE_ENDIAN_ORDER;
  const std::int32_t n = internal::cache_count(number_of_points, "points");
  const std::int32_t f = internal::cache_count(number_of_frames, "frames");
  os.write("POINTCACHE2", 12); // with the final zero
  internal::put_scalar(os, std::int32_t(1), order);
  internal::put_scalar(os, n, order);
  internal::put_scalar(os, start_frame, order);
  internal::put_scalar(os, sample_rate, order);
  internal::put_scalar(os, f, order);
  internal::put_frames(os, number_of_points, number_of_frames, frame, order);
}

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes the positions of an animation as MDD point cache (LightWave, Blender): big-endian, single precision, no
connectivity.

\param times the time of each frame (s); there are as many frames as times
\param os,number_of_points,frame as for `write_pc2()`

\throws Output_error if `N` or `F` exceeds 2^31 - 1.
*/
template <class Frame_source>
void write_mdd(std::ostream& os, std::size_t number_of_points, const std::vector<float>& times, Frame_source frame)
{
  const internal::Byte_order order = internal::Byte_order::BIG_ENDIAN_ORDER;
  const std::int32_t n = internal::cache_count(number_of_points, "points");
  internal::put_scalar(os, internal::cache_count(times.size(), "frames"), order);
  internal::put_scalar(os, n, order);
  for (float t : times) internal::put_scalar(os, t, order);
  internal::put_frames(os, number_of_points, times.size(), frame, order);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_POINT_CACHE_H
