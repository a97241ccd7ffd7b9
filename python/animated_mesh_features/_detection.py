# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Features, the fields in which they are found, and geodesic balls."""

import numpy as np

from . import _core
from ._animation import Animation, Shape, _numbers, _shape_text, animation_of
from ._exceptions import InputError, OptionError
from ._options import arguments, takes

#: The type of a feature: a row of `Detection.features`.
#:
#: vertex, frame (int64): where and when the response is strongest, from 0. time (s): the same, refined between frames;
#: refined_frame: the same as a number of frames. position (3): the place on the moving surface at that time;
#: rest_position (3) on the rest shape. triangle (3 of int64), barycentric_coordinates (3): the place in a form that
#: holds for every frame. sigma (length), tau (s): spatial and temporal scale, standard deviations of a Gaussian event.
#: radius (length): sqrt(2) sigma. response: negative. amplitude: how much more than at its least the surface is
#: deformed. fit: the correlation with the Gaussian. strength: amplitude times fit, less where the ranges of sigma and tau begin. place (int64): features at one place
#: at different times share a number. parent (int64): the rank of a stronger feature of another scale in which this one
#: lies, -1 if there is none. at_scale_limit (bool): found at the smallest or largest scale searched.
#: Ranks and places are counted from 0, as rows of the array are; in files, from 1.
feature_dtype = _core.feature_dtype

_FIELDS = ("strain", "curvature", "deformation")


class Detection:
    """What a detection found: `features`, strongest first, and how it came to them."""

    def __init__(self, data, animation):
        self._data = data
        self._animation = animation
        self._features = data.features

    def __len__(self):
        return len(self._features)

    def __repr__(self):
        if len(self) == 0:
            return f"<Detection of no features{': ' + self.reason if self.reason else ''}>"
        f = self._features[0]
        return (f"<Detection of {len(self)} feature{'s' if len(self) > 1 else ''}, the strongest ({f['strength']:.3f}) "
                f"at vertex {f['vertex']}, frame {f['frame']}>")

    @property
    def features(self) -> np.ndarray:
        """a structured array of `feature_dtype`, strongest first: ``r.features["vertex"]``, ``r.features[:10]``."""
        return self._features

    @property
    def animation(self):
        """the `Animation` in which they were found; the `Shape` for a field of your own."""
        return self._animation

    def _field(self, kind):
        values = self._data.field(kind)
        if values is None:
            raise OptionError(f"the {kind} was not kept; keep_fields=(\"{kind}\",) keeps it")
        return values

    @property
    def deformation(self) -> np.ndarray:
        """N x F: the field in which features were found, strain + alpha |change of curvature|, less its baseline.
        Read-only, no copy."""
        return self._field("deformation")

    @property
    def strain(self) -> np.ndarray:
        """N x F, if it was kept."""
        return self._field("strain")

    @property
    def curvature(self) -> np.ndarray:
        """N x F: the absolute change from the rest shape, if it was kept."""
        return self._field("curvature")

    @property
    def sigma_levels(self) -> np.ndarray:
        """the spatial scales of the scale space (length)."""
        return self._data.sigma_levels

    @property
    def tau_levels(self) -> np.ndarray:
        """the temporal scales of the scale space (s)."""
        return self._data.tau_levels

    @property
    def ball_radius(self) -> float:
        """of the geodesic balls (length); 0 if there were none."""
        return self._data.ball_radius

    @property
    def number_of_minima(self) -> int:
        """of the response, before thresholds and suppression."""
        return self._data.number_of_minima

    @property
    def parameters(self) -> dict:
        """all that is needed to find the same features again, as it stands in the JSON file."""
        return self._data.description["parameters"]

    @property
    def reason(self) -> str:
        """why there are no features, and what may be done, as the end of a sentence; empty if there are some."""
        return self._data.reason

    def write(self, output=None, *, write_field=None, html=None, html_every=None, vtk=None, glb=None, plot=None,
              png=None, frame=None, png_size=None, png_background=None, view=None, up=None, views=None, view_map=None,
              vertex_map=None, no_sync=False):
        """Writes files, as the program ``detect_features`` does: all of them or none.

        Parameters
        ----------
        output : path or sequence of paths, optional
            the features: .json, .csv or .ply by its ending; "json:FILE" and so on whatever its name; "-" for the
            standard output.
        write_field : str or sequence of str, optional
            "deformation:FILE", "strain:FILE" or "curvature:FILE": a NumPy file (.npy), N x F, float32. Of fields that
            were kept.
        html : path, optional
            a page for the browser to play, turn and search.
        html_every : int, optional
            take every n-th frame into the page.
        vtk, glb, plot, png : path, optional
            a folder for ParaView; a scene for Blender; a plot of the features over time (.svg, .pdf, .png); a picture.
        frame : int or sequence of int, optional
            the frames of the picture, by default those of the strongest features.
        png_size, png_background, view, up : str, optional
            "1600x1000", "ffffff"; "auto", "front", "back", "left", "right", "top", "bottom" or "AZIMUTH,ELEVATION" in
            degrees; "x", "y" or "z".
        views, view_map : path, optional
            the views that show most of the features, with a camera's path over the clip (JSON); a map of what views
            from all sides show of them (.svg, .pdf, .png).
        vertex_map : path, optional
            which vertices of the input the vertices here are made of (CSV).
        no_sync : bool
            do not wait for the disk.

        Raises
        ------
        OutputError
            if a file cannot be written.
        OptionError
            if the module was built without what writes one, or a field was not kept.
        """
        given = arguments(output=output, write_field=write_field, html=html, html_every=html_every, vtk=vtk, glb=glb,
                          plot=plot, png=png, frame=frame, png_size=png_size, png_background=png_background,
                          view=view, up=up, views=views, view_map=view_map, vertex_map=vertex_map, no_sync=no_sync)
        if not any(a.startswith(("--output", "--write-field", "--html=", "--vtk", "--glb", "--plot", "--png=",
                                 "--views=", "--view-map=", "--vertex-map")) for a in given):
            raise TypeError("write() needs a file to write")
        self._data.write(given)


