// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/clip_outputs.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <set>
#include <system_error>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

const std::string place_of_clip = "{clip}";

bool is_folder(const std::string& path)
{
  std::error_code ignored;
  return !path.empty() && (path.back() == '/' || std::filesystem::is_directory(path, ignored));
}

// `use(path, ending of files in a folder)` for each output
template <class Options, class Use>
void for_each_path(Options& o, const Use& use)
{
  for (auto& f : o.features) use(f.path, "." + name(f.kind));
  for (auto& f : o.fields) use(f.path, "." + name(f.kind) + ".npy");
  for (auto& s : o.scenes) switch (s.kind) {
    case Scene_format::VTK:
      use(s.path, "");
      break;
    case Scene_format::PLOT:
      use(s.path, ".svg");
      break;
    case Scene_format::VIEWS:
      use(s.path, ".views.json");
      break;
    case Scene_format::VIEW_MAP:
      use(s.path, ".views.svg");
      break;
    case Scene_format::HTML:
    case Scene_format::GLB:
    case Scene_format::PNG:
      use(s.path, "." + name(s.kind));
      break;
    }
  if (!o.vertex_map.empty()) use(o.vertex_map, ".vertices.csv");
}

std::string safe_name(const std::string& clip)
{
  const std::size_t longest = 100; // bytes: endings are added, and 255 are usual
  const std::string refused = "/\\:*?\"<>|{}";
  std::string name;
  for (const char c : clip) {
    const unsigned char u = static_cast<unsigned char>(c);
    name += u < 32 || u == 127 || refused.find(c) != std::string::npos ? '_' : c;
  }
  if (name.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end; // within a letter of UTF-8
    name.resize(end);
  }
  while (!name.empty() && (name.back() == ' ' || name.back() == '.')) name.back() = '_';
  if (!name.empty() && (name[0] == '.' || name[0] == '-' || name[0] == ' ')) name[0] = '_';
  return name;
}

} // namespace

std::vector<std::string> clip_file_names(const std::vector<std::string>& clips)
{
  std::set<std::string> taken; // in small letters
  const auto take = [&](std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return taken.insert(name).second;
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const std::string number = std::to_string(i), name = safe_name(clips[i]);
    std::string unique = name.empty() ? "clip_" + number : name;
    while (!take(unique)) unique += "_" + number;
    names.push_back(unique);
  }
  return names;
}

void check_clip_outputs(const Output_options& options)
{
  for_each_path(options, [](const std::string& path, const std::string& ending) {
    if (path == "-")
      throw AMF::Option_error("--clip all: the results of several clips cannot all go to the standard output");
    if (path.find(place_of_clip) == std::string::npos && !is_folder(path))
      throw AMF::Option_error("--clip all: each clip has files of its own; name a folder, " + path + "/, or write " +
                              place_of_clip + " where the clip's name is to be: results/" + place_of_clip + ending);
  });
}

Output_options outputs_of_clip(const Output_options& options, const std::string& file_name)
{
  Output_options o = options;
  for_each_path(o, [&](std::string& path, const std::string& ending) {
    if (path.find(place_of_clip) == std::string::npos) {
      path = (std::filesystem::path(path) / (file_name + ending)).string();
      return;
    }
    for (std::size_t at = path.find(place_of_clip); at != std::string::npos;
         at = path.find(place_of_clip, at + file_name.size()))
      path.replace(at, place_of_clip.size(), file_name);
  });
  return o;
}

void make_folders(const std::vector<std::string>& paths)
{
  for (const std::string& path : paths) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) throw AMF::Output_error(folder.string() + ": cannot make the folder: " + error.message());
  }
}

} // namespace Programs
