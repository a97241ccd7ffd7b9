// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_SCALE_SAMPLING_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_SCALE_SAMPLING_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>
#include <CGAL/Animated_mesh_features/Scale_space/is_periodic.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesScaleSpace

Levels at a fixed ratio, in units that do not depend on how surface and motion are sampled; a model of `ScaleSampling`,
the default.

Between `min` and `max` of a range lie \f$\mathrm{round}(\log_\rho(\max/\min)) + 1\f$ levels of ratio \f$\rho\f$ at
which features are found; the response is computed at one level more on either side, and needs yet another one for its
differences. A feature whose refined scale is outside of the range is not reported: it belongs to another range, and a clip
of half the frame rate would not have it.

Where a range begins, features count less and less, see `Scale_fade`: by their scales, those of two animations that show the
same, at another frame rate or on another mesh, would be on this side in one and on that side in the other.

The two terms of the response differ by a velocity, \f$\sigma\f$ over \f$\tau\f$, so that a length and a time have to be
fixed. They are the same for all ranges, clips and frame rates, so that responses are, too.

\cgalModels{ScaleSampling}
*/
struct Fixed_ratio_sampling
{
  /// the ratio of the levels in \f$\sigma\f$. At \f$\sqrt2\f$ the error of interpolated scales is below 3 %, at 2 5.5
  /// %.
  double sigma_ratio = std::sqrt(2.);

  /// the ratio of the levels in \f$\tau\f$, closer than in \f$\sigma\f$: the strongest events last one or two frames,
  /// where the response falls off within few levels, and a level in time costs little. Features of the same motion at
  /// another frame rate are found again more often, by up to 8 % of the strongest 50, than at \f$\sqrt2\f$.
  double tau_ratio = std::cbrt(2.);

  /// the range of \f$\sigma\f$ (length); by default 0.495 % to 17.5 % of the diameter of the rest shape: wrists and ankles
  /// are small, and strong from 0.8 % on. What the mesh cannot resolve is left out; the range begins there, then.
  Scale_range sigma;

  /// from that many times the smallest \f$\sigma\f$ on features count as strong as they are, and from 0.4 times
  /// `unit_length` on in any case, 2 % of the diameter: ankles and wrists; 1: all do.
  double sigma_fade = 1.6;

  /// likewise for \f$\tau\f$. What takes less than two frames is sampled by one or two: whether it is found depends on when
  /// the frames are taken. At half the frame rate, .88 of the strongest 50 features of a galloping horse are found again, in
  /// place of .72. But what takes 1.2 times `unit_time` counts as strong as it is: at ten frames a second all that bodies do
  /// lasts a frame or two.
  double tau_fade = 2;

  /// the range of \f$\tau\f$ (seconds); by default from one frame to a third of the duration: a gesture that is held
  /// takes up much of its clip. Of a cyclic animation (see `is_periodic()`) to a quarter of the period: the slowest event
  /// that it can hold, a single wave, has its strongest response at a fifth.
  Scale_range tau;

  /// the length in which the response measures \f$\sigma\f$; 0: 5 % of the diameter of the rest shape, the size of a
  /// joint.
  double unit_length = 0;

  /// the time in which the response measures \f$\tau\f$ (seconds); by default that of a quick movement of a body. For
  /// animations whose seconds are not those of a body, set it to what lasts short there.
  double unit_time = 0.1;

  /// scales of more than that many diameters, or durations, are refused: all is average then, and filters would go on
  /// without end.
  static constexpr double largest_relative_scale = 10;

  /// more levels than that between the ends of a range are refused, as of a range that begins at next to nothing.
  static constexpr long most_levels = 500;

