// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_THREAD_LOCAL_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_THREAD_LOCAL_H

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/enumerable_thread_specific.h>
#endif

#include <memory>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// A workspace for each thread that asks for one, made at its first request.
template <class T>
class Thread_local
{
#ifdef CGAL_LINKED_WITH_TBB
public:
  template <class Make>
  T& get(const Make& make)
  {
    std::unique_ptr<T>& p = m_workspaces.local();
    if (!p) p = make();
    return *p;
  }

private:
  tbb::enumerable_thread_specific<std::unique_ptr<T>> m_workspaces;
#else
public:
  template <class Make>
  T& get(const Make& make)
  {
    if (!m_workspace) m_workspace = make();
    return *m_workspace;
  }

private:
  std::unique_ptr<T> m_workspace;
#endif
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_THREAD_LOCAL_H