@takes("arrays", "measures", "search", "selection", "resources", "running")
def detect(frames, faces=None, *, keep_fields=("deformation",), visitor, **options) -> Detection:
    """Detects the spatio-temporal feature points of an animated mesh: where, when, how large and how long it deforms in
    a distinctive way.

    >>> r = amf.detect(frames, faces, frame_duration=1/30, rest="average")  # F x N x 3, T x 3
    >>> r.features["time"], r.features["position"], r.deformation

    All options are those of the command line, with the same names and defaults, and the features are the same, bit for
    bit. Python's lock is released while it computes. Time is linear in N F times the number of pairs of levels; memory
    is that of the animation, of the deformation, and of some levels of the scale space, N F each.

    Parameters
    ----------
    {arrays}
    {measures}
    {search}
    {selection}
    keep_fields : sequence of {"deformation", "strain", "curvature"}
        which fields the result has, N x F each.
    {resources}
    {running}

    Returns
    -------
    Detection
        its `features` are a structured array, its `deformation` is N x F.

    Raises
    ------
    {errors}
    """
    if isinstance(keep_fields, str):
        keep_fields = (keep_fields,)
    for kind in keep_fields:
        if kind not in _FIELDS:
            raise OptionError(f"keep_fields: there is no \"{kind}\"; choose among {', '.join(_FIELDS)}")
    animation = animation_of(frames, faces, options, visitor)
    return Detection(_core.detect(animation._data, arguments(**options), list(keep_fields), visitor), animation)


