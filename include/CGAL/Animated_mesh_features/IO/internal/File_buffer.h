// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_BUFFER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_BUFFER_H

#include <cerrno>
#include <cstdio>
#include <streambuf>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// What std::ofstream lacks: the reason why the first write failed, and exclusive creation (by std::fopen's "x").
// Buffering is left to the C library. Does not close the file.
class File_buffer : public std::streambuf
{
public:
  explicit File_buffer(std::FILE* file = nullptr)
    : m_file(file)
  {}

  void set_file(std::FILE* file) { m_file = file; }

  // errno of the first failed write, 0 if all went well
  int error() const { return m_error; }

protected:
  int_type overflow(int_type c) override
  {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char one = traits_type::to_char_type(c);
    return xsputn(&one, 1) == 1 ? c : traits_type::eof();
  }

  std::streamsize xsputn(const char* text, std::streamsize n) override
  {
    if (m_file == nullptr || m_error != 0) return 0;
    errno = 0;
    const std::size_t written = std::fwrite(text, 1, static_cast<std::size_t>(n), m_file);
    if (written != static_cast<std::size_t>(n)) m_error = errno != 0 ? errno : EIO;
    return static_cast<std::streamsize>(written);
  }

  int sync() override
  {
    if (m_file == nullptr || m_error != 0) return -1;
    errno = 0;
    if (std::fflush(m_file) == 0) return 0;
    m_error = errno != 0 ? errno : EIO;
    return -1;
  }

private:
  std::FILE* m_file;
  int m_error = 0;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_FILE_BUFFER_H
