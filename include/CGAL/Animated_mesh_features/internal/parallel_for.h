// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_PARALLEL_FOR_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_PARALLEL_FOR_H

#include <CGAL/Animated_mesh_features/Visitor.h>
#include <CGAL/Animated_mesh_features/exceptions.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
  #include <tbb/blocked_range.h>
  #include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// task(i) for each i in [first, last), in any order and, with Parallel_tag and TBB, on several threads. Tasks must not
// depend on one another; whatever they write is theirs alone, which is what makes results independent of threads.
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

// A share of a stage: knows how to run tasks and whom to tell. Between its own tasks the calling thread - no other -
// tells the visitor how far the stage is. If the visitor has had enough, the tasks that have not begun are left out, and
// Cancelled is thrown.
template <class ConcurrencyTag, class Visitor>
class Task_loop
{
public:
  Task_loop(Visitor& visitor, Stage stage, double from = 0, double to = 1)
    : m_visitor(&visitor)
    , m_stage(stage)
    , m_from(from)
    , m_to(to)
  {
  }

  template <class Task>
  void operator()(std::size_t number_of_tasks, const Task& task) const
  {
    tell(0);
    // Often enough for a bar that moves, seldom enough to cost nothing. The tasks are never divided into portions that
    // wait for one another: at the end of each, all threads but one would be idle.
    constexpr std::size_t times = 32;
    const std::size_t portion = (std::max)(std::size_t(1), number_of_tasks / times);
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::size_t> done(0);
    std::atomic<bool> is_cancelled(false);
    std::size_t told = 0; // the caller's
    parallel_for<ConcurrencyTag>(0, number_of_tasks, [&](std::size_t i) {
      if (is_cancelled.load(std::memory_order_relaxed)) return;
      task(i);
      const std::size_t now = done.fetch_add(1, std::memory_order_relaxed) + 1;
      if (std::this_thread::get_id() != caller || now < told + portion || now == number_of_tasks) return;
      told = now;
      if (!m_visitor->progress(m_stage, at(double(now) / double(number_of_tasks))))
        is_cancelled.store(true, std::memory_order_relaxed);
    });
    if (is_cancelled) throw Cancelled();
    tell(1);
  }

  // Tells that the whole share is done, for those who do it in parts and leave some out.
  void finish() const { tell(1); }

  // The loop for the i-th of n equal parts of this share.
  Task_loop part(std::size_t i, std::size_t n) const
  {
    return Task_loop(*m_visitor, m_stage, at(double(i) / double(n)), at(double(i + 1) / double(n)));
  }

private:
  void tell(double fraction) const
  {
    if (!m_visitor->progress(m_stage, at(fraction))) throw Cancelled();
  }

  // Exact at both ends: where one part ends the next begins, or the visitor might be told that a bit of work is undone.
  double at(double fraction) const { return (1 - fraction) * m_from + fraction * m_to; }

  Visitor* m_visitor;
  Stage m_stage;
  double m_from, m_to;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_PARALLEL_FOR_H
