// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_AVAILABLE_MEMORY_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_AVAILABLE_MEMORY_H

#ifdef __linux__
  #include <unistd.h>
#endif

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <limits>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Bytes of this process that are in memory; 0 where the system does not tell.
inline std::size_t resident_memory()
{
#ifdef __linux__
  std::ifstream statm("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  if (statm >> all >> resident) return resident * std::size_t(::sysconf(_SC_PAGESIZE));
#endif
  return 0;
}

// Bytes that a process can take without others being swapped out: what the system calls available, and what the limits
// of a container leave; the largest number where the system does not tell.
inline std::size_t available_memory()
{
  std::size_t available = (std::numeric_limits<std::size_t>::max)();
#ifdef __linux__
  std::ifstream meminfo("/proc/meminfo");
  std::string key, unit;
  for (std::size_t value; meminfo >> key >> value; std::getline(meminfo, unit))
    if (key == "MemAvailable:") available = value * 1024;
  // cgroup 2, then 1 ("max" is no number); cached files that nobody uses are given up first
  struct Names
  {
    const char *limit, *usage, *statistics, *unused_files;
  };
  const Names names[] = {{"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current", "/sys/fs/cgroup/memory.stat",
                          "inactive_file"},
                         {"/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes",
                          "/sys/fs/cgroup/memory/memory.stat", "total_inactive_file"}};
  for (const Names& n : names) {
    std::ifstream limit_file(n.limit), usage_file(n.usage), statistics(n.statistics);
    std::size_t limit = 0, usage = 0;
    if (!(limit_file >> limit && usage_file >> usage)) continue;
    for (std::size_t value; statistics >> key >> value;)
      if (key == n.unused_files) usage -= (std::min)(usage, value);
    available = (std::min)(available, limit > usage ? limit - usage : std::size_t(0));
  }
#endif
  return available;
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_MEMORY_AVAILABLE_MEMORY_H
