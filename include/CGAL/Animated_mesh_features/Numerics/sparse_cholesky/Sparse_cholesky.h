// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_SPARSE_CHOLESKY_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_SPARSE_CHOLESKY_H

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Aligned_vector.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Multifrontal_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Nested_dissection.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Selected_inverse.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Symbolic_factorization.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Triangular_solve.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Solves A X = B for sparse symmetric positive definite matrices A, N x N, whose graphs are meshes, and many right-hand
// sides B, N x M, by the Cholesky factorisation P A P^T = L L^T with a permutation P that leaves L few entries:
//
//   const Symbolic_cholesky symbolic(neighbours, points);               // once for a pattern of entries
//   const Sparse_cholesky<float> cholesky(symbolic, diagonal, entry);   // once for a matrix
//   Right_hand_sides<float> x(symbolic, columns);                       // B
//   cholesky.solve(x);                                                  // X
//
// Results are the same, bit for bit, whatever the processor, its vector instructions and caches, and the number of
// right-hand sides that are solved at a time; a matrix is factored, and a pack of columns solved, by one thread. There
// are no fused products, and nothing depends on a time or an address. (Hence no BLAS: CHOLMOD's results change with the
// number of threads and with the processor. It also takes 1.2 to 4 times as long, see the benchmark `cholesky`.)

// What the matrices of one pattern have in common: the order of elimination and the places of the factor's entries.
//
// In the nested dissection of A. George (SIAM J. Numer. Anal. 10(2), 1973), the factor of a surface has O(N log N)
// entries - 35 N at N = 10,000, 75 N at a million -, and it takes O(N log N) time to find them.
class Symbolic_cholesky
{
public:
  typedef Compressed_rows::Index Index;

  // `neighbours`: for each row of the matrix the columns of its entries off the diagonal, in both triangles, without
  // duplicates. `points`: where the rows are, anything with three coordinates: how few entries the factor has depends
  // on them, what the solution is does not.
  template <class Point>
  Symbolic_cholesky(const Compressed_rows& neighbours, const std::vector<Point>& points)
    : Symbolic_cholesky(neighbours, Nested_dissection(neighbours, points).order())
  {}

  // `order`: the row that is eliminated first, and so on.
  Symbolic_cholesky(Compressed_rows neighbours, std::vector<Index> order)
    : m_neighbours(std::move(neighbours))
    , m_structure(m_neighbours, std::move(order))
  {}

  // N.
  std::size_t size() const { return m_neighbours.size(); }

  // A copy of the neighbours that were given.
  const Compressed_rows& neighbours() const { return m_neighbours; }

  // Numbers in a factor, a few zeros among them.
  std::size_t number_of_values() const { return m_structure.number_of_values(); }

  // The row that is eliminated first, and so on: the order in which right-hand sides are in memory.
  const std::vector<Index>& order() const { return m_structure.original(); }

  // The inverse of it.
  const std::vector<Index>& position() const { return m_structure.position(); }

  // For those who factor and solve.
  const Symbolic_factorization& structure() const { return m_structure; }

private:
  Compressed_rows m_neighbours;
  Symbolic_factorization m_structure;
};

// Columns of numbers, N x M, in packs: as many columns as numbers fit into a cache line, row after row in the order of
// elimination. Columns to spare in the last pack are solved with the others, whatever they hold.
template <class T>
class Right_hand_sides
{
public:
  static constexpr std::size_t pack_size = Triangular_solve<T>::pack_size;

  // All zero.
  Right_hand_sides(const Symbolic_cholesky& symbolic, std::size_t columns)
    : m_position(symbolic.position().data())
    , m_pack_stride((symbolic.size() + 1) * pack_size)
  {
    resize(columns);
  }

  // Columns that stay keep their values.
  void resize(std::size_t columns)
  {
    m_packs = (columns + pack_size - 1) / pack_size;
    m_values.resize(m_packs * m_pack_stride);
  }

  std::size_t number_of_packs() const { return m_packs; }

  // A row: pack(p) has its numbers in the columns [p * pack_size, (p + 1) * pack_size).
  template <class U>
  struct Row
  {
    U* first;
    std::size_t stride;
    U* pack(std::size_t p) const { return first + p * stride; }
    U& operator[](std::size_t column) const { return pack(column / pack_size)[column % pack_size]; }
  };

