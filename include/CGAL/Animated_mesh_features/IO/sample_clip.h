// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_SAMPLE_CLIP_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_SAMPLE_CLIP_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Clip_sampling.h>
#include <CGAL/Animated_mesh_features/IO/Memory_chooser.h>
#include <CGAL/Animated_mesh_features/IO/Coincident_vertices.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model_evaluator.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>
#include <CGAL/Animated_mesh_features/IO/check_frames.h>
#include <CGAL/Animated_mesh_features/IO/internal/Clip_frames.h>
#include <CGAL/Animated_mesh_features/IO/internal/Field_filler.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/IO/internal/welding_remarks.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/take_part.h>
#include <CGAL/Animated_mesh_features/IO/taken_parts.h>
#include <CGAL/Animated_mesh_features/IO/weld_surface.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// The triangles of the parts that are taken - all, if there are none - by the vertices of the file; turned round in parts
// that are mirrored.
inline std::vector<std::array<std::size_t, 3>>
drawn_triangles(const Keyframed_model& model, const std::vector<char>& mirrored, const std::vector<char>& taken)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  std::size_t first = 0;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Keyframed_model::Geometry& g = model.geometries[model.parts[i].geometry];
    if (taken.empty() || taken[i])
      for (std::array<std::size_t, 3> t : g.triangles) {
        if (mirrored[i]) std::swap(t[1], t[2]);
        triangles.push_back({{first + t[0], first + t[1], first + t[2]}});
      }
    first += g.points.size();
  }
  return triangles;
}

inline std::size_t number_of_vertices(const Keyframed_model& model, const std::vector<char>& taken)
{
  std::size_t n = 0;
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (taken.empty() || taken[i]) n += model.geometries[model.parts[i].geometry].points.size();
  return n;
}

inline Vertex_origins vertex_origins(const Keyframed_model& model, Welded_surface& surface)
{
  Vertex_origins origins;
  std::size_t first_of_part = 0;
  for (const Keyframed_model::Part& part : model.parts) {
    const std::size_t size = model.geometries[part.geometry].points.size();
    origins.parts.push_back({part.name, first_of_part, size});
    first_of_part += size;
  }
  origins.first = std::move(surface.first);
  origins.file_vertices = std::move(surface.file_vertices);
  return origins;
}

// How many vertices there are at least once coincident ones are welded: those that are apart in one frame, and in a triangle
// with two others.
inline std::size_t fewest_vertices(const std::vector<std::array<std::size_t, 3>>& triangles,
                                   const Clip_frames::Points& points)
{
  Coincident_vertices coincident(points.size());
  coincident.add_frame(points);
  const std::vector<std::size_t>& first = coincident.first_of_class();
  std::vector<char> is_used(points.size(), 0);
  for (const auto& t : triangles)
    if (first[t[0]] != first[t[1]] && first[t[1]] != first[t[2]] && first[t[2]] != first[t[0]])
      for (std::size_t v : t) is_used[first[v]] = 1;
  return std::size_t(std::count(is_used.begin(), is_used.end(), 1));
}

// Where vertices are without any clip; `source` has a vertex of the file for each of them. Empty, if a position is not
// finite.
inline Clip_frames::Points bind_points(const Keyframed_model& model, const std::vector<std::size_t>& source,
                                       const std::string& file)
{
  const Keyframed_model::Clip no_clip;
  Clip_frames::Points points, taken;
  Keyframed_model_evaluator(model, no_clip, file)(0, points);
  for (std::size_t v : source) {
    for (double x : points[v])
      if (!is_finite(x)) return Clip_frames::Points();
    taken.push_back(points[v]);
  }
  return taken;
}

