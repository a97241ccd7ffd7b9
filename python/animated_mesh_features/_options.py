# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""From keywords to the options of the command line, which are understood and checked in one place for both."""

import functools
import inspect
import os
import re
from typing import Any, Dict

import numpy as np

from . import _core

# What is given without a value.
_SWITCHES = frozenset(["cyclic", "no_suppression", "there_and_back", "allow_outside", "rescale_rest", "as_given", "triangulate",
                       "repair", "skip_bad_frames", "no_sync"])
# MIN:MAX
_RANGES = frozenset(["sigma_range", "tau_range"])
# numbers between commas
_LISTS = frozenset(["vertices", "lods"])
_REPEATABLE = frozenset(["output", "write_field", "frame"])
_SWITCHES |= {"mutual"}  # of a comparison

MEASURES = """
    preset : {"calibrated", "published"}
        the paper's own choices, marked (p) below, or those that repair what breaks in them. What the other options
        choose replaces a single choice of the preset.
    strain : {"hencky", "green-lagrange", "stretch", "largest-eigenvalue"}, optional
        by default "hencky", "largest-eigenvalue" (p).
    curvature : {"density", "dihedral"}, optional
        density of mean curvature, or the mean of dihedral angles (p).
    balls : {"heat", "heat-patches", "heat-global", "dijkstra"}, optional
        geodesic balls for the curvature: by the heat method (default), the same by CGAL's class on local patches (slow)
        or on the whole mesh (very slow), or by paths along edges.
    ball_radius : float or str, optional
        a length, or a percentage of the diameter of the rest shape, "4.5%". By default 4.5 % of it, between 3 and 8
        mean edge lengths, but less where balls would have more than 1,500 vertices in the mean.
    alpha : float, optional
        weight of the change of curvature against strain, by default 7; 0 leaves curvature out.
    baseline : {"least", "none"}, optional
        what is subtracted from the deformation of each vertex: its least value over the clip, or nothing (p)."""

SEARCH = """
    spatial_filter : {"heat", "one-ring"}, optional
        diffusion, or averages over neighbours (p).
    dimension : {"surface", "plane"}, optional
        responses are normalised to the surface's own dimension, or to that of a plane (p).
    temporal_filter : {"gaussian", "box"}, optional
        "box": (p).
    cyclic : bool
        the last frame is followed by the first, as in a step of a gait: no reflecting ends, and a feature may lie across
        the end. The period is as many frames as there are: leave out a last frame that repeats the first.
    box_width : int, optional
        of the temporal box, in frames; preset "published" only. By default a sixth of the frames.
    space_counts, time_counts : int, optional
        search up to so many passes of the filter in space, in time; preset "published" only. By default by the paper's
        formulas.
    sigma_range : (float or str, float or str) or str, optional
        the smallest and the largest spatial scale, as lengths or as percentages of the diameter of the rest shape,
        ``("1%", "17.5%")``; None for one of them leaves it at its default. Preset "calibrated" only.
    tau_range : (float, float) or str, optional
        the temporal scales in seconds, by default from one frame to a third of the duration, or with `cyclic` to a
        quarter. Preset "calibrated" only."""

SELECTION = """
    threshold : float, optional
        least strength, in the unit of the deformation: amplitude times fit, less where the ranges of
        scales begin. By default 0.1; (p) none.
    relative_threshold : float, optional
        least strength as a fraction of the strongest one, 0 to 1. By default none; (p) 0.2. If only one of the two
        thresholds is given, the other is none; the stricter one decides.
    min_fit : float, optional
        least correlation of the deformation around a feature with the feature's Gaussian, 0 to 1. By default 0.5; (p)
        any.
    top : int, optional
        so many features at most, the strongest ones.
    no_suppression : bool
        keep features close to stronger ones (p)."""

