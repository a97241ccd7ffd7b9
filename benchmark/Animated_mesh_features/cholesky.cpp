// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The package's sparse Cholesky factorisation against CHOLMOD's and Eigen's, on the matrices of heat diffusion: whether
// the package had better use one of them. And whether the small factorisation of geodesic balls had better be the same.

#include "animations.h"
#include "benchmark_support.h"

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Patch_factors.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Surface_patch.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/internal/Vertex_clusters.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>
#include <CGAL/Animated_mesh_features/Numerics/sparse_cholesky/Sparse_cholesky.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_system.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cholmod.h>
#include <dlfcn.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace Benchmark;

namespace {

namespace Ai = Amf::internal;
typedef Amf::Rest_shape Rest_shape;

const std::size_t columns = 100;

// ------------------------------------------------------------------------------------------------- the linear systems

// M + t L of a shape, and right-hand sides.
struct System
{
  Amf::Compressed_rows neighbours;
  std::vector<Rest_shape::Point> points;
  std::vector<double> diagonal;
  std::vector<std::vector<double>> entries; // for each row those of its neighbours
  std::vector<double> right;                // [row][column]

  // A level that is three edge lengths smoother than the one before.
  explicit System(const Rest_shape& shape)
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
    right.resize(heat.size() * columns);
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

// The package's: on several threads one matrix on each, as the levels of heat diffusion are, and some columns on each.
template <class T>
class Package_solver : public Solver
{
  static constexpr std::size_t columns_per_task = 2 * Ai::Right_hand_sides<T>::pack_size;
  typedef CGAL::Parallel_if_available_tag Tag;

public:
  Package_solver(const System& system, std::size_t threads)
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
    Amf::parallel_for<Tag>(0, (columns + columns_per_task - 1) / columns_per_task, [&](std::size_t task) {
      const std::size_t first = task * columns_per_task, size = (std::min)(columns_per_task, columns - first);
      auto& x =
          m_workspaces->get([&] { return std::make_unique<Ai::Right_hand_sides<T>>(*m_symbolic, columns_per_task); });
      x.resize(size);
      for (std::size_t v = 0; v < m_system.size(); ++v)
        for (std::size_t c = 0; c < size; ++c) x(v, c) = T(m_system.right[v * columns + first + c]);
      m_factors.front()->solve(x);
      for (std::size_t v = 0; v < m_system.size(); ++v)
        for (std::size_t c = 0; c < size; ++c) m_solution[v * columns + first + c] = x(v, c);
    });
  }

