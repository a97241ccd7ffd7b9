// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/Html_scene.h"

#include "page/deflated.h"
#include "page/write_base64.h"
#include "page/write_json_script.h"
#include "rendering/Palette.h"
#include "running/Interruption.h"
#include "views/Scene_views.h"

#include <CGAL/Animated_mesh_features/IO/write_json.h>

#include <nlohmann/json.hpp>

#include <array>
#include <utility>

typedef nlohmann::ordered_json Json;

namespace Programs {

namespace {

std::vector<std::size_t> kept_frames(std::size_t number_of_frames, std::size_t step)
{
  std::vector<std::size_t> frames;
  for (std::size_t f = 0; f < number_of_frames; f += step) frames.push_back(f);
  if (number_of_frames > 0 && frames.back() + 1 != number_of_frames) frames.push_back(number_of_frames - 1);
  return frames;
}

Quantized_positions::Trajectories resting(const CGAL::Animated_mesh_features::Rest_shape& shape)
{
  const std::size_t n = shape.number_of_vertices();
  Quantized_positions::Trajectories result;
  result.x = result.y = result.z = CGAL::Animated_mesh_features::Spatio_temporal_field<double>(n, 1);
  for (std::size_t v = 0; v < n; ++v) {
    result.x(v, 0) = shape.points()[v].x();
    result.y(v, 0) = shape.points()[v].y();
    result.z(v, 0) = shape.points()[v].z();
  }
  return result;
}

// The least significant byte of all numbers, then the next one of all, and so on: the upper bytes of small numbers are
// a long run of zeros.
template <class Number>
std::string byte_planes(const std::vector<Number>& numbers)
{
  std::string planes;
  planes.reserve(numbers.size() * sizeof(Number));
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    for (const Number n : numbers) planes += static_cast<char>(static_cast<unsigned char>(n >> (8 * i)));
  return planes;
}

// Each number as the difference from the one before, signs folded.
std::vector<std::uint32_t> differences(const std::vector<std::uint32_t>& numbers)
{
  std::vector<std::uint32_t> result;
  std::uint32_t last = 0;
  for (const std::uint32_t n : numbers) {
    const std::uint32_t difference = n - last;
    result.push_back((difference << 1) ^ (difference >> 31 ? ~std::uint32_t(0) : 0));
    last = n;
  }
  return result;
}

// Colours of a map from 0 to 1: so many that it is straight between them, to within rounding.
std::vector<std::string> samples(const Rendering::Colour_map& map)
{
  const std::size_t n = 129;
  std::vector<std::string> result;
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(Rendering::hexadecimal(Rendering::encoded(map(double(i) / double(n - 1)))));
  return result;
}

void write_bytes(std::ostream& os, const std::string& id, const std::string& bytes)
{
  os << "<script type=\"text/plain\" id=\"" << id << "\">";
  write_base64(os, deflated(bytes));
  os << "</script>\n";
}

} // namespace

Html_scene::Html_scene(const Shown_scene& scene, const Html_sampling& sampling, const Html_options& options)
  : m_scene(scene)
  , m_options(options)
  , m_surface(scene.sequence, sampling.vertices)
  , m_frames(kept_frames(scene.sequence.number_of_frames(), sampling.frame_step))
  , m_positions(scene.sequence.trajectories(), scene.sequence.rest_shape(), m_surface.vertices())
  , m_rest(resting(scene.sequence.rest_shape()))
  , m_rest_positions(m_rest, scene.sequence.rest_shape(), m_surface.vertices())
  , m_prediction(m_surface.vertices().size(), m_surface.triangles())
{
  for (const Scene_field& f : scene.fields) m_fields.emplace_back(*f.values, m_surface.vertices(), m_frames);
}

double Html_scene::largest_error() const
{
  const double diagonal = m_scene.sequence.rest_shape().bounding_box_diagonal();
  return diagonal > 0 ? m_positions.largest_error() / diagonal : 0;
}

void Html_scene::write(std::ostream& os, const std::string& name) const
{
  write_json_script(os, name, description());
  write_bytes(os, name + "-faces", faces());
  if (m_surface.is_thinned()) write_bytes(os, name + "-vertices", vertices());
  write_bytes(os, name + "-positions", positions(m_positions, m_frames));
  write_bytes(os, name + "-rest", positions(m_rest_positions, {0}));
  for (std::size_t i = 0; i < m_fields.size(); ++i)
    write_bytes(os, name + "-field-" + std::to_string(i), byte_planes(residuals(m_fields[i])));
}

Json Html_scene::description() const
{
  const Shown_sequence& sequence = m_scene.sequence;
  Json fields = Json::array();
  for (std::size_t i = 0; i < m_fields.size(); ++i)
    fields.push_back({{"name", m_scene.fields[i].name},
                      {"min", m_fields[i].min()},
                      {"max", m_fields[i].max()},
                      {"largest", m_fields[i].largest()},
                      {"top_level", Quantized_field::top_level}});
  Json result = {{"format", "animated-mesh-features-scene"},
          {"version", 1},
          {"title", m_scene.title},
          {"vertices", m_surface.vertices().size()},
          {"faces", m_surface.triangles().size()},
          {"frames", sequence.number_of_frames()},
          {"frame_duration", sequence.frame_duration()},
          {"bounding_box_diagonal", sequence.rest_shape().bounding_box_diagonal()},
          {"mean_edge_length", sequence.rest_shape().mean_edge_length()},
          {"largest_error", largest_error()},
          {"kept_frames", m_frames},
          {"view", view()},
          {"origin", m_positions.origin()},
          {"step", m_positions.step()},
          {"corners", corners()},
          {"rest_step", m_rest_positions.step()},
          {"fields", std::move(fields)},
          {"colours",
           {{"field", samples(Rendering::field_colours())}, {"duration", samples(Rendering::duration_colours())}}},
          {"features", m_scene.features}};
  if (m_scene.is_cyclic) result["cyclic"] = true;
  if (m_surface.is_thinned()) {
    result["all_vertices"] = sequence.number_of_vertices();
    result["all_faces"] = sequence.rest_shape().triangles().size();
    result["places"] = places();
  }
  return result;
}

Json Html_scene::places() const
{
  Json result = Json::array();
  for (const Shown_feature& feature : m_scene.features) {
    const Page_surface::Place place = m_surface.place(feature);
    result.push_back(
        {{"triangle", place.triangle}, {"barycentric_coordinates", place.barycentric_coordinates}});
  }
  return result;
}

Json Html_scene::corners() const
{
  Json result = Json::array();
  for (const std::size_t f : m_frames)
    result.push_back(
        std::array<std::int64_t, 3>{{m_positions.corner(0, f), m_positions.corner(1, f), m_positions.corner(2, f)}});
  return result;
}

// Where the page opens: null, or what points up and, if it is known, the direction to the camera.
Json Html_scene::view() const
{
  namespace AMF = CGAL::Animated_mesh_features;
  const bool is_told = m_options.view.kind != View_kind::AUTO;
  if (!is_told && !m_options.up_axis && m_scene.views == nullptr) return nullptr;
  const int up = m_scene.views != nullptr ? m_scene.views->up_axis : scene_up_axis(m_scene, m_options.up_axis);
  if (up == 0) return nullptr; // the page knows of y and z
  Json result = {{"up", up == 2 ? "z" : "y"}};
  if (!is_told && m_scene.views == nullptr) return result;
  const Eigen::Vector3d d = is_told ? AMF::view_direction(told_angles(m_options.view, up), Eigen::Vector3d::Unit(up))
                                    : m_scene.views->selection.views.front().direction;
  result["direction"] = std::array<double, 3>{{d[0], d[1], d[2]}};
  return result;
}

std::string Html_scene::faces() const
{
  std::vector<std::uint32_t> corners;
  for (const auto& t : m_surface.triangles()) corners.insert(corners.end(), t.begin(), t.end());
  return byte_planes(differences(corners));
}

std::string Html_scene::vertices() const
{
  return byte_planes(differences({m_surface.vertices().begin(), m_surface.vertices().end()}));
}

std::string Html_scene::positions(const Quantized_positions& positions, const std::vector<std::size_t>& frames) const
{
  std::vector<std::uint16_t> residuals, now;
  const std::size_t n = m_surface.vertices().size();
  residuals.reserve(3 * n * frames.size());
  std::array<std::vector<std::uint16_t>, 3> before;
  before.fill(std::vector<std::uint16_t>(n));
  for (const std::size_t f : frames) {
    Interruption::check();
    for (std::size_t c = 0; c < 3; ++c) {
      positions.get_frame(c, f, now);
      m_prediction.append_residuals(residuals, before[c], now);
      before[c].swap(now);
    }
  }
  return byte_planes(residuals);
}

std::vector<std::uint8_t> Html_scene::residuals(const Quantized_field& field) const
{
  std::vector<std::uint8_t> residuals, now, before(m_surface.vertices().size());
  residuals.reserve(before.size() * m_frames.size());
  for (const std::size_t f : m_frames) {
    Interruption::check();
    field.get_frame(f, now);
    m_prediction.append_residuals(residuals, before, now);
    before.swap(now);
  }
  return residuals;
}

} // namespace Programs