ARRAYS = """
    frames : array_like, F x N x 3, or Animation
        positions of N vertices in F frames, at least 3: float32 or float64 of any strides and memory maps are read
        where they are, other numbers are converted first. Also a sequence of F arrays N x 3. Or an animation that was
        made before, with which `faces` and what is made of arrays, up to `denoise`, do not go.
    faces : array_like of int, T x 3
        the vertices of each triangle, counted from 0, of any type of integers. An oriented manifold, possibly with
        border.
    frame_duration : float, optional
        seconds from one frame to the next; or
    fps : float, optional
        frames in a second, by default 30.
    rest : optional
        the undeformed shape, against which deformation is measured: an array N x 3; "average", the canonical shape of
        all frames; "first", the first frame; "frame:12" or the integer 12, another one; the name of a mesh file of the
        same connectivity. By default the average.
    rescale_rest : bool
        scale the array or the file so that its median edge is as long as that of the frames.
    triangulate : bool
        cut faces with more than three corners (T x 4 and more) into triangles, as a fan around the first corner.
    weld : {"auto", "always", "never"}
        what becomes of vertices that lie at the same place in all frames: they are welded where that closes a seam and
        makes a manifold; always, which is an error where it does not; never. After welding vertices have other numbers,
        see `Animation.vertex_of_input`.
    repair : bool
        mend a mesh that is no oriented manifold: leave out collapsed and repeated faces, turn round what is oriented
        unlike its neighbours, take apart what meets in a vertex only.
    skip_bad_frames : bool
        leave out frames that are broken, without extent or with a vertex that is exploded, and bridge them in time. By
        default they are an error, but for a single frame without extent.
    denoise : {"auto", "always", "never"}, optional
        whether noise of the positions is taken out, as scans and captures have it, independent in vertices and frames:
        by default where it is more than 10 % of the mean edge."""

RESOURCES = """
    memory : int or str, optional
        how many bytes to use at most, or "4G", "800M"; what does not fit goes to files on the scratch directory, with
        the same result. By default what is available, and nothing on a disk.
    scratch : path, optional
        the scratch directory, by default that of TMPDIR, or /var/tmp."""

RUNNING = """
    threads : int, optional
        so many at most, by default all; the result is the same, bit for bit.
    visitor : callable, optional
        ``visitor(stage, fraction)``, called from this thread some 30 times a stage with the stage's name ("geodesic
        balls", "strain", "curvature", "scale space", "extrema", "rest shape"; "descriptors", "matching", "alignment",
        "distances", "simplification", "errors", "views") and how far it is, from 0 to 1. If it returns False,
        `Cancelled` is raised; an exception of its own goes through. Ctrl-C works without one, too."""

ERRORS = """
    InputError
        if the arrays make no animation: the message names the frame, the vertex or the face.
    OptionError
        if an option makes no sense, or none for this animation.
    NumericalError
        if a factorisation fails.
    Cancelled
        if the visitor asked for it."""

DISTANCE = """
    distance_place_weight : float
        how much the places of deformation count.
    distance_recurrence_weight : float
        and how much what was before and comes after.
    cycle_weight : float
        how much cycles count, from 0 to 1.
    variation_weight : float
        and how much how far the body moves, from 0 to 1; of features alone it is not known.
    duration_weight : float
        and how much durations, from 0 to 1."""

_TEXTS = {"{measures}": MEASURES, "{search}": SEARCH, "{selection}": SELECTION, "{arrays}": ARRAYS,
          "{resources}": RESOURCES, "{running}": RUNNING, "{distance}": DISTANCE, "{errors}": ERRORS}

