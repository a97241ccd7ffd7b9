// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/deflated.h"

#include "running/Interruption.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <new>

namespace Programs {

namespace {

// A stream of zlib.
class Deflation
{
public:
  Deflation()
  {
    if (deflateInit(&m_stream, Z_BEST_COMPRESSION) != Z_OK) throw std::bad_alloc();
  }
  ~Deflation() { deflateEnd(&m_stream); }
  Deflation(const Deflation&) = delete;
  Deflation& operator=(const Deflation&) = delete;

  int run(const char* from, std::size_t given, bool is_last, char* to, std::size_t room)
  {
    m_stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(from));
    m_stream.avail_in = static_cast<uInt>(given);
    m_stream.next_out = reinterpret_cast<Bytef*>(to);
    m_stream.avail_out = static_cast<uInt>(room);
    return deflate(&m_stream, is_last ? Z_FINISH : Z_NO_FLUSH);
  }

  std::size_t not_taken() const { return m_stream.avail_in; }
  std::size_t not_filled() const { return m_stream.avail_out; }

private:
  z_stream m_stream = {};
};

} // namespace

std::string deflated(const std::string& bytes)
{
  const std::size_t most = (std::numeric_limits<uLong>::max)() / 2; // of 32 bits on some systems
  if (bytes.size() > most) throw CGAL::Animated_mesh_features::Output_error("zlib cannot compress as many bytes");
  Deflation deflation;
  std::string result(compressBound(static_cast<uLong>(bytes.size())), '\0');
  const std::size_t piece = std::size_t(1) << 20; // some tens of milliseconds
  std::size_t taken = 0, made = 0;
  for (int state = Z_OK; state != Z_STREAM_END;) {
    Interruption::check();
    const std::size_t room = (std::min)(piece, result.size() - made), given = (std::min)(piece, bytes.size() - taken);
    state = deflation.run(&bytes[0] + taken, given, taken + given == bytes.size(), &result[0] + made, room);
    taken += given - deflation.not_taken();
    made += room - deflation.not_filled();
  }
  result.resize(made);
  return result;
}

} // namespace Programs
