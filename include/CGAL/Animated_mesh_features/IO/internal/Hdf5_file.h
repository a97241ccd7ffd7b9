// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_HDF5_FILE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_HDF5_FILE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// Errors of the library are reported by exceptions here, not printed by it.
class Hdf5_silence
{
public:
  Hdf5_silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &m_function, &m_data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5_silence() { H5Eset_auto2(H5E_DEFAULT, m_function, m_data); }
  Hdf5_silence(const Hdf5_silence&) = delete;
  Hdf5_silence& operator=(const Hdf5_silence&) = delete;

private:
  H5E_auto2_t m_function = nullptr;
  void* m_data = nullptr;
};

// Something open in the library, closed when it dies.
class Hdf5_handle
{
public:
  Hdf5_handle(hid_t id, herr_t (*close)(hid_t))
    : m_id(id)
    , m_close(close)
  {}
  Hdf5_handle(Hdf5_handle&& other) noexcept
    : m_id(std::exchange(other.m_id, -1))
    , m_close(other.m_close)
  {}
  Hdf5_handle(const Hdf5_handle&) = delete;
  Hdf5_handle& operator=(const Hdf5_handle&) = delete;
  ~Hdf5_handle()
  {
    if (m_id >= 0) m_close(m_id);
  }

  bool is_open() const { return m_id >= 0; }
  hid_t id() const { return m_id; }

private:
  hid_t m_id;
  herr_t (*m_close)(hid_t);
};

// A file of arrays, opened for reading. Links that lead out of it are not followed.
class Hdf5_file
{
public:
  typedef std::vector<hsize_t> Extent;

  explicit Hdf5_file(const std::string& path)
    : m_path(path)
    , m_file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose)
    , m_access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose)
  {
    if (!m_file.is_open()) throw Input_error(path + ": is no readable HDF5 file");
    H5Pset_elink_cb(m_access.id(), refuse_link, nullptr);
  }

  // The names of all arrays, with the groups they are in, in alphabetical order.
  std::vector<std::string> datasets() const
  {
    std::vector<std::string> links, names;
    H5Lvisit(m_file.id(), H5_INDEX_NAME, H5_ITER_INC, append_name, &links);
    for (const std::string& link : links)
      if (open(link).is_open()) names.push_back(link);
    return names;
  }

  // Empty if there is no such array.
  Extent extent(const std::string& name) const
  {
    const Hdf5_handle dataset = open(name);
    if (!dataset.is_open()) return Extent();
    const Hdf5_handle space(H5Dget_space(dataset.id()), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space.id());
    Extent extent(rank > 0 ? std::size_t(rank) : 0);
    if (rank > 0) H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr);
    return extent;
  }

  // To be called before memory for an array is taken: that the file itself holds what the array's extent announces. A file
  // of a few hundred bytes can announce any size, and what was never written would be read as zeros.
  void check_content(const std::string& name) const
  {
    const Hdf5_handle dataset = open(name);
    const Hdf5_handle how(H5Dget_create_plist(dataset.id()), H5Pclose);
    const auto fail = [&](const std::string& text) { throw Input_error(m_path + ": dataset " + name + " " + text); };
    if (H5Pget_layout(how.id()) == H5D_VIRTUAL || H5Pget_external_count(how.id()) > 0)
      fail("keeps its numbers in other files, which are not read; copy them into this one (h5repack)");
    const Hdf5_handle type(H5Dget_type(dataset.id()), H5Tclose);
    double bytes = double(H5Tget_size(type.id()));
    for (hsize_t n : extent(name)) bytes *= double(n);
    const double most_compressed = 1032; // what deflate makes of zeros
    const hsize_t stored = H5Dget_storage_size(dataset.id());
    if (bytes > 0 && stored == 0) fail("has no content: nothing was written into it");
    if (bytes > most_compressed * double(stored))
      fail("announces more numbers than the " + std::to_string(stored) + " bytes that it takes in the file can hold");
  }

  // Reads `count` elements from `start`, in each dimension; converted from whatever numbers they are.
  void read(const std::string& name, const Extent& start, const Extent& count, double* to) const
  {
    read_as(name, start, count, H5T_NATIVE_DOUBLE, to);
  }
  void read(const std::string& name, const Extent& start, const Extent& count, long long* to) const
  {
    read_as(name, start, count, H5T_NATIVE_LLONG, to);
  }

private:
  static herr_t refuse_link(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) { return -1; }

  // Not open if there is no such array.
  Hdf5_handle open(const std::string& name) const
  {
    return Hdf5_handle(H5Dopen2(m_file.id(), name.c_str(), m_access.id()), H5Dclose);
  }

  static herr_t append_name(hid_t, const char* name, const H5L_info_t*, void* names)
  {
    static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
  }

  void read_as(const std::string& name, const Extent& start, const Extent& count, hid_t type, void* to) const
  {
    const Hdf5_handle dataset = open(name);
    const Hdf5_handle space(H5Dget_space(dataset.id()), H5Sclose);
    const Hdf5_handle memory(H5Screate_simple(int(count.size()), count.data(), nullptr), H5Sclose);
    const bool is_read =
        H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
        H5Dread(dataset.id(), type, memory.id(), space.id(), H5P_DEFAULT, to) >= 0;
    if (!is_read) throw Input_error(m_path + ": dataset " + name + " cannot be read as numbers");
  }

  std::string m_path;
  Hdf5_silence m_silence;
  Hdf5_handle m_file;
  Hdf5_handle m_access;
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_HDF5_FILE_H