  double entries() const override { return double(m_symbolic->number_of_values()); }
  double solution(std::size_t row, std::size_t column) const override
  {
    return double(m_solution[row * columns + column]);
  }
  std::size_t matrices_at_once() const override { return m_factors.size(); }

private:
  const System& m_system;
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
  Cholmod_solver(const System& system, int ordering)
    : m_system(system)
  {
    cholmod_start(&m_common);
    m_common.supernodal = CHOLMOD_SUPERNODAL;
    m_common.nmethods = 1;
    m_common.method[0].ordering = ordering;
    m_common.postorder = 1;
    make_matrix();
    m_right = cholmod_allocate_dense(system.size(), columns, system.size(), CHOLMOD_REAL, &m_common);
    double* to = static_cast<double*>(m_right->x);
    for (std::size_t c = 0; c < columns; ++c)
      for (std::size_t v = 0; v < system.size(); ++v) *to++ = system.right[v * columns + c];
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

  const System& m_system;
  cholmod_common m_common;
  cholmod_sparse* m_matrix = nullptr;
  cholmod_factor* m_factor = nullptr;
  cholmod_dense *m_right = nullptr, *m_solution = nullptr, *m_workspace[2] = {};
};

// Eigen's own, column by column.
class Eigen_solver : public Solver
{
public:
  explicit Eigen_solver(const System& system)
    : m_matrix(Eigen::Index(system.size()), Eigen::Index(system.size()))
    , m_right(Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          system.right.data(), Eigen::Index(system.size()), Eigen::Index(columns)))
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

// ------------------------------------------------------------------------------------------------------------ threads

// OpenBLAS has functions for these; of any other nothing is known.
void set_blas_threads(int threads)
{
  if (void* f = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<void (*)(int)>(f)(threads);
}

std::string blas()
{
  void* f = dlsym(RTLD_DEFAULT, "openblas_get_config");
  return f ? reinterpret_cast<char* (*)()>(f)() : "a BLAS that is not OpenBLAS";
}

// Keeps this process, and all threads that it makes from now on, on so many cores.
void use_cores(std::size_t number)
{
  cpu_set_t all, some;
  CPU_ZERO(&some);
  if (sched_getaffinity(0, sizeof all, &all) != 0) return;
  for (int i = 0; i < CPU_SETSIZE && number > 0; ++i)
    if (CPU_ISSET(i, &all)) {
      CPU_SET(i, &some);
      --number;
    }
  sched_setaffinity(0, sizeof some, &some);
}

// ------------------------------------------------------------------------------------------------ measuring the solvers

struct Method
{
  std::string name;
  std::function<std::unique_ptr<Solver>(std::size_t threads)> make;
};

std::vector<Method> methods(const System& system)
{
  std::vector<Method> result = {
      {"Sparse_cholesky<double>",
       [&](std::size_t threads) { return std::make_unique<Package_solver<double>>(system, threads); }},
      {"Sparse_cholesky<float>",
       [&](std::size_t threads) { return std::make_unique<Package_solver<float>>(system, threads); }},
      {"CHOLMOD, METIS", [&](std::size_t) { return std::make_unique<Cholmod_solver>(system, CHOLMOD_METIS); }},
      {"CHOLMOD, AMD", [&](std::size_t) { return std::make_unique<Cholmod_solver>(system, CHOLMOD_AMD); }},
      {"CHOLMOD, the package's order",
       [&](std::size_t) { return std::make_unique<Cholmod_solver>(system, CHOLMOD_GIVEN); }}};
  if (system.size() < 20000)
    result.push_back({"Eigen::SimplicialLLT", [&](std::size_t) { return std::make_unique<Eigen_solver>(system); }});
  return result;
}

// Of the bits of the solution, as a whole number that a double holds.
double checksum(const Solver& solver, std::size_t rows)
{
  std::uint64_t sum = 1469598103934665603u;
  for (std::size_t v = 0; v < rows; ++v)
    for (std::size_t c = 0; c < columns; ++c) {
      const double x = solver.solution(v, c);
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      sum = (sum ^ bits) * 1099511628211u;
    }
  return double(sum >> 12);
}

double largest_difference(const Solver& a, const Solver& b, std::size_t rows)
{
  double largest = 0, difference = 0;
  for (std::size_t v = 0; v < rows; ++v)
    for (std::size_t c = 0; c < columns; ++c) {
      largest = (std::max)(largest, std::abs(a.solution(v, c)));
      difference = (std::max)(difference, std::abs(a.solution(v, c) - b.solution(v, c)));
    }
  return difference / largest;
}

// All that is measured with some number of threads: "<number of the method>_<what>" and a value.
std::map<std::string, double> measure(const System& system, std::size_t threads, const Repetitions& r)
{
  use_cores(threads);
  set_blas_threads(int(threads));
  const Thread_limit limit(threads);
  std::vector<std::unique_ptr<Solver>> solvers;
  for (const Method& m : methods(system)) solvers.push_back(m.make(threads));
  const auto seconds = [&](void (Solver::*phase)()) {
    std::vector<std::function<void()>> functions;
    for (auto& s : solvers) functions.push_back([&s, phase] { ((*s).*phase)(); });
    return least_seconds(functions, r);
  };
  const std::vector<double> analysis = seconds(&Solver::analyze), factor = seconds(&Solver::factor),
                            solve = seconds(&Solver::solve);
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < solvers.size(); ++i) {
    const auto at = [&](const char* what) -> double& { return result[std::to_string(i) + "_" + what]; };
    at("analysis") = analysis[i];
    at("factor") = factor[i] / double(solvers[i]->matrices_at_once());
    at("solve") = solve[i];
    at("entries") = solvers[i]->entries() / double(system.size());
    at("checksum") = checksum(*solvers[i], system.size());
    at("difference") = largest_difference(*solvers[0], *solvers[i], system.size());
  }
  return result;
}

void compare_solvers(const std::string& name, const Rest_shape& shape, const Arguments& arguments, Table& table)
{
  const System system(shape);
  Repetitions r = repetitions(arguments);
  if (system.size() > 500000) r.least = 2;
  std::map<std::string, double> one; // thread
  for (std::size_t threads : thread_counts()) {
    auto values = in_child_process([&] { return measure(system, threads, r); });
    if (threads == 1) one = values;
    const std::vector<Method> all = methods(system);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto at = [&](const char* what) { return values[std::to_string(i) + "_" + what]; };
      const bool same = at("checksum") == one[std::to_string(i) + "_checksum"];
      table.add(name, system.size(), all[i].name, threads, at("entries"), 1000 * at("analysis"), 1000 * at("factor"),
                1000 * at("solve"), at("factor") / values["0_factor"], at("solve") / values["0_solve"],
                threads == 1 ? Cell() : Cell(same ? "yes" : "no"), at("difference"));
    }
  }
}

// ------------------------------------------------------------------------------------------------- patches of the balls

// The two matrices of the heat method on a patch, M + L and L, in units of its edges.
struct Patch_system
{
  Ai::Patch_factors::Pattern pattern;
  std::vector<Ai::Patch_factors::Pair> diagonal, values;
  Amf::Compressed_rows neighbours;
  std::vector<Rest_shape::Point> points;
  std::vector<std::size_t> sources;

