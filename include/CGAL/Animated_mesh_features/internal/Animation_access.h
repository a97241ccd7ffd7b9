// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_INTERNAL_ANIMATION_ACCESS_H
#define CGAL_ANIMATED_MESH_FEATURES_INTERNAL_ANIMATION_ACCESS_H

#include <CGAL/Animated_mesh_features/Frame_sequence.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace internal {

// Any model of MeshAnimation as a Frame_sequence: the model's points are read once, through its point maps.
template <class Animation>
class Animation_access
{
public:
  typedef Frame_sequence<typename Animation::Triangle_mesh, typename Animation::FT> Sequence;

  explicit Animation_access(const Animation& animation)
  {
    std::vector<decltype(animation.point_map(0))> maps;
    for (std::size_t f = 0; f < animation.number_of_frames(); ++f) maps.push_back(animation.point_map(f));
    m_sequence = std::make_shared<Sequence>(animation.triangle_mesh(), maps, animation.frame_duration());
    // the model vouches for the unit of its rest shape
    m_sequence->set_rest_shape(animation.rest_point_map(), Rest_unit::KEEP);
  }

  const Sequence& operator*() const { return *m_sequence; }
  const Sequence* operator->() const { return m_sequence.get(); }

private:
  std::shared_ptr<Sequence> m_sequence;
};

// A Frame_sequence is used as it is.
template <class TriangleMesh, class FT>
class Animation_access<Frame_sequence<TriangleMesh, FT>>
{
public:
  typedef Frame_sequence<TriangleMesh, FT> Sequence;
  explicit Animation_access(const Sequence& sequence) : m_sequence(&sequence) {}
  const Sequence& operator*() const { return *m_sequence; }
  const Sequence* operator->() const { return m_sequence; }

private:
  const Sequence* m_sequence;
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_INTERNAL_ANIMATION_ACCESS_H
