# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Spatio-temporal feature points of animated meshes: where, when, how large and how long a surface deforms in a
distinctive way.

>>> import animated_mesh_features as amf
>>> r = amf.detect(frames, faces, frame_duration=1/30, rest="average")  # F x N x 3, T x 3
>>> r.features             # structured array: vertex, frame, time, position, sigma, tau, amplitude, fit, place, ...
>>> r.deformation          # N x F, no copy
>>> r.write("features.json", html="view.html")

detect            features of an animation, arrays in; every option of the command line is a keyword
detect_in_field   features of a field of your own
Animation         an animation that is used several times; read_animation: from files; write_animation: to files
strain, curvature, deformation, geodesic_balls
                  the parts alone
descriptors, match_features, align, animation_distance, distance_matrix
                  animations beside each other, of whatever meshes; Signature, signature: what is compared of each
simplify          fewer vertices for all frames at once
select_views      where features are seen from
read_features     files of features
evaluation        how good features are

Lengths are in the unit of the coordinates, times in seconds, vertices and frames are counted from 0. Results do not
depend on the number of threads, bit for bit.
"""


from . import _core
from ._exceptions import Cancelled, Error, InputError, Notice, NumericalError, OptionError, OutputError
from ._animation import Animation, Shape, read_animation
from ._detection import (Detection, curvature, deformation, detect, detect_in_field, feature_dtype, geodesic_balls,
                         strain)
from ._files import FeatureFile, read_features, write_animation
from ._options import options
from ._comparison import (Alignment, Signature, align, animation_distance, classical_scaling, descriptors,
                          distance_matrix, event_differences, match_features, signature)
from ._simplification import Level, Simplification, simplify
from ._views import Views, select_views
from . import evaluation

__version__ = _core.__version__

#: Whether detections run on several threads: the module was built with oneTBB.
has_threads = _core.has_threads

__all__ = ["Alignment", "Animation", "Cancelled", "Detection", "Error", "FeatureFile", "InputError", "Level", "Notice",
           "NumericalError", "OptionError", "OutputError", "Shape", "Signature", "Simplification", "Views", "align",
           "animation_distance", "classical_scaling", "curvature", "deformation", "descriptors", "detect",
           "detect_in_field", "distance_matrix", "evaluation", "event_differences", "feature_dtype", "geodesic_balls",
           "has_threads", "match_features", "options", "read_animation", "read_features", "select_views", "signature",
           "simplify", "strain", "write_animation"]

