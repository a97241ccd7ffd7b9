# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Files of features, and of animations."""

import os
from typing import Any, Dict, List, NamedTuple

import numpy as np

from . import _core
from ._animation import Animation, _faces, _frames, _points
from ._exceptions import InputError, OptionError


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


def write_animation(mesh, cache, frames, faces=None, *, rest=None, frame_duration=None, fps=None) -> None:
    """Writes an animation as a mesh and a point cache, which `read_animation()`, the programs, Blender and others read:
    both files or none. Coordinates are in single precision in the cache, exact in the mesh.

    Parameters
    ----------
    mesh : path
        .obj: the shape at rest.
    cache : path
        .pc2, which knows nothing of time, or .mdd, which has the time of each frame.
    frames : array_like, F x N x 3, or sequence of N x 3, or Animation
    faces : array_like of int, T x 3
        with an array.
    rest : array_like, N x 3, optional
        by default the first frame, or that of the animation.
    frame_duration, fps : float, optional
        see `detect()`.

    Raises
    ------
    InputError
        if the arrays make no animation, or a position is not finite in single precision.
    OutputError
        if a file cannot be written.
    """
    cache_name = os.fsdecode(cache)
    form = os.path.splitext(cache_name)[1].lower()
    if form not in (".pc2", ".mdd"):
        raise OptionError(f"{cache_name}: a point cache is a file .pc2 or .mdd")
    if os.path.splitext(os.fsdecode(mesh))[1].lower() != ".obj":
        raise OptionError(f"{os.fsdecode(mesh)}: the mesh of a point cache is a file .obj")
    if isinstance(frames, Animation):
        if faces is not None or rest is not None or frame_duration is not None or fps is not None:
            raise TypeError("an Animation has its own faces, shape at rest and time between two frames")
        animation = frames
        number, faces, rest, frame_duration = (animation.number_of_frames, animation.faces, animation.vertices,
                                               animation.frame_duration)

        def positions(f):
            return np.stack([animation.x[:, f], animation.y[:, f], animation.z[:, f]], axis=1)
    else:
        if faces is None:
            raise TypeError("faces are needed with an array of frames")
        if frame_duration is not None and fps is not None:
            raise TypeError("frame_duration and fps exclude each other")
        if frame_duration is None:
            frame_duration = 1 / (30.0 if fps is None else float(fps))
        given = _frames(frames)
        arrays: Any = given[0] if given and given[0].ndim == 3 else given
        number = len(arrays)
        if number == 0:
            raise InputError("frames: there are none")
        rest = arrays[0] if rest is None else rest

        def positions(f):
            return arrays[f]
    rest = _points(rest, "rest")

    def single(f):
        with np.errstate(over="ignore"):
            array = np.ascontiguousarray(positions(f), dtype=np.float32)
        if array.shape != rest.shape:
            raise InputError(f"frames, frame {f}: has {len(array)} vertices, the shape at rest {len(rest)}")
        good = np.isfinite(array).all(axis=1)
        if not good.all():
            raise InputError(f"frames, frame {f}: the position of vertex {int(np.argmin(good))} is not finite in single "
                             "precision")
        return array

    _core.write_animation(os.fsdecode(mesh), cache_name, form == ".mdd", rest, _faces(faces), number,
                          float(frame_duration), single)
