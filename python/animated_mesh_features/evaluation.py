# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""How good features are: are they found again, are they where a rig bends, do they tell what people see?

Each figure has its chance level beside it, from `random_places()` or `shifted_in_time()`, and an interval from
`bootstrap_interval()`. Features are structured arrays as `Detection.features` and `FeatureFile.features`.
"""

import json
import os
from typing import Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from . import _core
from ._animation import Shape, _points
from ._exceptions import InputError, OptionError

__all__ = ["repeated_features", "paired_features", "shifted_in_time", "matching_errors", "feature_regions",
           "MapScores", "map_scores", "Painting", "read_painting", "bootstrap_interval", "random_places",
           "chance_level", "prominent_maxima", "Rig", "RigMatches", "read_rig_events", "rig_matches"]


def _features(features):
    features = getattr(features, "features", features)  # of a Detection
    array = np.asarray(features)
    if array.dtype.names is None or array.ndim != 1:
        raise InputError("features: a structured array is expected, as Detection.features")
    if array.dtype == _core.feature_dtype:
        return np.ascontiguousarray(array)
    known = np.zeros(len(array), dtype=_core.feature_dtype)
    known["parent"] = -1
    for name in array.dtype.names:
        if name in _core.feature_dtype.names:
            known[name] = array[name]
    return known


def _at_rest(at):
    if at not in ("rest_position", "position"):
        raise OptionError(f'at: there is no "{at}"; choose among rest_position, position')
    return at == "rest_position"


def repeated_features(features, others, *, place, time, factor=1.5, top=50, among=150,
                      at="rest_position") -> Tuple[np.ndarray, np.ndarray]:
    """Looks up the first `top` features among the first `among` others: the repeatability of a detector.

    Parameters
    ----------
    features, others : structured arrays, strongest first
    place : float
        the largest distance in space (length) at which two features count as the same.
    time : float
        the largest distance in time (s).
    factor : float
        the largest ratio of two values of sigma, and of tau.
    top, among : int
    at : {"rest_position", "position"}
        where features are.

    Returns
    -------
    in_place_and_time, with_scales : arrays of 0 and 1
        whether each was found again, and with the same scales; their means are the rates. Chance: the same with
        `shifted_in_time()`.
    """
    return _core.repeated_features(_features(features), _features(others), top, among, place, time, factor,
                                   _at_rest(at))


def paired_features(a, b, *, place, time, factor=1.5, at="rest_position") -> Tuple[np.ndarray, np.ndarray]:
    """Pairs the features of two lists one-to-one, as many as can be (Hopcroft, Karp 1973): whether each feature of the
    shorter list, of `a` if they are equal, has a partner of its own. Parameters and result as of
    `repeated_features()`."""
    return _core.paired_features(_features(a), _features(b), place, time, factor, _at_rest(at))


def shifted_in_time(features, shift, period) -> np.ndarray:
    """The same features at other times (s), as if the animation of this period went round in a circle: places, and how
    features crowd in time, stay what they are."""
    if not period > 0:
        raise OptionError("the period must be positive")
    shifted = _features(features).copy()
    time = np.fmod(shifted["time"] + shift, period)
    shifted["time"] = np.where(time < 0, time + period, time)
    return shifted


def matching_errors(shape: Shape, features, others, time: Optional[float] = None) -> np.ndarray:
    """How far each feature is from the nearest of others, by paths along edges of the rest shape (length): infinity if
    there is none. If `time` is given, among those only that are so near in time (s); see Mykhalchuk, Seo, Cordier 2014,
    sect. 6.1."""
    if time is not None and not time >= 0:
        raise OptionError("the largest distance in time must not be negative")
    return _core.matching_errors(shape._data, _features(features), _features(others), -1.0 if time is None else time)


def feature_regions(shape: Shape, features, frames: int, frame_duration: float, course="present") -> np.ndarray:
    """The map of feature regions, N x F of float32: for each vertex and frame the most that a feature's region is worth
    there. A region is the disc of radius sigma about its vertex on the rest shape; it is worth 1 within tau of the
    feature's time (course "present") or exp(-(t - t0)^2 / 2 tau^2) ("gaussian")."""
    if course not in ("present", "gaussian"):
        raise OptionError(f'course: there is no "{course}"; choose among present, gaussian')
    return _core.feature_regions(shape._data, _features(features), frames, frame_duration, course == "gaussian")


class MapScores(NamedTuple):
    """How well a map tells what people marked."""

    auc: float  #: area under the ROC curve, 0.5 is chance
    nss: float  #: normalised scanpath saliency, 0 is chance
    correlation: float  #: from -1 to 1


class Painting(NamedTuple):
    """What somebody painted on an animation."""

    painter: str  #: who
    strokes: List[Tuple[int, int, np.ndarray]]  #: first frame, last frame (included), vertices
    vertices: int  #: of the animation, their number
    frames: int  #: their number
    frame_duration: float  #: seconds

    def marks(self) -> np.ndarray:
        """N x F of float32: 1 where and while something is painted. The mean of several painters' is what `map_scores()`
        takes."""
        result = np.zeros((self.vertices, self.frames), dtype=np.float32)
        for first, last, vertices in self.strokes:
            result[vertices, first:last + 1] = 1
        return result


