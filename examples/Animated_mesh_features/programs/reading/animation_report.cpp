// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/animation_report.h"

#include "running/counted.h"

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/IO/Clip_sampling.h>

#include <cstddef>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

std::string animation_report(const Reading_options& options, const Animation& animation)
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
  os << "parts: " << animation.parts() << (options.part.empty() ? "" : "; this is " + options.part) << '\n';
  for (const std::string& remark : animation.remarks()) os << "file: " << remark << '\n';
  os << "rest shape: " << animation.rest().name;
  if (options.rest.kind == Rest::BY_INPUT) os << ", as " << animation.rest().reason;
  os << ", bounding-box diagonal " << shape.bounding_box_diagonal()
     << ", mean edge length " << shape.mean_edge_length();
  if (animation.rest().is_scaled) os << ", scaled by " << animation.rest().factor;
  os << "\nmesh: " << counted(r.connected_components, "component", "components") << ", "
     << counted(r.border_edges, "border edge", "border edges") << ", "
     << counted(r.isolated_vertices, "isolated vertex", "isolated vertices") << ", "
     << counted(r.degenerate_rest_triangles, "degenerate triangle", "degenerate triangles") << " at rest\n";
  return os.str();
}

std::string reading_notices(const Reading_options& options, const Animation& animation)
{
  std::string lines;
  if (animation.clips().size() > 1 && options.clip.empty())
    lines = "clip " + animation.clip_name() + ", the first of " + AMF::IO::clip_list(animation.clips()) +
            "; --clip chooses another, or several together: A+B\n";
  for (const std::string& notice : animation.notices()) lines += "note: " + notice + '\n';
  return lines;
}

AMF::IO::Result_description animation_description(const Animation& animation)
{
  const Sequence& sequence = animation.sequence();
  AMF::IO::Result_description d;
  d.vertices = sequence.number_of_vertices();
  d.faces = animation.number_of_faces();
  d.frames = sequence.number_of_frames();
  d.frame_duration = sequence.frame_duration();
  d.bounding_box_diagonal = sequence.rest_shape().bounding_box_diagonal();
  d.mean_edge_length = sequence.rest_shape().mean_edge_length();
  d.origins = animation.origins();
  return d;
}

void add_reading_parameters(AMF::IO::Result_description& d, const Reading_options& o, const Animation& animation)
{
  const std::size_t frames = animation.number_of_frames_read();
  d.add("inputs", o.inputs);
  d.add("as_given", o.as_given);
  d.add("triangulate", o.triangulate);
  d.add("weld", name(o.weld));
  d.add("repair", o.repair);
  d.add("skip_bad_frames", o.skip_bad_frames);
  d.add("denoise", name(o.denoise));
  add_if(animation.noise() > 0, d, "noise_taken_out", animation.noise());
  add_if(!o.part.empty(), d, "part", o.part);
  d.add("fps", animation.frames_per_second());
  add_if(o.frame_range.has_value(), d, "frame_range", o.frame_range.value_or(Frame_range()).text);
  add_if(!animation.clips().empty(), d, "clip", animation.clip_name());
  add_if(animation.is_sampled() && (o.clip_frames || !o.frames_per_second), d, "frames",
         o.there_and_back ? (frames + 1) / 2 : frames);
  add_if(animation.is_sampled(), d, "there_and_back", o.there_and_back);
  add_if(!o.faces_dataset.empty(), d, "faces", o.faces_dataset);
  const Taken_rest& rest = animation.rest();
  d.add("rest", rest.text);
  d.add("rescale_rest", rest.is_scaled);
  d.add("rest_factor", rest.factor);
}

} // namespace Programs