  // All rows, numbered as those of the matrix; valid until resize(). For loops that store to them: this is an object of
  // their own, which the compiler need not load again after each store.
  template <class U>
  struct Rows
  {
    U* values;
    std::size_t stride;
    const Symbolic_cholesky::Index* position;
    Row<U> operator[](std::size_t i) const { return {values + std::size_t(position[i]) * pack_size, stride}; }
  };
  Rows<T> rows() { return {m_values.data(), m_pack_stride, m_position}; }
  Rows<const T> rows() const { return {m_values.data(), m_pack_stride, m_position}; }

  T& operator()(std::size_t i, std::size_t column) { return rows()[i][column]; }
  T operator()(std::size_t i, std::size_t column) const { return rows()[i][column]; }

  // The pack p of the row that is eliminated first. Following that of the last row is one that stands for all rows that
  // do not exist.
  T* first_row(std::size_t p) { return m_values.data() + p * m_pack_stride; }

private:
  const Symbolic_cholesky::Index* m_position;
  std::size_t m_pack_stride;
  std::size_t m_packs = 0;
  Aligned_vector<T> m_values;
};

// The factor L of a matrix: computed in double, by the multifrontal method on dense blocks (J. W. H. Liu, SIAM Review
// 34(1), 1992), and kept as T, `float` or `double`, in which systems are solved.
//
// Time: O(N^1.5) operations for a factor, four operations a value of it for the solution of each column. Memory:
// `symbolic.number_of_values()` numbers of type T.
template <class T>
class Sparse_cholesky
{
public:
  // `symbolic`: of the matrix's pattern; is kept by reference. `diagonal(i)` and `entry(i, k)`, for the k-th of the
  // neighbours of row i, are the entries of the matrix, of which those of the lower triangle of P A P^T are asked for.
  // Throws Numerical_error if the matrix is not positive definite or has an entry that is not a number. With any
  // `instructions` of this processor the factor is the same.
  template <class Diagonal, class Entry>
  Sparse_cholesky(const Symbolic_cholesky& symbolic, const Diagonal& diagonal, const Entry& entry,
                  Instruction_set instructions = widest_instruction_set())
    : m_symbolic(&symbolic)
    , m_values(symbolic.number_of_values())
  {
    Multifrontal_factorization(symbolic.structure(), symbolic.neighbours(), instructions)
        .run(diagonal, entry, m_values.data());
  }

  const Symbolic_cholesky& symbolic() const { return *m_symbolic; }

  // Replaces B by A^-1 B. May be called by several threads at a time, with right-hand sides of their own.
  void solve(Right_hand_sides<T>& x, Instruction_set instructions = widest_instruction_set()) const
  {
    // Each part of the factor serves all of them while it is in the cache. Measured: with 2, systems of 100,000 rows
    // take a sixth longer, with 8 those of 10,000 a tenth to a fifth.
    constexpr std::size_t packs_at_once = 4;
    for (std::size_t p = 0; p < x.number_of_packs(); p += packs_at_once) {
      const std::size_t packs = (std::min)(packs_at_once, x.number_of_packs() - p);
      for (std::size_t i = p; i < p + packs; ++i)
        std::fill_n(x.first_row(i) + m_symbolic->size() * x.pack_size, x.pack_size, T(0));
      Triangular_solve<T> some{&m_symbolic->structure(), m_values.data(), x.first_row(p), packs};
      run_reproducibly<T>(instructions, some);
    }
  }

  // The diagonal of A^-1, N numbers in the order of the matrix's rows, computed in double without solving for any column;
  // see Selected_inverse. With any `instructions` they are the same.
  //
  // Takes twice the operations of the factorisation, on larger blocks: measured, up to a tenth longer with 4,000 to 65,000
  // rows. Memory: as the factorisation, no more than that of the factor again.
  std::vector<double> diagonal_of_inverse(Instruction_set instructions = widest_instruction_set()) const
  {
    return Selected_inverse(m_symbolic->structure(), instructions).diagonal(m_values.data());
  }

private:
  const Symbolic_cholesky* m_symbolic;
  Aligned_vector<T> m_values;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_SPARSE_CHOLESKY_SPARSE_CHOLESKY_H
