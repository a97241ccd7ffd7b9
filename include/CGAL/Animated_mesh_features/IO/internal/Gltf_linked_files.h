// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_LINKED_FILES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_LINKED_FILES_H

#include <CGAL/Animated_mesh_features/IO/Linked_files.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The name that a URI stands for: %20 is a space (RFC 3986, section 2.1).
inline std::string decoded_uri(const std::string& uri)
{
  const auto digit = [](char c) {
    const std::string digits = "0123456789abcdef";
    return digits.find(char(std::tolower(static_cast<unsigned char>(c))));
  };
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape = uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) != std::string::npos &&
                           digit(uri[i + 2]) != std::string::npos;
    name += is_escape ? char(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (is_escape) i += 2;
  }
  return name;
}

// Decides which files a model may have its buffers in, and reads them. A model is somebody else's: it does not choose which
// of the user's files are opened.
class Gltf_linked_files
{
public:
  Gltf_linked_files(const std::string& model, Linked_files allowed, const Gltf_check& check)
    : m_folder(std::filesystem::path(model).parent_path())
    , m_allowed(allowed)
    , m_check(check)
  {
    if (m_folder.empty()) m_folder = ".";
  }

  // The first `size` bytes of the file of a buffer.
  std::vector<unsigned char> read(const std::string& uri, std::size_t size, const std::string& buffer)
  {
    const std::filesystem::path file = path(uri, buffer);
    std::error_code error;
    const std::uintmax_t there = std::filesystem::file_size(file, error);
    if (error || there < size)
      m_check.fail(buffer + ": " + file.string() + " has " + std::to_string(error ? 0 : there) + " bytes, not " +
                   std::to_string(size));
    // A buffer of a few characters may name a large file, and so may a thousand.
    const std::uintmax_t most_again = std::uintmax_t(1) << 28;
    if (std::find(m_files.begin(), m_files.end(), file.string()) != m_files.end() && (m_again += size) > most_again)
      m_check.fail(buffer + ": " + file.string() + " is read again and again");
    std::vector<unsigned char> bytes(size);
    const File_handle handle = open_for_reading(file.string());
    if (read_bytes(handle.get(), reinterpret_cast<char*>(bytes.data()), size, file.string()) < size)
      m_check.fail(buffer + ": " + file.string() + " ends too early");
    m_files.push_back(file.string());
    return bytes;
  }

  // those that were read
  const std::vector<std::string>& files() const { return m_files; }

private:
  std::filesystem::path path(const std::string& uri, const std::string& buffer) const
  {
    const std::string name = decoded_uri(uri);
    const std::size_t colon = uri.find(':'); // in a name it would be escaped: this is "http:" or the like
    if (name.find('\0') != std::string::npos || (colon != std::string::npos && colon > 1))
      m_check.fail(buffer + ": " + name + " is no file beside the model");
    const std::filesystem::path file = m_folder / name;
    if (m_allowed == Linked_files::BESIDE_MODEL && !is_beside(name))
      m_check.fail(buffer + ": " + name +
                   " is not in the model's folder, and only that is read (command line: --allow-outside)");
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) m_check.fail(buffer + ": there is no file " + file.string());
    // A pipe or a device would be waited for without end.
    if (!std::filesystem::is_regular_file(status)) m_check.fail(buffer + ": " + file.string() + " is no regular file");
    return file;
  }

  // By its name, and where symbolic links lead.
  bool is_beside(const std::filesystem::path& name) const
  {
    if (name.is_absolute() || name.has_root_path() || name.string().find('\\') != std::string::npos) return false;
    for (const std::filesystem::path& part : name)
      if (part == "..") return false;
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::weakly_canonical(m_folder, error);
    const std::filesystem::path file = std::filesystem::weakly_canonical(m_folder / name, error);
    const std::filesystem::path inside = file.lexically_relative(folder);
    return !error && !inside.empty() && *inside.begin() != "..";
  }

  std::filesystem::path m_folder;
  Linked_files m_allowed;
  const Gltf_check& m_check;
  std::vector<std::string> m_files;
  std::uintmax_t m_again = 0; // bytes
};

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_GLTF_LINKED_FILES_H
