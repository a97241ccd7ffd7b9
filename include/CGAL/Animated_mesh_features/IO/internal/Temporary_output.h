// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEMPORARY_OUTPUT_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEMPORARY_OUTPUT_H

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>

#if defined(__unix__) || (defined(__APPLE__) && defined(__MACH__))
  #define CGAL_ANIMATED_MESH_FEATURES_HAS_FLOCK
  #include <fcntl.h>
  #include <sys/file.h>
  #include <sys/stat.h>
  #include <unistd.h>
#endif

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A lock on a file or folder that exists, which ends with the object, or with the process however that ends.
class Path_lock
{
public:
  Path_lock() = default;
  ~Path_lock() { release(); }
  Path_lock(const Path_lock&) = delete;
  Path_lock& operator=(const Path_lock&) = delete;

  // Takes the lock, or waits for it if `wait`. `false` if somebody else has it, or `path` is another file by then; also
  // where there are no locks, if `is_required`.
  bool take(const std::filesystem::path& path, bool wait, bool is_required)
  {
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_FLOCK
    release();
    m_file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (m_file < 0) return !is_required && errno != ENOENT;
    if (::flock(m_file, wait ? LOCK_EX : LOCK_EX | LOCK_NB) != 0) return !is_required && errno != EWOULDBLOCK;
    struct stat locked, there;
    return ::fstat(m_file, &locked) == 0 && ::lstat(path.c_str(), &there) == 0 && locked.st_dev == there.st_dev &&
           locked.st_ino == there.st_ino;
#else
    (void)path, (void)wait;
    return !is_required;
#endif
  }

  void release()
  {
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_FLOCK
    if (m_file >= 0) ::close(m_file);
    m_file = -1;
#endif
  }

private:
  int m_file = -1;
};

// Temporaries of `target` in a folder are called so, with a number in between.
inline std::string temporary_prefix(const std::filesystem::path& target)
{
  const std::size_t part_of_name = 64; // so that the temporary's name is never too long
  return "." + target.filename().string().substr(0, part_of_name) + ".";
}

inline bool is_own(const std::filesystem::path& path)
{
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_FLOCK
  struct stat s;
  return ::lstat(path.c_str(), &s) == 0 && (S_ISREG(s.st_mode) || S_ISDIR(s.st_mode)) && s.st_uid == ::geteuid();
#else
  (void)path;
  return false;
#endif
}

// Removes what earlier runs have left in `folder` that were killed while they wrote `target`: nobody locks it any more.
inline void remove_leftovers(const std::filesystem::path& folder, const std::filesystem::path& target)
{
  const std::string prefix = temporary_prefix(target), suffix = ".tmp";
  std::error_code ignored;
  for (std::filesystem::directory_iterator i(folder.empty() ? "." : folder, ignored), end; !ignored && i != end;
       i.increment(ignored)) {
    const std::string name = i->path().filename().string();
    if (name.size() <= prefix.size() + suffix.size() || name.compare(0, prefix.size(), prefix) != 0 ||
        name.compare(name.size() - suffix.size(), suffix.size(), suffix) != 0)
      continue;
    const bool is_number =
        std::all_of(name.begin() + std::ptrdiff_t(prefix.size()), name.end() - std::ptrdiff_t(suffix.size()),
                    [](char c) { return c >= '0' && c <= '9'; });
    Path_lock lock;
    std::error_code kept;
    if (is_number && is_own(i->path()) && lock.take(i->path(), false, true))
      std::filesystem::remove_all(i->path(), kept);
  }
}

// Makes a temporary of `target` in `folder` by `make`, which is given its name and returns whether it could, else sets an
// error; locked, so that other runs know that it is in use.
// returns its name, or none if there is an error that is not that there is such a file.
template <class Make>
std::filesystem::path make_temporary(const std::filesystem::path& folder, const std::filesystem::path& target,
                                     Path_lock& lock, const Make& make)
{
  std::random_device random;
  while (true) {
    const std::uint64_t number = (std::uint64_t(random()) << 32) | random();
    const std::filesystem::path path = folder / (temporary_prefix(target) + std::to_string(number) + ".tmp");
    std::error_code error;
    if (make(path, error)) {
      if (lock.take(path, false, false)) return path;
      std::filesystem::remove_all(path, error); // another run took it for a leftover, in this moment
    } else if (error != std::errc::file_exists) {
      return std::filesystem::path();
    }
  }
}

// Waits until the disk has what was written to a file; returns errno, or 0. What cannot be waited for is no error.
inline int wait_for_disk(std::FILE* file)
{
#ifdef CGAL_ANIMATED_MESH_FEATURES_HAS_FLOCK
  if (::fsync(fileno(file)) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) return errno;
#else
  (void)file;
#endif
  return 0;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_TEMPORARY_OUTPUT_H
