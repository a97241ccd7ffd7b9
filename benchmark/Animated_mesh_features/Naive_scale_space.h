// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NAIVE_SCALE_SPACE_H
#define CGAL_ANIMATED_MESH_FEATURES_NAIVE_SCALE_SPACE_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace Benchmark {

// Every smoothing count as the paper describes it, with what is at hand: a level is a dense matrix of doubles (vertices
// x frames, frames contiguous, the better order of the two for Eigen), one-ring averaging a sparse matrix, and all
// space levels of two time levels are in memory, with the responses of three. Products of a sparse and a dense matrix
// run on all of Eigen's threads; the other loops have OpenMP's directives, for they need nothing else.
template <class Response>
class Naive_scale_space
{
public:
  typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Level;
  typedef CGAL::Animated_mesh_features::Rest_shape Rest_shape;

  struct Minimum
  {
    std::size_t vertex, frame, k, l;
    double response;
  };

  // How level (k, l) is made.
  enum Order
  {
    SPACE_FIRST, // from (k-1, l), by a product with the sparse matrix
    TIME_FIRST   // from (k, l-1), by a running mean over the frames, which costs less than the product
  };

  // `response` has been initialized with the scales of the levels (0..space_count) x (0..time_count).
  Naive_scale_space(const Rest_shape& shape, std::size_t frames, std::size_t box_width, std::size_t space_count,
                    std::size_t time_count, const Response& response, Order order)
    : m_shape(shape)
    , m_frames(Eigen::Index(frames))
    , m_width(Eigen::Index(box_width))
    , m_space_count(space_count)
    , m_time_count(time_count)
    , m_response(response)
    , m_order(order)
  {
    const Eigen::Index n = Eigen::Index(shape.number_of_vertices());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index v = 0; v < n; ++v) {
      const auto ring = shape.neighbours()[std::size_t(v)];
      const double weight = 1 / double(ring.size() + 1);
      entries.emplace_back(v, v, weight);
      for (Rest_shape::Index w : ring) entries.emplace_back(v, w, weight);
    }
    m_average.resize(n, n);
    m_average.setFromTriplets(entries.begin(), entries.end());
  }

  // Bytes of the arrays.
  double memory() const
  {
    const double level = double(m_shape.number_of_vertices()) * double(m_frames) * sizeof(double);
    const double matrix = double(m_average.nonZeros()) * (sizeof(double) + sizeof(int));
    return (2 * double(m_space_count + 1) + 3 * double(m_space_count)) * level + matrix;
  }

  template <class FT>
  std::vector<Minimum> operator()(const CGAL::Animated_mesh_features::Spatio_temporal_field<FT>& field) const
  {
    const Eigen::Index n = Eigen::Index(m_shape.number_of_vertices());
    std::vector<Level> now(m_space_count + 1, Level(n, m_frames)), next = now;
    std::array<std::vector<Level>, 3> responses; // of time levels l - 2, l - 1 and l
    responses.fill(std::vector<Level>(m_space_count, Level(n, m_frames)));
    for (Eigen::Index v = 0; v < n; ++v)
      for (Eigen::Index f = 0; f < m_frames; ++f) now[0](v, f) = double(field(std::size_t(v), std::size_t(f)));
    for (std::size_t k = 1; k <= m_space_count; ++k) now[k].noalias() = m_average * now[k - 1];

    std::vector<Minimum> minima;
    for (std::size_t l = 0; l < m_time_count; ++l) {
      for (std::size_t k = 0; k <= m_space_count; ++k)
        if (m_order == TIME_FIRST || k == 0)
          average_frames(now[k], next[k]);
        else
          next[k].noalias() = m_average * next[k - 1];
      std::vector<Level>& d = responses[l % 3];
#pragma omp parallel for
      for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(m_space_count); ++i) {
        const std::size_t k = std::size_t(i);
        const double a = m_response.space_weight(k, l), b = m_response.time_weight(k, l);
        d[k] = a * (now[k + 1] - now[k]) + b * (next[k] - now[k]);
      }
      if (l >= 2) find_minima(responses[(l - 2) % 3], responses[(l - 1) % 3], d, l - 1, minima);
      now.swap(next);
    }
    return minima;
  }

