// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_SCALE_SPACE_ENGINE_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_SCALE_SPACE_ENGINE_H

#include <CGAL/Animated_mesh_features/Extremum_search.h>
#include <CGAL/Animated_mesh_features/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Visitor.h>
#include <CGAL/Animated_mesh_features/internal/Thread_local.h>
#include <CGAL/Animated_mesh_features/internal/parallel_for.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// An extremum on the grid of samples, with what is needed to place it between them.
struct Extremum
{
  Rest_shape::Index vertex;
  std::size_t frame, k, l;
  // responses at the vertex, [dk + 1][dl + 1][df + 1]
  std::array<std::array<std::array<double, 3>, 3>, 3> window;
  // responses at the neighbours, in the order of Rest_shape::neighbours(), same scale and frame
  std::vector<double> ring;

  double response() const { return window[1][1][1]; }
};

// Finds the extrema of the response over all samples (vertex, frame, k, l).
//
// The spatial filter S acts on frames, the temporal filter T on rows of frames, so they commute, L_kl = S_k d T_l, and
// S is applied once for each k only. For a batch of space levels that are kept as rows, all time levels of a vertex,
// its responses and the tests at the vertex itself run in the cache. What survives them looks at its neighbours: T is
// linear, so a single response at a neighbour is a few scalar products of its rows with rows of the matrix of T_l.
template <class FT, class TemporalFilter, class Response, class Search>
class Scale_space_engine
{
  static constexpr std::size_t below = Response::below, above = Response::above;
  typedef Spatio_temporal_field<FT> Field;

public:
  Scale_space_engine(const Rest_shape& shape,
                     std::size_t number_of_frames,
                     std::size_t space_levels,
                     std::size_t time_levels,
                     const TemporalFilter& temporal,
                     const Response& response,
                     const Search& search)
    : m_shape(shape)
    , m_frames(number_of_frames)
    , m_space_levels(space_levels)
    , m_time_levels(time_levels)
    , m_temporal(temporal)
    , m_response(response)
    , m_search(search)
  {
    tabulate_temporal_filter();
  }

  template <class ConcurrencyTag, class SpatialFilter, class Visitor>
  std::vector<Extremum> run(const Field& field, SpatialFilter& spatial, Visitor& visitor)
  {
    const Task_loop<ConcurrencyTag, Visitor> smooth_loop(visitor, Stage::SCALE_SPACE);
    const Task_loop<ConcurrencyTag, Visitor> search_loop(visitor, Stage::EXTREMA);
    // D exists for k in [below, space_levels - above), an extremum has a D on either side.
    const std::size_t first = below + 1, last = m_space_levels - above - 1; // [first, last)
    // Batches of at most 12 levels keep the memory bounded and recompute little: (12 + 2) / 12.
    constexpr std::size_t batch = 12;
    std::vector<Extremum> extrema;
    Levels levels(m_space_levels);
    std::size_t smoothed = 0;
    for (std::size_t k0 = first; k0 < last; k0 += batch) {
      const std::size_t k1 = (std::min)(k0 + batch, last);
      // L for the D of [k0 - 1, k1 + 1)
      const std::size_t l0 = k0 - 1 - below, l1 = k1 + above + 1;
      {
        const Stage_scope<Visitor> stage(visitor, Stage::SCALE_SPACE);
        for (; smoothed < l1; ++smoothed) {
          levels[smoothed] = std::make_shared<Field>(field.number_of_rows(), field.number_of_frames());
          const Field& previous = smoothed > 0 ? *levels[smoothed - 1] : field;
          spatial(smoothed, previous, *levels[smoothed], smooth_loop.part(smoothed, m_space_levels));
        }
      }
      const Stage_scope<Visitor> stage(visitor, Stage::EXTREMA);
      search_batch(levels, l0, l1, k0, k1, search_loop.part((k0 - first) / batch, (last - first + batch - 1) / batch),
                   extrema);
      for (std::size_t k = l0; k + below + 1 < k1; ++k) levels[k].reset(); // the next batch starts at k1 - 1 - below
    }
    return extrema;
  }

private:
  typedef std::vector<std::shared_ptr<Field>> Levels;
  typedef Eigen::Array<FT, Eigen::Dynamic, 1> Row;

  struct Workspace
  {
    std::vector<FT> smoothed;  // [space level of the batch][time level][frame]
    std::vector<FT> responses; // [space level of the batch][time level][frame]
  };

  template <class Loop>
  void search_batch(const Levels& levels,
                    std::size_t l0,
                    std::size_t l1,
                    std::size_t k0,
                    std::size_t k1,
                    const Loop& loop,
                    std::vector<Extremum>& extrema)
  {
    constexpr std::size_t vertices_per_task = 64;
    const std::size_t n = m_shape.number_of_vertices();
    const std::size_t tasks = (n + vertices_per_task - 1) / vertices_per_task;
    std::vector<std::vector<Extremum>> found(tasks); // in order, whichever thread finds them
    Thread_local<Workspace> workspaces;
    loop(tasks, [&](std::size_t task) {
      Workspace& workspace = workspaces.get([] { return std::make_unique<Workspace>(); });
      const std::size_t end = (std::min)(n, (task + 1) * vertices_per_task);
      for (std::size_t v = task * vertices_per_task; v < end; ++v) {
        respond(levels, v, l0, l1, k0, k1, workspace);
        search_vertex(levels, v, k0, k1, workspace, found[task]);
      }
    });
    for (std::vector<Extremum>& f : found)
      extrema.insert(extrema.end(), std::make_move_iterator(f.begin()), std::make_move_iterator(f.end()));
  }

