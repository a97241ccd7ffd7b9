// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_GLTF_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_GLTF_H

#include <CGAL/Animated_mesh_features/IO/Linked_files.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_check.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_container.h>
#include <CGAL/Animated_mesh_features/IO/internal/Gltf_linked_files.h>
#include <CGAL/Animated_mesh_features/IO/internal/file_content.h>
#include <CGAL/Animated_mesh_features/IO/internal/gltf_extensions.h>
#include <CGAL/Animated_mesh_features/IO/internal/parse_json.h>

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

inline std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// The buffers that are not in the text, for tinygltf: it asks for files by name, and gets these and no others.
class Gltf_buffers
{
public:
  // returns the name under which it is asked for
  std::string add(std::vector<unsigned char> bytes)
  {
    m_buffers.push_back(std::move(bytes));
    return "buffer" + std::to_string(m_buffers.size() - 1);
  }

  tinygltf::FsCallbacks callbacks()
  {
    tinygltf::FsCallbacks files{};
    files.user_data = this;
    files.ExpandFilePath = [](const std::string& name, void*) { return name; };
    files.FileExists = [](const std::string& name, void* all) {
      return static_cast<Gltf_buffers*>(all)->find(name) != nullptr;
    };
    files.ReadWholeFile = [](std::vector<unsigned char>* to, std::string*, const std::string& name, void* all) {
      std::vector<unsigned char>* const buffer = static_cast<Gltf_buffers*>(all)->find(name);
      if (buffer == nullptr) return false;
      to->swap(*buffer); // each is asked for once
      return true;
    };
    return files;
  }

private:
  std::vector<unsigned char>* find(const std::string& name)
  {
    for (std::size_t i = 0; i < m_buffers.size(); ++i)
      if (name == "buffer" + std::to_string(i)) return &m_buffers[i];
    return nullptr;
  }

  std::vector<std::vector<unsigned char>> m_buffers;
};

// Reads what buffers refer to, and puts the names of Gltf_buffers in the place of theirs.
inline void load_buffers(nlohmann::json& gltf, const std::optional<std::string>& binary, Gltf_linked_files& files,
                         Gltf_buffers& buffers, const Gltf_check& check)
{
  if (!gltf.is_object() || !gltf.contains("buffers") || !gltf["buffers"].is_array()) return;
  for (std::size_t i = 0; i < gltf["buffers"].size(); ++i) {
    nlohmann::json& buffer = gltf["buffers"][i];
    const std::string name = "buffer " + std::to_string(i);
    if (!buffer.is_object() || !buffer.contains("byteLength") || !buffer["byteLength"].is_number_unsigned())
      check.fail(name + " has no size");
    const std::size_t size = buffer["byteLength"].get<std::size_t>();
    if (size == 0) check.fail(name + " has 0 bytes");
    if (!buffer.contains("uri")) {
      if (i > 0 || !binary) check.fail(name + " has no data" + compression_of(buffer));
      if (size > binary->size())
        check.fail(name + " has " + std::to_string(size) + " bytes, the file " + std::to_string(binary->size()));
      buffer["uri"] = buffers.add(std::vector<unsigned char>(binary->begin(), binary->begin() + std::ptrdiff_t(size)));
    } else if (!buffer["uri"].is_string()) {
      check.fail(name + " has a uri that is no text");
    } else if (const std::string uri = buffer["uri"].get<std::string>(); uri.compare(0, 5, "data:") != 0) {
      buffer["uri"] = buffers.add(files.read(uri, size, name));
    }
  }
}

inline void parse_text(const nlohmann::json& json, Gltf_buffers& buffers, const Gltf_check& check, tinygltf::Model& model)
{
  const std::string text = json.dump();
  if (text.size() > (std::numeric_limits<unsigned int>::max)()) check.fail("is larger than 4 GB");
  tinygltf::TinyGLTF parser;
  parser.SetFsCallbacks(buffers.callbacks());
  std::string error, warning;
  bool is_read = false;
  try {
    is_read = parser.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned int>(text.size()),
                                         std::string());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) { // not its own: it looks for something without asking whether it is there
    error = "something that it refers to is not there, or is of another kind";
  }
  if (!is_read) check.fail("is no readable glTF 2.0: " + one_line(error));
  if (model.asset.version.compare(0, 1, "2") != 0) check.fail("is glTF " + model.asset.version + ", not glTF 2.0");
}

// Reads what a file holds and links, into `model`; returns the files that it links.
//
// The text is taken apart here first: tinygltf would follow brackets to the end of the stack, and open whatever file an
// image or a buffer names, also in the current folder.
inline std::vector<std::string> parse_gltf(const std::string& file, Linked_files allowed, tinygltf::Model& model)
{
  const Gltf_check check(file);
  std::string content;
  read_content(file, content);
  Gltf_container container = gltf_container(std::move(content), check);
  nlohmann::json json = parse_json(container.text, file + ": is no readable glTF 2.0");
  container.text = std::string();
  check_extensions(json, check);
  if (json.is_object()) json.erase("images"); // nobody looks at them
  Gltf_linked_files files(file, allowed, check);
  Gltf_buffers buffers;
  load_buffers(json, container.binary, files, buffers, check);
  container.binary.reset();
  parse_text(json, buffers, check, model);
  return files.files();
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_PARSE_GLTF_H
