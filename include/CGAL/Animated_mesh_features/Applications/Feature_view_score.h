// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_FEATURE_VIEW_SCORE_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_FEATURE_VIEW_SCORE_H

#include <CGAL/Animated_mesh_features/Animation/Bounded_dijkstra.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/vertex_areas.h>
#include <CGAL/Animated_mesh_features/Applications/Surface_view.h>
#include <CGAL/Animated_mesh_features/Applications/internal/feature_presence.h>
#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesViews

Scores a view by what it shows of the features: the sum over all features and the frames in which they live of amplitude
times the part of the region that is seen. The region is the disc of radius \f$\sigma\f$ about the feature's vertex, by
paths along edges of the rest shape, as in `feature_regions()`; in time it is worth \f$e^{-(t-t_0)^2/2\tau^2}\f$ within
\f$2\tau\f$, divided by its sum, so that a feature counts as its amplitude whatever its duration.

A vertex of a region counts as its area, as far as nothing hides it, times what of the surface's size there is in the
image: \f$\min(1, \cos\theta / c)\f$ with the angle \f$\theta\f$ between the surface's normal and the view. With \f$c = 1\f$
that is the projected size, with \f$c = 0\f$ whatever is not hidden is seen. The default, 1/2, takes for seen as a whole
what is turned away by up to 60 degrees: the projected size alone never grants more than half of a region on a limb, and
would have a camera look straight at one feature rather than obliquely at two.

An item is a vertex in a frame, so that several views together show what any of them shows.

\cgalModels{ViewScore}
*/
class Feature_view_score
{
public:
  /*!
  prepares, in \f$O(k \log k + F)\f$ for a feature with `k` vertices within its region, and \f$O(N K)\f$ memory at most.

  \param shape the surface at rest.
  \param frames the `K` frames that are looked at, ascending, at least one. What a feature is worth in other frames, it is
    worth in the nearest of them: the surface looks much the same there.
  \param number_of_frames `F` of the animation.
  \param frame_duration the time between two frames (s), positive.
  \param features a range of `Feature_point`; of them the vertex, frame, time, \f$\sigma\f$, \f$\tau\f$ and the amplitude
    are used; where there is no amplitude, the strength.
  \param full_cosine the cosine from which on the surface counts as seen as a whole, `c` above; from 0 to 1.
  \param is_cyclic whether the last frame is followed by the first: a feature near one end lives on at the other.
  \throw Input_error if a feature is at a vertex or in a frame that is not there, or its \f$\sigma\f$ is not positive;
    Option_error if `frames` is empty, not ascending or reaches beyond the animation, or `full_cosine` is out of range.
  */
  template <class FeatureRange>
  Feature_view_score(const Rest_shape& shape, const std::vector<std::size_t>& frames, std::size_t number_of_frames,
                     double frame_duration, const FeatureRange& features, double full_cosine = 0.5,
                     bool is_cyclic = false)
    : m_full_cosine(full_cosine)
    , m_first(frames.size() + 1, 0)
  {
    if (!(full_cosine >= 0 && full_cosine <= 1)) throw Option_error("the cosine of a full view must be from 0 to 1");
    if (frames.empty()) throw Option_error("at least one frame has to be looked at");
    for (std::size_t k = 0; k < frames.size(); ++k)
      if (frames[k] >= number_of_frames || (k > 0 && frames[k] <= frames[k - 1]))
        throw Option_error("the frames that are looked at must ascend, and be below " +
                           std::to_string(number_of_frames));
    typedef std::pair<Rest_shape::Index, double> Weight;
    std::vector<std::vector<Weight>> weights(frames.size());
    const std::vector<double> areas = vertex_areas(shape);
    internal::Bounded_dijkstra paths(shape);
    for (const Feature_point& f : features) {
      check(f, shape, number_of_frames);
      if (shape.is_isolated(f.vertex_index)) continue;
      const std::array<Rest_shape::Index, 1> centre = {{Rest_shape::Index(f.vertex_index)}};
      const std::vector<Weight> disc = sampled(paths.run(centre, f.sigma), areas);
      std::vector<double> presence(frames.size(), 0);
      for (const auto& m : internal::feature_presence(f, number_of_frames, frame_duration, is_cyclic))
        presence[nearest(frames, m.first, is_cyclic ? number_of_frames : 0)] += m.second;
      for (std::size_t k = 0; k < frames.size(); ++k)
        if (presence[k] > 0)
          for (const Weight& w : disc) weights[k].emplace_back(w.first, internal::worth(f) * presence[k] * w.second);
    }
    for (std::size_t k = 0; k < frames.size(); ++k) {
      std::stable_sort(weights[k].begin(), weights[k].end(),
                       [](const Weight& a, const Weight& b) { return a.first < b.first; });
      for (const Weight& w : weights[k])
        if (m_vertices.size() > m_first[k] && m_vertices.back() == w.first)
          m_weights.back() += w.second;
        else
          m_vertices.push_back(w.first), m_weights.push_back(w.second);
      m_first[k + 1] = m_vertices.size();
    }
  }

