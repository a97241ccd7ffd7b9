// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_BOX_TEMPORAL_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_BOX_TEMPORAL_FILTER_H

#include <CGAL/Animated_mesh_features/Scale_space/Boundary_condition.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Boundary_extension.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Window_sum.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/window_sums.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/number_of_passes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing in time by repeated box averages; a model of `TemporalFilter`.

With a given width w, a level is a number of passes of that box, each of which adds the variance \f$(w^2-1)/12\f$
frames². An even box has no middle frame; it is taken as w + 1 frames of which the first and the last count half, with
variance
\f$(w^2+2)/12\f$.

With width 0, each level is `passes` passes of an extended box \cgalCite{gwosdek2011}, whose two end frames have a
weight that gives any variance exactly.

\cgalModels{TemporalFilter}
*/
class Box_temporal_filter
{
public:
  /// rows may be those of several vertices at once, see `TemporalFilter`.
  static constexpr bool vectorized = true;

  /// makes a filter without levels.
  /// \param width of the box in frames, or 0 for boxes that fit the variances.
  /// \param ends what is averaged over where a box reaches beyond the row.
  explicit Box_temporal_filter(std::size_t width = 0, Boundary_condition ends = Boundary_condition::REFLECT)
    : m_width(width)
    , m_ends(ends)
  {}

  /// passes from level to level with width 0: the fourfold convolution of a box is visually a Gaussian already, and
  /// passes add up over the levels.
  static constexpr std::size_t passes = 3;

  /// the width of the box in frames; 0: boxes that fit the variances.
  std::size_t width() const { return m_width; }

  /// the variance that one pass adds, in squared seconds; that of three frames with width 0.
  double unit_variance(std::size_t /* number_of_frames */, double frame_duration) const
  {
    return box_of_width(m_width > 0 ? m_width : 3).variance() * frame_duration * frame_duration;
  }

