# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Animations beside each other: descriptors, matched features, alignment in time, distances."""

from typing import Optional, Tuple

import numpy as np

from . import _core
from ._detection import Detection
from ._exceptions import InputError
from ._files import FeatureFile
from ._options import arguments, takes
from .evaluation import _features


def _known_features(found, features, *kinds):
    """Those that were given, or all that were found; of which the scales are known."""
    if not isinstance(found, kinds):
        raise TypeError(f"a {' or a '.join(k.__name__ for k in kinds)} is expected, not {type(found).__name__}")
    array = _features(found if features is None else features)
    if not ((array["sigma"] > 0) & (array["tau"] > 0)).all():
        raise InputError("features: sigma and tau must be positive")
    return array


def _is_cyclic(found):
    return bool(found.parameters.get("cyclic"))


@takes("running")
def descriptors(found, features=None, *, descriptor="rotation-free", visitor, **options) -> np.ndarray:
    """Describes features by what the deformation around them is like: histograms of its gradients in space and time, in
    coordinates of the feature's own place, sigma and tau. What is alike has a small Euclidean distance, whatever the
    mesh, the size and the frame rate of the body.

    Parameters
    ----------
    found : Detection
        with its deformation; also of a field of your own.
    features : structured array, optional
        M features of the same surface, by default all that were found.
    descriptor : {"rotation-free", "oriented"}
        100 numbers that do not depend on how the surface is turned about the feature; or 192 in a frame along the
        dominant direction of the gradients, which tell more and are mirrored on a mirrored body.
    {running}

    Returns
    -------
    ndarray of float32, M x 100 or M x 192
        not negative, each row of length 1; in the order of the features. Linear in the number of samples around them.

    Raises
    ------
    {errors}
    """
    chosen = _known_features(found, features, Detection)
    return _core.descriptors(found._data, chosen, arguments(descriptor=descriptor, cyclic=_is_cyclic(found), **options),
                             visitor)


class Signature:
    """What it takes to compare an animation with others, some kilobytes without its mesh: see `signature()`."""

    def __init__(self, data):
        self._data = data

    def __repr__(self):
        d = self._data
        cycle = f", repeats itself after {self.period:.3g} s" if self.period > 0 else ""
        return f"<Signature of {len(self.features)} features in {d.number_of_frames} frames{cycle}>"

    @property
    def features(self) -> np.ndarray:
        """M features, a structured array of `feature_dtype`: what ranks in matches and alignments are ranks of."""
        return self._data.features

    @property
    def descriptors(self) -> np.ndarray:
        """M x L, float32, see `descriptors()`; 0 x 0 if only features are known."""
        return self._data.descriptors

    @property
    def number_of_vertices(self) -> int:
        """N"""
        return self._data.number_of_vertices

    @property
    def number_of_frames(self) -> int:
        """F"""
        return self._data.number_of_frames

    @property
    def frame_duration(self) -> float:
        """seconds from one frame to the next."""
        return self._data.frame_duration

    @property
    def activity(self) -> np.ndarray:
        """the mean deformation of the surface at `rate` samples a second, float32, of root mean square 1."""
        return self._data.activity

    @property
    def rate(self) -> float:
        """samples in a second."""
        return self._data.rate

    @property
    def is_cyclic(self) -> bool:
        """whether it is a loop, whose last frame is followed by the first: compared as such, from whatever frame it
        begins."""
        return self._data.is_cyclic

    @property
    def period(self) -> float:
        """after which the motion repeats itself (s); 0 if it does not."""
        return self._data.period

    @property
    def cycle_strength(self) -> float:
        """from 0, no cycle, to 1, the same again exactly."""
        return self._data.cycle_strength

    @property
    def pose_variation(self) -> Optional[float]:
        """how far the body moves about its mean pose, relative to its size; None if only features are known."""
        return self._data.pose_variation


