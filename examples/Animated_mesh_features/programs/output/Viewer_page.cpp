// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Viewer_page.h"

#include <cstddef>

namespace Programs {

#ifdef DETECT_FEATURES_WITH_VIEWER

// From viewer_page.cpp, which the build makes.
extern const unsigned char viewer_page_bytes[];
extern const std::size_t viewer_page_size;
extern const char* const viewer_page_missing;

std::string_view viewer_page()
{
  return std::string_view(reinterpret_cast<const char*>(viewer_page_bytes), viewer_page_size);
}

std::string missing_viewer()
{
  return viewer_page_missing;
}

#else

std::string_view viewer_page()
{
  return std::string_view();
}

std::string missing_viewer()
{
  return "zlib was missing, or the viewer switched off";
}

#endif

} // namespace Programs
