// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/write_vtk.h"

#include "scenes/Vtp_output.h"
#include "scenes/feature_in_frame.h"
#include "scenes/for_each_frame.h"
#include "scenes/paraview_script.h"
#include "scenes/surface_shapes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <vector>

using CGAL::Animated_mesh_features::IO::Output_folder;

namespace Programs {

namespace {

void write_pvd(std::ostream& os, const std::string& series, std::size_t number_of_frames, double frame_duration)
{
  std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"";
  xml += vtk_byte_order();
  xml += "\">\n<Collection>\n";
  for (std::size_t f = 0; f < number_of_frames; ++f) {
    const std::string time = nlohmann::json(double(f) * frame_duration).dump(); // all digits, in any locale
    xml += "<DataSet timestep=\"" + time + "\" part=\"0\" file=\"" + vtp_name(series, f, number_of_frames) + "\"/>\n";
  }
  os << xml << "</Collection>\n</VTKFile>\n";
}

// The surface in one frame. Only its positions and fields change from frame to frame, but every file is a whole.
template <class Index>
class Vtk_surface
{
public:
  explicit Vtk_surface(const Triangles& triangles)
    : m_triangles(triangles)
  {
    m_corners.reserve(3 * triangles.size());
    for (const auto& t : triangles) {
      for (auto v : t) m_corners.push_back(static_cast<Index>(v));
      m_ends.push_back(static_cast<Index>(m_corners.size()));
    }
  }

  void write(std::ostream& os, const Scene_frame& frame, const std::vector<Scene_field>& fields, double time) const
  {
    const std::vector<float> normals = vertex_normals(frame.xyz, m_triangles);
    Vtp_output out(frame.xyz.size() / 3, 0, m_ends.size(), time);
    out.begin_point_data(fields.empty() ? std::string() : fields.front().name, "Normals");
    out.array("Normals", normals, 3);
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
  const Triangles& m_triangles;
  std::vector<Index> m_corners, m_ends;
};

// The features that live in frame `f`; all arrays are there even if none does, so that what shows them finds them.
class Vtk_features
{
public:
  Vtk_features(const Shown_scene& scene, std::size_t f)
    : m_frame_time(double(f) * scene.sequence.frame_duration())
  {
    const double frame_duration = scene.sequence.frame_duration();
    for (std::size_t i = 0; i < scene.features.size(); ++i) {
      const Shown_feature& feature = scene.features[i];
      if (!lives_in_frame(feature, f, frame_duration, period(scene))) continue;
      for (double x : position_in_frame(scene.sequence, feature, f)) m_points.push_back(x);
      m_sigma.push_back(feature.sigma);
      m_tau.push_back(feature.tau);
      m_time.push_back(feature.time);
      m_strength.push_back(feature.strength);
      m_amplitude.push_back(feature.amplitude);
      m_fit.push_back(feature.fit);
      m_radius.push_back(feature.radius());
      m_opacity.push_back(opacity_in_frame(feature, f, frame_duration, period(scene)));
      m_vertex.push_back(static_cast<std::int64_t>(feature.vertex_index));
      m_frame.push_back(static_cast<std::int64_t>(feature.frame));
      m_rank.push_back(static_cast<std::int64_t>(i + 1));
      m_place.push_back(static_cast<std::int64_t>(feature.place + 1));
      m_parent.push_back(feature.parent == Shown_feature::none ? 0 : static_cast<std::int64_t>(feature.parent + 1));
      m_at_scale_limit.push_back(feature.at_scale_limit ? 1 : 0);
    }
  }

  void write(std::ostream& os) const
  {
    std::vector<std::int64_t> points(m_rank.size()), ends(m_rank.size()); // of vertices, of one point each
    std::iota(points.begin(), points.end(), 0);
    std::iota(ends.begin(), ends.end(), 1);
    Vtp_output out(m_rank.size(), m_rank.size(), 0, m_frame_time);
    out.begin_point_data("strength");
    out.array("sigma", m_sigma);
    out.array("tau", m_tau);
    out.array("time", m_time);
    out.array("strength", m_strength);
    out.array("amplitude", m_amplitude);
    out.array("fit", m_fit);
    out.array("radius", m_radius);
    out.array("opacity", m_opacity);
    out.array("vertex", m_vertex);
    out.array("frame", m_frame);
    out.array("rank", m_rank);
    out.array("place", m_place);
    out.array("parent", m_parent);
    out.array("at_scale_limit", m_at_scale_limit);
    out.end("PointData");
    out.begin("Points");
    out.array("Points", m_points, 3);
    out.end("Points");
    out.begin("Verts");
    out.array("connectivity", points);
    out.array("offsets", ends);
    out.end("Verts");
    out.write(os);
  }

private:
  double m_frame_time;
  std::vector<double> m_points, m_sigma, m_tau, m_time, m_strength, m_amplitude, m_fit, m_radius, m_opacity;
  std::vector<std::int64_t> m_vertex, m_frame, m_rank, m_place, m_parent, m_at_scale_limit;
};

template <class Index>
void write_surfaces(Output_folder& folder, const Shown_scene& scene)
{
  const std::size_t frames = scene.sequence.number_of_frames();
  const Vtk_surface<Index> surface(scene.sequence.rest_shape().triangles());
  for_each_frame(scene, [&](const Scene_frame& frame) {
    folder.write(vtp_name("surface", frame.index, frames), [&](std::ostream& os) {
      surface.write(os, frame, scene.fields, double(frame.index) * scene.sequence.frame_duration());
    });
  });
}

} // namespace

std::string vtp_name(const std::string& series, std::size_t frame, std::size_t number_of_frames)
{
  const std::size_t least_digits = 4;
  const std::size_t digits = (std::max)(least_digits, std::to_string(number_of_frames - 1).size());
  const std::string number = std::to_string(frame);
  return series + '_' + std::string(digits - number.size(), '0') + number + ".vtp";
}

void write_vtk(Output_folder& folder, const Shown_scene& scene)
{
  check_scene(scene);
  const std::size_t frames = scene.sequence.number_of_frames();
  // the largest number is the last end of a triangle
  if (3 * scene.sequence.rest_shape().triangles().size() <= std::size_t((std::numeric_limits<std::int32_t>::max)()))
    write_surfaces<std::int32_t>(folder, scene);
  else
    write_surfaces<std::int64_t>(folder, scene);
  for (std::size_t f = 0; f < frames; ++f)
    folder.write(vtp_name("features", f, frames), [&](std::ostream& os) { Vtk_features(scene, f).write(os); });
  for (const char* series : {"surface", "features"})
    folder.write(std::string(series) + ".pvd",
                 [&](std::ostream& os) { write_pvd(os, series, frames, scene.sequence.frame_duration()); });
  folder.write("show_in_paraview.py", [&](std::ostream& os) { os << paraview_script(scene); });
}

} // namespace Programs
