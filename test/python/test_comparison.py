# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Descriptors, matches, alignment and distances: those of the program, and what must not change them."""

import json
import subprocess
import sys

import numpy as np
import pytest

import animated_mesh_features as amf
from conftest import run


@pytest.fixture(scope="module")
def pair(figure):
    """a running figure, a coarser one at half the rate, and what was detected in them"""
    a = amf.detect(amf.read_animation(figure / "f.obj", figure / "f.pc2"))
    coarse = amf.simplify(a.animation, ratio=0.8, measure=False).levels[0]
    b = amf.detect(coarse.positions(a.animation)[::2], coarse.faces, fps=15, rest=coarse.vertices)
    a.write(figure / "a.json")
    b.write(figure / "b.json")
    return figure, a, b


@pytest.fixture(scope="module")
def signatures(pair):
    return amf.signature(pair[1]), amf.signature(pair[2])


def assert_same_matches(matches, expected):
    assert len(matches) == len(expected) > 0
    for name in ("a", "b", "confidence", "difference"):
        assert matches[name].tolist() == [m[name] for m in expected], name


def test_same_as_program(pair, signatures):
    """in two files of features, bit for bit; and in the animation itself"""
    folder, a, _ = pair
    files = [amf.read_features(folder / f"{name}.json") for name in "ab"]
    options = ["--matched", 40, "--ratio", 0.95, "--mutual", "--max-slope", 2, "--end-weight", 0.5, "--bend-weight",
               0.1, "--recurrence-weight", 1, "--distance-recurrence-weight", 2, "--cycle-weight", 0.3, "--variation-weight", 0.3,
               "--duration-weight", 0.2, "--rate", 24]
    run("COMPARE_ANIMATIONS", folder / "a.json", folder / "b.json", "-q", "-o", folder / "pair.json", *options)
    expected = json.loads((folder / "pair.json").read_text())
    x, y = (amf.signature(f, rate=24) for f in files)
    assert amf.animation_distance(x, y, distance_recurrence_weight=2, cycle_weight=0.3, variation_weight=0.3,
                                  duration_weight=0.2) == expected["distance"]
    alignment = amf.align(x, y, max_slope=2, end_weight=0.5, bend_weight=0.1, recurrence_weight=1)
    for name, value in expected["alignment"].items():
        assert np.array_equal(getattr(alignment, name), value), name
    assert_same_matches(amf.match_features(x, y, alignment, matched=40, ratio=0.95, mutual=True), expected["matches"])
    assert_same_matches(alignment.pairs, expected["events"]["pairs"])
    for name in ("only_a", "only_b", "score"):
        assert np.array_equal(getattr(alignment, name), expected["events"][name]), name
    for side, s in (("a", x), ("b", y)):
        for name, value in (("vertices", s.number_of_vertices), ("frames", s.number_of_frames), ("period", s.period),
                            ("cycle_strength", s.cycle_strength), ("pose_variation", s.pose_variation), ("features", len(s.features))):
            assert expected[side][name] == value, (side, name)
    differences = amf.event_differences(x, y, alignment)
    assert differences["amplitude"].tolist() == [d["difference"] for d in expected["differences"]]
    for name in "ab":
        assert differences[name].tolist() == [-1 if d[name] is None else d[name] for d in expected["differences"]]

    run("COMPARE_ANIMATIONS", "describe", folder / "f.pc2", "-q", "--write-descriptors", folder / "d.npy",
        "--descriptor", "oriented")
    expected = np.load(folder / "d.npy")
    assert expected.shape == (len(a), 192) and np.array_equal(amf.descriptors(a, descriptor="oriented"), expected)
    run("COMPARE_ANIMATIONS", "matrix", folder / "f.pc2", folder / "b.json", "-q", "-o", folder / "m.json")
    expected = json.loads((folder / "m.json").read_text())
    matrix = amf.distance_matrix([signatures[0], files[1]])
    assert np.array_equal(matrix, expected["distances"])
    assert np.array_equal(amf.classical_scaling(matrix), expected["embedding"])


