# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Arrays and files in, surfaces and animations out."""

import os

import numpy as np

from . import _core
from ._exceptions import InputError, tell
from ._options import GROUPS, arguments, documented, takes


def _shape_text(array):
    return " x ".join(str(n) for n in array.shape) or "a single number"


def _numbers(array, what):
    """The same array if it is float32 or float64, else float64."""
    array = np.asanyarray(array)
    if isinstance(array, np.ma.MaskedArray):
        if np.ma.is_masked(array):
            raise InputError(f"{what}: some values are masked; fill them in")
        array = array.data
    if array.dtype.kind not in "fiu":
        raise InputError(f"{what}: numbers are expected, not {array.dtype}")
    if array.dtype.kind != "f" or array.dtype.itemsize not in (4, 8) or not array.dtype.isnative:
        array = array.astype(np.float64)
    return array


def _frames(frames):
    """A list of arrays, one F x N x 3 or F of N x 3."""
    if not isinstance(frames, np.ndarray) and hasattr(frames, "__array__"):
        frames = np.asanyarray(frames)  # of other libraries
    if isinstance(frames, np.ndarray):
        array = _numbers(frames, "frames")
        if array.ndim != 3 or array.shape[2] != 3:
            hint = "" if array.ndim != 3 or array.shape[1] != 3 else \
                "; frames.transpose(2, 0, 1) makes it of vertices x 3 x frames, without a copy"
            raise InputError(f"frames: frames x vertices x 3 are expected, not {_shape_text(array)}{hint}")
        arrays = [array]
    else:
        try:
            arrays = [_numbers(frame, f"frames, frame {f}") for f, frame in enumerate(frames)]
        except TypeError:
            raise InputError(f"frames: an array is expected, not {type(frames).__name__}") from None
        for f, array in enumerate(arrays):
            if array.ndim != 2 or array.shape[1] != 3:
                raise InputError(f"frames, frame {f}: vertices x 3 are expected, not {_shape_text(array)}")
            if len(array) != len(arrays[0]):
                raise InputError(f"frames, frame {f}: has {len(array)} vertices, frame 0 has {len(arrays[0])}")
    if arrays and arrays[0].shape[-2] == 0:
        raise InputError("frames: there are no vertices")
    return arrays


def _faces(faces):
    try:
        array = np.asarray(faces)
    except ValueError as e:
        raise InputError(f"faces: faces x 3 are expected: {e}") from None
    if array.dtype.kind not in "iu":
        raise InputError(f"faces: integers are expected, not {array.dtype}")
    if array.dtype == np.uint64 and array.size > 0 and int(array.max()) > np.iinfo(np.int64).max:
        raise InputError(f"faces: a face has vertex {array.max()}")
    if array.ndim != 2 or array.shape[1] < 3:
        raise InputError(f"faces: faces x 3 are expected, not {_shape_text(array)}")
    return np.ascontiguousarray(array, dtype=np.int64)


def _points(points, what):
    array = _numbers(points, what)
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"{what}: vertices x 3 are expected, not {_shape_text(array)}")
    if len(array) == 0:
        raise InputError(f"{what}: there are no vertices")
    return np.ascontiguousarray(array, dtype=np.float64)


class Shape:
    """A surface at rest: N vertices, T triangles.

    Parameters
    ----------
    vertices : array_like, N x 3
        positions.
    faces : array_like of int, T x 3
        the vertices of each triangle, counted from 0: an oriented manifold, possibly with border.

    Raises
    ------
    InputError
        if a position is not finite, or the triangles make no manifold.
    """

    def __init__(self, vertices, faces):
        self._data = _core.MeshData(_points(vertices, "vertices"), _faces(faces))

    @property
    def vertices(self) -> np.ndarray:
        """N x 3: where the vertices are at rest."""
        return self._data.vertices

    @property
    def faces(self) -> np.ndarray:
        """T x 3 of int64: the vertices of each triangle, counterclockwise, the smallest first."""
        return self._data.faces

    @property
    def areas(self) -> np.ndarray:
        """N: the share of the surface that each vertex stands for, a third of its triangles (squared length)."""
        return self._data.areas

    @property
    def diameter(self) -> float:
        """of the smallest sphere around all that deforms (length): what default lengths are fractions of."""
        return self._data.diameter

    @property
    def bounding_box_diagonal(self) -> float:
        """of the axis-parallel box around the same (length)."""
        return self._data.bounding_box_diagonal

    @property
    def mean_edge_length(self) -> float:
        """of the same (length)."""
        return self._data.mean_edge_length


