// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "evaluate_features/write_region_mesh.h"

#include "rendering/Palette.h"
#include "scenes/append_little_endian.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace AMF = CGAL::Animated_mesh_features;

namespace Evaluate_features {

void write_region_mesh(std::ostream& os, const AMF::Rest_shape& shape, const std::vector<float>& values)
{
  float most = 0;
  for (float x : values) most = (std::max)(most, x);
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment regions of spatio-temporal features\nelement vertex " +
                     std::to_string(values.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
                     "property uchar blue\nproperty float quality\nelement face " +
                     std::to_string(shape.triangles().size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < values.size(); ++v) {
    for (int k = 0; k < 3; ++k) Programs::append_little_endian(text, float(shape.points()[v][k]));
    const double place = most > 0 ? double(values[v] / most) : 0;
    for (std::uint8_t c : Programs::Rendering::encoded(Programs::Rendering::field_colours()(place))) text += char(c);
    Programs::append_little_endian(text, values[v]);
  }
  for (const AMF::Rest_shape::Triangle& t : shape.triangles()) {
    text += char(3);
    for (AMF::Rest_shape::Index v : t) Programs::append_little_endian(text, std::int32_t(v));
  }
  os.write(text.data(), std::streamsize(text.size()));
}

} // namespace Evaluate_features
