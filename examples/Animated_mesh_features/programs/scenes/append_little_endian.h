// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_APPEND_LITTLE_ENDIAN_H
#define PROGRAMS_SCENES_APPEND_LITTLE_ENDIAN_H

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace Programs {

// Appends the bytes of numbers, the least significant one first, whatever the byte order of the machine.
template <class T>
void append_little_endian(std::string& bytes, const std::vector<T>& values)
{
  const std::size_t begin = bytes.size();
  bytes.resize(begin + values.size() * sizeof(T));
  unsigned char* place = reinterpret_cast<unsigned char*>(&bytes[0]) + begin;
  for (const T& value : values) {
    boost::endian::endian_store<T, sizeof(T), boost::endian::order::little>(place, value);
    place += sizeof(T);
  }
}

} // namespace Programs

#endif // PROGRAMS_SCENES_APPEND_LITTLE_ENDIAN_H
