// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_CANCELLATION_SCOPE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_CANCELLATION_SCOPE_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// How a task that takes long finds out, in its middle, that it is not wanted any more: whoever runs it opens a scope on the
// same thread with something to ask, and the task calls cancellation_point() here and there. So what computes - a
// factorisation, say - is not handed a visitor through all of its functions, and costs nothing more where there is no scope.
class Cancellation_scope
{
public:
  // `ask()` returns whether to go on; is kept by reference.
  template <class Ask>
  explicit Cancellation_scope(const Ask& ask)
    : m_ask(&ask)
    , m_call([](const void* a) -> bool { return (*static_cast<const Ask*>(a))(); })
    , m_around(innermost())
  {
    innermost() = this;
  }

  ~Cancellation_scope() { innermost() = m_around; }
  Cancellation_scope(const Cancellation_scope&) = delete;
  Cancellation_scope& operator=(const Cancellation_scope&) = delete;

  bool goes_on() const { return m_call(m_ask); }

  // of this thread; none: null
  static Cancellation_scope*& innermost()
  {
    static thread_local Cancellation_scope* scope = nullptr;
    return scope;
  }

private:
  const void* m_ask;
  bool (*m_call)(const void*);
  Cancellation_scope* m_around;
};

// To be called at least every tenth of a second or so, and not much more often than every microsecond.
// throws Cancelled if the task need not be finished.
inline void cancellation_point()
{
  const Cancellation_scope* const scope = Cancellation_scope::innermost();
  if (scope != nullptr && !scope->goes_on()) throw Cancelled();
}

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_CANCELLATION_SCOPE_H
