// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_RUN_VECTORIZED_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_RUN_VECTORIZED_H

#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>

#include <cstddef>
#include <type_traits>

// CGAL_ANIMATED_MESH_FEATURES_BASELINE_ONLY leaves out the loops for other instructions than the program's: they triple
// the time to compile the search, and more than that under sanitizers, which look at every access that is inlined.
#if defined(__x86_64__) && defined(CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES) && \
    !defined(CGAL_ANIMATED_MESH_FEATURES_BASELINE_ONLY)
  #define CGAL_ANIMATED_MESH_FEATURES_CHOOSES_INSTRUCTIONS 1
#endif

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Vector instructions, from narrow to wide. BASELINE is what the program is compiled for.
enum class Instruction_set
{
  BASELINE,
  AVX2,
  AVX512
};

// The widest that this processor and its operating system have. AVX2 comes without fused multiply-add on purpose: as
// no sum is fused with a product, results are those of BASELINE, bit for bit.
inline Instruction_set widest_instruction_set()
{
#ifdef CGAL_ANIMATED_MESH_FEATURES_CHOOSES_INSTRUCTIONS
  static const Instruction_set widest = [] {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
      return Instruction_set::AVX512;
    return __builtin_cpu_supports("avx2") ? Instruction_set::AVX2 : Instruction_set::BASELINE;
  }();
  return widest;
#else
  return Instruction_set::BASELINE;
#endif
}

// Bytes in a register of the baseline: of one number where the compiler has no vector types.
template <class T>
struct Baseline_register
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_VECTOR_TYPES
  : std::integral_constant<std::size_t, 16>
#else
  : std::integral_constant<std::size_t, sizeof(T)>
#endif
{
};

#ifdef CGAL_ANIMATED_MESH_FEATURES_CHOOSES_INSTRUCTIONS
// Flattened, since a function that is called, not inlined, is compiled for the baseline.
template <class Vector_loop>
__attribute__((target("avx2"), flatten, noinline)) void run_avx2(Vector_loop& loop)
{
  loop.template run<32>();
}

template <class Vector_loop>
__attribute__((target("avx512f,avx512dq,avx512vl"), flatten, noinline)) void run_avx512(Vector_loop& loop)
{
  loop.template run<64>();
}
#endif

// Calls loop.run<bytes in a register>() with the instructions of a set that this processor has. T is the loop's scalar.
template <class T, class Vector_loop>
void run_vectorized(Instruction_set instructions, Vector_loop& loop)
{
#ifdef CGAL_ANIMATED_MESH_FEATURES_CHOOSES_INSTRUCTIONS
  if (instructions == Instruction_set::AVX512) return run_avx512(loop);
  if (instructions == Instruction_set::AVX2) return run_avx2(loop);
#endif
  (void)instructions;
  loop.template run<Baseline_register<T>::value>();
}

// The same with AVX2 at most, so that what is computed has the same bits whatever the processor: with AVX512 come fused
// operations, which the compiler uses where it can. For results that are kept; the loop needs no run<64>().
template <class T, class Vector_loop>
void run_reproducibly(Instruction_set instructions, Vector_loop& loop)
{
#ifdef CGAL_ANIMATED_MESH_FEATURES_CHOOSES_INSTRUCTIONS
  if (instructions >= Instruction_set::AVX2) return run_avx2(loop);
#endif
  (void)instructions;
  loop.template run<Baseline_register<T>::value>();
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SIMD_RUN_VECTORIZED_H
