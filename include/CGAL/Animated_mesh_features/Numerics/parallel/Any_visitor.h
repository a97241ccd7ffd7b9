// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_ANY_VISITOR_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_ANY_VISITOR_H

#include <CGAL/Animated_mesh_features/Numerics/parallel/Default_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>

#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesTasks

A reference to a visitor of whatever type: what a detection is compiled for, so that it is compiled once for all visitors.
It is told of something some hundred times in a detection, which costs nothing.

\cgalModels{DetectionVisitor}
*/
class Any_visitor
{
  template <class Visitor>
  using If_other = std::enable_if_t<!std::is_base_of<Any_visitor, Visitor>::value>;

public:
  /// refers to a `Default_visitor`.
  Any_visitor()
    : Any_visitor(nobody())
  {}

  /// refers to a model of `DetectionVisitor`, which has to live as long.
  template <class Visitor, class = If_other<Visitor>>
  Any_visitor(Visitor& visitor)
    : m_visitor(const_cast<void*>(static_cast<const void*>(&visitor)))
    , m_begin([](void* v, Stage stage) { static_cast<Visitor*>(v)->begin(stage); })
    , m_progress([](void* v, Stage stage, double fraction) -> bool {
      return static_cast<Visitor*>(v)->progress(stage, fraction);
    })
    , m_end([](void* v, Stage stage) { static_cast<Visitor*>(v)->end(stage); })
  {}

  /// tells the visitor that a stage begins.
  void begin(Stage stage) { m_begin(m_visitor, stage); }

  /// tells the visitor how far a stage is.
  /// \returns whether to go on.
  bool progress(Stage stage, double fraction) { return m_progress(m_visitor, stage, fraction); }

  /// tells the visitor that a stage ends.
  void end(Stage stage) { m_end(m_visitor, stage); }

private:
  static Default_visitor& nobody()
  {
    static Default_visitor visitor;
    return visitor;
  }

  void* m_visitor;
  void (*m_begin)(void*, Stage);
  bool (*m_progress)(void*, Stage, double);
  void (*m_end)(void*, Stage);
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_ANY_VISITOR_H
