// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "running/is_terminal.h"

#ifdef _WIN32
  #include <io.h>
#else
  #include <unistd.h>
#endif

namespace Programs {

bool is_terminal(std::FILE* stream)
{
#ifdef _WIN32
  return _isatty(_fileno(stream)) != 0;
#else
  return isatty(fileno(stream)) != 0;
#endif
}

} // namespace Programs
