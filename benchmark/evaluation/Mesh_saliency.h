// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_MESH_SALIENCY_H
#define ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_MESH_SALIENCY_H

#include "Static_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace Static_detectors {

// C. H. Lee, A. Varshney, D. W. Jacobs, Mesh saliency, 2005: with the mean curvature H and its Gaussian-weighted
// average over all vertices x within 2 sigma (straight distance),
//   G(v, sigma) = sum H(x) exp(-|x - v|^2 / (2 sigma^2)) / sum exp(-|x - v|^2 / (2 sigma^2)),
// the saliency at a scale is S_i(v) = |G(v, sigma_i) - G(v, 2 sigma_i)|, sigma_i = 2, 3, 4, 5, 6 times .3 % of the
// diagonal. Maps are normalised to a maximum of 1, multiplied by (1 - m_i)^2 with the mean m_i of all local maxima
// but the greatest, and added. Here both normalisations are those of all frames together: frame by frame they would
// flicker, and strengths of frames could not be compared. Interest points are the local maxima; sigma is that of the
// scale that adds most.
//
// Complexity: linear in the number of pairs within 7.2 % of the diagonal.
class Mesh_saliency : public Static_detector
{
public:
  Static_response operator()(const Surface& s) const override
  {
    const std::vector<double> curvature = vertex_measures(s).mean_curvature;
    const double unit = 0.003 * s.diagonal, reach = 2 * 2 * double(factors.back()) * unit;
    const Grid grid(s.points, reach);
    Static_response response;
    response.levels.assign(factors.size(), std::vector<float>(s.size(), 0));
    for (std::size_t v = 0; v < s.size(); ++v) {
      std::array<double, largest + 1> sum = {}, weights = {}; // by sigma in units
      grid.for_each_near(s.points[v], [&](std::size_t x) {
        const double square = (s.points[x] - s.points[v]).squaredNorm() / (unit * unit);
        if (square >= 4. * largest * largest) return;
        const std::array<double, largest + 1> gaussians = gaussians_of(square);
        for (int sigma : sigmas) {
          if (square >= 4. * sigma * sigma) continue;
          weights[sigma] += gaussians[sigma];
          sum[sigma] += gaussians[sigma] * curvature[x];
        }
      });
      const auto average = [&](int sigma) { return sum[sigma] / weights[sigma]; };
      for (std::size_t i = 0; i < factors.size(); ++i)
        response.levels[i][v] = float(std::abs(average(factors[i]) - average(2 * factors[i])));
    }
    return response;
  }

  void finish(const Surface& s, std::vector<Static_response>& frames) const override
  {
    std::array<double, 5> weights;
    for (std::size_t i = 0; i < factors.size(); ++i) weights[i] = level_weight(s, frames, i);
    for (Static_response& r : frames) {
      r.values.assign(s.size(), 0);
      for (std::size_t v = 0; v < s.size(); ++v)
        for (std::size_t i = 0; i < factors.size(); ++i) r.values[v] += weights[i] * double(r.levels[i][v]);
      for (std::size_t v = 0; v < s.size(); ++v) {
        if (!is_maximum(s, r.values, v)) continue;
        std::size_t best = 0;
        for (std::size_t i = 1; i < factors.size(); ++i)
          if (weights[i] * double(r.levels[i][v]) > weights[best] * double(r.levels[best][v])) best = i;
        r.points.push_back({v, factors[best] * 0.003 * s.diagonal, r.values[v]});
      }
      r.levels.clear();
    }
  }

private:
  static constexpr std::array<int, 5> factors = {{2, 3, 4, 5, 6}};
  static constexpr std::array<int, 8> sigmas = {{2, 3, 4, 5, 6, 8, 10, 12}}; // these and twice these
  static constexpr int largest = 12;

  // exp(-square / (2 sigma^2)) for each sigma: the Gaussian of half the sigma is the fourth power.
  static std::array<double, largest + 1> gaussians_of(double square)
  {
    std::array<double, largest + 1> g = {};
    const auto fourth = [](double x) { return x * x * x * x; };
    for (int sigma : {8, 10, 12}) g[sigma] = std::exp(-square / (2. * sigma * sigma));
    for (int sigma : {4, 5, 6}) g[sigma] = fourth(g[2 * sigma]);
    for (int sigma : {2, 3}) g[sigma] = fourth(g[2 * sigma]);
    return g;
  }

  // Cubic cells of the edge length `reach`; points that are near are in the 27 around.
  class Grid
  {
  public:
    Grid(const std::vector<Point>& points, double reach)
      : m_reach(reach)
    {
      for (std::size_t v = 0; v < points.size(); ++v) m_cells[key(cell(points[v]))].push_back(v);
    }

    template <class Use>
    void for_each_near(const Point& p, const Use& use) const
    {
      const std::array<std::int64_t, 3> c = cell(p);
      for (std::int64_t i = -1; i <= 1; ++i)
        for (std::int64_t j = -1; j <= 1; ++j)
          for (std::int64_t k = -1; k <= 1; ++k) {
            const auto found = m_cells.find(key({{c[0] + i, c[1] + j, c[2] + k}}));
            if (found == m_cells.end()) continue;
            for (std::size_t v : found->second) use(v);
          }
    }

  private:
    std::array<std::int64_t, 3> cell(const Point& p) const
    {
      return {{std::int64_t(std::floor(p[0] / m_reach)), std::int64_t(std::floor(p[1] / m_reach)),
               std::int64_t(std::floor(p[2] / m_reach))}};
    }

    // cells that are 2^21 apart share a key, and are too far from each other to count
    static std::uint64_t key(const std::array<std::int64_t, 3>& c)
    {
      const std::uint64_t mask = (std::uint64_t(1) << 21) - 1;
      return (std::uint64_t(c[0]) & mask) << 42 | (std::uint64_t(c[1]) & mask) << 21 | (std::uint64_t(c[2]) & mask);
    }

    double m_reach;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> m_cells;
  };

  // (1 - m_i)^2 over the greatest value.
  static double level_weight(const Surface& s, const std::vector<Static_response>& frames, std::size_t i)
  {
    double greatest = 0, sum = 0;
    std::size_t maxima = 0;
    std::vector<double> values(s.size());
    for (const Static_response& r : frames) {
      std::copy(r.levels[i].begin(), r.levels[i].end(), values.begin());
      for (std::size_t v = 0; v < s.size(); ++v) {
        if (!is_maximum(s, values, v)) continue;
        greatest = (std::max)(greatest, values[v]);
        sum += values[v];
        ++maxima;
      }
    }
    if (!(greatest > 0)) return 0;
    const double mean = maxima > 1 ? (sum - greatest) / (double(maxima - 1) * greatest) : 0;
    return (1 - mean) * (1 - mean) / greatest;
  }
};

} // namespace Static_detectors

#endif // ANIMATED_MESH_FEATURES_BENCHMARK_EVALUATION_MESH_SALIENCY_H
