// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/run.h"

#include "detect_features/check_scales.h"
#include "detect_features/detect.h"
#include "detect_features/detection_notices.h"
#include "detect_features/feature_table.h"
#include "detect_features/reason_for_none.h"
#include "detect_features/report.h"
#include "options/Names.h"
#include "output/Html_file.h"
#include "output/Result_files.h"
#include "output/Wanted_fields.h"
#include "output/check_outputs.h"
#include "reading/Animation.h"
#include "reading/Memory_plan.h"
#include "reading/animation_report.h"
#include "running/Interruption.h"
#include "running/Monitor.h"
#include "running/Stage_log.h"
#include "running/Thread_limit.h"
#include "running/tell.h"
#include "views/Scene_views.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>

using namespace Programs;

namespace Detect_features {

namespace {

Memory_plan memory_plan(const Run_options& o)
{
  return Memory_plan(o.memory, o.scratch_directory.empty() ? default_scratch_directory() : o.scratch_directory);
}

// The animation and the features as writers of scenes take them.
Shown_scene scene(const Command_line& c, const Animation& animation, const Detection& detection,
                  const Wanted_fields& fields)
{
  std::filesystem::path first = c.reading.inputs.front();
  if (!first.has_filename()) first = first.parent_path(); // of "frames/"
  Shown_scene s{animation.sequence(), detection.features, {}, first.stem().string()};
  s.is_cyclic = c.method.is_cyclic;
  for (const auto& f : fields.kept()) s.fields.push_back({name(f.kind), &f.values});
  return s;
}

// Each line after the name of what it is about.
std::string lines_after(const std::string& name, const std::string& lines)
{
  if (name.empty()) return lines;
  std::string result;
  for (std::size_t first = 0, end; first < lines.size(); first = end) {
    end = (std::min)(lines.find('\n', first), lines.size() - 1) + 1;
    result += name + lines.substr(first, end - first);
  }
  return result;
}

Outcome outcome_of(const Animation& animation, const Method_options& method, const Detection& detection)
{
  Outcome outcome;
  outcome.frames = animation.sequence().number_of_frames();
  outcome.duration = double(outcome.frames - 1) * animation.sequence().frame_duration();
  outcome.features = detection.features.size();
  if (!detection.features.empty())
    outcome.strongest = detection.features.front();
  else
    outcome.reason = reason_for_none(animation.sequence(), method, detection);
  return outcome;
}

} // namespace

Outcome run(const Command_line& c, const std::string& name, const std::string& progress)
{
  const auto say = [&](const std::string& lines) { tell(lines_after(name, lines)); };
  const Thread_limit thread_limit(c.run.threads);
  Stage_log log;
  log.begin("reading");
  Memory_plan plan = memory_plan(c.run);
  std::string page_notice;
  const auto choose_memory = [&](std::size_t vertices, std::size_t frames) {
    page_notice = html_notice(c.output, vertices, frames);
    return plan.decide(vertices, frames, c.output.extra_fields());
  };
  std::optional<Monitor> monitor(std::in_place, log, !c.run.quiet, progress);
  const Animation animation(c.reading, choose_memory, *monitor);
  monitor.reset(); // what is told now is not to stand beside a progress bar
  log.end();
  const Sequence& sequence = animation.sequence();
  plan.refine(sequence.rest_shape());
  check_outputs(c.output.paths(), animation.files());
  // now rather than after hours of computation
  check_picture_frames(c.output.picture, sequence.number_of_frames());
  if (c.run.verbose) say(animation_report(c.reading, animation) + plan.report() + "\n");
  if (!c.run.quiet) say(page_notice + reading_notices(c.reading, animation));
  check_scales(sequence, c.method, c.reading.rest.file.empty() ? c.reading.inputs.front() : c.reading.rest.file);
  if (!c.run.quiet) say(counts_notice(sequence, c.method));

  const Interruption interruption; // before there is anything to be left on a disk
  Result_files files(c.output);
  Wanted_fields fields(c.output, files, log);
  monitor.emplace(log, !c.run.quiet, progress);
  const Detection detection = detect(sequence, c.method, plan.level_memory(), fields, *monitor);
  monitor.reset();
  Interruption::check();
  Shown_scene shown = scene(c, animation, detection, fields);
  std::optional<Scene_views> views;
  if (c.output.has_chosen_views()) {
    monitor.emplace(log, !c.run.quiet, progress);
    views = scene_views(shown, c.output.picture.up_axis, *monitor);
    monitor.reset();
    shown.views = &*views;
  }
  {
    const Stage_log::Scope stage(log, "writing");
    files.write_features(detection.features, result_description(c.reading, c.method, animation, detection));
    Interruption::check();
    files.write_scenes(shown);
    Interruption::check();
    files.commit();
  }
  if (c.run.verbose) say(detection_report(detection) + log.report());
  if (c.output.is_table_shown) std::cout << feature_table(detection.features, animation.origins()) << std::flush;
  const Outcome outcome = outcome_of(animation, c.method, detection);
  if (c.run.quiet) return outcome;
  const double writing = log.seconds("writing");
  say(detection_notices(sequence, c.method, detection));
  if (name.empty()) say(summary(c.output, animation, c.method, detection, {log.total_seconds() - writing, writing}));
  return outcome;
}

void run(const Command_line& c)
{
  run(c, "", "");
}

} // namespace Detect_features
