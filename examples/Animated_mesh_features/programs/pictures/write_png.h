// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_WRITE_PNG_H
#define PROGRAMS_PICTURES_WRITE_PNG_H

#include "pictures/Picture_options.h"
#include "scenes/Scene.h"
#include "pictures/Png_encoder.h"
#include "pictures/picture_of_scene.h"

#include <ostream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a picture of a scene, see `picture_of_scene()`, as PNG: 8 bits a channel, sRGB. Needs zlib.

\param os a binary stream; errors are left in its state, `Output_file` reports them
\param scene,options what is shown, and how

\throws Option_error as `picture_of_scene()`
\throws Input_error as `picture_of_scene()`
*/
template <class Sequence, class Feature>
void write_png(std::ostream& os, const Scene<Sequence, Feature>& scene,
               const Picture_options& options = Picture_options())
{
  const std::string png = internal::encoded_png(picture_of_scene(scene, options));
  os.write(png.data(), std::streamsize(png.size()));
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PICTURES_WRITE_PNG_H
