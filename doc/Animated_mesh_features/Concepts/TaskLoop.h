// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgAnimatedMeshFeaturesConcepts
\cgalConcept

The concept `TaskLoop` describes what policies are handed to run their work in: a loop over tasks, which knows on how many
threads to run them and whom to tell of the progress. It stands for a share of a stage.

A model is copy-constructible and cheap to copy; all functions are const.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Animated_mesh_features::Task_loop<ConcurrencyTag, Visitor>}
\cgalHasModelsEnd

\sa `DetectionVisitor`
*/
class TaskLoop
{
public:
  /*!
  calls `task(i)` for each `i` in `[0, number_of_tasks)`, in any order and possibly on several threads, and returns when
  all of them are done. The tasks must not depend on one another, nor write to the same place: that is what makes results
  independent of threads. Meanwhile the visitor is told of the progress, from none to all of the share.

  \tparam Task a function object, callable with a `std::size_t`, from several threads at a time.
  \throw CGAL::Animated_mesh_features::Cancelled if the visitor asks for it, which is to be let through; an exception of
    a task.
  */
  template <class Task>
  void operator()(std::size_t number_of_tasks, const Task& task) const;

  /// the loop that stands for the `i`-th of `n` equal parts of this share, for those who need several passes.
  TaskLoop part(std::size_t i, std::size_t n) const;

  /// tells the visitor that the whole share is done, for those who do it in parts and leave some out.
  /// \throw CGAL::Animated_mesh_features::Cancelled if the visitor asks for it.
  void finish() const;
};