  /// prepares the levels.
  /// \param number_of_frames of each row.
  /// \param frame_duration seconds.
  /// \param variances ascending; squared seconds.
  /// \throw Option_error if more than 1e9 passes would be needed.
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
        const std::size_t count = (std::max)(total, internal::number_of_passes(u, unit));
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
    std::size_t widest = 0;
    for (const Step& step : m_steps) widest = (std::max)(widest, 2 * step.box.reach + 2);
    m_extension = internal::Boundary_extension(number_of_frames, 2 * widest, m_ends);
  }

  /// the variance attained at level `l`.
  double variance(std::size_t l) const { return m_steps[l].variance; }

  /// whether every level from the second on is the level before it after one and the same operation.
  bool has_equal_steps() const
  {
    for (std::size_t l = 2; l < m_steps.size(); ++l)
      if (m_steps[l].passes != m_steps[1].passes || m_steps[l].box.reach != m_steps[1].box.reach ||
          m_steps[l].box.end != m_steps[1].box.end)
        return false;
    return true;
  }

  /// smooths a row of frames from level `l` - 1 (the unsmoothed row for `l` = 0) to level `l`; `in` and `out` do not
  /// overlap.
  /// \tparam T `float`, `double`, or several of them that are computed with as one, see `vectorized`.
  template <class T>
  void operator()(std::size_t l, const T* in, T* out) const
  {
    const Step& step = m_steps[l];
    if (step.passes == 0) std::copy(in, in + m_frames, out);
    // a pass reads one row and writes another; the last one writes `out`
    static thread_local std::vector<T> buffer;
    if (step.passes > 1 && buffer.size() < m_frames) buffer.resize(m_frames);
    for (std::size_t i = 0; i < step.passes; ++i) {
      T* const to = (step.passes - i) % 2 == 1 ? out : buffer.data();
      average(step.box, in, to);
      in = to;
    }
  }

  /// \name What Long Rows Need
  /// See `TemporalFilter`.
  /// @{

  /// whether a row is continued by its mirror image.
  bool reflects() const { return m_ends == Boundary_condition::REFLECT; }

  /// whether a row is continued by itself.
  bool is_periodic() const { return m_ends == Boundary_condition::PERIODIC; }

  /// the weights of level `l` with respect to the unsmoothed row, by distance on the circle of F frames, or of the 2 F on which
  /// the row and its mirror image live: all up to the opposite frame. Only if the filter is periodic or reflects. Linear in F
  /// times the number of passes.
  std::vector<double> weights_by_distance(std::size_t l) const
  {
    std::vector<double> circle(is_periodic() ? m_frames : 2 * m_frames, 0), next(circle.size());
    circle[0] = 1;
    for (std::size_t level = 0; level <= l; ++level)
      for (std::size_t pass = 0; pass < m_steps[level].passes; ++pass) {
        average_on_circle(m_steps[level].box, circle, next);
        circle.swap(next);
      }
    circle.resize(circle.size() / 2 + 1);
    return circle;
  }
  /// @}

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

  template <class T>
  void average(const Box& box, const T* in, T* out) const
  {
    typedef typename internal::Scalar_of<T>::type Scalar;
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames), r = std::ptrdiff_t(box.reach);
    const Scalar factor = Scalar(1 / box.total());
    if constexpr (internal::Is_register_pair<T>::value)
      if (m_ends != Boundary_condition::TRUNCATE && average_stream(box, in, out, std::make_index_sequence<stream_widths>()))
        return;
    if (box.end == 0) {
      const auto emit = [=](std::ptrdiff_t f, const T&, const T& sum) { out[f] = sum * factor; };
      internal::window_sums(m_extension, in, -r, n, 2 * r + 1, emit, emit);
    } else if (box.end == 0.5) {
      // the mean of two boxes of even width, one shifted by a frame
      const Scalar half = factor * Scalar(0.5);
      const auto emit = [=](std::ptrdiff_t f, const T& before, const T& sum) { out[f - 1] = (before + sum) * half; };
      const auto emit_first = [=](std::ptrdiff_t f, const T& before, const T& sum) {
        if (f > 0) emit(f, before, sum);
      };
      internal::window_sums(m_extension, in, -r - 1, n + 1, 2 * r + 2, emit_first, emit);
    } else {
      const Scalar end = Scalar(box.end);
      const auto emit = [=](std::ptrdiff_t f, const T&, const T& sum) {
        out[f] = (sum + (m_extension.value(in, f - r - 1) + m_extension.value(in, f + r + 1)) * end) * factor;
      };
      internal::window_sums(m_extension, in, -r, n, 2 * r + 1, emit, emit);
    }
    if (m_ends == Boundary_condition::TRUNCATE)
      for (std::ptrdiff_t f = 0; f < n; ++f)
        if (f <= r || f + r + 1 >= n) out[f] = out[f] * Scalar(box.total() / existing(box, f));
  }

  // One pass over a closed row.
  static void average_on_circle(const Box& box, const std::vector<double>& in, std::vector<double>& out)
  {
    const std::ptrdiff_t n = std::ptrdiff_t(in.size()), r = std::ptrdiff_t(box.reach), margin = 2 * (2 * r + 3);
    std::vector<double> around(std::size_t(n + 2 * margin)); // so that no window reaches beyond it
    for (std::ptrdiff_t i = 0; i < n + 2 * margin; ++i) around[std::size_t(i)] = in[std::size_t(((i - margin) % n + n) % n)];
    const internal::Boundary_extension nothing(around.size(), 0, Boundary_condition::TRUNCATE);
    const double factor = 1 / box.total();
    const auto emit = [&](std::ptrdiff_t f, double, double sum) {
      const std::size_t at = std::size_t(margin + f), reach = std::size_t(r + 1);
      out[std::size_t(f)] = (sum + (around[at - reach] + around[at + reach]) * box.end) * factor;
    };
    internal::window_sums(nothing, around.data(), margin - r, n, 2 * r + 1, emit, emit);
  }

  // Widths for which sums of a stream are compiled, which makes the average twice as fast where the processor has 32
  // registers as wide as the pack; with fewer or narrower ones it would be slower.
  static constexpr std::size_t first_stream_width = 3, stream_widths = 10;

  // false if the box is none of them
  template <class T, std::size_t... i>
  CGAL_ANIMATED_MESH_FEATURES_INLINE bool average_stream(const Box& box, const T* in, T* out,
                                                         std::index_sequence<i...>) const
  {
    const std::size_t width = box.end == 0 ? 2 * box.reach + 1 : box.end == 0.5 ? 2 * box.reach + 2 : 0;
    return ((width == first_stream_width + i && average_stream<first_stream_width + i>(box, in, out)) || ...);
  }

  template <std::size_t width, class T>
  CGAL_ANIMATED_MESH_FEATURES_INLINE bool average_stream(const Box& box, const T* in, T* out) const
  {
    typedef internal::Window_sum<T, width> Sum;
    constexpr bool is_even = width % 2 == 0;
    constexpr std::size_t lead = is_even ? width : width - 1; // frames that come before the first sum is complete
    const auto factor = typename internal::Scalar_of<T>::type((is_even ? 0.5 : 1) / box.total());
    const std::size_t* const sources = m_extension.sources(-std::ptrdiff_t(width / 2));
    Sum sums(T::all(0));
    T before = T::all(0);
    const auto step = [&](std::size_t i) CGAL_ANIMATED_MESH_FEATURES_INLINE_LAMBDA {
      const T sum = sums.push(in[sources[i]]);
      // what is not complete is overwritten
      out[i < lead ? 0 : i - lead] = (is_even ? before + sum : sum) * factor;
      before = sum;
    };
    const std::size_t count = m_frames + lead;
    std::size_t i = 0;
    for (; i + Sum::period <= count; i += Sum::period) {
      CGAL_ANIMATED_MESH_FEATURES_UNROLL
      for (std::size_t j = 0; j < Sum::period; ++j) step(i + j);
    }
    for (; i < count; ++i) step(i);
    return true;
  }

  // The total weight of the frames that exist around frame f.
  double existing(const Box& box, std::ptrdiff_t f) const
  {
    const std::ptrdiff_t n = std::ptrdiff_t(m_frames), r = std::ptrdiff_t(box.reach);
    const std::ptrdiff_t first = (std::max)(std::ptrdiff_t(0), f - r), last = (std::min)(n - 1, f + r);
    return double(last - first + 1) + (f - r - 1 >= 0 ? box.end : 0) + (f + r + 1 < n ? box.end : 0);
  }

  std::size_t m_width;
  Boundary_condition m_ends;
  std::size_t m_frames = 0;
  std::vector<Step> m_steps;
  internal::Boundary_extension m_extension;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_BOX_TEMPORAL_FILTER_H
