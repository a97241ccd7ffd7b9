// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_FILE_FORMAT_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_FILE_FORMAT_H

#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>

#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

The formats of files that hold animations or parts of them.
*/
enum class File_format
{
  UNKNOWN, ///< none of the others
  OBJ,     ///< a mesh, see `read_mesh()`
  OFF,     ///< a mesh, see `read_mesh()`
  PLY,     ///< a mesh, see `read_mesh()`
  STL,     ///< a mesh, see `read_mesh()`
  PC2,     ///< a point cache, see `Point_cache_reader`
  MDD,     ///< a point cache, see `Point_cache_reader`
  GLTF,    ///< an animated model, see `read_gltf()`
  FBX,     ///< an animated model, see `read_assimp()`
  COLLADA, ///< an animated model, see `read_assimp()`
  X,       ///< an animated model, see `read_assimp()`
  HDF5     ///< sequences of positions, see `read_hdf5()`
};

/// \ingroup PkgAnimatedMeshFeaturesReading
/// whether files of that format hold a mesh that does not move: `read_mesh()` reads them.
inline bool is_mesh(File_format format)
{
  return format == File_format::OBJ || format == File_format::OFF || format == File_format::PLY ||
         format == File_format::STL;
}

/// \ingroup PkgAnimatedMeshFeaturesReading
/// whether files of that format hold positions only: `Point_cache_reader` reads them.
inline bool is_point_cache(File_format format)
{
  return format == File_format::PC2 || format == File_format::MDD;
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the ending of the name of a file, in small letters: ".obj" of "Walk.OBJ"; empty if there is none. Letters of ASCII only,
so that the locale has no say.
*/
inline std::string file_ending(const std::string& path)
{
  std::string e = std::filesystem::path(path).extension().string();
  for (char& c : e)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return e;
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the format that the ending of a file's name tells, in either case of letters: .obj, .off, .ply, .stl, .pc2, .mdd, .gltf,
.glb, .fbx, .dae (Collada), .x, .h5 and .hdf5. The file need not be there.
*/
inline File_format file_format_by_ending(const std::string& path)
{
  constexpr std::pair<const char*, File_format> formats[] = {
      {".obj", File_format::OBJ},     {".off", File_format::OFF},   {".ply", File_format::PLY},
      {".stl", File_format::STL},     {".pc2", File_format::PC2},   {".mdd", File_format::MDD},
      {".glb", File_format::GLTF},    {".gltf", File_format::GLTF}, {".fbx", File_format::FBX},
      {".dae", File_format::COLLADA}, {".x", File_format::X},       {".h5", File_format::HDF5},
      {".hdf5", File_format::HDF5}};
  const std::string ending = file_ending(path);
  for (const auto& format : formats)
    if (ending == format.first) return format.second;
  return File_format::UNKNOWN;
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the format of a file: what the ending of its name tells or, if that is none that is known, what its first bytes tell,
which they do for binary glTF, binary FBX and HDF5. What is no regular file is `UNKNOWN`, so that nothing is taken out
of a pipe.

\throws Input_error if the ending tells nothing and the file cannot be read.
*/
inline File_format file_format(const std::string& path)
{
  const File_format by_ending = file_format_by_ending(path);
  std::error_code ignored;
  if (by_ending != File_format::UNKNOWN || !std::filesystem::is_regular_file(path, ignored)) return by_ending;
  std::array<char, 18> bytes{};
  const internal::File_handle file = internal::open_for_reading(path);
  const std::string start(bytes.data(), internal::read_bytes(file.get(), bytes.data(), bytes.size(), path));
  const auto starts_with = [&](const std::string& text) { return start.compare(0, text.size(), text) == 0; };
  if (starts_with("glTF")) return File_format::GLTF;
  if (starts_with("\x89HDF\r\n\x1a\n")) return File_format::HDF5;
  if (starts_with("Kaydara FBX Binary")) return File_format::FBX;
  return File_format::UNKNOWN;
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

tells that the package does not read files of some kind, and which ones it reads.

\throws Input_error if the ending of the name tells no format, and so does the content (see `file_format()`). The message
calls formats that people animate with by their names.
*/
inline void check_known_format(const std::string& path)
{
  if (file_format(path) != File_format::UNKNOWN) return;
  constexpr std::pair<const char*, const char*> foreign[] = {
      {".abc", "Alembic"},  {".usd", "USD"},       {".usda", "USD"},      {".usdc", "USD"},    {".usdz", "USD"},
      {".npz", "NumPy"},    {".npy", "NumPy"},     {".mat", "MATLAB"},    {".vtk", "VTK"},     {".vtp", "VTK"},
      {".vtu", "VTK"},      {".pvd", "VTK"},       {".blend", "Blender"}, {".ma", "Maya"},     {".mb", "Maya"},
      {".bgeo", "Houdini"}, {".c4d", "Cinema 4D"}, {".3ds", "3D Studio"}, {".max", "3ds Max"}, {".bvh", "BVH"},
      {".zip", "packed"},   {".gz", "packed"},     {".7z", "packed"},     {".xz", "packed"},   {".tar", "packed"}};
  const std::string ending = file_ending(path);
  std::string what = ending.empty() ? "unknown kind of file, without an ending of its name"
                                    : "unknown kind of file \"" + ending + "\"";
  for (const auto& format : foreign)
    if (ending == format.first) what = std::string(format.second) + " files (" + ending + ") are not read";
  throw Input_error(path + ": " + what +
                    "; known are meshes (.obj, .off, .ply, .stl), point caches (.pc2, .mdd), animated models (.gltf, "
                    ".glb, .fbx, .dae, .x) and sequences (.h5, .hdf5)");
}

/*!
\ingroup PkgAnimatedMeshFeaturesReading

tells why a file cannot be read, before a library is asked to that tells less.

\throws Input_error if it cannot be opened, with the reason that the system gives.
*/
inline void check_readable(const std::string& path)
{
  internal::open_for_reading(path);
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_FILE_FORMAT_H
