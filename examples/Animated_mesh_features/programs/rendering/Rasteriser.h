// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RENDERING_RASTERISER_H
#define PROGRAMS_RENDERING_RASTERISER_H

#include "rendering/Camera.h"
#include "rendering/Surface.h"
#include "rendering/Triangle_scan.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Programs::Rendering {

constexpr long samples_per_side = 4; // of a pixel
constexpr long samples_per_pixel = samples_per_side * samples_per_side;

// The place of a sample in its pixel, 0 to 1. Samples are counted row by row.
inline Eigen::Array2d sample_offset(long sample)
{
  return Eigen::Array2d(double(sample % samples_per_side) + 0.5, double(sample / samples_per_side) + 0.5) /
         double(samples_per_side);
}

// A triangle that is the nearest one at some samples of a pixel.
struct Fragment
{
  std::uint32_t triangle = 0; // rank in `Surface::triangles`
  std::uint16_t samples = 0;  // bit `i` is sample `i`
};
static_assert(samples_per_pixel <= 16, "a bit for each sample");

// What a camera sees of a surface: for each pixel the triangles that are nearest at its samples. Hidden parts are found
// by a z-buffer with the reciprocal of the distance, which is linear on the image of a triangle. Triangles that reach
// behind the camera are left out; a `fitted_camera()` has none.
//
// Takes O(samples + triangles) time. The result does not depend on the number of threads.
class Visible_surface
{
public:
  // looks at a surface, which is not kept; the image has the size of the camera's
  Visible_surface(const Surface& surface, const Camera& camera);

  std::size_t width() const { return m_width; }   // pixels
  std::size_t height() const { return m_height; } // pixels

  // Those of pixel `(x, y)` are `fragments()[i]` for `i` from `first(x, y)` to before `first(x + 1, y)`.
  const std::vector<Fragment>& fragments() const { return m_fragments; }

  // where the fragments of a pixel begin; `x` may be `width()`
  std::size_t first(std::size_t x, std::size_t y) const { return m_starts[y * m_width + x]; }

  // a triangle on the image; its `value()` is the reciprocal of the distance along the view direction
  Triangle_scan image(std::size_t triangle) const
  {
    const Surface::Triangle& t = m_triangles[triangle];
    return Triangle_scan(m_projected[t[0]], m_projected[t[1]], m_projected[t[2]]);
  }

  // barycentric coordinates on the surface, not on the image, of what is seen of a triangle at a place of the image
  Eigen::Array3d coordinates(std::size_t triangle, double x, double y) const;

private:
  void project(const Surface& surface, const Camera& camera);
  std::vector<std::vector<std::uint32_t>> sorted_in_bands(std::size_t bands) const;
  std::vector<Fragment> fragments_of_band(std::size_t band, const std::vector<std::uint32_t>& triangles);

  std::size_t m_width, m_height;
  std::vector<Eigen::Vector3d> m_projected; // x, y, reciprocal of the distance
  std::vector<Surface::Triangle> m_triangles;
  std::vector<Fragment> m_fragments;
  std::vector<std::size_t> m_starts;
};

} // namespace Programs::Rendering

#endif // PROGRAMS_RENDERING_RASTERISER_H
