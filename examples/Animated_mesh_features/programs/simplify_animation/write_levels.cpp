// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/write_levels.h"

#include "running/Interruption.h"
#include "scenes/append_little_endian.h"
#include "simplify_animation/write_model.h"

#include <CGAL/Animated_mesh_features/IO/Indexed_mesh.h>
#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/Output_folder.h>
#include <CGAL/Animated_mesh_features/IO/Point_cache_reader.h>
#include <CGAL/Animated_mesh_features/IO/write_obj.h>
#include <CGAL/Animated_mesh_features/IO/write_point_cache.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace AMF = CGAL::Animated_mesh_features;
namespace IO = CGAL::Animated_mesh_features::IO;

namespace Simplify_animation {

namespace {

typedef std::vector<AMF::Rest_shape::Point> Points;

void write_frame_ply(std::ostream& os, const Points& points, const AMF::Animation_level& level)
{
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                     std::to_string(level.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const AMF::Rest_shape::Point& p : points)
    Programs::append_little_endian(text, std::vector<float>{float(p[0]), float(p[1]), float(p[2])});
  for (const AMF::Rest_shape::Triangle& t : level.triangles) {
    text += char(3);
    Programs::append_little_endian(text, std::vector<std::int32_t>(t.begin(), t.end()));
  }
  os.write(text.data(), std::streamsize(text.size()));
}

// frames of the same number of digits, so that they are in their order by name
std::string frame_file(std::size_t frame, std::size_t frames)
{
  std::string number = std::to_string(frame);
  const std::size_t digits = (std::max)(std::size_t(4), std::to_string(frames - 1).size());
  return "frame_" + std::string(digits - number.size(), '0') + number + ".ply";
}

std::string further_file(const std::string& base, const std::string& cache)
{
  return base + "_" + std::filesystem::path(cache).stem().string() + ".pc2";
}

void finish(IO::Output_file& file)
{
  file.stream().flush();
  file.check();
}

IO::Indexed_mesh rest_mesh(const Programs::Sequence& sequence, const AMF::Animation_level& level)
{
  IO::Indexed_mesh mesh;
  for (const AMF::Rest_shape::Point& p : level.binding.positions(sequence.rest_shape().points()))
    mesh.points.push_back({{p[0], p[1], p[2]}});
  for (const AMF::Rest_shape::Triangle& t : level.triangles) mesh.triangles.push_back({{t[0], t[1], t[2]}});
  return mesh;
}

// Another animation of the same vertices.
struct Further_animation
{
  AMF::Spatio_temporal_field<float> x, y, z;

  Further_animation(const std::string& name, std::size_t vertices)
  {
    IO::Point_cache_reader cache(name);
    cache.check_number_of_points(vertices, "that is simplified");
    cache.read_fields(x, y, z);
  }
};

template <class Positions>
void write_cache(IO::Output_file& file, const AMF::Animation_level& level, std::size_t frames,
                 const Positions& positions)
{
  IO::write_pc2(file.stream(), level.binding.size(), frames, [&](std::size_t f, float* xyz) {
    Programs::Interruption::check();
    const auto fine = positions(f);
    for (std::size_t v = 0; v < level.binding.size(); ++v) {
      const AMF::Rest_shape::Point p = level.binding.position(v, fine);
      for (int axis = 0; axis < 3; ++axis) *xyz++ = float(p[axis]);
    }
  });
  finish(file);
}

} // namespace

std::vector<std::string> level_bases(const Command_line& o, std::size_t levels)
{
  std::vector<std::string> bases;
  for (std::size_t i = 1; i <= levels; ++i) bases.push_back(levels == 1 ? o.base : o.base + "-" + std::to_string(i));
  return bases;
}

std::vector<std::string> level_files(const Command_line& o, std::size_t levels)
{
  std::vector<std::string> files;
  if (o.base.empty()) return files;
  for (const std::string& base : level_bases(o, levels)) {
    if (o.form == Form::PLY) {
      files.push_back(base);
      continue;
    }
    if (o.form == Form::GLB) {
      files.push_back(base + ".glb");
      continue;
    }
    files.push_back(base + ".obj");
    files.push_back(base + ".pc2");
    for (const std::string& cache : o.further) files.push_back(further_file(base, cache));
  }
  return files;
}

void write_levels(const Command_line& o, const Programs::Sequence& sequence, const IO::Vertex_origins& origins,
                  const Source_model& source, const AMF::Simplified_animation& result)
{
  if (o.base.empty()) return;
  const std::vector<std::string> bases = level_bases(o, result.levels.size());
  const std::size_t frames = sequence.number_of_frames();
  std::vector<std::unique_ptr<IO::Output_file>> files;
  std::vector<std::unique_ptr<IO::Output_folder>> folders;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    const AMF::Animation_level& level = result.levels[i];
    if (o.form == Form::GLB) {
      files.push_back(std::make_unique<IO::Output_file>(bases[i] + ".glb"));
      write_model(files.back()->stream(), *source.model, origins, level, source.texture ? &*source.texture : nullptr,
                  o.reading.inputs.front());
      finish(*files.back());
      continue;
    }
    if (o.form == Form::PLY) {
      folders.push_back(std::make_unique<IO::Output_folder>(bases[i]));
      for (std::size_t f = 0; f < frames; ++f) {
        Programs::Interruption::check();
        folders.back()->write(frame_file(f, frames), [&](std::ostream& os) {
          write_frame_ply(os, level.binding.positions(sequence.trajectories().frame(f)), level);
        });
      }
      continue;
    }
    files.push_back(std::make_unique<IO::Output_file>(bases[i] + ".obj"));
    IO::write_obj(files.back()->stream(), rest_mesh(sequence, level));
    finish(*files.back());
    files.push_back(std::make_unique<IO::Output_file>(bases[i] + ".pc2"));
    write_cache(*files.back(), level, frames, [&](std::size_t f) { return sequence.trajectories().frame(f); });
    for (const std::string& name : o.further) {
      const Further_animation other(name, sequence.number_of_vertices());
      files.push_back(std::make_unique<IO::Output_file>(further_file(bases[i], name)));
      write_cache(*files.back(), level, other.x.number_of_frames(),
                  [&](std::size_t f) { return AMF::Frame_positions<float>(other.x, other.y, other.z, f); });
    }
  }
  for (auto& file : files) file->commit();
  for (auto& folder : folders) folder->commit();
}

std::string binding_text(const AMF::Simplified_animation& result)
{
  typedef nlohmann::ordered_json Json;
  Json json = {{"format", "animated-mesh-features-binding"}, {"version", 1}, {"levels", Json::array()}};
  for (const AMF::Animation_level& level : result.levels) {
    Json l = {{"triangles", level.triangles}, {"vertices", Json::array()}, {"weights", Json::array()}};
    for (std::size_t v = 0; v < level.binding.size(); ++v) {
      const auto row = level.binding.vertices(v);
      const auto weights = level.binding.weights(v);
      l["vertices"].push_back(std::vector<std::size_t>(row.begin(), row.end()));
      l["weights"].push_back(std::vector<double>(weights.begin(), weights.end()));
    }
    json["levels"].push_back(l);
  }
  return json.dump(-1) + "\n";
}

} // namespace Simplify_animation
