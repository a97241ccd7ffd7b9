// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The sparse factorisation, the diagonal of the inverse and the solves of heat diffusion against dense matrices, for graphs
// of all kinds, and the same bits with any vector instructions and any number of right-hand sides at a time.

#include "test_shapes.h"

#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/Nested_dissection.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/internal/minimum_degree_order.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_step.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
namespace Ai = CGAL::Animated_mesh_features::internal;
using namespace test_support;

typedef std::vector<std::set<std::uint32_t>> Graph;

void join(Graph& graph, std::size_t a, std::size_t b)
{
  if (a == b) return;
  graph[a].insert(std::uint32_t(b));
  graph[b].insert(std::uint32_t(a));
}

Amf::Compressed_rows rows_of(const Graph& graph)
{
  Amf::Compressed_rows rows;
  for (const auto& row : graph) rows.push_back(row.begin(), row.end());
  return rows;
}

// A positive definite matrix with entries where the graph has edges.
Eigen::MatrixXd matrix_of(const Graph& graph, Random& random)
{
  const Eigen::Index n = Eigen::Index(graph.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    a(i, i) += random.power(0.01, 1);
    for (std::uint32_t j : graph[std::size_t(i)])
      if (Eigen::Index(j) < i) {
        const double x = random(-1, 0.3), y = std::abs(x) * random.power(0.5, 2);
        a(i, j) = a(j, i) = x;
        a(i, i) += y;
        a(j, j) += x * x / y;
      }
  }
  return a;
}

std::vector<Ai::Instruction_set> instruction_sets()
{
  std::vector<Ai::Instruction_set> sets = {Ai::Instruction_set::BASELINE};
  if (Ai::widest_instruction_set() >= Ai::Instruction_set::AVX2) sets.push_back(Ai::Instruction_set::AVX2);
  if (Ai::widest_instruction_set() == Ai::Instruction_set::AVX512) sets.push_back(Ai::Instruction_set::AVX512);
  return sets;
}

template <class T>
Eigen::MatrixXd solved(const Ai::Sparse_cholesky<T>& factor, const Eigen::MatrixXd& b, std::size_t packs,
                       Ai::Instruction_set instructions)
{
  const std::size_t n = factor.symbolic().size(), columns = packs * Ai::Right_hand_sides<T>::pack_size;
  Ai::Right_hand_sides<T> x(factor.symbolic(), columns);
  CHECK(x.number_of_packs() == packs);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < columns; ++c) x(i, c) = T(b(Eigen::Index(i), Eigen::Index(c) % b.cols()));
  factor.solve(x, instructions);
  Eigen::MatrixXd result(b.rows(), b.cols());
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    for (Eigen::Index c = 0; c < b.cols(); ++c) result(i, c) = double(x(std::size_t(i), std::size_t(c)));
  return result;
}

// Against columns of the identity that are solved for, and against another factorisation.
void test_diagonal_of_inverse(const Eigen::MatrixXd& a, const Ai::Sparse_cholesky<double>& factor,
                              const std::vector<double>& inverse, const std::vector<double>& single_inverse)
{
  const Eigen::Index n = a.rows();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n), dense = a.llt().solve(identity);
  const std::size_t packs = (std::size_t(n) + Ai::Right_hand_sides<double>::pack_size - 1) /
                            Ai::Right_hand_sides<double>::pack_size;
  const Eigen::MatrixXd columns = solved(factor, identity, packs, Ai::Instruction_set::BASELINE);
  const double condition = a.norm() * dense.norm();
  double error = 0, dense_error = 0, single_error = 0;
  CHECK(inverse.size() == std::size_t(n) && single_inverse.size() == std::size_t(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = inverse[std::size_t(i)];
    error = (std::max)(error, std::abs(x / columns(i, i) - 1));
    dense_error = (std::max)(dense_error, std::abs(x / dense(i, i) - 1));
    single_error = (std::max)(single_error, std::abs(single_inverse[std::size_t(i)] / dense(i, i) - 1));
  }
  CHECK(error < 1e-12);
  CHECK(dense_error < 1e-10);
  CHECK(single_error < 1e-7 * condition);
}

