// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FILE_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FILE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/internal/File_buffer.h>
#include <CGAL/Animated_mesh_features/IO/internal/Temporary_output.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

Whether an output waits for the disk before it takes its place.
*/
enum class Output_sync
{
  BEFORE_RENAME, ///< after a power failure, the old file or the new one is there, and complete: the default
  NEVER          ///< the system writes when it likes; saves some milliseconds a file, seconds on slow or busy disks
};

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

A file that is either written completely or not at all.

Everything goes to a temporary file in the same folder, which takes the place of the file only in `commit()`. If the
object dies before, because of an exception for instance, the temporary is removed and what stood under the name is
untouched. If the process is killed, the next `Output_file` of the same name removes the temporary, but none that another
process is still writing (on systems with `flock()`).

- An existing file keeps its permissions; a new one gets those that the umask leaves. Other hard links to an existing
  file keep the old contents.
- A symbolic link stays one: its target is written.
- Pipes, devices and whatever is named in `/dev` or `/proc` are opened and written directly, never replaced.
- `-` is the standard output, and so are `/dev/stdout` and its synonyms.

Errors while writing (a full disk, say) put the stream in a failed state, as with any stream; `check()` and `commit()`
turn them into exceptions.

\code
IO::Output_file file("features.json");
IO::write_json(file.stream(), features, description);
file.commit();
\endcode
*/
class Output_file
{
public:
  /*!
  opens `name` for writing, in binary mode.
  \throws Output_error if it cannot be opened, is a folder, or exists and is not writable.
  */
  explicit Output_file(const std::string& name, Output_sync sync = Output_sync::BEFORE_RENAME)
    : Output_file(name, name, sync, true)
  {
  }

  /// a file of an `Output_folder`, which cares for leftovers and the disk; messages name the place to which it will come.
  Output_file(const std::string& name, const std::string& name_in_messages)
    : Output_file(name, name_in_messages, Output_sync::NEVER, false)
  {}

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  /// drops what was written, unless `commit()` was called. What went to a pipe or device cannot be taken back.
  ~Output_file() { discard(); }

  /// where to write.
  std::ostream& stream() { return m_stream; }

  /// the name for messages.
  const std::string& name() const { return m_name; }

  /// tells whether writing has failed so far; for stopping early in a long output.
  /// \throws Output_error if it has.
  void check() const
  {
    if (m_buffer.error() != 0) fail(m_buffer.error());
    if (!m_stream) fail(EIO);
  }