@takes("running")
def signature(found, features=None, *, rate=30.0, descriptor="rotation-free", visitor, **options) -> Signature:
    """Makes the signature of an animation, of a loop if it was detected as one (`cyclic`). All that compares takes what was found as well, and makes it itself; make it
    once to compare an animation several times, or with other options.

    O(M N log N) time for M features.

    Parameters
    ----------
    found : Detection or FeatureFile
        of a file of features there is less to compare: no descriptors, and straight distances.
    features : structured array, optional
        by default all that were found.
    rate : float
        samples in a second by which animations are aligned, whatever their frame rates; the same for all that are
        compared.
    descriptor : {"rotation-free", "oriented"}
        see `descriptors()`.
    {running}

    Raises
    ------
    {errors}
    """
    chosen = _known_features(found, features, Detection, FeatureFile)
    given = arguments(rate=rate, descriptor=descriptor, cyclic=_is_cyclic(found), **options)
    if not isinstance(found, FeatureFile):
        return Signature(_core.signature(found._data, chosen, given, visitor))
    a = found.animation
    return Signature(_core.signature_of_features(chosen, a["vertices"], a["frames"], a["frame_duration"],
                                                 a["bounding_box_diagonal"], given))


def _signatures(*found, **running):
    for one in found:
        if not isinstance(one, (Detection, FeatureFile, Signature)):
            raise TypeError(f"a Detection, a FeatureFile or a Signature is expected, not {type(one).__name__}")
    return [(one if isinstance(one, Signature) else signature(one, **running))._data for one in found]


@takes("running")
def match_features(a, b, alignment=None, *, matched=150, ratio=1.0, mutual=False, **running) -> np.ndarray:
    """Pairs features of two animations that show the same event, by what the deformation around them is like, where on
    the body they are, and whether the pairs agree in distances and times (Leordeanu, Hebert 2005). No correspondence
    between the meshes is needed.

    Parameters
    ----------
    a, b : Signature, Detection or FeatureFile
    alignment : Alignment, optional
        of their times, see `align()`: features of motions that both repeat themselves are matched in the cycle in which
        the alignment has them. By default matches agree with each other alone, and may be a cycle late.
    matched : int
        how many of the strongest features of each are matched.
    ratio : float
        match only features of which the second nearest is less alike, by this factor; a cycle fails it. 1: all.
    mutual : bool
        match only features of which each is the other's nearest.
    {running}

    Returns
    -------
    structured array
        a, b (int64): ranks of the two features; confidence, from 0 to 1; difference, 0 for the same. The most confident
        ones first; each feature is in one pair at most.

    Raises
    ------
    {errors}
    """
    a, b = _signatures(a, b, **running)
    return _core.match_features(a, b, None if alignment is None else alignment._data,
                                arguments(matched=matched, ratio=ratio, mutual=mutual), running["visitor"])


class Alignment:
    """Which time of one animation is which of another one, and which events follow one another in both: see
    `align()`."""

    def __init__(self, data, periods):
        self._data = data
        self._periods = periods

    def __repr__(self):
        return (f"<Alignment of cost {self.cost:.3f} and confidence {self.confidence:.3f}, {len(self.pairs)} events in "
                "the same order>")

    @property
    def times_a(self) -> np.ndarray:
        """S samples of the map of time (s), strictly ascending; linear between them. Those of a loop go on past its
        end."""
        return self._data.times_a

    @property
    def times_b(self) -> np.ndarray:
        """S, ascending: the times of the second animation at which it is as the first one at `times_a`."""
        return self._data.times_b

    def to_b(self, times):
        """the times of the second animation that belong to those of the first (s), of whatever shape; outside of the
        samples the clocks run alike. Those of a loop are from 0 to before its period."""
        return self._data.to_b(times)

    def to_a(self, times):
        """the other way."""
        return self._data.to_a(times)

    @property
    def cost(self) -> float:
        """from 0, for the same motion, to 1."""
        return self._data.cost

    @property
    def confidence(self) -> float:
        """from 0, if rearranged pieces of the second animation fit as well, to 1."""
        return self._data.confidence

    @property
    def loops(self) -> Tuple[float, float]:
        """how long each of the two is (s) if it is a loop; 0 if it ends."""
        return self._data.loops

    @property
    def phase(self):
        """of two motions that repeat themselves: how much of a period, of two loops of a loop, the second one is ahead,
        from -0.5 to 0.5; else None."""
        return self._data.phase

    @property
    def periods(self) -> Tuple[float, float]:
        """after which each of the two repeats itself (s); 0 if it does not."""
        return self._periods

    @property
    def pairs(self) -> np.ndarray:
        """events that follow one another in the same order (Smith, Waterman 1981), as of `match_features()`, in the
        order of time."""
        return self._data.pairs

    @property
    def only_a(self) -> np.ndarray:
        """ranks of features of the first animation that have no partner, int64, in the order of time."""
        return self._data.only_a

    @property
    def only_b(self) -> np.ndarray:
        """the same of the second one."""
        return self._data.only_b

    @property
    def score(self) -> float:
        """of the events in the same order: the sum of gains less the costs of gaps."""
        return self._data.score


