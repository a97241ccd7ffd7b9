# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A small animation, made by the program and read without the package, and what the program finds in it."""

import json
import os
import pathlib
import subprocess
import types

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def program(name):
    path = os.environ.get(name)
    if not path or not os.path.exists(path):
        pytest.skip(f"{name} does not name the program")
    return path


def run(name, *arguments):
    return subprocess.run([program(name), *map(str, arguments)], check=True, capture_output=True, text=True)


def read_obj(path):
    lines = [line.split() for line in path.read_text().splitlines()]
    vertices = np.array([line[1:4] for line in lines if line and line[0] == "v"], dtype=float)
    faces = np.array([[c.split("/")[0] for c in line[1:4]] for line in lines if line and line[0] == "f"], dtype=int) - 1
    return vertices, faces


def read_pc2(path):
    data = path.read_bytes()
    _, points, _, _, frames = np.frombuffer(data, "<i4,<i4,<f4,<f4,<i4", 1, 12)[0]
    return np.frombuffer(data, "<f4", 3 * points * frames, 32).reshape(frames, points, 3)


@pytest.fixture(scope="session")
def cylinder(tmp_path_factory):
    """frames (F x N x 3, float32), faces, rest (N x 3); and the files, for the program"""
    folder = tmp_path_factory.mktemp("cylinder")
    run("MAKE_ANIMATION", "cylinder", "--vertices", 500, "--frames", 40, "--fps", 20, "-o", folder / "a")
    rest, faces = read_obj(folder / "a.obj")
    frames = read_pc2(folder / "a.pc2")
    assert frames.shape == (40, len(rest), 3) and faces.max() + 1 == len(rest)
    for array in (frames, faces, rest):
        array.flags.writeable = False
    return types.SimpleNamespace(frames=frames, faces=faces, rest=rest, fps=20, mesh=folder / "a.obj",
                                 cache=folder / "a.pc2", folder=folder)


@pytest.fixture(scope="session")
def figure(tmp_path_factory):
    """a running figure: the folder of its mesh f.obj, its frames f.pc2, 30 a second, and its rig's events e.json"""
    folder = tmp_path_factory.mktemp("figure")
    run("MAKE_ANIMATION", "figure", "--vertices", 1200, "--frames", 36, "-o", folder / "f", "--events",
        folder / "e.json")
    return folder


@pytest.fixture(scope="session")
def found_by_program(cylinder):
    """what the program finds: found_by_program("--rest", "average") is the content of the JSON file"""
    def find(*options, field=None):
        path = cylinder.folder / "found.json"
        more = ["--write-field", field] if field else []
        run("DETECT_FEATURES", cylinder.mesh, cylinder.cache, "--fps", 20, "-q", "-o", path, *options, *more)
        return json.loads(path.read_text())
    return find


def assert_same_features(features, json_features):
    """bit for bit: JSON has as many digits as it takes to read the same number back"""
    assert len(features) == len(json_features) > 0
    for f, j in zip(features, json_features):
        for name in features.dtype.names:
            if name == "refined_frame":
                continue
            expected = j[name]
            if name in ("place", "parent"):  # from 1 in files, from 0 in arrays; -1 is none
                expected = -1 if expected is None else expected - 1
            assert f[name].tolist() == expected, name