  Patch_system(const Ai::Surface_patch& patch, double unit)
    : diagonal(patch.number_of_vertices(), Ai::Patch_factors::Pair::Zero())
    , points(patch.points())
  {
    for (std::size_t v = 0; v < patch.number_of_vertices(); ++v) {
      std::vector<Rest_shape::Index> row;
      for (const auto& w : patch.neighbours(v)) row.push_back(w.vertex);
      std::sort(row.begin(), row.end());
      neighbours.push_back(row.begin(), row.end());
      pattern.columns.insert(pattern.columns.end(), row.begin(), row.end());
      pattern.offsets.push_back(int(pattern.columns.size()));
    }
    values.assign(pattern.columns.size(), Ai::Patch_factors::Pair::Zero());
    for (const Rest_shape::Triangle& corner : patch.triangles())
      for (std::size_t i = 0; i < 3; ++i) {
        const Rest_shape::Index v = corner[i], a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
        const Rest_shape::Point p = (points[a] - points[v]) / unit, q = (points[b] - points[v]) / unit;
        const double area = p.cross(q).norm() / 2, weight = p.dot(q) / (4 * area);
        diagonal[v][0] += area / 3;
        diagonal[a] += weight;
        diagonal[b] += weight;
        values[entry(a, b)] -= weight;
        values[entry(b, a)] -= weight;
      }
  }

