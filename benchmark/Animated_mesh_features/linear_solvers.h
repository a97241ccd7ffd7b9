// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_LINEAR_SOLVERS_H
#define CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_LINEAR_SOLVERS_H

#include "animations.h"

#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_system.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

// The linear systems of heat diffusion, and who solves them.

namespace Benchmark {

namespace Ai = Amf::internal;

const std::size_t right_hand_sides = 100;

// M + t L of a shape, and right-hand sides.
struct Heat_equation
{
  Amf::Compressed_rows neighbours;
  std::vector<Amf::Rest_shape::Point> points;
  std::vector<double> diagonal;
  std::vector<std::vector<double>> entries; // for each row those of its neighbours
  std::vector<double> right;                // [row][column]

  // A level that is three edge lengths smoother than the one before.
  explicit Heat_equation(const Amf::Rest_shape& shape)
    : neighbours(shape.neighbours())
    , points(shape.points())
  {
    const Ai::Heat_system heat(shape);
    const double variance = std::pow(3 * shape.mean_edge_length(), 2), t = (1 - 1 / std::sqrt(2.)) * variance / 2;
    for (std::size_t v = 0; v < heat.size(); ++v) {
      double sum = 0;
      entries.emplace_back();
      for (std::size_t k = 0; k < neighbours[v].size(); ++k) {
        sum += heat.weights(v)[k];
        entries.back().push_back(-t * heat.weights(v)[k]);
      }
      diagonal.push_back(heat.mass()[v] + t * sum);
    }
    std::uint32_t random = 1;
    right.resize(heat.size() * right_hand_sides);
    for (double& x : right) x = double(random = 1664525 * random + 1013904223) / 4294967296.;
  }

  std::size_t size() const { return diagonal.size(); }
};

// What solves all right-hand sides of a system, in three phases, each of which may be repeated.
class Solver
{
public:
  virtual ~Solver() = default;
  virtual void analyze() = 0;
  virtual void factor() = 0;
  virtual void solve() = 0;
  virtual double entries() const = 0; // of the factor
  virtual double solution(std::size_t row, std::size_t column) const = 0;
  virtual std::size_t matrices_at_once() const { return 1; } // that factor() factors
};

// The package's: on several threads a matrix on each, as with the levels of heat diffusion, and some columns on each.
template <class T>
class Package_solver : public Solver
{
  static constexpr std::size_t columns_per_task = 2 * Ai::Right_hand_sides<T>::pack_size;
  typedef CGAL::Parallel_if_available_tag Tag;

public:
  Package_solver(const Heat_equation& system, std::size_t threads)
    : m_system(system)
    , m_factors(threads)
    , m_solution(system.right.size())
  {}

  void analyze() override
  {
    m_symbolic = std::make_unique<Ai::Symbolic_cholesky>(m_system.neighbours, m_system.points);
    m_workspaces = std::make_unique<Ai::Thread_local<Ai::Right_hand_sides<T>>>();
  }

  void factor() override
  {
    for (auto& f : m_factors) f.reset();
    Amf::parallel_for<Tag>(0, m_factors.size(), [&](std::size_t i) {
      m_factors[i] = std::make_unique<Ai::Sparse_cholesky<T>>(
          *m_symbolic, [&](std::size_t v) { return m_system.diagonal[v]; },
          [&](std::size_t v, std::size_t k) { return m_system.entries[v][k]; });
    });
  }

  void solve() override
  {
    Amf::parallel_for<Tag>(0, (right_hand_sides + columns_per_task - 1) / columns_per_task, [&](std::size_t task) {
      const std::size_t first = task * columns_per_task, size = (std::min)(columns_per_task, right_hand_sides - first);
      auto& x =
          m_workspaces->get([&] { return std::make_unique<Ai::Right_hand_sides<T>>(*m_symbolic, columns_per_task); });
      x.resize(size);
      for (std::size_t v = 0; v < m_system.size(); ++v)
        for (std::size_t c = 0; c < size; ++c) x(v, c) = T(m_system.right[v * right_hand_sides + first + c]);
      m_factors.front()->solve(x);
      for (std::size_t v = 0; v < m_system.size(); ++v)
        for (std::size_t c = 0; c < size; ++c) m_solution[v * right_hand_sides + first + c] = x(v, c);
    });
  }

  double entries() const override { return double(m_symbolic->number_of_values()); }
  double solution(std::size_t row, std::size_t column) const override
  {
    return double(m_solution[row * right_hand_sides + column]);
  }
  std::size_t matrices_at_once() const override { return m_factors.size(); }

private:
  const Heat_equation& m_system;
  std::unique_ptr<Ai::Symbolic_cholesky> m_symbolic;
  std::vector<std::unique_ptr<Ai::Sparse_cholesky<T>>> m_factors;
  std::unique_ptr<Ai::Thread_local<Ai::Right_hand_sides<T>>> m_workspaces;
  std::vector<T> m_solution; // [row][column]
};

// CHOLMOD's supernodal factorisation, in double, the only type that it has before version 5.
class Cholmod_solver : public Solver
{
public:
  // ordering: CHOLMOD_METIS, CHOLMOD_AMD, or CHOLMOD_GIVEN for the package's.
  Cholmod_solver(const Heat_equation& system, int ordering)
    : m_system(system)
  {
    cholmod_start(&m_common);
    m_common.supernodal = CHOLMOD_SUPERNODAL;
    m_common.nmethods = 1;
    m_common.method[0].ordering = ordering;
    m_common.postorder = 1;
    make_matrix();
    m_right = cholmod_allocate_dense(system.size(), right_hand_sides, system.size(), CHOLMOD_REAL, &m_common);
    double* to = static_cast<double*>(m_right->x);
    for (std::size_t c = 0; c < right_hand_sides; ++c)
      for (std::size_t v = 0; v < system.size(); ++v) *to++ = system.right[v * right_hand_sides + c];
  }
  Cholmod_solver(const Cholmod_solver&) = delete;
  Cholmod_solver& operator=(const Cholmod_solver&) = delete;

