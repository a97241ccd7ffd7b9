// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "views/View_choice.h"

namespace Programs {

Names<View_kind> names(View_kind)
{
  return {{"auto", View_kind::AUTO},    {"front", View_kind::FRONT}, {"back", View_kind::BACK},
          {"left", View_kind::LEFT},    {"right", View_kind::RIGHT}, {"top", View_kind::TOP},
          {"bottom", View_kind::BOTTOM}};
}

CGAL::Animated_mesh_features::View_angles told_angles(const View_choice& view, int up_axis)
{
  const double front = up_axis == 2 ? -90 : 0;
  const double steep = 89; // an upright camera cannot look straight down
  switch (view.kind) {
  case View_kind::BACK:
    return {front + 180, 0};
  case View_kind::LEFT:
    return {front + 90, 0};
  case View_kind::RIGHT:
    return {front - 90, 0};
  case View_kind::TOP:
    return {front, steep};
  case View_kind::BOTTOM:
    return {front, -steep};
  case View_kind::ANGLES:
    return {view.azimuth, view.elevation};
  case View_kind::AUTO:
  case View_kind::FRONT:
    break;
  }
  return {front, 0};
}

} // namespace Programs
