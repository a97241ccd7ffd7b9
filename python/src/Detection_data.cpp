// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Detection_data.h"

#include "detect_features/Search.h"
#include "detect_features/check_scales.h"
#include "detect_features/detect.h"
#include "detect_features/measure_deformation.h"
#include "detect_features/method_policies.h"
#include "detect_features/reason_for_none.h"
#include "detect_features/report.h"
#include "detect_features/with_temporal_filter.h"
#include "output/Result_files.h"
#include "output/Wanted_fields.h"
#include "output/check_outputs.h"
#include "running/Thread_limit.h"

#include <CGAL/Animated_mesh_features/Deformation/subtract_baseline.h>
#include <CGAL/Animated_mesh_features/Detection/place_on_animation.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <filesystem>
#include <utility>

using Programs::Field;
using Programs::Values;

namespace Python_module {

namespace {

// Nothing is written while features are found.
struct No_files
{
  Programs::Output_options options;
  Programs::Result_files files{options};
  Programs::Stage_log log;
};

class Kept_fields : private No_files, public Programs::Wanted_fields
{
public:
  explicit Kept_fields(std::set<Field> kept)
    : Wanted_fields(options, files, log)
    , m_kept(std::move(kept))
  {}

  bool is_kept(Field kind) const override { return m_kept.count(kind) > 0; }

private:
  std::set<Field> m_kept;
};

// The policies are compiled for triangles whose vertices have ranks.
typedef Programs::Sequence::vertex_descriptor Vertex;

Detect_features::Search_result search(const Shape_data& shape, Values field, double frame_duration, double noise,
                                      const Detect_features::Method_options& o,
                                      const Detect_features::Method_values& values, Python_monitor& monitor)
{
  Detect_features::Search search{shape.shape(),
                                 frame_duration,
                                 std::move(field),
                                 noise,
                                 true,
                                 spatial_filter(o),
                                 Detect_features::Chosen_normalization{o.dimension ==
                                                                       Detect_features::Dimension::SURFACE},
                                 o.preset != Detect_features::Preset::PUBLISHED,
                                 values.selection,
                                 std::size_t(-1),
                                 monitor};
  const double diameter = shape.shape().diameter();
  return with_temporal_filter(o, values, [&](const auto& filter) {
    return o.preset == Detect_features::Preset::PUBLISHED
               ? find_features(std::move(search), filter, every_smoothing_count(o))
               : find_features(std::move(search), filter, fixed_ratio_sampling(o, diameter));
  });
}

} // namespace

Detection_data::Detection_data(std::shared_ptr<const Animation_data> animation, const Arguments& arguments,
                               std::set<Field> kept, Python_monitor& monitor)
  : m_shape(animation)
  , m_animation(std::move(animation))
  , m_frame_duration(m_animation->sequence().frame_duration())
  , m_frames(m_animation->sequence().number_of_frames())
{
  const Options o = options_of(arguments, METHOD);
  m_method = o.method;
  const Programs::Thread_limit limit(o.run.threads);
  check_scales(m_animation->sequence(), m_method, m_animation->reading().inputs.front());
  Kept_fields fields(std::move(kept));
  m_detection = detect(m_animation->sequence(), m_method, m_animation->level_memory(), fields, monitor);
  for (auto& f : fields.take_kept()) m_fields.push_back({f.kind, std::move(f.values)});
}

Detection_data::Detection_data(std::shared_ptr<const Shape_data> shape, Values field, double frame_duration,
                               double noise, const Arguments& arguments, Python_monitor& monitor)
  : m_shape(std::move(shape))
  , m_animation(std::dynamic_pointer_cast<const Animation_data>(m_shape))
  , m_frame_duration(frame_duration)
  , m_frames(field.number_of_frames())
{
  if (m_animation && m_frames != m_animation->sequence().number_of_frames())
    throw AMF::Option_error("the field has " + std::to_string(m_frames) + " frames, the animation " +
                            std::to_string(m_animation->sequence().number_of_frames()));
  const Options o = options_of(arguments, METHOD);
  m_method = o.method;
  const Programs::Thread_limit limit(o.run.threads);
  Detect_features::Method_values values = method_values(m_method, m_frames);
  if (!m_method.threshold && !m_method.relative_threshold) { // its unit is not known
    const AMF::Feature_selection any = AMF::Feature_selection::of_any_field();
    values.selection.absolute_threshold = any.absolute_threshold;
    values.selection.relative_threshold = any.relative_threshold;
  }
  if (m_method.baseline == Detect_features::Baseline::LEAST) {
    if (m_frames == 0) throw AMF::Input_error("the field has no frames");
    AMF::subtract_baseline(field, AMF::Least_value_baseline());
  }
  Detect_features::Search_result found =
      search(*m_shape, std::move(field), frame_duration, noise, m_method, values, monitor);
  m_detection.values = values;
  for (const auto& f : found.features)
    m_detection.features.push_back(m_animation ? place_on_animation(f, m_animation->sequence())
                                               : Programs::Feature(f, Vertex(Vertex::size_type(f.vertex))));
  m_detection.number_of_minima = found.number_of_minima;
  m_detection.scales = std::move(found.scales);
  m_detection.missing = found.missing;
  m_fields.push_back({Field::DEFORMATION, std::move(found.field)});
}

const Values* Detection_data::field(Field kind) const
{
  for (const Field_values& f : m_fields)
    if (f.kind == kind) return &f.values;
  return nullptr;
}

std::string Detection_data::reason() const
{
  if (!m_detection.missing || !m_animation) return std::string();
  return reason_for_none(m_animation->sequence(), m_method, m_detection);
}

AMF::IO::Result_description Detection_data::description() const
{
  if (m_animation)
    return result_description(m_animation->reading(), m_method, m_animation->animation(), m_detection);
  const AMF::Rest_shape& shape = m_shape->shape();
  AMF::IO::Result_description d;
  d.vertices = shape.number_of_vertices();
  d.faces = shape.triangles().size();
  d.frames = m_frames;
  d.frame_duration = m_frame_duration;
  d.bounding_box_diagonal = shape.bounding_box_diagonal();
  d.mean_edge_length = shape.mean_edge_length();
  d.add("diameter", shape.diameter());
  d.add("sigma_levels", m_detection.scales.sigma_levels);
  d.add("tau_levels", m_detection.scales.tau_levels);
  d.add("threshold", m_detection.values.selection.absolute_threshold);
  d.add("relative_threshold", m_detection.values.selection.relative_threshold);
  d.add("min_fit", m_detection.values.selection.min_fit);
  return d;
}

void Detection_data::write(const Arguments& arguments) const
{
  Programs::Output_options o = options_of(arguments, OUTPUT).output;
  Programs::check_outputs(o.paths(), m_animation ? m_animation->animation().files() : std::vector<std::string>());
  if (!m_animation && !o.scenes.empty())
    throw AMF::Option_error("--" + name(o.scenes.front().kind) +
                            ": a scene shows an animation; the features were found on a shape at rest");
  for (const auto& f : o.fields)
    if (field(f.kind) == nullptr)
      throw AMF::Option_error("--write-field " + name(f.kind) + ": the field was not kept; keep_fields says which are");
  if (m_animation) check_picture_frames(o.picture, m_frames);
  Programs::Result_files files(o);
  for (const auto& f : m_fields) files.write_field(f.kind, f.values);
  files.write_features(m_detection.features, description());
  if (!o.scenes.empty()) {
    Programs::Shown_scene scene{m_animation->sequence(), m_detection.features, {}, "animation"};
    scene.is_cyclic = m_method.is_cyclic;
    if (m_animation->reading().inputs.front() != "faces")
      scene.title = std::filesystem::path(m_animation->reading().inputs.front()).stem().string();
    for (const Field kind : {Field::DEFORMATION, Field::STRAIN, Field::CURVATURE})
      if (field(kind) != nullptr) scene.fields.push_back({name(kind), field(kind)});
    files.write_scenes(scene);
  }
  files.commit();
}

Values measured_field(const Animation_data& animation, Field kind, const Arguments& arguments, Python_monitor& monitor)
{
  Options o = options_of(arguments, METHOD);
  const Programs::Thread_limit limit(o.run.threads);
  std::set<Field> kept;
  if (kind != Field::DEFORMATION) { // a deformation that is made of strain alone is the strain
    o.method.alpha = 0;
    o.method.baseline = Detect_features::Baseline::NONE;
    if (kind == Field::CURVATURE) kept.insert(kind);
  }
  Kept_fields fields(std::move(kept));
  Values field = measure_deformation(animation.sequence(), o.method,
                                     method_values(o.method, animation.sequence().number_of_frames()), fields, monitor)
                     .field;
  auto all = fields.take_kept();
  return all.empty() ? std::move(field) : std::move(all.front().values);
}

AMF::Compressed_rows geodesic_balls(const Shape_data& shape, const Arguments& arguments, Python_monitor& monitor)
{
  const Options o = options_of(arguments, METHOD);
  const Programs::Thread_limit limit(o.run.threads);
  return find_balls(shape.shape(), o.method, monitor);
}

} // namespace Python_module
