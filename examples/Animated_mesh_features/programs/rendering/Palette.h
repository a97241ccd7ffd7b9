// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_PALETTE_H
#define PROGRAMS_RENDERING_PALETTE_H

#include "rendering/Colour_map.h"

namespace Programs::Rendering {

// The map for fields on the surface, in every output: from 0, the colour of sand, where nothing happens and the surface
// looks like clay, over green to 1, a dark petrol.
//
// CIELAB lightness falls from 94 to 30 in even steps, so that it can be read without seeing hues, and in print. Its hues
// are those which `duration_colours()` leaves free: no part of the surface is taken for a feature. Made for this package.
const Colour_map& field_colours();

// The map for the temporal scale of features, in every output: from 0, the shortest, red, over purple to 1, the longest,
// blue, as in the figures of the paper.
//
// The steps are even for those who confuse red and green, too: what they see goes from yellow or brown over grey to blue.
// Made for this package.
const Colour_map& duration_colours();

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_PALETTE_H
