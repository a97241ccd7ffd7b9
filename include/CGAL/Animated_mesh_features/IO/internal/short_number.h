// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SHORT_NUMBER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SHORT_NUMBER_H

#include <locale>
#include <sstream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// A number for a sentence.
inline std::string short_number(double x)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(3);
  os << x;
  return os.str();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_SHORT_NUMBER_H
