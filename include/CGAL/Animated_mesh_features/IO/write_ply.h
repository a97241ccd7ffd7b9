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
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes features as a PLY point cloud, to be looked at next to the mesh in MeshLab, Blender or CloudCompare. Each point
is a feature's position on the animated surface at its time; further properties are `sigma`, `tau`, `time`, `strength`,
`radius`, `amplitude` and `fit` (`float`), `frame`, `vertex`, `rank`, `place` and `parent` (`int`; the last three from 1,
0 without a parent), `at_scale_limit` (`uchar`), and, if there are `colours`, `red`, `green` and `blue` (`uchar`), which
viewers show. Independent of the stream's locale.

\param os a binary stream; errors are left in its state, `Output_file` reports them
\param features a range of `Spatio_temporal_feature<VertexDescriptor>`
\param use_binary_mode `true`: binary, little-endian; `false`: ASCII
\param colours red, green and blue of each feature, encoded as sRGB; none by default

\throws Output_error if a frame or a vertex does not fit an `int` of PLY, 32 bits.
\throws Option_error if there are colours, but not as many as features.
*/
template <class FeatureRange>
void write_ply(std::ostream& os, const FeatureRange& features, bool use_binary_mode = true,
               const std::vector<std::array<std::uint8_t, 3>>& colours = {})
{
  const auto as_int = [](std::size_t i) {
    if (i > std::size_t((std::numeric_limits<std::int32_t>::max)()))
      throw Output_error("PLY cannot hold the index " + std::to_string(i));
    return static_cast<std::int32_t>(i);
  };

  const std::size_t n = std::size_t(std::distance(std::begin(features), std::end(features)));
  if (!colours.empty() && colours.size() != n)
    throw Option_error(std::to_string(colours.size()) + " colours for " + std::to_string(n) + " features");

  internal::Text_output out(os);
  out << "ply\nformat " << (use_binary_mode ? "binary_little_endian" : "ascii") << " 1.0\n"
      << "comment spatio-temporal features of an animated mesh\n"
      << "element vertex " << n << '\n';
  for (const char* name : {"x", "y", "z", "sigma", "tau", "time", "strength", "radius", "amplitude", "fit"})
    out << "property float " << name << '\n';
  for (const char* name : {"frame", "vertex", "rank", "place", "parent"}) out << "property int " << name << '\n';
  out << "property uchar at_scale_limit\n";
  if (!colours.empty()) out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out << "end_header\n";

  std::size_t i = 0;
  for (const auto& f : features) {
    const std::array<double, 10> values = {{f.position[0], f.position[1], f.position[2], f.sigma, f.tau, f.time,
                                            f.strength, f.radius(), f.amplitude, f.fit}};
    const std::array<std::int32_t, 5> indices = {
        {as_int(f.frame), as_int(f.vertex_index), as_int(i + 1), as_int(f.place + 1),
         f.parent == Feature_point::none ? 0 : as_int(f.parent + 1)}};
    std::string small(1, f.at_scale_limit ? '\1' : '\0');
    if (!colours.empty())
      for (std::uint8_t c : colours[i]) small += static_cast<char>(c);
    ++i;
    if (use_binary_mode) {
      const internal::Byte_order order = internal::Byte_order::LITTLE_ENDIAN_ORDER;
      char bytes[4 * (values.size() + indices.size())];
      char* p = bytes;
      for (double x : values) internal::store(p, static_cast<float>(x), order), p += 4;
      for (std::int32_t k : indices) internal::store(p, k, order), p += 4;
      out << std::string_view(bytes, sizeof(bytes)) << small;
    } else {
      for (double x : values) out << static_cast<float>(x) << ' ';
      for (std::int32_t k : indices) out << k << ' ';
      const char* separator = "";
      for (char c : small) {
        out << separator << std::size_t(static_cast<unsigned char>(c));
        separator = " ";
      }
      out << '\n';
    }
  }
  out.flush();
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_PLY_H
