// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/Model_texture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;
namespace IO = CGAL::Animated_mesh_features::IO;

namespace Simplify_animation {

namespace {

typedef Model_texture::Place Place;
typedef AMF::Rest_shape::Index Index;

// of each vertex of the file, counted through all parts
std::vector<Place> places_in_file(const IO::Keyframed_model& model)
{
  std::vector<Place> places;
  for (const IO::Keyframed_model::Part& part : model.parts) {
    const IO::Keyframed_model::Geometry& geometry = model.geometries[part.geometry];
    if (geometry.texture_coordinates.empty())
      places.resize(places.size() + geometry.points.size(), Place{{0, 0}});
    else
      places.insert(places.end(), geometry.texture_coordinates.begin(), geometry.texture_coordinates.end());
  }
  return places;
}

// the vertex of the animation that each vertex of the file has become
std::vector<Index> vertices_of_file(const IO::Vertex_origins& origins, std::size_t vertices, std::size_t in_file)
{
  std::vector<Index> result(in_file, AMF::Rest_shape::none);
  for (std::size_t v = 0; v < vertices; ++v)
    for (std::size_t i : origins.of(v)) result[i] = Index(v);
  return result;
}

// so that the least of its corners comes first
template <class Corners>
std::size_t first_corner(const Corners& t)
{
  return std::size_t(std::min_element(t.begin(), t.end()) - t.begin());
}

} // namespace

Model_texture::Model_texture(const IO::Keyframed_model& model, const IO::Vertex_origins& origins,
                             const AMF::Rest_shape& rest)
  : m_places(rest.number_of_vertices())
  , m_triangles(rest.triangles())
{
  const std::vector<Place> in_file = places_in_file(model);
  for (std::size_t v = 0; v < m_places.size(); ++v)
    for (std::size_t i : origins.of(v))
      if (std::find(m_places[v].begin(), m_places[v].end(), in_file[i]) == m_places[v].end())
        m_places[v].push_back(in_file[i]);
  const std::vector<Index> vertex_of = vertices_of_file(origins, m_places.size(), in_file.size());
  std::map<Triangle, std::array<Place, 3>> corners; // by the triangle whose least corner comes first
  std::size_t first = 0;
  for (const IO::Keyframed_model::Part& part : model.parts) {
    const IO::Keyframed_model::Geometry& geometry = model.geometries[part.geometry];
    for (const std::array<std::size_t, 3>& t : geometry.triangles) {
      const Triangle all = {{vertex_of[first + t[0]], vertex_of[first + t[1]], vertex_of[first + t[2]]}};
      const std::size_t k = first_corner(all);
      const auto place = [&](std::size_t i) { return in_file[first + t[(k + i) % 3]]; };
      corners.emplace(Triangle{{all[k], all[(k + 1) % 3], all[(k + 2) % 3]}},
                      std::array<Place, 3>{{place(0), place(1), place(2)}});
    }
    first += geometry.points.size();
  }
  for (const Triangle& t : m_triangles) {
    const std::size_t k = first_corner(t);
    const auto found = corners.find(Triangle{{t[k], t[(k + 1) % 3], t[(k + 2) % 3]}});
    std::array<Place, 3> places;
    for (std::size_t i = 0; i < 3; ++i) // a triangle that reading has made has its vertices' first places
      places[(k + i) % 3] = found != corners.end() ? found->second[i] : m_places[t[(k + i) % 3]].front();
    m_places_of_corners.push_back(places);
  }
}

std::vector<std::size_t> Model_texture::seam_vertices() const
{
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < m_places.size(); ++v)
    if (m_places[v].size() > 1) result.push_back(v);
  return result;
}

Model_texture::Place Model_texture::nearest(std::size_t vertex, const Place& to) const
{
  const auto distance = [&](const Place& p) { return std::hypot(p[0] - to[0], p[1] - to[1]); };
  return *std::min_element(m_places[vertex].begin(), m_places[vertex].end(),
                           [&](const Place& p, const Place& q) { return distance(p) < distance(q); });
}

// A corner of a coarse triangle is as far in the texture from the corner of the original's triangle as what it has taken
// in: on the same side of a seam, which nothing has crossed. So each vertex that it follows is taken where it is nearest
// to that corner.
Model_texture::Corners Model_texture::corners(const AMF::Animation_level& level) const
{
  Corners result;
  std::map<std::pair<std::size_t, Place>, std::size_t> numbers;
  for (std::size_t t = 0; t < level.triangles.size(); ++t) {
    const std::size_t original = level.triangle_of[t];
    std::array<std::size_t, 3> triangle;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = level.triangles[t][c];
      Place hint = {{0, 0}};
      for (std::size_t i = 0; i < 3; ++i)
        if (level.vertex_of[m_triangles[original][i]] == v) hint = m_places_of_corners[original][i];
      Place place = {{0, 0}};
      const auto row = level.binding.vertices(v);
      for (std::size_t i = 0; i < std::size_t(row.size()); ++i) {
        const Place there = nearest(row[std::ptrdiff_t(i)], hint);
        for (std::size_t k = 0; k < 2; ++k) place[k] += level.binding.weights(v)[std::ptrdiff_t(i)] * there[k];
      }
      const auto added = numbers.emplace(std::make_pair(v, place), result.vertices.size());
      if (added.second) {
        result.vertices.push_back(v);
        result.places.push_back(place);
      }
      triangle[c] = added.first->second;
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

} // namespace Simplify_animation
