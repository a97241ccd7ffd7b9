// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_ISOLATED_LOOPS_H
#define CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_ISOLATED_LOOPS_H

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

// Bounds: what a core can do at most, with the widest instructions it has, whatever the compiler's flags. They need the
// vector types of g++ and clang++.

namespace Benchmark {

#define BENCHMARK_INLINE inline __attribute__((always_inline))

template <class T, std::size_t bytes>
struct Vector;
#define BENCHMARK_VECTOR(T, Integer, bytes)                                                                            \
  template <>                                                                                                          \
  struct Vector<T, bytes>                                                                                              \
  {                                                                                                                    \
    typedef T type __attribute__((vector_size(bytes)));                                                                \
    typedef Integer Mask __attribute__((vector_size(bytes)));                                                          \
    static constexpr std::size_t width = bytes / sizeof(T);                                                            \
  };
BENCHMARK_VECTOR(float, std::int32_t, 16)
BENCHMARK_VECTOR(float, std::int32_t, 32)
BENCHMARK_VECTOR(float, std::int32_t, 64)
BENCHMARK_VECTOR(double, std::int64_t, 16)
BENCHMARK_VECTOR(double, std::int64_t, 32)
BENCHMARK_VECTOR(double, std::int64_t, 64)
#undef BENCHMARK_VECTOR

template <class T>
using Aligned_values = std::vector<T, boost::alignment::aligned_allocator<T, 64>>;

// Runs loop.run<bytes>(), compiled for registers of that many bytes.
#if defined(__x86_64__)
template <class Loop>
__attribute__((target("avx2,fma"), flatten, noinline)) void run_32(Loop& loop)
{
  loop.template run<32>();
}
template <class Loop>
__attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma"), flatten, noinline)) void run_64(Loop& loop)
{
  loop.template run<64>();
}
#endif
template <class Loop>
__attribute__((noinline)) void run_16(Loop& loop)
{
  loop.template run<16>();
}

inline std::size_t register_bytes()
{
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return 64;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return 32;
#endif
  return 16;
}

template <class Loop>
void run_widest(Loop& loop)
{
#if defined(__x86_64__)
  if (register_bytes() == 64) return run_64(loop);
  if (register_bytes() == 32) return run_32(loop);
#endif
  run_16(loop);
}

// ------------------------------------------------------------------------------------------------------- arithmetic

// Twelve independent chains of multiply-and-add in registers: enough for two units with a latency of five, and not more
// than sixteen registers hold.
template <class T>
struct Multiply_add_loop
{
  static constexpr std::size_t chains = 12;
  std::size_t steps;
  T result = 0;

  double flops() const { return 2. * double(chains) * double(steps) * double(register_bytes() / sizeof(T)); }

  template <std::size_t bytes>
  BENCHMARK_INLINE void run()
  {
    typedef typename Vector<T, bytes>::type V;
    const V m = V{} + T(0.999), a = V{} + T(0.001);
    V x[chains];
    for (std::size_t i = 0; i < chains; ++i) x[i] = V{} + T(i) / T(chains);
    for (std::size_t s = 0; s < steps; ++s) {
#pragma GCC unroll 12
      for (std::size_t i = 0; i < chains; ++i) x[i] = x[i] * m + a;
    }
    V sum = V{};
    for (std::size_t i = 0; i < chains; ++i) sum += x[i];
    T values[Vector<T, bytes>::width];
    __builtin_memcpy(values, &sum, sizeof values);
    for (T v : values) result += v;
  }
};

// ---------------------------------------------------------------------------------------------------------- bandwidth

// STREAM's triad a = b + s c on three arrays, so many times over. By STREAM's convention 24 bytes an element are moved;
// that the caches read a as well before it is written does not count.
struct Triad_loop
{
  Aligned_values<double> a, b, c;
  std::size_t sweeps;

  Triad_loop(std::size_t bytes, std::size_t number_of_sweeps)
    : a(bytes / 24 / 64 * 64, 0)
    , b(a.size(), 1)
    , c(a.size(), 2)
    , sweeps(number_of_sweeps)
  {}

  double bytes_moved() const { return 24. * double(a.size()) * double(sweeps); }

  template <std::size_t bytes>
  BENCHMARK_INLINE void run()
  {
    typedef typename Vector<double, bytes>::type V;
    V* const x = reinterpret_cast<V*>(a.data());
    const V* const y = reinterpret_cast<const V*>(b.data());
    const V* const z = reinterpret_cast<const V*>(c.data());
    const std::size_t n = a.size() / Vector<double, bytes>::width;
    for (std::size_t s = 0; s < sweeps; ++s) {
      const V factor = V{} + double(s);
#pragma GCC unroll 4
      for (std::size_t i = 0; i < n; ++i) x[i] = y[i] + factor * z[i];
      asm volatile("" ::: "memory");
    }
  }
};

// -------------------------------------------------------------------------------------------------------- scale space

// What cannot be saved of a scale space of every smoothing count, and nothing else: for each sample two box averages
// (of the differences in space and in time), their weighted sum, and the comparison with the 8 neighbouring scales and
// the 2 neighbouring frames. A register holds as many vertices; rows are so short that all of it stays in the L1 cache,
// and every row is a neighbour of the other two. Survivors are counted, not examined.
struct Scale_space_loop
{
  static constexpr std::size_t frames = 16, rows = 3; // 27 KB with registers of 64 bytes
  std::size_t box_width, time_levels;
  std::size_t minima = 0;
  Aligned_values<float> memory;

