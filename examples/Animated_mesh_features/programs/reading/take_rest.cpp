// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/take_rest.h"

#include "reading/Rest_comparison.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/IO/check_same_connectivity.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <sstream>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

typedef AMF::IO::Animation_file_data<FT> File_data;

std::string file_name(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

Rest_points points_of(const std::vector<std::array<double, 3>>& from)
{
  Rest_points points;
  points.reserve(from.size());
  for (const auto& p : from) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Taken_rest take_frame(std::size_t frame, Sequence& sequence)
{
  if (frame != 0) sequence.set_rest_frame(frame); // it is the first already
  return {"frame:" + std::to_string(frame), "frame " + std::to_string(frame), "", false, 1};
}

Taken_rest take_average(Sequence& sequence, AMF::Any_visitor visitor)
{
  AMF::set_canonical_rest_shape(sequence, visitor);
  return {"average", "the average of all frames", "", false, 1};
}

// Another shape than the frames that comes with the input.
struct Own_shape
{
  Rest_points points;
  Taken_rest taken;
  std::string file; // that holds it
};

// The mesh of a pair, or the pose of a model without any clip; none, if there is neither.
std::optional<Own_shape> own_shape(const File_data& data, bool is_model)
{
  const std::string& file = data.sources.front();
  if (is_model && !data.bind_points.empty())
    return Own_shape{points_of(data.bind_points), {"bind", "the bind pose of " + file_name(file), "", false, 1}, file};
  if (!is_model && AMF::IO::is_point_cache(AMF::IO::file_format_by_ending(data.sources.back())))
    return Own_shape{points_of(data.mesh.points), {"mesh", "the mesh " + file_name(file), "", false, 1}, file};
  return std::nullopt;
}

Taken_rest take_own(const Reading_options& o, const File_data& data, bool is_model, Sequence& sequence)
{
  const std::optional<Own_shape> own = own_shape(data, is_model);
  if (o.rest.kind == Rest::MESH && (!own || is_model))
    throw AMF::Option_error("--rest mesh goes with a mesh and a point cache");
  if (o.rest.kind == Rest::BIND && (!own || !is_model))
    throw AMF::Option_error("--rest bind goes with an animated model");
  Taken_rest taken = own->taken;
  taken.is_scaled = o.rest.rescale;
  try {
    return take_points(own->points, taken, sequence);
  } catch (const AMF::Input_error& e) {
    throw AMF::Input_error(own->file + ": " + e.what());
  }
}

Rest_points points_of_file(const Reading_options& o, const File_data& data)
{
  const std::string& file = o.rest.file;
  const AMF::IO::Indexed_mesh rest = AMF::IO::read_mesh(file, mesh_reading_options(o));
  const bool is_file_mesh = data.file_mesh.points.empty();
  AMF::IO::check_same_connectivity(is_file_mesh ? data.mesh : data.file_mesh, data.sources.front(), rest, file);
  std::vector<std::array<double, 3>> points;
  for (std::size_t v = 0; v < data.mesh.points.size(); ++v)
    points.push_back(rest.points[is_file_mesh ? v : data.origins.file_vertices[data.origins.first[v]]]);
  return points_of(points);
}

Taken_rest take_file(const Reading_options& o, const File_data& data, Sequence& sequence)
{
  const std::string& file = o.rest.file;
  const Rest_points points = points_of_file(o, data);
  try {
    return take_points(points, {file, file_name(file), "", o.rest.rescale, 1}, sequence);
  } catch (const AMF::Input_error& e) {
    throw AMF::Input_error(file + ": " + e.what());
  }
}

// What must be known of a shape that nobody chose.
void add_notices(const Own_shape& own, const Rest_comparison& c, std::vector<std::string>& notices)
{
  // of bodies and their own shape at rest 0.01 to 0.16, of one body and the motion of another 0.21
  const double much = 0.2;
  const bool is_other_body = c.change > much, is_other_pose = c.change > c.spread && c.spread > 0;
  if (!own.taken.is_scaled && !is_other_body && !is_other_pose) return;
  std::ostringstream os;
  os.precision(3);
  os << own.taken.name << ", the rest shape, is ";
  if (own.taken.is_scaled)
    os << "in another unit: it is scaled by " << c.ratio << ", the median ratio of the frames' edges to its own";
  if (is_other_body || is_other_pose) {
    os << (own.taken.is_scaled ? "; and it is " : "") << "unlike all frames: its edges differ by " << 100 * c.change
       << " % even from those of frame " << c.frame;
    if (is_other_pose) os << ", other frames by " << 100 * c.spread << " % at most, so that few features may stand out";
  }
  os << "; --rest average takes the average of all frames instead, --rest FILE another mesh";
  notices.push_back(os.str());
}

// Where the average cannot be had, an input is not refused that nobody asked the average of.
Taken_rest take_average_or_first(std::string reason, Sequence& sequence, std::vector<std::string>& notices,
                                 AMF::Any_visitor visitor)
{
  Taken_rest taken;
  try {
    taken = take_average(sequence, visitor);
  } catch (const AMF::Numerical_error& e) {
    notices.push_back(std::string(e.what()) + "; the rest shape is the first frame instead");
    taken = take_frame(0, sequence);
    reason = "there is no average of all frames";
  }
  taken.reason = std::move(reason);
  return taken;
}

// A shape that is one of the frames says nothing that they do not. The first one is undeformed, if the motion begins
// there from rest, as that of simulations and gestures; in the middle of a motion, the average is nearer to rest.
// Measured on 16 motions of two bodies with a skeleton, of whose events 0.48 are found against the first frame, 0.41
// against the average, 0.51 against what is taken here; 0.66, 0.70 and 0.68 of the features are at events.
Taken_rest take_by_input(const File_data& data, bool is_model, Sequence& sequence, std::vector<std::string>& notices,
                         AMF::Any_visitor visitor)
{
  const double usual_ratio = 1.3; // as Rest_unit::CHECK has it
  std::optional<Own_shape> own = own_shape(data, is_model);
  if (!own) return take_average_or_first("there are only frames", sequence, notices, visitor);
  if (const std::optional<std::size_t> frame = frame_at(own->points, sequence)) {
    const std::string name = own->taken.name + " is frame " + std::to_string(*frame);
    if (*frame != 0 || !begins_still(sequence)) return take_average_or_first(name, sequence, notices, visitor);
    Taken_rest taken = take_frame(0, sequence);
    taken.reason = own->taken.name + ", from which the motion begins at rest";
    return taken;
  }
  Rest_comparison c = compare_with_frames(own->points, sequence, false);
  if (!(c.ratio > 0)) return take_average_or_first(own->taken.name + " has no extent", sequence, notices, visitor);
  own->taken.is_scaled = c.ratio > usual_ratio || c.ratio < 1 / usual_ratio;
  own->taken.reason = is_model ? "given with the clip" : "given with the frames";
  if (own->taken.is_scaled) c = compare_with_frames(own->points, sequence, true);
  add_notices(*own, c, notices);
  return take_points(own->points, own->taken, sequence);
}

} // namespace

Taken_rest take_points(const Rest_points& points, Taken_rest taken, Sequence& sequence)
{
  std::vector<Sequence::Point_3> converted;
  converted.reserve(points.size());
  for (const auto& p : points) converted.emplace_back(p[0], p[1], p[2]);
  taken.factor =
      sequence.set_rest_shape(converted, taken.is_scaled ? AMF::Rest_unit::RESCALE : AMF::Rest_unit::CHECK);
  return taken;
}

Rest_points given_shape(const Reading_options& o, const File_data& data, bool is_model)
{
  if (o.rest.kind == Rest::FILE) return points_of_file(o, data);
  const std::optional<Own_shape> own = own_shape(data, is_model);
  return own ? own->points : Rest_points();
}

Taken_rest take_rest(const Reading_options& o, const File_data& data, bool is_model, Sequence& sequence,
                     std::vector<std::string>& notices, AMF::Any_visitor visitor)
{
  switch (o.rest.kind) {
  case Rest::FRAME:
    if (o.rest.frame >= data.frames)
      throw AMF::Option_error("--rest " + o.rest.text + ": there is no such frame; frames are 0 to " +
                              std::to_string(data.frames - 1));
    return take_frame(o.rest.frame, sequence);
  case Rest::AVERAGE: return take_average(sequence, visitor);
  case Rest::MESH:
  case Rest::BIND: return take_own(o, data, is_model, sequence);
  case Rest::FILE: return take_file(o, data, sequence);
  case Rest::BY_INPUT: break;
  }
  return take_by_input(data, is_model, sequence, notices, visitor);
}

} // namespace Programs
