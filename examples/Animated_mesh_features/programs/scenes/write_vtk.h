// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_WRITE_VTK_H
#define PROGRAMS_SCENES_WRITE_VTK_H

#include <CGAL/Animated_mesh_features/IO/Output_folder.h>
#include "scenes/Scene.h"
#include "scenes/feature_in_frame.h"
#include <CGAL/Animated_mesh_features/IO/internal/Text_output.h>
#include "scenes/Vtp_output.h"
#include "scenes/for_each_frame.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// "surface_0007.vtp": with as many digits for all frames, so that they sort.
inline std::string vtp_name(const char* series, std::size_t frame, std::size_t number_of_frames)
{
  const std::size_t least_digits = 4;
  const std::size_t digits = (std::max)(least_digits, std::to_string(number_of_frames - 1).size());
  const std::string number = std::to_string(frame);
  return std::string(series) + '_' + std::string(digits - number.size(), '0') + number + ".vtp";
}

inline void write_pvd(std::ostream& os, const char* series, std::size_t number_of_frames, double frame_duration)
{
  Text_output out(os);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"" << vtk_byte_order()
      << "\">\n<Collection>\n";
  for (std::size_t f = 0; f < number_of_frames; ++f)
    out << "<DataSet timestep=\"" << double(f) * frame_duration << "\" part=\"0\" file=\""
        << vtp_name(series, f, number_of_frames) << "\"/>\n";
  out << "</Collection>\n</VTKFile>\n";
  out.flush();
}

// The surface in one frame. Only its positions and fields change from frame to frame, but every file is a whole.
template <class Index>
class Vtk_surface
{
public:
  template <class Triangles>
  explicit Vtk_surface(const Triangles& triangles)
  {
    m_corners.reserve(3 * triangles.size());
    for (const auto& t : triangles)
      for (auto v : t) {
        m_corners.push_back(static_cast<Index>(v));
        if (m_corners.size() % 3 == 0) m_ends.push_back(static_cast<Index>(m_corners.size()));
      }
  }

  template <class FT>
  void write(std::ostream& os, const Scene_frame& frame, const std::vector<Scene_field<FT>>& fields, double time) const
  {
    Vtp_output out(frame.xyz.size() / 3, 0, m_ends.size(), time);
    if (fields.empty())
      out.begin("PointData");
    else
      out.begin("PointData", fields.front().name);
    for (std::size_t i = 0; i < fields.size(); ++i) out.array(fields[i].name, frame.fields[i]);
    out.end("PointData");
    out.begin("Points");
    out.array("Points", frame.xyz, 3);
    out.end("Points");
    out.begin("Polys");
    out.array("connectivity", m_corners);
    out.array("offsets", m_ends);
    out.end("Polys");
    out.write(os);
  }

private:
  std::vector<Index> m_corners, m_ends;
};

// The features that live in frame `f`; all arrays are there even if none does, so that what shows them finds them.
template <class Sequence, class Feature>
void write_vtk_features(std::ostream& os, const Scene<Sequence, Feature>& scene, std::size_t f)
{
  const double clock = scene.sequence.frame_duration();
  std::vector<double> points, sigma, tau, time, strength, radius, opacity;
  std::vector<std::int64_t> vertex, frame, rank, ends;
  for (std::size_t i = 0; i < scene.features.size(); ++i) {
    const Feature& feature = scene.features[i];
    if (!lives_in_frame(feature, f, clock)) continue;
    for (double x : position_in_frame(scene.sequence, feature, f)) points.push_back(x);
    sigma.push_back(feature.sigma);
    tau.push_back(feature.tau);
    time.push_back(feature.time);
    strength.push_back(feature.strength());
    radius.push_back(feature.radius());
    opacity.push_back(opacity_in_frame(feature, f, clock));
    vertex.push_back(static_cast<std::int64_t>(feature.vertex_index));
    frame.push_back(static_cast<std::int64_t>(feature.frame));
    rank.push_back(static_cast<std::int64_t>(i));
    ends.push_back(static_cast<std::int64_t>(rank.size()));
  }
  std::vector<std::int64_t> points_of_vertices(rank.size());
  std::iota(points_of_vertices.begin(), points_of_vertices.end(), 0);

  Vtp_output out(rank.size(), rank.size(), 0, double(f) * clock);
  out.begin("PointData", "strength");
  out.array("sigma", sigma);
  out.array("tau", tau);
  out.array("time", time);
  out.array("strength", strength);
  out.array("radius", radius);
  out.array("opacity", opacity);
  out.array("vertex", vertex);
  out.array("frame", frame);
  out.array("rank", rank);
  out.end("PointData");
  out.begin("Points");
  out.array("Points", points, 3);
  out.end("Points");
  out.begin("Verts");
  out.array("connectivity", points_of_vertices);
  out.array("offsets", ends);
  out.end("Verts");
  out.write(os);
}

template <class Index, class Sequence, class Feature>
void write_vtk_surfaces(Output_folder& folder, const Scene<Sequence, Feature>& scene)
{
  const std::size_t frames = scene.sequence.number_of_frames();
  const Vtk_surface<Index> surface(scene.sequence.rest_shape().triangles());
  for_each_frame(scene, [&](const Scene_frame& frame) {
    folder.write(vtp_name("surface", frame.index, frames), [&](std::ostream& os) {
      surface.write(os, frame, scene.fields, double(frame.index) * scene.sequence.frame_duration());
    });
  });
}

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a scene as two time series for ParaView and whatever else reads VTK's XML files.

- `surface.pvd` with a `surface_0000.vtp` for each frame: the surface, with the fields of the scene as point data under
  their names, in single precision, the first of them shown first;
- `features.pvd` with a `features_0000.vtp` for each frame: the features that live in it (see `lives_in_frame()`) as
  points that move with the surface. Point data are `sigma`, `tau`, `time`, `strength` and `radius`, `opacity` (see
  `opacity_in_frame()`), `vertex` and `frame` counted from 0, and `rank`, 0 for the strongest feature. A frame in which no
  feature lives has a file without points.

Times are in seconds from the first frame, lengths in the unit of the animation.

In ParaView: open both; filter Glyph on the features, glyph type Sphere of radius 1, scaled by `radius` with scale factor
1, and all points.

Every frame holds the connectivity: about 12 bytes for each of the vertices, 16 for each of the triangles, and 4 for each
value of a field.

\param folder written, but not committed.
\param scene see `check_scene()` for what is thrown if it does not fit together.

\throw Output_error if a file cannot be written, or a coordinate or a value exceeds single precision.
*/
template <class Sequence, class Feature>
void write_vtk(Output_folder& folder, const Scene<Sequence, Feature>& scene)
{
  check_scene(scene);
  const std::size_t frames = scene.sequence.number_of_frames();
  // the largest number is the last end of a triangle
  if (3 * scene.sequence.rest_shape().triangles().size() <= std::size_t((std::numeric_limits<std::int32_t>::max)()))
    internal::write_vtk_surfaces<std::int32_t>(folder, scene);
  else
    internal::write_vtk_surfaces<std::int64_t>(folder, scene);
  for (std::size_t f = 0; f < frames; ++f)
    folder.write(internal::vtp_name("features", f, frames),
                 [&](std::ostream& os) { internal::write_vtk_features(os, scene, f); });
  for (const char* series : {"surface", "features"})
    folder.write(std::string(series) + ".pvd", [&](std::ostream& os) {
      internal::write_pvd(os, series, frames, scene.sequence.frame_duration());
    });
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_SCENES_WRITE_VTK_H
