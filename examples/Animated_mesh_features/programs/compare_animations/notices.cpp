// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/notices.h"

#include "running/counted.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>

namespace Compare_animations {

std::string notice_of_kinds(const std::vector<Item>& items)
{
  const auto is_file = [](const Item& i) { return !i.feature_file.empty(); };
  const std::size_t files = std::size_t(std::count_if(items.begin(), items.end(), is_file));
  if (files == 0 || files == items.size()) return std::string();
  return Programs::counted(files, "file of features is", "files of features are") +
         " compared with animations, of which more is known: such distances are larger than those of two of a kind\n";
}

std::string notice_of_clocks(const CGAL::Animated_mesh_features::Animation_signature& a,
                             const CGAL::Animated_mesh_features::Animation_signature& b)
{
  if (a.frames != b.frames || std::abs(std::log(a.frame_duration / b.frame_duration)) < 0.01) return std::string();
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << std::setprecision(4) << "both have " << a.frames << " frames, A " << 1 / a.frame_duration << " and B "
     << 1 / b.frame_duration
     << " in a second: if they are takes of the same length, one rate was told wrongly (--fps)\n";
  return os.str();
}

} // namespace Compare_animations