// Fills the coordinates of `data`, which has its surface already; `source` has a vertex of the file for each vertex.
template <class ConcurrencyTag, class FT>
void fill_frames(const Clip_frames& frames, const std::vector<std::size_t>& source,
                 const std::shared_ptr<Field_memory>& memory, Animation_file_data<FT>& data)
{
  const std::size_t n = source.size();
  const std::array<Spatio_temporal_field<FT>*, 3> fields = {{&data.x, &data.y, &data.z}};
  resize_fields(n, data.frames, fields, memory);
  Field_filler<FT, ConcurrencyTag> filler(fields);
  struct Frame_memory
  {
    Clip_frames::Points points, welded;
  };
  Animated_mesh_features::internal::Thread_local<Frame_memory> memories;
  for (std::size_t first = 0, last; first < data.frames; first = last) {
    last = filler.end_of_batch();
    parallel_for<ConcurrencyTag>(first, last, [&](std::size_t f) {
      Frame_memory& m = memories.get([] { return std::make_unique<Frame_memory>(); });
      frames.get(f, m.points);
      m.welded.resize(n);
      for (std::size_t v = 0; v < n; ++v) m.welded[v] = m.points[source[v]];
      filler.put(f, m.welded[0].data(), frames.name(f));
    });
    filler.finish_batch();
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesModels

makes the frames of a clip of an animated model, and its shape without any clip, with vertices welded that the format split: see `Clip_sampling`,
`Coincident_vertices` and `weld_surface()`. Times are from 0 at the clip's first key.

The clip is evaluated twice, so that nothing of the size of the animation is in memory before `choose_memory` is told the
size; `O(F (N + nodes + keys))`. How many vertices are left after welding is known late: `choose_memory` is asked about the
fewest that there can be, too, after one frame, so that what is much too large is refused at once.

\tparam FT, ConcurrencyTag as for `read_animation()`
\param model what the file holds
\param sampling which clip, and when
\param file the name for messages
\param choose_memory see `Memory_chooser`
\throws Option_error see `find_clips()`, `joined_clip()`, `frame_times()`, and `keep_component()` for a part that is not there
\throws Input_error see `Keyframed_model_evaluator`, `find_clips()`, `frame_times()`; a position is not
finite; there are no triangles; a frame is broken, see `check_frames()`.
*/
template <class FT, class ConcurrencyTag = CGAL::Parallel_if_available_tag>
Animation_file_data<FT> sample_clip(const Keyframed_model& model, const Clip_sampling& sampling,
                                    const std::string& file, const Memory_chooser& choose_memory = Memory_chooser())
{
  Animation_file_data<FT> data;
  data.sources = {file};
  data.linked_files = model.linked_files;
  data.clips = clip_names(model);
  const std::vector<std::size_t> clips = find_clips(data.clips, sampling.clip, file);
  data.clip = clips.front();
  data.further_clips.assign(clips.begin() + 1, clips.end());
  const internal::Clip_frames frames(model, joined_clip(model, clips, file), sampling, file);
  data.frames = frames.size();
  data.times = frames.times();

  const std::vector<char> taken = taken_parts(model, sampling.part);
  const std::vector<std::array<std::size_t, 3>> triangles =
      internal::drawn_triangles(model, frames.mirrored_parts(), taken);
  internal::Clip_frames::Points first_points;
  frames.get(0, first_points);
  internal::chosen_memory(choose_memory, internal::fewest_vertices(triangles, first_points), data.frames);
  const Coincident_vertices coincident =
      internal::coincident_vertices(frames, model.number_of_vertices(), first_points);
  Welded_surface surface = weld_surface(triangles, coincident.first_of_class());
  if (surface.triangles.empty()) throw Input_error(file + ": holds no triangles");
  data.remarks = model.remarks;
  const std::size_t taken_vertices = internal::number_of_vertices(model, taken);
  surface.unused_vertices -= model.number_of_vertices() - taken_vertices; // in parts that were not asked for
  for (std::string& remark : internal::welding_remarks(surface, taken_vertices))
    data.remarks.push_back(std::move(remark));

  data.mesh.triangles = std::move(surface.triangles);
  data.origins = internal::vertex_origins(model, surface);
  const std::size_t n = data.origins.number_of_vertices();
  std::vector<std::size_t> source(n); // the first of those of the file
  for (std::size_t v = 0; v < n; ++v) source[v] = data.origins.file_vertices[data.origins.first[v]];
  for (std::size_t v : source) data.mesh.points.push_back(first_points[v]);
  data.bind_points = internal::bind_points(model, source, file);
  internal::fill_frames<ConcurrencyTag>(frames, source, internal::chosen_memory(choose_memory, n, data.frames), data);
  check_frames<ConcurrencyTag>(sampling.skip_bad_frames, data);
  data.part_names = part_names(model);
  if (!sampling.part.empty() && taken.empty()) keep_component(sampling.part, data);
  return data;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_SAMPLE_CLIP_H