private:
  // The mean of m_width frames, or, if that is even, of m_width + 1 of which the first and the last count half; beyond
  // the ends the row is mirrored.
  void average_frames(const Level& in, Level& out) const
  {
    const Eigen::Index reach = m_width / 2;
    const double end = m_width % 2 ? 1 : 0.5, scale = 1 / double(m_width);
#pragma omp parallel
    {
      std::vector<double> extended(std::size_t(m_frames + 2 * reach));
      double* const row = extended.data();
#pragma omp for
      for (Eigen::Index v = 0; v < in.rows(); ++v) {
        const double* const values = in.data() + v * m_frames;
        double* const means = out.data() + v * m_frames;
        std::copy(values, values + m_frames, row + reach);
        for (Eigen::Index i = 0; i < reach; ++i) {
          row[i] = values[mirrored(i - reach)];
          row[m_frames + reach + i] = values[mirrored(m_frames + i)];
        }
        double inner = 0; // of all but the two at the ends
        for (Eigen::Index i = 1; i < 2 * reach; ++i) inner += row[i];
        for (Eigen::Index f = 0; f < m_frames; ++f) {
          const double first = row[f], last = row[f + 2 * reach];
          means[f] = (inner + end * (first + last)) * scale;
          inner += last - row[f + 1];
        }
      }
    }
  }

  Eigen::Index mirrored(Eigen::Index f) const
  {
    const Eigen::Index period = 2 * m_frames;
    f = ((f % period) + period) % period;
    return f < m_frames ? f : period - 1 - f;
  }

  void find_minima(const std::vector<Level>& below, const std::vector<Level>& same, const std::vector<Level>& above,
                   std::size_t l, std::vector<Minimum>& minima) const
  {
    const std::array<const std::vector<Level>*, 3> d = {{&below, &same, &above}};
#pragma omp parallel
    {
      std::vector<Minimum> found;
#pragma omp for
      for (std::ptrdiff_t v = 0; v < std::ptrdiff_t(m_shape.number_of_vertices()); ++v)
        for (std::size_t k = 1; k + 1 < m_space_count; ++k)
          for (Eigen::Index f = 1; f + 1 < m_frames; ++f)
            if (is_minimum(d, v, k, f)) found.push_back({std::size_t(v), std::size_t(f), k, l, same[k](v, f)});
#pragma omp critical
      minima.insert(minima.end(), found.begin(), found.end());
    }
  }

  bool is_minimum(const std::array<const std::vector<Level>*, 3>& d, Eigen::Index v, std::size_t k,
                  Eigen::Index f) const
  {
    const Level& same = (*d[1])[k];
    const double centre = same(v, f);
    if (!(centre < 0) || !(centre < same(v, f - 1)) || !(centre < same(v, f + 1))) return false;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = k - 1; i <= k + 1; ++i)
        if ((i != k || j != 1) && !(centre < (*d[j])[i](v, f))) return false;
    for (Rest_shape::Index w : m_shape.neighbours()[std::size_t(v)])
      for (Eigen::Index g = f - 1; g <= f + 1; ++g)
        if (!(centre < same(w, g))) return false;
    return true;
  }

  const Rest_shape& m_shape;
  Eigen::Index m_frames, m_width;
  std::size_t m_space_count, m_time_count;
  const Response& m_response;
  Order m_order;
  Eigen::SparseMatrix<double, Eigen::RowMajor> m_average;
};

} // namespace Benchmark

#endif // CGAL_ANIMATED_MESH_FEATURES_NAIVE_SCALE_SPACE_H
