// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_ANIMATION_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Memory_chooser.h>
#include <CGAL/Animated_mesh_features/IO/Point_cache_reader.h>
#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>
#include <CGAL/Animated_mesh_features/IO/check_same_connectivity.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/frame_files_in_folder.h>
#include <CGAL/Animated_mesh_features/IO/internal/Field_filler.h>
#include <CGAL/Animated_mesh_features/IO/natural_order.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

An animation as its files hold it: `N` vertices, `F` frames.
*/
template <class FT>
struct Animation_file_data
{
  /// the connectivity, and the points of the mesh file: those of the first frame for a sequence of meshes.
  Indexed_mesh mesh;

  /// `F`
  std::size_t frames = 0;

  /// the time of each frame (s) if the file tells it (MDD, clips of models), else empty.
  std::vector<double> times;

  Spatio_temporal_field<FT> x; ///< coordinates, `N x F`
  Spatio_temporal_field<FT> y; ///< coordinates, `N x F`
  Spatio_temporal_field<FT> z; ///< coordinates, `N x F`

  /// the files: mesh and cache, or a mesh for each frame, in their order.
  std::vector<std::string> sources;

  /// further files that those refer to: the buffers of a model.
  std::vector<std::string> linked_files;

  /// the names of all animations in the file; empty where there is but one, without a name.
  std::vector<std::string> clips;

  /// which of them this is.
  std::size_t clip = 0;

  /// which others are played together with it.
  std::vector<std::size_t> further_clips;

  /// empty if vertices are those of the file.
  Vertex_origins origins;

  /// what was left out or changed on reading, for the user: a sentence each.
  std::vector<std::string> remarks;

  /// where a frame comes from, for messages.
  std::string frame_name(std::size_t frame) const
  {
    return is_mesh(file_format_by_ending(sources.back())) ? sources[frame]
                                                          : sources.back() + ", frame " + std::to_string(frame);
  }
};

