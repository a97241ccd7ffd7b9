// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_DIFFUSION_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_DIFFUSION_FILTER_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_step.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_system.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing by heat diffusion on the rest shape; a model of `SpatialFilter`, the default.

The heat equation with the cotangent Laplacian \f$L_c\f$ and lumped masses M, stepped from level to level by the
second-order L-stable scheme SDIRK2 \cgalCite{alexander1977}: with \f$\gamma = 1 - 1/\sqrt2\f$,
\f$t = (s_k - s_{k-1})/2\f$ and \f$B = (M + \gamma t L_c)^{-1} M\f$,
\f[ L_k = (1+\sqrt2)\, B^2 L_{k-1} - \sqrt2\, B\, L_{k-1} . \f]
Its scale does not depend on the sampling of the surface. (Backward Euler has the exact variance, too, but its peak
decays differently, which biases detected scales by +11 %.)

The matrix of a level is factored once and used for all frames, several of which are solved at a time. A vertex that is
in no proper triangle keeps its values.

What a level changes is solved for in single precision, but in double precision by the first levels, in which values of
any roughness meet the steep weights of slivers: an error of some \f$10^{-7}\f$ of the largest change of a level. A
constant field stays as it is, bit for bit. The result does not depend on the processor.

Complexity of a level: a factorisation, \f$O(N^{1.5})\f$ operations for \f$O(N \log N)\f$ entries (35 `N` of them at N =
10,000, 75 `N` at a million), and `F` solves with it, of two operations an entry, which are most of the time where there
are more than some 100 frames. Memory: `O(N)` for a thread, and the factors of as many levels at a time as fit into the
memory of the field, but two at least.

\cgalModels{SpatialFilter}
*/
class Heat_diffusion_filter
{
public:
  /// the variance that one-ring averaging would add in a pass, \f$3h^2/7\f$: the step where a sampling counts steps.
  double unit_variance(const Rest_shape& shape) const { return 3 * squared(shape.mean_edge_length()) / 7; }

  /// the smallest variance that a level can have: \f$(0.3\,h)^2\f$, below which a Gaussian falls between the vertices.
  double smallest_variance(const Rest_shape& shape) const { return squared(0.3 * shape.mean_edge_length()); }

  /// prepares the levels; factors are computed when a level is asked for.
  /// \param shape the rest shape.
  /// \param variances ascending; squared length per axis.
  template <class Loop>
  void initialize(const Rest_shape& shape, const std::vector<double>& variances, const Loop&)
  {
    m_variances = variances;
    m_system = std::make_shared<internal::Heat_system>(shape);
    m_factors.assign(variances.size(), Factor());
  }

  /// the variance of level `k`, exactly the one that was asked for.
  double variance(std::size_t k) const { return m_variances[k]; }

  /// the same at every vertex.
  double variance(std::size_t k, std::size_t) const { return m_variances[k]; }

  /// smooths all frames from level `k` - 1 (the unsmoothed field for `k` = 0) to level `k`.
  /// \throw Numerical_error if the factorisation fails.
  template <class Loop>
  void operator()(std::size_t k, const Spatio_temporal_field<double>& in, Spatio_temporal_field<double>& out,
                  const Loop& loop)
  {
    if (variance_step(k) == 0) {
      out = in;
      return;
    }
    const bool is_factored = m_factors[k].single || m_factors[k].precise;
    if (!is_factored) factor_levels(k, in.size_in_bytes(), loop.part(0, 2));
    const Loop solve_loop = is_factored ? loop : loop.part(1, 2);
    const Factor factor = std::move(m_factors[k]);
    m_factors[k] = Factor(); // each level is asked for once
    if (factor.single)
      step(k, *factor.single, in, out, solve_loop);
    else
      step(k, *factor.precise, in, out, solve_loop);
  }

