// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PLOTS_WRITE_PLOT_H
#define PROGRAMS_PLOTS_WRITE_PLOT_H

#include "scenes/Scene.h"
#include "plots/Feature_plot.h"

#include <ostream>
#include <string>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a plot of features as a drawing (SVG): for browsers and documents, light or dark as its surroundings are.

- Above, the features over time: a circle at the time (seconds) and the strength, with a radius in proportion to
  \f$\sigma\f$, and a bar as long as \f$\tau\f$; colours are from red for the smallest \f$\tau\f$ to blue for the largest.
  Pointing at a feature shows its numbers.
- Below, how many features there are of which \f$\sigma\f$ (length) and of which \f$\tau\f$ (seconds), on logarithmic
  axes. They are left out if there are no features.

\param os errors are left in its state, `Output_file` reports them.
\param scene see `check_scene()` for what is thrown if it does not fit together. Its fields are not used.
*/
template <class Sequence, class Feature>
void write_plot(std::ostream& os, const Scene<Sequence, Feature>& scene)
{
  check_scene(scene);
  const internal::Feature_plot<Sequence, Feature> plot(scene);
  const std::string& svg = plot.svg();
  os.write(svg.data(), static_cast<std::streamsize>(svg.size()));
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PLOTS_WRITE_PLOT_H