  // All time levels and responses of one vertex.
  void respond(const Levels& levels,
               std::size_t v,
               std::size_t l0,
               std::size_t l1,
               std::size_t k0,
               std::size_t k1,
               Workspace& w) const
  {
    const std::size_t plane = m_time_levels * m_frames;
    w.smoothed.resize((l1 - l0) * plane);
    for (std::size_t k = l0; k < l1; ++k) {
      FT* row = w.smoothed.data() + (k - l0) * plane;
      m_temporal(0, levels[k]->row(v), row);
      for (std::size_t l = 1; l < m_time_levels; ++l) m_temporal(l, row + (l - 1) * m_frames, row + l * m_frames);
    }
    w.responses.assign((k1 - k0 + 2) * plane, FT(0));
    for (std::size_t k = k0 - 1; k < k1 + 1; ++k) {
      const auto smoothed = [&](std::size_t kk, std::size_t l) {
        return w.smoothed.data() + (kk - l0) * plane + l * m_frames;
      };
      for (std::size_t l = below; l + above < m_time_levels; ++l) {
        const FT a = FT(m_response.space_weight(k, l)), b = FT(m_response.time_weight(k, l));
        const FT *s1 = smoothed(k + above, l), *s0 = smoothed(k - below, l);
        const FT *t1 = smoothed(k, l + above), *t0 = smoothed(k, l - below);
        FT* d = w.responses.data() + (k - (k0 - 1)) * plane + l * m_frames;
        const auto row = [&](const FT* r) { return Eigen::Map<const Row>(r, Eigen::Index(m_frames)); };
        Eigen::Map<Row>(d, Eigen::Index(m_frames)) = a * (row(s1) - row(s0)) + b * (row(t1) - row(t0));
      }
    }
  }

  void search_vertex(const Levels& levels,
                     std::size_t v,
                     std::size_t k0,
                     std::size_t k1,
                     const Workspace& w,
                     std::vector<Extremum>& found) const
  {
    const std::size_t plane = m_time_levels * m_frames;
    for (std::size_t k = k0; k < k1; ++k)
      for (std::size_t l = below + 1; l + above + 1 < m_time_levels; ++l) {
        const FT* d = w.responses.data() + (k - (k0 - 1)) * plane + l * m_frames;
        for (std::size_t f = 1; f + 1 < m_frames; ++f) {
          const Response_window<FT> window(d + f - plane, d + f, d + f + plane, std::ptrdiff_t(m_frames));
          if (!m_search.at_vertex(window)) continue;
          Extremum e;
          if (!survives_neighbours(levels, v, k, l, f, e.ring)) continue;
          e.vertex = Rest_shape::Index(v);
          e.frame = f;
          e.k = k;
          e.l = l;
          for (int dk = -1; dk <= 1; ++dk)
            for (int dl = -1; dl <= 1; ++dl)
              for (int df = -1; df <= 1; ++df) e.window[dk + 1][dl + 1][df + 1] = double(window(dk, dl, df));
          found.push_back(std::move(e));
        }
      }
  }

  bool survives_neighbours(const Levels& levels,
                           std::size_t v,
                           std::size_t k,
                           std::size_t l,
                           std::size_t f,
                           std::vector<double>& ring) const
  {
    const FT centre = response(levels, v, k, l, f); // by the same operations as those it is compared with
    for (Rest_shape::Index w : m_shape.neighbours()[v]) {
      const FT same = response(levels, w, k, l, f);
      if (!m_search.at_neighbour(centre, response(levels, w, k, l, f - 1), same, response(levels, w, k, l, f + 1)))
        return false;
      ring.push_back(double(same));
    }
    return true;
  }

  FT response(const Levels& levels, std::size_t v, std::size_t k, std::size_t l, std::size_t f) const
  {
    const FT a = FT(m_response.space_weight(k, l)), b = FT(m_response.time_weight(k, l));
    const FT *upper = levels[k + above]->row(v), *lower = levels[k - below]->row(v), *same = levels[k]->row(v);
    const FT *t = matrix_row(l, f), *t1 = matrix_row(l + above, f), *t0 = matrix_row(l - below, f);
    const auto row = [&](const FT* r) { return Eigen::Map<const Row>(r, Eigen::Index(m_frames)); };
    return a * ((row(upper) - row(lower)) * row(t)).sum() + b * (row(same) * (row(t1) - row(t0))).sum();
  }

  const FT* matrix_row(std::size_t l, std::size_t f) const { return m_matrices.data() + (l * m_frames + f) * m_frames; }

  // Row f of the matrix of T_l holds the weights of all frames in frame f of level l: unit impulses, smoothed.
  void tabulate_temporal_filter()
  {
    m_matrices.resize(m_time_levels * m_frames * m_frames);
    std::vector<FT> in(m_frames), out(m_frames);
    for (std::size_t j = 0; j < m_frames; ++j) {
      std::fill(in.begin(), in.end(), FT(0));
      in[j] = 1;
      for (std::size_t l = 0; l < m_time_levels; ++l) {
        m_temporal(l, in.data(), out.data());
        for (std::size_t f = 0; f < m_frames; ++f) m_matrices[(l * m_frames + f) * m_frames + j] = out[f];
        in.swap(out);
      }
    }
  }

  const Rest_shape& m_shape;
  std::size_t m_frames, m_space_levels, m_time_levels;
  const TemporalFilter& m_temporal;
  const Response& m_response;
  const Search& m_search;
  std::vector<FT> m_matrices; // [l][f][j]
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_SCALE_SPACE_ENGINE_H
