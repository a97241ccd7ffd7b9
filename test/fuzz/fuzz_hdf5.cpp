// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// HDF5 files, as far as they are the package's: the bytes tell which datasets there are, of which sizes, types and
// layouts, and the library writes them. Bytes of the file itself are the library's affair.

#include "fuzz_support.h"

#include <CGAL/Animated_mesh_features/IO/read_hdf5.h>

#include <fuzzer/FuzzedDataProvider.h>
#include <hdf5.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace Amf = CGAL::Animated_mesh_features;
using fuzz::require;

namespace {

// Mostly small; but a file of a few hundred bytes can announce any size.
hsize_t extent(FuzzedDataProvider& bytes)
{
  const std::uint8_t n = bytes.ConsumeIntegral<std::uint8_t>();
  return n < 240 ? n % 12 : hsize_t(1) << (4 * (n - 239)) % 60;
}

hid_t type(FuzzedDataProvider& bytes)
{
  const hid_t types[] = {H5T_STD_I8LE,  H5T_STD_U8LE,    H5T_STD_I32BE,   H5T_STD_U32LE, H5T_STD_I64LE,
                         H5T_STD_U64BE, H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_C_S1,      H5T_STD_REF_OBJ};
  return types[bytes.ConsumeIntegralInRange<std::size_t>(0, sizeof(types) / sizeof(types[0]) - 1)];
}

// In pieces of 4 in each dimension, compressed or not, or in one; written or not; with a value for what is not written.
void put_dataset(hid_t file, FuzzedDataProvider& bytes)
{
  const char* const names[] = {"faces", "walk", "a/walk", "a"};
  const char* const name = names[bytes.ConsumeIntegralInRange<std::size_t>(0, 3)];
  const int rank = bytes.ConsumeIntegralInRange<int>(0, 4);
  std::vector<hsize_t> extents;
  std::size_t size = 1;
  for (int i = 0; i < rank; ++i) {
    extents.push_back(extent(bytes));
    size = extents[i] == 0 ? 0 : (std::min)(size * std::size_t(std::min<hsize_t>(extents[i], 4096)), std::size_t(4096));
  }
  const hid_t of = type(bytes);
  const std::uint8_t layout = bytes.ConsumeIntegral<std::uint8_t>();

  const hid_t links = H5Pcreate(H5P_LINK_CREATE), how = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  if (layout % 2 != 0 && rank > 0) {
    H5Pset_chunk(how, rank, std::vector<hsize_t>(std::size_t(rank), 4).data());
    if (layout % 4 == 3) H5Pset_deflate(how, 6);
  }
  const hid_t space = H5Screate_simple(rank, extents.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, of, space, links, how, H5P_DEFAULT);
  if (dataset >= 0 && layout % 8 < 6 && size < 4096 && of != H5T_STD_REF_OBJ) {
    std::vector<std::uint8_t> values(8 * size);
    for (std::uint8_t& value : values) value = bytes.ConsumeIntegral<std::uint8_t>();
    H5Dwrite(dataset, of, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  if (dataset >= 0) H5Dclose(dataset);
  if (space >= 0) H5Sclose(space);
  H5Pclose(how);
  H5Pclose(links);
}

void put_file(const std::string& path, FuzzedDataProvider& bytes)
{
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  require(file >= 0, "the folder for temporary files can be written");
  const int datasets = bytes.ConsumeIntegralInRange<int>(1, 3);
  for (int i = 0; i < datasets; ++i) put_dataset(file, bytes);
  H5Fclose(file);
}

void check(const Amf::IO::Animation_file_data<float>& data)
{
  require(data.frames >= 2 && data.x.number_of_frames() == data.frames, "there are frames");
  require(data.x.number_of_rows() == data.mesh.points.size(), "each vertex has its row of frames");
  for (const auto& triangle : data.mesh.triangles)
    for (std::size_t v : triangle) require(v < data.mesh.points.size(), "corners are vertices");
  for (std::size_t v = 0; v < data.x.number_of_rows(); ++v)
    for (std::size_t f = 0; f < data.frames; ++f)
      require(std::isfinite(data.x(v, f)) && std::isfinite(data.y(v, f)) && std::isfinite(data.z(v, f)),
              "positions are finite");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  const std::string& path = fuzz::files().path(".h5");
  const std::string sequence = bytes.ConsumeBool() ? "" : "a/walk", faces = bytes.ConsumeBool() ? "faces" : "a";
  put_file(path, bytes);
  Amf::IO::Animation_file_data<float> animation;
  try {
    animation = Amf::IO::read_hdf5<float>(path, sequence, faces);
  } catch (const Amf::Input_error&) {
    return 0;
  } catch (const Amf::Option_error&) {
    return 0;
  }
  check(animation);
  return 0;
}
