// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_STAGE_SCOPE_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_STAGE_SCOPE_H

#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage.h>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

// begin() and end() of a stage around a scope.
class Stage_scope
{
public:
  Stage_scope(const Any_visitor& visitor, Stage stage) : m_visitor(visitor), m_stage(stage) { m_visitor.begin(stage); }
  ~Stage_scope() { m_visitor.end(m_stage); }
  Stage_scope(const Stage_scope&) = delete;
  Stage_scope& operator=(const Stage_scope&) = delete;

private:
  Any_visitor m_visitor;
  Stage m_stage;
};

} // namespace internal

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_PARALLEL_STAGE_SCOPE_H
