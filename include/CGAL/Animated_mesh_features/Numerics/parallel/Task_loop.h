// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_TASK_LOOP_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_TASK_LOOP_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesTasks

The loop in which policies run their tasks: a share of a stage, which knows on how many threads to run them and whom to
tell. Between its own tasks the calling thread - no other - tells the visitor how far the stage is, some 30 times a share and
at least every tenth of a second, so that a visitor that cancels does not wait for longer than for a task; long tasks of the
package ask in between.

Whoever calls a policy without a detector gives it one of these:
\code
Default_visitor visitor;
const Task_loop<CGAL::Parallel_if_available_tag, Default_visitor> loop(visitor, Stage::GEODESIC_BALLS);
const Compressed_rows balls = Dijkstra_geodesic_balls()(animation.rest_shape(), radius, loop);
\endcode

\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag`, `CGAL::Parallel_tag` or `CGAL::Sequential_tag`.
\tparam Visitor a model of `DetectionVisitor`.

\cgalModels{TaskLoop}
*/
template <class ConcurrencyTag, class Visitor>
class Task_loop
{
public:
  /// stands for a share of a stage.
  /// \param visitor a model of `DetectionVisitor`; is kept by reference.
  /// \param stage of which the visitor is told.
  /// \param from, to the fractions of the stage at which the share begins and ends.
  explicit Task_loop(Visitor& visitor, Stage stage, double from = 0, double to = 1)
    : m_visitor(&visitor)
    , m_stage(stage)
    , m_from(from)
    , m_to(to)
  {
  }

  /// calls `task(i)` for each `i` in `[0, number_of_tasks)`, in any order and, with `CGAL::Parallel_tag` and oneTBB, on
  /// several threads; returns when all of them are done. Tasks must not depend on one another.
  /// \throw Cancelled if the visitor has had enough; the tasks that have not begun are then left out. What a task throws.
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
    typedef std::chrono::steady_clock Clock;
    constexpr std::chrono::milliseconds longest_silence(100);
    std::size_t told = 0; // the caller's
    Clock::time_point told_at = Clock::now();
    const auto tell_now = [&] {
      told = done.load(std::memory_order_relaxed);
      told_at = Clock::now();
      if (!m_visitor->progress(m_stage, at(double(told) / double(number_of_tasks))))
        is_cancelled.store(true, std::memory_order_relaxed);
    };
    // asked by long tasks in their middle, on any thread
    const auto goes_on = [&] {
      if (std::this_thread::get_id() == caller && Clock::now() >= told_at + longest_silence) tell_now();
      return !is_cancelled.load(std::memory_order_relaxed);
    };
    parallel_for<ConcurrencyTag>(0, number_of_tasks, [&](std::size_t i) {
      if (is_cancelled.load(std::memory_order_relaxed)) return;
      {
        const internal::Cancellation_scope scope(goes_on);
        task(i);
      }
      const std::size_t now = done.fetch_add(1, std::memory_order_relaxed) + 1;
      if (std::this_thread::get_id() != caller || now == number_of_tasks) return;
      if (now >= told + portion || Clock::now() >= told_at + longest_silence) tell_now();
    });
    if (is_cancelled) throw Cancelled();
    tell(1);
  }

  /// tells that the whole share is done, for those who do it in parts and leave some out.
  void finish() const { tell(1); }

  /// the loop for the `i`-th of `n` equal parts of this share.
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

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_TASK_LOOP_H
