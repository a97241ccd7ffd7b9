// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANIMATED_MESH_GENERATORS_INTERNAL_RIGID_MOTION_H
#define ANIMATED_MESH_GENERATORS_INTERNAL_RIGID_MOTION_H

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace Animated_mesh_generators {
namespace internal {

/*!
A rigid motion as a dual quaternion, which can be averaged without the loss of volume at bent joints that averaged
matrices suffer (Kavan, Collins, Zara and O'Sullivan, *Geometric skinning with approximate dual quaternion blending*,
ACM Transactions on Graphics 27(4), 2008).

`q` and `-q` are one rotation. Motions that are to be averaged must have their signs agree, which they do if each is
the product of the one before and a turn by less than half a circle, made by `turn()`.
*/
struct Rigid_motion
{
  Eigen::Vector4d rotation = Eigen::Vector4d(0, 0, 0, 1); // x, y, z, w
  Eigen::Vector4d dual = Eigen::Vector4d::Zero();

  Rigid_motion() = default;

  /// rotates, then translates.
  Rigid_motion(const Eigen::Quaterniond& q, const Eigen::Vector3d& translation)
    : rotation(q.coeffs())
    , dual(0.5 * (Eigen::Quaterniond(0, translation.x(), translation.y(), translation.z()) * q).coeffs())
  {}

  /// a rotation about a point.
  static Rigid_motion turn(const Eigen::Quaterniond& q, const Eigen::Vector3d& centre)
  {
    return Rigid_motion(q, centre - q * centre);
  }

  Eigen::Quaterniond quaternion() const { return Eigen::Quaterniond(rotation); }

  Eigen::Vector3d translation() const { return 2 * (Eigen::Quaterniond(dual) * quaternion().conjugate()).vec(); }

  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return quaternion() * p + translation(); }

  /// first `second`, then `first`.
  friend Rigid_motion operator*(const Rigid_motion& first, const Rigid_motion& second)
  {
    return Rigid_motion(first.quaternion() * second.quaternion(), first(second.translation()));
  }

  /// adds a motion with a weight to an average that started with `zero()` and ends with `normalise()`.
  void add(double weight, const Rigid_motion& m)
  {
    rotation += weight * m.rotation;
    dual += weight * m.dual;
  }

  static Rigid_motion zero()
  {
    Rigid_motion m;
    m.rotation.setZero();
    return m;
  }

  void normalise()
  {
    const double norm = rotation.norm();
    rotation /= norm;
    dual /= norm;
  }
};

} // namespace internal
} // namespace Animated_mesh_generators

#endif // ANIMATED_MESH_GENERATORS_INTERNAL_RIGID_MOTION_H
