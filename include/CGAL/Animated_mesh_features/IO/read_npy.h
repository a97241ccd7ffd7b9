// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_READ_NPY_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_READ_NPY_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/IO/internal/bytes.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// The header of a NumPy file, whose text is a dictionary of Python.
class Npy_header
{
public:
  Npy_header(const std::string& content, const std::string& file)
    : m_file(file)
  {
    const std::size_t before_length = 8;
    if (content.size() < before_length + 4 || content.compare(0, 6, "\x93NUMPY") != 0) fail("is no NumPy file");
    const bool is_first = content[6] == 1;
    if (!is_first && content[6] != 2) fail("has a version of the NumPy format that is not known");
    const char* const p = content.data() + before_length;
    const std::size_t length = is_first ? std::size_t(load<std::uint16_t>(p, Byte_order::LITTLE_ENDIAN_ORDER))
                                        : std::size_t(load<std::uint32_t>(p, Byte_order::LITTLE_ENDIAN_ORDER));
    m_begin = before_length + (is_first ? 2 : 4);
    if (content.size() - m_begin < length) fail("ends within its header");
    m_text = content.substr(m_begin, length);
    m_begin += length;
  }

  // where the values begin
  std::size_t begin() const { return m_begin; }

  // what follows a key, without blanks before it
  std::string value(const std::string& key) const
  {
    std::size_t place = m_text.find("'" + key + "'");
    if (place != std::string::npos) place = m_text.find(':', place);
    if (place != std::string::npos) place = m_text.find_first_not_of(' ', place + 1);
    if (place == std::string::npos) fail("has a header without " + key);
    return m_text.substr(place);
  }

  // The two numbers of the shape.
  void read_shape(std::size_t& rows, std::size_t& columns) const
  {
    const std::string text = value("shape");
    std::size_t place = 1;
    const auto number = [&](char end) {
      std::size_t n = 0, digits = 0;
      while (place < text.size() && text[place] == ' ') ++place;
      for (; place < text.size() && text[place] >= '0' && text[place] <= '9'; ++place, ++digits)
        n = 10 * n + std::size_t(text[place] - '0');
      if (digits == 0 || digits > 15 || place == text.size() || text[place++] != end) fail("is not N x F");
      return n;
    };
    if (text.empty() || text[0] != '(') fail("is not N x F");
    rows = number(',');
    columns = number(')');
  }

  [[noreturn]] void fail(const std::string& what) const { throw Input_error(m_file + ": " + what); }

private:
  std::string m_file, m_text;
  std::size_t m_begin = 0;
};

template <class Number, class FT>
void load_values(const char* bytes, Spatio_temporal_field<FT>& field)
{
  for (std::size_t v = 0; v < field.number_of_rows(); ++v)
    for (std::size_t m = 0; m < field.number_of_frames(); ++m, bytes += sizeof(Number))
      field(v, m) = FT(load<Number>(bytes, Byte_order::LITTLE_ENDIAN_ORDER));
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesReading

reads a field from a NumPy array (formats NPY 1.0 and 2.0), `N x F` in C order, in single or double precision,
little-endian: what `write_npy()` writes.

\tparam FT `float` or `double`, the scalar of the field.
\throws Input_error if the file cannot be read, is no such array, or has not the size that its header tells. Values that are
not finite are read as they are.

Linear in the size of the file, which is held in memory.
*/
template <class FT = float>
Spatio_temporal_field<FT> read_npy(const std::string& path)
{
  std::string content;
  internal::read_content(path, content);
  const internal::Npy_header header(content, path);
  const std::string type = header.value("descr");
  const bool is_single = type.compare(0, 5, "'<f4'") == 0;
  if (!is_single && type.compare(0, 5, "'<f8'") != 0) header.fail("holds no little-endian float32 or float64");
  if (header.value("fortran_order").compare(0, 5, "False") != 0) header.fail("is not in C order");
  std::size_t rows = 0, columns = 0;
  header.read_shape(rows, columns);
  const std::size_t bytes = content.size() - header.begin(), size = is_single ? 4 : 8;
  if (columns == 0) header.fail("has no frames");
  if (bytes % size != 0 || bytes / size % columns != 0 || bytes / size / columns != rows)
    header.fail("has " + std::to_string(bytes) + " bytes of values, not " + std::to_string(rows) + " x " +
                std::to_string(columns));
  Spatio_temporal_field<FT> field(rows, columns);
  if (is_single)
    internal::load_values<float>(content.data() + header.begin(), field);
  else
    internal::load_values<double>(content.data() + header.begin(), field);
  return field;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_READ_NPY_H
