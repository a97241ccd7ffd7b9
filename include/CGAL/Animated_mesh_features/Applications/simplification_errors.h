// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_ERRORS_H
#define CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_ERRORS_H

#include <CGAL/Animated_mesh_features/Animation/Rest_shape.h>
#include <CGAL/Animated_mesh_features/Animation/Spatio_temporal_field.h>
#include <CGAL/Animated_mesh_features/Animation/Vertex_trajectories.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Measured_surface.h>
#include <CGAL/Animated_mesh_features/Applications/internal/Surface_samples.h>
#include <CGAL/Animated_mesh_features/Applications/internal/turned_triangles.h>
#include <CGAL/Animated_mesh_features/Numerics/exceptions.h>
#include <CGAL/Animated_mesh_features/Numerics/parallel/parallel_for.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

How far a simplified surface is from the original in one frame. Lengths are in the unit of the coordinates.
*/
struct Simplification_error
{
  std::size_t frame = 0;       ///< from 0
  double mean_to_original = 0; ///< the mean distance of the coarse surface from the original
  double mean_to_coarse = 0;   ///< the mean distance of the original from the coarse surface
  double max_to_original = 0;  ///< the largest distance of the coarse surface from the original
  double max_to_coarse = 0;    ///< the largest distance of the original from the coarse surface
  double normal_angle = 0;     ///< the mean angle between normals, from the original to the coarse surface (degrees)
  double mean_in_regions = 0;  ///< `mean_to_coarse` of what is in regions; 0 if nothing is
  double mean_elsewhere = 0;   ///< `mean_to_coarse` of all the rest; 0 if there is none
  double share_in_regions = 0; ///< the share of the original's area that is in regions
  std::size_t turned = 0;      ///< coarse triangles that look away from the original around their corners

  /// triangles of the original that look away from what is around their own corners.
  std::size_t turned_in_original = 0;

  /// coarse triangles that look away from the original nearest to them, which is another part of the body where two
  /// touch: all that can be told if `Simplification_error_options::vertex_of` is not known, and `turned` in that case.
  std::size_t turned_from_nearest = 0;

  /// the mean of both mean distances.
  double mean() const { return (mean_to_original + mean_to_coarse) / 2; }

  /// the Hausdorff distance of the samples: the larger one of both largest distances.
  double hausdorff() const { return (std::max)(max_to_original, max_to_coarse); }
};

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

What `simplification_errors()` measures.
*/
struct Simplification_error_options
{
  /// which frames; empty: all.
  std::vector<std::size_t> frames;

  /// about how many samples each surface has, besides all of its vertices and at least one a triangle; 0: twice as
  /// many as the original has triangles.
  std::size_t samples = 0;

  /// `N x F`, positive where a vertex is in a region in a frame; null: no regions. See `feature_regions()`.
  const Spatio_temporal_field<float>* regions = nullptr;

  /// `N`, for each vertex of the original the coarse vertex that has taken its place, or `Rest_shape::none`, see
  /// `Animation_level::vertex_of`: a coarse triangle is compared with the sum of the normals, by area, around the
  /// vertices whose place its corners have taken. Where that sum is shorter than half of their area, that is, on
  /// more than a hemisphere or a crumpled piece, the original has no side to look away from. Null: with the original nearest to
  /// it.
  const std::vector<Rest_shape::Index>* vertex_of = nullptr;
};

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

measures how far a simplified surface is from the original, in each frame. Both surfaces are sampled alike in all
frames: at points that move with them.

\param rest the original at rest.
\param trajectories its `N` vertices in `F` frames.
\param triangles of the coarse surface.
\param rest_points of the coarse surface at rest.
\param coarse a functor that returns the coarse surface's points in a frame, `std::vector<Rest_shape::Point>`; called
  from several threads.
\param options what is measured.
\returns one for each frame, in the order of `options.frames`.
\throw Option_error if there is no such frame, or regions are of another size.