bool is_permutation_of_all(std::vector<std::uint32_t> order)
{
  std::vector<std::uint32_t> all(order.size());
  std::iota(all.begin(), all.end(), 0u);
  std::sort(order.begin(), order.end());
  return order == all;
}

void test_order(const std::string& name, const Graph& graph, const Amf::Compressed_rows& rows,
                const std::vector<std::uint32_t>& order, Random& random)
{
  const std::size_t n = graph.size();
  CHECK(order.size() == n && is_permutation_of_all(order));
  const Ai::Symbolic_cholesky symbolic(rows, order);
  CHECK(symbolic.size() == n && is_permutation_of_all(symbolic.order()));
  // every column once, in panels of bounded width; rows below them, ascending
  const Ai::Symbolic_factorization& structure = symbolic.structure();
  CHECK(structure.number_of_columns() == n);
  std::size_t next = 0, widest = 0;
  bool is_sound = true;
  for (const auto& p : structure.panels()) {
    is_sound = is_sound && p.first == next && p.width > 0 && p.width <= Ai::Cholesky_panel::widest;
    next += p.width;
    widest = (std::max)(widest, std::size_t(p.width));
    const auto* below = structure.rows(p);
    for (std::size_t i = 0; i < p.height; ++i)
      is_sound = is_sound && below[i] >= (i > 0 ? below[i - 1] + 1 : next) && below[i] < n;
  }
  CHECK(is_sound && next == n);

  const Eigen::MatrixXd a = matrix_of(graph, random);
  Eigen::MatrixXd b(Eigen::Index(n), 5);
  for (Eigen::Index i = 0; i < b.size(); ++i) b(i) = random(-1, 1);
  const Eigen::MatrixXd exact = a.llt().solve(b);
  const double scale = exact.cwiseAbs().maxCoeff() * a.norm() * a.inverse().norm();
  const auto diagonal = [&](std::size_t v) { return a(Eigen::Index(v), Eigen::Index(v)); };
  const auto entry = [&](std::size_t v, std::size_t k) { return a(Eigen::Index(v), Eigen::Index(rows[v].begin()[k])); };
  Eigen::MatrixXd first, first_single;
  std::vector<double> inverse, single_inverse;
  double error = 0, single_error = 0;
  for (Ai::Instruction_set instructions : instruction_sets()) {
    const Ai::Sparse_cholesky<double> factor(symbolic, diagonal, entry, instructions);
    const Ai::Sparse_cholesky<float> single(symbolic, diagonal, entry, instructions);
    for (std::size_t packs : {1, 2, 3}) {
      const Eigen::MatrixXd x = solved(factor, b, packs, instructions);
      const Eigen::MatrixXd y = solved(single, b, packs, instructions);
      if (first.size() == 0) {
        first = x;
        first_single = y;
        error = (x - exact).cwiseAbs().maxCoeff() / scale;
        single_error = (y - exact).cwiseAbs().maxCoeff() / scale;
      }
      CHECK(x == first && y == first_single); // the same bits
    }
    if (inverse.empty()) {
      inverse = factor.diagonal_of_inverse(instructions);
      single_inverse = single.diagonal_of_inverse(instructions);
      test_diagonal_of_inverse(a, factor, inverse, single_inverse);
    }
    CHECK(factor.diagonal_of_inverse(instructions) == inverse);
    CHECK(single.diagonal_of_inverse(instructions) == single_inverse);
  }
  CHECK(error < 1e-16);
  CHECK(single_error < 1e-7);
  CHECK(single_error > 0 || n < 3);
  std::cout << name << ": " << n << " columns, " << structure.panels().size() << " panels up to " << widest
            << " wide; error / condition " << error << ", in float " << single_error << std::endl;
}

// points: where they are, any if there are none.
void test_graph(const std::string& name, const Graph& graph, std::vector<Vec> points, Random& random)
{
  const Amf::Compressed_rows rows = rows_of(graph);
  while (points.size() < graph.size()) { // some at the same place
    const double x = random(-1, 1);
    points.insert(points.end(), 1 + random.below(3), Vec(x, random(-1, 1), 0));
  }
  points.resize(graph.size());
  test_order(name + ", minimum degree", graph, rows, Ai::minimum_degree_order(rows), random);
  test_order(name + ", dissected", graph, rows, Ai::Nested_dissection(rows, points, 6).order(), random);
}

