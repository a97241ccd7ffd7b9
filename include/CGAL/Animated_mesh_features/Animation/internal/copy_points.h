// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_COPY_POINTS_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_COPY_POINTS_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/all_finite.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Whether `T` is a property map with this key. Asked before whether it is a range: some property maps, such as those of
// Surface_mesh, are ranges as well, but with an element for every removed vertex.
template <class T, class Key, class = void>
struct Is_point_map : std::false_type
{
};
template <class T, class Key>
struct Is_point_map<T, Key, std::void_t<decltype(get(std::declval<const T&>(), std::declval<Key>()))>> : std::true_type
{
};

// Writes the coordinates vertex by vertex: of a property map, or of a range in the order of the vertices. `name` is for
// messages.
template <class Points, class Vertex, class Scalar>
void copy_points(const Points& points, const std::vector<Vertex>& vertices, const std::string& name, Scalar* xyz)
{
  const auto insert = [&](std::size_t v, const auto& point) {
    Scalar* const p = xyz + 3 * v;
    p[0] = Scalar(CGAL::to_double(point.x()));
    p[1] = Scalar(CGAL::to_double(point.y()));
    p[2] = Scalar(CGAL::to_double(point.z()));
    if (!all_finite(p, 3))
      throw Input_error(name + ": the position of vertex " + std::to_string(v) + " is not finite");
  };
  if constexpr (Is_point_map<Points, Vertex>::value) {
    for (std::size_t v = 0; v < vertices.size(); ++v) insert(v, get(points, vertices[v]));
  } else {
    const std::size_t n = std::size_t(std::distance(std::begin(points), std::end(points)));
    if (n != vertices.size())
      throw Input_error(name + " has " + std::to_string(n) + " points, the mesh has " +
                        std::to_string(vertices.size()) + " vertices");
    std::size_t v = 0;
    for (const auto& p : points) insert(v++, p);
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_INTERNAL_COPY_POINTS_H