namespace internal {

template <class ConcurrencyTag, class FT>
void read_point_cache(const std::string& mesh_file, const std::string& cache_file, const Mesh_reading_options& options,
                      const Memory_chooser& choose_memory, Animation_file_data<FT>& data)
{
  data.sources = {mesh_file, cache_file};
  data.mesh = IO::read_mesh(mesh_file, options);
  Point_cache_reader cache(cache_file);
  cache.check_number_of_points(data.mesh.points.size(), mesh_file);
  data.frames = cache.number_of_frames();
  data.times = cache.times();
  cache.read_fields<ConcurrencyTag>(data.x, data.y, data.z,
                                    chosen_memory(choose_memory, data.mesh.points.size(), data.frames));
}

// What reading one file takes: a thread has its own.
struct Mesh_reading_memory
{
  std::string content;
  Indexed_mesh mesh;
};

template <class ConcurrencyTag, class FT>
void read_frame_files(const std::vector<std::string>& files, const Mesh_reading_options& options,
                      const Memory_chooser& choose_memory, Animation_file_data<FT>& data)
{
  data.sources = files;
  data.frames = files.size();
  Animated_mesh_features::internal::Thread_local<Mesh_reading_memory> memories;
  const auto memory = [&]() -> Mesh_reading_memory& {
    return memories.get([] { return std::make_unique<Mesh_reading_memory>(); });
  };
  read_mesh(files[0], options, memory().content, data.mesh);
  const std::array<Spatio_temporal_field<FT>*, 3> fields = {{&data.x, &data.y, &data.z}};
  resize_fields(data.mesh.points.size(), data.frames, fields,
                chosen_memory(choose_memory, data.mesh.points.size(), data.frames));
  Field_filler<FT, ConcurrencyTag> filler(fields);
  filler.put(0, data.mesh.points[0].data(), files[0]);

  for (std::size_t first = 1, last; first < data.frames; first = last) {
    last = filler.end_of_batch();
    // Of several errors, the first frame's is told, whichever thread is faster.
    std::vector<std::exception_ptr> errors(last - first);
    parallel_for<ConcurrencyTag>(first, last, [&](std::size_t f) {
      try {
        Mesh_reading_memory& m = memory();
        if (!read_mesh(files[f], options, m.content, m.mesh, &data.mesh) ||
            m.mesh.points.size() != data.mesh.points.size())
          check_same_connectivity(data.mesh, "the first frame, " + files[0], m.mesh, files[f]);
        filler.put(f, m.mesh.points[0].data(), files[f]);
      } catch (...) {
        errors[f - first] = std::current_exception();
      }
    });
    for (const std::exception_ptr& error : errors)
      if (error) std::rethrow_exception(error);
    filler.finish_batch();
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads an animation. `inputs` is one of
- a mesh file and a point cache (.pc2, .mdd) with as many points as the mesh has vertices, in either order;
- a folder, whose mesh files are the frames (`frame_files_in_folder()`);
- two or more mesh files, the frames. They are put in `natural_order()`, whatever order they are given in, since a shell
  expands `walk*.obj` to `walk_10.obj walk_2.obj`.

All meshes of a sequence must have the same faces in the same order. STL repeats coordinates instead of naming
vertices, so that a sequence of STL files works only as long as no two vertices ever meet.

Linear in the size of the files. Apart from the result, `3 N F` numbers, a sequence takes the memory of 16 frames and of
a file for each thread, a point cache some 0.4 MB a thread (see `Point_cache_reader::read_fields()`).

\tparam FT `float` or `double`: the precision of the coordinates.
\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`. The result is the same, bit for bit,
  and so is the error, if there are several: that of the first frame.

\param inputs the files, or the folder.
\param options how mesh files are read.
\param choose_memory see `Memory_chooser`.
\throws Input_error if a file is missing or malformed (see `read_mesh()`, `Point_cache_reader`), the frames differ in
connectivity (the message names the first such triangle) or there are less than two of them, or the inputs are none of
the above.
*/
template <class FT, class ConcurrencyTag = CGAL::Parallel_if_available_tag>
Animation_file_data<FT> read_animation(const std::vector<std::string>& inputs,
                                       Mesh_reading_options options = Mesh_reading_options(),
                                       const Memory_chooser& choose_memory = Memory_chooser())
{
  if (inputs.empty()) throw Input_error("no input: give a mesh and a point cache, a folder, or a mesh for each frame");
  std::vector<std::string> caches, meshes, folders;
  for (const std::string& input : inputs) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(input, error);
    if (!std::filesystem::exists(status)) throw Input_error(input + ": cannot read: " + error.message());
    const bool is_cache = is_point_cache(file_format_by_ending(input));
    (std::filesystem::is_directory(status) ? folders : is_cache ? caches : meshes).push_back(input);
  }

  Animation_file_data<FT> data;
  if (!folders.empty()) {
    if (inputs.size() > 1) throw Input_error(folders[0] + ": a folder of frames must be the only input");
    meshes = frame_files_in_folder(folders[0]);
  }
  if (caches.size() > 1) throw Input_error(caches[1] + ": a second point cache; give one mesh and one point cache");
  if (caches.size() == 1) {
    if (meshes.empty())
      throw Input_error(caches[0] + ": a point cache holds positions only; give the mesh file that belongs to it too");
    if (meshes.size() > 1) throw Input_error(meshes[1] + ": a second mesh; give one mesh and one point cache");
    internal::read_point_cache<ConcurrencyTag>(meshes[0], caches[0], options, choose_memory, data);
  } else {
    if (meshes.size() == 1)
      throw Input_error(meshes[0] +
                        ": one mesh is no animation; give the point cache that belongs to it, or more frames");
    std::sort(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) { return natural_order(a, b); });
    internal::read_frame_files<ConcurrencyTag>(meshes, options, choose_memory, data);
  }
  if (data.frames < 2) throw Input_error(data.sources.back() + ": one frame is no animation");
  return data;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_ANIMATION_H
