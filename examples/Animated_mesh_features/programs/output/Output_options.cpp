// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Output_options.h"

#include "options/Option_groups.h"
#include "output/add_picture_options.h"
#include "running/is_terminal.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

using CGAL::Animated_mesh_features::Option_error;

namespace Programs {

namespace {

// PREFIX:FILE, if the prefix is one of the names
template <class Kind>
std::optional<Requested_file<Kind>> prefixed_file(const std::string& text)
{
  for (const auto& n : names(Kind()))
    if (text.compare(0, n.first.size() + 1, n.first + ":") == 0)
      return Requested_file<Kind>{n.second, text.substr(n.first.size() + 1)};
  return std::nullopt;
}

Requested_file<Format> requested_features(const std::string& text)
{
  if (text == "-") return {Format::JSON, text};
  if (const auto forced = prefixed_file<Format>(text)) return *forced;
  if (!text.empty() && text.back() == '/') return {Format::JSON, text}; // of all clips
  std::string ending = std::filesystem::path(text).extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& n : names(Format()))
    if (ending == "." + n.first) return {n.second, text};
  throw Option_error("-o " + text + ": the format is not clear from the ending (.json, .csv, .ply); write -o json:" +
                     text + ", for instance");
}

Requested_file<Field> requested_field(const std::string& text)
{
  if (const auto field = prefixed_file<Field>(text)) return *field;
  throw Option_error("--write-field " + text + ": write strain:FILE, curvature:FILE or deformation:FILE");
}

void add_result_options(Option_group& group, Output_options& o)
{
  group.add_repeatable(
      "output,o", "FILE",
      "where to write the features, repeatable: .json, .csv or .ply by its ending; json:FILE, csv:FILE or "
      "ply:FILE whatever its name; - for the standard output (default, if no scene is written either: a table of the "
      "strongest at a terminal, JSON in a pipe or a file)",
      [&](const Argument& a) { o.features.push_back(requested_features(a.text())); });
  group.add_repeatable(
      "write-field", "FIELD:FILE",
      "also write strain, curvature (its absolute change from the rest shape) or deformation (strain + alpha "
      "times curvature) of all N vertices in all F frames, repeatable: a NumPy file (.npy), N x F, float32",
      [&](const Argument& a) { o.fields.push_back(requested_field(a.text())); });
}

void check_is_built([[maybe_unused]] Scene_format format)
{
#ifndef DETECT_FEATURES_WITH_PICTURES
  if (format == Scene_format::PLOT || format == Scene_format::PNG || format == Scene_format::VIEW_MAP)
    throw Option_error("--" + name(format) +
                       ": this program was built without pictures: cairo was missing, or switched off");
#endif
}

void add_scene(Option_group& group, Output_options& o, Scene_format format, const std::string& value_name,
               const std::string& description)
{
  group.add(name(format), value_name, description, [&o, format](const Argument& a) {
    check_is_built(format);
    if (format == Scene_format::VTK && a.text() == "-")
      throw Option_error(a.option() + ": a folder cannot go to the standard output");
    o.scenes.push_back({format, a.text()});
  });
}

void set_html_frame_step(const Argument& a, Output_options& o)
{
  if (!o.has_scene(Scene_format::HTML)) throw Option_error(a.option() + " goes with --html, the page that it is about");
  o.html_frame_step = a.count();
  if (o.html_frame_step == 0) throw Option_error(a.option() + ": at least 1, which takes all frames");
}

void add_scene_options(Option_group& group, Output_options& o)
{
  add_scene(
      group, o, Scene_format::HTML, "FILE",
      "a page for the browser, with everything in it: the moving surface, coloured by the deformation (and the fields "
      "of --write-field), the features as spheres, a timeline and a table");
  group.add("html-every", "N",
            "take every N-th frame into the page, 1 for all of them (default: as many as leave 6.5 million positions)",
            [&](const Argument& a) { set_html_frame_step(a, o); });
  add_scene(group, o, Scene_format::VTK, "DIR",
            "a scene for ParaView: in the folder DIR, surface.pvd with strain, curvature and deformation, and "
            "features.pvd with the features, each in the frames in which it lives");
  add_scene(group, o, Scene_format::GLB, "FILE",
            "a scene for Blender and other viewers of glTF: the moving surface, coloured by its deformation, with the "
            "features as spheres that come and go");
  add_scene(
      group, o, Scene_format::PLOT, "FILE",
      "a plot of the features over time, of the deformation at the strongest places over the same time, and of how many "
      "features there are of which sigma and tau: .svg, .pdf or .png by its ending, SVG on the standard output");
  add_scene(group, o, Scene_format::PNG, "FILE",
            "a picture (PNG) of the surface, coloured by the deformation, with the features as spheres (radius sqrt(2) "
            "sigma; blue: long, red: short; dashed: at a limit of the scales) with their ranks, in the frames that --frame "
            "tells (default: those of the strongest "
            "features, at most 6)");
  add_scene(group, o, Scene_format::VIEWS, "FILE",
            "the views that show most of the features (JSON): the best one and two that show what it hides, with their "
            "scores, and a camera's path over the clip");
  add_scene(group, o, Scene_format::VIEW_MAP, "FILE",
            "a map of what views from all sides show of the features, by azimuth and elevation: .svg, .pdf or .png by its "
            "ending");
}

} // namespace

