// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_SCRATCH_FIELD_MEMORY_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_SCRATCH_FIELD_MEMORY_H

#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/available_memory.h>

#ifdef __linux__
  #include <fcntl.h>
  #include <sys/mman.h>
  #include <sys/vfs.h>
  #include <unistd.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesMemory

Fields in files of a scratch directory: a `Field_memory` for animations that are larger than the memory. Results are the
same, bit for bit.

Each field is a file without a name - nothing remains of it, however the program ends -, mapped into the address space.
When the process has more than `limit` bytes in memory, all pages of all fields are let go of; what is needed again comes
back from the system's cache or from the disk. A thread looks after that, some hundred times a second, so that the limit
can be exceeded by what is touched in between, and by what is not a field: the mesh, the geodesic balls, the factors of a
spatial filter.

Linux only.
*/
class Scratch_field_memory : public Field_memory
{
public:
  /*!
  begins to watch the memory of the process.

  \param directory on a disk, with room for the fields.
  \param limit bytes in memory above which fields are let go of.
  \throw Output_error if no file can be made there, or it is in memory itself (tmpfs).
  */
  Scratch_field_memory(std::string directory, std::size_t limit)
    : m_directory(std::move(directory))
    , m_limit(limit)
  {
#ifdef __linux__
    ::close(new_file());
    struct statfs information;
    constexpr unsigned long tmpfs = 0x01021994, ramfs = 0x858458f6; // f_type, statfs(2)
    if (::statfs(m_directory.c_str(), &information) == 0 && ((unsigned long)(information.f_type) == tmpfs ||
                                                             (unsigned long)(information.f_type) == ramfs))
      throw Output_error(m_directory + ": is kept in memory itself (tmpfs); choose a scratch directory on a disk");
    m_watch = std::thread([this] { watch(); });
#else
    throw Output_error(m_directory + ": fields on a scratch directory need Linux");
#endif
  }

  ~Scratch_field_memory() override
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_over = true;
    }
    m_wake.notify_all();
    if (m_watch.joinable()) m_watch.join();
  }

  Scratch_field_memory(const Scratch_field_memory&) = delete;
  Scratch_field_memory& operator=(const Scratch_field_memory&) = delete;

  /// makes a file of that many zero bytes, and maps it.
  /// \throw Output_error if there is no room.
  void* allocate(std::size_t bytes) override
  {
#ifdef __linux__
    const int file = new_file();
    // Now, with a message, rather than by a signal when a page finds no room.
    const int error = ::posix_fallocate(file, 0, off_t(bytes));
    void* const values = error == 0 ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
    const int mapping_error = errno;
    ::close(file);
    if (values == MAP_FAILED)
      throw Output_error(m_directory + ": cannot make a file of " + std::to_string(bytes) +
                         " bytes for a field: " + std::strerror(error != 0 ? error : mapping_error));
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_blocks.emplace_back(values, bytes);
    return values;
#else
    (void)bytes;
    throw std::bad_alloc();
#endif
  }

  /// lets go of the file.
  void deallocate(void* values, std::size_t bytes) noexcept override
  {
#ifdef __linux__
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_blocks.erase(std::remove(m_blocks.begin(), m_blocks.end(), Block(values, bytes)), m_blocks.end());
    ::munmap(values, bytes);
#else
    (void)values;
    (void)bytes;
#endif
  }

private:
  typedef std::pair<void*, std::size_t> Block;

#ifdef __linux__
  int new_file() const
  {
    int file = -1;
  #ifdef O_TMPFILE
    file = ::open(m_directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  #endif
    if (file < 0) { // a file system that knows no files without names
      std::string name = m_directory + "/.animated_mesh_features_XXXXXX";
      file = ::mkstemp(&name[0]);
      if (file >= 0) ::unlink(name.c_str());
    }
    if (file < 0) throw Output_error(m_directory + ": cannot make a scratch file: " + std::strerror(errno));
    return file;
  }

  void watch()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    while (!m_wake.wait_for(lock, std::chrono::milliseconds(4), [this] { return m_is_over; })) {
      // with a margin for what is touched until the next look
      if (internal::resident_memory() < m_limit - m_limit / 8) continue;
      for (const Block& b : m_blocks) ::madvise(b.first, b.second, MADV_DONTNEED); // of a shared mapping: nothing is lost
    }
  }
#endif

  std::string m_directory;
  std::size_t m_limit;
  std::mutex m_mutex;
  std::condition_variable m_wake;
  bool m_is_over = false;
  std::vector<Block> m_blocks;
  std::thread m_watch;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_SCRATCH_FIELD_MEMORY_H
