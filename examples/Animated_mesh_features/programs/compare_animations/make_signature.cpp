// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare_animations/make_signature.h"

#include "compare_animations/Analysed_animation.h"
#include "compare_animations/Signature_cache.h"
#include "running/Interruption.h"
#include "running/Progress_bar.h"
#include "running/tell.h"

#include <CGAL/Animated_mesh_features/IO/read_json.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <variant>

namespace AMF = CGAL::Animated_mesh_features;
using namespace Programs;

namespace Compare_animations {

namespace {

// Whether the features lie no farther apart than the animation is large.
void check_units(const AMF::IO::Feature_file_data& data, const std::string& file)
{
  std::array<double, 3> low{}, high{};
  for (std::size_t i = 0; i < data.features.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = data.features[i].rest_position[k];
      low[k] = i == 0 ? x : (std::min)(low[k], x);
      high[k] = i == 0 ? x : (std::max)(high[k], x);
    }
  const double extent = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  if (extent > 1.01 * data.description.bounding_box_diagonal)
    throw AMF::Input_error(file + ": features are " + std::to_string(extent) +
                           " apart at rest, and the bounding box has a diagonal of " +
                           std::to_string(data.description.bounding_box_diagonal) + ": lengths have different units");
}

bool is_cyclic(const AMF::IO::Result_description& d)
{
  for (const auto& [name, value] : d.parameters)
    if (const bool* flag = std::get_if<bool>(&value); name == "cyclic" && flag != nullptr) return *flag;
  return false;
}

// Errors of what knows of no files name `file`.
template <class Compute>
Signature named(const std::string& file, const Compute& compute)
{
  try {
    return compute();
  } catch (const AMF::Input_error& e) {
    throw AMF::Input_error(file + ": " + e.what() +
                           " (--rate tells how many there are in a second, --fps how many frames)");
  }
}

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
  check_units(data, item.feature_file);
  AMF::Activity_options options = s.activity;
  options.is_cyclic = is_cyclic(d);
  return named(item.feature_file, [&] {
    return AMF::animation_signature(data.features, d.vertices, d.frames, d.frame_duration, d.bounding_box_diagonal,
                                    options);
  });
}

} // namespace

Signature make_signature(const Item& item, const Settings& s)
{
  if (!item.feature_file.empty()) return signature_of_features(item, s);
  const Signature_cache cache(item, s);
  Signature result;
  if (cache.find(result)) return result;
  const Analysed_animation animation(item, s);
  result = named(item.reading.inputs.back(), [&] { return animation.signature(s); });
  cache.keep(result);
  return result;
}

Signature make_signature(const Item& item, const Settings& s, std::unique_ptr<Analysed_animation>& animation)
{
  const Signature_cache cache(item, s);
  animation = std::make_unique<Analysed_animation>(item, s);
  const Signature result = named(item.reading.inputs.back(), [&] { return animation->signature(s); });
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
