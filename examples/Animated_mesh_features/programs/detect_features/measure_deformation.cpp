// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/measure_deformation.h"

#include "detect_features/Chosen_measures.h"

#include <CGAL/Animated_mesh_features/Deformation/Curvature_measures.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_measurement.h>
#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/default_ball_radius.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

using Programs::Field;
using Programs::Monitor;
using Programs::Sequence;
using Programs::Values;
using Programs::Wanted_fields;

namespace Detect_features {

namespace {

double ball_radius(const AMF::Rest_shape& shape, const Method_options& o)
{
  return o.ball_radius ? o.ball_radius->on(shape.diameter()) : AMF::default_ball_radius(shape);
}

template <class CurvatureMeasure>
Deformation measure(const Sequence& sequence, const Method_options& o, const Method_values& values,
                    const CurvatureMeasure& curvature, Wanted_fields& fields, Monitor& monitor)
{
  AMF::Deformation_options<Chosen_strain, CurvatureMeasure, Chosen_balls> options;
  options.strain = Chosen_strain(o.strain);
  options.curvature = curvature;
  options.balls = Chosen_balls(o.balls);
  options.triangle_weights = values.triangle_weights;
  options.alpha = values.alpha;
  Deformation result;
  if (options.alpha != 0 || fields.is_wanted(Field::CURVATURE))
    result.ball_radius = ball_radius(sequence.rest_shape(), o);
  result.bounds_ball_radius = result.ball_radius > 0 && !o.ball_radius &&
                              result.ball_radius < AMF::unbounded_ball_radius(sequence.rest_shape());
  options.ball_radius = result.ball_radius;
  AMF::Deformation_measurement<Sequence, decltype(options)> measurement(sequence, options);

  const auto use = [&](Field kind, const Values& field) {
    fields.write(kind, field);
    if (fields.is_kept(kind)) fields.keep(kind, field);
  };
  if (fields.is_wanted(Field::STRAIN)) use(Field::STRAIN, measurement.strain(monitor));
  if (fields.is_wanted(Field::CURVATURE)) use(Field::CURVATURE, measurement.curvature_change(monitor));
  result.field = measurement.take_deformation(monitor);
  result.noise = measurement.noise();
  if (o.baseline == Baseline::LEAST) AMF::subtract_baseline(result.field, AMF::Least_value_baseline());
  fields.write(Field::DEFORMATION, result.field);
  return result;
}

} // namespace

Deformation measure_deformation(const Sequence& sequence, const Method_options& options, const Method_values& values,
                                Wanted_fields& fields, Monitor& monitor)
{
  return options.curvature == Curvature::DENSITY
             ? measure(sequence, options, values, AMF::Mean_curvature_density(), fields, monitor)
             : measure(sequence, options, values, AMF::Mean_dihedral_angle(), fields, monitor);
}

AMF::Compressed_rows find_balls(const AMF::Rest_shape& shape, const Method_options& o, Monitor& monitor)
{
  AMF::Any_visitor visitor(monitor);
  return AMF::geodesic_balls(shape, ball_radius(shape, o), Chosen_balls(o.balls),
                             AMF::Task_loop<CGAL::Parallel_if_available_tag, AMF::Any_visitor>(
                                 visitor, AMF::Stage::GEODESIC_BALLS));
}

} // namespace Detect_features
