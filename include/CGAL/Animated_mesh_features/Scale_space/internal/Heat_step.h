// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_STEP_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_STEP_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_system.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Triangular_solve.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/convert_packs.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What a step of heat diffusion starts from, t L f with the sign that smooths, for some vertices in all frames, for
// run_reproducibly(): sums of differences, which are exactly zero where the field is constant.
struct Heat_source
{
  static constexpr std::size_t lanes = 8; // rows are padded to that many

  const Heat_system& system;
  double t;
  const Spatio_temporal_field<double>& field;
  Spatio_temporal_field<double>& source;
  std::size_t first, last; // vertices

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<double, lanes, register_bytes> L;
    for (std::size_t v = first; v < last; ++v) {
      const Compressed_rows::Row ring = system.neighbours()[v];
      const double* weights = system.weights(v);
      const double* row = field.row(v);
      double* to = source.row(v);
      for (std::size_t f = 0; f < field.number_of_frames(); f += lanes) {
        const L own = L::load(row + f);
        L sum = L::all(0);
        for (std::size_t k = 0; k < ring.size(); ++k)
          sum = sum + (L::load(field.row(ring.begin()[k]) + f) - own) * weights[k];
        (sum * t).store(to + f);
      }
    }
  }
};

// A step of heat diffusion for some of the frames in all vertices, for run_reproducibly(). With A = M + t L, B = A^-1 M
// and the change u = (B - 1) f = -A^-1 t L f by backward Euler, SDIRK2 is
//   (1 + sqrt 2) B^2 f - sqrt 2 B f = f + u + (1 + sqrt 2) A^-1 M u,
// so that T, in which the systems are solved, rounds what changes only.
template <class T>
struct Heat_step
{
  static constexpr std::size_t lanes = Triangular_solve<T>::lanes;
  static constexpr std::size_t unit = Heat_source::lanes;
  static constexpr std::size_t units_per_line = lanes / unit;

  const Heat_system& system;
  const Cholesky_factor<T>& factor;
  const Spatio_temporal_field<double>& in;
  Spatio_temporal_field<double>& out; // the source of the step at first

  // Numbers of a workspace for that many lines.
  std::size_t workspace_size(std::size_t lines) const { return 2 * lines * line_size(); }

  // Lines of right-hand sides in all frames.
  std::size_t number_of_lines() const { return (in.number_of_frames() + lanes - 1) / lanes; }

  // The lines [first, first + lines), set before run().
  std::size_t first = 0, lines = 0;
  T* workspace = nullptr;

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<double, unit, register_bytes> Unit;
    const Symbolic_factorization& symbolic = system.symbolic();
    const std::size_t n = system.size();
    T* change = workspace;
    T* next = workspace + lines * line_size();
    // behind the last row one that panels are filled up with
    for (std::size_t i = 0; i < 2 * lines; ++i) std::fill_n(workspace + i * line_size() + n * lanes, lanes, T(0));
    const std::size_t first_frame = first * lanes, units = lines * units_per_line;
    const std::size_t inside = (std::min)(units, (in.stride() - first_frame) / unit);
    for (std::size_t v = 0; v < n; ++v) {
      T* to = change + std::size_t(symbolic.position()[v]) * lanes;
      const double* row = out.row(v) + first_frame;
      for (std::size_t i = 0; i < inside; ++i) store_pack(Unit::load(row + i * unit), address(to, i));
      for (std::size_t i = inside; i < units; ++i) std::fill_n(address(to, i), unit, T(0));
    }
    Triangular_solve<T> solve{&symbolic, factor.values(), change, lines};
    solve.template run<register_bytes>();
    typedef Pack<T, lanes, register_bytes> Line;
    for (std::size_t line = 0; line < lines; ++line)
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t at = line * line_size() + i * lanes;
        (Line::load(change + at) * T(system.mass()[symbolic.original()[i]])).store(next + at);
      }
    solve.x = next;
    solve.template run<register_bytes>();
    const double factor_of_next = 1 + std::sqrt(2.);
    for (std::size_t v = 0; v < n; ++v) {
      const std::size_t position = std::size_t(symbolic.position()[v]) * lanes;
      const double* row = in.row(v) + first_frame;
      double* to = out.row(v) + first_frame;
      for (std::size_t i = 0; i < inside; ++i)
        (Unit::load(row + i * unit) + load_pack<Unit>(address(change + position, i)) +
         load_pack<Unit>(address(next + position, i)) * factor_of_next)
            .store(to + i * unit);
    }
  }

private:
  std::size_t line_size() const { return (system.size() + 1) * lanes; }

  template <class U>
  CGAL_ANIMATED_MESH_FEATURES_INLINE U* address(U* row, std::size_t i) const
  {
    return row + i / units_per_line * line_size() + i % units_per_line * unit;
  }
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_STEP_H