  std::size_t entry(Rest_shape::Index v, Rest_shape::Index w) const
  {
    const auto first = pattern.columns.begin() + pattern.offsets[v];
    return std::size_t(std::find(first, pattern.columns.begin() + pattern.offsets[v + 1], int(w)) -
                       pattern.columns.begin());
  }
};

std::vector<Patch_system> patches_of_balls(const Rest_shape& shape, double radius, std::size_t number)
{
  const Amf::Heat_method_geodesic_balls balls;
  const double margin = balls.patch_margin * shape.mean_edge_length();
  const Amf::Compressed_rows clusters = Ai::Vertex_clusters(shape, balls.cluster_radius * (radius + margin)).rows();
  std::vector<Patch_system> patches;
  Ai::Bounded_dijkstra dijkstra(shape);
  Ai::Surface_patch patch(shape);
  const std::size_t step = (std::max)(std::size_t(1), clusters.size() / number);
  for (std::size_t c = 0; c < clusters.size(); c += step) {
    patch.set(dijkstra.run(clusters[c], radius + margin));
    patches.emplace_back(patch, shape.mean_edge_length());
    for (Rest_shape::Index v : clusters[c]) patches.back().sources.push_back(patch.number(v));
  }
  return patches;
}

// calls f(first source, last source) for each pack of sources.
template <class Function>
void for_each_pack(const Patch_system& p, const Function& f)
{
  for (std::size_t first = 0; first < p.sources.size(); first += Ai::Source_pack::size)
    f(first, (std::min)(first + Ai::Source_pack::size, p.sources.size()));
}

void solve_patch(const Ai::Patch_factors& factors, const Patch_system& p, Ai::Source_pack::Rows& x,
                 std::vector<char>& marks, std::vector<char>& all)
{
  const std::size_t n = factors.size();
  all.assign(n, 1);
  for_each_pack(p, [&](std::size_t first, std::size_t last) {
    x.assign(n, Ai::Source_pack::Array::Zero());
    marks.assign(n, 0);
    for (std::size_t s = first; s < last; ++s) {
      x[std::size_t(factors.position(p.sources[s]))][Eigen::Index(s - first)] = 1;
      marks[std::size_t(factors.position(p.sources[s]))] = 1;
    }
    factors.mark_ancestors(marks);
    factors.solve_lower(Ai::Patch_factors::HEAT, x, marks);
    factors.solve_upper(Ai::Patch_factors::HEAT, x, all);
    factors.solve_lower(Ai::Patch_factors::DISTANCE, x, all);
    factors.solve_upper(Ai::Patch_factors::DISTANCE, x, marks);
  });
}

struct Patch_choleskies
{
  std::unique_ptr<Ai::Symbolic_cholesky> symbolic;
  std::unique_ptr<Ai::Sparse_cholesky<double>> factor[2];
};

// The Laplacian is singular; a little mass makes it definite.
void factor_patch(const Patch_system& p, Patch_choleskies& c)
{
  c.symbolic = std::make_unique<Ai::Symbolic_cholesky>(p.neighbours, p.points);
  for (std::size_t w : {0u, 1u})
    c.factor[w] = std::make_unique<Ai::Sparse_cholesky<double>>(
        *c.symbolic, [&](std::size_t v) { return p.diagonal[v][Eigen::Index(w)] + (w == 1 ? 1e-6 : 0.); },
        [&](std::size_t v, std::size_t k) { return p.values[std::size_t(p.pattern.offsets[v]) + k][Eigen::Index(w)]; });
}

void solve_patch(const Patch_choleskies& c, const Patch_system& p, Ai::Right_hand_sides<double>& x)
{
  for_each_pack(p, [&](std::size_t first, std::size_t last) {
    std::fill_n(x.first_row(0), c.symbolic->size() * x.pack_size, 0.);
    for (std::size_t s = first; s < last; ++s) x(p.sources[s], s - first) = 1;
    c.factor[0]->solve(x);
    c.factor[1]->solve(x);
  });
}

void compare_patches(const Rest_shape& shape, const Arguments& arguments, Table& table)
{
  for (double edges : {3., 8.}) {
    const std::vector<Patch_system> patches =
        patches_of_balls(shape, edges * shape.mean_edge_length(), arguments.quick ? 3 : 30);
    std::vector<Ai::Patch_factors> own(patches.size());
    std::vector<Patch_choleskies> same(patches.size());
    Ai::Source_pack::Rows rows;
    std::vector<char> marks, all;
    double vertices = 0, sources = 0;
    for (const Patch_system& p : patches) {
      vertices += double(p.diagonal.size());
      sources += double(p.sources.size());
    }
    const auto factor_own = [&] {
      for (std::size_t i = 0; i < patches.size(); ++i)
        own[i].factorize(patches[i].pattern, patches[i].diagonal, patches[i].values);
    };
    const auto factor_same = [&] {
      for (std::size_t i = 0; i < patches.size(); ++i) factor_patch(patches[i], same[i]);
    };
    const std::vector<double> factor = least_seconds({factor_own, factor_same}, repetitions(arguments));
    std::vector<Ai::Right_hand_sides<double>> x;
    for (const Patch_choleskies& c : same) x.emplace_back(*c.symbolic, Ai::Source_pack::size);
    const std::vector<double> solve = least_seconds({[&] {
                                                       for (std::size_t i = 0; i < patches.size(); ++i)
                                                         solve_patch(own[i], patches[i], rows, marks, all);
                                                     },
                                                     [&] {
                                                       for (std::size_t i = 0; i < patches.size(); ++i)
                                                         solve_patch(same[i], patches[i], x[i]);
                                                     }},
                                                    repetitions(arguments));
    const double n = double(patches.size());
    for (std::size_t i = 0; i < 2; ++i)
      table.add(edges, vertices / n, sources / n, i == 0 ? "Patch_factors" : "Sparse_cholesky<double>",
                1e6 * factor[i] / n, 1e6 * solve[i] / n, 1e6 * (factor[i] + solve[i]) / sources,
                (factor[i] + solve[i]) / (factor[0] + solve[0]));
  }
}

} // namespace

