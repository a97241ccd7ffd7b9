// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_PARALLEL_FOR_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_PARALLEL_FOR_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/blocked_range.h>
  #include <tbb/parallel_for.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesTasks

calls `task(i)` for each `i` in `[first, last)`, in any order and, with `CGAL::Parallel_tag` and oneTBB, on several threads.
Tasks must not depend on one another; whatever they write is theirs alone, which is what makes results independent of
threads.

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag`, `CGAL::Parallel_tag` or `CGAL::Sequential_tag`.
*/
template <class ConcurrencyTag, class Task>
void parallel_for(std::size_t first, std::size_t last, const Task& task)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last), [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) task(i);
    });
    return;
  }
#endif
  for (std::size_t i = first; i != last; ++i) task(i);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_PARALLEL_FOR_H
