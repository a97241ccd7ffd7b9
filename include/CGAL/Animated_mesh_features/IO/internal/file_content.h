// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_CONTENT_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_CONTENT_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <system_error>

#if defined(__unix__) || (defined(__APPLE__) && defined(__MACH__))
  #define CGAL_ANIMATED_MESH_FEATURES_HAS_PREAD
  #include <sys/types.h>
  #include <unistd.h>
#endif

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

struct File_closer
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};

typedef std::unique_ptr<std::FILE, File_closer> File_handle;

[[noreturn]] inline void throw_cannot_read(const std::string& path, int error)
{
  throw Input_error(path + ": cannot read: " + std::generic_category().message(error));
}

inline File_handle open_for_reading(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw_cannot_read(path, EISDIR);
  errno = 0;
  File_handle file(std::fopen(path.c_str(), "rb"));
  if (!file) throw_cannot_read(path, errno);
  return file;
}

// The next `size` bytes, or fewer at the end of the file.
inline std::size_t read_bytes(std::FILE* file, char* bytes, std::size_t size, const std::string& path)
{
  errno = 0;
  const std::size_t n = std::fread(bytes, 1, size, file);
  if (n < size && std::ferror(file)) throw_cannot_read(path, errno != 0 ? errno : EIO);
  return n;
}

// Reads `size` bytes at `offset`, from any thread, leaving the position of the file where it is. `false` if they cannot
// be read in this way: on systems without it, from pipes, after the end of the file, or if reading fails; whoever
// reads the file from its start will find out why.
//
// This is how large files are read in pieces. Mapping them into memory takes as long, but a mapped file that shrinks
// meanwhile, as when its animation is exported again, kills the process.
inline bool read_bytes_at(std::FILE* file, char* bytes, std::size_t size, std::uint64_t offset)
{
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_PREAD
  if (offset > static_cast<std::uint64_t>((std::numeric_limits<off_t>::max)()) - size) return false;
  while (size > 0) {
    const ssize_t n = pread(fileno(file), bytes, size, static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes += n;
    size -= static_cast<std::size_t>(n);
    offset += static_cast<std::uint64_t>(n);
  }
  return true;
#else
  (void)file, (void)bytes, (void)size, (void)offset;
  return false;
#endif
}

// The whole file; its memory is reused. Also for pipes, whose size is not known before.
inline void read_content(const std::string& path, std::string& content)
{
  const File_handle file = open_for_reading(path);
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  const std::size_t at_least = 1 << 16;
  // one byte more than expected, so that the first read already meets the end
  content.resize(unknown || size < at_least ? at_least : std::size_t(size) + 1);
  std::size_t n = 0;
  while (true) {
    n += read_bytes(file.get(), &content[n], content.size() - n, path);
    if (n < content.size()) break;
    content.resize(2 * n);
  }
  content.resize(n);
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_CONTENT_H
