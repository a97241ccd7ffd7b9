// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_VECTOR_SEQUENCE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_VECTOR_SEQUENCE_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A vector for each of T samples of a motion, and its derivative by central differences; linear between samples, the
// first and the last one for all times before and after. Times are numbers of samples.
class Vector_sequence
{
public:
  Vector_sequence(const std::vector<float>& values, std::size_t width)
    : m_width(width)
    , m_size(values.size() / width)
    , m_values(values.begin(), values.end())
    , m_derivatives(values.size(), 0)
  {
    for (std::size_t t = 0; t < m_size; ++t) {
      const std::size_t before = t > 0 ? t - 1 : 0, after = (std::min)(t + 1, m_size - 1);
      if (before == after) continue;
      for (std::size_t c = 0; c < width; ++c)
        m_derivatives[t * width + c] =
            (m_values[after * width + c] - m_values[before * width + c]) / double(after - before);
    }
  }

  std::size_t size() const { return m_size; }
  std::size_t width() const { return m_width; }

  double value(double t, std::size_t c) const { return between(m_values, t, c); }

  double derivative(double t, std::size_t c) const
  {
    return t > 0 && t < double(m_size - 1) ? between(m_derivatives, t, c) : 0;
  }

  double square_derivative(std::size_t t) const
  {
    double sum = 0;
    for (std::size_t c = 0; c < m_width; ++c) sum += m_derivatives[t * m_width + c] * m_derivatives[t * m_width + c];
    return sum;
  }

  double mean_square_derivative() const
  {
    double sum = 0;
    for (std::size_t t = 0; t < m_size; ++t) sum += square_derivative(t);
    return sum / double(m_size);
  }

  // multiplies the components from `begin` to before `end`.
  void scale(std::size_t begin, std::size_t end, double factor)
  {
    for (std::vector<double>* x : {&m_values, &m_derivatives})
      for (std::size_t t = 0; t < m_size; ++t)
        for (std::size_t c = begin; c < end; ++c) (*x)[t * m_width + c] *= factor;
  }

private:
  double between(const std::vector<double>& x, double t, std::size_t c) const
  {
    const double at = (std::min)((std::max)(t, 0.), double(m_size - 1));
    const std::size_t i = std::size_t(at);
    if (i + 1 >= m_size) return x[(m_size - 1) * m_width + c];
    return x[i * m_width + c] + (at - double(i)) * (x[(i + 1) * m_width + c] - x[i * m_width + c]);
  }

  std::size_t m_width, m_size;
  std::vector<double> m_values, m_derivatives;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_INTERNAL_VECTOR_SEQUENCE_H
