// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_SEQUENCE_H
#define CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_SEQUENCE_H

#include <CGAL/Animated_mesh_features/Animation/Animation_report.h>
#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/check_timing.h>
#include <CGAL/Animated_mesh_features/Animation/internal/check_trajectories.h>
#include <CGAL/Animated_mesh_features/Animation/internal/deforming_vertices.h>
#include <CGAL/Animated_mesh_features/Animation/Frame_batch.h>
#include <CGAL/Animated_mesh_features/Animation/internal/copy_points.h>
#include <CGAL/Animated_mesh_features/Animation/internal/rest_points.h>
#include <CGAL/Animated_mesh_features/Animation/internal/rest_unit.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

What `Frame_sequence::set_rest_shape()` does with a rest mesh whose edges are much longer or shorter than those of the
frames, as happens when the two come in different units.
*/
enum class Rest_unit
{
  CHECK,   ///< throw if the median ratio of edge lengths, frames to rest, is outside of [1/1.3, 1.3]; the default.
  RESCALE, ///< scale the rest shape by that ratio.
  KEEP     ///< take it as it is: the whole body really grows or shrinks.
};

/*!
\ingroup PkgAnimatedMeshFeaturesAnimation

An animation held in memory: one connectivity, `F` frames, and a rest shape. Model of `MeshAnimation`.

Coordinates are converted once, at construction, from whatever kernel they come in; they are kept for each vertex
contiguously over the frames (`3 N F` scalars). The mesh is kept by reference and must not be modified while the
sequence is in use. The rest shape is the first frame until one of the `set_rest_...()` functions is called; `set_canonical_rest_shape()`
makes one of all frames.

Vertices are numbered by their rank in `vertices(mesh)`, also if the mesh's own indices have gaps.

\tparam TriangleMesh a model of `FaceListGraph`, `VertexListGraph` and `EdgeListGraph`, with dynamic vertex properties,
  whose faces are triangles.
\tparam FT_ `float` or `double`, the scalar of coordinates and of everything computed from them. `float` halves the
  memory; its rounding is about 10^-7 of the coordinates.

\cgalModels{MeshAnimation}
*/
template <class TriangleMesh, class FT_ = double>
class Frame_sequence
{
  typedef typename CGAL::dynamic_vertex_property_t<std::size_t> Index_tag;

public:
  typedef TriangleMesh Triangle_mesh; ///< the mesh
  typedef FT_ FT;                     ///< `float` or `double`

  /// what the keys of property maps are.
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  /// a position, whatever the kernel of the points that were given.
  typedef typename CGAL::Simple_cartesian<FT>::Point_3 Point_3;

  /// readable: vertex descriptor to rank in `vertices(mesh)`.
  typedef typename boost::property_map<TriangleMesh, Index_tag>::const_type Vertex_index_map;

  /// readable: vertex descriptor to position in one frame, or in the rest shape. Valid as long as the sequence.
  class Point_map
  {
  public:
    typedef vertex_descriptor key_type;                ///< a vertex of the mesh
    typedef Point_3 value_type;                        ///< its position
    typedef Point_3 reference;                         ///< the same, by value
    typedef boost::readable_property_map_tag category; ///< `get()` only

    /// the position of `v`.
    friend reference get(const Point_map& map, const key_type& v)
    {
      const std::size_t i = get(map.m_index, v);
      const Rest_shape::Point p = map.m_frame == rest ? map.m_sequence->rest_shape().points()[i]
                                                      : map.m_sequence->trajectories().point(i, map.m_frame);
      return Point_3(FT(p[0]), FT(p[1]), FT(p[2]));
    }

  private:
    /// \cond SKIP_IN_MANUAL
    friend class Frame_sequence;
    /// \endcond
    static constexpr std::size_t rest = std::size_t(-1);
    Point_map(const Frame_sequence* sequence, std::size_t frame)
      : m_sequence(sequence)
      , m_index(sequence->m_index)
      , m_frame(frame)
    {
    }
    const Frame_sequence* m_sequence;
    Vertex_index_map m_index;
    std::size_t m_frame;
  };

  /*!
  converts and keeps the positions of all frames, in `O(N F)` time. The rest shape is the first frame.

  \param mesh the connectivity. Borders, several components, isolated vertices and triangles that are degenerate are
    allowed, see `report()`.
  \param frames a range with an element for each frame: either a readable property map from vertex descriptor to a
    point of any \cgal kernel, or a range of such points in the order of `vertices(mesh)`.
  \param frame_duration the time between two frames, in seconds.
  \param memory where the coordinates live, and what is computed from them.

  \throw Input_error if a face is no triangle, a frame has another number of points than the mesh has vertices, a
    coordinate is not finite, there are fewer than 3 frames, or `frame_duration` is not positive.
  */
  template <class FrameRange>
  Frame_sequence(const TriangleMesh& mesh, const FrameRange& frames, double frame_duration,
                 const std::shared_ptr<Field_memory>& memory = Field_memory::heap())
    : Frame_sequence(mesh)
  {
    const std::size_t number_of_frames = std::size_t(std::distance(std::begin(frames), std::end(frames)));
    internal::check_timing(number_of_frames, frame_duration);
    m_frame_duration = frame_duration;
    Vertex_trajectories<FT>& t = m_trajectories;
    for (Spatio_temporal_field<FT>* c : {&t.x, &t.y, &t.z})
      *c = Spatio_temporal_field<FT>(m_vertices.size(), number_of_frames, memory);
    Frame_batch<FT, CGAL::Parallel_if_available_tag> batch({{&t.x, &t.y, &t.z}}, 64 / sizeof(FT)); // a cache line of a row
    std::size_t f = 0;
    for (const auto& frame : frames) {
      internal::copy_points(frame, m_vertices, "frame " + std::to_string(f), batch.frame(f));
      if (++f == batch.end()) batch.finish();
    }
    set_rest_frame(0);
  }

