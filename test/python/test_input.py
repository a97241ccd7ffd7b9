# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What is no animation is told in a sentence, as an exception that can be caught; nothing crashes."""

import numpy as np
import pytest

import animated_mesh_features as amf


def changed(array, index, value):
    copy = np.array(array, dtype=np.result_type(array, type(value)) if isinstance(value, float) else array.dtype)
    copy[index] = value
    return copy


@pytest.mark.parametrize("change, words", [
    (lambda c: (c.frames[0], c.faces), "frames x vertices x 3 are expected, not 494 x 3"),
    (lambda c: (c.frames[:, :, :2], c.faces), "expected"),
    (lambda c: (c.frames.transpose(1, 2, 0), c.faces), r"transpose\(2, 0, 1\)"),
    (lambda c: (c.frames[:2], c.faces), "has 2 frames; at least 3"),
    (lambda c: (c.frames[:0], c.faces), "has 0 frames; at least 3"),
    (lambda c: (c.frames[:, :0], c.faces), "no vertices"),
    (lambda c: ([], c.faces), "has 0 frames"),
    (lambda c: (7, c.faces), "an array is expected"),
    (lambda c: (c.frames.astype(complex), c.faces), "numbers are expected, not complex"),
    (lambda c: (np.array([["a"]]), c.faces), "numbers are expected"),
    (lambda c: (list(c.frames[:3]) + [c.frames[3][:-1]], c.faces), "frame 3: has 493 vertices, frame 0 has 494"),
    (lambda c: (np.ma.masked_greater(c.frames, 0.5), c.faces), "masked"),
    (lambda c: (changed(c.frames, (7, 3, 1), np.nan), c.faces),
     "frames, frame 7: the position of vertex 3 is not finite"),
    (lambda c: (changed(changed(c.frames, (30, 0, 0), np.inf), (9, 5, 2), -np.inf), c.faces),
     "frame 9: the position of vertex 5 "),
    (lambda c: (changed(c.frames.astype(float), (39, 493, 2), np.nan), c.faces),
     "frame 39: the position of vertex 493"),
    (lambda c: (changed(c.frames, (5, 8), 1e4), c.faces), "frame 5.*vertex 8"),
    (lambda c: (c.frames.astype(float) * 1e80, c.faces), "nothing can be computed"),
    (lambda c: (c.frames, c.faces.astype(float)), "integers are expected, not float64"),
    (lambda c: (c.frames, c.faces[:, :2]), "faces x 3 are expected"),
    (lambda c: (c.frames, c.faces[0]), "faces x 3 are expected"),
    (lambda c: (c.frames, c.faces[:0]), "no faces|no triangles|face"),
    (lambda c: (c.frames, [[0, 1, 2], [3, 4]]), "faces"),
    (lambda c: (c.frames, changed(c.faces, (4, 1), -1)), "face 4 has vertex -1, there are 494 vertices"),
    (lambda c: (c.frames, changed(c.faces, (4, 1), 494)), "face 4 has vertex 494"),
    (lambda c: (c.frames, changed(c.faces.astype(np.uint64), (4, 1), np.uint64(2**63 + 1))),
     "vertex 9223372036854775809"),
    (lambda c: (c.frames, np.concatenate([c.faces, c.faces[:1]])), "face"),  # twice
    (lambda c: (c.frames, np.concatenate([c.faces, [[0, 1, 1]]])), "984|0"),  # collapsed
    (lambda c: (c.frames, np.hstack([c.faces, c.faces[:, :1]])), "triangulate=True"),
])
def test_bad_arrays(cylinder, change, words):
    frames, faces = change(cylinder)
    with pytest.raises(amf.InputError, match=words) as e:
        amf.detect(frames, faces)
    assert isinstance(e.value, ValueError) and isinstance(e.value, amf.Error)


