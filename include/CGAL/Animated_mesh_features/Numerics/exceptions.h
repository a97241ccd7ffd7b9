// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANIMATED_MESH_FEATURES_NUMERICS_EXCEPTIONS_H
#define CGAL_ANIMATED_MESH_FEATURES_NUMERICS_EXCEPTIONS_H

#include <stdexcept>

namespace CGAL {
namespace Animated_mesh_features {

/*!
\ingroup PkgAnimatedMeshFeaturesExceptions

The base of all exceptions that the package throws for a reason that the caller can meet in practice.
Exceptions are told apart by what the caller can do about them.
*/
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
\ingroup PkgAnimatedMeshFeaturesExceptions

The data are unusable: a file that is missing or malformed, a face that is no triangle, a coordinate that is not
finite, a rest shape in another unit. The message names the file, the frame and the vertex, edge or face as far as
they are known. Repair the data.
*/
class Input_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgAnimatedMeshFeaturesExceptions

An option has a value that makes no sense for this animation, such as an empty range of scales. Change the option.
*/
class Option_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgAnimatedMeshFeaturesExceptions

A result could not be written. What stood under that name before is still there.
*/
class Output_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgAnimatedMeshFeaturesExceptions

A numerical method failed, for instance the factorisation of a Laplacian that contains non-finite cotangents.
*/
class Numerical_error : public Error
{
public:
  using Error::Error;
};

/*!
\ingroup PkgAnimatedMeshFeaturesExceptions

The visitor asked to stop. No result is returned; the detector stays usable.
*/
class Cancelled : public Error
{
public:
  /// with a message of its own.
  Cancelled() : Error("cancelled by the visitor") {}
};

} // namespace Animated_mesh_features
} // namespace CGAL

#endif // CGAL_ANIMATED_MESH_FEATURES_NUMERICS_EXCEPTIONS_H