  /// chooses the levels; asks the spatial filter for its `smallest_variance()`, below which levels are left out.
  /// \throw Option_error if a range is empty, nothing of it can be resolved by the mesh or by the frames, it goes beyond
  /// `largest_relative_scale`, or has more than `most_levels`.
  template <class SpatialFilter, class TemporalFilter>
  Scale_levels operator()(const Rest_shape& shape, std::size_t number_of_frames, double frame_duration,
                          const SpatialFilter& spatial, const TemporalFilter& temporal) const
  {
    const double duration = double(number_of_frames) * frame_duration;
    const Scale_range s = completed(sigma, smallest_share * shape.diameter(), 0.175 * shape.diameter());
    const double longest = duration / (is_periodic(temporal) ? 4 : 3);
    const Scale_range t = completed(tau, frame_duration, (std::max)(longest, frame_duration));
    check_largest(s, "sigma", shape.diameter(), "diameter of the rest shape");
    check_largest(t, "tau", duration, "duration of the animation");
    if (!(sigma_fade >= 1) || !(tau_fade >= 1))
      throw Option_error("the factors within which features fade where ranges of scales begin must be at least 1");
    if (!(unit_length >= 0) || !(unit_time > 0))
      throw Option_error("the units of the response must be a length and a time, both positive");
    Scale_levels levels;
    // The smallest level, two below the first at which features are found, must have a variance that the filter can
    // make.
    const double finest = sigma_ratio * sigma_ratio * std::sqrt(spatial.smallest_variance(shape));
    levels.space_variances = variances(s, sigma_ratio, finest, "sigma", "edge length of the mesh");
    levels.time_variances = variances(t, tau_ratio, 0, "tau", "time between frames");
    levels.unit_length = unit_length > 0 ? unit_length : 0.05 * shape.diameter();
    levels.unit_time = unit_time;
    levels.reported_sigma = s;
    levels.reported_tau = t;
    levels.sigma_fade = fade(s, sigma_fade, 0.4 * levels.unit_length, levels.space_variances[2], sigma_ratio);
    levels.tau_fade = fade(t, tau_fade, 1.2 * unit_time, levels.time_variances[2], tau_ratio);
    return levels;
  }

private:
  static constexpr double smallest_share = 0.00495; // of the diameter, see `sigma`

  // Refined scales go down to half a level below the first one. A range that is short counts in full from its middle on,
  // and all of it that is longer than `most`.
  static Scale_fade fade(const Scale_range& range, double ratio, double most, double first_variance, double level_ratio)
  {
    Scale_fade result;
    result.from = (std::max)(range.min, std::sqrt(first_variance / level_ratio));
    const double full = (std::min)({result.from * ratio, std::sqrt(result.from * range.max), most});
    result.full = (std::max)(result.from, full);
    return result;
  }

  static Scale_range completed(Scale_range r, double min, double max)
  {
    if (r.min == 0) r.min = min;
    if (r.max == 0) r.max = max;
    return r;
  }

  static void check_largest(const Scale_range& range, const char* name, double extent, const char* what)
  {
    if (!(range.max > largest_relative_scale * extent)) return;
    std::ostringstream message;
    message << "the range of " << name << " up to " << range.max << " goes beyond " << largest_relative_scale
            << " times the " << what << ", " << extent << ", where nothing is left to be found";
    throw Option_error(message.str());
  }

