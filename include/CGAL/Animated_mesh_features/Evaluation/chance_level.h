// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_EVALUATION_CHANCE_LEVEL_H
#define CGAL_ANIMATED_MESH_FEATURES_EVALUATION_CHANCE_LEVEL_H

#include <CGAL/Animated_mesh_features/Evaluation/Random_numbers.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

How chance levels are made: as many features with the same scales at random vertices and times, several times over.
*/
struct Chance_options
{
  std::size_t draws = 20; ///< of which the mean is the chance level; positive
  std::uint64_t seed = 0; ///< the same seed gives the same level
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

Where and when a feature is by chance.
*/
struct Random_place
{
  std::size_t vertex = 0; ///< all vertices are equally likely
  double time = 0;        ///< seconds, uniform over the duration
};

/*!
\ingroup PkgAnimatedMeshFeaturesEvaluation

computes what a figure is by chance: its mean over several draws of random places.

\param number_of_features how many places are drawn each time.
\param number_of_vertices among which they are drawn, positive.
\param duration of the animation (s).
\param figure takes a `std::vector<Random_place>` and returns what can be added up and multiplied by a number: a `double`,
  an `Eigen::ArrayXd` that was evaluated.
\param options see there.
\throw Option_error if there are no draws.
*/
template <class Figure>
auto chance_level(std::size_t number_of_features, std::size_t number_of_vertices, double duration, const Figure& figure,
                  Chance_options options = Chance_options())
{
  if (options.draws == 0) throw Option_error("a chance level needs at least one draw");
  Random_numbers random(options.seed);
  std::vector<Random_place> places(number_of_features);
  const auto draw = [&] {
    for (Random_place& p : places) p.vertex = random.below(number_of_vertices);
    for (Random_place& p : places) p.time = random.uniform(0, duration);
    return figure(places);
  };
  auto sum = draw();
  for (std::size_t i = 1; i < options.draws; ++i) sum += draw();
  sum *= 1. / double(options.draws);
  return sum;
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_EVALUATION_CHANCE_LEVEL_H
