// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_PALETTE_H
#define PROGRAMS_RENDERING_PALETTE_H

#include "rendering/Colour_map.h"

namespace CGAL {
namespace Animated_mesh_features {
namespace Rendering {

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the map for fields on the surface, in every output: from 0, the colour of sand, where nothing happens and the surface
looks like clay, over green to 1, a dark petrol.

CIELAB lightness falls from 94 to 30 in even steps, so that it can be read without seeing hues, and in print. Its hues
are those which `duration_colours()` leaves free: no part of the surface is taken for a feature. Made for this package.
*/
inline const Colour_map& field_colours()
{
  static const Colour_map map({{94, 0, 10}, {78, -16, 9}, {62, -29, 0}, {46, -24, -13}, {30, -10, -20}});
  return map;
}

/*!
\ingroup PkgAnimatedMeshFeaturesRendering

the map for the temporal scale of features, in every output: from 0, the shortest, red, over purple to 1, the longest,
blue, as in the figures of the paper.

The steps are even for those who confuse red and green, too: what they see goes from yellow or brown over grey to blue.
Made for this package.
*/
inline const Colour_map& duration_colours()
{
  static const Colour_map map({{57, 65, 45}, {54, 65, 2}, {49, 52, -38}, {42, 34, -76}});
  return map;
}

} // namespace Rendering
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_RENDERING_PALETTE_H
