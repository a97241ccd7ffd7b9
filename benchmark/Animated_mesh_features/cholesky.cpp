// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The package's sparse Cholesky factorisation against CHOLMOD's and Eigen's, on the matrices of heat diffusion: whether
// the package had better use one of them. And whether the small factorisation of geodesic balls had better be the same.

#include "animations.h"
#include "benchmark_support.h"
#include "linear_solvers.h"
#include "patch_systems.h"

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
#include <string>
#include <vector>

using namespace Benchmark;

namespace {

typedef Amf::Rest_shape Rest_shape;

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

struct Method
{
  std::string name;
  std::function<std::unique_ptr<Solver>(std::size_t threads)> make;
};

std::vector<Method> methods(const Heat_equation& system)
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
    for (std::size_t c = 0; c < right_hand_sides; ++c) {
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
    for (std::size_t c = 0; c < right_hand_sides; ++c) {
      largest = (std::max)(largest, std::abs(a.solution(v, c)));
      difference = (std::max)(difference, std::abs(a.solution(v, c) - b.solution(v, c)));
    }
  return difference / largest;
}

// All that is measured with some number of threads: "<number of the method>_<what>" and a value.
std::map<std::string, double> measure(const Heat_equation& system, std::size_t threads, const Repetitions& r)
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
  const Heat_equation system(shape);
  Repetitions r = repetitions(arguments);
  if (system.size() > 500000 && !arguments.quick) r.least = 3;
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
            ". Same bits: whether the solution has those of one thread; features must not depend on the number of "
            "threads, nor on the processor. Difference: the largest, from the first row's solution, relative to the "
            "largest value. CHOLMOD would replace the package's own if it took at most 1.3 times as long and always "
            "computed the same bits.",
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
