// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_READ_FRAME_FILES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_READ_FRAME_FILES_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/Animation_file_data.h>
#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Memory_chooser.h>
#include <CGAL/Animated_mesh_features/IO/Mesh_reading_options.h>
#include <CGAL/Animated_mesh_features/IO/check_same_connectivity.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/internal/Field_filler.h>
#include <CGAL/Animated_mesh_features/IO/internal/Stl_series.h>
#include <CGAL/Animated_mesh_features/IO/read_mesh.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Thread_local.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What reading one file takes: a thread has its own.
struct Mesh_reading_memory
{
  std::string content;
  Indexed_mesh mesh;
};

// One way to read the frames of a series: all of them have the faces of the first.
class Mesh_series
{
public:
  Mesh_series(const std::vector<std::string>& files, const Mesh_reading_options& options)
    : m_first_file(files[0])
    , m_options(options)
  {
    std::string content;
    read_mesh(m_first_file, m_options, content, m_mesh);
  }

  const Indexed_mesh& mesh() const { return m_mesh; }

  void read_points(const std::string& file, std::string& content, Indexed_mesh& mesh) const
  {
    if (!read_mesh(file, m_options, content, mesh, &m_mesh) || mesh.points.size() != m_mesh.points.size())
      check_same_connectivity(m_mesh, "the first frame, " + m_first_file, mesh, file);
  }

private:
  std::string m_first_file;
  Mesh_reading_options m_options;
  Indexed_mesh m_mesh;
};

// `Series`: Mesh_series or Stl_series
template <class ConcurrencyTag, class Series, class FT>
void read_series(const Series& series, const Memory_chooser& choose_memory, Animation_file_data<FT>& data)
{
  const std::vector<std::string>& files = data.sources;
  data.mesh = series.mesh();
  for (const std::string& remark : data.mesh.remarks) data.notices.push_back(files[0] + ": " + remark);
  Animated_mesh_features::internal::Thread_local<Mesh_reading_memory> memories;
  const std::array<Spatio_temporal_field<FT>*, 3> fields = {{&data.x, &data.y, &data.z}};
  resize_fields(data.mesh.points.size(), data.frames, fields,
                chosen_memory(choose_memory, data.mesh.points.size(), data.frames));
  std::size_t told = data.mesh.remarks.size(); // of one frame only: others are likely to be alike
  Field_filler<FT, ConcurrencyTag> filler(fields);
  filler.put(0, data.mesh.points[0].data(), files[0]);

  for (std::size_t first = 1, last; first < data.frames; first = last) {
    last = filler.end_of_batch();
    // Of several errors, the first frame's is told, whichever thread is faster.
    std::vector<std::exception_ptr> errors(last - first);
    std::vector<std::vector<std::string>> remarks(last - first);
    parallel_for<ConcurrencyTag>(first, last, [&](std::size_t f) {
      try {
        Mesh_reading_memory& m = memories.get([] { return std::make_unique<Mesh_reading_memory>(); });
        series.read_points(files[f], m.content, m.mesh);
        filler.put(f, m.mesh.points[0].data(), files[f]);
        remarks[f - first] = std::move(m.mesh.remarks);
      } catch (...) {
        errors[f - first] = std::current_exception();
      }
    });
    for (const std::exception_ptr& error : errors)
      if (error) std::rethrow_exception(error);
    for (std::size_t f = first; f < last; ++f)
      for (const std::string& remark : remarks[f - first])
        if (told++ == 0) data.notices.push_back(files[f] + ": " + remark);
    filler.finish_batch();
  }
}

template <class ConcurrencyTag, class FT>
void read_frame_files(const std::vector<std::string>& files, const Mesh_reading_options& options,
                      const Memory_chooser& choose_memory, Animation_file_data<FT>& data)
{
  data.sources = files;
  data.frames = files.size();
  const bool is_stl = std::all_of(files.begin(), files.end(), [](const std::string& file) {
    std::error_code ignored; // what is no regular file can be read but once
    return file_format_by_ending(file) == File_format::STL && std::filesystem::is_regular_file(file, ignored);
  });
  if (is_stl)
    read_series<ConcurrencyTag>(Stl_series(files, options), choose_memory, data);
  else
    read_series<ConcurrencyTag>(Mesh_series(files, options), choose_memory, data);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_READ_FRAME_FILES_H