  /// the frames that are looked at.
  std::size_t number_of_frames() const { return m_first.size() - 1; }

  /// where the items of the `k`-th frame begin; those of all end at `first_item(number_of_frames())`.
  std::size_t first_item(std::size_t k) const { return m_first[k]; }

  /// in the unit of the amplitude.
  double weight(std::size_t item) const { return m_weights[item]; }

  /// how much is seen of the frame's items, from 0 to 1.
  void operator()(const Surface_view& view, float* seen) const
  {
    for (std::size_t i = m_first[view.frame_rank()]; i < m_first[view.frame_rank() + 1]; ++i) {
      const double cosine = std::abs(view.cosine(m_vertices[i]));
      const double size = cosine < m_full_cosine ? cosine / m_full_cosine : 1;
      *seen++ = size > 0 ? float(size * view.visibility(m_vertices[i])) : 0.f;
    }
  }

private:
  static void check(const Feature_point& f, const Rest_shape& shape, std::size_t number_of_frames)
  {
    if (f.vertex_index >= shape.number_of_vertices() || f.frame >= number_of_frames || !(f.sigma > 0))
      throw Input_error("the feature at vertex " + std::to_string(f.vertex_index) + " in frame " +
                        std::to_string(f.frame) + " has sigma " + std::to_string(f.sigma) + ", the animation " +
                        std::to_string(shape.number_of_vertices()) + " vertices and " +
                        std::to_string(number_of_frames) + " frames");
  }

  // The rank of the frame nearest to m, of a cycle of so many frames, 0: of none; the earlier of two.
  static std::size_t nearest(const std::vector<std::size_t>& frames, std::size_t m, std::size_t cycle)
  {
    const std::size_t n = frames.size(),
                      k = std::size_t(std::lower_bound(frames.begin(), frames.end(), m) - frames.begin());
    if (cycle == 0 && (k == 0 || k == n)) return k == 0 ? 0 : n - 1;
    const std::size_t before = k > 0 ? k - 1 : n - 1, after = k < n ? k : 0;
    const std::size_t to_before = k > 0 ? m - frames[before] : m + cycle - frames[before],
                      to_after = k < n ? frames[after] - m : frames[after] + cycle - m;
    return to_before <= to_after ? before : after;
  }

  // Vertices with their share of the disc's area: all, or so many, evenly spread over the distances.
  static std::vector<std::pair<Rest_shape::Index, double>> sampled(const std::vector<Rest_shape::Index>& disc,
                                                                   const std::vector<double>& areas)
  {
    const std::size_t most = 64;
    const std::size_t step = (disc.size() + most - 1) / most;
    std::vector<std::pair<Rest_shape::Index, double>> result;
    double sum = 0;
    for (std::size_t i = 0; i < disc.size(); i += step)
      result.emplace_back(disc[i], areas[disc[i]]), sum += areas[disc[i]];
    for (auto& w : result) w.second = sum > 0 ? w.second / sum : 1 / double(result.size());
    return result;
  }

  double m_full_cosine;
  std::vector<std::size_t> m_first; // of the items of each frame
  std::vector<Rest_shape::Index> m_vertices;
  std::vector<double> m_weights;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_FEATURE_VIEW_SCORE_H
