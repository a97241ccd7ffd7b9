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
#include <CGAL/Animated_mesh_features/IO/internal/Field_filler.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>
#include <CGAL/Animated_mesh_features/IO/weld_surface.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

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

inline std::string counted(std::size_t n, const char* singular, const char* plural)
{
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

inline std::vector<std::string> welding_remarks(const Welded_surface& w, std::size_t file_vertices)
{
  std::vector<std::string> remarks;
  if (w.number_of_vertices() != file_vertices || w.welded_edges > 0)
    remarks.push_back(counted(file_vertices, "vertex", "vertices") + " of the file became " +
                      std::to_string(w.number_of_vertices()) + ", " +
                      counted(w.welded_edges, "edge was", "edges were") + " sewn");
  if (w.unused_vertices > 0)
    remarks.push_back(counted(w.unused_vertices, "vertex", "vertices") + " in no triangle left out");
  if (w.collapsed_triangles > 0)
    remarks.push_back(counted(w.collapsed_triangles, "triangle", "triangles") + " without area in any frame left out");
  if (w.split_vertices > 0)
    remarks.push_back(counted(w.split_vertices, "vertex", "vertices") +
                      " split where the surface meets in a point only");
  if (w.open_edges > 0)
    remarks.push_back(counted(w.open_edges, "edge", "edges") +
                      " left open: borders coincide there, but do not make a manifold");
  return remarks;
}

// The triangles of all parts, by the vertices of the file; turned round in parts that are mirrored.
inline std::vector<std::array<std::size_t, 3>> drawn_triangles(const Keyframed_model& model,
                                                               const std::vector<char>& mirrored)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  std::size_t first = 0;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const Keyframed_model::Geometry& g = model.geometries[model.parts[i].geometry];
    for (std::array<std::size_t, 3> t : g.triangles) {
      if (mirrored[i]) std::swap(t[1], t[2]);
      triangles.push_back({{first + t[0], first + t[1], first + t[2]}});
    }
    first += g.points.size();
  }
  return triangles;
}

inline void check_finite(const Keyframed_model_evaluator::Points& points, const std::string& name)
{
  for (std::size_t v = 0; v < points.size(); ++v)
    for (double x : points[v])
      if (!is_finite(x)) throw Input_error(name + ": the position of vertex " + std::to_string(v) + " is not finite");
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesModels

makes the frames of a clip of an animated model, with vertices welded that the format split: see `Clip_sampling`,
`Coincident_vertices` and `weld_surface()`. Times are from 0 at the clip's first key.

The clip is evaluated twice, so that nothing of the size of the animation is in memory before `choose_memory` is told the
size; `O(F (N + nodes + keys))`.

\tparam FT, ConcurrencyTag as for `read_animation()`
\param model what the file holds
\param sampling which clip, and when
\param file the name for messages
\param choose_memory see `Memory_chooser`
\throws Option_error see `find_clip()` and `frame_times()`
\throws Input_error see `Keyframed_model_evaluator`, `find_clip()`, `frame_times()`; a position is not
finite; there are no triangles.
*/
template <class FT, class ConcurrencyTag = CGAL::Parallel_if_available_tag>
Animation_file_data<FT> sample_clip(const Keyframed_model& model, const Clip_sampling& sampling,
                                    const std::string& file, const Memory_chooser& choose_memory = Memory_chooser())
{
  typedef Keyframed_model_evaluator::Points Points;

  Animation_file_data<FT> data;
  data.sources = {file};
  data.clips = clip_names(model);
  data.clip = find_clip(data.clips, sampling.clip, file);
  const Keyframed_model::Clip& clip = model.clips[data.clip];
  const std::vector<double> times = frame_times(clip, sampling, file);
  data.frames = times.size();
  for (std::size_t f = 0; f < data.frames; ++f) data.times.push_back(double(f) * (times[1] - times[0]));
  const Keyframed_model_evaluator evaluate(model, data.clip, file);
  const auto name = [&](std::size_t f) { return file + ", clip \"" + clip.name + "\", frame " + std::to_string(f); };

  const std::size_t file_vertices = model.number_of_vertices();
  Coincident_vertices coincident(file_vertices);
  Points points, first_points;
  for (std::size_t f = 0; f < times.size() && !(f > 0 && coincident.all_apart()); ++f) {
    evaluate(times[f], points);
    internal::check_finite(points, name(f));
    coincident.add_frame(points);
    if (f == 0) first_points = points;
  }
  Welded_surface surface =
      weld_surface(internal::drawn_triangles(model, evaluate.mirrored_parts(times[0])), coincident.first_of_class());
  if (surface.triangles.empty()) throw Input_error(file + ": holds no triangles");
  data.remarks = model.remarks;
  for (std::string& remark : internal::welding_remarks(surface, file_vertices))
    data.remarks.push_back(std::move(remark));

  const std::size_t n = surface.number_of_vertices();
  std::size_t first_of_part = 0;
  for (const Keyframed_model::Part& part : model.parts) {
    const std::size_t size = model.geometries[part.geometry].points.size();
    data.origins.parts.push_back({part.name, first_of_part, size});
    first_of_part += size;
  }
  data.origins.first = std::move(surface.first);
  data.origins.file_vertices = std::move(surface.file_vertices);
  data.mesh.triangles = std::move(surface.triangles);
  std::vector<std::size_t> source(n);
  for (std::size_t v = 0; v < n; ++v) source[v] = data.origins.file_vertices[data.origins.first[v]];
  for (std::size_t v : source) data.mesh.points.push_back(first_points[v]);

  const std::array<Spatio_temporal_field<FT>*, 3> fields = {{&data.x, &data.y, &data.z}};
  internal::resize_fields(n, data.frames, fields, internal::chosen_memory(choose_memory, n, data.frames));
  internal::Field_filler<FT, ConcurrencyTag> filler(fields);
  struct Frame_memory
  {
    Points points, welded;
  };
  Animated_mesh_features::internal::Thread_local<Frame_memory> memories;
  for (std::size_t first = 0, last; first < data.frames; first = last) {
    last = filler.end_of_batch();
    parallel_for<ConcurrencyTag>(first, last, [&](std::size_t f) {
      Frame_memory& m = memories.get([] { return std::make_unique<Frame_memory>(); });
      evaluate(times[f], m.points);
      m.welded.resize(n);
      for (std::size_t v = 0; v < n; ++v) m.welded[v] = m.points[source[v]];
      filler.put(f, m.welded[0].data(), name(f));
    });
    filler.finish_batch();
  }
  return data;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_SAMPLE_CLIP_H
