// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_KERNEL_NORMALIZATION_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_KERNEL_NORMALIZATION_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/run_vectorized.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Geometric_intervals.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Heat_system.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Lattice_kernel.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesNormalizations

A factor that tells how the surface around a vertex differs from a plane at a scale, from how much heat stays at a point;
a model of `ScaleNormalization`.

On a limb, heat spreads in all directions at first, and only to and fro once it has gone round: at scales larger than its
girth the surface is one-dimensional. Smoothing takes less from a bump there than it would in the plane, and at a later
scale; so the response, whose powers of \f$\sigma\f$ are those of the plane, has its minimum at a scale that is too large,
by half or more. What is left of a unit of heat where it was is the diagonal of the heat kernel, \f$h_t(v,v)\f$, the heat
kernel signature of \cgalCite{sun2009}. It is \f$1/(4\pi t)\f$ in the plane and falls as \f$t^{-d/2}\f$ on a surface that
is d-dimensional at that scale. For a Gaussian in d dimensions, the conditions of \cgalCite{laptev2005} put the extremum
at its own scale if the response with the powers for the plane is multiplied by \f$\sigma^{(d-2)/2}\f$. That is what
\f$(4\pi t\,h_t)^{-1/2}\f$ with \f$t = \sigma^2/2\f$ is, up to a constant, whatever d, also where it is none of these.

<b>The kernel.</b> In place of the heat kernel, \f$e^{-tL}\f$, this takes \f$(1+tL)^{-2}\f$, which is a mean of heat
kernels, over times with the Gamma distribution of shape 2 and scale t. Its diagonal \f$k_t(v,v)\f$ is
\f$1/(4\pi t)\f$ in the plane, too, and has the same exponents: in d dimensions it is \f$\Gamma(2 - d/2)\f$ times that of
the heat kernel, 0.89 times for d = 1. The factor is
\f[ g(v,\sigma) = \min\left(1, \left(4\pi t\,k_t(v,v)\right)^{-1/2}\right), \qquad t = \sigma^2/2 . \f]
Far inside a surface that is flat at this scale it is 1; on a tube of radius R, at scales beyond its girth,
\f$(\sigma / (2\sqrt2\,R))^{-1/2}\f$; at a border \f$1/\sqrt2\f$, since there is only half of a disc; and on a component
of area A, at scales beyond its size, \f$(A/(4\pi t))^{1/2}\f$. On a mesh with a thick and a thin limb it was between
10 % less and 7 % more than with the kernel of `Heat_diffusion_filter` at scales of at least two edges, and between 12 %
less and 16 % more at all scales from half an edge on.

It is never more than 1. Where \f$\sigma\f$ is less than an edge, heat stays in the area around a vertex, and the kernel is
at most one over this area, while that of the surface grows as \f$1/t\f$: what the mesh tells of so small scales is its
own size, not the shape of the surface. (Where a smooth surface is saddle-shaped, a little less heat stays than in the
plane; that is left out, too.) Above an edge, a mesh keeps more heat than its surface does, for its Laplacian is too
small for waves as short as its edges. Both are taken out by comparing with a plane that is a mesh as well: the lattice of
equilateral triangles whose edges are as long as those at the vertex, in the mean of their squares.

<b>Computation.</b> With the cotangent Laplacian \f$L_c\f$ and lumped masses M of the heat diffusion,
\f[ k_t(v,v) = \left[(M+tL_c)^{-1} M\,(M+tL_c)^{-1}\right]_{vv}
             = \frac{d}{dt}\,t\,Z_v(t), \qquad Z(t) = \mathrm{diag}\,(M+tL_c)^{-1}, \f]
so that \f$4\pi t\,k_t = 4\pi\,dF/d\ln t\f$ with \f$F = t\,Z\f$; the lattice's F is an integral over its waves. The diagonals of the inverses are computed from Cholesky
factors by the recurrence of \cgalCite{takahashi1973} and \cgalCite{erisman1975}, exactly, without solving for any
column, for values of t at a ratio of 4 at most. The logarithms of the differences of F are those of its derivative
between them, up to a term of second order that is taken off, and are interpolated by cubics: g is within 2 % of what it
is by the matrices of each level, mostly within 1 %.

Nothing is random: the same bits for any number of threads and any processor, and up to rounding the same for vertices in
any order, for the body wherever it is, turned or in another unit of length.

Complexity: a factorisation, and the diagonal of an inverse, which takes about as long, for each factor of 2 in
\f$\sigma\f$ and two more, some 8 in all; \f$O(N^{1.5})\f$ operations. Memory: `N` numbers in double precision for
each of them, and for each thread a factor, 35 `N` numbers at N = 10,000, 75 `N` at a million, and less than that again.

\cgalModels{ScaleNormalization}

