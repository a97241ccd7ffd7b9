// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/read_model.h"

#include "reading/Model_file.h"

#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  #include <CGAL/Animated_mesh_features/IO/read_gltf.h>
#endif
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

namespace AMF = CGAL::Animated_mesh_features;

namespace Simplify_animation {

void check_is_model(const Programs::Reading_options& o, const std::string& option)
{
  if (Programs::model_format(o.inputs) != Programs::Model_format::GLTF)
    throw AMF::Option_error(option + ": the input is no animated model in glTF");
}

AMF::IO::Keyframed_model read_model(const Programs::Reading_options& o)
{
#ifdef ANIMATED_MESH_FEATURES_WITH_GLTF
  return AMF::IO::read_gltf(o.inputs.front(),
                            o.allow_outside ? AMF::IO::Linked_files::ANYWHERE : AMF::IO::Linked_files::BESIDE_MODEL);
#else
  throw AMF::Option_error("this program was built without what reads glTF");
#endif
}

} // namespace Simplify_animation
