// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_READING_DENOISE_H
#define PROGRAMS_READING_DENOISE_H

#include "reading/Reading_options.h"
#include "reading/Sequence.h"
#include "reading/take_rest.h"

#include <CGAL/Animated_mesh_features/Numerics/parallel/Any_visitor.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Programs {

struct Denoised
{
  double noise = 0;                 // that was taken out, a length; 0 if none was
  std::optional<std::size_t> frame; // that was the given shape, before
};

// Takes the noise out of a sequence, as the options ask for it or, if they leave it open, where it is large enough to hide
// deformations. `given` returns a shape of the same body, such as its mesh at rest, empty if there is none: then, or if it
// is one of the frames or in another unit, the average of all frames is what deforms; it is called only where there is
// noise. Notes what was done, or could be.
// throws what `given` throws, Numerical_error, Cancelled.
Denoised denoise(const Reading_options& options, const Mesh& mesh, const std::function<Rest_points()>& given,
                 std::optional<Sequence>& sequence, std::vector<std::string>& notices,
                 CGAL::Animated_mesh_features::Any_visitor visitor);

} // namespace Programs

#endif // PROGRAMS_READING_DENOISE_H
