// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_WRITE_HTML_H
#define PROGRAMS_PAGE_WRITE_HTML_H

#include "page/Html_options.h"
#include "scenes/Shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace Programs {

// What write_html() did.
struct Html_report
{
  std::size_t vertices = 0;   // so many vertices are in the page
  std::size_t frame_step = 1; // every so many frames are in the page
  double largest_error = 0;   // no vertex is farther from where it was, in bounding-box diagonals of the rest shape
};

// Writes a scene as one HTML file that shows it in a browser, without a network and without a server: the moving surface
// with its features and fields, to be turned, played and searched.
//
// The file is `page`, the viewer, with the scene in it. `detect_features --html` has the viewer built in; it is installed
// as `share/Animated_mesh_features/viewer.html`.
//
// The scene is kept small: 2.2 bytes for a vertex and a frame, and 0.6 for each field, on a galloping horse.
// - Positions are rounded to a grid of 2^16 steps along the longest side of the largest frame's bounding box; no vertex
//   moves by more than sqrt(3) / 2 steps, at most 1.4e-5 of that side. The page says how much it is.
// - The rest shape, along whose edges the page measures a brush, is rounded likewise, to a grid of its own; where it is in
//   space is not kept.
// - Fields are rounded to 224 values between the smallest and the 99.5th percentile, at which colours end, and to 32 above.
// - All are written as differences from what a neighbour's motion predicts, in byte planes, deflated, as base64.
// - Features are written as IO::write_json() does; "cyclic" is there, and true, if they live on across the end.
// - "view" tells where the page opens: what points up, and the direction to the camera; null if that is left to the page.
//
// A scene of more vertices times frames than `Html_options::most_positions` is thinned out, see html_sampling(). In space:
// the page has a surface with fewer of the vertices, see thinned_triangles(), their numbers in the scene (`scene-vertices`,
// differences), and, for each feature, the nearest place on it (`places`); features themselves are those of the scene. In
// time: every k-th frame and the last one are kept, the page is linear between them.
//
// To a binary stream; its errors are left in its state, `Output_file` reports them. Independent of its locale.
// throws what check_scene() does if the scene does not fit together; Option_error if it is too large, see
// html_sampling(), or if `page` is not the viewer.
//
// Time: linear in the number of vertices times frames, about 0.25 s for each million.
Html_report write_html(std::ostream& os, const Shown_scene& scene, std::string_view page,
                       const Html_options& options = Html_options());

// The same of two animations, side by side: `b` is shown at the time that is aligned with that of `a`, from the same side,
// and features that are a pair have one colour and one number.
//
// The page has the scripts of both scenes, those of `b` with ids that begin with `scene-b`, and `comparison`, which is
// what `compare_animations --output` writes of a pair: of that, it reads `distance`; `alignment` with `times_a`, `times_b`,
// `loops`, their periods or 0, and `confidence`; and of each of `matches` the ranks `a` and `b`, which are those of the scenes' features, from 0.
//
// Each scene has half of the room, see html_sampling(). returns what it did with the first and with the second one.
// throws as above.
std::array<Html_report, 2> write_html_pair(std::ostream& os, const Shown_scene& a, const Shown_scene& b,
                                           const nlohmann::ordered_json& comparison, std::string_view page,
                                           const Html_options& options = Html_options());

} // namespace Programs

#endif // PROGRAMS_PAGE_WRITE_HTML_H
