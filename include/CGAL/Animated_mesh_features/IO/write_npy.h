// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_NPY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_NPY_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a field as NumPy array (format NPY 1.0): `N x F` in C order, so that `numpy.load(file)[v, f]` is the value of
vertex `v` in frame `f`; single precision, little-endian.

\param os a binary stream; errors are left in its state, `Output_file` reports them
\param field the values
*/
template <class FT>
void write_npy(std::ostream& os, const Spatio_temporal_field<FT>& field)
{
  const internal::Byte_order order = internal::Byte_order::LITTLE_ENDIAN_ORDER;
  const std::size_t preamble = 10, alignment = 64; // the values start at a multiple of 64
  std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(field.number_of_rows()) +
                       ", " + std::to_string(field.number_of_frames()) + "), }";
  header.append((alignment - (preamble + header.size() + 1) % alignment) % alignment, ' ');
  header += '\n';
  char length[2];
  internal::store(length, static_cast<std::uint16_t>(header.size()), order);
  os.write("\x93NUMPY\x01\x00", 8);
  os.write(length, sizeof(length));
  os.write(header.data(), static_cast<std::streamsize>(header.size()));

  std::vector<char> bytes(4 * field.number_of_frames());
  for (std::size_t v = 0; v < field.number_of_rows() && os; ++v) {
    for (std::size_t f = 0; f < field.number_of_frames(); ++f)
      internal::store(bytes.data() + 4 * f, static_cast<float>(field(v, f)), order);
    os.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_WRITE_NPY_H