  /// the same for fields of `float`, by way of fields of `double`.
  template <class FT, class Loop>
  void operator()(std::size_t k, const Spatio_temporal_field<FT>& in, Spatio_temporal_field<FT>& out, const Loop& loop)
  {
    Spatio_temporal_field<double> precise_in(in.number_of_rows(), in.number_of_frames());
    Spatio_temporal_field<double> precise_out(in.number_of_rows(), in.number_of_frames());
    for (std::size_t v = 0; v < in.number_of_rows(); ++v)
      std::copy_n(in.row(v), in.number_of_frames(), precise_in.row(v));
    operator()(k, precise_in, precise_out, loop);
    for (std::size_t v = 0; v < in.number_of_rows(); ++v)
      std::transform(precise_out.row(v), precise_out.row(v) + in.number_of_frames(), out.row(v),
                     [](double x) { return FT(x); });
  }

private:
  // One of the two, as long as it is needed; copies of the filter share it.
  struct Factor
  {
    std::shared_ptr<const internal::Sparse_cholesky<float>> single;
    std::shared_ptr<const internal::Sparse_cholesky<double>> precise;
  };

  static double squared(double x) { return x * x; }

  double variance_step(std::size_t k) const { return m_variances[k] - (k > 0 ? m_variances[k - 1] : 0); }

  // t in the matrix M + t L
  double time_step(std::size_t k) const { return (1 - 1 / std::sqrt(2.)) * variance_step(k) / 2; }

  // Errors are relative to the right-hand side, a sum of differences with the weights of the edges, which are as large as
  // slivers are flat. Where the field is rough, that is much larger than the change. It no longer is once smoothing has
  // evened out the ends of such edges; each doubling of what is left of it is a doubling of the error.
  bool needs_double_precision(std::size_t k) const
  {
    const double largest_growth = 8;
    return k == 0 || variance_step(k) > largest_growth * m_variances[k - 1];
  }

  // Level k and those following it, at the same time, as far as memory goes.
  template <class Loop>
  void factor_levels(std::size_t k, std::size_t memory, const Loop& loop)
  {
    std::vector<std::size_t> levels;
    std::size_t size = 0;
    for (std::size_t i = k; i < m_variances.size(); ++i) {
      if (variance_step(i) == 0) continue;
      size += m_system->symbolic().number_of_values() * (needs_double_precision(i) ? sizeof(double) : sizeof(float));
      if (levels.size() >= 2 && size > memory) break;
      levels.push_back(i);
    }
    const internal::Instruction_set instructions = internal::widest_instruction_set();
    loop(levels.size(), [&](std::size_t i) {
      Factor& factor = m_factors[levels[i]];
      const double t = time_step(levels[i]);
      if (needs_double_precision(levels[i]))
        factor.precise = std::make_shared<internal::Sparse_cholesky<double>>(m_system->factor<double>(t, instructions));
      else
        factor.single = std::make_shared<internal::Sparse_cholesky<float>>(m_system->factor<float>(t, instructions));
    });
  }

  template <class T, class Loop>
  void step(std::size_t k, const internal::Sparse_cholesky<T>& factor, const Spatio_temporal_field<double>& in,
            Spatio_temporal_field<double>& out, const Loop& loop) const
  {
    typedef internal::Heat_step<T> Step;
    const internal::Instruction_set instructions = internal::widest_instruction_set();
    constexpr std::size_t vertices_per_task = 256;
    const std::size_t n = in.number_of_rows();
    loop.part(0, 2)((n + vertices_per_task - 1) / vertices_per_task, [&](std::size_t task) {
      const std::size_t first = task * vertices_per_task;
      internal::Heat_source source{*m_system, time_step(k), in, out, first, (std::min)(n, first + vertices_per_task)};
      internal::run_reproducibly<double>(instructions, source);
    });
    const Step step(*m_system, factor, in, out);
    // two packs use each part of the factor while it is in the cache, unless that leaves too few tasks
    const std::size_t packs = step.number_of_packs(), packs_per_task = packs >= 8 ? 2 : 1;
    internal::Thread_local<typename Step::Workspace> workspaces;
    loop.part(1, 2)((packs + packs_per_task - 1) / packs_per_task, [&](std::size_t task) {
      const std::size_t first = task * packs_per_task;
      auto& workspace =
          workspaces.get([&] { return std::make_unique<typename Step::Workspace>(*m_system, packs_per_task); });
      step(first, (std::min)(packs_per_task, packs - first), workspace, instructions);
    });
  }

  std::vector<double> m_variances;
  std::shared_ptr<const internal::Heat_system> m_system;
  std::vector<Factor> m_factors;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_DIFFUSION_FILTER_H