\sa `Planar_normalization`
\sa `Heat_diffusion_filter`
*/
class Heat_kernel_normalization
{
public:
  /// the factors \f$g(v,\sigma_k)\f$ of all vertices and levels, [vertex][level], in (0, 1]. A vertex that is in no
  /// proper triangle has 1, and a level that is not smoothed, of variance 0, has 1 everywhere.
  /// \param shape the rest shape.
  /// \param variances \f$\sigma_k^2\f$ per axis; ascending; squared length.
  /// \param loop runs tasks, one for each factorisation.
  /// \tparam Loop a model of `TaskLoop`.
  /// \throw Numerical_error if a factorisation fails.
  template <class Loop>
  std::vector<float> operator()(const Rest_shape& shape, const std::vector<double>& variances, const Loop& loop) const
  {
    CGAL_precondition(std::is_sorted(variances.begin(), variances.end()));
    CGAL_precondition(variances.empty() || variances.front() >= 0);
    std::vector<float> factors(shape.number_of_vertices() * variances.size(), 1);
    const auto smoothed = std::find_if(variances.begin(), variances.end(), [](double s) { return s > 0; });
    const internal::Heat_system system(shape);
    if (smoothed == variances.end() || !(system.mean_mass() > 0)) {
      loop.finish();
      return factors;
    }
    const Intervals intervals(*smoothed / 2, variances.back() / 2, largest_ratio);
    const std::vector<std::vector<double>> integrals = integrals_at_nodes(system, intervals, loop);

    std::vector<Intervals::Weights> weights;
    for (double s : variances) weights.push_back(s > 0 ? intervals.at(s / 2) : Intervals::Weights());
    std::vector<double> logarithms(intervals.size());
    const internal::Lattice_kernel plane;
    for (std::size_t v = 0; v < system.size(); ++v) {
      if (!system.is_on_surface(v)) continue;
      relative_to_plane(shape, system, intervals, plane, integrals, v, logarithms);
      intervals.to_derivatives(logarithms);
      for (std::size_t k = 0; k < variances.size(); ++k)
        factors[v * variances.size() + k] = float(std::exp(-(std::max)(0., weights[k](logarithms)) / 2));
    }
    return factors;
  }

private:
  typedef internal::Geometric_intervals Intervals;

  // Of t, from one factorisation to the next: with 4, factors are within 2 % of exact ones, mostly within 1 %;
  // with 3, within 1 %, with 8, within 8 %.
  static constexpr double largest_ratio = 3;

  // F = t Z(t) at the nodes, in units of the mean mass, [node][vertex].
  template <class Loop>
  static std::vector<std::vector<double>> integrals_at_nodes(const internal::Heat_system& system,
                                                             const Intervals& intervals, const Loop& loop)
  {
    const internal::Instruction_set instructions = internal::widest_instruction_set();
    std::vector<std::vector<double>> integrals(intervals.size() + 1);
    loop(integrals.size(), [&](std::size_t i) {
      const double t = intervals.node(i);
      integrals[i] = system.factor<double>(t, instructions).diagonal_of_inverse(instructions);
      for (double& f : integrals[i]) f *= t;
    });
    return integrals;
  }

  // The logarithms of (F(t_+) - F(t_-)) over the same difference on a plane that is sampled as densely, a mean of what
  // 4 pi t k_t is in terms of the plane's over each interval.
  static void relative_to_plane(const Rest_shape& shape, const internal::Heat_system& system,
                                const Intervals& intervals, const internal::Lattice_kernel& plane,
                                const std::vector<std::vector<double>>& integrals, std::size_t v,
                                std::vector<double>& logarithms)
  {
    const double four_pi = 12.566370614359172;
    const double unit = four_pi / system.mean_mass(), area = system.mean_mass() * double(system.size());
    const double own_area = area_in_lattice(shape, v);
    const auto of_plane = [&](std::size_t node) { return plane(intervals.node(node) / own_area); };
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const double ratio = unit * (integrals[i + 1][v] - integrals[i][v]) / (of_plane(i + 1) - of_plane(i));
      // no less than what an even distribution over the whole surface leaves, whatever rounding does
      logarithms[i] = std::log((std::max)(four_pi * intervals.middle(i) / area, ratio));
    }
  }

  // The area of a vertex of the lattice whose edges are as long as those at v, in the mean of their squares, by which the
  // waves of a mesh are slower than those of its surface.
  static double area_in_lattice(const Rest_shape& shape, std::size_t v)
  {
    const auto edges = shape.incident_edges()[v];
    double squares = 0;
    for (Rest_shape::Index e : edges) squares += shape.lengths()[e] * shape.lengths()[e];
    return std::sqrt(3.) / 2 * squares / double(edges.size());
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_HEAT_KERNEL_NORMALIZATION_H