For each frame \f$O(S \log N)\f$ for `S` samples, less where surfaces move little; on several threads if oneTBB is
there. The result is the same bits whatever their number.
*/
template <class FT, class Coarse>
std::vector<Simplification_error>
simplification_errors(const Rest_shape& rest, const Vertex_trajectories<FT>& trajectories,
                      const std::vector<Rest_shape::Triangle>& triangles,
                      const std::vector<Rest_shape::Point>& rest_points, const Coarse& coarse,
                      const Simplification_error_options& options = Simplification_error_options())
{
  std::vector<std::size_t> frames = options.frames;
  if (frames.empty())
    for (std::size_t f = 0; f < trajectories.number_of_frames(); ++f) frames.push_back(f);
  for (std::size_t f : frames)
    if (f >= trajectories.number_of_frames())
      throw Option_error("there is no frame " + std::to_string(f) + " to measure");
  if (options.regions != nullptr && (options.regions->number_of_rows() != rest.number_of_vertices() ||
                                     options.regions->number_of_frames() != trajectories.number_of_frames()))
    throw Option_error("regions are not of this animation");
  if (options.vertex_of != nullptr && options.vertex_of->size() != rest.number_of_vertices())
    throw Option_error("the coarse vertices are not of this animation");
  if (triangles.empty()) throw Option_error("there is no simplified surface to measure");
  const std::size_t number = options.samples > 0 ? options.samples : 2 * rest.triangles().size();
  const internal::Surface_samples of_original(rest.triangles(), rest.points(), number);
  const internal::Surface_samples of_coarse(triangles, rest_points, number);
  std::vector<Rest_shape::Index> itself(rest.number_of_vertices());
  std::iota(itself.begin(), itself.end(), Rest_shape::Index(0));
  std::vector<Simplification_error> errors(frames.size());
  constexpr std::size_t block = 8; // frames in which guesses carry over: fixed, for the same bits
  parallel_for<CGAL::Parallel_if_available_tag>(0, (frames.size() + block - 1) / block, [&](std::size_t b) {
    internal::Measured_surface fine(rest.triangles(), rest.points()), other(triangles, rest_points);
    std::vector<Rest_shape::Index> guesses, other_guesses;
    for (std::size_t k = b * block; k < (std::min)(frames.size(), (b + 1) * block); ++k) {
      const std::size_t f = frames[k];
      fine.follow(trajectories.frame(f).points());
      other.follow(coarse(f));
      Simplification_error& e = errors[k];
      e.frame = f;
      double area = 0, area_in = 0, in = 0;
      internal::measure_samples(
          of_original, fine, other, guesses, [&](const auto& s, double a, double d, double cosine) {
            area += a;
            e.mean_to_coarse += a * d;
            e.max_to_coarse = (std::max)(e.max_to_coarse, d);
            e.normal_angle += a * std::acos(cosine) * 57.29577951308232;
            if (options.regions == nullptr) return;
            double inside = 0;
            for (std::size_t c = 0; c < 3; ++c)
              inside += (*options.regions)(rest.triangles()[s.triangle][c], f) > 0 ? s.place[c] : 0;
            if (inside < .5) return;
            area_in += a;
            in += a * d;
          });
      if (area > area_in) e.mean_elsewhere = (e.mean_to_coarse - in) / (area - area_in);
      if (area_in > 0) e.mean_in_regions = in / area_in;
      if (area > 0) {
        e.mean_to_coarse /= area;
        e.normal_angle /= area;
        e.share_in_regions = area_in / area;
      }
      double coarse_area = 0;
      std::vector<double> look(triangles.size(), 0);
      internal::measure_samples(of_coarse, other, fine, other_guesses,
                                [&](const auto& s, double a, double d, double cosine) {
                                  coarse_area += a;
                                  e.mean_to_original += a * d;
                                  e.max_to_original = (std::max)(e.max_to_original, d);
                                  look[s.triangle] += s.share * cosine;
                                });
      if (coarse_area > 0) e.mean_to_original /= coarse_area;
      e.turned_from_nearest = std::size_t(std::count_if(look.begin(), look.end(), [](double x) { return x < 0; }));
      e.turned_in_original = internal::turned_triangles(rest, fine.normals(), itself, rest.triangles(), fine.normals());
      e.turned = options.vertex_of == nullptr
                     ? e.turned_from_nearest
                     : internal::turned_triangles(rest, fine.normals(), *options.vertex_of, triangles, other.normals());
    }
  });
  return errors;
}

/*!
\ingroup PkgAnimatedMeshFeaturesSimplification

the frame in which the mean distance is largest; the first of several.
\param errors at least one.
*/
inline const Simplification_error& worst_frame(const std::vector<Simplification_error>& errors)
{
  return *std::max_element(
      errors.begin(), errors.end(),
      [](const Simplification_error& a, const Simplification_error& b) { return a.mean() < b.mean(); });
}

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_APPLICATIONS_SIMPLIFICATION_ERRORS_H
