// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CHOICES_H
#define DETECT_FEATURES_CHOICES_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <string>
#include <utility>
#include <vector>

// What the command line lets choose by name.

namespace Detect_features {

enum class Preset { CALIBRATED, PUBLISHED };
enum class Strain { HENCKY, GREEN_LAGRANGE, STRETCH, LARGEST_EIGENVALUE };
enum class Curvature { DENSITY, DIHEDRAL };
enum class Balls { HEAT, HEAT_PATCHES, HEAT_GLOBAL, DIJKSTRA };
enum class Spatial_filter { HEAT, ONE_RING };
enum class Temporal_filter { GAUSSIAN, BOX };
enum class Field { STRAIN, CURVATURE, DEFORMATION };
enum class Format { JSON, CSV, PLY };
enum class Scene_format { HTML, VTK, GLB, PLOT, PNG }; // each has an option of its own

template <class Choice>
using Names = std::vector<std::pair<std::string, Choice>>;

inline Names<Preset> names(Preset)
{
  return {{"calibrated", Preset::CALIBRATED}, {"published", Preset::PUBLISHED}};
}
inline Names<Strain> names(Strain)
{
  return {{"hencky", Strain::HENCKY},
          {"green-lagrange", Strain::GREEN_LAGRANGE},
          {"stretch", Strain::STRETCH},
          {"largest-eigenvalue", Strain::LARGEST_EIGENVALUE}};
}
inline Names<Curvature> names(Curvature)
{
  return {{"density", Curvature::DENSITY}, {"dihedral", Curvature::DIHEDRAL}};
}
inline Names<Balls> names(Balls)
{
  return {{"heat", Balls::HEAT},
          {"heat-patches", Balls::HEAT_PATCHES},
          {"heat-global", Balls::HEAT_GLOBAL},
          {"dijkstra", Balls::DIJKSTRA}};
}
inline Names<Spatial_filter> names(Spatial_filter)
{
  return {{"heat", Spatial_filter::HEAT}, {"one-ring", Spatial_filter::ONE_RING}};
}
inline Names<Temporal_filter> names(Temporal_filter)
{
  return {{"gaussian", Temporal_filter::GAUSSIAN}, {"box", Temporal_filter::BOX}};
}
inline Names<Field> names(Field)
{
  return {{"strain", Field::STRAIN}, {"curvature", Field::CURVATURE}, {"deformation", Field::DEFORMATION}};
}
inline Names<Format> names(Format)
{
  return {{"json", Format::JSON}, {"csv", Format::CSV}, {"ply", Format::PLY}};
}

inline Names<Scene_format> names(Scene_format)
{
  return {{"html", Scene_format::HTML},
          {"vtk", Scene_format::VTK},
          {"glb", Scene_format::GLB},
          {"plot", Scene_format::PLOT},
          {"png", Scene_format::PNG}};
}

template <class Choice>
std::string name(Choice choice)
{
  for (const auto& n : names(choice))
    if (n.second == choice) return n.first;
  return "";
}

// The choice of a name; Option_error, with all that could be chosen, if there is none.
template <class Choice>
Choice chosen(const std::string& option, const std::string& text)
{
  std::string all;
  for (const auto& n : names(Choice())) {
    if (n.first == text) return n.second;
    all += (all.empty() ? "" : ", ") + n.first;
  }
  throw CGAL::Animated_mesh_features::Option_error(option + ": there is no \"" + text + "\"; choose among " + all);
}

} // namespace Detect_features

#endif // DETECT_FEATURES_CHOICES_H
