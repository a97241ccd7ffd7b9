// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_ANIMATION_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_ANIMATION_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Memory_chooser.h>
#include <CGAL/Animated_mesh_features/IO/Point_cache_reader.h>
#include <CGAL/Animated_mesh_features/IO/check_cache_fits.h>
#include <CGAL/Animated_mesh_features/IO/check_frames.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/frame_files_in_folder.h>
#include <CGAL/Animated_mesh_features/IO/internal/read_frame_files.h>
#include <CGAL/Animated_mesh_features/IO/numbered_series.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/IO/weld_part.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

template <class ConcurrencyTag, class FT>
void read_point_cache(const std::string& mesh_file, const std::string& cache_file, const Mesh_reading_options& options,
                      const Memory_chooser& choose_memory, Animation_file_data<FT>& data)
{
  data.sources = {mesh_file, cache_file};
  data.mesh = IO::read_mesh(mesh_file, options);
  for (const std::string& remark : data.mesh.remarks) data.notices.push_back(mesh_file + ": " + remark);
  Point_cache_reader cache(cache_file);
  cache.check_number_of_points(data.mesh.points.size(), mesh_file);
  data.frames = cache.number_of_frames();
  data.times = cache.times();
  cache.read_fields<ConcurrencyTag>(data.x, data.y, data.z,
                                    chosen_memory(choose_memory, data.mesh.points.size(), data.frames));
}

// The frames among the files of a folder or a list, in their order; tells what is left out or was read in an unusual way.
template <class FT>
std::vector<std::string> frames_in_order(const Numbered_series& series, Animation_file_data<FT>& data)
{
  std::string others;
  for (const std::string& other : series.others) others += (others.empty() ? "" : ", ") + file_name(other);
  if (!others.empty())
    data.notices.push_back("not among the " + std::to_string(series.files.size()) +
                           " frames, to whose series the name " + "does not belong: " + others);
  if (!series.reading.empty())
    data.notices.push_back("the names of the frames are read as " + series.reading + ", from " +
                           file_name(series.files.front()) + " to " + file_name(series.files.back()));
  return series.files;
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads an animation. `inputs` is one of
- a mesh file and a point cache (.pc2, .mdd) with as many points as the mesh has vertices, in either order;
- a folder, whose mesh files are the frames (`frame_files_in_folder()`);
- two or more mesh files, the frames. They are put in the order of their numbers, whatever order they are given in: see
  `numbered_series()` and `Mesh_reading_options::frames_as_given`.

All meshes of a sequence must have the same faces in the same order. STL repeats coordinates instead of naming vertices:
corners that are at the same place in all frames are one vertex, for which a sequence of STL files is read twice.

Linear in the size of the files. Apart from the result, `3 N F` numbers, a sequence takes the memory of 16 frames and of
a file for each thread, a point cache some 0.4 MB a thread (see `Point_cache_reader::read_fields()`).

\tparam FT `float` or `double`: the precision of the coordinates.
\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`. The result is the same, bit for bit,
  and so is the error, if there are several: that of the first frame.

\param inputs the files, or the folder.
\param options how mesh files are read.
\param choose_memory see `Memory_chooser`.
\throws Input_error if a file is missing or malformed (see `read_mesh()`, `Point_cache_reader`), mesh and cache do not
fit (see `check_cache_fits()`), a frame is broken (see `check_frames()`), the frames differ in connectivity (the message names the first such triangle) or there are
less than two of them, or the inputs are none of the above.
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
    const bool is_folder = std::filesystem::is_directory(status);
    if (!is_folder) check_known_format(input);
    const bool is_cache = is_point_cache(file_format_by_ending(input));
    (is_folder ? folders : is_cache ? caches : meshes).push_back(input);
  }

  Animation_file_data<FT> data;
  if (!folders.empty()) {
    if (inputs.size() > 1) throw Input_error(folders[0] + ": a folder of frames must be the only input");
    if (options.frames_as_given)
      throw Input_error(folders[0] + ": the files of a folder are in no order that is given");
    meshes = internal::frames_in_order(frame_files_in_folder(folders[0]), data);
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
    if (folders.empty() && !options.frames_as_given)
      meshes = internal::frames_in_order(numbered_series(meshes, false), data);
    internal::read_frame_files<ConcurrencyTag>(meshes, options, choose_memory, data);
  }
  if (data.frames < 2) throw Input_error(data.sources.back() + ": one frame is no animation");
  check_frames<ConcurrencyTag>(options.skip_bad_frames, data);
  if (!caches.empty()) check_cache_fits(caches[0], data);
  weld_part(options, data);
  return data;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_ANIMATION_H
