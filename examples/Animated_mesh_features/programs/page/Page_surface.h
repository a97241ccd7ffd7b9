// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_PAGE_SURFACE_H
#define PROGRAMS_PAGE_PAGE_SURFACE_H

#include "scenes/Shown_scene.h"
#include "scenes/surface_shapes.h"

#include <array>
#include <cstddef>
#include <vector>

namespace Programs {

// The surface that a page shows: that of the scene, or one with fewer of its vertices.
class Page_surface
{
public:
  // A place on the page's surface: vertices of the page, and barycentric coordinates.
  struct Place
  {
    std::array<std::size_t, 3> triangle;
    std::array<double, 3> barycentric_coordinates;
  };

  // With at most so many vertices, if that can be: see thinned_triangles(). With all of them, nothing is changed.
  Page_surface(const Shown_sequence& sequence, std::size_t most_vertices);

  bool is_thinned() const { return m_is_thinned; }

  // The vertices of the scene that are left, in their order.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }

  // Of the page's vertices, which are the ranks in `vertices()`.
  const Triangles& triangles() const { return m_triangles; }

  // The nearest place to a feature, on the rest shape and in its frame. Linear in the triangles.
  Place place(const Shown_feature& feature) const;

private:
  void thin(std::size_t most_vertices);

  const Shown_sequence& m_sequence;
  std::vector<std::size_t> m_vertices;
  Triangles m_triangles;
  bool m_is_thinned = false;
};

} // namespace Programs

#endif // PROGRAMS_PAGE_PAGE_SURFACE_H
