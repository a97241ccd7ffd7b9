// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Scene_files.h"

#include "output/Html_file.h"
#include "scenes/write_glb.h"
#include "scenes/write_vtk.h"
#include "views/write_views.h"
#ifdef DETECT_FEATURES_WITH_PICTURES
  #include "pictures/write_png.h"
  #include "plots/plot_format.h"
  #include "plots/write_plot.h"
  #include "plots/write_view_map.h"
#endif

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/IO/Output_folder.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <ostream>
#include <string>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

class Vtk_folder : public Scene_file
{
public:
  Vtk_folder(const std::string& path, AMF::IO::Output_sync sync)
    : m_folder(path, sync)
  {}

  void write(const Shown_scene& scene) override { write_vtk(m_folder, scene); }
  void commit() override { m_folder.commit(); }

private:
  AMF::IO::Output_folder m_folder;
};

// What goes to a single file, by `write(stream, scene)`.
template <class Write>
class Single_file : public Scene_file
{
public:
  Single_file(const std::string& path, AMF::IO::Output_sync sync, Write write)
    : m_file(path, sync)
    , m_write(std::move(write))
  {}

  void write(const Shown_scene& scene) override
  {
    m_write(m_file.stream(), scene);
    m_file.stream().flush();
    m_file.check();
  }
  void commit() override { m_file.commit(); }

private:
  AMF::IO::Output_file m_file;
  Write m_write;
};

template <class Write>
std::unique_ptr<Scene_file> single_file(const std::string& path, AMF::IO::Output_sync sync, Write write)
{
  return std::make_unique<Single_file<Write>>(path, sync, std::move(write));
}

std::unique_ptr<Scene_file> open(const Requested_file<Scene_format>& requested, const Output_options& o)
{
  switch (requested.kind) {
  case Scene_format::HTML:
    return open_html_file(requested.path, o);
  case Scene_format::VTK:
    return std::make_unique<Vtk_folder>(requested.path, o.sync());
  case Scene_format::GLB:
    return single_file(requested.path, o.sync(),
                       [](std::ostream& os, const Shown_scene& scene) { write_glb(os, scene); });
  case Scene_format::VIEWS:
    return single_file(requested.path, o.sync(),
                       [](std::ostream& os, const Shown_scene& scene) { write_views(os, scene); });
#ifdef DETECT_FEATURES_WITH_PICTURES
  case Scene_format::VIEW_MAP:
    return single_file(requested.path, o.sync(),
                       [format = plot_format("--view-map", requested.path)](std::ostream& os, const Shown_scene& scene) {
                         write_view_map(os, scene, format);
                       });
  case Scene_format::PLOT:
    return single_file(requested.path, o.sync(),
                       [format = plot_format("--plot", requested.path)](std::ostream& os, const Shown_scene& scene) {
                         write_plot(os, scene, format);
                       });
  case Scene_format::PNG:
    return single_file(requested.path, o.sync(), [options = o.picture](std::ostream& os, const Shown_scene& scene) {
      write_png(os, scene, options);
    });
#else
  case Scene_format::VIEW_MAP:
  case Scene_format::PLOT:
  case Scene_format::PNG:
    break; // refused with the option
#endif
  }
  return nullptr;
}

} // namespace

Scene_files::Scene_files(const Output_options& options)
{
  for (const auto& requested : options.scenes) m_files.push_back(open(requested, options));
}

void Scene_files::write(const Shown_scene& scene)
{
  for (auto& file : m_files) file->write(scene);
}

void Scene_files::commit()
{
  for (auto& file : m_files) file->commit();
}

} // namespace Programs
