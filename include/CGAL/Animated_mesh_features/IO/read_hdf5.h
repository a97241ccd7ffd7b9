// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_HDF5_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_HDF5_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/Clip_sampling.h>
#include <CGAL/Animated_mesh_features/IO/Memory_chooser.h>
#include <CGAL/Animated_mesh_features/IO/check_frames.h>
#include <CGAL/Animated_mesh_features/IO/internal/Field_filler.h>
#include <CGAL/Animated_mesh_features/IO/internal/Hdf5_file.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/IO/read_animation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

inline std::string extent_text(const Hdf5_file::Extent& extent)
{
  std::string text;
  for (hsize_t n : extent) text += (text.empty() ? "" : " x ") + std::to_string(n);
  return text.empty() ? "a single value" : text;
}

// Positions of vertices in all frames: `N x 3 x F`, or `F x N x 3`.
struct Hdf5_sequence
{
  std::string name;
  bool is_by_frame;
  std::size_t vertices, frames;
};

// The least and the largest vertex that the faces have.
struct Hdf5_corners
{
  std::size_t least, largest;

  // Whether they can be vertices of so many, counted from 0, or else from 1.
  bool fit(hsize_t vertices) const { return vertices > largest || are_from_one(vertices); }
  bool are_from_one(hsize_t vertices) const { return least >= 1 && vertices == largest; }
};

inline Hdf5_corners hdf5_corners(const std::vector<std::array<std::size_t, 3>>& triangles)
{
  Hdf5_corners corners = {(std::numeric_limits<std::size_t>::max)(), 0};
  for (const std::array<std::size_t, 3>& t : triangles)
    for (std::size_t v : t) corners = {(std::min)(corners.least, v), (std::max)(corners.largest, v)};
  return corners;
}

inline bool is_by_vertex(const Hdf5_file::Extent& e, const Hdf5_corners& corners)
{
  return e.size() == 3 && e[1] == 3 && corners.fit(e[0]);
}

inline bool is_by_frame(const Hdf5_file::Extent& e, const Hdf5_corners& corners)
{
  return e.size() == 3 && e[2] == 3 && corners.fit(e[1]);
}

// All three-dimensional datasets, in alphabetical order.
inline std::vector<std::string> hdf5_sequences(const Hdf5_file& hdf5)
{
  std::vector<std::string> names;
  for (const std::string& name : hdf5.datasets())
    if (hdf5.extent(name).size() == 3) names.push_back(name);
  return names;
}

// The name or number of the sequence that is meant: if nothing is wanted, the first that has the vertices of the faces.
inline std::size_t hdf5_clip(const Hdf5_file& hdf5, const std::vector<std::string>& names, const std::string& wanted,
                             const Hdf5_corners& corners, const std::string& file)
{
  if (!wanted.empty()) return find_clip(names, wanted, file);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Hdf5_file::Extent e = hdf5.extent(names[i]);
    if (is_by_vertex(e, corners) || is_by_frame(e, corners)) return i;
  }
  return 0; // what is wrong with it is told
}

inline std::vector<std::array<std::size_t, 3>> read_hdf5_faces(const Hdf5_file& hdf5, const std::string& name,
                                                               const std::string& file)
{
  const Hdf5_file::Extent extent = hdf5.extent(name);
  if (extent.empty())
    throw Input_error(file + ": has no dataset \"" + name + "\" with the triangles (command line: --faces)");
  if (extent.size() != 2 || extent[1] != 3)
    throw Input_error(file + ": dataset " + name + " is " + extent_text(extent) + ", not triangles x 3");
  if (extent[0] == 0) throw Input_error(file + ": dataset " + name + " has no triangles");
  hdf5.check_content(name);
  std::vector<long long> corners(3 * std::size_t(extent[0]));
  hdf5.read(name, {0, 0}, extent, corners.data());
  std::vector<std::array<std::size_t, 3>> triangles(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] < 0)
      throw Input_error(file + ": dataset " + name + ", face " + std::to_string(i / 3) + " has a negative corner");
    triangles[i / 3][i % 3] = std::size_t(corners[i]);
  }
  return triangles;
}

// Which of the two layouts an array has: by its size, and where that leaves a doubt by the vertices of the faces.
inline Hdf5_sequence hdf5_sequence(const Hdf5_file& hdf5, const std::string& name, const Hdf5_corners& corners,
                                   const std::string& file)
{
  const Hdf5_file::Extent e = hdf5.extent(name);
  const std::string dataset = file + ": dataset " + name + " is " + extent_text(e);
  const bool by_vertex = is_by_vertex(e, corners), by_frame = is_by_frame(e, corners);
  if (by_vertex && by_frame)
    throw Input_error(dataset + ": both vertices x 3 x frames and frames x vertices x 3 would be possible");
  if (!by_vertex && !by_frame)
    throw Input_error(dataset + ", neither vertices x 3 x frames nor frames x vertices x 3 with the " +
                      std::to_string(corners.largest + 1) + " vertices or more that the faces have");
  if (by_vertex) return {name, false, std::size_t(e[0]), std::size_t(e[2])};
  return {name, true, std::size_t(e[1]), std::size_t(e[0])};
}