@takes("clock", "fps", "preset", "search", "selection", "running")
def detect_in_field(field, shape, faces=None, *, noise=0.0, baseline="none", frame_duration, fps, visitor,
                    **options) -> Detection:
    """Finds features in a field of your own: temperature, muscle activity, the error of a simulation. Its positive
    bumps are found.

    Parameters
    ----------
    field : array_like, N x F
        finite values at N vertices in F frames.
    shape : array_like, N x 3, or Shape or Animation
        the surface at rest; on an animation, features have their places on the moving surface.
    faces : array_like of int, T x 3
        with an array of vertices.
    frame_duration, fps : float, optional
        see `detect()`; those of the animation, if there is one.
    noise : float
        responses that are at most that strong count as errors of the field.
    preset : {"calibrated", "published"}
        see `detect()`; the paper's own choices are marked (p).
    baseline : {"none", "least"}
        what is subtracted from the field of each vertex: nothing, or its least value over the clip.
    {search}
    {selection}
    {running}

    The unit of the field is not known: if there is no threshold, `relative_threshold` is 0.2.

    Returns
    -------
    Detection
        `deformation` is the field.

    Raises
    ------
    {errors}
    """
    if not isinstance(shape, Shape):
        if faces is None:
            raise TypeError("faces are needed: detect_in_field(field, vertices, faces)")
        shape = Shape(shape, faces)
    elif faces is not None:
        raise TypeError("faces goes with an array of vertices")
    if frame_duration is not None and fps is not None:
        raise TypeError("frame_duration and fps exclude each other")
    if isinstance(shape, Animation):
        if frame_duration is not None or fps is not None:
            raise TypeError("the animation has its own time between two frames")
        frame_duration = shape.frame_duration
    elif frame_duration is None:
        frame_duration = 1 / (30.0 if fps is None else float(fps))
    values = _numbers(field, "the field")
    if values.ndim != 2:
        raise InputError(f"the field: vertices x frames are expected, not {_shape_text(values)}")
    return Detection(_core.detect_in_field(shape._data, values, float(frame_duration), float(noise),
                                           arguments(baseline=baseline, **options), visitor), shape)


def _measure(kind, frames, faces, visitor, options):
    animation = animation_of(frames, faces, options, visitor)
    return _core.measure(animation._data, kind, arguments(**options), visitor)


@takes("arrays", "preset", "strain", "resources", "running")
def strain(frames, faces=None, *, visitor, **options) -> np.ndarray:
    """Measures the strain of all vertices in all frames against the rest shape: N x F, without unit, O(N F).

    Parameters
    ----------
    {arrays}
    preset : {"calibrated", "published"}
        the mean by area at rest, or the plain mean, over the triangles of a vertex.
    strain : {"hencky", "green-lagrange", "stretch", "largest-eigenvalue"}, optional
        by default that of the preset.
    {resources}
    {running}

    Raises
    ------
    {errors}
    """
    return _measure("strain", frames, faces, visitor, options)


@takes("arrays", "preset", "curvature", "balls", "ball_radius", "resources", "running")
def curvature(frames, faces=None, *, visitor, **options) -> np.ndarray:
    """Measures the absolute change of curvature from the rest shape, over geodesic balls: N x F, without unit, O(N F)
    and the balls.

    Parameters
    ----------
    {arrays}
    preset : {"calibrated", "published"}
        see `detect()`, as `curvature`, `balls` and `ball_radius`.
    {resources}
    {running}

    Raises
    ------
    {errors}
    """
    return _measure("curvature", frames, faces, visitor, options)


@takes("arrays", "measures", "resources", "running")
def deformation(frames, faces=None, *, visitor, **options) -> np.ndarray:
    """Measures the deformation in which features are found: strain + alpha |change of curvature|, less what never
    changes. N x F, without unit.

    Parameters
    ----------
    {arrays}
    {measures}
    {resources}
    {running}

    Raises
    ------
    {errors}
    """
    return _measure("deformation", frames, faces, visitor, options)


@takes("ball_radius", "balls", "running")
def geodesic_balls(shape, faces=None, *, visitor, **options):
    """Finds for each vertex the vertices within a geodesic distance.

    Parameters
    ----------
    shape : array_like, N x 3, or Shape or Animation
        the surface at rest.
    faces : array_like of int, T x 3
        with an array of vertices.
    ball_radius, balls
        see `detect()`.
    {running}

    Returns
    -------
    offsets : ndarray of int64, N + 1
    vertices : ndarray of uint32
        the ball of vertex `v` is ``vertices[offsets[v]:offsets[v + 1]]``, ascending, `v` included: the index arrays of
        a sparse matrix, ``scipy.sparse.csr_matrix((numpy.ones(len(vertices)), vertices, offsets))``.
    """
    if not isinstance(shape, Shape):
        if faces is None:
            raise TypeError("faces are needed: geodesic_balls(vertices, faces)")
        shape = Shape(shape, faces)
    elif faces is not None:
        raise TypeError("faces goes with an array of vertices")
    return _core.geodesic_balls(shape._data, arguments(**options), visitor)
