// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_PLY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_PLY_H

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/Text_output.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes features as a PLY point cloud, to be looked at next to the mesh in MeshLab, Blender or CloudCompare. Each point
is a feature's position on the animated surface at its time; further properties are `sigma`, `tau`, `time`, `strength`,
`radius`, `amplitude` and `fit` (`float`), `frame`, `vertex`, `place` and `parent` (`int`, -1 without a parent). Independent of the stream's locale.

\param os a binary stream; errors are left in its state, `Output_file` reports them
\param features a range of `Spatio_temporal_feature<VertexDescriptor>`
\param use_binary_mode `true`: binary, little-endian; `false`: ASCII

\throws Output_error if a frame or a vertex does not fit an `int` of PLY, 32 bits.
*/
template <class FeatureRange>
void write_ply(std::ostream& os, const FeatureRange& features, bool use_binary_mode = true)
{
  const auto as_int = [](std::size_t i) {
    if (i > std::size_t((std::numeric_limits<std::int32_t>::max)()))
      throw Output_error("PLY cannot hold the index " + std::to_string(i));
    return static_cast<std::int32_t>(i);
  };

  internal::Text_output out(os);
  out << "ply\nformat " << (use_binary_mode ? "binary_little_endian" : "ascii") << " 1.0\n"
      << "comment spatio-temporal features of an animated mesh\n"
      << "element vertex " << std::size_t(std::distance(std::begin(features), std::end(features))) << '\n';
  for (const char* name : {"x", "y", "z", "sigma", "tau", "time", "strength", "radius", "amplitude", "fit"})
    out << "property float " << name << '\n';
  out << "property int frame\nproperty int vertex\nproperty int place\nproperty int parent\nend_header\n";

  for (const auto& f : features) {
    const std::array<double, 10> values = {{f.position[0], f.position[1], f.position[2], f.sigma, f.tau, f.time,
                                            f.strength, f.radius(), f.amplitude, f.fit}};
    const std::array<std::int32_t, 4> indices = {{as_int(f.frame), as_int(f.vertex_index), as_int(f.place),
                                                  f.parent == Feature_point::none ? -1 : as_int(f.parent)}};
    if (use_binary_mode) {
      const internal::Byte_order order = internal::Byte_order::LITTLE_ENDIAN_ORDER;
      char bytes[4 * (values.size() + indices.size())];
      char* p = bytes;
      for (double x : values) internal::store(p, static_cast<float>(x), order), p += 4;
      for (std::int32_t i : indices) internal::store(p, i, order), p += 4;
      out << std::string_view(bytes, sizeof(bytes));
    } else {
      for (double x : values) out << static_cast<float>(x) << ' ';
      out << indices[0] << ' ' << indices[1] << ' ' << indices[2] << ' ' << indices[3] << '\n';
    }
  }
  out.flush();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_PLY_H
