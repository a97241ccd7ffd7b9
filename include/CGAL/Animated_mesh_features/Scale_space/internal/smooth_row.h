// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_SMOOTH_ROW_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_SMOOTH_ROW_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Step_weights.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A row of n frames and, on either side, as many of its periodic mirror images as the weights reach.
template <class T>
void mirror(const T* in, std::ptrdiff_t n, std::ptrdiff_t reach, T* row)
{
  std::copy(in, in + n, row);
  for (std::ptrdiff_t first = 0; first < reach; first += n) {
    const std::ptrdiff_t last = (std::min)(reach, first + n);
    const bool is_turned = first / n % 2 == 0;
    for (std::ptrdiff_t i = first; i < last; ++i) {
      const std::ptrdiff_t j = i - first;
      row[-1 - i] = in[is_turned ? j : n - 1 - j];
      row[n + i] = in[is_turned ? n - 1 - j : j];
    }
  }
}

// The same with the row again and again on either side.
template <class T>
void repeat(const T* in, std::ptrdiff_t n, std::ptrdiff_t reach, T* row)
{
  std::copy(in, in + n, row);
  for (std::ptrdiff_t first = 0; first < reach; first += n) {
    const std::ptrdiff_t count = (std::min)(reach - first, n);
    std::copy(in + n - count, in + n, row - first - count);
    std::copy(in, in + count, row + n + first);
  }
}

// Values of single vertices: the registers hold successive frames.
template <class FT>
void convolve_row(const FT* row, std::ptrdiff_t n, const Step_weights& k, FT* out)
{
  typedef Eigen::Array<FT, Eigen::Dynamic, 1> Row;
  const std::ptrdiff_t size = std::ptrdiff_t(k.weights.size());
  const auto pair = [&](std::ptrdiff_t i) {
    const std::ptrdiff_t m = i * k.stride;
    return FT(k.weights[std::size_t(i)]) * (Eigen::Map<const Row>(row - m, n) + Eigen::Map<const Row>(row + m, n));
  };
  Eigen::Map<Row> sum(out, n);
  sum = FT(k.weights[0]) * Eigen::Map<const Row>(row, n);
  std::ptrdiff_t i = 1;
  // two at a time: half of the loads and stores of the sum
  for (; i + 1 < size; i += 2) sum += pair(i) + pair(i + 1);
  if (i < size) sum += pair(i);
}

// A register holds one frame of all vertices.
template <int frames, class T>
void convolve(const T* row, const Step_weights& k, std::ptrdiff_t spacing, T* out)
{
  typedef typename T::Scalar Scalar;
  T sum[frames];
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (int f = 0; f < frames; ++f) sum[f] = row[f] * Scalar(k.weights[0]);
  for (std::size_t i = 1; i < k.weights.size(); ++i) {
    const std::ptrdiff_t m = std::ptrdiff_t(i);
    const Scalar weight = Scalar(k.weights[i]);
    CGAL_ANIMATED_MESH_FEATURES_UNROLL
    for (int f = 0; f < frames; ++f) sum[f] = sum[f] + (row[f - m] + row[f + m]) * weight;
  }
  CGAL_ANIMATED_MESH_FEATURES_UNROLL
  for (int f = 0; f < frames; ++f) out[f * spacing] = sum[f];
}

// Values of several vertices in n frames one after the other, all of whose weights there are; written `spacing` apart.
template <class T>
void convolve_every(const T* row, std::ptrdiff_t n, const Step_weights& k, std::ptrdiff_t spacing, T* out)
{
  std::ptrdiff_t f = 0;
  // several frames at a time: their sums do not wait for one another
  for (; f + 3 < n; f += 4) convolve<4>(row + f, k, spacing, out + f * spacing);
  for (; f < n; ++f) convolve<1>(row + f, k, spacing, out + f * spacing);
}

// Values of several vertices, with weights several frames apart: frames that are weighted together, and their images, are
// brought together, so that they meet in the caches however long the row is.
template <class T>
void convolve_thinned(const T* in, std::ptrdiff_t n, const Step_weights& k, bool is_periodic, T* out)
{
  static thread_local std::vector<T> before, gathered;
  const std::ptrdiff_t s = k.stride, reach = std::ptrdiff_t(k.weights.size()) - 1;
  // the frame of the row of which frame f, anywhere, is an image
  const std::ptrdiff_t circle = is_periodic ? n : 2 * n;
  const auto original_frame = [&](std::ptrdiff_t f) {
    f = (f % circle + circle) % circle;
    return f < n ? f : 2 * n - 1 - f;
  };
  const auto inner = [&](std::ptrdiff_t f) { return f >= 0 && f < n; };
  for (std::size_t part = 0; part < k.parts; ++part) {
    if (part > 0) before.assign(out, out + n);
    const T* const row = part == 0 ? in : before.data();
    for (std::ptrdiff_t first = 0; first < (std::min)(n, s); ++first) {
      const std::ptrdiff_t count = (n - first + s - 1) / s, size = count + 2 * reach;
      if (std::ptrdiff_t(gathered.size()) < size) gathered.resize(std::size_t(size));
      std::ptrdiff_t i = 0, f = first - reach * s;
      for (; i < size && !inner(f); ++i, f += s) gathered[std::size_t(i)] = row[original_frame(f)];
      for (; i < size && inner(f); ++i, f += s) gathered[std::size_t(i)] = row[f];
      for (; i < size; ++i, f += s) gathered[std::size_t(i)] = row[original_frame(f)];
      convolve_every(gathered.data() + reach, count, k, s, out + first);
    }
  }
}

// Smooths a row of n frames, which is continued by itself or by its mirror image; `in` and `out` do not overlap.
template <class T>
void smooth_row(const T* in, std::ptrdiff_t n, const Step_weights& k, bool is_periodic, T* out)
{
  const std::ptrdiff_t reach = k.reach();
  if constexpr (!std::is_arithmetic<T>::value)
    if (k.stride > 1) return convolve_thinned(in, n, k, is_periodic, out);
  // the row between its images
  static thread_local std::vector<T> continued;
  if (std::ptrdiff_t(continued.size()) < n + 2 * reach) continued.resize(std::size_t(n + 2 * reach));
  T* const row = continued.data() + reach;
  for (std::size_t part = 0; part < k.parts; ++part) {
    if (is_periodic)
      repeat(part == 0 ? in : out, n, reach, row);
    else
      mirror(part == 0 ? in : out, n, reach, row);
    if constexpr (std::is_arithmetic<T>::value)
      convolve_row(row, n, k, out);
    else
      convolve_every(row, n, k, 1, out);
  }
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_SMOOTH_ROW_H
