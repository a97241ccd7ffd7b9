// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_PROPERTY_MAP_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_PROPERTY_MAP_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

One frame of a field as a readable property map from the mesh's own descriptors to scalars. Valid as long as the
field.

\tparam FT the scalar of the field.
\tparam IndexMap readable property map from descriptor to row of the field.
*/
template <class FT, class IndexMap>
class Frame_property_map
{
public:
  typedef typename boost::property_traits<IndexMap>::key_type key_type; ///< a descriptor of the mesh
  typedef FT value_type;                                                ///< the scalar of the field
  typedef FT reference;                                                 ///< the same, by value
  typedef boost::readable_property_map_tag category;                    ///< `get()` only

  /// the map of frame `frame`, from 0. The field is kept by reference.
  Frame_property_map(const Spatio_temporal_field<FT>& field, IndexMap index, std::size_t frame)
    : m_field(&field)
    , m_index(index)
    , m_frame(frame)
  {
  }

  /// the value of `k` in the frame.
  friend reference get(const Frame_property_map& map, const key_type& k)
  {
    return (*map.m_field)(get(map.m_index, k), map.m_frame);
  }

private:
  const Spatio_temporal_field<FT>* m_field;
  IndexMap m_index;
  std::size_t m_frame;
};

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

makes the property map of one frame of a vertex field; both this and `get()` take constant time.

\param sequence the `Frame_sequence` of which the field was computed; it knows the row of each vertex.
\param field `N x F`; must outlive the map.
\param frame from 0.
*/
template <class FrameSequence, class FT>
Frame_property_map<FT, typename FrameSequence::Vertex_index_map>
frame_property_map(const FrameSequence& sequence, const Spatio_temporal_field<FT>& field, std::size_t frame)
{
  return Frame_property_map<FT, typename FrameSequence::Vertex_index_map>(field, sequence.vertex_index_map(), frame);
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_PROPERTY_MAP_H
