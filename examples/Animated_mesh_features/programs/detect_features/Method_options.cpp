// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/Method_options.h"

#include "options/Option_groups.h"

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <string>

using CGAL::Animated_mesh_features::Option_error;
using Programs::Argument;
using Programs::Names;
using Programs::Option_group;

namespace Detect_features {

namespace {

void set_preset(Preset preset, Method_options& o)
{
  o.preset = preset;
  if (preset == Preset::CALIBRATED) return; // what Method_options starts with
  o.strain = Strain::LARGEST_EIGENVALUE;
  o.curvature = Curvature::DIHEDRAL;
  o.spatial_filter = Spatial_filter::ONE_RING;
  o.temporal_filter = Temporal_filter::BOX;
  o.baseline = Baseline::NONE;
  o.dimension = Dimension::PLANE;
}

// A use of an argument: one of several names.
template <class Choice>
auto to_choice(Choice& choice)
{
  return [&choice](const Argument& a) { choice = a.choice<Choice>(); };
}

std::size_t smoothing_counts(const Argument& a, Preset preset)
{
  const std::size_t result = a.count();
  if (result < 3) throw Option_error(a.option() + ": at least 3 are needed for an extremum between them");
  if (preset != Preset::PUBLISHED)
    throw Option_error(a.option() + " goes with --preset published only; elsewhere the scales follow from their range");
  return result;
}

double fraction(const Argument& a, const char* what)
{
  const double result = a.non_negative_number();
  if (result > 1) a.refuse(what);
  return result;
}

void add_measure_options(Option_group& group, Method_options& o)
{
  group.add("strain", "NAME", "hencky (default), green-lagrange, stretch, largest-eigenvalue (p)", to_choice(o.strain));
  group.add("curvature", "NAME", "density: of mean curvature (default); dihedral: mean of dihedral angles (p)",
            to_choice(o.curvature));
  group.add("balls", "NAME",
            "geodesic balls for the curvature: heat method (heat, default), the same by CGAL's class on local patches "
            "(heat-patches, slow) or on the whole mesh (heat-global, very slow), or paths along edges (dijkstra)",
            to_choice(o.balls));
  group.add("ball-radius", "R",
            "length, or % of the diameter of the rest shape (default: 4.5 % of it, between 3 and 8 mean edge "
            "lengths, but less where balls would have more than 1,500 vertices in the mean)",
            [&](const Argument& a) { o.ball_radius = Programs::length(a); });
  group.add("alpha", "A", "weight of the change of curvature, bending, against strain, stretching (default: 7); 0 leaves curvature "
            "out",
            [&](const Argument& a) { o.alpha = a.non_negative_number(); });
  group.add("baseline", "NAME",
            "what is subtracted from the deformation of each vertex: its least value over the clip, so that what never "
            "changes hides nothing (least, default), or nothing (none, p)",
            to_choice(o.baseline));
}

void add_filter_options(Option_group& group, Method_options& o)
{
  group.add("spatial-filter", "NAME", "heat: diffusion (default); one-ring: averages over neighbours (p)",
            to_choice(o.spatial_filter));
  group.add("dimension", "NAME",
            "responses are normalised to the surface's own dimension, which is 1 on a limb whose girth is smaller than the "
            "scale (surface, default), or to that of a plane (plane, p)",
            to_choice(o.dimension));
  group.add("temporal-filter", "NAME", "gaussian (default), box (p)", to_choice(o.temporal_filter));
  group.add_switch(
      "cyclic", o.is_cyclic,
      "the last frame is followed by the first, as in a step of a gait that is walked again and again: no "
      "reflecting ends, and a feature may lie across the end. The period is as many frames as there are; a last "
      "frame that repeats the first is left out");
  group.add("box-width", "W",
            "width of the temporal box in frames; preset published only (default: a sixth of the frames)",
            [&](const Argument& a) { o.box_width = a.count(); });
}

void add_scale_options(Option_group& group, Method_options& o)
{
  group.add(
      "space-counts", "K",
      "search up to K passes of the spatial filter; preset published only (default: by the paper's formula, which "
      "grows with the square of diagonal by edge length, to thousands for a fine mesh)",
      [&](const Argument& a) { o.space_counts = smoothing_counts(a, o.preset); });
  group.add("time-counts", "L",
            "search up to L passes of the temporal filter; preset published only (default: by the paper's formula)",
            [&](const Argument& a) { o.time_counts = smoothing_counts(a, o.preset); });
  group.add("sigma-range", "MIN:MAX",
            "how large events may be (sigma, the standard deviation of a Gaussian in space), as lengths or % of the "
            "diameter of the rest shape; either may be left out (default: 0.5 to 17.5 % of it); below 1.6 MIN "
            "they count less and less. Preset calibrated only",
            [&](const Argument& a) { o.sigma = Programs::range(a, Programs::length); });
  group.add("tau-range", "MIN:MAX",
            "how long events may last (tau, the standard deviation in time), in seconds; either may be left out "
            "(default: from one frame to a third of the duration, with --cyclic to a quarter); below 2 MIN they count less and "
            "less. Preset calibrated only",
            [&](const Argument& a) {
              o.tau = Programs::range(a, [](const Argument& bound) { return bound.positive_number(); });
            });
}

} // namespace

Names<Preset> names(Preset)
{
  return {{"calibrated", Preset::CALIBRATED}, {"published", Preset::PUBLISHED}};
}

Names<Strain> names(Strain)
{
  return {{"hencky", Strain::HENCKY},
          {"green-lagrange", Strain::GREEN_LAGRANGE},
          {"stretch", Strain::STRETCH},
          {"largest-eigenvalue", Strain::LARGEST_EIGENVALUE}};
}

Names<Curvature> names(Curvature)
{
  return {{"density", Curvature::DENSITY}, {"dihedral", Curvature::DIHEDRAL}};
}

Names<Balls> names(Balls)
{
  return {{"heat", Balls::HEAT},
          {"heat-patches", Balls::HEAT_PATCHES},
          {"heat-global", Balls::HEAT_GLOBAL},
          {"dijkstra", Balls::DIJKSTRA}};
}

Names<Spatial_filter> names(Spatial_filter)
{
  return {{"heat", Spatial_filter::HEAT}, {"one-ring", Spatial_filter::ONE_RING}};
}

Names<Temporal_filter> names(Temporal_filter)
{
  return {{"gaussian", Temporal_filter::GAUSSIAN}, {"box", Temporal_filter::BOX}};
}

Names<Baseline> names(Baseline)
{
  return {{"least", Baseline::LEAST}, {"none", Baseline::NONE}};
}

Names<Dimension> names(Dimension)
{
  return {{"surface", Dimension::SURFACE}, {"plane", Dimension::PLANE}};
}

void add_method_options(Option_group& group, Method_options& o)
{
  // first: the others replace single choices of it
  group.add("preset", "NAME",
            "calibrated (default), or published: the paper's own choices, marked (p) below. What the other options "
            "choose replaces a single choice of the preset",
            [&](const Argument& a) { set_preset(a.choice<Preset>(), o); });
  add_measure_options(group, o);
  add_filter_options(group, o);
  add_scale_options(group, o);
}

void add_selection_options(Option_group& group, Method_options& o)
{
  group.add("threshold", "T",
            "least strength, in the unit of the deformation: the amplitude of the event times its fit, less where the "
            "ranges of scales begin (default: 0.1; p: none)",
            [&](const Argument& a) { o.threshold = a.non_negative_number(); });
  group.add("relative-threshold", "T",
            "least strength as a fraction of the strongest one, 0 to 1 (default: none; p: 0.2). If only one of the two "
            "thresholds is given, the other is none; the stricter one decides",
            [&](const Argument& a) {
              o.relative_threshold = fraction(a, "is above 1; it is a fraction of the strongest (see --threshold)");
            });
  group.add("min-fit", "R",
            "least correlation of the deformation around a feature with the feature's Gaussian, 0 to 1; 0: any (default: "
            "0.5; p: any)",
            [&](const Argument& a) { o.min_fit = fraction(a, "is above 1; it is a correlation"); });
  group.add("top", "N", "the N strongest features at most", [&](const Argument& a) { o.top = a.count(); });
  group.add_switch("no-suppression", o.no_suppression, "keep features close to stronger ones (p)");
}

void check(const Method_options& o)
{
  const bool is_published = o.preset == Preset::PUBLISHED;
  if (is_published && !(o.sigma.text.empty() && o.tau.text.empty()))
    throw Option_error(
        std::string(o.sigma.text.empty() ? "--tau-range" : "--sigma-range") +
        " does not go with --preset published: there, every smoothing count is a scale, up to counts that "
        "follow from the bounding box and the number of frames");
  if (!o.box_width) return;
  if (*o.box_width < 2) throw Option_error("--box-width: a box must be at least 2 frames wide to smooth anything");
  if (!is_published || o.temporal_filter != Temporal_filter::BOX)
    throw Option_error("--box-width goes with the box filter of --preset published only; elsewhere the filters follow "
                       "the scales");
}

} // namespace Detect_features
