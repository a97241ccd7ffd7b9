// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_HEAT_DIFFUSION_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_HEAT_DIFFUSION_FILTER_H

#include <CGAL/Animated_mesh_features/Animation_report.h>
#include <CGAL/Animated_mesh_features/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/internal/Frame_block.h>
#include <CGAL/Animated_mesh_features/internal/Lane_cholesky.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing by heat diffusion on the rest shape; a model of `SpatialFilter`, the default.

The heat equation with the cotangent Laplacian \f$L_c\f$ and lumped masses M, stepped from level to level by the
second-order L-stable scheme SDIRK2: with \f$\gamma = 1 - 1/\sqrt2\f$, \f$t = (s_k - s_{k-1})/2\f$ and
\f$B = (M + \gamma t L_c)^{-1} M\f$,
\f[ L_k = (1+\sqrt2)\, B^2 L_{k-1} - \sqrt2\, B\, L_{k-1} . \f]
Its scale does not depend on the sampling of the surface. (Backward Euler has the exact variance, too, but its peak
decays differently, which biases detected scales by +11 %.)

The matrix of a level is factored once and used for all frames, several of which are solved at a time. A vertex that is
in no proper triangle keeps its values.
*/
class Heat_diffusion_filter
{
public:
  /// the variance that one-ring averaging would add in a pass, \f$3h^2/7\f$: the step where a sampling counts steps.
  double unit_variance(const Rest_shape& shape) const { return 3 * squared(shape.mean_edge_length()) / 7; }

  /// the smallest variance that a level can have: \f$(0.35\,h)^2\f$, below which a Gaussian falls between the vertices.
  double smallest_variance(const Rest_shape& shape) const { return squared(0.35 * shape.mean_edge_length()); }

  /// prepares the levels.
  /// \param variances ascending; squared length per axis.
  template <class Loop>
  void initialize(const Rest_shape& shape, const std::vector<double>& variances, const Loop&)
  {
    m_variances = variances;
    assemble(shape);
    m_cholesky = std::make_shared<internal::Lane_cholesky>();
    m_cholesky->analyze(system(1));
  }

  /// the variance of level `k`, exactly the one that was asked for.
  double variance(std::size_t k) const { return m_variances[k]; }

  /// the same at every vertex.
  double variance(std::size_t k, std::size_t) const { return m_variances[k]; }

  /// smooths all frames from level `k` - 1 (the unsmoothed field for `k` = 0) to level `k`.
  /// \throw Numerical_error if the factorisation fails.
  template <class FT, class Loop>
  void operator()(std::size_t k, const Spatio_temporal_field<FT>& in, Spatio_temporal_field<FT>& out, const Loop& loop)
  {
    const double t = (m_variances[k] - (k > 0 ? m_variances[k - 1] : 0)) / 2;
    out = in;
    if (t == 0) return;
    const double gamma = 1 - 1 / std::sqrt(2.);
    m_cholesky->factorize(system(gamma * t));
    loop(internal::Frame_block<FT>::number_of_blocks(in.number_of_frames()),
         [&](std::size_t block) { step(block, in, out); });
  }

private:
  static double squared(double x) { return x * x; }

  template <class FT>
  void step(std::size_t block, const Spatio_temporal_field<FT>& in, Spatio_temporal_field<FT>& out) const
  {
    typedef internal::Frame_block<FT> Block;
    const std::size_t n = in.number_of_rows();
    std::vector<typename Block::Array> x(n);
    for (std::size_t v = 0; v < n; ++v) x[m_cholesky->position(v)] = Block::load(in, v, block) * FT(m_mass[v]);
    m_cholesky->solve<FT>(x); // B in
    for (std::size_t v = 0; v < n; ++v) {
      auto& y = x[m_cholesky->position(v)];
      Block::at(out, v, block) = y * FT(-std::sqrt(2.));
      y *= FT(m_mass[v]);
    }
    m_cholesky->solve<FT>(x); // B^2 in
    for (std::size_t v = 0; v < n; ++v)
      Block::at(out, v, block) += x[m_cholesky->position(v)] * FT(1 + std::sqrt(2.));
  }

  void assemble(const Rest_shape& shape)
  {
    typedef Eigen::Triplet<double> Entry;
    const std::size_t n = shape.number_of_vertices();
    m_mass.assign(n, 0);
    std::vector<Entry> entries;
    entries.reserve(12 * shape.triangles().size());
    for (Rest_shape::Index t : shape.ordered_triangles()) {
      if (is_degenerate(shape, t)) continue;
      const Rest_shape::Triangle& corner = shape.triangles()[t];
      for (int i = 0; i < 3; ++i) {
        const int a = int(corner[(i + 1) % 3]), b = int(corner[(i + 2) % 3]);
        const Rest_shape::Point& p = shape.points()[corner[i]];
        m_mass[corner[i]] += shape.areas()[t] / 3;
        // half the cotangent of the angle at p: (u . w) / |u x w| / 2 with |u x w| = 2 area
        const double c = (shape.points()[a] - p).dot(shape.points()[b] - p) / (4 * shape.areas()[t]);
        entries.emplace_back(a, b, -c);
        entries.emplace_back(b, a, -c);
        entries.emplace_back(a, a, c);
        entries.emplace_back(b, b, c);
      }
    }
    // in units of the mean mass, so that the matrices do not depend on the unit of length
    double total = 0;
    for (double m : m_mass) total += m;
    const double mean = total / double(n);
    for (std::size_t v = 0; v < n; ++v) {
      m_mass[v] = m_mass[v] > 0 ? m_mass[v] / mean : 1;
      entries.emplace_back(int(v), int(v), 0); // a vertex in no proper triangle has a diagonal, too
    }
    m_laplacian.resize(Eigen::Index(n), Eigen::Index(n));
    m_laplacian.setFromTriplets(entries.begin(), entries.end());
    m_laplacian /= mean;
  }

  Eigen::SparseMatrix<double> system(double t) const
  {
    Eigen::SparseMatrix<double> a = t * m_laplacian;
    for (std::size_t v = 0; v < m_mass.size(); ++v) a.coeffRef(Eigen::Index(v), Eigen::Index(v)) += m_mass[v];
    return a;
  }

  std::vector<double> m_variances;
  std::vector<double> m_mass; // in units of the mean mass
  Eigen::SparseMatrix<double> m_laplacian;
  std::shared_ptr<internal::Lane_cholesky> m_cholesky; // copies of the filter share it until they are initialized
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_HEAT_DIFFUSION_FILTER_H
