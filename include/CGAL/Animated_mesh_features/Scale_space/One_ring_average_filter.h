// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_ONE_RING_AVERAGE_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_ONE_RING_AVERAGE_FILTER_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/run_in_chunks.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/number_of_passes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing by repeated averages over the closed one-ring, a vertex and its neighbours with equal weights; a model of
`SpatialFilter`.

One average adds the variance \f$\Delta(v) = \frac12\,\mathrm{mean}\,|x_j - x_v|^2\f$ per axis, the mean being over the
closed ring: \f$3h^2/7\f$ on a regular triangulation of edge length h. Where the sampling varies, so does the scale:
\f$s_n(v) = \sum_{j<n} (P^j \Delta)(v)\f$ for the averaging operator P, which `variance(k, v)` returns.

A pass costs one addition for each pair of neighbours and frame. A level of standard deviation \f$\sigma\f$ takes some
\f$2.3\,(\sigma/h)^2\f$ passes. Memory: another field, if there is more than one pass between two levels.

\cgalModels{SpatialFilter}
*/
class One_ring_average_filter
{
public:
  /// makes a filter without levels.
  /// \param scale_per_vertex whether the scale of a level is told for each vertex; otherwise it is the same for all.
  explicit One_ring_average_filter(bool scale_per_vertex = true) : m_per_vertex(scale_per_vertex) {}

  /// the mean variance per axis that one average adds at the measured vertices (squared length); also the smallest that
  /// can be asked for.
  double unit_variance(const Rest_shape& shape) const
  {
    double sum = 0;
    const std::vector<double> delta = added_variance(shape);
    for (Rest_shape::Index v : shape.measured_vertices()) sum += delta[v];
    return sum / double(shape.measured_vertices().size());
  }

  /// the smallest variance that a level can have.
  double smallest_variance(const Rest_shape& shape) const { return unit_variance(shape); }

  /*!
  prepares the levels: the numbers of averages whose variances come nearest, strictly increasing as long as the
  variances are.
  \param shape the rest shape; is kept by reference.
  \param variances ascending; squared length per axis.
  \throw Option_error if more than 1e9 averages would be needed.
  */
  template <class Loop>
  void initialize(const Rest_shape& shape, const std::vector<double>& variances, const Loop&)
  {
    m_shape = &shape;
    m_unit = unit_variance(shape);
    m_counts.assign(variances.size(), 0);
    for (std::size_t k = 0; k < variances.size(); ++k) {
      const std::size_t nearest = internal::number_of_passes(variances[k], m_unit);
      m_counts[k] = k == 0 ? nearest : (std::max)(nearest, m_counts[k - 1] + (variances[k] > variances[k - 1]));
    }
    if (m_per_vertex) measure_levels();
  }

  /// the number of averages of level `k`.
  std::size_t count(std::size_t k) const { return m_counts[k]; }

  /// the mean variance of level `k`.
  double variance(std::size_t k) const { return double(m_counts[k]) * m_unit; }

  /// the variance of level `k` at a vertex.
  double variance(std::size_t k, std::size_t v) const
  {
    return m_per_vertex ? double(m_variances[k][v]) : variance(k);
  }

  /// smooths all frames from level `k` - 1 (the unsmoothed field for `k` = 0) to level `k`.
  template <class FT, class Loop>
  void
  operator()(std::size_t k, const Spatio_temporal_field<FT>& in, Spatio_temporal_field<FT>& out, const Loop& loop) const
  {
    const std::size_t passes = m_counts[k] - (k > 0 ? m_counts[k - 1] : 0);
    if (passes == 0) {
      out = in;
      return;
    }
    // to and fro between `out`, where the last pass ends, and another field
    Spatio_temporal_field<FT> other(passes > 1 ? in.number_of_rows() : 0, in.number_of_frames());
    for (std::size_t i = 0; i < passes; ++i) {
      const bool to_out = (passes - i) % 2 == 1;
      const Spatio_temporal_field<FT>& from = i == 0 ? in : to_out ? other : out;
      Spatio_temporal_field<FT>& to = to_out ? out : other;
      internal::run_in_chunks(in.number_of_rows(), loop.part(i, passes), [&](std::size_t first, std::size_t last) {
        Pass<FT> pass{*m_shape, from, to, first, last};
        internal::run_reproducibly<FT>(internal::widest_instruction_set(), pass);
      });
    }
  }

private:
  // The averages at vertices [first, last).
  template <class FT>
  struct Pass
  {
    const Rest_shape& shape;
    const Spatio_temporal_field<FT>& in;
    Spatio_temporal_field<FT>& out;
    std::size_t first, last;

    template <std::size_t register_bytes>
    CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
    {
      constexpr std::size_t line = 64 / sizeof(FT); // rows are whole cache lines
      for (std::size_t v = first; v < last; ++v) {
        std::size_t f = 0;
        for (; f + 2 * line <= in.stride(); f += 2 * line) average<internal::Pack<FT, 2 * line, register_bytes>>(v, f);
        if (f < in.stride()) average<internal::Pack<FT, line, register_bytes>>(v, f);
      }
    }

    template <class P>
    CGAL_ANIMATED_MESH_FEATURES_INLINE void average(std::size_t v, std::size_t f)
    {
      const Compressed_rows::Row ring = shape.neighbours()[v];
      P sum = P::load(in.row(v) + f);
      for (Rest_shape::Index w : ring) sum = sum + P::load(in.row(w) + f);
      (sum * (FT(1) / FT(ring.size() + 1))).store(out.row(v) + f);
    }
  };

  static std::vector<double> added_variance(const Rest_shape& shape)
  {
    std::vector<double> delta(shape.number_of_vertices(), 0);
    for (std::size_t v = 0; v < delta.size(); ++v) {
      const auto ring = shape.neighbours()[v];
      for (Rest_shape::Index w : ring) delta[v] += (shape.points()[w] - shape.points()[v]).squaredNorm();
      delta[v] /= 2 * double(ring.size() + 1);
    }
    return delta;
  }

  // s_n(v), by averaging the variance that the next pass adds along with the field
  void measure_levels()
  {
    const std::size_t n = m_shape->number_of_vertices();
    m_variances.assign(m_counts.size(), std::vector<float>(n, 0));
    std::vector<double> delta = added_variance(*m_shape), next(n), sum(n, 0);
    std::size_t done = 0;
    for (std::size_t k = 0; k < m_counts.size(); ++k) {
      for (; done < m_counts[k]; ++done) {
        for (std::size_t v = 0; v < n; ++v) {
          sum[v] += delta[v];
          const auto ring = m_shape->neighbours()[v];
          double s = delta[v];
          for (Rest_shape::Index w : ring) s += delta[w];
          next[v] = s / double(ring.size() + 1);
        }
        delta.swap(next);
      }
      for (std::size_t v = 0; v < n; ++v) m_variances[k][v] = float(sum[v]);
    }
  }

  bool m_per_vertex;
  const Rest_shape* m_shape = nullptr;
  double m_unit = 0;
  std::vector<std::size_t> m_counts;
  std::vector<std::vector<float>> m_variances; // levels x N
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_ONE_RING_AVERAGE_FILTER_H
