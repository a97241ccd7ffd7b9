// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DETECT_FEATURES_REASON_FOR_NONE_H
#define DETECT_FEATURES_REASON_FOR_NONE_H

#include "detect_features/Detection.h"
#include "detect_features/Method_options.h"
#include "reading/Sequence.h"

#include <string>

namespace Detect_features {

// Why a detection found no features, as the end of a sentence, and what may be done.
std::string reason_for_none(const Programs::Sequence& sequence, const Method_options& options,
                            const Detection& detection);

} // namespace Detect_features

#endif // DETECT_FEATURES_REASON_FOR_NONE_H
