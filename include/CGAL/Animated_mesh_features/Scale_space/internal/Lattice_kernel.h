// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_LATTICE_KERNEL_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_LATTICE_KERNEL_H

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What a plane has as a mesh: 4 pi F of the lattice of equilateral triangles, F = t times the diagonal of (M + t L)^-1, as
// a function of x = t / m with the area m of a vertex. A continuous plane has the logarithm of t and a constant; waves as
// short as an edge are slower on a mesh, by which its slope is larger: by 16 % at x = 2, a sigma of two edges, 4 % at x =
// 15, 1 % at x = 100.
//
// The plane's waves exp(i k p) are eigenvectors of the lattice, too, with the eigenvalues
//   lambda(k) = 4/3 sum over the three directions e of edges (1 - cos(k e)),     edges of length 1,
// so that F is the mean of t / (1 + t lambda) over all waves there are, over m = sqrt(3) / 2.
class Lattice_kernel
{
public:
  Lattice_kernel()
  {
    const double pi = 3.14159265358979323846;
    std::array<double, waves> cosines, sines; // of the angles k e that are sampled, evenly
    for (std::size_t i = 0; i < waves; ++i) {
      const double angle = 2 * pi * (double(i) + 0.5) / double(waves);
      cosines[i] = std::cos(angle);
      sines[i] = std::sin(angle);
    }
    m_values.fill(0);
    const double area = std::sqrt(3.) / 2;
    for (std::size_t i = 0; i < waves; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const double third = cosines[i] * cosines[j] + sines[i] * sines[j]; // of the difference of the two angles
        const double lambda = 4. / 3 * (3 - cosines[i] - cosines[j] - third), weight = i == j ? 1 : 2;
        for (std::size_t n = 0; n < size; ++n) m_values[n] += weight / (1 / (area * at(n)) + lambda);
      }
    for (double& value : m_values) value *= 4 * pi / (area * double(waves * waves));
  }

  // 4 pi F(x), to 1e-4.
  double operator()(double x) const
  {
    if (!(x > at(0))) return m_values[0] * x / at(0); // next to nothing has left the vertex
    const double position = std::log(x / at(0)) / step();
    if (position >= double(size - 1)) return m_values[size - 1] + (position - double(size - 1)) * step();
    const std::size_t n = position < 1 ? 0 : position >= double(size - 2) ? size - 4 : std::size_t(position) - 1;
    const double u = position - double(n); // cubic through four values
    return -m_values[n] * (u - 1) * (u - 2) * (u - 3) / 6 + m_values[n + 1] * u * (u - 2) * (u - 3) / 2 -
           m_values[n + 2] * u * (u - 1) * (u - 3) / 2 + m_values[n + 3] * u * (u - 1) * (u - 2) / 6;
  }

private:
  static constexpr std::size_t size = 24, waves = 160;
  static double step() { return std::log(2.) * 0.7; }
  static double at(std::size_t n) { return 0.004 * std::exp(step() * double(n)); } // to 280

  std::array<double, size> m_values;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_LATTICE_KERNEL_H
