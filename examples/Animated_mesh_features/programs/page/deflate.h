// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_DEFLATE_H
#define PROGRAMS_PAGE_DEFLATE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The bytes compressed as a zlib stream (RFC 1950): what browsers call "deflate". Needs zlib.
// throws std::bad_alloc, Output_error.
inline std::string deflated(std::string_view bytes)
{
  z_stream z{};
  if (deflateInit(&z, Z_BEST_COMPRESSION) != Z_OK) throw std::bad_alloc();
  struct End
  {
    z_stream* z;
    ~End() { deflateEnd(z); }
  } end{&z};

  std::string result;
  std::vector<unsigned char> buffer(std::size_t(1) << 16);
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (z.avail_in == 0 && !bytes.empty()) {
      // zlib counts with `unsigned`
      const std::size_t part = (std::min)(bytes.size(), std::size_t((std::numeric_limits<uInt>::max)()));
      z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      z.avail_in = static_cast<uInt>(part);
      bytes.remove_prefix(part);
    }
    z.next_out = buffer.data();
    z.avail_out = static_cast<uInt>(buffer.size());
    state = deflate(&z, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END) throw Output_error("zlib cannot compress");
    result.append(reinterpret_cast<const char*>(buffer.data()), buffer.size() - z.avail_out);
  }
  return result;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PAGE_DEFLATE_H