@documented
class Animation(Shape):
    """An animation: a surface of N vertices that moves in F frames, and its shape at rest.

    `detect()` and the others make one of the arrays that they are given; make it yourself to use it several times, or
    to read it from files with `read_animation()`. Coordinates are kept in double precision, for each vertex
    contiguously over the frames (`x`, `y`, `z`): 24 N F bytes, beside which nothing of that size is held while arrays
    are read.

    Parameters
    ----------
    {arrays}
    {resources}
    {running}

    Raises
    ------
    {errors}
    """

    @takes("arrays", "resources", "running")
    def __init__(self, frames, faces, *, frame_duration, rest, visitor, **options):
        if frame_duration is not None:
            if options["fps"] is not None:
                raise TypeError("frame_duration and fps exclude each other")
            frame_duration = float(frame_duration)
            if not 0 < frame_duration < np.inf:
                raise InputError("the time between two frames must be positive")
            options["fps"] = 1 / frame_duration
        points = np.empty((0, 3))
        if isinstance(rest, (int, np.integer)) and not isinstance(rest, bool):
            rest = f"frame:{rest}"
        elif rest is not None and not isinstance(rest, (str, os.PathLike)):
            points, rest = _points(rest, "rest"), None
        self._take(_core.animation_of_arrays(_frames(frames), _faces(faces), points, arguments(rest=rest, **options),
                                             visitor))

    def _take(self, data):
        self._data = data
        tell(*data.notices)

    def __repr__(self):
        d = self._data
        return (f"<Animation of {d.number_of_vertices} vertices in {d.number_of_frames} frames, {d.fps:.6g} in a "
                f"second, against {d.rest_name}>")

    @property
    def number_of_vertices(self) -> int:
        """N"""
        return self._data.number_of_vertices

    @property
    def number_of_frames(self) -> int:
        """F"""
        return self._data.number_of_frames

    @property
    def frames(self) -> np.ndarray:
        """F x N x 3, float64: positions. A copy, made anew each time; see `x`."""
        return self._data.positions

    @property
    def x(self) -> np.ndarray:
        """N x F: the first coordinate of each vertex over the frames. Read-only, no copy; so are `y` and `z`."""
        return self._data.trajectories(0)

    @property
    def y(self) -> np.ndarray:
        """N x F: the second coordinate."""
        return self._data.trajectories(1)

    @property
    def z(self) -> np.ndarray:
        """N x F: the third coordinate."""
        return self._data.trajectories(2)

    @property
    def frame_duration(self) -> float:
        """seconds from one frame to the next."""
        return self._data.frame_duration

    @property
    def fps(self) -> float:
        """frames in a second."""
        return self._data.fps

    @property
    def rest(self) -> str:
        """which shape is the undeformed one, as the argument `rest` has it; "given" for an array."""
        return self._data.rest

    @property
    def rest_factor(self) -> float:
        """by which the shape was multiplied to have the frames' unit."""
        return self._data.rest_factor

    @property
    def vertex_of_input(self) -> np.ndarray:
        """for each vertex of the arrays or the file its vertex here, -1 if it has none: 0, 1, 2... unless vertices were
        welded or the surface was repaired."""
        return self._data.vertex_of_input

    @property
    def notices(self) -> list:
        """what must be known to judge the result, a sentence each; warned of as `Notice` when the animation is made."""
        return self._data.notices

    @property
    def remarks(self) -> list:
        """what was left out or changed on reading, a sentence each."""
        return self._data.remarks

    @property
    def clips(self) -> list:
        """the names of all clips in the file."""
        return self._data.clips

    @property
    def clip(self) -> str:
        """which of them this is."""
        return self._data.clip

    @property
    def files(self) -> list:
        """the files that were read."""
        return [] if self._data.files == ["faces", "frames"] else self._data.files


