# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Where to look at an animation from."""

from typing import NamedTuple

import numpy as np

from . import _core
from ._animation import Animation
from ._detection import Detection
from ._exceptions import OptionError
from ._options import arguments, takes
from .evaluation import _features


class Views(NamedTuple):
    """The views that `select_views()` chose, V of them, the best first, and what it chose from."""

    direction: np.ndarray  #: V x 3: unit vectors from the body to the camera
    azimuth: np.ndarray  #: V: degrees around `up`; 0 is along +z if y points up, along +x if z does, along +y if x does
    elevation: np.ndarray  #: V: degrees above the horizon
    score: np.ndarray  #: V: what each shows alone of all that there is to be seen, from 0 to 1
    covered: np.ndarray  #: V: what it and those before it show together
    up: np.ndarray  #: 3: what points up, a unit vector
    frames: np.ndarray  #: K of int64: the frames that were looked at
    directions: np.ndarray  #: D x 3: all directions that were looked from
    scores: np.ndarray  #: D x K: what each shows in each frame; the sum of a row is its score

    def __repr__(self):
        views = "; ".join(f"azimuth {a:.0f}, elevation {e:.0f}, covered {c:.2f}"
                          for a, e, c in zip(self.azimuth, self.elevation, self.covered))
        return f"<Views in {len(self.frames)} frames: {views}>"


@takes("running")
def select_views(animation, features=None, *, up=None, subdivisions=2, refinements=3, most_frames=8, most_views=3,
                 lowest_elevation=5.0, highest_elevation=50.0, cyclic=False, visitor, **options) -> Views:
    """Chooses where to look at an animation from so that its features are seen while they last, as the program
    ``detect_features`` does with ``--views``; without features, by the entropy of what is seen of the triangles
    (Vázquez et al. 2001). The camera follows the body and stands upright.

    A millisecond of a core for each direction and frame of 8,000 vertices.

    Parameters
    ----------
    animation : Detection or Animation
        a detection brings its features.
    features : structured array, optional
        of the same animation.
    up : array_like of 3, or {"x", "y", "z"}, optional
        by default the axis that probably points up.
    subdivisions : int
        of the icosahedron of directions, up to 6: 10 * 4^n + 2 of them, 162 for 2, 18 degrees apart.
    refinements : int
        how often the best direction is refined, each time to half the angle.
    most_frames : int
        how many frames are looked at.
    most_views : int
        how many views are chosen.
    lowest_elevation, highest_elevation : float
        of the views that are chosen from (degrees), from -90 to 90. By default the camera looks down a little, so that
        the ground is seen, and not so much that the body is seen as on a plan.
    cyclic : bool
        whether the last frame is followed by the first, so that a feature near one end lives on at the other; so it is
        in any case if the features were detected like that.
    {running}

    Raises
    ------
    {errors}
    """
    if isinstance(animation, Detection):
        features = animation if features is None else features
        cyclic = cyclic or animation.parameters["cyclic"]
        animation = animation.animation
    if not isinstance(animation, Animation):
        raise TypeError("an Animation is looked at, or what was detected in one")
    chosen = _features(np.zeros(0, dtype=_core.feature_dtype) if features is None else features)
    if isinstance(up, str):
        if up not in ("x", "y", "z"):
            raise OptionError(f'up: there is no "{up}"; choose among x, y, z')
        up = np.eye(3)["xyz".index(up)]
    if up is not None:
        up = [float(x) for x in up]
        if len(up) != 3:
            raise OptionError(f"up: 3 coordinates are expected, not {len(up)}")
    found = _core.select_views(animation._data, chosen, up, subdivisions, refinements, most_frames, most_views,
                               lowest_elevation, highest_elevation, bool(cyclic), arguments(**options), visitor)
    views = found["views"]
    return Views(views["direction"], views["azimuth"], views["elevation"], views["score"], views["covered"],
                 found["up"], found["frames"], found["directions"], found["scores"])
