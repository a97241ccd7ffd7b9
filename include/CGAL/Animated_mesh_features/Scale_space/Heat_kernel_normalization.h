// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_KERNEL_NORMALIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_KERNEL_NORMALIZATION_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Scale_space/Heat_diffusion_filter.h>

#include <cmath>
#include <fstream>
#include <string>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {


struct Heat_kernel_normalization
{
  std::size_t columns = 256; std::string cache;

  template <class Loop>
  std::vector<float> operator()(const Rest_shape& shape, const std::vector<double>& variances, const Loop& loop) const
  {
    const std::size_t n = shape.number_of_vertices(), levels = variances.size();
    if (!cache.empty()) { std::ifstream is(cache, std::ios::binary); if (is) { std::vector<float> r(n * levels); is.read((char*)r.data(), 4 * r.size()); return r; } }
    std::vector<double> mass(n, 0);
    for (const auto& t : shape.triangles()) {
      const double a = (shape.points()[t[1]] - shape.points()[t[0]]).cross(shape.points()[t[2]] - shape.points()[t[0]]).norm() / 6;
      for (int i = 0; i < 3; ++i) mass[t[i]] += a;
    }
    std::vector<double> half;
    for (double s : variances) half.push_back(s / 2);
    Heat_diffusion_filter filter;
    filter.initialize(shape, half, loop);
    Spatio_temporal_field<double> in(n, columns), out(n, columns);
    std::mt19937 random(1);
    for (std::size_t v = 0; v < n; ++v)
      for (std::size_t c = 0; c < columns; ++c)
        in(v, c) = mass[v] > 0 ? (random() & 1 ? 1 : -1) / std::sqrt(mass[v]) : 0;
    std::vector<float> result(n * levels, 1);
    for (std::size_t k = 0; k < levels; ++k) {
      filter(k, in, out, loop);
      in.swap(out);
      if (variances[k] == 0) continue;
      for (std::size_t v = 0; v < n; ++v) {
        double sum = 0;
        for (std::size_t c = 0; c < columns; ++c) sum += in(v, c) * in(v, c);
        const double h = sum / double(columns); // 1 / (2 pi sigma^2) in the plane
        result[v * levels + k] = float(1 / std::sqrt(2 * 3.14159265358979323846 * variances[k] * h));
      }
    }
    if (!cache.empty()) { std::ofstream os(cache, std::ios::binary); os.write((char*)result.data(), 4 * result.size()); }
    return result;
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_KERNEL_NORMALIZATION_H