@takes("running")
def align(a, b, *, place_weight=3.0, recurrence_weight=0.0, max_slope=3, end_weight=1.0, bend_weight=0.02,
          **running) -> Alignment:
    """Finds the map of time by which the deformation of two animations is most alike (dynamic time warping; Sakoe,
    Chiba 1978), whatever their meshes and frame rates.

    9 max_slope T^2 steps for T samples; for loops, which are aligned from all frames, up to 150 times as many.

    Parameters
    ----------
    a, b : Signature, Detection or FeatureFile
        signatures of the same rate.
    place_weight : float
        how much the places of deformation count.
    recurrence_weight : float
        and how much what was before and comes after.
    max_slope : int
        how much faster one animation may run than the other.
    end_weight : float
        from 0, the ends of the animations are open, to 1.
    bend_weight : float
        what it costs that one animation is faster than the other.
    {running}

    Raises
    ------
    {errors}
    """
    a, b = _signatures(a, b, **running)
    return Alignment(_core.align(a, b, arguments(
        place_weight=place_weight, recurrence_weight=recurrence_weight, max_slope=max_slope, end_weight=end_weight,
        bend_weight=bend_weight), running["visitor"]), (a.period, b.period))


@takes("running")
def event_differences(a, b, alignment=None, *, place=0.05, profile=0.3, frames=1.5, factor=2.0,
                      **running) -> np.ndarray:
    """Tells in what two takes of a motion differ: events of one of them only, and events of other amplitudes.

    Parameters
    ----------
    a, b : Signature, Detection or FeatureFile
    alignment : Alignment, optional
        of their times, by default that of `align()`.
    place : float
        the largest distance of one event on the rest shapes, as a share of the bounding box's diagonal; sigma if that
        is more.
    profile : float
        the largest difference of places, if the takes are of different meshes.
    frames : float
        how many frames it may be early or late, after the alignment; half of tau if that is more.
    factor : float
        the largest ratio of two values of sigma, and of tau.
    {running}

    Returns
    -------
    structured array
        a, b (int64): ranks, -1 for none; amplitude: of an event of one take only, else the difference of both. The
        largest first.

    Raises
    ------
    {errors}
    """
    a, b = _signatures(a, b, **running)
    data = _core.align(a, b, [], running["visitor"]) if alignment is None else alignment._data
    return _core.event_differences(a, b, data, place, profile, frames, factor)


@takes("distance", "running")
def animation_distance(a, b, **options) -> float:
    """Tells how unlike two motions are, from 0, the same, to 1. It is the same for a body of another shape, another
    mesh and another frame rate, as far as the deformation is.

    Parameters
    ----------
    a, b : Signature, Detection or FeatureFile
    {distance}
    {running}

    Raises
    ------
    {errors}
    """
    return float(distance_matrix([a, b], **options)[0, 1])


@takes("distance", "running")
def distance_matrix(animations, *, threads, visitor, **options) -> np.ndarray:
    """The distances of all pairs of animations, see `animation_distance()`.

    Parameters
    ----------
    animations : sequence of Signature, Detection or FeatureFile
        of the first two, if they are large, signatures take less memory.
    {distance}
    {running}

    Returns
    -------
    ndarray, n x n
        symmetric, 0 on its diagonal: ``scipy.cluster.hierarchy.linkage(scipy.spatial.distance.squareform(d))``, or
        places in the plane by `classical_scaling()`.

    Raises
    ------
    {errors}
    """
    signatures = _signatures(*animations, threads=threads, visitor=visitor)
    return _core.distances(signatures, arguments(threads=threads, **options), visitor)


def classical_scaling(distances) -> np.ndarray:
    """Places in the plane whose distances are as given, as nearly as can be (Torgerson 1952).

    Parameters
    ----------
    distances : array_like, n x n
        symmetric.

    Returns
    -------
    ndarray, n x 2
    """
    array = np.asarray(distances, dtype=np.float64)
    if array.ndim != 2 or array.shape[0] != array.shape[1]:
        raise InputError(f"distances: a square matrix is expected, not {' x '.join(map(str, array.shape))}")
    if not np.isfinite(array).all():
        raise InputError("distances: some are not finite")
    return _core.classical_scaling(array)
