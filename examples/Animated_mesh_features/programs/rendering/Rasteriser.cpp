// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rendering/Rasteriser.h"

#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>

namespace Programs::Rendering {

namespace {

constexpr std::size_t band_height = 16; // pixels: two threads share few bands, and a band fits a cache
constexpr std::uint32_t none = std::uint32_t(-1);

} // namespace

Visible_surface::Visible_surface(const Surface& surface, const Camera& camera)
  : m_width(std::size_t(camera.width))
  , m_height(std::size_t(camera.height))
{
  project(surface, camera);
  const std::size_t bands = (m_height + band_height - 1) / band_height;
  const std::vector<std::vector<std::uint32_t>> triangles_of_bands = sorted_in_bands(bands);
  std::vector<std::vector<Fragment>> fragments(bands);
  m_starts.assign(m_width * m_height + 1, 0);
  CGAL::Animated_mesh_features::parallel_for<CGAL::Parallel_if_available_tag>(
      0, bands, [&](std::size_t band) { fragments[band] = fragments_of_band(band, triangles_of_bands[band]); });
  for (std::size_t i = 0; i < m_width * m_height; ++i) m_starts[i + 1] += m_starts[i];
  m_fragments.reserve(m_starts.back());
  for (const auto& f : fragments) m_fragments.insert(m_fragments.end(), f.begin(), f.end());
}

Eigen::Array3d Visible_surface::coordinates(std::size_t triangle, double x, double y) const
{
  const Surface::Triangle& t = m_triangles[triangle];
  Eigen::Array3d b = image(triangle).coordinates(x, y);
  for (int i = 0; i < 3; ++i) b[i] *= m_projected[t[std::size_t(i)]][2];
  return b / b.sum();
}

void Visible_surface::project(const Surface& surface, const Camera& camera)
{
  m_projected.resize(surface.points.size());
  std::vector<char> is_in_front(surface.points.size());
  for (std::size_t v = 0; v < m_projected.size(); ++v) {
    Eigen::Vector3d p = camera.project(surface.points[v]);
    is_in_front[v] = p[2] > 0;
    p[2] = 1 / p[2];
    m_projected[v] = p;
  }
  for (const Surface::Triangle& t : surface.triangles)
    m_triangles.push_back(is_in_front[t[0]] && is_in_front[t[1]] && is_in_front[t[2]]
                              ? t
                              : Surface::Triangle{{t[0], t[0], t[0]}}); // keeps its number, covers nothing
}

std::vector<std::vector<std::uint32_t>> Visible_surface::sorted_in_bands(std::size_t bands) const
{
  std::vector<std::vector<std::uint32_t>> result(bands);
  for (std::size_t i = 0; i < m_triangles.size(); ++i) {
    const Surface::Triangle& t = m_triangles[i];
    if (t[0] == t[1]) continue;
    const auto ys = std::minmax({m_projected[t[0]][1], m_projected[t[1]][1], m_projected[t[2]][1]});
    if (!(ys.second >= 0 && ys.first < double(m_height))) continue;
    const std::size_t first = std::size_t((std::max)(0., ys.first)) / band_height;
    const std::size_t last = std::size_t((std::min)(double(m_height - 1), ys.second)) / band_height;
    for (std::size_t b = first; b <= last; ++b) result[b].push_back(std::uint32_t(i));
  }
  return result;
}

// Tells the number of fragments of each pixel on the way.
std::vector<Fragment> Visible_surface::fragments_of_band(std::size_t band, const std::vector<std::uint32_t>& triangles)
{
  const long first_row = long(band * band_height), last_row = long((std::min)(m_height, (band + 1) * band_height));
  const long row_length = long(m_width) * samples_per_side;
  const std::size_t rows = std::size_t((last_row - first_row) * samples_per_side);
  std::vector<Fragment> result;
  if (triangles.empty()) return result;
  std::vector<float> depth(rows * std::size_t(row_length), 0); // reciprocal: 0 is infinitely far
  std::vector<std::uint32_t> nearest(depth.size(), none);
  for (std::uint32_t t : triangles)
    image(t)(1. / samples_per_side, 0, row_length, first_row * samples_per_side, last_row * samples_per_side,
             [&](long x, long y, double z) {
               const std::size_t i = std::size_t((y - first_row * samples_per_side) * row_length + x);
               if (float(z) > depth[i]) depth[i] = float(z), nearest[i] = t;
             });
  for (long y = first_row; y < last_row; ++y)
    for (long x = 0; x < long(m_width); ++x) {
      const std::size_t before = result.size();
      for (long s = 0; s < samples_per_pixel; ++s) {
        const long sx = x * samples_per_side + s % samples_per_side;
        const long sy = (y - first_row) * samples_per_side + s / samples_per_side;
        const std::uint32_t t = nearest[std::size_t(sy * row_length + sx)];
        if (t == none) continue;
        const auto same = std::find_if(result.begin() + std::ptrdiff_t(before), result.end(),
                                       [t](const Fragment& f) { return f.triangle == t; });
        if (same == result.end())
          result.push_back({t, std::uint16_t(1u << s)});
        else
          same->samples = std::uint16_t(same->samples | 1u << s);
      }
      m_starts[std::size_t(y) * m_width + std::size_t(x) + 1] = result.size() - before;
    }
  return result;
}

} // namespace Programs::Rendering
