# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The files that the program writes and reads."""

import json

import numpy as np
import pytest

import animated_mesh_features as amf
from conftest import assert_same_features, run


@pytest.fixture(scope="module")
def result(cylinder):
    return amf.detect(cylinder.frames, cylinder.faces, fps=20, rest="average", keep_fields=("deformation", "strain"))


def test_same_files_as_the_program(cylinder, result, tmp_path):
    run("DETECT_FEATURES", cylinder.mesh, cylinder.cache, "--fps", 20, "--rest", "average", "-q",
        "-o", tmp_path / "p.json", "-o", tmp_path / "p.csv", "-o", tmp_path / "p.ply",
        "--write-field", f"deformation:{tmp_path}/p.npy")
    result.write([tmp_path / "m.json", tmp_path / "m.csv", tmp_path / "m.ply"],
                 write_field=f"deformation:{tmp_path}/m.npy")
    for kind in ("csv", "ply", "npy"):
        assert (tmp_path / f"p.{kind}").read_bytes() == (tmp_path / f"m.{kind}").read_bytes()
    p, m = (json.loads((tmp_path / f"{x}.json").read_text()) for x in "pm")
    assert p["parameters"].pop("inputs") != m["parameters"].pop("inputs")
    assert p == m
    assert np.array_equal(np.load(tmp_path / "m.npy"), result.deformation.astype(np.float32))


def test_features_come_back(result, tmp_path):
    result.write(tmp_path / "f.json")
    file = amf.read_features(tmp_path / "f.json")
    assert file.animation["vertices"] == 494 and file.parameters == result.parameters
    for name in file.features.dtype.names:
        if name == "refined_frame":
            np.testing.assert_allclose(file.features[name], result.features[name])
        else:
            assert np.array_equal(file.features[name], result.features[name]), name


def test_field_of_ones_own(cylinder, result, tmp_path):
    r = amf.detect_in_field(result.deformation, cylinder.rest, cylinder.faces, fps=20)
    r.write(tmp_path / "own.json")
    assert np.array_equal(amf.read_features(tmp_path / "own.json").features["strength"], r.features["strength"])
    with pytest.raises(amf.OptionError, match="--glb"):
        r.write(glb=tmp_path / "x.glb")


def test_scenes(result, tmp_path):
    result.write(glb=tmp_path / "s.glb", vtk=tmp_path / "scene")
    result.write(views=tmp_path / "views.json")
    assert json.loads((tmp_path / "views.json").read_text())
    assert (tmp_path / "s.glb").read_bytes()[:4] == b"glTF" and (tmp_path / "scene" / "features.pvd").exists()
    try:
        result.write(png=tmp_path / "s.png", plot=tmp_path / "s.svg", frame=[3, 7], png_size="320x200", view="-30,10")
    except amf.OptionError as e:
        assert "built without" in str(e)
    else:
        assert (tmp_path / "s.png").read_bytes()[1:4] == b"PNG" and "<svg" in (tmp_path / "s.svg").read_text()


def test_what_cannot_be_written_or_read(cylinder, result, tmp_path):
    with pytest.raises(amf.OutputError, match="nowhere") as e:
        result.write(tmp_path / "nowhere" / "f.json")
    assert isinstance(e.value, OSError)
    with pytest.raises(amf.OptionError, match="format is not clear"):
        result.write(tmp_path / "features")
    with pytest.raises(amf.OptionError, match="--write-field curvature: the field was not kept"):
        result.write(write_field=f"curvature:{tmp_path}/c.npy")
    with pytest.raises(amf.OptionError, match="strain was not kept"):
        amf.detect(result.animation).strain
    with pytest.raises(TypeError):
        result.write()
    with pytest.raises(TypeError):
        result.write(frame=3)
    assert not list(tmp_path.iterdir())
    (tmp_path / "bad.json").write_text('{"format": "something else"}')
    with pytest.raises(amf.InputError, match="bad.json"):
        amf.read_features(tmp_path / "bad.json")
    with pytest.raises(amf.InputError, match="nowhere.json"):
        amf.read_features("nowhere.json")
    for inputs in ((), ("nowhere.obj", "nowhere.pc2"), (cylinder.mesh,)):
        with pytest.raises(amf.Error):
            amf.read_animation(*inputs)


