// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_CHOSEN_MEASURES_H
#define DETECT_FEATURES_CHOSEN_MEASURES_H

#include "detect_features/Method_options.h"

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Deformation/Strain_measures.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/CGAL_heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Dijkstra_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Global_heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/Heat_method_geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>

#include <variant>

// Policies of the measurement, of which the kind is chosen when the program runs. Each models the same concept as its
// alternatives, so that the measurement is compiled once and not for every combination. They are asked for whole blocks of
// frames: finding the alternative costs nothing beside that.

namespace Detect_features {

namespace AMF = CGAL::Animated_mesh_features;

class Chosen_strain
{
public:
  static constexpr bool vectorized = true;

  explicit Chosen_strain(Strain strain = Strain::HENCKY)
  {
    switch (strain) {
    case Strain::HENCKY:
      m_measure = AMF::Hencky_strain();
      break;
    case Strain::GREEN_LAGRANGE:
      m_measure = AMF::Green_lagrange_strain();
      break;
    case Strain::STRETCH:
      m_measure = AMF::Principal_stretch_strain();
      break;
    case Strain::LARGEST_EIGENVALUE:
      m_measure = AMF::Largest_eigenvalue_strain();
      break;
    }
  }

  template <class T>
  T operator()(const T& lambda_1, const T& lambda_2) const
  {
    return std::visit([&](const auto& measure) { return measure(lambda_1, lambda_2); }, m_measure);
  }

private:
  std::variant<AMF::Hencky_strain, AMF::Green_lagrange_strain, AMF::Principal_stretch_strain,
               AMF::Largest_eigenvalue_strain>
      m_measure;
};

class Chosen_balls
{
public:
  explicit Chosen_balls(Balls balls = Balls::HEAT)
  {
    switch (balls) {
    case Balls::HEAT:
      m_balls = AMF::Heat_method_geodesic_balls();
      break;
    case Balls::HEAT_PATCHES:
      m_balls = AMF::CGAL_heat_method_geodesic_balls();
      break;
    case Balls::HEAT_GLOBAL:
      m_balls = AMF::Global_heat_method_geodesic_balls();
      break;
    case Balls::DIJKSTRA:
      m_balls = AMF::Dijkstra_geodesic_balls();
      break;
    }
  }

  template <class Loop>
  AMF::Compressed_rows operator()(const AMF::Rest_shape& shape, double radius, const Loop& loop) const
  {
    return std::visit([&](const auto& balls) { return balls(shape, radius, loop); }, m_balls);
  }

private:
  std::variant<AMF::Heat_method_geodesic_balls, AMF::CGAL_heat_method_geodesic_balls,
               AMF::Global_heat_method_geodesic_balls, AMF::Dijkstra_geodesic_balls>
      m_balls;
};

} // namespace Detect_features

#endif // DETECT_FEATURES_CHOSEN_MEASURES_H
