// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_STEP_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_STEP_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/convert_packs.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_system.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// What a step of heat diffusion starts from, t L f with the sign that smooths, for some vertices in all frames, for
// run_reproducibly(): sums of differences, which are exactly zero where the field is constant.
struct Heat_source
{
  static constexpr std::size_t pack_size = 8; // rows are padded to that many

  const Heat_system& system;
  double t;
  const Spatio_temporal_field<double>& field;
  Spatio_temporal_field<double>& source;
  std::size_t first, last; // vertices

  template <std::size_t register_bytes>
  CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
  {
    typedef Pack<double, pack_size, register_bytes> Frames;
    for (std::size_t v = first; v < last; ++v) {
      const Compressed_rows::Row ring = system.neighbours()[v];
      const double* weights = system.weights(v);
      const double* row = field.row(v);
      double* to = source.row(v);
      for (std::size_t f = 0; f < field.number_of_frames(); f += pack_size) {
        const Frames own = Frames::load(row + f);
        Frames sum = Frames::all(0);
        for (std::size_t k = 0; k < ring.size(); ++k)
          sum = sum + (Frames::load(field.row(ring.begin()[k]) + f) - own) * weights[k];
        (sum * t).store(to + f);
      }
    }
  }
};

// A step of heat diffusion for some of the frames in all vertices. With A = M + t L, B = A^-1 M and the change
// u = (B - 1) f = -A^-1 t L f by backward Euler, SDIRK2 is
//   (1 + sqrt 2) B^2 f - sqrt 2 B f = f + u + (1 + sqrt 2) A^-1 M u,
// so that T, in which the systems are solved, rounds what changes only.
template <class T>
class Heat_step
{
  static constexpr std::size_t pack_size = Right_hand_sides<T>::pack_size; // frames in a pack of right-hand sides
  static constexpr std::size_t unit = Heat_source::pack_size;              // frames that are read and written together
  static constexpr std::size_t units_per_pack = pack_size / unit;

public:
  // Room for the right-hand sides of some packs of frames, for a thread: u, and A^-1 M u.
  struct Workspace
  {
    Right_hand_sides<T> change, next;

    Workspace(const Heat_system& system, std::size_t packs)
      : change(system.symbolic(), packs * pack_size)
      , next(change)
    {}
  };

  // `out` has the source of the step at first.
  Heat_step(const Heat_system& system, const Sparse_cholesky<T>& factor, const Spatio_temporal_field<double>& in,
            Spatio_temporal_field<double>& out)
    : m_system(system)
    , m_factor(factor)
    , m_in(in)
    , m_out(out)
  {}

  // Packs of right-hand sides in all frames.
  std::size_t number_of_packs() const { return (m_in.number_of_frames() + pack_size - 1) / pack_size; }

  // Packs [first, first + packs).
  void operator()(std::size_t first, std::size_t packs, Workspace& w, Instruction_set instructions) const
  {
    w.change.resize(packs * pack_size);
    w.next.resize(packs * pack_size);
    const std::size_t first_frame = first * pack_size, units = packs * units_per_pack;
    const std::size_t inside = (std::min)(units, (m_in.stride() - first_frame) / unit);
    Load load{m_system, m_out, w.change, first_frame, units, inside};
    run_reproducibly<double>(instructions, load);
    m_factor.solve(w.change, instructions);
    Weigh weigh{m_system, w.change, w.next};
    run_reproducibly<T>(instructions, weigh);
    m_factor.solve(w.next, instructions);
    Combine combine{m_system, m_in, w.change, w.next, m_out, first_frame, inside};
    run_reproducibly<double>(instructions, combine);
  }

private:
  // The source as a right-hand side.
  struct Load
  {
    const Heat_system& system;
    const Spatio_temporal_field<double>& source;
    Right_hand_sides<T>& change;
    std::size_t first_frame, units, inside; // of the units those that the rows of a field have

    template <std::size_t register_bytes>
    CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
    {
      typedef Pack<double, unit, register_bytes> Unit;
      const auto rows = change.rows();
      const std::size_t n = system.size(), begin = first_frame, stored = inside, all = units;
      for (std::size_t v = 0; v < n; ++v) {
        const double* row = source.row(v) + begin;
        const auto to = rows[v];
        for (std::size_t i = 0; i < stored; ++i) store_pack(Unit::load(row + i * unit), address(to, i));
        for (std::size_t i = stored; i < all; ++i) std::fill_n(address(to, i), unit, T(0));
      }
    }
  };

  // M u, in the order in which it is in memory.
  struct Weigh
  {
    const Heat_system& system;
    const Right_hand_sides<T>& change;
    Right_hand_sides<T>& next;

    template <std::size_t register_bytes>
    CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
    {
      typedef Pack<T, pack_size, register_bytes> Frames;
      const auto rows = change.rows();
      const auto next_rows = next.rows();
      for (std::size_t p = 0; p < change.number_of_packs(); ++p)
        for (Compressed_rows::Index v : system.symbolic().order())
          (Frames::load(rows[v].pack(p)) * T(system.mass()[v])).store(next_rows[v].pack(p));
    }
  };

  struct Combine
  {
    const Heat_system& system;
    const Spatio_temporal_field<double>& in;
    const Right_hand_sides<T>&change, &next;
    Spatio_temporal_field<double>& out;
    std::size_t first_frame, inside;

    template <std::size_t register_bytes>
    CGAL_ANIMATED_MESH_FEATURES_INLINE void run()
    {
      typedef Pack<double, unit, register_bytes> Unit;
      const double weight_of_next = 1 + std::sqrt(2.);
      const auto rows = change.rows(), next_rows = next.rows();
      const std::size_t n = system.size(), begin = first_frame, stored = inside;
      for (std::size_t v = 0; v < n; ++v) {
        const double* row = in.row(v) + begin;
        double* to = out.row(v) + begin;
        const auto first = rows[v], second = next_rows[v];
        for (std::size_t i = 0; i < stored; ++i)
          (Unit::load(row + i * unit) + load_pack<Unit>(address(first, i)) +
           load_pack<Unit>(address(second, i)) * weight_of_next)
              .store(to + i * unit);
      }
    }
  };

  // Unit i of a row.
  template <class Row>
  static CGAL_ANIMATED_MESH_FEATURES_INLINE auto address(const Row& row, std::size_t i)
  {
    return row.pack(i / units_per_pack) + i % units_per_pack * unit;
  }

  const Heat_system& m_system;
  const Sparse_cholesky<T>& m_factor;
  const Spatio_temporal_field<double>& m_in;
  Spatio_temporal_field<double>& m_out;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_INTERNAL_HEAT_STEP_H