  ~Cholmod_solver() override
  {
    cholmod_free_factor(&m_factor, &m_common);
    cholmod_free_sparse(&m_matrix, &m_common);
    for (cholmod_dense** x : {&m_right, &m_solution, &m_workspace[0], &m_workspace[1]})
      cholmod_free_dense(x, &m_common);
    cholmod_finish(&m_common);
  }

  void analyze() override
  {
    cholmod_free_factor(&m_factor, &m_common);
    if (m_common.method[0].ordering == CHOLMOD_GIVEN) {
      const Ai::Nested_dissection dissection(m_system.neighbours, m_system.points);
      std::vector<int> order(dissection.order().begin(), dissection.order().end());
      m_factor = cholmod_analyze_p(m_matrix, order.data(), nullptr, 0, &m_common);
    } else
      m_factor = cholmod_analyze(m_matrix, &m_common);
    if (m_factor == nullptr) throw std::runtime_error("CHOLMOD does not analyze the matrix");
  }

  void factor() override
  {
    if (!cholmod_factorize(m_matrix, m_factor, &m_common) || m_common.status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD does not factor the matrix");
  }

  void solve() override
  {
    if (!cholmod_solve2(CHOLMOD_A, m_factor, m_right, nullptr, &m_solution, nullptr, &m_workspace[0], &m_workspace[1],
                        &m_common))
      throw std::runtime_error("CHOLMOD does not solve the system");
  }

  double entries() const override { return double(m_factor->xsize); }
  double solution(std::size_t row, std::size_t column) const override
  {
    return static_cast<const double*>(m_solution->x)[column * m_system.size() + row];
  }

private:
  // The lower triangle, by columns.
  void make_matrix()
  {
    const std::size_t n = m_system.size();
    m_matrix = cholmod_allocate_sparse(n, n, n + m_system.neighbours.number_of_entries() / 2, 1, 1, -1, CHOLMOD_REAL,
                                       &m_common);
    int *offset = static_cast<int*>(m_matrix->p), *row = static_cast<int*>(m_matrix->i), count = 0;
    double* value = static_cast<double*>(m_matrix->x);
    const auto add = [&](std::size_t i, double x) {
      row[count] = int(i);
      value[count++] = x;
    };
    for (std::size_t v = 0; v < n; ++v) {
      offset[v] = count;
      add(v, m_system.diagonal[v]);
      for (std::size_t k = 0; k < m_system.neighbours[v].size(); ++k)
        if (m_system.neighbours[v].begin()[k] > v) add(m_system.neighbours[v].begin()[k], m_system.entries[v][k]);
    }
    offset[n] = count;
  }

  const Heat_equation& m_system;
  cholmod_common m_common;
  cholmod_sparse* m_matrix = nullptr;
  cholmod_factor* m_factor = nullptr;
  cholmod_dense *m_right = nullptr, *m_solution = nullptr, *m_workspace[2] = {};
};

// Eigen's own, column by column.
class Eigen_solver : public Solver
{
public:
  explicit Eigen_solver(const Heat_equation& system)
    : m_matrix(Eigen::Index(system.size()), Eigen::Index(system.size()))
    , m_right(Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          system.right.data(), Eigen::Index(system.size()), Eigen::Index(right_hand_sides)))
  {
    std::vector<Eigen::Triplet<double>> triplets;
    for (std::size_t v = 0; v < system.size(); ++v) {
      triplets.emplace_back(int(v), int(v), system.diagonal[v]);
      for (std::size_t k = 0; k < system.neighbours[v].size(); ++k)
        triplets.emplace_back(int(v), int(system.neighbours[v].begin()[k]), system.entries[v][k]);
    }
    m_matrix.setFromTriplets(triplets.begin(), triplets.end());
  }

  void analyze() override { m_solver.analyzePattern(m_matrix); }
  void factor() override { m_solver.factorize(m_matrix); }
  void solve() override { m_solution = m_solver.solve(m_right); }
  double entries() const override { return double(m_solver.matrixL().nestedExpression().nonZeros()); }
  double solution(std::size_t row, std::size_t column) const override
  {
    return m_solution(Eigen::Index(row), Eigen::Index(column));
  }

private:
  Eigen::SparseMatrix<double> m_matrix;
  Eigen::MatrixXd m_right, m_solution;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_solver;
};

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_BENCHMARK_LINEAR_SOLVERS_H
