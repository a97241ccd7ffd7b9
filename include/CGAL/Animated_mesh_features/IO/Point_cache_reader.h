// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_POINT_CACHE_READER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_POINT_CACHE_READER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/internal/Field_filler.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/IO/internal/read_frame_pieces.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads a point cache: the positions of `N` vertices in `F` frames, in single precision, without connectivity. Two
formats are known, by the ending of the file's name:
- PC2 (`.pc2`; 3ds Max, Blender, Maya): little-endian; the frames are equidistant, their rate is not told;
- MDD (`.mdd`; LightWave, Blender): big-endian; each frame has its time (s).

Files may be larger than 4 GB, and than the memory. A pipe can be read as well; that it ends early is then noticed late.
*/
class Point_cache_reader
{
public:
  /*!
  opens a point cache and reads its header.
  \throws Input_error if the file cannot be read, is no point cache, is shorter than its header says (the message
  counts the whole frames there are) or longer, or has no points or no frames.
  */
  explicit Point_cache_reader(const std::string& path)
    : m_path(path)
    , m_file(internal::open_for_reading(path))
  {
    const File_format format = file_format_by_ending(path);
    if (format == File_format::PC2) {
      read_pc2_header();
    } else if (format == File_format::MDD) {
      read_mdd_header();
    } else {
      fail("unknown kind of point cache \"" + file_ending(path) + "\"; known are .pc2 and .mdd");
    }
  }

  std::size_t number_of_points() const { return m_points; } ///< `N`
  std::size_t number_of_frames() const { return m_frames; } ///< `F`

  /// the time of each frame (s); empty for PC2, which has none.
  const std::vector<double>& times() const { return m_times; }

  /// the number of the first frame in the program that wrote a PC2 file; 0 for MDD.
  double start_frame() const { return m_start_frame; }

  /// the distance of the samples of a PC2 file, in frames; 1 for MDD.
  double sample_rate() const { return m_sample_rate; }

  /*!
  checks that the cache belongs to a mesh.
  \throws Input_error if it does not have `number_of_vertices` points.
  */
  void check_number_of_points(std::size_t number_of_vertices, const std::string& name_of_mesh) const
  {
    if (m_points != number_of_vertices)
      fail("has " + std::to_string(m_points) + " points, but the mesh " + name_of_mesh + " has " +
           std::to_string(number_of_vertices) + " vertices");
  }

  /*!
  reads all frames in their order, one frame being in memory at a time. The frames can be read once, by this or by
  `read_fields()`.
  \param sink a callable `void(std::size_t f, const float* xyz)` that gets the `3 N` coordinates of frame `f`, vertex by
         vertex; the memory is valid during the call.
  \throws Input_error if a position is not finite (the message names frame and vertex) or the file cannot be read.
  */
  template <class Frame_sink>
  void read_frames(Frame_sink sink)
  {
    std::vector<float> xyz(3 * m_points);
    for (std::size_t f = 0; f < m_frames; ++f) {
      const std::size_t n =
          internal::read_bytes(m_file.get(), reinterpret_cast<char*>(xyz.data()), frame_size(), m_path);
      if (n < frame_size()) fail_for_size(m_header_size + f * std::uint64_t(frame_size()) + n);
      internal::convert_from(m_order, xyz.data(), xyz.size());
      const auto bad = std::find_if_not(xyz.begin(), xyz.end(), [](float x) { return internal::is_finite(x); });
      if (bad != xyz.end())
        fail("frame " + std::to_string(f) + ", vertex " + std::to_string((bad - xyz.begin()) / 3) +
             ": the position is not finite");
      sink(f, static_cast<const float*>(xyz.data()));
    }
    char one;
    if (internal::read_bytes(m_file.get(), &one, 1, m_path) != 0) fail("goes on after the last frame");
  }

  /*!
  reads all frames into fields `N x F`, a row for each vertex: the layout of the package. Errors are those of
  `read_frames()`. Memory beside the fields: some 0.4 MB a thread; 16 frames for a pipe, and on systems where several
  threads cannot read a file at once.
  \tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`; the result is the same.
  */
  template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class FT>
  void read_fields(Spatio_temporal_field<FT>& x, Spatio_temporal_field<FT>& y, Spatio_temporal_field<FT>& z,
                   const std::shared_ptr<Field_memory>& memory = Field_memory::heap())
  {
    const std::array<Spatio_temporal_field<FT>*, 3> fields = {{&x, &y, &z}};
    internal::resize_fields(m_points, m_frames, fields, memory);
    const internal::Frames_in_file frames = {m_file.get(), m_header_size, m_points, m_frames, m_order};
    if (internal::read_frame_pieces<ConcurrencyTag>(frames, fields)) return;
    internal::Field_filler<FT, ConcurrencyTag> filler(fields);
    read_frames([&](std::size_t f, const float* xyz) {
      filler.put(f, xyz, m_path);
      if (f + 1 == filler.end_of_batch()) filler.finish_batch();
    });
  }

private:
  std::size_t frame_size() const { return 3 * sizeof(float) * m_points; }

