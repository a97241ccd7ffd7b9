// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_RESULT_DESCRIPTION_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_RESULT_DESCRIPTION_H

#include <CGAL/Animated_mesh_features/IO/Vertex_origins.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

What a file of features says besides the features: the animation they were found on, and all that is needed to find
them again.
*/
struct Result_description
{
  /// the value of a parameter; `std::monostate` stands for "none" (JSON's `null`).
  typedef std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                       std::vector<std::string>>
      Value;

  /// \name The animation
  /// @{
  std::size_t vertices = 0;         ///< their number
  std::size_t faces = 0;            ///< their number
  std::size_t frames = 0;           ///< their number
  double frame_duration = 0;        ///< seconds
  double bounding_box_diagonal = 0; ///< length, of the rest shape
  double mean_edge_length = 0;      ///< length, of the rest shape
  Vertex_origins origins;           ///< if vertices are not those of the file
  /// @}

  /// names and values, in the order in which they are written.
  std::vector<std::pair<std::string, Value>> parameters;

  /// appends a parameter: a truth value, a number, a text (anything that converts to `std::string`), a vector of
  /// numbers or texts, or a `Value`.
  template <class T>
  void add(const std::string& name, const T& value)
  {
    // Decided here and not by the variant: to it, a text in quotes is a truth value first of all.
    if constexpr (std::is_same<T, bool>::value) {
      parameters.emplace_back(name, Value(std::in_place_type<bool>, value));
    } else if constexpr (std::is_integral<T>::value) {
      parameters.emplace_back(name, Value(std::in_place_type<std::int64_t>, static_cast<std::int64_t>(value)));
    } else if constexpr (std::is_floating_point<T>::value) {
      parameters.emplace_back(name, Value(std::in_place_type<double>, static_cast<double>(value)));
    } else if constexpr (std::is_convertible<const T&, std::string>::value) {
      parameters.emplace_back(name, Value(std::in_place_type<std::string>, std::string(value)));
    } else {
      parameters.emplace_back(name, Value(value));
    }
  }
};

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_RESULT_DESCRIPTION_H
