// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_FUZZ_SUPPORT_H
#define CGAL_ANIMATED_MESH_FEATURES_FUZZ_SUPPORT_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include <unistd.h>

// What the fuzz targets share. A target gives bytes to a reader: it refuses them with an exception of the documented type,
// or what it returns keeps what its documentation promises. Everything else ends the process, and libFuzzer keeps the bytes.

namespace fuzz {

// Ends the process with a message unless `holds`.
inline void require(bool holds, const char* what)
{
  if (holds) return;
  std::fprintf(stderr, "fuzz target: this does not hold: %s\n", what);
  std::abort();
}

// Puts bytes where readers that want the name of a file find them: each ending has a file of its own, in the folder for
// temporary files, which scripts/fuzz.sh puts into memory. It is removed when the process ends well.
class Files
{
public:
  Files() = default;
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  ~Files()
  {
    std::error_code ignored;
    for (const auto& path : m_paths) std::filesystem::remove(path.second, ignored);
  }

  const std::string& path(const std::string& ending)
  {
    std::string& path = m_paths[ending];
    if (path.empty())
      path = (std::filesystem::temp_directory_path() / ("fuzz_" + std::to_string(getpid()) + ending)).string();
    return path;
  }

  const std::string& write(const std::string& ending, const void* bytes, std::size_t size)
  {
    const std::string& name = path(ending);
    std::FILE* const file = std::fopen(name.c_str(), "wb");
    const bool is_written = file != nullptr && std::fwrite(bytes, 1, size, file) == size;
    require(file != nullptr && std::fclose(file) == 0 && is_written, "the folder for temporary files can be written");
    return name;
  }

private:
  std::map<std::string, std::string> m_paths;
};

inline Files& files()
{
  static Files files;
  return files;
}

} // namespace fuzz

#endif // CGAL_ANIMATED_MESH_FEATURES_FUZZ_SUPPORT_H