  Scale_space_loop(std::size_t width, std::size_t levels)
    : box_width(width)
    , time_levels(levels)
    , memory((4 + 3 + 2) * rows * frames * 16)
  {}

  double samples() const { return double(rows * frames * time_levels * (register_bytes() / sizeof(float))); }

  template <std::size_t bytes>
  BENCHMARK_INLINE void run()
  {
    typedef typename Vector<float, bytes>::type V;
    typedef typename Vector<float, bytes>::Mask Mask;
    V* const base = reinterpret_cast<V*>(memory.data());
    constexpr std::size_t plane = rows * frames;
    V *in = base, *out = base + 2 * plane;                                              // two differences each
    V* const d = base + 4 * plane;                                                      // of three time levels
    V *const least_of_three = base + 7 * plane, *const least_of_two = base + 8 * plane; // over time levels
    std::uint32_t seed = 1;
    for (std::size_t i = 0; i < 2 * plane; ++i)
      for (std::size_t j = 0; j < Vector<float, bytes>::width; ++j) {
        seed = seed * 1664525u + 1013904223u;
        in[i][j] = float(seed >> 8) / float(1 << 24) - 0.5f;
      }
    for (std::size_t i = 0; i < 3 * plane; ++i) d[i] = V{};

    const std::ptrdiff_t reach = std::ptrdiff_t(box_width / 2);
    constexpr std::ptrdiff_t n = std::ptrdiff_t(frames);
    const float end = box_width % 2 ? 1.f : 0.5f, scale = 1 / float(box_width);
    const auto mirrored = [](std::ptrdiff_t f) {
      while (f < 0 || f >= n) f = f < 0 ? -1 - f : 2 * n - 1 - f;
      return f;
    };
    std::ptrdiff_t first[frames], second[frames], last[frames]; // of the box around each frame
    for (std::ptrdiff_t f = 0; f < n; ++f) {
      first[f] = mirrored(f - reach);
      second[f] = mirrored(f - reach + 1);
      last[f] = mirrored(f + reach);
    }
    Mask found = Mask{};
    for (std::size_t l = 0; l < time_levels; ++l) {
      const float a = 1 + 0.01f * float(l), b = 1 - 0.01f * float(l);
      V* const now = d + (l % 3) * plane;
      const V* const before = d + ((l + 2) % 3) * plane;
      const V* const before_that = d + ((l + 1) % 3) * plane;
      for (std::size_t k = 0; k < rows; ++k) {
        const V *p = in + 2 * k * frames, *q = p + frames;
        V *p_out = out + 2 * k * frames, *q_out = p_out + frames;
        V p_inner = V{}, q_inner = V{};
        for (std::ptrdiff_t i = 1 - reach; i < reach; ++i) {
          p_inner += p[mirrored(i)];
          q_inner += q[mirrored(i)];
        }
        for (std::size_t f = 0; f < frames; ++f) {
          const V p_last = p[last[f]], q_last = q[last[f]];
          const V p_mean = (p_inner + (p[first[f]] + p_last) * end) * scale;
          const V q_mean = (q_inner + (q[first[f]] + q_last) * end) * scale;
          p_inner += p_last - p[second[f]];
          q_inner += q_last - q[second[f]];
          p_out[f] = p_mean;
          q_out[f] = q_mean;
          const V x = p_mean * a + q_mean * b;
          const std::size_t i = k * frames + f;
          const V y = before[i], z = before_that[i];
          now[i] = x;
          const V two = x < z ? x : z;
          least_of_two[i] = two;
          least_of_three[i] = two < y ? two : y;
        }
      }
      for (std::size_t k = 0; k < rows; ++k) {
        const V *one = least_of_three + (k + 1) % rows * frames, *other = least_of_three + (k + 2) % rows * frames;
        const V *same = least_of_two + k * frames, *centre = before + k * frames;
        for (std::size_t f = 1; f + 1 < frames; ++f) {
          // Comparisons of vectors become branches in g++ 12, except those for the lesser of two. A minimum is below
          // the least of its neighbours and zero, and the sign of the difference is a bit.
          const V c = centre[f], before_it = centre[f - 1], behind_it = centre[f + 1];
          V least = before_it < behind_it ? before_it : behind_it;
          least = least < one[f] ? least : one[f];
          least = least < other[f] ? least : other[f];
          least = least < same[f] ? least : same[f];
          least = least < V{} ? least : V{};
          const V difference = c - least;
          Mask bits;
          __builtin_memcpy(&bits, &difference, sizeof bits);
          found -= bits >> 31; // all bits of a negative number
        }
      }
      std::swap(in, out);
    }
    std::int32_t counts[Vector<float, bytes>::width];
    __builtin_memcpy(counts, &found, sizeof counts);
    minima = 0;
    for (std::int32_t c : counts) minima += std::size_t(c);
  }
};

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_ISOLATED_LOOPS_H
