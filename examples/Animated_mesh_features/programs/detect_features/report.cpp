// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/report.h"

#include "detect_features/reason_for_none.h"
#include "options/Names.h"
#include "reading/animation_report.h"
#include "running/counted.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <vector>

namespace AMF = CGAL::Animated_mesh_features;

using Programs::add_if;
using Programs::counted;
using Programs::Feature;
using Programs::name;

namespace Detect_features {

namespace {

// The levels at which features may be found.
std::string searched(const char* what, const std::vector<double>& levels, const Searched_scales& scales,
                     const char* unit)
{
  const std::size_t first = scales.levels_below, last = levels.size() - 1 - scales.levels_above;
  std::ostringstream os;
  os << what << " from " << levels[first] << " to " << levels[last] << unit << " (" << last - first + 1 << " levels)";
  return os.str();
}

// The strongest feature, or why there is none.
std::string best(const Programs::Animation& animation, const Method_options& method, const Detection& detection)
{
  if (detection.features.empty()) return ": " + reason_for_none(animation.sequence(), method, detection);
  const Feature& f = detection.features.front();
  std::ostringstream os;
  os << ", the strongest (" << std::fixed << std::setprecision(3) << f.strength << ") at vertex " << f.vertex_index
     << ", frame " << f.frame;
  return os.str();
}

std::string list_of_files(const Programs::Output_options& output)
{
  std::string list;
  const auto add = [&](const auto& files) {
    for (const auto& f : files)
      if (f.path != "-") list += (list.empty() ? "; written to " : ", ") + f.path;
  };
  add(output.features);
  add(output.fields);
  add(output.scenes);
  return list;
}

void add_method_parameters(AMF::IO::Result_description& d, const Method_options& o, const Detection& detection)
{
  const Method_values& values = detection.values;
  const bool has_balls = detection.ball_radius > 0;
  d.add("preset", name(o.preset));
  d.add("strain", name(o.strain));
  d.add("triangle_weights", values.triangle_weights == AMF::Triangle_weights::UNIFORM ? "uniform" : "rest-area");
  d.add("alpha", values.alpha);
  add_if(has_balls, d, "curvature", name(o.curvature));
  add_if(has_balls, d, "balls", name(o.balls));
  add_if(has_balls, d, "ball_radius", detection.ball_radius);
  d.add("baseline", name(o.baseline));
  d.add("spatial_filter", name(o.spatial_filter));
  d.add("temporal_filter", name(o.temporal_filter));
  d.add("cyclic", o.is_cyclic);
  d.add("dimension", name(o.dimension));
  add_if(values.box_width > 0, d, "box_width", values.box_width);
  add_if(o.space_counts.has_value(), d, "space_counts", o.space_counts.value_or(0));
  add_if(o.time_counts.has_value(), d, "time_counts", o.time_counts.value_or(0));
  add_if(!o.sigma.text.empty(), d, "sigma_range", o.sigma.text);
  add_if(!o.tau.text.empty(), d, "tau_range", o.tau.text);
  d.add("sigma_levels", detection.scales.sigma_levels);
  d.add("tau_levels", detection.scales.tau_levels);
  d.add("threshold", values.selection.absolute_threshold);
  d.add("relative_threshold", values.selection.relative_threshold);
  d.add("min_fit", values.selection.min_fit);
  add_if(o.top.has_value(), d, "top", o.top.value_or(0));
  d.add("suppression", values.selection.suppress_non_maxima);
}

} // namespace

std::string detection_report(const Detection& detection)
{
  const Searched_scales& scales = detection.scales;
  std::ostringstream os;
  if (detection.ball_radius > 0)
    os << "balls: radius " << detection.ball_radius
       << (detection.bounds_ball_radius ? ", smaller than usual so that balls have 1,500 vertices at most in the mean" : "")
       << "\n";
  os << "scales: " << searched("sigma", scales.sigma_levels, scales, "") << ", "
     << searched("tau", scales.tau_levels, scales, " s") << "\n";
  const std::size_t at_limit = std::size_t(std::count_if(detection.features.begin(), detection.features.end(),
                                                         [](const Feature& f) { return f.at_scale_limit; }));
  os << "found: " << counted(detection.number_of_minima, "minimum", "minima") << " of the response, "
     << counted(detection.features.size(), "feature", "features") << ", " << at_limit
     << " of them at a limit of the scales\n";
  return os.str();
}

std::string summary(const Programs::Output_options& output, const Programs::Animation& animation,
                    const Method_options& method, const Detection& detection, const Durations& seconds)
{
  const std::string& reason = animation.rest().reason;
  std::ostringstream os;
  os << counted(detection.features.size(), "feature", "features") << " in "
     << counted(animation.sequence().number_of_frames(), "frame", "frames") << " against " << animation.rest().name
     << (reason.empty() ? "" : " (" + reason + ")") << std::fixed << std::setprecision(1) << ", computed in "
     << seconds.computing << " s";
  const double worth_telling = 0.05;
  if (seconds.writing >= worth_telling) os << (output.scenes.empty() ? ", written in " : ", pictures and files in ") << seconds.writing << " s";
  os << best(animation, method, detection) << list_of_files(output) << '\n';
  return os.str();
}

AMF::IO::Result_description result_description(const Programs::Reading_options& reading, const Method_options& method,
                                               const Programs::Animation& animation, const Detection& detection)
{
  AMF::IO::Result_description d = Programs::animation_description(animation);
  d.add("diameter", animation.sequence().rest_shape().diameter()); // of which lengths in % are
  d.add("program", std::string("detect_features ") + ANIMATED_MESH_FEATURES_VERSION);
  add_reading_parameters(d, reading, animation);
  add_method_parameters(d, method, detection);
  return d;
}

} // namespace Detect_features
