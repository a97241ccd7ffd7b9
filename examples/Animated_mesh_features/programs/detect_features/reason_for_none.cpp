// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/reason_for_none.h"

#include "detect_features/check_scales.h"
#include "running/counted.h"

#include <cstddef>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;

using Programs::counted;
using Programs::Sequence;

namespace Detect_features {

namespace {

// The options that limit the scales, as they were typed; empty if none was.
std::string typed_limits(const Method_options& o)
{
  std::ostringstream os;
  if (!o.sigma.text.empty()) os << "--sigma-range " << o.sigma.text << ' ';
  if (!o.tau.text.empty()) os << "--tau-range " << o.tau.text << ' ';
  if (o.space_counts) os << "--space-counts " << *o.space_counts << ' ';
  if (o.time_counts) os << "--time-counts " << *o.time_counts << ' ';
  if (o.box_width) os << "--box-width " << *o.box_width << ' ';
  std::string text = os.str();
  if (!text.empty()) text.pop_back();
  return text;
}

// Nothing comes and goes within so few frames.
bool has_few_frames(const Sequence& sequence)
{
  const std::size_t usual_least = 12;
  return sequence.number_of_frames() < usual_least;
}

// Why no minimum may be within the scales: each is the end of a sentence.
std::string causes(const Sequence& sequence, const Method_options& o, const Detection& d)
{
  std::string causes;
  const std::string typed = typed_limits(o);
  if (!typed.empty())
    causes += "; " + typed + (typed.find(" --") == std::string::npos ? " excludes" : " exclude") + " others";
  const double sigma = d.scales.sigma_levels[d.scales.levels_below];
  if (o.sigma.text.empty() && is_limited_by_mesh(sequence.rest_shape(), o, sigma))
    causes += "; the mesh is coarse: " + coarse_mesh(sequence.rest_shape(), o);
  if (has_few_frames(sequence))
    causes += "; " + counted(sequence.number_of_frames(), "frame is", "frames are") +
              " few: an event needs some before and after it";
  const Missing_features& m = *d.missing;
  std::ostringstream largest;
  largest << "; the largest deformation, " << m.deformation << ", is at vertex " << m.vertex << " in frame " << m.frame;
  if (!o.is_cyclic && (m.frame == 0 || m.frame + 1 == sequence.number_of_frames()))
    largest << ", the " << (m.frame == 0 ? "first" : "last")
            << ": what only grows or fades has no moment of its own (of a clip, --there-and-back makes one)";
  else if (causes.empty() && o.preset == Preset::CALIBRATED)
    largest << ": it may be larger or last longer than that; --sigma-range and --tau-range take other scales";
  return causes + largest.str();
}

} // namespace

std::string reason_for_none(const Sequence& sequence, const Method_options& o, const Detection& d)
{
  const Missing_features& m = *d.missing;
  std::ostringstream os;
  if (!(m.deformation > m.noise)) {
    os << "nothing deforms: ";
    if (m.deformation > 0)
      os << "the largest deformation, " << m.deformation << ", is within the rounding of the coordinates, " << m.noise;
    else
      os << "all frames have the rest shape, but for how it lies in space";
  } else if (d.number_of_minima > 0) {
    const AMF::Feature_selection& s = d.values.selection;
    if (m.strength < s.absolute_threshold)
      os << "the strongest, " << m.strength << ", is below the threshold, " << s.absolute_threshold << " (--threshold)";
    else if (s.most_features == 0)
      os << "--top 0 wants none";
    else
      os << "no event that is strong enough resembles a Gaussian as much as --min-fit " << s.min_fit
         << " asks for; the strongest, " << m.strength << ", has a fit of " << m.fit;
  } else {
    const Searched_scales& s = d.scales;
    os << "the response has no minimum at sigma from " << s.sigma_levels[s.levels_below] << " to "
       << s.sigma_levels[s.sigma_levels.size() - 1 - s.levels_above] << ", tau from " << s.tau_levels[s.levels_below]
       << " to " << s.tau_levels[s.tau_levels.size() - 1 - s.levels_above] << " s" << causes(sequence, o, d);
  }
  return os.str();
}

} // namespace Detect_features