  /*!
  takes over coordinates that already are in the package's layout, without copying: `N x F` each, row `i` for the
  `i`-th vertex of `mesh`.
  \throw Input_error as above.
  */
  Frame_sequence(const TriangleMesh& mesh,
                 Spatio_temporal_field<FT> x,
                 Spatio_temporal_field<FT> y,
                 Spatio_temporal_field<FT> z,
                 double frame_duration)
    : Frame_sequence(mesh)
  {
    for (const Spatio_temporal_field<FT>* c : {&x, &y, &z})
      if (c->number_of_rows() != m_vertices.size() || c->number_of_frames() != x.number_of_frames())
        throw Input_error("the coordinates are " + std::to_string(c->number_of_rows()) + " x " +
                          std::to_string(c->number_of_frames()) + ", the mesh has " +
                          std::to_string(m_vertices.size()) + " vertices");
    internal::check_timing(x.number_of_frames(), frame_duration);
    m_trajectories.x.swap(x);
    m_trajectories.y.swap(y);
    m_trajectories.z.swap(z);
    m_frame_duration = frame_duration;
    std::size_t v, f;
    if (internal::find_not_finite(m_trajectories, v, f))
      throw Input_error("frame " + std::to_string(f) + ": the position of vertex " + std::to_string(v) +
                        " is not finite");
    set_rest_frame(0);
  }

  /// \name The rest shape
  /// @{

  /// takes frame `f` as rest shape.
  /// \throw Input_error if there is no such frame.
  void set_rest_frame(std::size_t f)
  {
    if (f >= number_of_frames())
      throw Input_error("there is no frame " + std::to_string(f) + " to take as rest shape; frames are 0 to " +
                        std::to_string(number_of_frames() - 1));
    set_rest_points(m_trajectories.frame(f).points());
  }

  /*!
  takes a separate shape of the same connectivity.
  \param points a readable property map from vertex descriptor to point, or a range of points in the order of
    `vertices(mesh)`.
  \param unit what to do if its edges are much longer or shorter than those of the frames.
  \returns the factor by which the points were scaled: 1, unless `unit` is `Rest_unit::RESCALE`.
  \throw Input_error if the number of points or the unit differ, or a coordinate is not finite.
  */
  template <class Points>
  double set_rest_shape(const Points& points, Rest_unit unit = Rest_unit::CHECK)
  {
    std::vector<Rest_shape::Point> rest = internal::rest_points(points, m_vertices, "the rest shape");
    double factor = 1;
    if (unit != Rest_unit::KEEP) {
      const double ratio = internal::median_edge_ratio(m_rest, rest, m_trajectories);
      if (unit == Rest_unit::RESCALE) {
        factor = ratio;
        for (Rest_shape::Point& p : rest) p *= factor;
      } else {
        internal::check_rest_unit(ratio);
      }
    }
    set_rest_points(std::move(rest));
    return factor;
  }

  /// @}

  /// \name MeshAnimation
  /// @{

  /// the connectivity.
  const TriangleMesh& triangle_mesh() const { return *m_mesh; }

  /// `F`, at least 3.
  std::size_t number_of_frames() const { return m_trajectories.number_of_frames(); }

  /// the time between two frames, in seconds.
  double frame_duration() const { return m_frame_duration; }

  /// the positions in a frame, from 0.
  Point_map point_map(std::size_t frame) const { return Point_map(this, frame); }

  /// the positions in the rest shape.
  Point_map rest_point_map() const { return Point_map(this, Point_map::rest); }
  /// @}

  /// `N`, the number of elements of `vertices(mesh)`.
  std::size_t number_of_vertices() const { return m_vertices.size(); }

  /// the vertices in the order of `vertices(mesh)`.
  const std::vector<vertex_descriptor>& vertex_descriptors() const { return m_vertices; }

  /// the row of each vertex in fields of this animation: its rank in `vertices(mesh)`.
  Vertex_index_map vertex_index_map() const { return m_index; }

  /// the rest shape as the policies see it. Its size, of which default lengths are fractions, is measured by the
  /// components that deform against it, by more than a hundredth of what the most deformed one does; by all, if none does.
  const Rest_shape& rest_shape() const { return m_rest; }

  /// the positions of all vertices in all frames, rows in the order of `vertices(mesh)`.
  const Vertex_trajectories<FT>& trajectories() const { return m_trajectories; }

  /// what is unusual about the mesh and nevertheless allowed.
  Animation_report report() const { return Animated_mesh_features::report(m_rest); }

private:
  explicit Frame_sequence(const TriangleMesh& mesh)
    : m_mesh(&mesh)
    , m_index(get(Index_tag(), mesh))
  {
    for (vertex_descriptor v : vertices(mesh)) {
      put(m_index, v, m_vertices.size());
      m_vertices.push_back(v);
    }
    m_rest = Rest_shape(mesh, m_index, m_vertices.size());
  }

  // Default lengths are to fit what deforms, not what only lies about.
  void set_rest_points(std::vector<Rest_shape::Point> points)
  {
    m_rest.set_points(std::move(points));
    std::vector<Rest_shape::Index> deforming = internal::deforming_vertices(m_rest, m_trajectories);
    if (deforming != m_rest.measured_vertices()) m_rest.set_measured_vertices(std::move(deforming));
  }

  const TriangleMesh* m_mesh;
  Vertex_index_map m_index;
  std::vector<vertex_descriptor> m_vertices;
  Rest_shape m_rest;
  Vertex_trajectories<FT> m_trajectories;
  double m_frame_duration = 0; // seconds
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_ANIMATION_FRAME_SEQUENCE_H
