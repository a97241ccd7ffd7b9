// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SIMPLIFY_ANIMATION_MODEL_TEXTURE_H
#define SIMPLIFY_ANIMATION_MODEL_TEXTURE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Applications/Simplified_animation.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace Simplify_animation {

// Where the vertices of a model are in its texture. Along a seam they are in several places: the vertex of an animation is
// then made of several of the file.
class Model_texture
{
public:
  typedef std::array<double, 2> Place;

  // A level as it is drawn: a vertex of the level once for each of its places.
  struct Corners
  {
    std::vector<std::size_t> vertices; // of the level, for each vertex that is drawn
    std::vector<Place> places;         // as many
    std::vector<std::array<std::size_t, 3>> triangles;
  };

  // `origins`: which vertices of the model the vertices of the animation are made of. The vertices of parts without a
  // texture are at (0, 0).
  Model_texture(const CGAL::Animated_mesh_features::IO::Keyframed_model& model,
                const CGAL::Animated_mesh_features::IO::Vertex_origins& origins,
                const CGAL::Animated_mesh_features::Rest_shape& rest);

  // vertices of the animation that are in several places, ascending
  std::vector<std::size_t> seam_vertices() const;

  // `level`: of an animation of which the seam vertices were kept.
  Corners corners(const CGAL::Animated_mesh_features::Animation_level& level) const;

private:
  typedef CGAL::Animated_mesh_features::Rest_shape::Triangle Triangle;

  // of a vertex, the one that is nearest in the texture
  Place nearest(std::size_t vertex, const Place& to) const;

  std::vector<std::vector<Place>> m_places;              // of each vertex of the animation
  std::vector<std::array<Place, 3>> m_places_of_corners; // of each triangle of the animation
  std::vector<Triangle> m_triangles;
};

} // namespace Simplify_animation

#endif // SIMPLIFY_ANIMATION_MODEL_TEXTURE_H
