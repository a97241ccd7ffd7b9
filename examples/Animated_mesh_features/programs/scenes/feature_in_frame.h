// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAMS_SCENES_FEATURE_IN_FRAME_H
#define PROGRAMS_SCENES_FEATURE_IN_FRAME_H

#include "scenes/Shown_scene.h"

#include <CGAL/Animated_mesh_features/Detection/Feature_point.h>

#include <array>
#include <cstddef>

// How a feature is shown in a frame: the same in all files and pictures. Frames are counted from 0.

namespace Programs {

// How long a feature is shown before and after its time, in units of tau: there, it has faded to 14 %.
constexpr double feature_life = 2;

// How long a scene's animation is until it begins again (seconds); 0: it is not cyclic.
double period(const Shown_scene& scene);

// Whether a feature is shown in frame `f`: at most `feature_life` times tau from its time, and in any case in its own
// frame, so that there is no feature that is never seen. In a cyclic animation, with that period (seconds), it lives on across
// the end.
bool lives_in_frame(const CGAL::Animated_mesh_features::Feature_point& feature, std::size_t f, double frame_duration,
                    double period = 0);

// How much of a feature is seen in frame `f`, from 0 to 1: exp(-(t - t_0)^2 / (2 tau^2)) with the time t of the frame and
// t_0 of the feature; 0 in frames in which it does not live.
double opacity_in_frame(const CGAL::Animated_mesh_features::Feature_point& feature, std::size_t f,
                        double frame_duration, double period = 0);

// The place of a feature on the surface in frame `f`: it moves with the triangle on which it was found.
std::array<double, 3> position_in_frame(const Shown_sequence& sequence,
                                        const CGAL::Animated_mesh_features::Feature_point& feature, std::size_t f);

} // namespace Programs

#endif // PROGRAMS_SCENES_FEATURE_IN_FRAME_H
