// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/make_signature.h"

#include "compare_animations/Signature_cache.h"
#include "detect_features/detect.h"
#include "output/Result_files.h"
#include "output/Wanted_fields.h"
#include "reading/Animation.h"
#include "reading/Memory_plan.h"
#include "running/Interruption.h"
#include "running/Monitor.h"
#include "running/Progress_bar.h"
#include "running/Stage_log.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;
using namespace Programs;

namespace Compare_animations {

namespace {

Signature signature_of_features(const Item& item, const Settings& s)
{
  const AMF::IO::Feature_file_data data = AMF::IO::read_json(item.feature_file);
  const AMF::IO::Result_description& d = data.description;
  for (std::size_t i = 0; i < data.features.size(); ++i)
    if (!(data.features[i].sigma > 0) || !(data.features[i].tau > 0))
      throw AMF::Input_error(item.feature_file + ": features[" + std::to_string(i) +
                             "]: sigma and tau must be positive");
  if (d.frames < 3 || !(d.frame_duration > 0) || !(d.bounding_box_diagonal > 0))
    throw AMF::Input_error(item.feature_file + ": the animation has " + std::to_string(d.frames) +
                           " frames, or no size, or no time between frames; there is nothing to compare");
  return AMF::animation_signature(data.features, d.vertices, d.frames, d.frame_duration, d.bounding_box_diagonal,
                                  s.activity);
}

Signature signature_of_animation(const Item& item, const Settings& s)
{
  Memory_plan plan(s.run.memory,
                   s.run.scratch_directory.empty() ? default_scratch_directory() : s.run.scratch_directory);
  const Animation animation(item.reading,
                            [&](std::size_t vertices, std::size_t frames) { return plan.decide(vertices, frames, 1); });
  plan.refine(animation.sequence().rest_shape());
  Stage_log log;
  Output_options outputs; // of nothing, but the deformation is kept as for a page
  Result_files files(outputs);
  outputs.scenes.push_back({Scene_format::HTML, ""});
  Wanted_fields fields(outputs, files, log);
  Monitor monitor(log, false);
  const Detect_features::Detection detection =
      Detect_features::detect(animation.sequence(), s.method, plan.level_memory(), fields, monitor);
  const std::vector<AMF::Feature_point> features(detection.features.begin(), detection.features.end());
  const auto make = [&](const auto& descriptor) {
    return AMF::animation_signature(animation.sequence().rest_shape(), fields.kept().front().values,
                                    animation.sequence().frame_duration(), features, s.activity, descriptor);
  };
  return s.is_oriented ? make(AMF::Oriented_gradient_histogram()) : make(AMF::Rotation_free_gradient_histogram());
}

} // namespace

Signature make_signature(const Item& item, const Settings& s)
{
  if (!item.feature_file.empty()) return signature_of_features(item, s);
  const Signature_cache cache(item, s);
  Signature result;
  if (cache.find(result)) return result;
  result = signature_of_animation(item, s);
  cache.keep(result);
  return result;
}

std::size_t make_signatures(std::vector<Item>& items, std::vector<Signature>& signatures, const Settings& s)
{
  Progress_bar bar(!s.run.quiet);
  std::vector<Item> good;
  std::size_t broken = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    bar.show(items[i].name, double(i) / double(items.size()));
    try {
      signatures.push_back(make_signature(items[i], s));
      good.push_back(items[i]);
    } catch (const AMF::Input_error& e) {
      Interruption::check();
      bar.clear();
      tell("compare_animations: " + items[i].name + " is left out: " + e.what() + "\n");
      ++broken;
    }
    Interruption::check();
  }
  bar.clear();
  items.swap(good);
  return broken;
}

} // namespace Compare_animations
