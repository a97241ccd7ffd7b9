# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Fewer vertices for all frames at once."""

import json
from typing import NamedTuple, Optional, Tuple

import numpy as np

from . import _core
from ._animation import Animation, _frames, animation_of
from ._exceptions import InputError, OptionError
from ._options import arguments, documented
from .evaluation import _features


class Level(NamedTuple):
    """One level of detail of an animation of N vertices: M of its own, each of which follows a few of the original, in
    this animation and in any other of the same mesh."""

    vertices: np.ndarray  #: M x 3: where they are at rest
    faces: np.ndarray  #: T x 3 of int64
    data: np.ndarray  #: weights, the sum of each row is 1
    indices: np.ndarray  #: int64: the vertices of the original that they are weights of
    indptr: np.ndarray  #: M + 1 of int64: row v is ``indices[indptr[v]:indptr[v + 1]]``
    vertex_of: np.ndarray  #: N of int64: which vertex here has taken the place of each of the original; -1: none
    errors: Optional[np.ndarray]  #: see `Simplification.levels`; None if they were not measured

    def __repr__(self):
        m, n = self.shape
        return f"<Level of {m} vertices, which follow {n}, and {len(self.faces)} triangles>"

    @property
    def shape(self) -> Tuple[int, int]:
        """M, N: ``scipy.sparse.csr_matrix((level.data, level.indices, level.indptr), level.shape)`` is the matrix by
        which vertices follow."""
        return len(self.vertices), len(self.vertex_of)

    def positions(self, frames) -> np.ndarray:
        """Where the vertices are if those of the original are at `frames`: F x M x 3 of F x N x 3, of whatever
        animation of the same mesh.

        Raises
        ------
        InputError
            if it has another number of vertices.
        """
        arrays = [frames.frames] if isinstance(frames, Animation) else _frames(frames)
        fine = arrays[0] if arrays and arrays[0].ndim == 3 else arrays
        result = np.empty((len(fine), len(self.vertices), 3))
        for f, positions in enumerate(fine):
            if len(positions) != len(self.vertex_of):
                raise InputError(f"frames: has {len(positions)} vertices, the original {len(self.vertex_of)}")
            np.add.reduceat(self.data[:, None] * positions[self.indices], self.indptr[:-1], axis=0, out=result[f])
        return result


class Simplification:
    """What `simplify()` made of an animation."""

    def __init__(self, data, animation):
        self._data = data
        self._animation = animation
        self._levels = [Level(data.vertices(i), data.faces(i), *data.binding(i), data.vertex_of(i), data.errors(i))
                        for i in range(data.number_of_levels)]

    def __repr__(self):
        sizes = ", ".join(str(len(level.vertices)) for level in self._levels)
        return f"<Simplification of {self._animation.number_of_vertices} vertices to {sizes}>"

    def __str__(self):
        return self._data.table if self.report["levels"] else repr(self)

    @property
    def animation(self) -> Animation:
        """what was simplified."""
        return self._animation

    @property
    def levels(self) -> list:
        """`Level`, from fine to coarse, one for each number of vertices that was asked for.

        Their `errors` are structured arrays of F: frame; mean_to_original, max_to_original: the mean and the largest
        distance of the coarse surface from the original (length); mean_to_coarse, max_to_coarse: those of the original
        from the coarse surface; normal_angle: the mean angle between normals (degrees); mean_in_regions,
        mean_elsewhere: mean_to_coarse where features are while they last, and elsewhere; share_in_regions: of the area;
        turned: coarse triangles that look the other way than the original around them."""
        return self._levels

    @property
    def poses(self) -> list:
        """the frames whose quadrics were summed."""
        return self._data.poses

    @property
    def report(self) -> dict:
        """the errors of all levels, as the program ``simplify_animation`` writes them with ``--report``: in % of the
        bounding box's diagonal. ``print(simplification)`` shows a table."""
        return json.loads(self._data.report)


@documented
def simplify(frames, faces=None, *, vertices=None, ratio=None, lods=None, error=None, poses=None, features=None,
             guidance=None, normals=None, support=None, refinements=None, measure=True, frame_duration=None, fps=None, rest=None,
             rescale_rest=False, triangulate=False, weld="auto", repair=False, skip_bad_frames=False,
             denoise=None, memory=None,
             scratch=None, threads=None, visitor=None) -> Simplification:
    """Collapses edges of the mesh where that changes the surface least, in all poses together: one coarse connectivity
    for all frames, or several, nested. No collapse turns a triangle over in any frame, the topology stays.

    >>> s = amf.simplify(frames, faces, ratio=0.1)
    >>> coarse = s.levels[0]
    >>> coarse.positions(frames), coarse.faces   # F x M x 3, T x 3
    >>> print(s)                                 # how far it is from the original

    One of `vertices`, `ratio`, `lods` and `error` tells how much is left. Options have the names and defaults of the
    program ``simplify_animation``, and the result is the same. O(N log N P + N F) time for P poses, of which each takes
    80 bytes a vertex.

    Parameters
    ----------
    {arrays}
    vertices : int or sequence of int, optional
        so many vertices; several numbers are levels of detail, from fine to coarse.
    ratio : float, optional
        this share of the vertices, up to 1.
    lods : sequence of float, optional
        levels of detail, nested: these shares of the vertices, such as ``(0.5, 0.25, 0.1)``.
    error : float, optional
        as few vertices as keep the mean distance, both ways, below so many % of the diagonal of the rest shape in every
        frame; found within 10 % of their number.
    poses : int, optional
        the most poses whose quadrics are summed, by default 32.
    features : structured array or Detection, optional
        of the same animation: errors tell their regions from elsewhere.
    guidance : float, optional
        with features: how much more a feature's region counts while the feature lasts, by default 0, no more.
    normals : float, optional
        the most by which a collapse may turn a normal in any frame, in degrees below 90, by default 78.5.
    support : int, optional
        the most vertices of the original that one vertex follows, up to 64, by default 8.
    refinements : int, optional
        how often the places of a level's vertices are refined by the distances between both surfaces, by default 6,
        with `error` 1.
    measure : bool
        whether errors are measured, in all frames, which takes several times as long as the simplification.
    {resources}
    {running}

    Raises
    ------
    {errors}
    """
    keywords = dict(locals())
    for name in ("frames", "faces", "features", "measure", "visitor"):
        del keywords[name]
    if guidance is not None and features is None:
        raise OptionError("guidance goes with features")
    chosen = _features(np.zeros(0, dtype=_core.feature_dtype) if features is None else features)
    own = {name: keywords.pop(name) for name in ("vertices", "ratio", "lods", "error", "poses", "guidance", "normals",
                                                 "support", "refinements")}
    if keywords["denoise"] is None and not isinstance(frames, Animation):
        keywords["denoise"] = "never"  # what is to be simplified is what was given, as in the program
    animation = animation_of(frames, faces, dict(keywords, visitor=visitor))
    n, length = animation.number_of_vertices, animation.number_of_frames
    if (chosen["vertex"] >= n).any() or (chosen["frame"] >= length).any():
        raise InputError(f"features: some are not of the {n} vertices and {length} frames of the animation")
    data = _core.simplify(animation._data, chosen, arguments(**own, threads=threads), bool(measure), visitor)
    return Simplification(data, animation)
