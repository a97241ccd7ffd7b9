// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ENTROPY_VIEW_SCORE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ENTROPY_VIEW_SCORE_H

#include <CGAL/Animated_mesh_features/Applications/Area_view_score.h>
#include <CGAL/Animated_mesh_features/Applications/Surface_view.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

Scores a view by its entropy (P.-P. Vázquez, M. Feixas, M. Sbert, W. Heidrich, <em>Viewpoint selection using viewpoint
entropy</em>, 2001): \f$-\sum_i a_i \log a_i\f$ over the triangles and the background, where \f$a_i\f$ is the part of the
image, here the disc that a sphere around the body fills, in which the triangle is seen; divided by the logarithm of their
number, and averaged over the frames. It is large where many triangles are seen about equally large, and depends on how the
surface is cut into triangles. It knows nothing of what moves; a baseline. Linear time for each view.

\cgalModels{ViewScore}
*/
class Entropy_view_score
{
public:
  /// looks at so many frames.
  explicit Entropy_view_score(std::size_t number_of_frames)
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
    const std::size_t n = view.shape().triangles().size();
    double entropy = 0, sum = 0;
    const auto add = [&](double a) {
      if (a > 0) entropy -= a * std::log(a);
    };
    for (std::size_t t = 0; t < n; ++t) {
      const double a = internal::visible_area(view, t);
      sum += a;
      add(a);
    }
    add(1 - sum);
    *seen = float(entropy / std::log(double(n + 1)));
  }

private:
  std::size_t m_number_of_frames;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_ENTROPY_VIEW_SCORE_H