void test_graphs()
{
  Random random(81);
  test_graph("a vertex", Graph(1), {}, random);
  test_graph("vertices without edges", Graph(7), {}, random);
  for (std::size_t n : {2, 3, 5, 8, 13, 67, 200}) { // panels are cut where they are wider than 64
    Graph complete(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j) join(complete, i, j);
    test_graph("complete graph", complete, {}, random);
  }
  Graph path(50), star(30);
  for (std::size_t i = 1; i < 50; ++i) join(path, i, i - 1);
  for (std::size_t i = 1; i < 30; ++i) join(star, 0, i);
  test_graph("path", path, {}, random);
  test_graph("star", star, {}, random);
  for (int repeat = 0; repeat < 12; ++repeat) { // some with many components, some that fill up
    Graph sparse(std::size_t(40 + 20 * repeat));
    const std::size_t edges = std::size_t(double(sparse.size()) * random.power(0.3, 4));
    for (std::size_t i = 0; i < edges; ++i) join(sparse, random.below(sparse.size()), random.below(sparse.size()));
    test_graph("random graph", sparse, {}, random);
  }
  Shape s = irregular_square(17, random);
  s.add(sphere(2), Vec(3, 0, 0));
  s.points.emplace_back(0, 0, 9);
  Graph mesh(s.points.size());
  for (const auto& f : s.faces)
    for (int i = 0; i < 3; ++i) join(mesh, std::size_t(f[std::size_t(i)]), std::size_t(f[std::size_t((i + 1) % 3)]));
  test_graph("mesh", mesh, s.points, random);
}

void test_indefinite()
{
  Graph graph(3);
  join(graph, 0, 1);
  join(graph, 1, 2);
  const Amf::Compressed_rows rows = rows_of(graph);
  const Ai::Symbolic_cholesky symbolic(rows, std::vector<std::uint32_t>{0, 1, 2});
  const auto factor = [&](double d) {
    return Ai::Sparse_cholesky<double>(
        symbolic, [&](std::size_t) { return d; }, [](std::size_t, std::size_t) { return 1.; },
        Ai::Instruction_set::BASELINE);
  };
  factor(1.5); // the smallest eigenvalue is d - sqrt(2)
  CHECK_THROWS(Amf::Numerical_error, factor(1.4), "positive definite");
  CHECK_THROWS(Amf::Numerical_error, factor(std::nan("")), "positive definite");
}

// Entries of the factor of a square of m x m vertices with diagonals, cut down to a few vertices: fewer than A. George's
// 31/4 n log2 n, and about as few as with minimum degree, which is at its best for such sizes.
void test_fill()
{
  for (std::size_t m : {30, 90, 200}) {
    const std::size_t n = m * m;
    Graph graph(n);
    std::vector<Vec> points;
    for (std::size_t i = 0; i < n; ++i) {
      points.emplace_back(double(i % m), 0.3, -double(i / m) / 3);
      if (i % m > 0) join(graph, i, i - 1);
      if (i >= m) join(graph, i, i - m);
      if (i % m > 0 && i >= m) join(graph, i, i - m - 1);
    }
    const Amf::Compressed_rows rows = rows_of(graph);
    const std::vector<std::uint32_t> order = Ai::Nested_dissection(rows, points, 20).order();
    const double entries = double(Ai::Symbolic_cholesky(rows, order).number_of_values()) / double(n);
    const double by_degree =
        double(Ai::Symbolic_cholesky(rows, Ai::minimum_degree_order(rows)).number_of_values()) / double(n);
    std::cout << "square of " << n << ": " << entries << " entries a column, minimum degree " << by_degree << std::endl;
    CHECK(entries < 31. / 4 * std::log2(double(n)) && entries < 1.05 * by_degree);
    // the separator of the first cut, one line, comes last
    std::set<std::uint32_t> last;
    for (std::size_t i = n - m; i < n; ++i) last.insert(order[i] % std::uint32_t(m));
    std::set<std::uint32_t> last_rows;
    for (std::size_t i = n - m; i < n; ++i) last_rows.insert(order[i] / std::uint32_t(m));
    CHECK(last.size() == 1 || last_rows.size() == 1);
    // the same for a body twice as large elsewhere
    std::vector<Vec> others = points;
    for (Vec& p : others) p = 2 * p + Vec(5, -3, 8);
    CHECK(Ai::Nested_dissection(rows, others, 20).order() == order);
    // all at one place: no cut
    const std::vector<Vec> heap(n, Vec(1, 2, 3));
    CHECK(Ai::Nested_dissection(rows, heap, 20).order() == Ai::minimum_degree_order(rows));
  }
}

