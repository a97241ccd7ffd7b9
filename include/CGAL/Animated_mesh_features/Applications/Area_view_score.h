// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_AREA_VIEW_SCORE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_AREA_VIEW_SCORE_H

#include <CGAL/Animated_mesh_features/Applications/Surface_view.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// The area of the image of a triangle that is not hidden, in parts of a sphere's around the body.
inline double visible_area(const Surface_view& view, std::size_t t)
{
  const Rest_shape::Triangle& c = view.shape().triangles()[t];
  const double area = view.projected_area(t) / (double(EIGEN_PI) * view.radius() * view.radius());
  return area > 0 ? area * (view.visibility(c[0]) + view.visibility(c[1]) + view.visibility(c[2])) / 3 : 0;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesViews

Scores a view by how large the body is in the image: the area that is seen, as a part of that of a sphere around the body,
averaged over the frames. It knows nothing of what moves; a baseline. Linear time for each view.

\cgalModels{ViewScore}
*/
class Area_view_score
{
public:
  /// looks at so many frames.
  explicit Area_view_score(std::size_t number_of_frames)
    : m_number_of_frames(number_of_frames)
  {}

  /// the frames that are looked at.
  std::size_t number_of_frames() const { return m_number_of_frames; }

  /// one item for each frame.
  std::size_t first_item(std::size_t k) const { return k; }

  /// the same for all.
  double weight(std::size_t) const { return 1; }

  /// from 0 to 1.
  void operator()(const Surface_view& view, float* seen) const
  {
    double sum = 0;
    for (std::size_t t = 0; t < view.shape().triangles().size(); ++t) sum += internal::visible_area(view, t);
    *seen = float(sum < 1 ? sum : 1);
  }

private:
  std::size_t m_number_of_frames;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_AREA_VIEW_SCORE_H
