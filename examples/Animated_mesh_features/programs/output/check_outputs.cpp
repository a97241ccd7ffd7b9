// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/check_outputs.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <vector>

#ifndef _WIN32
  #include <sys/stat.h>
#endif

using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

namespace {

namespace fs = std::filesystem;

bool is_standard_output(const std::string& path)
{
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

// Where a file is that is not there yet, also at the end of dangling links.
fs::path place(fs::path path)
{
  std::error_code error;
  const int longest_chain = 40; // as in Linux
  for (int i = 0; i < longest_chain && fs::is_symlink(fs::symlink_status(path, error)); ++i)
    path = path.parent_path() / fs::read_symlink(path, error);
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
  return canonical.has_filename() ? canonical : canonical.parent_path(); // of "folder/"
}

// What tells two files apart; the same for all paths that lead to a file. Empty for what may be written twice.
std::string identity(const std::string& path)
{
  const std::string file = is_standard_output(path) ? "/dev/stdout" : path;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return "place " + place(file).string();
  if (!fs::is_regular_file(status) && !fs::is_directory(status))
    return is_standard_output(path) ? "standard output" : std::string();
#ifdef _WIN32
  return "place " + place(file).string();
#else
  struct stat s;
  if (::stat(file.c_str(), &s) != 0) return "place " + place(file).string();
  return "file " + std::to_string(s.st_dev) + " " + std::to_string(s.st_ino);
#endif
}

std::string shown(const std::string& path)
{
  return is_standard_output(path) ? "the standard output" : path;
}

} // namespace

void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs)
{
  std::map<std::string, std::string> seen; // the path of each output
  for (const std::string& path : outputs) {
    if (path.empty()) throw Option_error("an output file has no name");
    const std::string id = identity(path);
    if (id.empty()) continue;
    const auto other = seen.emplace(id, path);
    if (other.second) continue;
    if (is_standard_output(path) && is_standard_output(other.first->second))
      throw Option_error("only one output can go to the standard output");
    const std::string& first = other.first->second;
    throw Option_error("two outputs go to the same file, " +
                       (first == path ? path : shown(first) + " and " + shown(path)));
  }
  for (const std::string& input : inputs) {
    const auto output = seen.find(identity(input));
    if (output == seen.end()) continue;
    throw Option_error("the output " + shown(output->second) + " is the input" +
                       (output->second == input ? std::string() : " " + input) + ", which would be lost");
  }
}

} // namespace Programs