def test_descriptors(pair):
    _, a, _ = pair
    all_of_them = amf.descriptors(a)
    assert all_of_them.shape == (len(a), 100) and all_of_them.dtype == np.float32
    np.testing.assert_allclose(np.linalg.norm(all_of_them, axis=1), 1, atol=1e-5)
    assert np.array_equal(amf.descriptors(a, a.features[3:5], threads=1), all_of_them[3:5])
    assert np.array_equal(amf.signature(a).descriptors, all_of_them)
    # neither where the body is, how it is turned, how large it is, nor the order of its vertices
    order = np.random.default_rng(3).permutation(a.animation.number_of_vertices)
    rank = np.argsort(order)
    turn = np.linalg.qr(np.random.default_rng(4).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    moved = 5 * a.animation.frames @ turn.T + [1, -2, 3]
    shape = 5 * a.animation.vertices @ turn.T + [1, -2, 3]
    features = a.features.copy()
    features["vertex"], features["triangle"] = rank[features["vertex"]], rank[features["triangle"]]
    features["sigma"] *= 5
    other = amf.Animation(moved[:, order], rank[a.animation.faces], fps=30, rest=shape[order])
    other = amf.detect_in_field(a.deformation[order], other, threshold=0.1)
    for descriptor in ("rotation-free", "oriented"):
        np.testing.assert_allclose(amf.descriptors(other, features, descriptor=descriptor),
                                   amf.descriptors(a, descriptor=descriptor), atol=2e-3)


def test_the_same_and_another(pair, signatures, cylinder):
    _, a, b = pair
    x, y = signatures
    assert amf.animation_distance(a, x) == 0
    same = amf.align(x, a)
    assert same.periods == (x.period, x.period)
    assert same.cost == 0 and len(same.only_a) == len(same.only_b) == 0
    np.testing.assert_allclose(same.to_b([0.1, 0.5, 3]), [0.1, 0.5, 3], atol=1e-9)
    matches = amf.match_features(a, x)
    assert np.array_equal(matches["a"], matches["b"]) and len(matches) > 5 and (matches["difference"] == 0).all()
    assert not amf.event_differences(x, x)["amplitude"].any()
    # another mesh and rate of the same motion is nearer than another motion
    c = amf.detect(cylinder.frames, cylinder.faces, fps=20, rest="average")
    told = []
    matrix = amf.distance_matrix([a, y, c], visitor=lambda *stage: told.append(stage))
    assert np.array_equal(matrix, matrix.T) and not matrix.diagonal().any()
    assert matrix[0, 1] < 0.5 * min(matrix[0, 2], matrix[1, 2])
    assert matrix[0, 1] == amf.animation_distance(x, b)
    assert {s for s, _ in told} == {"descriptors", "distances"} and told[-1] == ("distances", 1)
    assert np.array_equal(amf.distance_matrix([a, y, c], threads=1), matrix)
    alignment = amf.align(x, y)
    times = np.linspace(0.1, 1, 7)
    np.testing.assert_allclose(alignment.to_b(times), times, atol=0.1)
    np.testing.assert_allclose(alignment.to_a(alignment.to_b(times)), times, atol=1e-9)
    assert alignment.confidence > amf.align(x, amf.signature(c)).confidence
    places = amf.classical_scaling(matrix)
    assert places.shape == (3, 2)
    assert np.linalg.norm(places[0] - places[1]) < np.linalg.norm(places[0] - places[2])


def test_cyclic(pair, recwarn):
    """a loop is the same one from whatever frame it begins; a file says that it is one"""
    folder, a, _ = pair
    frames = a.animation.frames
    loops = [amf.detect(np.roll(frames, -k, axis=0), a.animation.faces, fps=30, rest=a.animation.vertices, cyclic=True)
             for k in (0, 11)]
    x, y = (amf.signature(loop) for loop in loops)
    assert x.is_cyclic and y.is_cyclic and not amf.signature(a).is_cyclic
    assert amf.animation_distance(x, y) < 1e-5 < 0.05 < amf.animation_distance(a, amf.detect(
        np.roll(frames, -11, axis=0), a.animation.faces, fps=30, rest=a.animation.vertices))
    alignment = amf.align(x, y)
    n = len(frames)
    assert alignment.phase == pytest.approx(11 / n, abs=1e-4) and alignment.loops == pytest.approx((n / 30, n / 30))
    assert amf.align(a, a).loops == (0, 0)
    np.testing.assert_allclose(alignment.to_b(np.arange(n) / 30), (np.arange(n) - 11) % n / 30, atol=1e-4)
    matches = amf.match_features(x, y, alignment)
    assert len(matches) == len(x.features) > 5
    late = (x.features["time"][matches["a"]] - y.features["time"][matches["b"]]) * 30 - 11
    assert np.abs((late + n / 2) % n - n / 2).max() < 1e-3
    assert amf.event_differences(x, y, alignment)["amplitude"].max() < 1e-4
    # where the deformation is described goes around, too
    np.testing.assert_allclose(amf.descriptors(loops[1], y.features[matches["b"]]),
                               amf.descriptors(loops[0], x.features[matches["a"]]), atol=2e-3)
    file = amf.read_features(folder / "a.json")
    assert not amf.signature(file).is_cyclic
    assert amf.signature(file._replace(parameters={**file.parameters, "cyclic": True})).is_cyclic
    assert not recwarn.list


def test_what_cannot_be_compared(pair, signatures):
    _, a, _ = pair
    x, _ = signatures
    with pytest.raises(TypeError, match="a Detection, a FeatureFile or a Signature"):
        amf.align(a, a.features)
    with pytest.raises(TypeError, match="a Detection is expected"):
        amf.descriptors(amf.read_features(pair[0] / "a.json"))
    with pytest.raises(amf.OptionError):
        amf.align(x, amf.signature(a, rate=25))
    for call in (lambda: amf.align(x, x, max_slope=0), lambda: amf.match_features(x, x, ratio=2),
                 lambda: amf.animation_distance(x, x, cycle_weight=3), lambda: amf.descriptors(a, descriptor="round"),
                 lambda: amf.signature(a, rate=-1), lambda: amf.event_differences(x, x, factor=0.5)):
        with pytest.raises(amf.OptionError):
            call()
    with pytest.raises(amf.OptionError, match="was not kept"):
        amf.descriptors(amf.detect(a.animation, keep_fields=()))
    bad = a.features[:2].copy()
    bad["vertex"] = 10 ** 6
    with pytest.raises(amf.InputError, match="1000000"):
        amf.signature(a, bad)
    bad["tau"] = 0
    with pytest.raises(amf.InputError, match="tau"):
        amf.signature(a, bad)
    with pytest.raises(amf.InputError, match="square"):
        amf.classical_scaling([[0, 1]])


def test_cancellation(pair, signatures):
    """of whatever compares, in each of its stages"""
    _, a, _ = pair
    x, y = signatures
    for compare, last in ((amf.match_features, "matching"), (amf.align, "alignment"), (amf.event_differences, "alignment"),
                          (amf.animation_distance, "distances"), (lambda *c, **k: amf.distance_matrix(c, **k), "distances")):
        told = []
        compare(a, y, threads=1, visitor=lambda *stage: told.append(stage))
        assert {s for s, _ in told} == {"descriptors", last} and told[-1] == (last, 1)
        for stage in ("descriptors", last):
            with pytest.raises(amf.Cancelled):
                compare(a, x, visitor=lambda s, _: s != stage)
        with pytest.raises(ZeroDivisionError):
            compare(x, y, visitor=lambda *_: 1 / 0)


def test_ctrl_c():
    """KeyboardInterrupt from the middle of an alignment and of a matching that take seconds"""
    code = """
import os, signal, threading, time
import numpy as np
import animated_mesh_features as amf
from animated_mesh_features import _core
n = 1000
features = np.zeros(n, amf.feature_dtype)
features["rest_position"] = np.random.default_rng(1).normal(size=(n, 3))
features["time"], features["sigma"], features["tau"], features["amplitude"] = np.linspace(0, 130, n), 0.1, 0.1, 1
x = amf.Signature(_core.signature_of_features(features, n, 4000, 1 / 30, 3.0, []))
signal.signal(signal.SIGINT, signal.default_int_handler)  # what runs in the background may ignore it

def interrupt():
    time.sleep(0.1)
    os.kill(os.getpid(), signal.SIGINT)

for compute in (amf.align, amf.match_features):
    told = []
    def visitor(stage, fraction):
        if not told:
            threading.Thread(target=interrupt).start()
        told.append(fraction)
    try:
        compute(x, x, visitor=visitor, **({"matched": n} if compute is amf.match_features else {}))
    except KeyboardInterrupt:
        print("interrupted", max(told))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout == "interrupted 0.0\n" * 2, done.stderr
