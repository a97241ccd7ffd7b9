// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FOLDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FOLDER_H

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

A folder of files that belong together, with the care of `Output_file`: everything goes to a temporary folder, on the same
disk, and takes its place only in `commit()`. If the object dies before, the temporary is removed and what stood under
the name is untouched.

A folder that exists may hold other files; they stay, and only files of the same names are replaced.
*/
class Output_folder
{
public:
  /*!
  makes the temporary folder: within the folder `name` if there is one, beside it otherwise.
  \throws Output_error if that cannot be done, or `name` is no folder.
  */
  explicit Output_folder(const std::string& name)
    : m_name(name)
    , m_target(std::filesystem::path(name).lexically_normal())
  {
    if (!m_target.has_filename() && m_target.has_parent_path()) m_target = m_target.parent_path(); // "name/"
    std::error_code ignored;
    const bool exists = std::filesystem::exists(std::filesystem::symlink_status(m_target, ignored));
    if (exists && !std::filesystem::is_directory(std::filesystem::status(m_target, ignored)))
      fail(std::make_error_code(std::errc::not_a_directory));
    m_is_new = !exists;
    make_temporary();
  }

  Output_folder(const Output_folder&) = delete;
  Output_folder& operator=(const Output_folder&) = delete;

  /// drops what was written, unless `commit()` was called.
  ~Output_folder() { discard(); }

  /// the name for messages.
  const std::string& name() const { return m_name; }

  /// writes one file; `write` is given its stream.
  /// \throws Output_error if any byte could not be written.
  template <class Write>
  void write(const std::string& file, const Write& write)
  {
    Output_file output((m_temporary / file).string(), (m_target / file).string());
    write(output.stream());
    output.commit();
    m_files.push_back(file);
  }

  /*!
  puts the folder in its place, or its files in theirs, in the order in which they were written: what refers to others
  is to be written last.
  \throws Output_error if that cannot be done; of a folder that exists, some files may be replaced by then.
  */
  void commit()
  {
    std::error_code error;
    if (m_is_new) {
      std::filesystem::rename(m_temporary, m_target, error);
      if (error) fail(error);
      m_temporary.clear();
      return;
    }
    for (const std::string& file : m_files) {
      std::filesystem::rename(m_temporary / file, m_target / file, error);
      if (error) fail(error);
    }
    discard();
  }

private:
  void make_temporary()
  {
    const std::size_t part_of_name = 64; // so that the temporary's name is never too long
    const std::filesystem::path place = m_is_new ? m_target.parent_path() : m_target;
    const std::string name = m_target.filename().string().substr(0, part_of_name);
    std::random_device random;
    std::error_code error;
    do {
      const std::uint64_t number = (std::uint64_t(random()) << 32) | random();
      m_temporary = place / ("." + name + "." + std::to_string(number) + ".tmp");
    } while (!std::filesystem::create_directory(m_temporary, error) && !error);
    if (!error) return;
    m_temporary.clear();
    fail(error);
  }

  void discard() noexcept
  {
    if (m_temporary.empty()) return;
    std::error_code ignored;
    std::filesystem::remove_all(m_temporary, ignored);
    m_temporary.clear();
  }

  [[noreturn]] void fail(const std::error_code& error) const
  {
    throw Output_error(m_name + ": cannot write: " + error.message());
  }

  std::string m_name;
  std::filesystem::path m_target;
  std::filesystem::path m_temporary; // empty if there is none
  bool m_is_new = false;
  std::vector<std::string> m_files;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FOLDER_H
