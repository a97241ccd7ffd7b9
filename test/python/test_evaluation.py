# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The measures of quality, against brute force, analytic answers and what chance must be."""

import json

import numpy as np
import pytest

import animated_mesh_features as amf

ev = amf.evaluation


@pytest.fixture(scope="module")
def result(cylinder):
    return amf.detect(cylinder.frames, cylinder.faces, fps=20, rest="average", threshold=0.02, min_fit=0)


def are_near(a, b, place, time):
    return (np.linalg.norm(a["rest_position"][:, None] - b["rest_position"], axis=2) <= place) & \
        (np.abs(a["time"][:, None] - b["time"]) <= time)


def test_repeated_and_paired(result):
    f = result.features
    moved = f[::2].copy()
    moved["sigma"] *= 2
    gates = dict(place=0.02 * result.animation.diameter, time=0.1)
    found, with_scales = ev.repeated_features(f, moved, top=len(f), among=len(f), **gates)
    near = are_near(f, moved, **gates)
    assert np.array_equal(found, near.any(axis=1)) and found[::2].all()
    ratio = np.maximum(f["sigma"][:, None] / moved["sigma"], moved["sigma"] / f["sigma"][:, None])
    tau = np.maximum(f["tau"][:, None] / moved["tau"], moved["tau"] / f["tau"][:, None])
    assert np.array_equal(with_scales, (near & (ratio <= 1.5) & (tau <= 1.5)).any(axis=1))
    assert ev.paired_features(f, f, place=1e-9, time=1e-9)[1].all()
    csgraph = pytest.importorskip("scipy.sparse.csgraph")
    sparse = pytest.importorskip("scipy.sparse")
    gates = dict(place=0.2 * result.animation.diameter, time=0.5)
    near = sparse.csr_matrix(are_near(f[::3], moved, **gates))
    partners = csgraph.maximum_bipartite_matching(near, perm_type="column")
    pairs = ev.paired_features(f[::3], moved, **gates)[0]
    assert pairs.sum() == (partners >= 0).sum() and len(pairs) == len(f[::3])
    again = ev.shifted_in_time(ev.shifted_in_time(f, 0.7, 2.0), -0.7, 2.0)
    np.testing.assert_allclose(again["time"], f["time"])


def test_matching_errors(cylinder, result):
    shape, f = result.animation, result.features
    assert (ev.matching_errors(shape, f, f) == 0).all()
    others = f[:3]
    csgraph = pytest.importorskip("scipy.sparse.csgraph")
    sparse = pytest.importorskip("scipy.sparse")
    edges = np.concatenate([shape.faces[:, [i, (i + 1) % 3]] for i in range(3)])
    lengths = np.linalg.norm(shape.vertices[edges[:, 0]] - shape.vertices[edges[:, 1]], axis=1)
    half = sparse.coo_matrix((lengths, edges.T), (494, 494)).tocsr()
    paths = csgraph.dijkstra(half.maximum(half.T), indices=others["vertex"])
    np.testing.assert_allclose(ev.matching_errors(shape, f, others), paths[:, f["vertex"]].min(axis=0), atol=1e-12)
    gated = np.where(np.abs(others["time"][:, None] - f["time"]) <= 0.2, paths[:, f["vertex"]], np.inf).min(axis=0)
    np.testing.assert_allclose(ev.matching_errors(shape, f, others, time=0.2), gated, atol=1e-12)


def test_regions_and_scores(result):
    shape, f = result.animation, result.features[:4]
    present = ev.feature_regions(shape, f, 40, 0.05)
    assert present.shape == (494, 40) and present.dtype == np.float32 and set(np.unique(present)) == {0, 1}
    times = 0.05 * np.arange(40)
    for one in f:
        np.testing.assert_array_equal(present[one["vertex"], np.abs(times - one["time"]) <= one["tau"]], 1)
    gaussian = ev.feature_regions(shape, f[:1], 40, 0.05, course="gaussian")[f[0]["vertex"]]
    x = (times - f[0]["time"]) / f[0]["tau"]
    np.testing.assert_allclose(gaussian, np.where(np.abs(x) <= 3, np.exp(-x * x / 2), 0), atol=1e-6)
    perfect = ev.map_scores(present, present, shape.areas)
    assert perfect.auc == 1 and perfect.correlation == pytest.approx(1)
    noise = np.random.default_rng(0).random(present.shape)
    weights = np.broadcast_to(shape.areas[:, None], noise.shape).astype(float)
    marked = present > 0
    order = np.argsort(noise.astype(np.float32), axis=None)
    below = np.cumsum((weights * ~marked).ravel()[order])
    auc = ((weights * marked).ravel()[order] * below).sum() / (weights * marked).sum() / (weights * ~marked).sum()
    assert ev.map_scores(noise, present, shape.areas).auc == pytest.approx(auc, abs=1e-4)
    assert auc == pytest.approx(0.5, abs=0.1)
    with pytest.raises(amf.InputError, match="nothing is marked"):
        ev.map_scores(noise, 0 * present, shape.areas)
    with pytest.raises(amf.OptionError):
        ev.map_scores(noise[1:], present, shape.areas)
    with pytest.raises(amf.InputError, match="494"):
        ev.feature_regions(shape, ev.shifted_in_time(_at(f, 494), 0, 1), 40, 0.05)


