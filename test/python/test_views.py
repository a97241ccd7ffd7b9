# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Views: those that the program writes, and what must hold of any."""

import json

import numpy as np
import pytest

import animated_mesh_features as amf


@pytest.fixture(scope="module")
def result(cylinder):
    return amf.detect(cylinder.frames, cylinder.faces, fps=20, rest="average")


@pytest.fixture(scope="module")
def views(result):
    return amf.select_views(result)


def test_same_as_program(cylinder, found_by_program, views):
    path = cylinder.folder / "views.json"
    found_by_program("--rest", "average", "--views", path)
    expected = json.loads(path.read_text())
    assert views.up.tolist() == expected["up"] and views.frames.tolist() == expected["frames"]
    assert len(views.score) == len(expected["views"]) > 1
    for name, digits in (("direction", 6), ("azimuth", 2), ("elevation", 2), ("score", 4), ("covered", 4)):
        np.testing.assert_allclose(getattr(views, name), [v[name] for v in expected["views"]], rtol=0,
                                   atol=0.5001 * 10.0 ** -digits)


def sums_of(views):
    """the score of each direction"""
    return views.scores.sum(axis=1)


def test_views(result, views):
    np.testing.assert_allclose(np.linalg.norm(views.direction, axis=1), 1)
    np.testing.assert_allclose(views.direction @ views.up, np.sin(np.radians(views.elevation)), atol=1e-12)
    assert (5 - 1e-6 <= views.elevation).all() and (views.elevation <= 50 + 1e-6).all()
    sums = sums_of(views)
    assert sums.max() == pytest.approx(views.score[0])
    assert views.scores.shape == (len(views.directions), len(views.frames))
    assert (np.diff(views.covered) >= 0).all() and views.covered[0] == pytest.approx(views.score[0], abs=0.005)
    for options in (dict(threads=1), dict(features=result.features)):
        other = amf.select_views(result if "threads" in options else result.animation, **options)
        assert all(np.array_equal(a, b) for a, b in zip(views, other))
    # the icosahedron is the same after half a turn about an axis, and so are the views
    half = np.diag([-1.0, -1.0, 1.0])
    turned = amf.Animation(result.animation.frames @ half, result.animation.faces, fps=20,
                           rest=result.animation.vertices @ half)
    here, there = amf.select_views(result, up="z"), amf.select_views(turned, result.features, up=[0, 0, 2])
    assert there.score[0] == pytest.approx(here.score[0], abs=0.02)
    # of views that are next to as good the one nearest to the front is chosen, which is elsewhere now
    nearest = np.argmax(here.directions @ (half @ there.direction[0]))
    assert sums_of(here)[nearest] > 0.95 * sums_of(here).max()
    # without features by entropy
    plain = amf.select_views(result.animation, most_views=1)
    assert len(plain.score) == 1 and 0 < plain.score[0] < 1


def test_options_and_cancellation(cylinder, result):
    with pytest.raises(TypeError, match="Animation"):
        amf.select_views(amf.Shape(cylinder.rest, cylinder.faces))
    for options in (dict(up=[0, 0, 0]), dict(up="w"), dict(up=[1, 2]), dict(most_views=0), dict(subdivisions=9),
                    dict(most_frames=0), dict(lowest_elevation=60)):
        with pytest.raises(amf.OptionError):
            amf.select_views(result, **options)
    bad = result.features[:1].copy()
    bad["vertex"] = 10 ** 6
    with pytest.raises(amf.InputError, match="1000000"):
        amf.select_views(result, bad)
    told = []
    few = amf.select_views(result, subdivisions=0, refinements=0, most_frames=2, most_views=1, lowest_elevation=-90,
                           highest_elevation=90, visitor=lambda *stage: told.append(stage))
    assert len(few.frames) == 2 and len(few.directions) == 12 and len(few.score) == 1 and told[-1] == ("views", 1)
    with pytest.raises(amf.Cancelled):
        amf.select_views(result, visitor=lambda *_: False)
