// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify_animation/run.h"

#include "evaluate_features/Feature_file.h"
#include "output/check_outputs.h"
#ifdef DETECT_FEATURES_WITH_PICTURES
  #include "plots/plot_format.h"
  #include "plots/write_curves.h"
#endif
#include "reading/Animation.h"
#include "running/Interruption.h"
#include "running/Progress_bar.h"
#include "running/Thread_limit.h"
#include "running/tell.h"
#include "simplify_animation/Level_report.h"
#include "simplify_animation/Measurement.h"
#include "simplify_animation/Source_model.h"
#include "simplify_animation/read_model.h"
#include "simplify_animation/simplify.h"
#include "simplify_animation/wanted_levels.h"
#include "simplify_animation/write_levels.h"

#include <CGAL/Animated_mesh_features/IO/Output_file.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/memory/Field_memory.h>

#include <algorithm>
#include <iostream>
#include <optional>

namespace AMF = CGAL::Animated_mesh_features;

namespace Simplify_animation {

namespace {

typedef std::vector<AMF::Feature_point> Features;

Features read_features(const std::string& path, const Programs::Animation& animation)
{
  if (path.empty()) return {};
  const Evaluate_features::Feature_file file(path);
  const std::size_t n = animation.sequence().number_of_vertices(), frames = animation.sequence().number_of_frames();
  if (file.data.description.vertices != n || file.frames() != frames)
    throw AMF::Input_error(path + ": is about " + std::to_string(file.data.description.vertices) + " vertices in " +
                           std::to_string(file.frames()) + " frames, the animation has " + std::to_string(n) + " in " +
                           std::to_string(frames));
  return file.features();
}

Source_model source_model(const Command_line& o, const Programs::Animation& animation)
{
  Source_model source;
  if (o.form != Form::GLB && !o.keep_seams) return source;
  source.model = read_model(o.reading);
  if (!o.keep_seams) return source;
  const auto& parts = source.model->parts;
  if (std::none_of(parts.begin(), parts.end(), [&](const AMF::IO::Keyframed_model::Part& part) {
        return !source.model->geometries[part.geometry].texture_coordinates.empty();
      }))
    throw AMF::Input_error(o.reading.inputs.front() +
                           ": has no texture coordinates, of which --keep-seams keeps seams");
  source.texture.emplace(*source.model, animation.origins(), animation.sequence().rest_shape());
  return source;
}

void tell_reading(const Command_line& o, const Programs::Animation& animation)
{
  if (o.running.quiet) return;
  for (const std::string& notice : animation.notices()) Programs::tell("simplify_animation: " + notice + "\n");
  if (!o.running.verbose) return;
  for (const std::string& remark : animation.remarks()) Programs::tell(remark + "\n");
}

void tell_what_is_left(const Command_line& o, const std::vector<std::size_t>& wanted,
                       const AMF::Simplified_animation& result)
{
  if (o.running.quiet || o.error) return;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (result.levels[i].binding.size() > wanted[i])
      Programs::tell(
          "simplify_animation: " + std::to_string(result.levels[i].binding.size()) + " vertices are left where " +
          std::to_string(wanted[i]) +
          " were wanted: no other edge can be collapsed without turning triangles over or changing the topology" +
          (o.keep_seams ? ", or seams" : "") + "\n");
}

// All are complete before one takes its place.
class Reports
{
public:
  Reports(const Command_line& o, const Level_report& report, const AMF::Simplified_animation& result)
  {
    write(m_json, o.json, [&](std::ostream& os) {
      os << json_of(report).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    });
#ifdef DETECT_FEATURES_WITH_PICTURES
    write(m_plot, o.plot,
          [&](std::ostream& os) { write_curves(os, curves_of(report), Programs::plot_format("--plot", o.plot)); });
#endif
    write(m_binding, o.binding, [&](std::ostream& os) { os << binding_text(result); });
  }

  void commit()
  {
    for (auto* file : {&m_json, &m_plot, &m_binding})
      if (*file) (*file)->commit();
  }

private:
  template <class Write>
  static void write(std::optional<AMF::IO::Output_file>& file, const std::string& path, const Write& write)
  {
    if (path.empty()) return;
    file.emplace(path);
    write(file->stream());
    file->stream().flush();
    file->check();
  }

  std::optional<AMF::IO::Output_file> m_json, m_plot, m_binding;
};

std::vector<std::string> all_outputs(const Command_line& o, std::size_t levels)
{
  std::vector<std::string> outputs = level_files(o, levels);
  for (const std::string& path : {o.json, o.plot, o.binding})
    if (!path.empty()) outputs.push_back(path);
  return outputs;
}

std::vector<std::string> all_inputs(const Command_line& o)
{
  std::vector<std::string> inputs = o.reading.paths();
  inputs.insert(inputs.end(), o.further.begin(), o.further.end());
  if (!o.features.empty()) inputs.push_back(o.features);
  return inputs;
}

} // namespace

void run(const Command_line& o)
{
  const std::size_t levels = o.error ? 1 : (std::max)(o.vertices.size(), o.ratios.size());
  Programs::check_outputs(all_outputs(o, levels), all_inputs(o));
  if (o.form == Form::GLB) check_is_model(o.reading, "--format glb");
  if (o.keep_seams) check_is_model(o.reading, "--keep-seams");
  const Programs::Thread_limit threads(o.running.threads);
  const Programs::Interruption interruption;
  const Programs::Animation animation(o.reading, [](std::size_t, std::size_t) { return AMF::Field_memory::heap(); });
  tell_reading(o, animation);
  const Programs::Sequence& sequence = animation.sequence();
  const Features features = read_features(o.features, animation);

  AMF::Simplification_options method = simplification_options(o);
  method.vertices = wanted_levels(o, sequence.rest_shape());
  const Source_model source = source_model(o, animation);
  if (source.texture) method.fixed_vertices = source.texture->seam_vertices();
  if (method.vertices.back() <= method.fixed_vertices.size() && !o.error)
    throw AMF::Option_error("--keep-seams: " + std::to_string(method.vertices.back()) +
                            " vertices are wanted, but the texture is cut along " +
                            std::to_string(method.fixed_vertices.size()) + ", which stay");
  AMF::Simplified_animation result;
  {
    Programs::Progress_bar bar(!o.running.quiet);
    result = simplify(sequence, method, features, o.strength.value_or(0), [&](double fraction) {
      bar.show("simplification", fraction);
      return Programs::Interruption::signal() == 0;
    });
  }
  tell_what_is_left(o, method.vertices, result);
  Level_report report = empty_report(sequence, result);
  report.title = o.reading.inputs.front();
  if (o.measures()) {
    const Measurement measure(sequence, features);
    report.has_regions = measure.has_regions();
    if (o.error) keep_coarsest_within(*o.error, report.diagonal, measure, result);
    for (const AMF::Animation_level& level : result.levels) report.levels.push_back(measure(level));
  }
  Programs::Interruption::check();
  Reports reports(o, report, result);
  write_levels(o, sequence, animation.origins(), source, result);
  reports.commit();
  const bool is_taken = o.json == "-" || o.plot == "-" || o.binding == "-"; // the standard output
  if (!o.running.quiet && !is_taken) std::cout << Programs::terminal_text(text_of(report)) << std::flush;
}

} // namespace Simplify_animation
