# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Simplification: what the program makes, as arrays."""

import json

import numpy as np
import pytest

import animated_mesh_features as amf
from conftest import run


@pytest.fixture(scope="module")
def animation(cylinder):
    return amf.Animation(cylinder.frames, cylinder.faces, fps=20, rest=cylinder.rest)


@pytest.fixture(scope="module")
def levels(animation):
    return amf.simplify(animation, lods=(0.5, 0.2))


def assert_same_report(report, path):
    expected = json.loads(path.read_text())
    del expected["animation"], report["animation"]
    assert report == expected


def test_same_as_program(cylinder, animation, levels, tmp_path):
    def simplified(*options):
        run("SIMPLIFY_ANIMATION", cylinder.mesh, cylinder.cache, "--fps", 20, "--rest", "mesh", "-q", "--report",
            tmp_path / "r.json", "--binding", tmp_path / "b.json", *options)
        return json.loads((tmp_path / "b.json").read_text())["levels"]

    expected = simplified("--lods", "0.5,0.2")
    assert len(levels.levels) == len(expected) == 2
    for level, rows in zip(levels.levels, expected):
        assert np.array_equal(level.faces, rows["triangles"])
        assert np.array_equal(level.indptr, np.cumsum([0] + [len(row) for row in rows["vertices"]]))
        assert np.array_equal(level.indices, np.concatenate(rows["vertices"]))
        assert np.array_equal(level.data, np.concatenate(rows["weights"]))
    assert_same_report(levels.report, tmp_path / "r.json")

    found = amf.detect(animation)
    found.write(tmp_path / "f.json")
    simplified("--vertices", 90, "--features", tmp_path / "f.json", "--guidance", 4, "--poses", 7, "--normals", 60,
               "--support", 5)
    guided = amf.simplify(animation, vertices=90, features=found, guidance=4, poses=7, normals=60, support=5)
    assert_same_report(guided.report, tmp_path / "r.json")
    assert np.diff(guided.levels[0].indptr).max() <= 5 and len(guided.poses) <= 7
    assert guided.levels[0].errors["share_in_regions"].any()

    simplified("--error", 0.3)
    within = amf.simplify(cylinder.frames, cylinder.faces, fps=20, rest=cylinder.rest, error=0.3)
    assert_same_report(within.report, tmp_path / "r.json")
    assert 0.1 < within.report["levels"][0]["worst_mean"] <= 0.3


def test_levels(cylinder, animation, levels):
    n = len(cylinder.rest)
    for level, report, share in zip(levels.levels, levels.report["levels"], (0.5, 0.2)):
        m = len(level.vertices)
        assert m == round(share * n) and level.shape == (m, n)
        assert sorted(set(level.vertex_of)) == list(range(m)) == sorted(set(level.faces.ravel()))
        np.testing.assert_allclose(np.add.reduceat(level.data, level.indptr[:-1]), 1, atol=1e-9)
        np.testing.assert_allclose(level.positions(cylinder.rest[None])[0], level.vertices, atol=1e-12)
        # closed surfaces stay closed: each edge is in two triangles, once in each direction
        edges = np.concatenate([level.faces[:, [i, (i + 1) % 3]] for i in range(3)])
        assert len(np.unique(edges, axis=0)) == len(edges)
        assert np.array_equal(np.unique(edges, axis=0), np.unique(edges[:, ::-1], axis=0))
        # vertices follow every affine map
        affine = np.random.default_rng(5).normal(size=(3, 3))
        np.testing.assert_allclose(level.positions(cylinder.frames @ affine + 1),
                                   level.positions(animation) @ affine + 1, atol=1e-5)
        means = (level.errors["mean_to_original"] + level.errors["mean_to_coarse"]) / 2
        assert level.errors["frame"].tolist() == list(range(40)) and (level.errors["turned"] == 0).all()
        assert report["worst_mean"] == pytest.approx(100 * means.max() / animation.bounding_box_diagonal)
    # nested
    fine, coarse = (level.vertex_of for level in levels.levels)
    for v in range(len(levels.levels[0].vertices)):
        assert len(set(coarse[fine == v])) == 1
    assert str(levels).splitlines()[-1].split()[0] == str(len(levels.levels[1].vertices))


def test_scipy(cylinder, levels):
    sparse = pytest.importorskip("scipy.sparse")
    level = levels.levels[1]
    matrix = sparse.csr_matrix((level.data, level.indices, level.indptr), level.shape)
    positions = level.positions(cylinder.frames)
    for f in (0, 17, 39):
        np.testing.assert_allclose(matrix @ cylinder.frames[f].astype(float), positions[f], atol=1e-7)


def test_options_and_cancellation(cylinder, animation):
    assert amf.simplify(animation, ratio=0.3, measure=False).levels[0].errors is None
    with pytest.raises(amf.OptionError, match="in one way"):
        amf.simplify(animation)
    with pytest.raises(amf.OptionError, match="in one way"):
        amf.simplify(animation, ratio=0.3, vertices=100)
    for options in (dict(vertices=2), dict(vertices=[100, 100]), dict(ratio=2), dict(ratio=0.5, normals=100),
                    dict(ratio=0.5, support=0), dict(ratio=0.5, guidance=1), dict(vertices=10 ** 6)):
        with pytest.raises(amf.OptionError):
            amf.simplify(animation, **options)
    features = np.zeros(1, dtype=amf.feature_dtype)
    features["vertex"] = 10 ** 6
    with pytest.raises(amf.InputError, match="features"):
        amf.simplify(animation, ratio=0.5, features=features)
    with pytest.raises(amf.InputError, match="vertices"):
        amf.simplify(animation, ratio=0.2, measure=False).levels[0].positions(cylinder.frames[:, 1:])
    told = []
    one = amf.simplify(animation, vertices=60, threads=1, visitor=lambda *stage: told.append(stage))
    assert {s for s, _ in told} == {"simplification", "errors"} and told[-1] == ("errors", 1)
    assert one.report == amf.simplify(animation, vertices=60).report
    for stage in ("simplification", "errors"):
        with pytest.raises(amf.Cancelled):
            amf.simplify(animation, ratio=0.3, visitor=lambda s, _: s != stage)