int main(int argc, char* argv[])
{
  return run("cholesky", argc, argv, [](const Arguments& arguments, Report& report) {
    limit_before_child_processes() = std::make_unique<Thread_limit>(1);
    Table table(
        "Sparse factorisation",
        "M + t L of a level of heat diffusion, 3 mean edge lengths smoother than the one before; larger meshes "
        "are smaller ones with their edges split in the middle. Order: with what follows from the pattern alone. "
        "100 solves: 100 right-hand sides, from where they are and back. With several threads the package "
        "factors as many matrices, and the time is that of one of them; CHOLMOD hands its threads to the BLAS. "
        "CHOLMOD " +
            std::to_string(CHOLMOD_MAIN_VERSION) + "." + std::to_string(CHOLMOD_SUB_VERSION) + "." +
            std::to_string(CHOLMOD_SUBSUB_VERSION) + ", supernodal, double (it has no float), with " + blas() +
            ". Same bits: of the solution, as with one thread. Difference: the largest, from the first row's "
            "solution, relative to the largest value.",
        {"mesh", "N", "solver", "threads", "entries / N", "order ms", "factor ms", "100 solves ms",
         "factor / package, double", "solves / package, double", "same bits", "difference"});
    const auto add = [&](const std::string& name, const Mesh& mesh) {
      compare_solvers(name, rest_shape(mesh), arguments, table);
    };
    if (has_horse(arguments)) add("horse", horse(arguments).animation.mesh);
    add("figure", figure(arguments.quick ? 1500 : 10000, 3).animation.mesh);
    if (!arguments.quick) {
      add("figure", subdivided(figure(25000, 3).animation.mesh));
      add("figure", subdivided(subdivided(figure(62500, 3).animation.mesh)));
    }
    report.add(table);

    Table patches(
        "Factorisations on the patches of geodesic balls",
        "Two matrices of one pattern, M + L and L, and two solves for each vertex of a cluster, eight at a time; "
        "one thread, figure. The package's balls have Patch_factors, which factors both matrices together, "
        "takes a matrix that is singular, and leaves out rows that nobody asks for.",
        {"radius / edge", "vertices of a patch", "sources", "method", "order, factor us", "solve us", "us a source",
         "this / Patch_factors"});
    compare_patches(rest_shape(figure(arguments.quick ? 1500 : 10000, 3).animation.mesh), arguments, patches);
    report.add(patches);
  });
}