template <class FT>
void read_hdf5_fields(const Hdf5_file& hdf5, const Hdf5_sequence& s, const std::string& file,
                      const std::array<Spatio_temporal_field<FT>*, 3>& fields)
{
  // As large as whole pieces of a compressed file often are: none is unpacked more than once or twice.
  const std::size_t numbers_at_once = std::size_t(1) << 23;
  const std::size_t rows = s.is_by_frame ? s.frames : s.vertices, columns = s.is_by_frame ? s.vertices : s.frames;
  const std::size_t rows_at_once = (std::min)(rows, (std::max)(std::size_t(1), numbers_at_once / (3 * columns)));
  std::vector<double> numbers(3 * rows_at_once * columns);
  for (std::size_t first = 0; first < rows; first += rows_at_once) {
    const std::size_t n = (std::min)(rows_at_once, rows - first);
    if (s.is_by_frame)
      hdf5.read(s.name, {first, 0, 0}, {n, columns, 3}, numbers.data());
    else
      hdf5.read(s.name, {first, 0, 0}, {n, 3, columns}, numbers.data());
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t v = s.is_by_frame ? c : first + r, f = s.is_by_frame ? first + r : c;
          const FT x = FT(numbers[s.is_by_frame ? 3 * (r * columns + c) + k : (3 * r + k) * columns + c]);
          if (!is_finite(x))
            throw Input_error(file + ": dataset " + s.name + ", frame " + std::to_string(f) + ", vertex " +
                              std::to_string(v) + " has a coordinate that is not finite");
          (*fields[k])(v, f) = x;
        }
  }
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the names of the sequences in an HDF5 file, which `read_hdf5()` reads: all three-dimensional datasets, in alphabetical order.

\throws Input_error if the file cannot be read.
*/
inline std::vector<std::string> hdf5_sequences(const std::string& file)
{
  return internal::hdf5_sequences(internal::Hdf5_file(file));
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads a sequence of registered meshes from an HDF5 file laid out like D-FAUST's: for each sequence a dataset of
positions, `N x 3 x F`, and one of triangles for all of them, `T x 3`, counted from 0, or from 1 if the largest is `N`. Positions may also be `F x N x
3`, unless the sizes leave a doubt.

\tparam FT `float` or `double`: the precision of the coordinates.
\param file its name
\param sequence the name of the dataset of positions, or its number among all three-dimensional ones in alphabetical
  order; empty: the first one with as many vertices as the triangles have
\param faces the name of the dataset of triangles
\param choose_memory see `Memory_chooser`
\param options whether broken frames are left out, see `check_frames()`, and whether seams are closed and the surface is
  mended, see `weld_animation()`

Whoever includes this header links with HDF5's C library. Linear in the size of the dataset; memory, besides the result,
for 8 million numbers or a frame or vertex.

\throws Input_error if the file cannot be read, or has not that layout; see `check_frames()`, `weld_animation()`.
\throws Option_error if there is no such sequence.
*/
template <class FT>
Animation_file_data<FT>
read_hdf5(const std::string& file, const std::string& sequence = std::string(), const std::string& faces = "faces",
          const Memory_chooser& choose_memory = Memory_chooser(), Mesh_reading_options options = Mesh_reading_options())
{
  const internal::Hdf5_file hdf5(file);
  Animation_file_data<FT> data;
  data.sources = {file};
  data.mesh.triangles = internal::read_hdf5_faces(hdf5, faces, file);
  const internal::Hdf5_corners corners = internal::hdf5_corners(data.mesh.triangles);
  data.clips = internal::hdf5_sequences(hdf5);
  if (data.clips.empty()) throw Input_error(file + ": has no dataset vertices x 3 x frames");
  data.clip = internal::hdf5_clip(hdf5, data.clips, sequence, corners, file);
  const internal::Hdf5_sequence s = internal::hdf5_sequence(hdf5, data.clips[data.clip], corners, file);
  hdf5.check_content(s.name);
  if (corners.are_from_one(s.vertices)) {
    for (std::array<std::size_t, 3>& t : data.mesh.triangles)
      for (std::size_t& v : t) --v;
    data.notices.push_back("the faces count vertices from 1, as their largest tells; results count from 0");
  }
  data.frames = s.frames;
  if (s.frames < 2) throw Input_error(file + ": dataset " + s.name + " has one frame, which is no animation");

  const std::array<Spatio_temporal_field<FT>*, 3> fields = {{&data.x, &data.y, &data.z}};
  internal::resize_fields(s.vertices, s.frames, fields, internal::chosen_memory(choose_memory, s.vertices, s.frames));
  internal::read_hdf5_fields(hdf5, s, file, fields);
  for (std::size_t v = 0; v < s.vertices; ++v)
    data.mesh.points.push_back({{double(data.x(v, 0)), double(data.y(v, 0)), double(data.z(v, 0))}});
  check_frames(options.skip_bad_frames, data);
  weld_part(options, data);
  return data;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_HDF5_H
