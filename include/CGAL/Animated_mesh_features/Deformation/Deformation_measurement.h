// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_MEASUREMENT_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_MEASUREMENT_H

#include <CGAL/Animated_mesh_features/Animation/Frame_sequence.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/as_frame_sequence.h>
#include <CGAL/Animated_mesh_features/Deformation/Deformation_options.h>
#include <CGAL/Animated_mesh_features/Deformation/deformation.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/curvature_rows.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/deformation_noise.h>
#include <CGAL/Animated_mesh_features/Deformation/internal/strain_fields.h>
#include <CGAL/Animated_mesh_features/Geodesic_balls/geodesic_balls.h>
#include <CGAL/Animated_mesh_features/Numerics/Compressed_rows.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Stage_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Task_loop.h>

#include <CGAL/tags.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesDeformation

The first stage of a detection: an animation in, fields out. Measures strain, change of curvature, and their sum

\f[d(v,f) = \mathrm{strain}(v,f) + \alpha\,|\kappa(v,f) - \kappa(v,\mathrm{rest})|,\f]

in which features are found. What was asked for is kept, with the geodesic balls; strain and change of curvature only if
they were asked for themselves. For a single field without keeping anything there are `strain()`, `curvature()` and
`deformation()`.

Time: linear in `N F`, plus the geodesic balls. Memory: that of the fields that are kept.

\tparam Animation a model of `MeshAnimation`.
\tparam Options a `Deformation_options`.
\tparam ConcurrencyTag `CGAL::Parallel_if_available_tag` or `CGAL::Sequential_tag`. Results are the same, bit for bit.

\sa `Feature_detector`, the second stage
*/
template <class Animation, class Options = Deformation_options<>,
          class ConcurrencyTag = CGAL::Parallel_if_available_tag>
class Deformation_measurement
{
  typedef decltype(as_frame_sequence(std::declval<const Animation&>())) Sequence_or_reference;

public:
  typedef typename Animation::FT FT;       ///< of coordinates and fields
  typedef Spatio_temporal_field<FT> Field; ///< of strains, deformations, ...

  /// a `Frame_sequence` is kept by reference; the positions of another model are read once, into a `Frame_sequence`,
  /// which takes `O(N F)` time and memory.
  /// \throw Input_error see `Frame_sequence`.
  explicit Deformation_measurement(const Animation& animation, Options options = Options())
    : m_sequence(as_frame_sequence(animation))
    , m_options(std::move(options))
  {}

  /// what is measured.
  const Frame_sequence<typename Animation::Triangle_mesh, FT>& sequence() const { return m_sequence; }

  /// what the measurement was told.
  const Options& options() const { return m_options; }

  /// \name Fields
  /// computed at the first call. A visitor is a model of `DetectionVisitor`, by default one that does nothing.
  /// \throw Option_error if the radius of the balls is negative or not finite.
  /// \throw Numerical_error if a matrix cannot be factored.
  /// \throw Cancelled if the visitor asks for it.
  /// @{

  /// `N x F` strains.
  const Field& strain(Any_visitor visitor = Any_visitor())
  {
    if (!m_strain) m_strain = strain_field(visitor);
    return *m_strain;
  }

  /// `N x F` absolute changes of curvature from the rest shape.
  const Field& curvature_change(Any_visitor visitor = Any_visitor())
  {
    if (!m_curvature_change) {
      const Compressed_rows& balls = geodesic_balls(visitor);
      const internal::Stage_scope stage(visitor, Stage::CURVATURE);
      m_curvature_change = internal::curvature_change_rows(shape(), sequence().trajectories(), balls,
                                                           m_options.curvature, loop(visitor, Stage::CURVATURE));
    }
    return *m_curvature_change;
  }

  /// `N x F` deformations, in which features are found.
  const Field& deformation(Any_visitor visitor = Any_visitor())
  {
    if (!m_deformation) m_deformation = sum(visitor);
    return *m_deformation;
  }

  /// the same, handed over: the measurement does not keep it.
  Field take_deformation(Any_visitor visitor = Any_visitor())
  {
    if (!m_deformation) return sum(visitor);
    Field field = std::move(*m_deformation);
    m_deformation.reset();
    return field;
  }

  /// the ball of each vertex on the rest shape.
  const Compressed_rows& geodesic_balls(Any_visitor visitor = Any_visitor())
  {
    if (!m_balls) {
      const internal::Stage_scope stage(visitor, Stage::GEODESIC_BALLS);
      m_balls = Animated_mesh_features::geodesic_balls(shape(), m_options.ball_radius, m_options.balls,
                                                       loop(visitor, Stage::GEODESIC_BALLS));
    }
    return *m_balls;
  }

  /// @}

  /// the strength up to which a feature of the deformation may be an error that stems from the coordinates, because they
  /// are rounded. `O(N F)`.
  double noise() const { return internal::deformation_noise(shape(), sequence().trajectories()); }

private:
  typedef Task_loop<ConcurrencyTag, Any_visitor> Loop;

  const Rest_shape& shape() const { return sequence().rest_shape(); }

  static Loop loop(Any_visitor& visitor, Stage stage) { return Loop(visitor, stage); }

  Field strain_field(Any_visitor visitor) const
  {
    const internal::Stage_scope stage(visitor, Stage::STRAIN);
    return internal::vertex_strain_rows(shape(), sequence().trajectories(), m_options.strain,
                                        m_options.triangle_weights, loop(visitor, Stage::STRAIN));
  }

  Field sum(Any_visitor visitor)
  {
    if (m_options.alpha == 0) return m_strain ? *m_strain : strain_field(visitor); // spares the balls
    if (m_curvature_change)
      return Animated_mesh_features::deformation(strain(visitor), *m_curvature_change, m_options.alpha);
    const Compressed_rows& balls = geodesic_balls(visitor);
    Field field = m_strain ? *m_strain : strain_field(visitor);
    const internal::Stage_scope stage(visitor, Stage::CURVATURE);
    internal::add_curvature_change(shape(), sequence().trajectories(), balls, m_options.curvature, m_options.alpha,
                                   loop(visitor, Stage::CURVATURE), field);
    return field;
  }

  Sequence_or_reference m_sequence;
  Options m_options;
  std::optional<Compressed_rows> m_balls;
  std::optional<Field> m_strain, m_curvature_change, m_deformation;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_DEFORMATION_MEASUREMENT_H
