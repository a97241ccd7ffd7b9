// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/Item.h"

#include "options/Option_groups.h"
#include "reading/Model_file.h"

#include <CGAL/Animated_mesh_features/IO/file_format.h>
#include <CGAL/Animated_mesh_features/IO/natural_order.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace AMF = CGAL::Animated_mesh_features;
namespace fs = std::filesystem;

namespace Compare_animations {

namespace {

bool is_model(AMF::IO::File_format f)
{
  return f != AMF::IO::File_format::UNKNOWN && !AMF::IO::is_mesh(f) && !AMF::IO::is_point_cache(f);
}

bool is_feature_file(const fs::path& path)
{
  return AMF::IO::file_ending(path.string()) == ".json";
}

bool is_folder(const fs::path& path)
{
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::vector<fs::path> members(const fs::path& folder)
{
  std::vector<fs::path> result;
  std::error_code error;
  fs::directory_iterator i(folder, error);
  for (const fs::directory_iterator end; !error && i != end; i.increment(error))
    if (i->path().filename().string()[0] != '.') result.push_back(i->path());
  if (error) throw AMF::Input_error(folder.string() + ": cannot read the folder: " + error.message());
  std::sort(result.begin(), result.end(),
            [](const fs::path& a, const fs::path& b) { return AMF::IO::natural_order(a.string(), b.string()); });
  return result;
}

std::string stem(const std::string& path)
{
  fs::path p = path;
  if (!p.has_filename()) p = p.parent_path(); // of "frames/"
  return is_folder(p) ? p.filename().string() : p.stem().string();
}

// The mesh of a point cache: the file beside it of the same name, or of the name that has most in common with it from
// its beginning on, as walker.obj with walker__run.pc2.
std::string mesh_of(const fs::path& cache)
{
  const std::string name = cache.stem().string();
  std::string best;
  std::size_t most = 0;
  bool is_unique = true;
  const fs::path folder = cache.has_parent_path() ? cache.parent_path() : fs::path(".");
  for (const fs::path& p : members(folder)) {
    if (!AMF::IO::is_mesh(AMF::IO::file_format_by_ending(p.string()))) continue;
    const std::string other = p.stem().string();
    std::size_t common = 0;
    while (common < name.size() && common < other.size() && name[common] == other[common]) ++common;
    if (common == name.size() && common == other.size()) ++common;
    if (common > most) {
      most = common;
      best = (cache.has_parent_path() ? p : p.filename()).string();
      is_unique = true;
    } else if (common == most && common > 0) {
      is_unique = false;
    }
  }
  if (best.empty() || !is_unique)
    throw AMF::Input_error(
        cache.string() + ": " +
        (best.empty() ? "no mesh whose name begins likewise is" : "several meshes are equally likely") +
        " beside the point cache; name it before a comma, MESH," + cache.filename().string());
  return best;
}

// Words of a line; quotes hold together what has blanks in it.
std::vector<std::string> words_of(const std::string& line, const std::string& where)
{
  std::vector<std::string> words;
  std::string word;
  bool is_open = false, is_word = false;
  for (char c : line) {
    if (c == '"') {
      is_open = !is_open;
      is_word = true;
    } else if (!is_open && (c == ' ' || c == '\t' || c == '\r')) {
      if (is_word) words.push_back(word);
      word.clear();
      is_word = false;
    } else {
      if (!is_open && !is_word && c == '#') return words;
      word += c;
      is_word = true;
    }
  }
  if (is_open) throw AMF::Input_error(where + ": a quote is not closed");
  if (is_word) words.push_back(word);
  return words;
}

// A line of a list: what detect_features would be told to read the animation, paths relative to the list.
Item listed_item(const std::vector<std::string>& words, const fs::path& folder, const std::string& where)
{
  Programs::Reading_options o;
  Programs::Option_groups groups;
  Programs::Option_group& input = groups.add_group("Input");
  add_reading_options(input, o);
  input.add_switch("cyclic", o.is_cyclic, "the last frame is followed by the first");
  groups.add_positional("inputs", o.inputs, -1);
  std::vector<const char*> arguments = {"compare_animations"};
  for (const std::string& w : words) arguments.push_back(w.c_str());
  try {
    groups.parse(int(arguments.size()), arguments.data());
    groups.use();
  } catch (const AMF::Option_error& e) {
    throw AMF::Input_error(where + ": " + e.what());
  }
  if (o.inputs.empty()) throw AMF::Input_error(where + ": no file is named");
  const auto moved = [&](std::string& path) {
    if (!path.empty() && fs::path(path).is_relative()) path = (folder / path).string();
  };
  for (std::string& path : o.inputs) moved(path);
  moved(o.rest.file);
  const std::string last = o.inputs.back();
  if (o.inputs.size() == 1) return item(last, o);
  return {stem(last) + (o.clip.empty() ? "" : "/" + o.clip), "", o};
}

void add_list(const std::string& path, std::vector<Item>& items)
{
  std::ifstream is(path);
  if (!is) throw AMF::Input_error(path + ": cannot read the list");
  std::size_t number = 0;
  for (std::string line; std::getline(is, line);) {
    const std::string where = path + ", line " + std::to_string(++number);
    const std::vector<std::string> words = words_of(line, where);
    if (!words.empty()) items.push_back(listed_item(words, fs::path(path).parent_path(), where));
  }
}

// All clips of a model; what has no clips, as it is.
void add_clips(const Item& model, std::vector<Item>& items)
{
  Programs::Reading_options reading = model.reading;
  reading.clip.clear();
  if (Programs::model_format(reading.inputs) == Programs::Model_format::NONE) {
    items.push_back(model);
    items.back().reading.clip.clear();
    return;
  }
  const std::vector<std::string> clips = Programs::clip_names(reading);
  for (std::size_t c = 0; c < clips.size(); ++c) {
    Item i = model;
    const bool is_unique = !clips[c].empty() && std::count(clips.begin(), clips.end(), clips[c]) == 1;
    i.reading.clip = is_unique ? clips[c] : std::to_string(c);
    i.name = stem(model.reading.inputs.front()) + "/" + i.reading.clip;
    items.push_back(i);
  }
}

bool is_of_frames(const fs::path& folder)
{
  std::size_t meshes = 0;
  for (const fs::path& p : members(folder)) {
    const AMF::IO::File_format f = AMF::IO::file_format_by_ending(p.string());
    if (AMF::IO::is_point_cache(f) || is_model(f) || is_feature_file(p)) return false;
    meshes += AMF::IO::is_mesh(f) ? 1 : 0;
  }
  return meshes >= 3;
}

void add(const Item& i, std::vector<Item>& items)
{
  if (i.reading.clip == "all")
    add_clips(i, items);
  else
    items.push_back(i);
}

// What is in a folder, besides meshes, which belong to something else.
void add_folder(const fs::path& folder, const Programs::Reading_options& common, std::vector<Item>& items)
{
  for (const fs::path& p : members(folder)) {
    const AMF::IO::File_format f = AMF::IO::file_format_by_ending(p.string());
    const bool is_file = !is_folder(p);
    if ((is_file && (is_feature_file(p) || AMF::IO::is_point_cache(f) || is_model(f))) || (!is_file && is_of_frames(p)))
      add(item(p.string(), common), items);
  }
}

std::string path_name(const Item& i)
{
  const std::string& path = i.feature_file.empty() ? i.reading.inputs.back() : i.feature_file;
  return path + (i.reading.clip.empty() ? "" : "/" + i.reading.clip);
}

// Names are those of files; where these are the same, of their folders, too.
void make_unique(std::vector<Item>& items)
{
  std::map<std::string, std::size_t> count;
  for (const Item& i : items) ++count[i.name];
  for (Item& i : items)
    if (count[i.name] > 1) i.name = path_name(i);
  std::map<std::string, std::size_t> again;
  for (const Item& i : items)
    if (++again[i.name] > 1) throw AMF::Option_error(i.name + " is in the collection twice");
}

} // namespace

Item item(const std::string& word, const Programs::Reading_options& common)
{
  Item result;
  result.reading = common;
  result.name = stem(word);
  std::error_code ignored;
  const std::size_t comma = word.find(',');
  if (!fs::exists(word, ignored) && comma != std::string::npos) {
    result.reading.inputs = {word.substr(0, comma), word.substr(comma + 1)};
    result.name = stem(result.reading.inputs.back());
  } else if (is_feature_file(word)) {
    result.feature_file = word;
  } else if (AMF::IO::is_point_cache(AMF::IO::file_format_by_ending(word)) && fs::exists(word, ignored)) {
    result.reading.inputs = {mesh_of(word), word};
  } else {
    result.reading.inputs = {word};
    if (!common.clip.empty() && common.clip != "all") result.name += "/" + common.clip;
  }
  if (result.feature_file.empty()) {
    if (result.reading.clip == "all" && AMF::IO::is_point_cache(AMF::IO::file_format_by_ending(word)))
      result.reading.clip.clear(); // a cache beside models
    check(result.reading);
  }
  return result;
}

void tell_apart(Item& a, Item& b)
{
  if (a.name != b.name || path_name(a) == path_name(b)) return;
  a.name = path_name(a);
  b.name = path_name(b);
}

std::vector<Item> collection(const std::vector<std::string>& words, const Programs::Reading_options& common)
{
  std::vector<Item> items;
  for (const std::string& word : words) {
    if (AMF::IO::file_ending(word) == ".txt")
      add_list(word, items);
    else if (is_folder(word) && !is_of_frames(word))
      add_folder(word, common, items);
    else
      add(item(word, common), items);
  }
  if (items.empty()) throw AMF::Input_error(words.front() + ": there are no animations and no files of features in it");
  make_unique(items);
  return items;
}

std::vector<std::string> paths(const std::vector<Item>& items)
{
  std::vector<std::string> all;
  for (const Item& i : items) {
    if (!i.feature_file.empty()) {
      all.push_back(i.feature_file);
      continue;
    }
    const std::vector<std::string> own = i.reading.paths();
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

} // namespace Compare_animations
