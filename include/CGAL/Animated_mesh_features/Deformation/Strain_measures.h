// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_STRAIN_MEASURES_H
#define CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_STRAIN_MEASURES_H

#include <CGAL/Animated_mesh_features/Numerics/simd/pack_math.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Animated_mesh_features {

namespace internal {

inline float maximum(float a, float b) { return (std::max)(a, b); }
inline double maximum(double a, double b) { return (std::max)(a, b); }
template <class Scalar, int N>
Eigen::Array<Scalar, N, 1> maximum(const Eigen::Array<Scalar, N, 1>& a, const Eigen::Array<Scalar, N, 1>& b)
{
  return a.max(b);
}

template <class T>
struct Constant
{
  static T of(double c) { return T(c); }
};
template <class Scalar, int N>
struct Constant<Eigen::Array<Scalar, N, 1>>
{
  static Eigen::Array<Scalar, N, 1> of(double c) { return Eigen::Array<Scalar, N, 1>::Constant(Scalar(c)); }
};
template <class Scalar, std::size_t n, std::size_t b>
struct Constant<Pack<Scalar, n, b>>
{
  static CGAL_ANIMATED_MESH_FEATURES_INLINE Pack<Scalar, n, b> of(double c)
  {
    return Pack<Scalar, n, b>::all(Scalar(c));
  }
};

// Whether a measure takes packs, too: those of the library.
template <class Measure>
struct Takes_packs : std::false_type
{
};

} // namespace internal

/*!
\addtogroup PkgAnimatedMeshFeaturesStrainMeasures

Models of `StrainMeasure`. Each maps the squared principal stretches \f$\lambda_1 \ge \lambda_2 > 0\f$ of a triangle,
the eigenvalues of \f$I_0^{-1} I_f\f$ with the first fundamental forms at rest and in the frame, to a scalar without a
unit. `vectorized` says that they also take Eigen arrays, with one entry for each of several frames.
*/

/*!
\ingroup PkgAnimatedMeshFeaturesStrainMeasures

The norm of Hencky's logarithmic strain, \f$\|\ln U\| = \frac12\sqrt{\ln^2\lambda_1 + \ln^2\lambda_2}\f$. The default:
doubling and halving a length count the same (0.69), and a sliver that is stretched a hundred times weighs 4.6, not
10,000.

\cgalModels{StrainMeasure}
*/
struct Hencky_strain
{
  static constexpr bool vectorized = true; ///< takes Eigen arrays, too

  /// \f$\frac12\sqrt{\ln^2\lambda_1 + \ln^2\lambda_2}\f$
  template <class T>
  T operator()(const T& lambda_1, const T& lambda_2) const
  {
    using std::log;
    using std::sqrt;
    const T a = log(lambda_1), b = log(lambda_2);
    return sqrt(T(a * a + b * b)) * internal::Constant<T>::of(0.5);
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesStrainMeasures

The norm of the Green-Lagrange strain, \f$\frac12\|C - I\| = \frac12\sqrt{(\lambda_1-1)^2 + (\lambda_2-1)^2}\f$;
standard in mechanics. Stretch by 2 gives 1.5, compression to one half 0.375.

\cgalModels{StrainMeasure}
*/
struct Green_lagrange_strain
{
  static constexpr bool vectorized = true; ///< takes Eigen arrays, too

  /// \f$\frac12\sqrt{(\lambda_1-1)^2 + (\lambda_2-1)^2}\f$
  template <class T>
  T operator()(const T& lambda_1, const T& lambda_2) const
  {
    using std::sqrt;
    const T one = internal::Constant<T>::of(1);
    const T a = lambda_1 - one, b = lambda_2 - one;
    return sqrt(T(a * a + b * b)) * internal::Constant<T>::of(0.5);
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesStrainMeasures

The largest change of length, \f$\max_i |\sqrt{\lambda_i} - 1|\f$. Stretch by 2 gives 1, compression to one half 0.5.

\cgalModels{StrainMeasure}
*/
struct Principal_stretch_strain
{
  static constexpr bool vectorized = true; ///< takes Eigen arrays, too

  /// \f$\max_i |\sqrt{\lambda_i} - 1|\f$
  template <class T>
  T operator()(const T& lambda_1, const T& lambda_2) const
  {
    using std::abs;
    using std::sqrt;
    const T one = internal::Constant<T>::of(1);
    const T a = abs(T(sqrt(lambda_1) - one)), b = abs(T(sqrt(lambda_2) - one));
    return internal::maximum(a, b);
  }
};

/*!
\ingroup PkgAnimatedMeshFeaturesStrainMeasures

The largest eigenvalue of the right Cauchy-Green tensor of the prism of unit height over the triangle,
\f$\max(\lambda_1, 1)\f$, as Mykhalchuk, Seo and Cordier \cgalCite{mykhalchuk2014} have it: 1 at rest, 4 at a stretch by
2, blind to compression.

\cgalModels{StrainMeasure}
*/
struct Largest_eigenvalue_strain
{
  static constexpr bool vectorized = true; ///< takes Eigen arrays, too

  /// \f$\max(\lambda_1, 1)\f$
  template <class T>
  T operator()(const T& lambda_1, const T&) const
  {
    return internal::maximum(lambda_1, internal::Constant<T>::of(1));
  }
};

namespace internal {

template <>
struct Takes_packs<Hencky_strain> : std::true_type
{
};
template <>
struct Takes_packs<Green_lagrange_strain> : std::true_type
{
};
template <>
struct Takes_packs<Principal_stretch_strain> : std::true_type
{
};
template <>
struct Takes_packs<Largest_eigenvalue_strain> : std::true_type
{
};

} // namespace internal
} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_DEFORMATION_STRAIN_MEASURES_H
