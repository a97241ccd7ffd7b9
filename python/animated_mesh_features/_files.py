# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of features."""

import os
from typing import Any, Dict, List, NamedTuple

import numpy as np

from . import _core


class FeatureFile(NamedTuple):
    """A file of features, as `read_features()` reads it."""

    features: np.ndarray  #: a structured array of `feature_dtype`, strongest first
    animation: Dict[str, Any]  #: vertices, faces, frames, frame_duration, bounding_box_diagonal, mean_edge_length
    parameters: Dict[str, Any]  #: what it takes to find the same features again
    file_vertices: List[List[int]]  #: of each feature, where vertices were welded; else empty


def read_features(path) -> FeatureFile:
    """Reads features from a JSON file, as `Detection.write()` and the program ``detect_features`` write it: they are
    the same numbers, bit for bit.

    Raises
    ------
    InputError
        if it is no such file. The message names the member, as ``features[3].sigma``.
    """
    data = _core.read_features(os.fsdecode(path))
    return FeatureFile(data["features"], data["animation"], data["parameters"], data.get("file_vertices", []))
