// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_REPORT_H
#define DETECT_FEATURES_REPORT_H

#include "reading/Animation.h"
#include "detect_features/Command_line.h"
#include "output/Scene_files.h"
#include "detect_features/Stage_log.h"
#include "detect_features/detect.h"

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/IO/Clip_sampling.h>
#include <CGAL/Animated_mesh_features/IO/Result_description.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace Detect_features {

namespace AMF = CGAL::Animated_mesh_features;

namespace internal {

inline std::string counted(std::size_t n, const std::string& singular, const std::string& plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

// The levels at which features may be found: those outside of them are there to be compared with.
inline std::string searched(const char* what, const std::vector<double>& levels, const Detection& detection,
                            const char* unit)
{
  const std::size_t first = detection.levels_below, last = levels.size() - 1 - detection.levels_above;
  std::ostringstream os;
  os << what << " from " << levels[first] << " to " << levels[last] << unit << " (" << last - first + 1 << " levels)";
  return os.str();
}

} // namespace internal

// The animation and the detection as writers of scenes take them.
inline Shown_scene scene(const Command_line& c, const Animation& animation, const Detection& detection)
{
  std::filesystem::path first = c.inputs.front();
  if (!first.has_filename()) first = first.parent_path(); // of "frames/"
  Shown_scene s{animation.sequence(), detection.features, {}, first.stem().string()};
  for (const Shown_field& f : detection.shown_fields) s.fields.push_back({name(f.kind), &f.values});
  return s;
}

// What the JSON file tells: all that is needed to find the same features again.
inline AMF::IO::Result_description description(const Command_line& c, const Animation& animation,
                                               const Detection& detection)
{
  const AMF::Rest_shape& shape = animation.sequence().rest_shape();
  AMF::IO::Result_description d;
  d.vertices = animation.sequence().number_of_vertices();
  d.faces = animation.number_of_faces();
  d.frames = animation.sequence().number_of_frames();
  d.frame_duration = animation.sequence().frame_duration();
  d.bounding_box_diagonal = shape.bounding_box_diagonal();
  d.mean_edge_length = shape.mean_edge_length();
  d.origins = animation.origins();

  const AMF::IO::Result_description::Value none = std::monostate();
  const auto add_if = [&](bool is_used, const std::string& name, const auto& value) {
    if (is_used)
      d.add(name, value);
    else
      d.add(name, none);
  };
  d.add("program", std::string("detect_features ") + ANIMATED_MESH_FEATURES_VERSION);
  d.add("inputs", c.inputs);
  d.add("triangulate", c.triangulate);
  d.add("fps", animation.frames_per_second());
  add_if(!animation.clips().empty(), "clip", animation.clip_name());
  add_if(animation.is_sampled() && (c.clip_frames || !c.frames_per_second), "frames",
         c.there_and_back ? (d.frames + 1) / 2 : d.frames);
  add_if(animation.is_sampled(), "there_and_back", c.there_and_back);
  add_if(!c.faces_dataset.empty(), "faces", c.faces_dataset);
  d.add("rest", c.rest);
  d.add("rescale_rest", c.rescale_rest);
  d.add("rest_factor", animation.rest_factor());
  d.add("preset", name(c.preset));
  d.add("strain", name(c.strain));
  d.add("triangle_weights", detection.triangle_weights == AMF::Triangle_weights::UNIFORM ? "uniform" : "rest-area");
  d.add("alpha", detection.alpha);
  add_if(detection.ball_radius > 0, "curvature", name(c.curvature));
  add_if(detection.ball_radius > 0, "balls", name(c.balls));
  add_if(detection.ball_radius > 0, "ball_radius", detection.ball_radius);
  d.add("spatial_filter", name(c.spatial_filter));
  d.add("temporal_filter", name(c.temporal_filter));
  add_if(detection.box_width > 0, "box_width", detection.box_width);
  add_if(bool(c.space_counts), "space_counts", c.space_counts.value_or(0));
  add_if(bool(c.time_counts), "time_counts", c.time_counts.value_or(0));
  add_if(!c.sigma.text.empty(), "sigma_range", c.sigma.text);
  add_if(!c.tau.text.empty(), "tau_range", c.tau.text);
  d.add("sigma_levels", detection.sigma_levels);
  d.add("tau_levels", detection.tau_levels);
  d.add("threshold", detection.selection.relative_threshold);
  d.add("absolute_threshold", detection.selection.absolute_threshold);
  d.add("suppression", detection.selection.suppress_non_maxima);
  return d;
}

// For --verbose, as the other reports.
inline std::string animation_report(const Command_line& c, const Animation& animation)
{
  const Sequence& sequence = animation.sequence();
  const AMF::Rest_shape& shape = sequence.rest_shape();
  const AMF::Animation_report r = sequence.report();
  std::ostringstream os;
  os << "animation: " << sequence.number_of_vertices() << " vertices, " << animation.number_of_faces() << " triangles, "
     << sequence.number_of_frames() << " frames, " << animation.frames_per_second()
     << " in a second: " << double(sequence.number_of_frames()) * sequence.frame_duration() << " s\n";
  if (!animation.clips().empty())
    os << "clips: " << AMF::IO::clip_list(animation.clips()) << "; this is " << animation.clip_name() << '\n';
  for (const std::string& remark : animation.remarks()) os << "file: " << remark << '\n';
  os << "rest shape: " << c.rest << ", bounding-box diagonal " << shape.bounding_box_diagonal() << ", mean edge length "
     << shape.mean_edge_length();
  if (c.rescale_rest) os << ", scaled by " << animation.rest_factor();
  os << "\nmesh: " << internal::counted(r.connected_components, "component", "components") << ", "
     << internal::counted(r.border_edges, "border edge", "border edges") << ", "
     << internal::counted(r.isolated_vertices, "isolated vertex", "isolated vertices") << ", "
     << internal::counted(r.degenerate_rest_triangles, "degenerate triangle", "degenerate triangles") << " at rest\n";
  return os.str();
}

// One line, or nothing: of several clips one was taken that nobody chose.
inline std::string clip_notice(const Command_line& c, const Animation& animation)
{
  if (animation.clips().size() < 2 || !c.clip.empty()) return std::string();
  return "clip " + animation.clip_name() + ", the first of " + AMF::IO::clip_list(animation.clips()) +
         "; --clip chooses another\n";
}

inline std::string detection_report(const Detection& detection)
{
  std::ostringstream os;
  if (detection.ball_radius > 0) os << "balls: radius " << detection.ball_radius << "\n";
  os << "scales: " << internal::searched("sigma", detection.sigma_levels, detection, "") << ", "
     << internal::searched("tau", detection.tau_levels, detection, " s") << "\n";
  const std::size_t at_limit = std::size_t(std::count_if(detection.features.begin(), detection.features.end(),
                                                         [](const Feature& f) { return f.at_scale_limit; }));
  os << "found: " << internal::counted(detection.number_of_minima, "minimum", "minima") << " of the response, "
     << internal::counted(detection.features.size(), "feature", "features") << ", " << at_limit
     << " of them at a limit of the scales\n";
  return os.str();
}

inline std::string stage_report(const Stage_log& log)
{
  const double megabyte = 1e6;
  std::size_t width = 5;
  for (const auto& e : log.entries()) width = (std::max)(width, e.name.size());
  std::ostringstream os;
  os << std::fixed;
  const auto line = [&](const std::string& name, double seconds, std::size_t memory) {
    os << std::left << std::setw(int(width)) << name << std::right << std::setprecision(3) << std::setw(11) << seconds
       << " s";
    if (memory > 0) os << std::setprecision(0) << std::setw(9) << double(memory) / megabyte << " MB";
    os << '\n';
  };
  os << std::left << std::setw(int(width)) << "stage"
     << "         time"
     << "  peak so far\n";
  for (const auto& e : log.entries()) line(e.name, e.seconds, e.peak_memory);
  line("total", log.total_seconds(), peak_memory());
  return os.str();
}

// One line.
inline std::string summary(const Command_line& c, const Detection& detection, double seconds)
{
  std::ostringstream os;
  os << internal::counted(detection.features.size(), "feature", "features") << " in " << std::fixed
     << std::setprecision(1) << seconds << " s";
  if (detection.features.empty()) {
    os << (detection.number_of_minima > 0 ? ": no response reaches the thresholds"
                                          : ": the response has no minimum within the range of scales");
  } else {
    const Feature& f = detection.features.front();
    os << ", the strongest (" << std::setprecision(3) << f.strength() << ") at vertex " << f.vertex_index << ", frame "
       << f.frame;
  }
  const char* separator = "; written to ";
  const auto add = [&](const std::string& path) {
    if (path == "-") return;
    os << separator << path;
    separator = ", ";
  };
  for (const auto& o : c.outputs) add(o.path);
  for (const auto& f : c.fields) add(f.path);
  for (const auto& s : c.scenes) add(s.path);
  os << '\n';
  return os.str();
}

} // namespace Detect_features

#endif // DETECT_FEATURES_REPORT_H
