// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_FRAME_FILES_IN_FOLDER_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_FRAME_FILES_IN_FOLDER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/natural_order.h>
#include <CGAL/Animated_mesh_features/IO/numbered_series.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesReading

the mesh files (.obj, .off, .ply, .stl) in a folder, one for each frame of an animation, as a `numbered_series()`.

If there are several kinds, those of the most common ending are the frames: next to them may lie a rest shape in
another format, say. These, and a template or a copy among the frames, are the `others` of the series. Hidden files (a
dot at the start of the name), other files and subfolders are ignored.

\throws Input_error if the folder cannot be read, has no mesh files, two endings are equally common, or the frames are
no series.
*/
inline Numbered_series frame_files_in_folder(const std::string& folder)
{
  std::map<std::string, std::vector<std::string>> files; // of each ending
  std::error_code error;
  std::filesystem::directory_iterator i(folder, error);
  for (const std::filesystem::directory_iterator end; !error && i != end; i.increment(error)) {
    const std::string name = i->path().filename().string();
    std::error_code ignored; // a link to nowhere is no file
    if (name[0] != '.' && is_mesh(file_format_by_ending(name)) && i->is_regular_file(ignored))
      files[file_ending(name)].push_back(i->path().string());
  }
  if (error) throw Input_error(folder + ": cannot read the folder: " + error.message());
  if (files.empty()) throw Input_error(folder + ": the folder has no mesh files (.obj, .off, .ply, .stl)");

  const auto fewer = [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); };
  const auto most = std::max_element(files.begin(), files.end(), fewer);
  for (auto other = files.begin(); other != files.end(); ++other)
    if (other != most && other->second.size() == most->second.size())
      throw Input_error(folder + ": the folder has as many " + most->first + " as " + other->first +
                        " files; which ones are the frames?");
  if (most->second.size() == 1) return {most->second, {}, {}};
  Numbered_series series = numbered_series(most->second, true);
  for (const auto& other : files)
    if (other.first != most->first) series.others.insert(series.others.end(), other.second.begin(), other.second.end());
  std::sort(series.others.begin(), series.others.end(),
            [](const auto& a, const auto& b) { return natural_order(a, b); });
  return series;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_FRAME_FILES_IN_FOLDER_H
