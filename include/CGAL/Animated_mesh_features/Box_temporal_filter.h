// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_BOX_TEMPORAL_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_BOX_TEMPORAL_FILTER_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

What a box average takes for the frames before the first and behind the last one. (Never zero: the field is not zero
there, and the false step at the ends makes several times as many spurious extrema as there are true ones.)
*/
enum class Row_ends
{
  REFLECT,   ///< the mirror image of the row: ... 1 0 | 0 1 2 ...; keeps the mean. The default.
  REPLICATE, ///< the first and the last value
  TRUNCATE   ///< nothing: the mean of the frames that exist
};

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing in time by repeated box averages; a model of `TemporalFilter`.

With a given width w, a level is a number of passes of that box, each of which adds the variance \f$(w^2-1)/12\f$
frames². An even box has no middle frame; it is taken as w + 1 frames of which the first and the last count half, with
variance
\f$(w^2+2)/12\f$.

With width 0, each level is `passes` passes of an extended box (Gwosdek et al. 2011), whose two end frames have a weight
that gives any variance exactly.
*/
class Box_temporal_filter
{
public:
  /// \param width of the box in frames, or 0 for boxes that fit the variances.
  explicit Box_temporal_filter(std::size_t width = 0, Row_ends ends = Row_ends::REFLECT)
    : m_width(width)
    , m_ends(ends)
  {
  }

  /// passes from level to level with width 0: the fourfold convolution of a box is visually a Gaussian already, and
  /// passes add up over the levels.
  static constexpr std::size_t passes = 3;

  std::size_t width() const { return m_width; }

  /// the variance that one pass adds, in squared seconds; that of three frames with width 0.
  double unit_variance(std::size_t /* number_of_frames */, double frame_duration) const
  {
    return box_of_width(m_width > 0 ? m_width : 3).variance() * frame_duration * frame_duration;
  }

  /// prepares the levels.
  /// \param variances ascending; squared seconds.
  void initialize(std::size_t number_of_frames, double frame_duration, const std::vector<double>& variances)
  {
    m_frames = number_of_frames;
    m_steps.clear();
    const double unit = unit_variance(number_of_frames, frame_duration);
    std::size_t total = 0;
    double attained = 0;
    for (double u : variances) {
      Step step = {Box{0, 0}, 0, attained};
      if (m_width > 0) {
        const std::size_t count = (std::max)(total, std::size_t(std::llround(u / unit)));
        step.box = box_of_width(m_width);
        step.passes = count - total;
        total = count;
        attained = double(total) * unit;
      } else if (u > attained) {
        step.box = box_of_variance((u - attained) / (frame_duration * frame_duration) / double(passes));
        step.passes = passes;
        attained = u;
      }
      step.variance = attained;
      m_steps.push_back(step);
    }
  }

  /// the variance attained at level `l`.
  double variance(std::size_t l) const { return m_steps[l].variance; }

  /// smooths a row of frames from level `l` - 1 (the unsmoothed row for `l` = 0) to level `l`; `in` and `out` do not
  /// overlap.
  template <class FT>
  void operator()(std::size_t l, const FT* in, FT* out) const
  {
    std::copy(in, in + m_frames, out);
    for (std::size_t i = 0; i < m_steps[l].passes; ++i) average(m_steps[l].box, out);
  }

private:
  // Frames up to `reach` away count fully, those at reach + 1 with weight `end`.
  struct Box
  {
    std::size_t reach;
    double end;

    double total() const { return 2 * double(reach) + 1 + 2 * end; }
    double variance() const
    {
      const double r = double(reach);
      return (r * (r + 1) * (2 * r + 1) / 3 + 2 * end * (r + 1) * (r + 1)) / total();
    }
  };

  struct Step
  {
    Box box;
    std::size_t passes;
    double variance;
  };

  static Box box_of_width(std::size_t w) { return w % 2 ? Box{(w - 1) / 2, 0} : Box{w / 2 - 1, 0.5}; }

  static Box box_of_variance(double v)
  {
    // a box without ends has variance r (r + 1) / 3
    const std::size_t reach = std::size_t(std::floor((std::sqrt(1 + 12 * v) - 1) / 2));
    const double r = double(reach);
    const double end = (v * (2 * r + 1) - r * (r + 1) * (2 * r + 1) / 3) / (2 * ((r + 1) * (r + 1) - v));
    return Box{reach, (std::max)(0., end)};
  }

  // The value of frame f, continued beyond the ends; weight 0 for a frame that is left out.
  struct Extended_frame
  {
    std::size_t frame;
    double weight;
  };
  Extended_frame extended(std::ptrdiff_t f) const
  {
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames);
    if (f >= 0 && f < n) return {std::size_t(f), 1};
    switch (m_ends) {
    case Row_ends::TRUNCATE: return {0, 0};
    case Row_ends::REPLICATE: return {std::size_t(f < 0 ? 0 : n - 1), 1};
    case Row_ends::REFLECT: break;
    }
    f %= 2 * n;
    if (f < 0) f += 2 * n;
    return {std::size_t(f < n ? f : 2 * n - 1 - f), 1};
  }

  template <class FT>
  void average(const Box& box, FT* row) const
  {
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames), r = std::ptrdiff_t(box.reach);
    // prefix sums of values and weights from frame -r-1 on, in double: a running sum would collect rounding errors
    static thread_local std::vector<double> values, weights;
    values.assign(std::size_t(n + 2 * r + 3), 0);
    weights.assign(values.size(), 0);
    for (std::ptrdiff_t i = 0; i < n + 2 * r + 2; ++i) {
      const Extended_frame e = extended(i - r - 1);
      values[std::size_t(i) + 1] = values[std::size_t(i)] + e.weight * double(row[e.frame]);
      weights[std::size_t(i) + 1] = weights[std::size_t(i)] + e.weight;
    }
    const auto sum = [&](const std::vector<double>& prefix, std::ptrdiff_t f) {
      const std::size_t a = std::size_t(f), b = std::size_t(f + 2 * r + 3); // all of -r-1 .. r+1 around f
      const double inner = prefix[b - 1] - prefix[a + 1];
      return inner + box.end * ((prefix[a + 1] - prefix[a]) + (prefix[b] - prefix[b - 1]));
    };
    for (std::ptrdiff_t f = 0; f < n; ++f) row[f] = FT(sum(values, f) / sum(weights, f));
  }

  std::size_t m_width;
  Row_ends m_ends;
  std::size_t m_frames = 0;
  std::vector<Step> m_steps;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_BOX_TEMPORAL_FILTER_H
