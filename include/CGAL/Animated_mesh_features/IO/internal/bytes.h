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
#include <utility>

// Scalars in files of a given byte order, whatever the byte order of the machine.

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

// A single expression for each order, without a loop: compilers turn it into a plain load or a byte swap.
template <class Unsigned, std::size_t... i>
Unsigned from_little_endian(const char* bytes, std::index_sequence<i...>)
{
  return static_cast<Unsigned>((... | (Unsigned(static_cast<unsigned char>(bytes[i])) << (8 * i))));
}

template <class Unsigned, std::size_t... i>
Unsigned from_big_endian(const char* bytes, std::index_sequence<i...>)
{
  return static_cast<Unsigned>(
      (... | (Unsigned(static_cast<unsigned char>(bytes[i])) << (8 * (sizeof(Unsigned) - 1 - i)))));
}

template <class T>
T load(const char* bytes, Byte_order order)
{
  typedef typename Unsigned_of_size<sizeof(T)>::type Unsigned;
  typedef std::make_index_sequence<sizeof(T)> Bytes;
  const Unsigned u = order == Byte_order::LITTLE_ENDIAN_ORDER ? from_little_endian<Unsigned>(bytes, Bytes())
                                                              : from_big_endian<Unsigned>(bytes, Bytes());
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

inline Byte_order native_byte_order()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1 ? Byte_order::LITTLE_ENDIAN_ORDER : Byte_order::BIG_ENDIAN_ORDER;
}

// Makes `n` scalars, which were read from a file as they are, the machine's.
template <class T>
void convert_from(Byte_order order, T* values, std::size_t n)
{
  if (order == native_byte_order()) return;
  for (std::size_t i = 0; i < n; ++i) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, values + i, sizeof(T));
    values[i] = order == Byte_order::LITTLE_ENDIAN_ORDER ? load<T>(bytes, Byte_order::LITTLE_ENDIAN_ORDER)
                                                         : load<T>(bytes, Byte_order::BIG_ENDIAN_ORDER);
  }
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_BYTES_H
