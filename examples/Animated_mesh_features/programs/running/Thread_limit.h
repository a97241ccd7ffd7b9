// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_RUNNING_THREAD_LIMIT_H
#define PROGRAMS_RUNNING_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/global_control.h>
#endif

#include <cstddef>
#include <optional>

namespace Programs {

// As many threads as that at most, as long as it lives; 0: all.
class Thread_limit
{
public:
  explicit Thread_limit(std::size_t threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if (threads > 0) m_limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
#else
    (void)threads;
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_limit;
#endif
};

} // namespace Programs

#endif // PROGRAMS_RUNNING_THREAD_LIMIT_H