def read_painting(path) -> Painting:
    """Reads what somebody painted on an animation, as the page of ``detect_features --html`` saves it (JSON).

    Raises
    ------
    InputError
        if it is no such file. The message names the member, as ``strokes[3].vertices[0]``.
    """
    return Painting(**_core.read_painting(os.fsdecode(path)))


def map_scores(map, marks, areas) -> MapScores:
    """Compares a map (N x F) with marks (N x F, from 0 to 1: which share of people marked a vertex in a frame, see
    `read_painting()`). Each vertex counts by its area (N), see `Shape.areas`, each frame the same."""
    return MapScores(*_core.map_scores(map, marks, areas))


def bootstrap_interval(sample, statistic=None, *, resamples=1000, confidence=0.95, seed=1) -> Tuple[float, float]:
    """The percentile bootstrap interval of a statistic of a sample: by default of its mean, else of
    ``statistic(array) -> float``. The same seed gives the same interval."""
    return _core.bootstrap_interval(np.asarray(sample, dtype=float).ravel(), statistic, resamples, confidence, seed)


def random_places(number_of_features, number_of_vertices, duration, *, draws=20,
                  seed=0) -> Tuple[np.ndarray, np.ndarray]:
    """Where and when features are by chance: vertices (draws x features) and times (s), all equally likely."""
    if not number_of_vertices > 0:
        raise OptionError("there are no vertices to draw from")
    return _core.random_places(number_of_features, number_of_vertices, duration, draws, seed)


def chance_level(features, number_of_vertices, duration, figure, *, draws=20, seed=0):
    """The mean of ``figure(features)`` over draws of the same features at random vertices and times: what a figure is
    by chance. `figure` returns a number or an array."""
    features = _features(features)
    vertices, times = random_places(len(features), number_of_vertices, duration, draws=draws, seed=seed)
    total = None
    for vertex, time in zip(vertices, times):
        moved = features.copy()
        moved["vertex"], moved["time"] = vertex, time
        value = figure(moved)
        total = value if total is None else total + value
    return total * (1.0 / draws)


def prominent_maxima(series, least) -> List[Tuple[int, float, float]]:
    """The local maxima of a series with a prominence of at least `least`: (index, value, prominence) each."""
    return _core.prominent_maxima(np.asarray(series, dtype=float).ravel(), least)


class Rig(NamedTuple):
    """The joints of an animated body, what moves where they bend, and when they are bent most."""

    names: List[str]  #: of the joints
    regions: List[List[int]]  #: of each joint the vertices that it moves
    events: List[Tuple[int, float, float, float]]  #: joint, time (s), angle (degrees), prominence (degrees)
    vertices: int  #: their number
    frames: int  #: their number
    frame_duration: float  #: seconds


def read_rig_events(path) -> Rig:
    """Reads the events of a rig, as ``make_animation figure --events`` writes them (JSON)."""
    name = os.fsdecode(path)
    try:
        with open(name, encoding="utf-8") as file:
            data = json.load(file)
        if data["format"] != "animated-mesh-features-rig-events":
            raise InputError(f"{name}: is no file of the events of a rig")
        if data["version"] != 1:
            raise InputError(f"{name}: has version {data['version']} of the format; known is version 1 only")
        joints = data["joints"]
        animation = data["animation"]
        return Rig([j["name"] for j in joints], [j["region"] for j in joints],
                   [(i, m["time"], m["angle_deg"], m["prominence_deg"])
                    for i, j in enumerate(joints) for m in j["maxima"]],
                   animation["vertices"], animation["frames"], animation["frame_duration"])
    except (OSError, ValueError, KeyError, TypeError) as e:
        if isinstance(e, InputError):
            raise
        raise InputError(f"{name}: is no file of the events of a rig: {e!r}") from None


class RigMatches(NamedTuple):
    """What features and events have to do with one another."""

    found: np.ndarray  #: of each event that should have a feature, whether one is at it; the mean is the recall
    at_event: np.ndarray  #: of each feature whether it is at an event; the mean is the precision
    of_joint: List[int]  #: of each joint, how many features are at an event of it
    recalled: List[Tuple[int, float]]  #: the events of `found`: joint and time (s)


def rig_matches(rig: Rig, points, features, **options: float) -> RigMatches:
    """Compares features with the moments at which the joints of a rig are bent most.

    Parameters
    ----------
    rig : Rig
    points : array_like, N x 3
        the body at rest.
    features : structured array
    **options
        least_prominence=10, least_angle=10, least_recalled_angle=20 (degrees); largest_distance=0.02, a share of the
        diagonal of the bounding box; frames=1.5 or share_of_tau=0.5: how early or late a feature may be.

    Chance: `chance_level()` with ``figure=lambda f: rig_matches(rig, points, f).found.mean()``.
    """
    points = _points(points, "points")
    if len(points) != rig.vertices:
        raise InputError(f"points: has {len(points)} vertices, the rig {rig.vertices}")
    chosen = _core.RigOptions()
    for name, value in options.items():
        if not hasattr(chosen, name):
            raise TypeError(f"rig_matches() has no option {name}")
        setattr(chosen, name, value)
    size = float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
    return RigMatches(*_core.rig_matches(points, size, rig.regions, rig.events, rig.frames, rig.frame_duration,
                                         _features(features), chosen))
