// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BYTES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Scalars in files of a given byte order, whatever the byte order of the machine. Compilers turn the shifts into a
// plain load or a byte swap.

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

enum class Byte_order
{
  LITTLE_ENDIAN_ORDER,
  BIG_ENDIAN_ORDER
};

template <std::size_t size>
struct Unsigned_of_size;
template <>
struct Unsigned_of_size<1>
{
  typedef std::uint8_t type;
};
template <>
struct Unsigned_of_size<2>
{
  typedef std::uint16_t type;
};
template <>
struct Unsigned_of_size<4>
{
  typedef std::uint32_t type;
};
template <>
struct Unsigned_of_size<8>
{
  typedef std::uint64_t type;
};

template <class T>
T load(const char* bytes, Byte_order order)
{
  typedef typename Unsigned_of_size<sizeof(T)>::type Unsigned;
  Unsigned u = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t shift = 8 * (order == Byte_order::LITTLE_ENDIAN_ORDER ? i : sizeof(T) - 1 - i);
    u = Unsigned(u | (Unsigned(static_cast<unsigned char>(bytes[i])) << shift));
  }
  T value;
  std::memcpy(&value, &u, sizeof(T));
  return value;
}

template <class T>
void store(char* bytes, T value, Byte_order order)
{
  typedef typename Unsigned_of_size<sizeof(T)>::type Unsigned;
  Unsigned u;
  std::memcpy(&u, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    const std::size_t shift = 8 * (order == Byte_order::LITTLE_ENDIAN_ORDER ? i : sizeof(T) - 1 - i);
    bytes[i] = static_cast<char>(static_cast<unsigned char>(u >> shift));
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BYTES_H