@pytest.mark.parametrize("cache", ["w.pc2", "w.mdd"])
def test_animations_are_written(cylinder, result, found_by_program, tmp_path, cache):
    """what is written is read again, by the module and by the program: the same numbers, in single precision"""
    files = tmp_path / "w.obj", tmp_path / cache
    for frames in (cylinder.frames, cylinder.frames.astype(float), np.asfortranarray(cylinder.frames),
                   list(cylinder.frames)):
        amf.write_animation(*files, frames, cylinder.faces, rest=cylinder.rest, fps=20)
        a = amf.read_animation(*files, rest="average", **({"fps": 20} if cache == "w.pc2" else {}))
        assert np.array_equal(a.frames, cylinder.frames) and a.fps == pytest.approx(20)
    mesh = amf.read_animation(*files, rest="mesh", fps=20)
    assert np.array_equal(mesh.vertices, cylinder.rest)
    assert np.array_equal(mesh.faces, result.animation.faces)
    run("DETECT_FEATURES", *files, "--fps", 20, "--rest", "average", "-q", "-o", tmp_path / "f.json")
    expected = found_by_program("--rest", "average")["features"]
    assert_same_features(amf.read_features(tmp_path / "f.json").features, [dict(f) for f in expected])
    # an animation, with its own shape at rest
    amf.write_animation(tmp_path / "a.obj", tmp_path / cache, result.animation)
    again = amf.read_animation(tmp_path / "a.obj", tmp_path / cache, rest="mesh")
    assert np.array_equal(again.frames, cylinder.frames)
    assert np.array_equal(again.vertices, result.animation.vertices)


def test_what_is_no_animation_is_not_written(cylinder, tmp_path):
    files = tmp_path / "w.obj", tmp_path / "w.pc2"
    large = cylinder.frames.astype(float)
    large[3, 7, 1] = 1e39
    bad = cylinder.faces.copy()
    bad[2, 1] = 10 ** 6
    for error, match, call in (
            (amf.InputError, "frame 3: the position of vertex 7", lambda: amf.write_animation(*files, large, cylinder.faces)),
            (amf.InputError, "face 2 has vertex 1000000", lambda: amf.write_animation(*files, cylinder.frames, bad)),
            (amf.InputError, "frame 0: has 494 vertices, the shape at rest 9",
             lambda: amf.write_animation(*files, cylinder.frames, [[0, 1, 2]], rest=cylinder.rest[:9])),
            (amf.OptionError, "w.npy", lambda: amf.write_animation(files[0], tmp_path / "w.npy", cylinder.frames, bad)),
            (amf.OptionError, "w.ply", lambda: amf.write_animation(tmp_path / "w.ply", files[1], cylinder.frames, bad)),
            (amf.OutputError, "nowhere",
             lambda: amf.write_animation(files[0], tmp_path / "nowhere" / "w.pc2", cylinder.frames, cylinder.faces)),
            (TypeError, "faces are needed", lambda: amf.write_animation(*files, cylinder.frames))):
        with pytest.raises(error, match=match):
            call()
        assert not list(tmp_path.iterdir())


def test_hdf5_and_models_say_what_is_missing(tmp_path):
    h5py = pytest.importorskip("h5py")
    frames = np.random.default_rng(1).normal(size=(4, 3, 5)).astype("f4")
    with h5py.File(tmp_path / "s.h5", "w") as file:
        file["walk"] = frames
        file["faces"] = np.array([[0, 1, 2], [0, 2, 3]], dtype="u4")
    try:
        a = amf.read_animation(tmp_path / "s.h5", rest="first")
    except amf.InputError as e:
        assert "built without" in str(e) or "frame" in str(e)
    else:
        assert np.array_equal(a.frames, frames.transpose(2, 0, 1)) and a.fps == 60 and a.clip == "walk"
