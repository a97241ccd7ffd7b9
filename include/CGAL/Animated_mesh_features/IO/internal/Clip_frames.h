// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CLIP_FRAMES_H
#define CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CLIP_FRAMES_H

#include <CGAL/Animated_mesh_features/IO/Clip_sampling.h>
#include <CGAL/Animated_mesh_features/IO/Coincident_vertices.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model.h>
#include <CGAL/Animated_mesh_features/IO/Keyframed_model_evaluator.h>
#include <CGAL/Animated_mesh_features/IO/internal/numbers.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {
namespace internal {

// The frames of a clip, with the vertices of the file.
class Clip_frames
{
public:
  typedef Keyframed_model_evaluator::Points Points;

  Clip_frames(const Keyframed_model& model, Keyframed_model::Clip clip, const Clip_sampling& sampling,
              const std::string& file)
    : m_clip(std::move(clip))
    , m_name(file + ", clip \"" + m_clip.name + "\"")
    , m_times(frame_times(m_clip, sampling, file))
    , m_evaluate(model, m_clip, file)
  {}
  Clip_frames(const Clip_frames&) = delete;
  Clip_frames& operator=(const Clip_frames&) = delete;

  std::size_t size() const { return m_times.size(); }
  std::string name(std::size_t f) const { return m_name + ", frame " + std::to_string(f); }
  void get(std::size_t f, Points& points) const { m_evaluate(m_times[f], points); }
  std::vector<char> mirrored_parts() const { return m_evaluate.mirrored_parts(m_times[0]); }

  // from 0 at the first one
  std::vector<double> times() const
  {
    std::vector<double> times;
    for (std::size_t f = 0; f < size(); ++f) times.push_back(double(f) * (m_times[1] - m_times[0]));
    return times;
  }

private:
  Keyframed_model::Clip m_clip;
  std::string m_name;
  std::vector<double> m_times; // of the clip
  Keyframed_model_evaluator m_evaluate;
};

inline void check_finite(const Clip_frames::Points& points, const std::string& name)
{
  for (std::size_t v = 0; v < points.size(); ++v)
    for (double x : points[v])
      if (!is_finite(x)) throw Input_error(name + ": the position of vertex " + std::to_string(v) + " is not finite");
}

// Vertices that are in the same place in all frames; the positions in the first frame.
inline Coincident_vertices coincident_vertices(const Clip_frames& frames, std::size_t number_of_vertices,
                                               Clip_frames::Points& first_points)
{
  Coincident_vertices coincident(number_of_vertices);
  Clip_frames::Points points;
  for (std::size_t f = 0; f < frames.size() && !(f > 0 && coincident.all_apart()); ++f) {
    frames.get(f, points);
    check_finite(points, frames.name(f));
    coincident.add_frame(points);
    if (f == 0) first_points = points;
  }
  return coincident;
}

} // namespace internal
} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_IO_INTERNAL_CLIP_FRAMES_H
