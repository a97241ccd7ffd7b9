// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Illumination.h"

#include "rendering/Depth_map.h"
#include "running/Interruption.h"

#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

namespace Programs::Rendering {

namespace {

double to_34(double x)
{
  const double x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
  return x16 * x16 * x2;
}

} // namespace

std::vector<Shading> illuminated(const std::vector<Shading_point>& points, const Surface& surface,
                                 const Eigen::Vector3d& centre, double radius, const std::vector<Light>& lights,
                                 std::size_t map_size)
{
  typedef CGAL::Parallel_if_available_tag Parallel;
  using CGAL::Animated_mesh_features::parallel_for;
  constexpr std::size_t maps_at_a_time = 8, block = 512;
  const double shininess = 34; // a soft highlight, as of clay; see to_34()
  const float reflectance = 0.04f; // of most things that are no metal
  std::vector<Shading> result(points.size());
  std::vector<std::unique_ptr<Depth_map>> maps(maps_at_a_time);
  for (std::size_t first = 0; first < lights.size(); first += maps_at_a_time) {
    const std::size_t n = (std::min)(maps_at_a_time, lights.size() - first);
    parallel_for<Parallel>(0, n, [&](std::size_t i) {
      Interruption::check();
      maps[i] = std::make_unique<Depth_map>(surface, centre, radius, lights[first + i].direction, map_size);
    });
    // Light by light also within a block: neighbours on the image see a light alike, and look into the same part of its map.
    parallel_for<Parallel>(0, (points.size() + block - 1) / block, [&](std::size_t b) {
      Interruption::check();
      const std::size_t begin = b * block, end = (std::min)(points.size(), begin + block);
      std::array<Eigen::Vector3f, block> lifted;
      for (std::size_t p = begin; p < end; ++p)
        lifted[p - begin] = maps.front()->lifted(points[p].point, points[p].normal);
      for (std::size_t i = 0; i < n; ++i) {
        const Light& light = lights[first + i];
        for (std::size_t p = begin; p < end; ++p) {
          const Shading_point& s = points[p];
          const double cosine = s.normal.dot(light.direction);
          if (!(cosine > s.least_cosine)) continue;
          const float visibility = maps[i]->visibility(lifted[p - begin]);
          if (!(visibility > 0)) continue;
          result[p].diffuse += visibility * float(cosine) * light.colour;
          if (!light.is_highlight || s.to_eye.isZero()) continue;
          // Blinn's highlights, normalised, with Schlick's approximation of what glances off
          const Eigen::Vector3d between = light.direction + s.to_eye;
          const double length = between.norm();
          const double mirrored = between.dot(s.normal);
          if (!(mirrored > 0.75 * length)) continue; // to the power of the shininess, below 1e-4
          const double grazing = 1 - (std::max)(0., between.dot(s.to_eye) / length);
          const double fresnel = reflectance + (1 - reflectance) * grazing * grazing * grazing * grazing * grazing;
          const double lobe = (shininess + 8) / 8 * to_34(mirrored / length) * fresnel * cosine;
          result[p].highlight += visibility * float(lobe) * light.colour;
        }
      }
    });
  }
  return result;
}

} // namespace Programs::Rendering
