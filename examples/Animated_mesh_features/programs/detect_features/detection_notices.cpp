// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detect_features/detection_notices.h"

#include "detect_features/check_scales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace Detect_features {

namespace {

using Programs::Feature;

// The ends of a range at which features are, as words, and how many are there.
struct Limit
{
  const char* what;
  double value;
  const char* unit;
  std::string remedy;
  std::size_t features = 0;
};

// Of scales `levels`, whether one lies within half a level of the first or of the last at which features may be.
bool is_at(double scale, double limit, const std::vector<double>& levels)
{
  const double half_level = 0.5 * std::log(levels[1] / levels[0]);
  return std::abs(std::log(scale / limit)) <= half_level * (1 + 1e-9);
}

std::string limits_notice(const Programs::Sequence& sequence, const Method_options& o, const Detection& d)
{
  const double worth_telling = 0.2;
  const std::size_t few = 3;
  const Searched_scales& s = d.scales;
  const double sigma[] = {s.sigma_levels[s.levels_below], s.sigma_levels[s.sigma_levels.size() - 1 - s.levels_above]};
  const double tau[] = {s.tau_levels[s.levels_below], s.tau_levels[s.tau_levels.size() - 1 - s.levels_above]};
  const bool is_resolved = !is_smallest_resolved(sequence.rest_shape(), o, sigma[0]);
  std::array<Limit, 4> limits = {
      {{"smallest sigma", sigma[0], "", is_resolved ? "--sigma-range takes smaller ones" : "a finer mesh would resolve them"},
       {"largest sigma", sigma[1], "", "--sigma-range takes larger ones"},
       {"shortest tau", tau[0], " s", "more frames in a second would resolve them"},
       {"longest tau", tau[1], " s", "--tau-range takes longer ones"}}};
  std::size_t at_limit = 0;
  for (const Feature& f : d.features) {
    if (!f.at_scale_limit) continue;
    ++at_limit;
    limits[0].features += is_at(f.sigma, sigma[0], s.sigma_levels);
    limits[1].features += is_at(f.sigma, sigma[1], s.sigma_levels);
    limits[2].features += is_at(f.tau, tau[0], s.tau_levels);
    limits[3].features += is_at(f.tau, tau[1], s.tau_levels);
  }
  if (at_limit < few || double(at_limit) <= worth_telling * double(d.features.size())) return "";
  const Limit& commonest =
      *std::max_element(limits.begin(), limits.end(), [](const Limit& a, const Limit& b) { return a.features < b.features; });
  std::ostringstream os;
  os.precision(3);
  os << "note: " << at_limit << " of " << d.features.size() << " features are at a limit of the scales";
  if (commonest.features > 0 && o.preset == Preset::CALIBRATED)
    os << ", " << commonest.features << " of them at the " << commonest.what << ", " << commonest.value << commonest.unit
       << "; " << commonest.remedy;
  os << '\n';
  return os.str();
}

std::string coarse_notice(const Programs::Sequence& sequence, const Method_options& o, const Detection& d)
{
  const double sigma = d.scales.sigma_levels[d.scales.levels_below];
  if (!o.sigma.text.empty() || !is_limited_by_mesh(sequence.rest_shape(), o, sigma)) return "";
  return "note: the mesh is coarse: " + coarse_mesh(sequence.rest_shape(), o) + '\n';
}

// A frame that is broken, or an explosion, deforms more than anything that a body does.
std::string burst_notice(const Detection& d)
{
  const double dwarfing = 20;
  const std::size_t few = 4;
  if (d.features.size() < few) return "";
  std::vector<double> others;
  const Feature& strongest = d.features.front();
  for (const Feature& f : d.features)
    if (f.frame != strongest.frame) others.push_back(f.strength);
  if (others.size() < few - 1) return "";
  const auto largest = std::max_element(others.begin(), others.end());
  if (!(strongest.strength > dwarfing * *largest)) return "";
  std::ostringstream os;
  os.precision(2);
  os << "note: what happens in frame " << strongest.frame << " is " << strongest.strength / *largest
     << " times as strong as anything at another time: look whether that frame is broken; --skip-bad-frames leaves out "
        "those that clearly are\n";
  return os.str();
}

// Ends that do not meet make an event of their own, all over the body.
std::string cycle_notice(const Method_options& o, const Detection& d)
{
  const double worth_telling = 1.5;
  if (!o.is_cyclic || d.closing_step <= worth_telling) return "";
  std::ostringstream os;
  os.precision(2);
  os << "note: --cyclic: from the last frame to the first the deformation changes by " << d.closing_step
     << " times as much as it ever does from a frame to the next: look whether the frames are one whole period\n";
  return os.str();
}

} // namespace

std::string detection_notices(const Programs::Sequence& sequence, const Method_options& options, const Detection& detection)
{
  if (detection.features.empty()) return cycle_notice(options, detection); // the summary tells why there are none
  return cycle_notice(options, detection) + burst_notice(detection) + limits_notice(sequence, options, detection) +
         coarse_notice(sequence, options, detection);
}

} // namespace Detect_features
