// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_PAGE_WRITE_HTML_H
#define PROGRAMS_PAGE_WRITE_HTML_H

#include "page/Html_options.h"
#include "scenes/Scene.h"
#include "page/Quantized_field.h"
#include "page/Quantized_positions.h"
#include "page/Surface_prediction.h"
#include "page/base64.h"
#include "page/deflate.h"
#include <CGAL/Animated_mesh_features/IO/write_json.h>
#include "rendering/Palette.h"
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {
namespace IO {

namespace internal {

// Where the viewer's page has its scene.
constexpr std::string_view html_scene_marker = "<!--scene-->";

// The scripts of a page that hold a scene. What is in them is described at `write_html()`.
template <class Scene>
class Html_scene
{
  typedef typename Scene::FT FT;

public:
  Html_scene(std::ostream& os, const Scene& scene, std::size_t frame_step)
    : m_os(os)
    , m_scene(scene)
    , m_frames(kept_frames(scene.sequence.number_of_frames(), frame_step))
    , m_positions(scene.sequence.trajectories())
    , m_prediction(scene.sequence.number_of_vertices(), scene.sequence.rest_shape().triangles())
  {
    for (const auto& f : scene.fields) m_fields.emplace_back(*f.values, m_frames);
  }

  double largest_error() const
  {
    const double diagonal = m_scene.sequence.rest_shape().bounding_box_diagonal();
    return diagonal > 0 ? m_positions.largest_error() / diagonal : 0;
  }

  void write() const
  {
    write_description();
    write_bytes("scene-faces", faces());
    write_bytes("scene-positions", positions());
    for (std::size_t i = 0; i < m_fields.size(); ++i)
      write_bytes("scene-field-" + std::to_string(i), byte_planes(residuals(m_fields[i])));
  }

private:
  void write_description() const
  {
    const auto& sequence = m_scene.sequence;
    std::ostringstream text;
    Json_output out(text);
    out.raw("{").member("format", "animated-mesh-features-scene").raw(", ").member("version", 1);
    out.raw(",\n ").member("title", m_scene.title);
    out.raw(",\n ").member("vertices", sequence.number_of_vertices());
    out.raw(", ").member("faces", sequence.rest_shape().triangles().size());
    out.raw(", ").member("frames", sequence.number_of_frames());
    out.raw(", ").member("frame_duration", sequence.frame_duration());
    out.raw(",\n ").member("bounding_box_diagonal", sequence.rest_shape().bounding_box_diagonal());
    out.raw(", ").member("largest_error", largest_error());
    out.raw(",\n ").member("kept_frames", m_frames);
    out.raw(",\n ").member("origin", m_positions.origin()).raw(", ").member("step", m_positions.step());
    out.raw(",\n ").member("corners", corners());
    out.raw(",\n \"fields\": [");
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
      out.raw(i > 0 ? ",\n  {" : "\n  {").member("name", m_scene.fields[i].name);
      out.raw(", ").member("min", m_fields[i].min()).raw(", ").member("max", m_fields[i].max());
      out.raw(", ").member("largest", m_fields[i].largest()).raw("}");
    }
    out.raw("],\n \"colours\": {").member("field", samples(Programs::Rendering::field_colours()));
    out.raw(",\n  ").member("duration", samples(Programs::Rendering::duration_colours())).raw("},\n ");
    write_json_features(out, m_scene.features);
    out.raw("}\n").flush();

    m_os << "<script type=\"application/json\" id=\"scene\">\n";
    // A script ends at "</script" even within quotes. In JSON, "<" can occur within quotes only.
    for (const char c : text.str()) {
      if (c == '<')
        m_os << "\\u003c";
      else
        m_os << c;
    }
    m_os << "</script>\n";
  }

  void write_bytes(const std::string& id, const std::string& bytes) const
  {
    m_os << "<script type=\"text/plain\" id=\"" << id << "\">";
    write_base64(m_os, deflated(bytes));
    m_os << "</script>\n";
  }

  std::vector<std::vector<std::int64_t>> corners() const
  {
    std::vector<std::vector<std::int64_t>> result;
    for (const std::size_t f : m_frames)
      result.push_back({m_positions.corner(0, f), m_positions.corner(1, f), m_positions.corner(2, f)});
    return result;
  }

  // Colours of a map from 0 to 1: so many that it is straight between them, to within rounding.
  static std::vector<std::string> samples(const Programs::Rendering::Colour_map& map)
  {
    const std::size_t n = 129;
    std::vector<std::string> result;
    using namespace Programs::Rendering;
    for (std::size_t i = 0; i < n; ++i) result.push_back(hexadecimal(encoded(map(double(i) / double(n - 1)))));
    return result;
  }

  // Each corner as the difference from the one before, signs folded.
  std::string faces() const
  {
    std::vector<std::uint32_t> residuals;
    std::uint32_t last = 0;
    for (const auto& t : m_scene.sequence.rest_shape().triangles())
      for (const std::uint32_t v : t) {
        const std::uint32_t difference = v - last;
        residuals.push_back((difference << 1) ^ (difference >> 31 ? ~std::uint32_t(0) : 0));
        last = v;
      }
    return byte_planes(residuals);
  }

  std::string positions() const
  {
    std::vector<std::uint16_t> residuals, now;
    residuals.reserve(3 * m_scene.sequence.number_of_vertices() * m_frames.size());
    std::array<std::vector<std::uint16_t>, 3> before;
    before.fill(std::vector<std::uint16_t>(m_scene.sequence.number_of_vertices()));
    for (const std::size_t f : m_frames)
      for (std::size_t c = 0; c < 3; ++c) {
        m_positions.get_frame(c, f, now);
        m_prediction.append_residuals(residuals, before[c], now);
        before[c].swap(now);
      }
    return byte_planes(residuals);
  }

  std::vector<std::uint8_t> residuals(const Quantized_field<FT>& field) const
  {
    std::vector<std::uint8_t> residuals, now, before(m_scene.sequence.number_of_vertices());
    residuals.reserve(before.size() * m_frames.size());
    for (const std::size_t f : m_frames) {
      field.get_frame(f, now);
      m_prediction.append_residuals(residuals, before, now);
      before.swap(now);
    }
    return residuals;
  }

  std::ostream& m_os;
  const Scene& m_scene;
  std::vector<std::size_t> m_frames;
  Quantized_positions<std::decay_t<decltype(std::declval<Scene>().sequence.trajectories())>> m_positions;
  Surface_prediction m_prediction;
  std::vector<Quantized_field<FT>> m_fields;
};

} // namespace internal

/*!
\ingroup PkgAnimatedMeshFeaturesWriting

writes a scene as one HTML file that shows it in a browser, without a network and without a server: the moving surface
with its features and fields, to be turned, played and searched.

The file is `page`, the package's viewer, with the scene in it. `detect_features --html` has the viewer built in; it is
installed as `share/Animated_mesh_features/viewer.html`, to be read by whoever calls this function.

The scene is kept small: 2.2 bytes for a vertex and a frame, and 0.6 for each field, on a galloping horse.
- Positions are rounded to a grid of 2^16 steps along the longest side of the largest frame's bounding box; no vertex
  moves by more than \f$\sqrt3/2\f$ steps, at most \f$1.4\cdot10^{-5}\f$ of that side. The page says how much it is.
- Fields are rounded to 256 values between the smallest and the 99.5th percentile, above which they are shown as that.
- Both are written as differences from what a neighbour's motion predicts, in byte planes, deflated, as base64.
- Features are written as `write_json()` does.

A scene of more vertices times frames than `Html_options::most_positions` is thinned out in time: every k-th frame and
the last one are kept, the page is linear between them.

\param os a binary stream; errors are left in its state, `Output_file` reports them. Independent of its locale.
\param scene what is to be seen
\param page the viewer
\param options how much of it

\throw Option_error if the scene is too large, see `html_frame_step()`; if a field has not the scene's shape; if `page` is
  not the viewer.
\throw Input_error if a value of a field is not finite, or a feature is not on the surface.

Time: linear in the number of vertices times frames, about 0.25 s for each million.

Needs zlib.
*/
template <class Sequence, class Feature>
Html_report write_html(std::ostream& os, const Scene<Sequence, Feature>& scene, std::string_view page,
                       const Html_options& options = Html_options())
{
  check_scene(scene);
  const std::size_t place = page.find(internal::html_scene_marker);
  if (place == std::string_view::npos) throw Option_error("the page has no place for a scene: it is not the viewer");
  Html_report report;
  report.frame_step = html_frame_step(scene.sequence.number_of_vertices(), scene.sequence.number_of_frames(), options);
  const internal::Html_scene<Scene<Sequence, Feature>> html(os, scene, report.frame_step);
  report.largest_error = html.largest_error();
  os.write(page.data(), static_cast<std::streamsize>(place));
  html.write();
  page.remove_prefix(place + internal::html_scene_marker.size());
  os.write(page.data(), static_cast<std::streamsize>(page.size()));
  return report;
}

} // namespace IO
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // PROGRAMS_PAGE_WRITE_HTML_H
