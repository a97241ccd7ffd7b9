// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_HEAT_KERNEL_SIGNATURE_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_HEAT_KERNEL_SIGNATURE_H

#include "Static_detector.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Static_detectors {

// J. Sun, M. Ovsjanikov, L. Guibas, A concise and provably informative multi-scale signature based on heat diffusion,
// 2009: the heat that stays at a vertex,
//   h_t(v) = sum_i exp(-lambda_i t) phi_i(v)^2,
// with the eigenvalues and eigenfunctions of the Laplacian (cotangents, lumped masses). Interest points are maxima
// over two rings at a large t: the first at which 50 eigenvalues suffice, t = 4 ln 10 / lambda_50 of the rest shape,
// so that the fiftieth adds 1e-4 of itself. The value is 4 pi t h_t, without unit, 1 in a plane; sigma = sqrt(2 t).
//
// Eigenfunctions are found by subspace iteration with the inverse of L + M / area: from scratch for the rest shape,
// from those of the rest shape for a frame. What has not converged when it ends are the last ones, which hardly
// count.
class Heat_kernel_signature : public Static_detector
{
public:
  void prepare(const Surface& rest) override
  {
    const Eigen::Index columns = (std::min)(Eigen::Index(functions + guard), Eigen::Index(rest.size()));
    m_start = Eigen::MatrixXd(Eigen::Index(rest.size()), columns);
    std::uint64_t state = 1; // any functions that differ: a linear congruential generator
    for (Eigen::Index i = 0; i < m_start.size(); ++i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      m_start.data()[i] = double(state >> 33) / 2147483648. - 0.5;
    }
    m_start.col(0).setOnes();
    const Eigenpairs pairs = eigenpairs(rest, iterations_at_rest);
    m_start = pairs.functions;
    m_time = 4 * std::log(10.) / pairs.values[(std::min)(columns, Eigen::Index(functions)) - 1];
  }

  // squared length
  double time() const { return m_time; }

  Static_response operator()(const Surface& s) const override
  {
    const Eigenpairs pairs = eigenpairs(s, iterations_of_frame);
    Static_response response;
    response.values.assign(s.size(), 0);
    const double four_pi = 12.566370614359172;
    const Eigen::Index used = (std::min)(Eigen::Index(functions), pairs.values.size());
    for (Eigen::Index i = 0; i < used; ++i) {
      const double weight = four_pi * m_time * std::exp(-(std::max)(0., pairs.values[i]) * m_time);
      for (std::size_t v = 0; v < s.size(); ++v) {
        const double phi = pairs.functions(Eigen::Index(v), i);
        response.values[v] += weight * phi * phi;
      }
    }
    for (std::size_t v = 0; v < s.size(); ++v)
      if (is_maximum(s, response.values, v, 2))
        response.points.push_back({v, std::sqrt(2 * m_time), response.values[v]});
    return response;
  }

private:
  static constexpr int functions = 50, guard = 14, iterations_at_rest = 30, iterations_of_frame = 4;

  struct Eigenpairs
  {
    Eigen::VectorXd values;    // ascending
    Eigen::MatrixXd functions; // columns of length 1 in the sense of the masses
  };

  Eigenpairs eigenpairs(const Surface& s, int iterations) const
  {
    const Eigen::Index n = Eigen::Index(s.size());
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
    const std::vector<double> areas = vertex_measures(s).areas;
    double area = 0;
    for (double a : areas) area += a;
    // a vertex without area is far away from all others in frequency
    for (std::size_t v = 0; v < s.size(); ++v)
      mass[Eigen::Index(v)] = (std::max)(areas[v], 1e-6 * area / double(s.size()));
    const double shift = 1 / area;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> inverse(matrix(s, shift, mass));
    if (inverse.info() != Eigen::Success)
      throw CGAL::Animated_mesh_features::Numerical_error("the Laplacian of a frame cannot be factored");
    Eigenpairs pairs;
    pairs.functions = m_start;
    for (int i = 0; i < iterations; ++i) {
      const Eigen::MatrixXd right = mass.asDiagonal() * pairs.functions;
      const Eigen::MatrixXd y = inverse.solve(right);
      const Eigen::MatrixXd y_mass = mass.asDiagonal() * y;
      const Eigen::MatrixXd gram = y.transpose() * y_mass;
      Eigen::MatrixXd energy = y.transpose() * right;
      energy = (energy + energy.transpose()).eval() / 2 - shift * gram; // of L: (L + shift M) y is the right-hand side
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(energy, gram);
      pairs.values = ritz.eigenvalues();
      pairs.functions = y * ritz.eigenvectors();
    }
    return pairs;
  }

  static Eigen::SparseMatrix<double> matrix(const Surface& s, double shift, const Eigen::VectorXd& mass)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index v = 0; v < mass.size(); ++v) entries.emplace_back(v, v, shift * mass[v]);
    for (const Triangle& t : s.connectivity.triangles)
      for (int i = 0; i < 3; ++i) {
        const std::size_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
        const double weight = cotangent(s.points[t[i]], s.points[a], s.points[b]) / 2;
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
      }
    Eigen::SparseMatrix<double> result(mass.size(), mass.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::MatrixXd m_start;
  double m_time = 0;
};

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_HEAT_KERNEL_SIGNATURE_H