def _at(features, vertex):
    moved = features.copy()
    moved["vertex"] = vertex
    return moved


def test_painting(result, tmp_path):
    """what people painted, as marks for the scores"""
    n, f = result.deformation.shape
    path = tmp_path / "anna.json"
    data = {"format": "animated-mesh-features-painting", "version": 1, "painter": "Anna",
            "animation": {"vertices": n, "frames": f, "frame_duration": 0.05},
            "strokes": [{"frame": 4, "frames": [3, 6], "vertices": [7, 2]}, {"frames": [0, 0], "vertices": [9]}]}
    path.write_text(json.dumps(data))
    painting = ev.read_painting(path)
    assert painting.painter == "Anna" and painting.vertices == n and painting.frame_duration == 0.05
    marks = painting.marks()
    assert marks.shape == (n, f) and marks.sum() == 9 and marks[[2, 7], 3:7].all() and marks[9, 0] == 1
    scores = ev.map_scores(marks, marks, result.animation.areas)
    assert scores.auc == 1 and scores.correlation == pytest.approx(1)
    data["strokes"][0]["vertices"][1] = n
    path.write_text(json.dumps(data))
    with pytest.raises(amf.InputError, match=r"anna.json.*strokes\[0\].vertices\[1\]"):
        ev.read_painting(path)


def test_intervals_and_chance(result):
    sample = np.random.default_rng(2).normal(3, 1, 400)
    low, high = ev.bootstrap_interval(sample)
    error = sample.std() / 20  # of the mean
    assert (low, high) == pytest.approx((sample.mean() - 1.96 * error, sample.mean() + 1.96 * error), abs=0.02)
    assert ev.bootstrap_interval(sample, np.mean, resamples=200) == pytest.approx(
        ev.bootstrap_interval(sample, resamples=200), abs=1e-12)
    vertices, times = ev.random_places(50, 494, 2.0, draws=30, seed=4)
    assert vertices.shape == times.shape == (30, 50) and vertices.max() < 494 and 0 <= times.min() <= times.max() < 2
    # of half of the vertices
    level = ev.chance_level(result.features, 494, 2.0, lambda f: (f["vertex"] < 247).mean(), draws=200)
    assert level == pytest.approx(0.5, abs=4 * 0.5 / np.sqrt(200 * len(result.features)))
    assert ev.prominent_maxima([0, 3, 1, 2, 0, 0.5, 0], 1) == [(1, 3.0, 3.0), (3, 2.0, 1.0)]


def test_rig(figure, tmp_path):
    """the figure's features are at the bends of its joints, more than by chance"""
    rig = ev.read_rig_events(figure / "e.json")
    a = amf.read_animation(figure / "f.obj", figure / "f.pc2", rest="mesh", fps=1 / rig.frame_duration)
    f = amf.detect(a, top=20).features
    matches = ev.rig_matches(rig, a.vertices, f)
    assert len(matches.found) == len(matches.recalled) > 0 and len(matches.at_event) == len(f)
    chance = ev.chance_level(f, a.number_of_vertices, 36 * a.frame_duration,
                             lambda g: ev.rig_matches(rig, a.vertices, g).at_event.mean())
    assert matches.at_event.mean() > chance + 0.2
    assert ev.rig_matches(rig, a.vertices, f, least_recalled_angle=1000.0).recalled == []
    with pytest.raises(TypeError):
        ev.rig_matches(rig, a.vertices, f, nonsense=1)
    (tmp_path / "bad.json").write_text(json.dumps({"format": "animated-mesh-features-rig-events"}))
    with pytest.raises(amf.InputError, match="bad.json"):
        ev.read_rig_events(tmp_path / "bad.json")
