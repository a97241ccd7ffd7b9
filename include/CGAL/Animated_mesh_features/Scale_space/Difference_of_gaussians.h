// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_DIFFERENCE_OF_GAUSSIANS_H
#define CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_DIFFERENCE_OF_GAUSSIANS_H

#include <CGAL/Animated_mesh_features/Scale_space/Scale_levels.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\addtogroup PkgAnimatedMeshFeaturesResponses

Models of `SpaceTimeResponse`: scale-normalised differences of Gaussians in space and time.
\f[ D_{k,l} = a_{k,l}\,(L_{k+p,l} - L_{k-q,l}) + b_{k,l}\,(L_{k,l+p} - L_{k,l-q}) , \f]
p is `above`, q is `below`. They are negative at the centre of a bright blob.
*/

/*!
\ingroup PkgAnimatedMeshFeaturesResponses

Central differences of logarithmic scales, the default. With \f$\hat s = s/\sigma_u^2\f$ and \f$\hat u = u/\tau_u^2\f$
in the units of the sampling,
\f[ D = \hat u^{1/4}\,\frac{L_{k+1,l} - L_{k-1,l}}{\ln(\sigma_{k+1}/\sigma_{k-1})} +
        \hat s^{1/2} \hat u^{-1/4}\,\frac{L_{k,l+1} - L_{k,l-1}}{\ln(\tau_{l+1}/\tau_{l-1})} . \f]
Both terms peak at the scales of a Gaussian blob; one of amplitude A with the scales of the units gives D = -0.53 A
in the limit of close levels, -0.515 A at the default ratios. (Forward differences at a ratio of \f$\sqrt2\f$ would bias
\f$\sigma\f$ by -13 %.)

\cgalModels{SpaceTimeResponse}
*/
class Central_difference_of_gaussians
{
public:
  static constexpr std::size_t below = 1; ///< q
  static constexpr std::size_t above = 1; ///< p

  /// takes over the scales, before any weight is asked for.
  /// \param sigma, tau the scales of the levels (length, seconds).
  /// \param levels has the units in which they are measured.
  void initialize(const std::vector<double>& sigma, const std::vector<double>& tau, const Scale_levels& levels)
  {
    m_sigma = sigma;
    m_tau = tau;
    m_unit_length = levels.unit_length;
    m_unit_time = levels.unit_time;
  }

  /// \f$a_{k,l} = \hat u^{1/4} / \ln(\sigma_{k+1}/\sigma_{k-1})\f$
  double space_weight(std::size_t k, std::size_t l) const
  {
    return std::sqrt(m_tau[l] / m_unit_time) / std::log(m_sigma[k + 1] / m_sigma[k - 1]);
  }

  /// \f$b_{k,l} = \hat s^{1/2} \hat u^{-1/4} / \ln(\tau_{l+1}/\tau_{l-1})\f$
  double time_weight(std::size_t k, std::size_t l) const
  {
    return m_sigma[k] / m_unit_length / std::sqrt(m_tau[l] / m_unit_time) / std::log(m_tau[l + 1] / m_tau[l - 1]);
  }

  /// knows the amplitude of a Gaussian event.
  static constexpr bool has_amplitude = true;

  /*!
  the amplitude of the Gaussian event that gives a response at its own scales.

  On a surface of dimension d at that scale, 2 on a disc and 1 on a tube, an event
  \f$A\,e^{-x^2/2\sigma_0^2} e^{-t^2/2\tau_0^2}\f$ is smoothed to
  \f$A\,(1 + \sigma^2/\sigma_0^2)^{-d/2} (1 + \tau^2/\tau_0^2)^{-1/2}\f$ at its centre, of which the differences
  follow.

  \param response at the extremum, before it was multiplied by a factor of a `ScaleNormalization`.
  \param k, l the extremum's levels: their ratios to the neighbouring levels are those of the differences.
  \param sigma, tau the refined scales.
  \param dimension d.
  */
  double amplitude(double response, std::size_t k, std::size_t l, double sigma, double tau, double dimension) const
  {
    const auto in_space = [&](double ratio) { return std::pow(1 + ratio * ratio, -dimension / 2); };
    const auto in_time = [](double ratio) { return 1 / std::sqrt(1 + ratio * ratio); };
    const double space = (in_space(m_sigma[k - 1] / m_sigma[k]) - in_space(m_sigma[k + 1] / m_sigma[k])) /
                         std::log(m_sigma[k + 1] / m_sigma[k - 1]) * in_time(1);
    const double time = (in_time(m_tau[l - 1] / m_tau[l]) - in_time(m_tau[l + 1] / m_tau[l])) /
                        std::log(m_tau[l + 1] / m_tau[l - 1]) * in_space(1);
    const double root = std::sqrt(tau / m_unit_time);
    return -response / (root * space + sigma / m_unit_length / root * time);
  }

private:
  std::vector<double> m_sigma, m_tau;
  double m_unit_length = 1, m_unit_time = 1;
};

/*!
\ingroup PkgAnimatedMeshFeaturesResponses

The forward differences of smoothing counts of the paper \cgalCite{mykhalchuk2014},
\f$D = \sigma^2\tau^{1/2} (L_{k+1,l} - L_{k,l}) + \sigma\tau^{3/2} (L_{k,l+1} - L_{k,l})\f$, in the units of the
sampling.

\cgalModels{SpaceTimeResponse}
*/
class Forward_difference_of_gaussians
{
public:
  static constexpr std::size_t below = 0; ///< q
  static constexpr std::size_t above = 1; ///< p

  /// takes over the scales, before any weight is asked for.
  /// \param sigma, tau the scales of the levels (length, seconds).
  /// \param levels has the units in which they are measured.
  void initialize(const std::vector<double>& sigma, const std::vector<double>& tau, const Scale_levels& levels)
  {
    m_sigma = sigma;
    m_tau = tau;
    for (double& s : m_sigma) s /= levels.unit_length;
    for (double& t : m_tau) t /= levels.unit_time;
  }

  /// \f$a_{k,l} = \sigma_k^2 \tau_l^{1/2}\f$
  double space_weight(std::size_t k, std::size_t l) const { return m_sigma[k] * m_sigma[k] * std::sqrt(m_tau[l]); }

  /// \f$b_{k,l} = \sigma_k \tau_l^{3/2}\f$
  double time_weight(std::size_t k, std::size_t l) const { return m_sigma[k] * m_tau[l] * std::sqrt(m_tau[l]); }

private:
  std::vector<double> m_sigma, m_tau;
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_SCALE_SPACE_DIFFERENCE_OF_GAUSSIANS_H
