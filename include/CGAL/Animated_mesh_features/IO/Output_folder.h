// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FOLDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FOLDER_H

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/internal/Temporary_output.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
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

A folder that exists may hold other files; they stay, and only files of the same names are replaced. So it is, too, with a
folder that another process has made meanwhile: its files are replaced by those that come later, all of them together.
*/
class Output_folder
{
public:
  /*!
  makes the temporary folder: within the folder `name` if there is one, beside it otherwise.
  \throws Output_error if that cannot be done, or `name` is no folder.
  */
  explicit Output_folder(const std::string& name, Output_sync sync = Output_sync::BEFORE_RENAME)
    : m_name(name)
    , m_target(std::filesystem::path(name).lexically_normal())
    , m_sync(sync)
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
    if (m_sync == Output_sync::BEFORE_RENAME)
      for (const std::string& file : m_files) wait_for_disk(file);
    std::error_code error;
    if (m_is_new) {
      std::filesystem::rename(m_temporary, m_target, error);
      if (!error) {
        m_temporary.clear();
        m_lock.release();
        return;
      }
      // Another process may have made the folder meanwhile.
      if (!std::filesystem::is_directory(m_target)) fail(error);
    }
    internal::Path_lock turn; // one process after the other, so that the files of each belong together
    turn.take(m_target, true, false);
    for (const std::string& file : m_files) {
      std::filesystem::rename(m_temporary / file, m_target / file, error);
      if (error) fail(error);
    }
    discard();
  }

private:
  void make_temporary()
  {
    const std::filesystem::path place = m_is_new ? m_target.parent_path() : m_target;
    internal::remove_leftovers(m_target.parent_path(), m_target);
    if (!m_is_new) internal::remove_leftovers(m_target, m_target);
    std::error_code error;
    m_temporary =
        internal::make_temporary(place, m_target, m_lock, [&](const std::filesystem::path& path, std::error_code& e) {
          const bool is_made = std::filesystem::create_directory(path, e);
          if (!is_made && !e) e = std::make_error_code(std::errc::file_exists);
          error = e;
          return is_made;
        });
    if (m_temporary.empty()) fail(error);
  }

  void wait_for_disk(const std::string& file) const
  {
    errno = 0;
    std::FILE* const opened = std::fopen((m_temporary / file).string().c_str(), "rb");
    if (opened == nullptr) fail(std::error_code(errno, std::generic_category()));
    const int error = internal::wait_for_disk(opened);
    std::fclose(opened);
    if (error != 0) fail(std::error_code(error, std::generic_category()));
  }

  void discard() noexcept
  {
    if (m_temporary.empty()) return;
    std::error_code ignored;
    std::filesystem::remove_all(m_temporary, ignored);
    m_temporary.clear();
    m_lock.release();
  }

  [[noreturn]] void fail(const std::error_code& error) const
  {
    throw Output_error(m_name + ": cannot write: " + error.message());
  }

  std::string m_name;
  std::filesystem::path m_target;
  std::filesystem::path m_temporary; // empty if there is none
  internal::Path_lock m_lock;        // on it
  Output_sync m_sync;
  bool m_is_new = false;
  std::vector<std::string> m_files;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FOLDER_H
