// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Result_files.h"

#include "scenes/colour_scales.h"

#include <CGAL/Animated_mesh_features/IO/write_csv.h>
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include <CGAL/Animated_mesh_features/IO/write_npy.h>
#include <CGAL/Animated_mesh_features/IO/write_ply.h>

#include <ostream>

namespace IO = CGAL::Animated_mesh_features::IO;

namespace Programs {

namespace {

void flush(IO::Output_file& file)
{
  file.stream().flush();
  file.check();
}

} // namespace

template <class Kind>
std::vector<Result_files::Open_file<Kind>> Result_files::opened(const std::vector<Requested_file<Kind>>& requested,
                                                                IO::Output_sync sync)
{
  std::vector<Open_file<Kind>> files;
  for (const auto& r : requested) files.push_back({r.kind, std::make_unique<Output_file>(r.path, sync)});
  return files;
}

Result_files::Result_files(const Output_options& options)
  : m_scenes(options)
  , m_fields(opened(options.fields, options.sync()))
  , m_features(opened(options.features, options.sync()))
{
  if (!options.vertex_map.empty()) m_vertex_map = std::make_unique<Output_file>(options.vertex_map, options.sync());
}

void Result_files::write_field(Field kind, const Values& field)
{
  for (auto& f : m_fields)
    if (f.kind == kind) {
      IO::write_npy(f.file->stream(), field);
      flush(*f.file);
    }
}

void Result_files::write_features(const std::vector<Feature>& features, const IO::Result_description& description)
{
  for (auto& f : m_features) {
    std::ostream& os = f.file->stream();
    switch (f.kind) {
    case Format::JSON:
      IO::write_json(os, features, description);
      break;
    case Format::CSV:
      IO::write_csv(os, features, description.origins);
      break;
    case Format::PLY:
      IO::write_ply(os, features, true, duration_colours_of(features));
      break;
    }
    flush(*f.file);
  }
  if (m_vertex_map) {
    IO::write_vertex_map(m_vertex_map->stream(), description.origins, description.vertices);
    flush(*m_vertex_map);
  }
}

void Result_files::write_scenes(const Shown_scene& scene)
{
  m_scenes.write(scene);
}

void Result_files::commit()
{
  for (auto& f : m_fields) f.file->commit();
  for (auto& f : m_features) f.file->commit();
  if (m_vertex_map) m_vertex_map->commit();
  m_scenes.commit();
}

} // namespace Programs
