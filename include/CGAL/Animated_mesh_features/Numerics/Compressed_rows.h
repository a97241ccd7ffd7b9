// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_COMPRESSED_ROWS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_COMPRESSED_ROWS_H

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesNumerics

Rows of indices of varying length, stored one after the other: the neighbours of each vertex, the vertices in each
geodesic ball. Memory: `8 (rows + 1) + 4 entries` bytes.
*/
class Compressed_rows
{
public:
  /// of vertices, edges or triangles.
  typedef std::uint32_t Index;

  /// the entries of a row, as a range with random access; valid until the rows are changed.
  typedef boost::iterator_range<const Index*> Row;

  /// no rows.
  Compressed_rows() : m_offsets(1, 0) {}

  /// the rows of a vector of vectors, whose memory is given back on the way.
  explicit Compressed_rows(std::vector<std::vector<Index>>&& rows) : m_offsets(1, 0)
  {
    m_offsets.reserve(rows.size() + 1);
    for (const std::vector<Index>& row : rows) m_offsets.push_back(m_offsets.back() + row.size());
    m_entries.reserve(m_offsets.back());
    for (std::vector<Index>& row : rows) {
      m_entries.insert(m_entries.end(), row.begin(), row.end());
      std::vector<Index>().swap(row);
    }
  }

  /// rows of these sizes, to be filled in through `row()`.
  explicit Compressed_rows(const std::vector<Index>& sizes) : m_offsets(1, 0)
  {
    m_offsets.reserve(sizes.size() + 1);
    for (Index size : sizes) m_offsets.push_back(m_offsets.back() + size);
    m_entries.resize(m_offsets.back());
  }

  /// the beginning of the `i`-th row.
  Index* row(std::size_t i) { return m_entries.data() + m_offsets[i]; }

  /// appends the row `[first, last)`.
  template <class InputIterator>
  void push_back(InputIterator first, InputIterator last)
  {
    m_entries.insert(m_entries.end(), first, last);
    m_offsets.push_back(m_entries.size());
  }

  /// the number of rows.
  std::size_t size() const { return m_offsets.size() - 1; }

  /// the lengths of all rows together.
  std::size_t number_of_entries() const { return m_entries.size(); }

  /// the `i`-th row, from 0.
  Row operator[](std::size_t i) const
  {
    return Row(m_entries.data() + m_offsets[i], m_entries.data() + m_offsets[i + 1]);
  }

  /// the memory that the rows take, in bytes.
  std::size_t memory() const
  {
    return m_offsets.capacity() * sizeof(std::size_t) + m_entries.capacity() * sizeof(Index);
  }

private:
  std::vector<std::size_t> m_offsets;
  std::vector<Index> m_entries;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_COMPRESSED_ROWS_H
