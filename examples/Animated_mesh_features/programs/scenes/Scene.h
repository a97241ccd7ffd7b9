// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_SCENE_H
#define PROGRAMS_SCENES_SCENE_H

#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/check_field.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

A field to be shown on the surface, under a name: "strain", "curvature", "deformation" or any other.
*/
template <class FT>
struct Scene_field
{
  std::string name;                                  ///< what it is called in files and legends
  const Spatio_temporal_field<FT>* values = nullptr; ///< `N x F`; not owned.
};

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

What is to be seen: a moving surface, its features, and fields on it. All writers of pictures and scenes take one.

It refers to what it shows, which must live as long.

\tparam Sequence_ a `Frame_sequence`
\tparam Feature_ a `Spatio_temporal_feature`
*/
template <class Sequence_, class Feature_>
struct Scene
{
  typedef Sequence_ Sequence;       ///< of the surface
  typedef Feature_ Feature;         ///< of the features
  typedef typename Sequence::FT FT; ///< of the fields

  const Sequence& sequence;             ///< the moving surface.
  const std::vector<Feature>& features; ///< strongest first.
  std::vector<Scene_field<FT>> fields;  ///< as many as there are; the most interesting one first.
  std::string title;                    ///< one line, UTF-8.

  /// the field of that name; null if there is none.
  const Spatio_temporal_field<FT>* field(const std::string& name) const
  {
    for (const Scene_field<FT>& f : fields)
      if (f.name == name) return f.values;
    return nullptr;
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

checks that the parts of a scene belong together: for writers, before they write anything.

\throw Option_error if a field has not the shape `N x F` of the sequence.
\throw Input_error if a value of a field is not finite, or a feature is on a vertex or in a frame that is not there.
*/
template <class Sequence, class Feature>
void check_scene(const Scene<Sequence, Feature>& scene)
{
  const std::size_t n = scene.sequence.number_of_vertices(), frames = scene.sequence.number_of_frames();
  for (const auto& f : scene.fields) Animated_mesh_features::internal::check_field(*f.values, n, frames);
  const auto check = [](std::size_t rank, const char* what, std::size_t i, std::size_t size) {
    if (i < size) return;
    throw Input_error("feature " + std::to_string(rank) + " has the " + what + " " + std::to_string(i) +
                      "; the animation has " + std::to_string(size));
  };
  for (std::size_t i = 0; i < scene.features.size(); ++i) {
    const Feature& f = scene.features[i];
    check(i, "vertex", f.vertex_index, n);
    for (std::size_t v : f.triangle) check(i, "vertex", v, n);
    check(i, "frame", f.frame, frames);
  }
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_SCENE_H
