// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PICTURES_PICTURE_OPTIONS_H
#define PROGRAMS_PICTURES_PICTURE_OPTIONS_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

What a picture of a scene shows, and from where.
*/
struct Picture_options
{
  /// pixels; each from `smallest_side` to `largest_side`, and `most_pixels` in all.
  std::size_t width = 1600;
  std::size_t height = 1000; ///< pixels, as `width`

  /// the frames, from 0, each in a panel of its own. None: those of the strongest features, at most 6, chosen apart in
  /// time.
  std::vector<std::size_t> frames;

  /// the axis that points up: 0, 1, 2 for x, y, z. None: y or z, on which the body stands.
  std::optional<int> up_axis;

  /// where the camera is, in degrees around the up axis, counterclockwise seen from above, from +z if y points up, from
  /// +x if z does, from +y if x does. None: beside the thinnest direction of the body, on the side that shows more of
  /// the features.
  std::optional<double> azimuth;

  /// degrees above the horizon.
  double elevation = 10;

  /// sRGB, 8 bits a channel.
  std::array<std::uint8_t, 3> background = {{255, 255, 255}};

  /// \name Limits
  /// @{
  static constexpr std::size_t smallest_side = 64;                 ///< of width and height (pixels)
  static constexpr std::size_t largest_side = 16384;               ///< of width and height (pixels)
  static constexpr std::size_t most_pixels = std::size_t(1) << 25; ///< which take some 150 bytes each
  static constexpr std::size_t most_frames = 100;                  ///< panels
  static constexpr std::size_t smallest_panel = 48 * 48;           ///< pixels for a panel
  /// @}
};

/// \ingroup PkgAnimatedMeshFeaturesWriting
/// checks what can be known before there is a scene.
/// \throw Option_error if an option has a value that makes no sense for any scene.
inline void check_picture_options(const Picture_options& options)
{
  const auto check_side = [](std::size_t pixels) {
    if (pixels < Picture_options::smallest_side || pixels > Picture_options::largest_side)
      throw Option_error("a picture cannot be " + std::to_string(pixels) + " pixels wide or high, only " +
                         std::to_string(Picture_options::smallest_side) + " to " +
                         std::to_string(Picture_options::largest_side));
  };
  check_side(options.width);
  check_side(options.height);
  if (options.width * options.height > Picture_options::most_pixels)
    throw Option_error("a picture of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                       " pixels is too large; at most " + std::to_string(Picture_options::most_pixels) +
                       " pixels are possible");
  if (options.up_axis && (*options.up_axis < 0 || *options.up_axis > 2))
    throw Option_error("there is no axis " + std::to_string(*options.up_axis) + " that could point up");
  if (!(std::abs(options.elevation) < 90) || (options.azimuth && !std::isfinite(*options.azimuth)))
    throw Option_error(
        "the elevation of a picture's view must be more than -90 and less than 90 degrees, and its azimuth "
        "finite");
}

/// \ingroup PkgAnimatedMeshFeaturesWriting
/// checks what can be known when the number of frames is.
/// \throw Option_error if a frame to be shown is not there, or there are too many of them for the picture.
inline void check_picture_frames(const Picture_options& options, std::size_t number_of_frames)
{
  if (options.frames.size() > Picture_options::most_frames)
    throw Option_error("a picture cannot show " + std::to_string(options.frames.size()) + " frames; at most " +
                       std::to_string(Picture_options::most_frames));
  if (options.width * options.height < options.frames.size() * Picture_options::smallest_panel)
    throw Option_error("a picture of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                       " pixels is too small for " + std::to_string(options.frames.size()) + " frames");
  for (std::size_t f : options.frames)
    if (f >= number_of_frames)
      throw Option_error("there is no frame " + std::to_string(f) + " to be shown; frames are 0 to " +
                         std::to_string(number_of_frames - 1));
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PICTURES_PICTURE_OPTIONS_H
