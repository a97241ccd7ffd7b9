// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_PROBABLE_UP_AXIS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_PROBABLE_UP_AXIS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// Where the weight of a body is, of the same density everywhere inside of its surface; of a sheet, which has no inside, and
// of a surface that is not oriented, of the same density everywhere on it. Each triangle stands for the tetrahedron that
// it makes with the centre of the surface: small holes matter little.
inline Eigen::Vector3d centre_of_mass(const Rest_shape& shape)
{
  const auto& p = shape.points();
  const auto normal = [&](const Rest_shape::Triangle& t) { return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]); };
  Eigen::Vector3d surface = Eigen::Vector3d::Zero(), inside = surface;
  Eigen::AlignedBox3d box;
  double area = 0, volume = 0;
  for (const Rest_shape::Triangle& t : shape.triangles()) {
    const double a = normal(t).norm() / 2;
    surface += a / 3 * (p[t[0]] + p[t[1]] + p[t[2]]);
    area += a;
    for (std::size_t k = 0; k < 3; ++k) box.extend(p[t[k]]);
  }
  if (!(area > 0)) return surface;
  surface /= area;
  for (const Rest_shape::Triangle& t : shape.triangles()) {
    const Eigen::Vector3d a = p[t[0]] - surface, b = p[t[1]] - surface, c = p[t[2]] - surface;
    const double v = normal(t).dot(a) / 6;
    inside += v / 4 * (a + b + c);
    volume += v;
  }
  const double sheet = 0.01; // of the volume of a ball of the same area
  if (!(std::abs(volume) > sheet * std::pow(area, 1.5) / (6 * std::sqrt(double(EIGEN_PI))))) return surface;
  const Eigen::Vector3d centre = surface + inside / volume;
  return box.contains(centre) ? centre : surface;
}

// How well a body stands if this axis points up. Its lowest points are its feet; the centre of mass is above the rectangle
// around them, at this part of its half width from the nearest side; negative for what topples. That, times how high the
// centre is, as a part of the height: feet carry what is above them, and what lies has its weight below.
inline double standing(const Rest_shape& shape, const Eigen::Vector3d& centre, int axis)
{
  const double lowest_part = 0.06; // of the height: feet
  const std::vector<Rest_shape::Index>& vertices = shape.measured_vertices();
  Eigen::AlignedBox3d box, feet;
  for (Rest_shape::Index v : vertices) box.extend(shape.points()[v]);
  const double low = box.min()[axis], height = box.sizes()[axis];
  for (Rest_shape::Index v : vertices)
    if (shape.points()[v][axis] <= low + lowest_part * height) feet.extend(shape.points()[v]);
  double stability = 1;
  for (int i : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double half_width = box.sizes()[i] / 2;
    if (!(half_width > 0)) continue;
    stability = (std::min)(stability, (std::min)(centre[i] - feet.min()[i], feet.max()[i] - centre[i]) / half_width);
  }
  return stability > 0 && height > 0 ? stability * (centre[axis] - low) / height : stability;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

the axis that probably points up, `y` (1) or `z` (2): the one on which the body stands better, with its centre of mass well
above its feet, and `y` if there is no clear difference. Files do not tell; animals and people at rest are told well, what
does not stand is not.
\param shape the body at rest. Linear time.
*/
inline int probable_up_axis(const Rest_shape& shape)
{
  const double clear_difference = 0.05;
  const Eigen::Vector3d centre = internal::centre_of_mass(shape);
  return internal::standing(shape, centre, 2) > internal::standing(shape, centre, 1) + clear_difference ? 2 : 1;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_PROBABLE_UP_AXIS_H