Names<Field> names(Field)
{
  return {{"strain", Field::STRAIN}, {"curvature", Field::CURVATURE}, {"deformation", Field::DEFORMATION}};
}

Names<Format> names(Format)
{
  return {{"json", Format::JSON}, {"csv", Format::CSV}, {"ply", Format::PLY}};
}

Names<Scene_format> names(Scene_format)
{
  return {{"html", Scene_format::HTML},
          {"vtk", Scene_format::VTK},
          {"glb", Scene_format::GLB},
          {"plot", Scene_format::PLOT},
          {"png", Scene_format::PNG},
          {"views", Scene_format::VIEWS},
          {"view-map", Scene_format::VIEW_MAP}};
}

bool Output_options::is_written(Field field) const
{
  return std::any_of(fields.begin(), fields.end(), [&](const auto& f) { return f.kind == field; });
}

bool Output_options::is_shown(Field field) const
{
  // All scenes with a surface colour it by the deformation, and offer the others if they are there anyway.
  const bool has_surface = has_scene(Scene_format::HTML) || has_scene(Scene_format::VTK) ||
                           has_scene(Scene_format::GLB) || has_scene(Scene_format::PNG);
  if (field == Field::DEFORMATION) return has_surface || has_scene(Scene_format::PLOT);
  const bool is_unused = field == Field::CURVATURE && !is_curvature_used;
  const bool has_all_fields = has_scene(Scene_format::VTK) && !is_unused;
  return has_all_fields || (has_surface && is_written(field));
}

std::size_t Output_options::extra_fields() const
{
  std::size_t n = 0;
  for (const auto& field : names(Field())) n += is_written(field.second) || is_shown(field.second);
  return n;
}

bool Output_options::has_scene(Scene_format format) const
{
  return std::any_of(scenes.begin(), scenes.end(), [&](const auto& s) { return s.kind == format; });
}

bool Output_options::has_chosen_views() const
{
  const bool is_auto = picture.view.kind == View_kind::AUTO;
  return has_scene(Scene_format::VIEWS) || has_scene(Scene_format::VIEW_MAP) ||
         (is_auto && (has_scene(Scene_format::PNG) || has_scene(Scene_format::HTML)));
}

CGAL::Animated_mesh_features::IO::Output_sync Output_options::sync() const
{
  typedef CGAL::Animated_mesh_features::IO::Output_sync Output_sync;
  return no_sync ? Output_sync::NEVER : Output_sync::BEFORE_RENAME;
}

std::vector<std::string> Output_options::paths() const
{
  std::vector<std::string> all;
  for (const auto& f : features) all.push_back(f.path);
  for (const auto& f : fields) all.push_back(f.path);
  for (const auto& s : scenes) all.push_back(s.path);
  if (!vertex_map.empty()) all.push_back(vertex_map);
  return all;
}

void add_output_options(Option_group& group, Output_options& o)
{
  add_result_options(group, o);
  add_scene_options(group, o);
  add_picture_options(group, o);
  group.add("vertex-map", "FILE",
            "also write which vertices of the file, by part, the vertices of the results are made of (CSV); models for "
            "pictures split vertices at seams, and split ones are welded on reading",
            [&](const Argument& a) { o.vertex_map = a.text(); });
  group.add_switch(
      "no-sync", o.no_sync,
      "do not wait for the disk before files take their places: faster on slow disks, but after a power failure "
      "files may be incomplete");
}

void complete(Output_options& o)
{
  check_picture_options(o.picture);
  for (const auto& f : o.features)
    if (!f.path.empty() && f.path.back() == '/')
      throw Option_error("-o " + f.path + ": a folder goes with --clip all, of which each clip has a file; name a file");
  // whoever asks for a scene does not ask for JSON on the standard output
  if (!o.features.empty() || !o.scenes.empty()) return;
  o.is_table_shown = is_terminal(stdout);
  if (!o.is_table_shown) o.features.push_back({Format::JSON, "-"});
}

} // namespace Programs