  /*!
  completes the file and puts it in its place. Nothing can be written afterwards.
  \throws Output_error if any byte could not be written or the file cannot be renamed; the old file is then untouched.
  */
  void commit()
  {
    if (m_file == nullptr) fail(EBADF);
    m_stream.flush();
    check();
    if (m_file != stdout) {
      std::FILE* const file = m_file;
      m_file = nullptr;
      m_buffer.set_file(nullptr);
      const bool waits = !m_temporary.empty() && m_sync == Output_sync::BEFORE_RENAME;
      const int sync_error = waits ? internal::wait_for_disk(file) : 0;
      errno = 0;
      if (std::fclose(file) != 0) fail(errno != 0 ? errno : EIO);
      if (sync_error != 0) fail(sync_error);
    }
    if (!m_temporary.empty()) {
      std::error_code error;
      std::filesystem::rename(m_temporary, m_target, error);
      if (error) fail(error);
      m_temporary.clear();
      m_lock.release();
    }
    m_file = nullptr;
    m_buffer.set_file(nullptr);
  }

private:
  Output_file(const std::string& name, const std::string& name_in_messages, Output_sync sync, bool removes_leftovers)
    : m_name(name_in_messages)
    , m_sync(sync)
    , m_stream(&m_buffer)
  {
    if (is_standard_output(name)) {
      m_name = "standard output";
      use(stdout);
      return;
    }
    m_target = resolved(name);
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(m_target, ignored);
    if (std::filesystem::is_directory(status)) fail(EISDIR);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
      open_directly("wb");
    } else if (is_inside(m_target, "/dev") || is_inside(m_target, "/proc")) {
      open_directly("ab"); // a file that somebody else has opened, as /dev/fd/3 may be: truncating it is not ours
    } else {
      if (removes_leftovers) internal::remove_leftovers(m_target.parent_path(), m_target);
      open_temporary(status);
    }
  }

  static bool is_standard_output(const std::string& name)
  {
    return name == "-" || name == "/dev/stdout" || name == "/dev/fd/1" || name == "/proc/self/fd/1";
  }

  static bool is_inside(const std::filesystem::path& path, const char* folder)
  {
    const std::string text = path.lexically_normal().string();
    const std::string prefix = std::string(folder) + "/";
    return text.compare(0, prefix.size(), prefix) == 0;
  }

  // Follows symbolic links, also a dangling one, but not those in /dev and /proc, which stand for open files.
  std::filesystem::path resolved(const std::filesystem::path& name) const
  {
    const int longest_chain = 40; // as in Linux
    std::filesystem::path path = name;
    std::error_code ignored;
    for (int i = 0; i < longest_chain; ++i) {
      if (is_inside(path, "/dev") || is_inside(path, "/proc")) return path;
      if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored))) return path;
      path = path.parent_path() / std::filesystem::read_symlink(path, ignored); // an absolute target replaces all
    }
    fail(ELOOP);
  }

  void open_directly(const char* mode)
  {
    errno = 0;
    std::FILE* const file = std::fopen(m_target.string().c_str(), mode);
    if (file == nullptr) fail(errno);
    use(file);
  }

  void open_temporary(const std::filesystem::file_status& status)
  {
    const bool exists = std::filesystem::exists(status);
    if (exists) {
      // Renaming asks for permission to write to the folder only; a file protected against writing shall stay.
      errno = 0;
      std::FILE* const probe = std::fopen(m_target.string().c_str(), "r+b");
      if (probe == nullptr) fail(errno);
      std::fclose(probe);
    }
    std::FILE* file = nullptr;
    int reason = 0;
    m_temporary = internal::make_temporary(m_target.parent_path(), m_target, m_lock,
                                           [&](const std::filesystem::path& path, std::error_code& error) {
                                             if (file != nullptr) std::fclose(file);
                                             errno = 0;
                                             file = std::fopen(path.string().c_str(), "wbx");
                                             reason = errno;
                                             error = std::error_code(reason, std::generic_category());
                                             return file != nullptr;
                                           });
    if (file == nullptr) fail(reason);
    use(file);
    if (exists) {
      std::error_code error;
      std::filesystem::permissions(m_temporary, status.permissions(), error);
      if (error) {
        discard();
        fail(error);
      }
    }
  }

  void use(std::FILE* file)
  {
    m_file = file;
    m_buffer.set_file(file);
  }

  void discard() noexcept
  {
    m_buffer.set_file(nullptr);
    if (m_file != nullptr && m_file != stdout) std::fclose(m_file);
    m_file = nullptr;
    if (!m_temporary.empty()) {
      std::error_code ignored;
      std::filesystem::remove(m_temporary, ignored);
      m_temporary.clear();
    }
  }

  [[noreturn]] void fail(int error) const { fail(std::error_code(error, std::generic_category())); }

  [[noreturn]] void fail(const std::error_code& error) const
  {
    throw Output_error(m_name + ": cannot write: " + error.message());
  }

  std::string m_name;
  std::filesystem::path m_target;
  std::filesystem::path m_temporary; // empty if there is none
  internal::Path_lock m_lock;        // on it
  Output_sync m_sync;
  std::FILE* m_file = nullptr;
  internal::File_buffer m_buffer;
  std::ostream m_stream;
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_OUTPUT_FILE_H
