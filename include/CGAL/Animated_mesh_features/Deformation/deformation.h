// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

The weight \f$\alpha\f$ of the change of curvature against strain, as in the paper \cgalCite{mykhalchuk2014}.
*/
constexpr double default_curvature_weight = 7;

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

adds up the deformation \f$d(v,f) = \mathrm{strain}(v,f) + \alpha\,|\kappa(v,f) - \kappa(v,\mathrm{rest})|\f$.

\param strain `N x F`, see `strain()`.
\param curvature_change `N x F`, see `curvature_change()`.
\param alpha the weight of the change of curvature.
\returns a field of `N x F`.
\throw Option_error if the fields differ in shape.
*/
template <class FT>
Spatio_temporal_field<FT> deformation(const Spatio_temporal_field<FT>& strain,
                                      const Spatio_temporal_field<FT>& curvature_change,
                                      double alpha = default_curvature_weight)
{
  if (strain.number_of_rows() != curvature_change.number_of_rows() ||
      strain.number_of_frames() != curvature_change.number_of_frames())
    throw Option_error("strain and change of curvature have different numbers of vertices or frames");
  Spatio_temporal_field<FT> field(strain.number_of_rows(), strain.number_of_frames(), strain.memory());
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      field(v, f) = strain(v, f) + FT(alpha) * curvature_change(v, f);
  return field;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_H
