// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_RESULT_FILES_H
#define DETECT_FEATURES_RESULT_FILES_H

#include "detect_features/Command_line.h"
#include "output/Scene_files.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/Result_description.h>
#include <CGAL/Animated_mesh_features/IO/write_csv.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/IO/write_npy.h>
#include <CGAL/Animated_mesh_features/IO/write_ply.h>

#include <memory>
#include <vector>

namespace Detect_features {

// All files that are written. They are opened first, so that a folder that does not exist is noticed before hours of
// computation, and take their places last, together, when each of them is complete.
class Result_files
{
  typedef CGAL::Animated_mesh_features::IO::Output_file Output_file;

  template <class Kind>
  struct Open_file
  {
    Kind kind;
    std::unique_ptr<Output_file> file;
  };

public:
  explicit Result_files(const Command_line& command_line)
    : m_scenes(command_line)
  {
    open(command_line.fields, m_fields);
    open(command_line.outputs, m_features);
    if (!command_line.vertex_map.empty()) m_vertex_map = std::make_unique<Output_file>(command_line.vertex_map);
  }

  template <class Spatio_temporal_field>
  void write_field(Field kind, const Spatio_temporal_field& field)
  {
    for (auto& f : m_fields)
      if (f.kind == kind) {
        CGAL::Animated_mesh_features::IO::write_npy(f.file->stream(), field);
        flush(*f.file);
      }
  }

  template <class FeatureRange>
  void write_features(const FeatureRange& features,
                      const CGAL::Animated_mesh_features::IO::Result_description& description)
  {
    namespace IO = CGAL::Animated_mesh_features::IO;
    for (auto& f : m_features) {
      std::ostream& os = f.file->stream();
      switch (f.kind) {
      case Format::JSON: IO::write_json(os, features, description); break;
      case Format::CSV: IO::write_csv(os, features, description.origins); break;
      case Format::PLY: IO::write_ply(os, features); break;
      }
      flush(*f.file);
    }
    if (m_vertex_map) {
      IO::write_vertex_map(m_vertex_map->stream(), description.origins, description.vertices);
      flush(*m_vertex_map);
    }
  }

  void write_scenes(const Shown_scene& scene) { m_scenes.write(scene); }

  void commit()
  {
    for (auto& f : m_fields) f.file->commit();
    for (auto& f : m_features) f.file->commit();
    if (m_vertex_map) m_vertex_map->commit();
    m_scenes.commit();
  }

private:
  template <class Kind>
  static void open(const std::vector<Requested_file<Kind>>& requested, std::vector<Open_file<Kind>>& files)
  {
    for (const auto& r : requested) files.push_back({r.kind, std::make_unique<Output_file>(r.path)});
  }

  static void flush(Output_file& file)
  {
    file.stream().flush();
    file.check();
  }

  std::vector<Open_file<Field>> m_fields;
  std::vector<Open_file<Format>> m_features;
  std::unique_ptr<Output_file> m_vertex_map;
  Scene_files m_scenes;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_RESULT_FILES_H
