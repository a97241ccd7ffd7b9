// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/deflated.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <zlib.h>

#include <limits>
#include <new>

namespace Programs {

std::string deflated(const std::string& bytes)
{
  const std::size_t most = (std::numeric_limits<uLong>::max)() / 2; // of 32 bits on some systems
  if (bytes.size() > most) throw CGAL::Animated_mesh_features::Output_error("zlib cannot compress as many bytes");
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(&result[0]), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc(); // the buffer is large enough
  result.resize(size);
  return result;
}

} // namespace Programs