  // Levels below what can be resolved are left out, the others stay where they are: twins of different sampling have
  // the same levels.
  static std::vector<double>
  variances(const Scale_range& range, double ratio, double finest, const char* name, const char* limit)
  {
    if (!(ratio > 1)) throw Option_error("the ratio of scale levels must be above 1");
    if (!(range.min > 0) || !(range.max >= range.min) || !std::isfinite(range.max)) {
      std::ostringstream message;
      message << "the range of " << name << " from " << range.min << " to " << range.max << " is empty";
      throw Option_error(message.str());
    }
    const double number = (std::log(range.max) - std::log(range.min)) / std::log(ratio);
    if (!(number < double(most_levels))) {
      std::ostringstream message;
      message << "the range of " << name << " from " << range.min << " to " << range.max << " has " << std::ceil(number)
              << " levels; at most " << most_levels << " are made";
      throw Option_error(message.str());
    }
    const long last = std::lround(number);
    if (!std::isfinite(finest)) throw Option_error(std::string("the ") + limit + " is not finite");
    const long first =
        finest > range.min ? long(std::ceil(std::log(finest / range.min) / std::log(ratio) - 1e-9)) : 0;
    if (first > last) {
      std::ostringstream message;
      message << "the range of " << name << " up to " << range.max << " lies below " << finest << ", which the "
              << limit << " can resolve";
      throw Option_error(message.str());
    }
    std::vector<double> result;
    for (long j = first - 2; j <= last + 2; ++j) {
      const double scale = range.min * std::pow(ratio, double(j));
      result.push_back(scale * scale);
    }
    return result;
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesScaleSpace

Every smoothing count, with the names that the paper \cgalCite{mykhalchuk2014} gives the scales; a model of
`ScaleSampling`.

Level (k, l) is k passes of the spatial and l passes of the temporal filter, for all k up to
\f$K = \lfloor 6\, r_s^2/h^2 \rfloor\f$ and l up to \f$L = \lfloor 6\, r_t^2/w^2 \rfloor\f$ (Eqs. 9 and 10), where
\f$r_s\f$ is 3 % of the bounding-box diagonal, \f$r_t\f$ half of the duration, h the mean edge length and w the width of
the box. This reproduces the counts in time of the paper's Table 1: 54 (F = 48, w = 8), 113 (139, 16), 107 (169, 20), 94
(159, 20), 57 (99, 16), 150 (100, 10), 114 (70, 8). (The table's 100 for the cylinder with F = 40 fits w = 5 with w² - 1
in the denominator only.) In space it gives 78 for the first frame of the horse's gallop, for which the table has 77.

A scale is named by Eq. (7), \f$\sigma = \sqrt{k (h^2 - 1)/12}\f$, in which h counts samples but the paper puts the
length of an edge in the unit of the mesh. That is imaginary for h < 1. This class therefore measures lengths in a unit
of which the mean edge has `edge_length_in_units`; the \f$\sigma\f$ that results is 0.42 of the standard deviation that
the averages really have on a regular mesh. Times are measured in frames.

\cgalModels{ScaleSampling}
*/
struct Every_smoothing_count
{
  /// the paper's mean edge length of the horse (Table 1).
  double edge_length_in_units = 3.48;

  /// \f$r_s\f$ as a fraction of the bounding-box diagonal.
  double radius_over_diagonal = 0.03;

  /// w (frames); 0: by the variance that a pass of the temporal filter adds, taken as that of a box, \f$(w^2-1)/12\f$.
  std::size_t box_width = 0;

  std::size_t max_space_count = 0; ///< K; 0: by the formula above
  std::size_t max_time_count = 0;  ///< L; 0: by the formula above

  /// the number of averages whose blob has a radius of that many widths: \f$\lfloor 6 x^2 \rfloor\f$.
  /// \throw Option_error if that are more than 100,000, as where a mesh consists of small parts far apart.
  static std::size_t largest_count(double radius_over_width)
  {
    const double most_counts = 1e5; // ten times those of a million vertices
    // the largest blob's radius is sqrt(2) sigma, and n boxes of width w have sigma^2 = n w^2 / 12 (without Eq. (7)'s
    // -1)
    const double count = std::floor(6 * radius_over_width * radius_over_width * (1 + 1e-12));
    if (!(count <= most_counts)) {
      std::ostringstream message;
      message << "there would be " << count << " smoothing counts, because edges or frames are so small a part of the "
              << "whole; limit the counts (max_space_count, max_time_count)";
      throw Option_error(message.str());
    }
    return std::size_t(count);
  }

  /// chooses the levels; asks both filters for their `unit_variance()`.
  /// \throw Option_error if there are not enough levels for an extremum between levels, or see `largest_count()`.
  template <class SpatialFilter, class TemporalFilter>
  Scale_levels operator()(const Rest_shape& shape,
                          std::size_t number_of_frames,
                          double frame_duration,
                          const SpatialFilter& spatial,
                          const TemporalFilter& temporal) const
  {
    const double h = shape.mean_edge_length();
    const double space_unit = spatial.unit_variance(shape);
    const double time_unit = temporal.unit_variance(number_of_frames, frame_duration);
    const double width =
        box_width > 0 ? double(box_width) : std::sqrt(12 * time_unit / (frame_duration * frame_duration) + 1);
    if (!(space_unit > 0) || !(time_unit > 0) || !(width > 1))
      throw Option_error("a pass of a filter adds no variance (a box of one frame?): there is nothing to count");
    const std::size_t space_count =
        max_space_count > 0 ? max_space_count : largest_count(radius_over_diagonal * shape.bounding_box_diagonal() / h);
    const std::size_t time_count =
        max_time_count > 0 ? max_time_count : largest_count(double(number_of_frames) / 2 / width);
    if (space_count < 3 || time_count < 3)
      throw Option_error("there are " + std::to_string(space_count) + " smoothing counts in space and " +
                         std::to_string(time_count) +
                         " in time; at least 3 are needed (a coarse mesh or a wide box allows fewer)");
    Scale_levels levels;
    for (std::size_t k = 0; k <= space_count; ++k) levels.space_variances.push_back(double(k) * space_unit);
    for (std::size_t l = 0; l <= time_count; ++l) levels.time_variances.push_back(double(l) * time_unit);
    levels.unit_length = h / edge_length_in_units;
    levels.unit_time = frame_duration;
    const double named = (edge_length_in_units * edge_length_in_units - 1) / 12; // Eq. (7), k = 1
    levels.sigma_factor = std::sqrt(named / space_unit) * levels.unit_length;
    levels.tau_factor = std::sqrt((width * width - 1) / 12 / time_unit) * frame_duration;
    return levels;
  }
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_SCALE_SAMPLING_H