// The diagonal of the inverse of a matrix that is too large for dense ones, with deep dissections, in some rows.
void test_large_inverse()
{
  const Shape s = sphere(5);
  const Amf::Rest_shape shape = rest_shape_of(s);
  const Ai::Heat_system system(shape);
  const std::size_t n = system.size();
  for (double t : {1e-3, 1.}) {
    const auto factor = system.factor<double>(t, Ai::widest_instruction_set());
    const std::vector<double> inverse = factor.diagonal_of_inverse();
    Ai::Right_hand_sides<double> x(system.symbolic(), 16);
    const auto row = [&](std::size_t c) { return c < 8 ? c * n / 8 : system.symbolic().order()[n - 1 - 9 * (c - 8)]; };
    for (std::size_t c = 0; c < 16; ++c) x(row(c), c) = 1;
    factor.solve(x);
    double error = 0;
    for (std::size_t c = 0; c < 16; ++c) error = (std::max)(error, std::abs(inverse[row(c)] / x(row(c), c) - 1));
    CHECK(inverse.size() == n && error < 1e-11);
    std::cout << "inverse of " << n << " rows, t = " << t << ": error " << error << std::endl;
  }
}

// A step of heat diffusion: the same bits with any instructions, and for a frame among any others.
template <class T>
void test_heat_step()
{
  Random random(82);
  Shape s = irregular_square(13, random, 0.35);
  s.add(tube(7, 5, 2), Vec(3, 0, 0));
  s.points.emplace_back(0, 0, 9);
  const Amf::Rest_shape shape = rest_shape_of(s);
  const Ai::Heat_system system(shape);
  const std::size_t n = system.size();
  Amf::Spatio_temporal_field<double> all(n, 130);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t f = 0; f < 130; ++f) all(v, f) = random(-1, 2);
  const double t = 0.01;
  Amf::Spatio_temporal_field<double> expected;
  for (Ai::Instruction_set instructions : instruction_sets()) {
    const auto factor = system.factor<T>(t, instructions);
    for (std::size_t frames : {130, 1, 3, 8, 9, 16, 17, 24, 31, 48, 100}) {
      Amf::Spatio_temporal_field<double> in(n, frames), out(n, frames);
      for (std::size_t v = 0; v < n; ++v) std::copy_n(all.row(v), frames, in.row(v));
      Ai::Heat_source source{system, t, in, out, 0, n};
      Ai::run_reproducibly<double>(instructions, source);
      const Ai::Heat_step<T> step(system, factor, in, out);
      for (std::size_t first = 0; first < step.number_of_packs();) {
        const std::size_t packs = (std::min)(frames % 3 + 1, step.number_of_packs() - first);
        typename Ai::Heat_step<T>::Workspace workspace(system, packs);
        for (auto* x : {&workspace.change, &workspace.next}) // what is left from elsewhere does not matter
          for (std::size_t p = 0; p < packs; ++p)
            std::fill_n(x->first_row(p), (n + 1) * x->pack_size, T(random(-1e6, 1e6)));
        step(first, packs, workspace, instructions);
        first += packs;
      }
      if (expected.number_of_rows() == 0) expected = out;
      bool same = true;
      for (std::size_t v = 0; v < n; ++v)
        for (std::size_t f = 0; f < frames; ++f) same = same && out(v, f) == expected(v, f);
      CHECK(same);
    }
  }
}

int main()
{
  test_graphs();
  test_indefinite();
  test_fill();
  test_large_inverse();
  test_heat_step<double>();
  test_heat_step<float>();
  return test_result();
}
