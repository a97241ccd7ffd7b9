// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EXTREMA_EXTREMUM_SEARCH_H
#define CGAL_ANIMATED_MESH_FEATURES_EXTREMA_EXTREMUM_SEARCH_H

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesExtrema

The responses at one vertex around a sample: at its own and the neighbouring space levels, time levels and frames.

\tparam FT the scalar of the response.
*/
template <class FT>
class Response_window
{
public:
  /// \cond SKIP_IN_MANUAL
  Response_window(const FT* below, const FT* same, const FT* above, std::ptrdiff_t time_level_stride)
    : m_rows{below, same, above}
    , m_stride(time_level_stride)
  {
  }
  /// \endcond

  /// the response `dk` space levels, `dl` time levels and `df` frames away, each -1, 0 or 1.
  FT operator()(int dk, int dl, int df) const { return m_rows[dk + 1][dl * m_stride + df]; }

private:
  const FT* m_rows[3];
  std::ptrdiff_t m_stride;
};

/*!
\ingroup PkgAnimatedMeshFeaturesExtrema

Strict local minima of a negative response; a model of `ExtremumSearch`.

A sample is a minimum if it is below zero, below the samples of its vertex in the frame before and the frame after it,
below the same sample at the 8 neighbouring scales, and below every sample of the one-ring in those three frames at its
own scale. Equal samples in time or scale are no minima, so that a flat region has none.

With `join_equal`, of equal samples that are neighbours on the surface the one whose point on the rest shape has the
smaller coordinates counts as lower; and minima of the same space level, at most one time level and one frame apart, are
one if a path of vertices joins them whose responses, at scale and frame of the stronger one, are above 95 % of it. The
strongest is kept, of minima that are equal to a millionth the one with the smaller coordinates. So a tube that swells all
around by the same amount has one extremum, wherever rounding finds the strongest one, whatever the numbers of its vertices.

\cgalModels{ExtremumSearch}
*/
struct Difference_of_gaussians_minima
{
  /// `at_vertex()` accepts nothing but strict minima below zero, over time and over scales: what the search in vector
  /// registers looks for.
  static constexpr bool strict_minima = true;

  /// whether nearly equal minima that are joined by a path of nearly equal response are one, and of equal neighbours one is a
  /// minimum, see above; the paper knows of neither.
  bool join_equal = true;

  /// whether the sample in the middle of the window may be an extremum, by what its own vertex knows.
  template <class FT>
  bool at_vertex(const Response_window<FT>& d) const
  {
    const FT centre = d(0, 0, 0);
    if (!(centre < 0) || !(centre < d(0, 0, -1)) || !(centre < d(0, 0, 1))) return false;
    for (int dk = -1; dk <= 1; ++dk)
      for (int dl = -1; dl <= 1; ++dl)
        if ((dk != 0 || dl != 0) && !(centre < d(dk, dl, 0))) return false;
    return true;
  }

  /// whether it still may, given the responses at one neighbour in the frame before, the same frame and the frame
  /// after it.
  template <class FT>
  bool at_neighbour(FT centre, FT before, FT same, FT after) const
  {
    return centre < before && centre < same && centre < after;
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EXTREMA_EXTREMUM_SEARCH_H
