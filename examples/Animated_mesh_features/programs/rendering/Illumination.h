// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_ILLUMINATION_H
#define PROGRAMS_RENDERING_ILLUMINATION_H

#include "rendering/Colour.h"
#include "rendering/Depth_map.h"
#include "rendering/Lights.h"
#include "rendering/Surface.h"
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

a place that is lit.
*/
struct Shading_point
{
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< its position.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< towards the camera's side, length 1.
  Eigen::Vector3d to_eye = Eigen::Vector3d::Zero(); ///< length 1; zero: no highlights.
  double least_cosine = 0;                          ///< of a light's direction and the normal; others are left out.
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

what arrives there.
*/
struct Shading
{
  Colour diffuse = Colour::Zero();   ///< 1: as much as a surface of full brightness needs.
  Colour highlight = Colour::Zero(); ///< mirrored, to be added.
};

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

lets all lights fall on points, with the shadows that the surface casts.

Light by light, for all points: a depth map is used while it is in the cache, and forgotten. Takes
O(lights (points + triangles)) time. The result does not depend on the number of threads.

\param points where light falls
\param surface casts shadows
\param centre,radius a sphere around the surface
\param lights see `studio_lights()`
\returns for each point what arrives there
*/
inline std::vector<Shading> illuminated(const std::vector<Shading_point>& points, const Surface& surface,
                                        const Eigen::Vector3d& centre, double radius, const std::vector<Light>& lights)
{
  typedef CGAL::Parallel_if_available_tag Parallel;
  using Animated_mesh_features::parallel_for;
  const std::size_t maps_at_a_time = 8, block = 4096;
  const double shininess = 34;     // a soft highlight, as of clay
  const float reflectance = 0.04f; // of most things that are no metal
  std::vector<Shading> result(points.size());
  std::vector<std::unique_ptr<Depth_map>> maps(maps_at_a_time);
  for (std::size_t first = 0; first < lights.size(); first += maps_at_a_time) {
    const std::size_t n = (std::min)(maps_at_a_time, lights.size() - first);
    parallel_for<Parallel>(0, n, [&](std::size_t i) {
      maps[i] = std::make_unique<Depth_map>(surface, centre, radius, lights[first + i].direction);
    });
    parallel_for<Parallel>(0, (points.size() + block - 1) / block, [&](std::size_t b) {
      for (std::size_t p = b * block; p < (std::min)(points.size(), (b + 1) * block); ++p) {
        const Shading_point& s = points[p];
        for (std::size_t i = 0; i < n; ++i) {
          const Light& light = lights[first + i];
          const double cosine = s.normal.dot(light.direction);
          if (!(cosine > s.least_cosine)) continue;
          const float visibility = maps[i]->visibility(s.point, s.normal);
          if (!(visibility > 0)) continue;
          result[p].diffuse += visibility * float(cosine) * light.colour;
          if (!light.is_highlight || s.to_eye.isZero()) continue;
          // Blinn's highlights, normalised, with Schlick's approximation of what glances off
          const Eigen::Vector3d half = (light.direction + s.to_eye).normalized();
          const double grazing = 1 - (std::max)(0., half.dot(s.to_eye));
          const double fresnel = reflectance + (1 - reflectance) * std::pow(grazing, 5);
          const double lobe =
              (shininess + 8) / 8 * std::pow((std::max)(0., half.dot(s.normal)), shininess) * fresnel * cosine;
          result[p].highlight += visibility * float(lobe) * light.colour;
        }
      }
    });
  }
  return result;
}

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_ILLUMINATION_H
