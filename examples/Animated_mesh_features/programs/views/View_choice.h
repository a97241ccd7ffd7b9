// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_VIEWS_VIEW_CHOICE_H
#define PROGRAMS_VIEWS_VIEW_CHOICE_H

#include "options/Names.h"

#include <CGAL/Animated_mesh_features/Applications/View_angles.h>

namespace Programs {

enum class View_kind
{
  AUTO,
  FRONT,
  BACK,
  LEFT,
  RIGHT,
  TOP,
  BOTTOM,
  ANGLES
};

// Those that have a name: all but ANGLES.
Names<View_kind> names(View_kind);

// Where pictures are taken from, as users say it.
struct View_choice
{
  View_kind kind = View_kind::AUTO;  // from where the features are seen
  double azimuth = 0, elevation = 0; // degrees, of ANGLES; see view_angles()
};

// The angles of a view that is told, not AUTO. The front is seen from +z if y points up and from -y if z does, as programs
// for modelling have it; left and right are the body's own.
CGAL::Animated_mesh_features::View_angles told_angles(const View_choice& view, int up_axis);

} // namespace Programs

#endif // PROGRAMS_VIEWS_VIEW_CHOICE_H