@takes("reading", "resources", "running")
def read_animation(*inputs, clip=None, frames=None, there_and_back=False, allow_outside=False, faces=None, part=None,
                   as_given=False, visitor, **options) -> Animation:
    """Reads an animation from files, as the program ``detect_features`` does.

    Parameters
    ----------
    *inputs : path
        a mesh (.obj, .off, .ply, .stl) and a point cache (.pc2, .mdd); or a folder with a mesh for each frame; or the
        meshes themselves; or an animated model (.glb, .gltf, .fbx, .dae, .x); or an HDF5 file as D-FAUST's. Which of
        the last two can be read depends on what the module was built with.
    fps : float, optional
        frames in a second. By default as the times in an MDD file tell; 60 for HDF5, as D-FAUST has it; otherwise 30. A
        clip is sampled at this rate.
    clip : str or int, optional
        the clip of an animated model, or the sequence of an HDF5 file, by name or by number from 0; several clips that
        play together as "A+B". By default the first.
    frames : int or str, optional
        equidistant frames to make of a clip, from its first to its last key; or "A:B", of whatever input only the
        frames from A to B, counted from 0, of which either may be left out.
    there_and_back : bool
        play the clip to its end and back again.
    allow_outside : bool
        read the data of a glTF model also where it names files outside of the model's folder: for models that you
        trust.
    faces : str, optional
        the dataset of triangles in an HDF5 file, by default "faces".
    part : str or int, optional
        a part of the surface only: of a model a node, with all that hangs below it, or a mesh, by its name, or "NAME/P"
        for its primitive P; of an OBJ file an object or a group; of whatever input the N-th connected component, 1 for
        the one with the most vertices.
    rest : str or path, optional
        the undeformed shape: a mesh file of the same connectivity; "mesh", the one given with a point cache; "bind", a
        model without any clip; "first"; "frame:12"; "average". By default the mesh, unless it is one of the frames; the
        bind pose, likewise; else the average.
    rescale_rest : bool
        scale the file, the mesh or the bind pose so that its median edge is as long as that of the frames.
    as_given : bool
        take meshes as the frames in the order in which they are given, whatever numbers are in their names.
    triangulate, weld, repair, skip_bad_frames, denoise
        see `Animation`.
    {resources}
    {running}

    Raises
    ------
    {errors}
    """
    names = [os.fsdecode(i) for i in inputs]
    animation = Animation.__new__(Animation)
    animation._take(_core.animation_of_files(names, arguments(
        clip=clip, frames=frames, there_and_back=there_and_back, allow_outside=allow_outside, faces=faces, part=part,
        as_given=as_given, **options), visitor))
    return animation


def animation_of(frames, faces, options, visitor):
    """The animation that was given, or the one of the arrays; takes out of the options what that is made of."""
    own = {name: options.pop(name) for name in (*GROUPS["arrays"], *GROUPS["resources"])}
    if isinstance(frames, Animation):
        given = [name for name, value in own.items() if value is not None and value is not False and value != "auto"]
        if faces is not None or given:
            raise TypeError(f"{'faces' if faces is not None else given[0]} goes with arrays; what is given is an "
                            "Animation, which has its own")
        return frames
    if faces is None:
        raise TypeError("faces are needed with an array of frames")
    return Animation(frames, faces, threads=options["threads"], visitor=visitor, **own)