@pytest.mark.parametrize("keywords, words", [
    ({"preset": "best"}, '--preset: there is no "best"; choose among calibrated, published'),
    ({"alpha": -1}, "--alpha.*negative"),
    ({"alpha": float("nan")}, "--alpha"),
    ({"fps": 0}, "--fps"),
    ({"top": -1}, "--top"),
    ({"min_fit": 2}, "--min-fit"),
    ({"sigma_range": (0.2, 0.1)}, ""),
    ({"sigma_range": "1%"}, "--sigma-range"),
    ({"box_width": 5}, "--box-width"),
    ({"rest": "frame:40"}, "no such frame"),
    ({"rest": 40}, "no such frame"),
    ({"rest": "mesh"}, "--rest mesh"),
    ({"rescale_rest": True}, "--rescale-rest"),
    ({"weld": "sometimes"}, "--weld"),
    ({"memory": "much"}, "--memory"),
    ({"scratch": "/tmp"}, "--scratch"),
    ({"keep_fields": ["colour"]}, "keep_fields"),
])
def test_bad_options(cylinder, keywords, words):
    with pytest.raises(amf.OptionError, match=words):
        amf.detect(cylinder.frames, cylinder.faces, **keywords)


@pytest.mark.parametrize("keywords", [{"nonsense": 1}, {"no_suppression": 1}, {"top": True}, {"alpha": [7]},
                                      {"sigma_range": 3}, {"visitor": 3}, {"fps": 30, "frame_duration": 1 / 30}])
def test_wrong_types(cylinder, keywords):
    with pytest.raises(TypeError):
        amf.detect(cylinder.frames, cylinder.faces, **keywords)
    with pytest.raises(TypeError, match="faces are needed"):
        amf.detect(cylinder.frames)


def test_bad_rest(cylinder):
    c = cylinder
    for rest, words in ((c.rest[:-1], "rest: has 493 vertices, the frames have 494"), (c.rest[:, :2], "vertices x 3"),
                        (changed(c.rest, (2, 0), np.nan), "rest: the position of vertex 2 is not finite")):
        with pytest.raises(amf.InputError, match=words):
            amf.detect(c.frames, c.faces, rest=rest)
    with pytest.raises(amf.InputError, match="nowhere.obj"):
        amf.detect(c.frames, c.faces, rest="nowhere.obj")
    with pytest.raises(amf.InputError, match="time between two frames must be positive"):
        amf.detect(c.frames, c.faces, frame_duration=-1)


def test_bad_fields(cylinder):
    c, field = cylinder, np.zeros((494, 40))
    for values, words in ((field[0], "vertices x frames"), (changed(field, (3, 4), np.nan), "frame 4.*vertex 3"),
                          (field[:, :2], "3")):
        with pytest.raises(amf.InputError, match=words):
            amf.detect_in_field(values, c.rest, c.faces)
    with pytest.raises(amf.OptionError, match="493 rows"):
        amf.detect_in_field(field[1:], c.rest, c.faces)
    with pytest.raises(amf.OptionError, match="39 frames"):
        amf.detect_in_field(field[:, 1:], amf.Animation(c.frames, c.faces, rest="first"))
    r = amf.detect_in_field(field, c.rest, c.faces)
    assert len(r) == 0 and len(r.features) == 0
    with pytest.raises(amf.InputError):
        amf.Shape(changed(c.rest, (0, 0), np.inf), c.faces)


def test_nothing_moves(cylinder):
    """no features, and why"""
    r = amf.detect(np.stack([cylinder.rest] * 5), cylinder.faces)
    assert len(r) == 0 and r.features.dtype == amf.feature_dtype and "nothing deforms" in r.reason
    assert "nothing deforms" in repr(r)


def test_broken_frames_are_bridged(cylinder):
    frames = cylinder.frames.copy()
    frames[10] = 0
    with pytest.warns(amf.Notice, match="frame 10") as told:
        a = amf.Animation(frames, cylinder.faces, rest="first")
        amf.strain(frames, cylinder.faces, rest="first")
    assert [w.filename for w in told if "frame 10" in str(w.message)] == [__file__] * 2
    np.testing.assert_allclose(a.frames[10], (frames[9].astype(float) + frames[11]) / 2)
    assert not frames[10].any()  # what was given is left alone


def test_quadrangles(cylinder):
    """cut as a fan"""
    x, y = np.meshgrid(np.arange(12.0), np.arange(9.0))
    points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    i = np.arange(len(points)).reshape(x.shape)
    quads = np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=-1).reshape(-1, 4)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    frames = np.stack([points + np.sin(f) * np.array([0, 0, 0.1]) * points[:, :1] ** 2 for f in range(6)])
    a, b = (amf.Animation(frames, faces, rest="first", triangulate=True) for faces in (quads, triangles))
    assert {tuple(f) for f in a.faces} == {tuple(f) for f in b.faces}