  void read_header(char* bytes, std::size_t size)
  {
    const std::size_t n = internal::read_bytes(m_file.get(), bytes, size, m_path);
    if (n < size) fail(n == 0 && m_header_size == 0 ? "is empty" : "ends within the header");
    m_header_size += size;
  }

  void set_counts(std::int32_t points, std::int32_t frames)
  {
    if (points <= 0) fail("the header announces " + std::to_string(points) + " points");
    if (frames <= 0) fail("the header announces " + std::to_string(frames) + " frames");
    m_points = static_cast<std::size_t>(points);
    m_frames = static_cast<std::size_t>(frames);
  }

  // Before anything of the size that the header tells is allocated.
  void check_size(std::uint64_t header_size)
  {
    m_header_size = header_size;
    std::error_code error;
    if (!std::filesystem::is_regular_file(m_path, error)) return;
    const std::uint64_t actual = std::filesystem::file_size(m_path, error);
    if (!error && actual != expected_size()) fail_for_size(actual);
  }

  // The largest number if even that is too small: 2^31 points in 2^31 frames would exceed it.
  std::uint64_t expected_size() const
  {
    const std::uint64_t largest = (std::numeric_limits<std::uint64_t>::max)();
    if (m_frames > (largest - m_header_size) / frame_size()) return largest;
    return m_header_size + std::uint64_t(m_frames) * frame_size();
  }

  [[noreturn]] void fail_for_size(std::uint64_t actual) const
  {
    const std::string sizes = std::to_string(m_points) + " points in " + std::to_string(m_frames) + " frames take " +
                              std::to_string(expected_size()) + " bytes, the file has " + std::to_string(actual);
    if (actual > expected_size()) fail(sizes + ": " + std::to_string(actual - expected_size()) + " too many");
    const std::uint64_t whole = actual < m_header_size ? 0 : (actual - m_header_size) / frame_size();
    fail(sizes + ": it is cut off after " + std::to_string(whole) + " whole frames");
  }

  void read_pc2_header()
  {
    const char magic[] = "POINTCACHE2"; // with its final zero
    char h[32];
    read_header(h, sizeof(h));
    if (std::memcmp(h, magic, sizeof(magic)) != 0)
      fail(std::string("is no PC2 file: it does not start with POINTCACHE2") +
           (has_size_of_mdd(h) ? "; this is an MDD file, whose name should end in .mdd" : ""));
    const std::int32_t version = internal::load<std::int32_t>(h + 12, m_order);
    if (version != 1) fail("is a PC2 file of version " + std::to_string(version) + "; known is 1");
    m_start_frame = internal::load<float>(h + 20, m_order);
    m_sample_rate = internal::load<float>(h + 24, m_order);
    set_counts(internal::load<std::int32_t>(h + 16, m_order), internal::load<std::int32_t>(h + 28, m_order));
    check_size(sizeof(h));
  }

  // Whether the file is as large as its first bytes, as the counts of an MDD file, ask for.
  bool has_size_of_mdd(const char* h) const
  {
    const internal::Byte_order order = internal::Byte_order::BIG_ENDIAN_ORDER;
    const double frames = internal::load<std::int32_t>(h, order), points = internal::load<std::int32_t>(h + 4, order);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(m_path, error);
    return !error && frames > 0 && points > 0 && double(size) == 8 + frames * (4 + 12 * points);
  }

  void read_mdd_header()
  {
    m_order = internal::Byte_order::BIG_ENDIAN_ORDER;
    char h[8];
    read_header(h, sizeof(h));
    if (std::memcmp(h, "POINTCACHE2", sizeof(h)) == 0)
      fail("is no MDD file: this is a PC2 file, whose name should end in .pc2");
    set_counts(internal::load<std::int32_t>(h + 4, m_order), internal::load<std::int32_t>(h, m_order));
    check_size(sizeof(h) + sizeof(float) * std::uint64_t(m_frames));
    std::vector<char> bytes(sizeof(float) * m_frames);
    const std::size_t n = internal::read_bytes(m_file.get(), bytes.data(), bytes.size(), m_path);
    if (n < bytes.size()) fail_for_size(sizeof(h) + n);
    for (std::size_t f = 0; f < m_frames; ++f) {
      const float t = internal::load<float>(bytes.data() + f * sizeof(float), m_order);
      if (!internal::is_finite(t)) fail("frame " + std::to_string(f) + ": the time is not finite");
      m_times.push_back(t);
    }
  }

  [[noreturn]] void fail(const std::string& message) const { throw Input_error(m_path + ": " + message); }

  std::string m_path;
  internal::File_handle m_file;
  internal::Byte_order m_order = internal::Byte_order::LITTLE_ENDIAN_ORDER;
  std::uint64_t m_header_size = 0;
  std::size_t m_points = 0;
  std::size_t m_frames = 0;
  double m_start_frame = 0;
  double m_sample_rate = 1;
  std::vector<double> m_times;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_POINT_CACHE_READER_H
