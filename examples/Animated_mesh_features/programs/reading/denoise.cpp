// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/denoise.h"

#include "reading/Rest_comparison.h"

#include <CGAL/Animated_mesh_features/Animation/Canonical_shape.h>
#include <CGAL/Animated_mesh_features/Animation/denoised_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/position_noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>

namespace AMF = CGAL::Animated_mesh_features;

namespace Programs {

namespace {

// Root of the mean squared distance from the mean point.
template <class Point_at>
double spread(std::size_t n, const Point_at& point)
{
  AMF::Rest_shape::Point mean = AMF::Rest_shape::Point::Zero();
  for (std::size_t v = 0; v < n; ++v) mean += point(v);
  mean /= double(n);
  double sum = 0;
  for (std::size_t v = 0; v < n; ++v) sum += (point(v) - mean).squaredNorm();
  return std::sqrt(sum / double(n));
}

// Not by edges, which noise makes longer. A body that crouches is hardly half as large as one that stands.
bool is_in_same_unit(const Rest_points& points, const Sequence& sequence)
{
  const double most = 2;
  const double given = spread(points.size(), [&](std::size_t v) { return points[v]; });
  const double seen =
      spread(points.size(), [&](std::size_t v) { return sequence.trajectories().point(v, sequence.number_of_frames() / 2); });
  return seen < most * given && given < most * seen;
}

double mean_edge(const Sequence& sequence)
{
  const AMF::Rest_shape& shape = sequence.rest_shape(); // the first frame
  double sum = 0;
  for (const double length : shape.lengths()) sum += length;
  return sum / double(shape.lengths().size());
}

} // namespace

Denoised denoise(const Reading_options& o, const Mesh& mesh, const std::function<Rest_points()>& given,
                 std::optional<Sequence>& sequence, std::vector<std::string>& notices, AMF::Any_visitor visitor)
{
  const double usual = 0.05; // of the mean edge: see position_noise()
  const double noise = AMF::position_noise(sequence->rest_shape(), sequence->trajectories());
  const double share = noise / mean_edge(*sequence);
  const bool is_noisy = share > usual;
  if (!(noise > 0) || (!is_noisy && o.denoise != Denoise::ALWAYS)) return {};
  std::ostringstream os;
  os.precision(3);
  os << "vertices tremble from frame to frame by " << noise << " in each coordinate, " << 100 * share
     << " % of the mean edge: ";
  if (o.denoise == Denoise::NEVER) {
    notices.push_back(os.str() + "small and short features may be noise (--denoise auto takes it out)");
    return {};
  }
  Denoised result;
  result.noise = noise;
  const Rest_points points = given();
  if (!points.empty()) result.frame = frame_at(points, *sequence);
  const bool has_shape = !points.empty() && !result.frame && is_in_same_unit(points, *sequence);
  AMF::Rest_shape shape = sequence->rest_shape();
  shape.set_points(has_shape ? points : AMF::canonical_shape(shape, sequence->trajectories(), visitor));
  auto clean = AMF::denoised_trajectories(shape, sequence->trajectories(), noise, visitor);
  const double frame_duration = sequence->frame_duration();
  sequence.emplace(mesh, std::move(clean.x), std::move(clean.y), std::move(clean.z), frame_duration);
  notices.push_back(os.str() + "taken out, as far as neighbours move alike (--denoise never leaves it in)");
  return result;
}

} // namespace Programs
