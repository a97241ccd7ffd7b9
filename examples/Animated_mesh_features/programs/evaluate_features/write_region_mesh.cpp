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
  std::string text =
      "ply\nformat binary_little_endian 1.0\ncomment regions of spatio-temporal features\nelement vertex " +
      std::to_string(values.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty float quality\nelement face " +
      std::to_string(shape.triangles().size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  std::vector<float> place(3), quality(1);
  for (std::size_t v = 0; v < values.size(); ++v) {
    for (int k = 0; k < 3; ++k) place[std::size_t(k)] = float(shape.points()[v][k]);
    Programs::append_little_endian(text, place);
    const double share = most > 0 ? double(values[v] / most) : 0;
    for (std::uint8_t c : Programs::Rendering::encoded(Programs::Rendering::field_colours()(share))) text += char(c);
    quality[0] = values[v];
    Programs::append_little_endian(text, quality);
  }
  for (const AMF::Rest_shape::Triangle& t : shape.triangles()) {
    text += char(3);
    Programs::append_little_endian(text, std::vector<std::int32_t>(t.begin(), t.end()));
  }
  os.write(text.data(), std::streamsize(text.size()));
}

} // namespace Evaluate_features
