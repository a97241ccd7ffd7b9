// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_REPORT_H
#define DETECT_FEATURES_REPORT_H

#include "detect_features/Detection.h"
#include "detect_features/Method_options.h"
#include "output/Output_options.h"
#include "reading/Animation.h"
#include "reading/Reading_options.h"

#include <CGAL/Animated_mesh_features/IO/Result_description.h>

#include <string>

// What is told of a detection: to the user, and in files of results.

namespace Detect_features {

// Some lines, for --verbose.
std::string detection_report(const Detection& detection);

// How long the program took (s).
struct Durations
{
  double computing, writing; // with reading; with drawing
};

// One line: what was found in how many seconds, or why nothing was, and where it was written.
std::string summary(const Programs::Output_options& output, const Programs::Animation& animation,
                    const Method_options& method, const Detection& detection, const Durations& seconds);

// What the JSON file tells besides the features: all that is needed to find the same ones again.
CGAL::Animated_mesh_features::IO::Result_description result_description(const Programs::Reading_options& reading,
                                                                        const Method_options& method,
                                                                        const Programs::Animation& animation,
                                                                        const Detection& detection);

} // namespace Detect_features

#endif // DETECT_FEATURES_REPORT_H
