// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_GAUSSIAN_TEMPORAL_FILTER_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_GAUSSIAN_TEMPORAL_FILTER_H

#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/Cancellation_scope.h>
#include <CGAL/Animated_mesh_features/Numerics/simd/Pack.h>
#include <CGAL/Animated_mesh_features/Scale_space/Boundary_condition.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/Gaussian_steps.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/discrete_gaussian.h>
#include <CGAL/Animated_mesh_features/Scale_space/internal/smooth_row.h>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesFilters

Smoothing in time by the discrete Gaussian with reflecting or joined ends; a model of `TemporalFilter`, the default.

The semigroup of the discrete heat equation: in the basis of the DCT-II, which continues a row by its mirror image, the
factors are \f$e^{u(\cos(\pi j/F) - 1)}\f$ for the variance u in squared frames \cgalCite{lindeberg1990}; in the Fourier
basis of a cyclic animation, which continues it by itself, \f$e^{u(\cos(2\pi j/F) - 1)}\f$. Variances add exactly, the mean
is kept exactly, and no new extrema appear, whatever the step.

A level costs F times the number of its weights. If steps grow with the variances, a row that has been smoothed needs a
weight every few frames only: two or three dozen of them altogether in single precision, however wide the Gaussian, and
twice as many in double precision, in which rows of up to 1,024 frames nevertheless get all of them. So time is linear
in F also where variances grow with the duration.

\cgalModels{TemporalFilter}
*/
class Gaussian_temporal_filter
{
public:
  /// rows may be those of several vertices at once, see `TemporalFilter`.
  static constexpr bool vectorized = true;

  /// \cond SKIP_IN_MANUAL
  // A row that is turned round comes out turned round, to the last bit: pairs of frames are added first.
  static constexpr bool is_mirror_symmetric = true;
  /// \endcond

  /// makes a filter without levels.
  /// \param ends what follows the last frame: `Boundary_condition::REFLECT`, or `PERIODIC` for cyclic animations.
  /// \throw Option_error if it is something else, of which this filter knows nothing.
  explicit Gaussian_temporal_filter(Boundary_condition ends = Boundary_condition::REFLECT)
    : m_is_periodic(ends == Boundary_condition::PERIODIC)
  {
    if (ends != Boundary_condition::REFLECT && ends != Boundary_condition::PERIODIC)
      throw Option_error("the Gaussian in time reflects a row or repeats it; other ends are those of boxes only");
  }

  /// the step where a sampling counts steps: the variance of a box of three frames (squared seconds).
  double unit_variance(std::size_t /* number_of_frames */, double frame_duration) const
  {
    return 2 * frame_duration * frame_duration / 3;
  }

  /// prepares the levels.
  /// \param number_of_frames of each row.
  /// \param frame_duration seconds.
  /// \param variances ascending; squared seconds.
  void initialize(std::size_t number_of_frames, double frame_duration, const std::vector<double>& variances)
  {
    m_frames = number_of_frames;
    m_frame_duration = frame_duration;
    m_variances = variances;
    m_weights.clear();
    const bool is_sparse = !has_equal_steps(); // errors are then measured by what equal steps have left of the row
    const internal::Gaussian_steps steps(number_of_frames, circle());
    for (std::size_t l = 0; l < variances.size(); ++l) {
      internal::cancellation_point();
      const double before = (l > 0 ? variances[l - 1] : 0) / (frame_duration * frame_duration);
      const double whole_step = variances[l] / (frame_duration * frame_duration) - before;
      m_weights.push_back(steps(before, whole_step, is_sparse));
    }
  }

  /// the variance of level `l`, exactly the one that was asked for.
  double variance(std::size_t l) const { return m_variances[l]; }

  /// whether every level from the second on is the level before it after one and the same operation.
  bool has_equal_steps() const
  {
    for (std::size_t l = 2; l < m_variances.size(); ++l) {
      const double first = m_variances[1] - m_variances[0], step = m_variances[l] - m_variances[l - 1];
      if (!(std::abs(step - first) <= 1e-12 * m_variances[l])) return false; // they may have been computed as multiples
    }
    return true;
  }

  /// smooths a row of frames from level `l` - 1 (the unsmoothed row for `l` = 0) to level `l`; `in` and `out` do not
  /// overlap. Rows of `float`, or of more than 1,024 frames, have to be those of
  /// level `l` - 1, since not every frame of them is looked at.
  /// \tparam T `float`, `double`, or several of them that are computed with as one, see `vectorized`.
  template <class T>
  void operator()(std::size_t l, const T* in, T* out) const
  {
    typedef typename internal::Scalar_of<T>::type Scalar;
    const internal::Gaussian_steps::Weights& k = m_weights[l];
    internal::smooth_row(in, std::ptrdiff_t(m_frames), std::is_same<Scalar, float>::value ? k.of_float : k.of_double,
                         m_is_periodic, out);
  }

  /// \name What Long Rows Need
  /// See `TemporalFilter`.
  /// @{

  /// whether a row is continued by its mirror image.
  bool reflects() const { return !m_is_periodic; }

  /// whether a row is continued by itself.
  bool is_periodic() const { return m_is_periodic; }

  /// the weights of level `l` with respect to the unsmoothed row, by distance on the circle of F frames, or of the 2 F on which
  /// the row and its mirror image live: those up to the opposite frame; those that are left out are zero. Linear in F.
  std::vector<double> weights_by_distance(std::size_t l) const
  {
    return internal::on_circle(internal::discrete_gaussian(m_variances[l] / (m_frame_duration * m_frame_duration)),
                               circle());
  }
  /// @}

private:
  // The frames after which a row that goes on repeats: a cyclic one itself, another one after its mirror image.
  std::size_t circle() const { return m_is_periodic ? m_frames : 2 * m_frames; }

  bool m_is_periodic;
  std::size_t m_frames = 0;
  double m_frame_duration = 0; // seconds
  std::vector<double> m_variances;
  std::vector<internal::Gaussian_steps::Weights> m_weights; // of the step to level l: [l]
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_GAUSSIAN_TEMPORAL_FILTER_H