# The keywords that several functions take, with their defaults: the one table of them, beside their description above.
GROUPS: Dict[str, Dict[str, Any]] = {
    "clock": dict(frame_duration=None),
    "reading": dict(fps=None, rest=None, rescale_rest=False, triangulate=False, weld="auto", repair=False,
                    skip_bad_frames=False, denoise=None),
    "measures": dict(preset="calibrated", strain=None, curvature=None, balls=None, ball_radius=None, alpha=None,
                     baseline=None),
    "search": dict(spatial_filter=None, dimension=None, temporal_filter=None, cyclic=False, box_width=None,
                   space_counts=None, time_counts=None, sigma_range=None, tau_range=None),
    "selection": dict(threshold=None, relative_threshold=None, min_fit=None, top=None, no_suppression=False),
    "distance": dict(distance_place_weight=0.0, distance_recurrence_weight=1.0, cycle_weight=0.1, variation_weight=0.4,
                     duration_weight=0.1),
    "resources": dict(memory=None, scratch=None),
    "running": dict(threads=None, visitor=None),
}
GROUPS["arrays"] = {**GROUPS["clock"], **GROUPS["reading"]}
_DEFAULTS = {name: default for group in GROUPS.values() for name, default in group.items()}


def documented(function):
    """Fills in the parts that docstrings have in common."""
    if function.__doc__:  # not with python -OO
        function.__doc__ = re.sub(r"\n *(\{\w+\})", lambda m: _TEXTS[m[1]], function.__doc__)
    return function


def takes(*names):
    """Makes a function of ``**options`` one of keywords: of the groups and single keywords that are named. The function
    gets all of them, by name where it names one; whoever asks for its signature, as `help()` does, is told their names and
    defaults."""
    def decorate(function):
        taken = {}
        for name in names:
            taken.update(GROUPS[name] if name in GROUPS else {name: _DEFAULTS[name]})
        own = inspect.signature(function)
        known = [p for p in own.parameters.values() if p.kind is not p.VAR_KEYWORD and p.name not in taken]
        signature = own.replace(parameters=known + [inspect.Parameter(n, inspect.Parameter.KEYWORD_ONLY, default=d)
                                                    for n, d in taken.items()])

        @functools.wraps(function)
        def call(*positional, **keywords):
            for name in keywords:
                if name not in signature.parameters:
                    raise TypeError(f"{function.__name__}() got an unexpected keyword argument '{name}'")
            return function(*positional, **{**taken, **keywords})

        call.__signature__ = signature
        return documented(call)
    return decorate


def _text(name, value):
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        value = value.item()
    if isinstance(value, bool):
        raise TypeError(f"{name}: a number or a text is expected, not {value}")
    if isinstance(value, (int, str)):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, os.PathLike):
        return os.fsdecode(value)
    raise TypeError(f"{name}: a number or a text is expected, not {type(value).__name__}")


def _range_text(name, value):
    if isinstance(value, str):
        return value
    try:
        low, high = value
    except (TypeError, ValueError):
        raise TypeError(f"{name}: a pair is expected: (smallest, largest)") from None
    return ":".join("" if x is None else _text(name, x) for x in (low, high))


def arguments(**keywords):
    """The options as the command line has them; those that are None or, of switches, false are left out."""
    result = []
    for name, value in keywords.items():
        option = "--" + name.replace("_", "-")
        if name in _SWITCHES:
            if not isinstance(value, (bool, np.bool_)) and value is not None:
                raise TypeError(f"{name}: True or False is expected, not {type(value).__name__}")
            if value:
                result.append(option)
        elif value is None:
            continue
        elif name in _RANGES:
            result.append(f"{option}={_range_text(name, value)}")
        elif name in _LISTS and np.ndim(value) == 1:
            result.append(f"{option}={','.join(_text(name, x) for x in value)}")
        elif name in _REPEATABLE and not isinstance(value, (str, os.PathLike, int, np.integer)):
            result.extend(f"{option}={_text(name, x)}" for x in value)
        else:
            result.append(f"{option}={_text(name, value)}")
    return result


def options(what=("input", "method", "output")):
    """The options of the command line, with their defaults, as ``detect_features --help`` lists them; also those of
    "comparison" and "simplification", as the programs for these do."""
    kinds = {"input": _core.READING, "method": _core.METHOD, "output": _core.OUTPUT, "comparison": _core.COMPARISON,
             "simplification": _core.SIMPLIFICATION}
    return _core.help_of(sum(kinds[kind] for kind in what))
