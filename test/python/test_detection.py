# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The same features as the program, whatever the arrays are made of."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

import animated_mesh_features as amf
from animated_mesh_features import _options
from conftest import assert_same_features, program


@pytest.fixture(scope="module")
def result(cylinder):
    return amf.detect(cylinder.frames, cylinder.faces, fps=20, rest="average", keep_fields=("deformation", "strain",
                                                                                           "curvature"))


@pytest.mark.parametrize("keywords, options", [
    ({"rest": "average"}, ["--rest", "average"]),
    ({"rest": "first", "alpha": 2, "strain": "green-lagrange", "balls": "dijkstra", "top": 5},
     ["--rest", "first", "--alpha", "2", "--strain", "green-lagrange", "--balls", "dijkstra", "--top", "5"]),
    ({"rest": 0, "preset": "published", "space_counts": 20, "time_counts": np.int32(8), "relative_threshold": 0.1},
     ["--rest", "frame:0", "--preset", "published", "--space-counts", "20", "--time-counts", "8",
      "--relative-threshold", "0.1"]),
    ({"rest": "average", "sigma_range": ("3%", "15%"), "tau_range": (None, 0.3), "spatial_filter": "one-ring",
      "dimension": "plane", "temporal_filter": "box", "curvature": "dihedral", "ball_radius": "6%", "threshold": 0.05,
      "min_fit": 0, "no_suppression": True, "baseline": "none"},
     ["--rest", "average", "--sigma-range", "3%:15%", "--tau-range", ":0.3", "--spatial-filter", "one-ring",
      "--dimension", "plane", "--temporal-filter", "box", "--curvature", "dihedral", "--ball-radius", "6%",
      "--threshold", "0.05", "--min-fit", "0", "--no-suppression", "--baseline", "none"]),
])
def test_same_as_program(cylinder, found_by_program, keywords, options):
    r = amf.detect(cylinder.frames, cylinder.faces, fps=20, **keywords)
    expected = found_by_program(*options)
    assert_same_features(r.features, expected["features"])
    for name, value in expected["parameters"].items():
        if name not in ("inputs", "program"):
            assert r.parameters[name] == value, name


def test_rest_array_is_the_mesh(cylinder, found_by_program):
    r = amf.detect(cylinder.frames, cylinder.faces, fps=20, rest=cylinder.rest)
    assert_same_features(r.features, found_by_program("--rest", "mesh")["features"])
    doubled = amf.detect(cylinder.frames, cylinder.faces, fps=20, rest=2 * cylinder.rest, rescale_rest=True)
    assert doubled.animation.rest_factor == pytest.approx(0.5, rel=1e-6)
    with pytest.raises(amf.InputError, match="unit"):
        amf.detect(cylinder.frames, cylinder.faces, rest=2 * cylinder.rest)


def test_files_are_the_same_animation(cylinder, result):
    a = amf.read_animation(cylinder.mesh, cylinder.cache, fps=20, rest="average")
    assert np.array_equal(a.frames, cylinder.frames) and np.array_equal(a.x, cylinder.frames[:, :, 0].T)
    assert np.array_equal(amf.detect(a).features, result.features)
    assert sorted(map(tuple, a.faces)) == sorted(tuple(np.roll(f, -f.argmin())) for f in cylinder.faces)


def layouts(frames, folder):
    strided = np.zeros((2 * len(frames), frames.shape[1], 5), dtype=frames.dtype)
    strided[::2, :, 1:4] = frames
    np.save(folder / "frames.npy", frames)
    record = np.zeros(frames.shape[:2], dtype=[("tag", "i1"), ("p", "f4", 3)])
    record["p"] = frames
    return {"double": frames.astype(float), "Fortran": np.asfortranarray(frames), "strided": strided[::2, :, 1:4],
            "vertices x 3 x frames": np.ascontiguousarray(frames.transpose(1, 2, 0)).transpose(2, 0, 1),
            "reversed": frames[::-1].copy()[::-1], "big-endian": frames.astype(">f4"), "unaligned": record["p"],
            "memory map": np.load(folder / "frames.npy", mmap_mode="r"), "list": list(frames),
            "list of doubles and singles": [f.astype(float) if i % 2 else f for i, f in enumerate(frames)],
            "long double": frames.astype(np.longdouble)}


def test_layouts_of_frames(cylinder, result):
    for name, frames in layouts(cylinder.frames, cylinder.folder).items():
        r = amf.detect(frames, cylinder.faces, fps=20, rest="average")
        assert np.array_equal(r.features, result.features), name
    integers = np.round(1000 * cylinder.frames).astype(np.int16)
    assert np.array_equal(amf.Animation(integers, cylinder.faces, rest="first").frames, integers)


@pytest.mark.parametrize("dtype", ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", ">i4"])
def test_types_of_faces(cylinder, dtype):
    grid = cylinder.faces if np.dtype(dtype).itemsize > 1 else cylinder.faces[(cylinder.faces < 100).all(axis=1)]
    frames = cylinder.frames if np.dtype(dtype).itemsize > 1 else cylinder.frames[:, :100]
    expected = amf.Animation(frames, grid, rest="first").faces
    for faces in (grid.astype(dtype), np.asfortranarray(grid.astype(dtype)), grid.astype(dtype).tolist()):
        assert np.array_equal(amf.Animation(frames, faces, rest="first").faces, expected)


def test_arrays_of_the_result(cylinder, result):
    d, n, f = result.deformation, len(cylinder.rest), len(cylinder.frames)
    assert d.shape == (n, f) and d.dtype == np.float64 and not d.flags.writeable and not d.flags.owndata
    assert d.__array_interface__["data"] == result.deformation.__array_interface__["data"]  # no copy
    alpha = result.parameters["alpha"]
    sum_of_both = result.strain + alpha * result.curvature
    np.testing.assert_allclose(d, sum_of_both - sum_of_both.min(axis=1, keepdims=True), atol=1e-12)
    features = result.features
    assert (np.diff(features["strength"]) <= 0).all() and (features["vertex"] < n).all()
    np.testing.assert_allclose(features["barycentric_coordinates"].sum(axis=1), 1)
    # the rest position is where the triangle says
    corners = result.animation.vertices[features["triangle"]]
    np.testing.assert_allclose((corners * features["barycentric_coordinates"][..., None]).sum(axis=1),
                               features["rest_position"], atol=1e-12)
    np.testing.assert_array_equal(features["time"], features["refined_frame"] * result.animation.frame_duration)
    view = result.deformation
    del result, features
    assert view.sum() > 0


def test_fields_alone(cylinder, result, found_by_program):
    a = result.animation
    assert np.array_equal(amf.deformation(a), result.deformation)
    assert np.array_equal(amf.strain(a), result.strain)
    assert np.array_equal(amf.curvature(cylinder.frames, cylinder.faces, rest="average"), result.curvature)
    for strain, function in {"stretch": np.abs, "hencky": np.abs}.items():
        assert function(amf.strain(a, strain=strain)).max() > 0
    found_by_program("--rest", "average", field=f"strain:{cylinder.folder}/strain.npy")
    assert np.array_equal(np.load(cylinder.folder / "strain.npy"), result.strain.astype(np.float32))
    # a uniform scaling by s of a surface at rest: both principal stretches are s, the Hencky strain is sqrt(2) ln s
    scaled = np.stack([cylinder.rest, 1.1 * cylinder.rest, cylinder.rest])
    strains = amf.strain(scaled, cylinder.faces, rest="first")
    np.testing.assert_allclose(strains[:, 1], np.sqrt(2) * np.log(1.1), rtol=1e-9)


def test_geodesic_balls(cylinder):
    shape = amf.Shape(cylinder.rest, cylinder.faces)
    offsets, vertices = amf.geodesic_balls(shape, ball_radius="8%")
    other = amf.geodesic_balls(cylinder.rest, cylinder.faces, ball_radius=0.08 * shape.diameter)
    assert np.array_equal(offsets, other[0]) and np.array_equal(vertices, other[1])
    assert offsets[0] == 0 and offsets[-1] == len(vertices) and len(offsets) == len(cylinder.rest) + 1
    for v in (0, 17, len(cylinder.rest) - 1):
        ball = vertices[offsets[v]:offsets[v + 1]]
        assert v in ball and (np.diff(ball.astype(int)) > 0).all()
        # no nearer than as the crow flies
        assert (np.linalg.norm(cylinder.rest[ball] - cylinder.rest[v], axis=1) <= 0.08 * shape.diameter + 1e-12).all()
    # by paths along edges: SciPy's, where it is here
    sparse = pytest.importorskip("scipy.sparse")
    graph = pytest.importorskip("scipy.sparse.csgraph")
    edges = np.concatenate([cylinder.faces[:, [i, (i + 1) % 3]] for i in range(3)])
    lengths = np.linalg.norm(cylinder.rest[edges[:, 0]] - cylinder.rest[edges[:, 1]], axis=1)
    n = len(cylinder.rest)
    half = sparse.coo_matrix((lengths, edges.T), (n, n)).tocsr()
    paths = graph.dijkstra(half.maximum(half.T), indices=[0, 99])
    offsets, vertices = amf.geodesic_balls(shape, ball_radius=0.08 * shape.diameter, balls="dijkstra")
    for row, v in zip(paths, (0, 99)):
        assert np.array_equal(vertices[offsets[v]:offsets[v + 1]], np.flatnonzero(row <= 0.08 * shape.diameter))


def test_own_field(cylinder, result):
    """in the deformation as a field of one's own, the features are the same but for the noise, which is 0"""
    a = result.animation
    r = amf.detect_in_field(result.deformation, a, threshold=0.1)
    assert np.array_equal(r.features, result.features)
    still = amf.detect_in_field(result.deformation, a.vertices, cylinder.faces, fps=20, threshold=0.1)
    for name in ("vertex", "frame", "sigma", "tau", "strength", "rest_position"):
        np.testing.assert_allclose(still.features[name], result.features[name], rtol=1e-9, atol=1e-9)
    assert np.array_equal(still.features["position"], still.features["rest_position"])
    # a bump in space and time is found where it is
    centre, moment = 200, 18
    distance = np.linalg.norm(cylinder.rest - cylinder.rest[centre], axis=1) / (0.05 * a.diameter)
    bump = np.exp(-distance[:, None] ** 2 / 2 - (np.arange(40) - moment) ** 2 / 2 / 3.0 ** 2)
    for field in (bump, np.asfortranarray(bump), bump.astype(np.float32)[:, ::-1].copy()[:, ::-1]):
        best = amf.detect_in_field(field, cylinder.rest, cylinder.faces, frame_duration=0.05).features[0]
        assert np.linalg.norm(cylinder.rest[best["vertex"]] - cylinder.rest[centre]) < 0.03 * a.diameter
        assert abs(best["frame"] - moment) <= 1 and best["tau"] == pytest.approx(3 * 0.05, rel=0.25)


def option_table(name):
    """the options in the help text of a program: for each its description in one line"""
    usage = subprocess.run([program(name), "--help"], capture_output=True, text=True, check=True).stdout
    parts = re.split(r"^  (?:-\w \[ )?--([a-z-]+)", usage, flags=re.MULTILINE)
    return {option: " ".join(text.split("\n\n")[0].split()) for option, text in zip(parts[1::2], parts[2::2])}


def keywords_of(*functions):
    """their arguments that can be keywords, with their defaults"""
    return {name: p.default for f in functions for name, p in inspect.signature(f).parameters.items()
            if p.kind != p.VAR_POSITIONAL and p.default is not p.empty}


TERMINAL = {"help", "version", "quiet", "verbose"}
# What an array has no use for: it is sliced, frames[a:b + 1], and is no file that would have to be understood.
FILES = {"clip", "frames", "there-and-back", "allow-outside", "faces", "part", "as-given"}


@pytest.mark.parametrize("name, functions, without", [
    ("DETECT_FEATURES", (amf.detect, amf.Detection.write), TERMINAL | FILES | {"man", "completion"}),
    ("DETECT_FEATURES", (amf.read_animation, amf.detect, amf.Detection.write), TERMINAL | {"man", "completion"}),
    # a signature stands for the cache, an array for a file, a comparison with the tolerance for the check
    ("COMPARE_ANIMATIONS", (amf.read_animation, amf.detect, amf.descriptors, amf.signature, amf.match_features,
                            amf.align, amf.distance_matrix),
     TERMINAL - {"version"} | {"cache", "output", "html", "plot", "write-descriptors", "check", "tolerance"}),
    ("SIMPLIFY_ANIMATION", (amf.read_animation, amf.simplify),
     TERMINAL | {"output", "format", "also", "binding", "report", "plot", "keep-seams"}),
])
def test_options_are_those_of_the_program(name, functions, without):
    """every option of the command line is a keyword of the same name and default, but for what makes no sense here"""
    table = option_table(name)
    keywords = keywords_of(*functions)
    without_faces = dict(keywords)
    if amf.read_animation not in functions:
        del without_faces["faces"]  # an array there
    assert {o for o in table if o.replace("-", "_") not in without_faces} == without
    told = 0
    for option, text in table.items():
        default = keywords.get(option.replace("-", "_"))
        if option in without or default is None or default is False:
            continue  # left to the program's own library, and a switch
        told += 1
        value = f"{default:g}" if isinstance(default, float) else str(default)
        assert re.search(rf"\(default: {value}\b|\b{value} \(default\)|\b{value}, default", text), (option, text)
    assert told >= (0 if name == "SIMPLIFY_ANIMATION" else 2)
    # and every default of the module's own has its option there
    for function in functions:
        for keyword in inspect.signature(function).parameters:
            assert keyword == "self" or re.search(rf"\b{keyword}\b", function.__doc__), (function, keyword)


def test_frames_of_a_range(cylinder, found_by_program):
    r = amf.detect(cylinder.frames[5:31], cylinder.faces, fps=20, rest="average")
    assert_same_features(r.features, found_by_program("--rest", "average", "--frames", "5:30")["features"])
    files = amf.read_animation(cylinder.mesh, cylinder.cache, fps=20, rest="average", frames="5:30")
    assert np.array_equal(amf.detect(files).features, r.features)


def test_documentation():
    assert "--sigma-range" in amf.options()
    assert "--bend-weight" in amf.options(["comparison"]) and "--lods" in amf.options(["simplification"])
    for name in amf.__all__:
        assert getattr(amf, name) is not None
        assert not callable(getattr(amf, name)) or getattr(amf, name).__doc__, name
        assert not re.search(r"^ *\{\w+\}$", getattr(amf, name).__doc__ or "", re.MULTILINE), name


def test_shared_keywords():
    """the same name, default and type wherever an option is taken, and in the order of the one table"""
    table = {name: default for group in _options.GROUPS.values() for name, default in group.items()}
    for name, function in [(n, getattr(amf, n)) for n in amf.__all__]:
        if not inspect.isfunction(function) and function is not amf.Animation:
            continue
        parameters = inspect.signature(function).parameters
        for p in parameters.values():
            # a field of one's own has no unit that it could be shifted in
            if p.name in table and p.kind is p.KEYWORD_ONLY and (name, p.name) != ("detect_in_field", "baseline"):
                assert p.default == table[p.name], (name, p.name)
    assert str(inspect.signature(amf.distance_matrix)).startswith(
        "(animations, *, distance_place_weight=0.0, distance_recurrence_weight=1.0, cycle_weight=0.1, "
        "variation_weight=0.4, duration_weight=0.1, threads=None, visitor=None)")
    with pytest.raises(TypeError, match=r"align\(\) got an unexpected keyword argument 'alpha'"):
        amf.align(None, None, alpha=1)


def test_type_stubs():
    """tell the same arguments as the functions have, of the same type wherever there are several that take them"""
    folder = pathlib.Path(amf.__file__).parent
    assert (folder / "py.typed").exists()
    known, types = 0, {}
    for stub in ("_animation", "_detection", "_comparison", "_simplification", "_views"):
        for node in ast.parse((folder / f"{stub}.pyi").read_text(encoding="utf-8")).body:
            own = getattr(amf, node.name, None) if isinstance(node, ast.ClassDef) else amf
            for f in node.body if isinstance(node, ast.ClassDef) else [node]:
                function = getattr(own, f.name, None) if isinstance(f, ast.FunctionDef) else None
                if not inspect.isfunction(function):
                    continue
                a = f.args
                for x in a.kwonlyargs:
                    types.setdefault(x.arg, {})[f.name] = ast.unparse(x.annotation)
                parameters = inspect.signature(function).parameters.values()
                assert [x.arg for x in a.args] == [p.name for p in parameters
                                                   if p.kind is p.POSITIONAL_OR_KEYWORD], f.name
                assert {x.arg for x in a.kwonlyargs} == {p.name for p in parameters if p.kind is p.KEYWORD_ONLY}, f.name
                known += 1
    assert known >= 20
    del types["rest"]["read_animation"], types["frames"]  # files, and a number of frames
    for name, annotations in types.items():
        if name in _options.GROUPS["arrays"] or "strain" in annotations or "threads" == name:
            assert len(set(annotations.values())) == 1, (name, annotations)


def test_types(tmp_path):
    """as mypy sees them, where it is here: of all that is public, and of the thirty-second example"""
    pytest.importorskip("mypy.stubtest", reason="mypy is not here (Debian: python3-mypy)")
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join([str(pathlib.Path(amf.__file__).parents[1]), *sys.path]),
                       MYPYPATH=str(pathlib.Path(amf.__file__).parents[1]))
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "animated_mesh_features", "--concise",
                           "--ignore-missing-stub"], cwd=tmp_path, env=environment, capture_output=True, text=True)
    wrong = [line for line in done.stdout.splitlines() if not line.startswith("animated_mesh_features._")
             and not line.endswith(".NamedTuple is not a type")]
    assert not wrong and not done.stderr, done.stderr
    (tmp_path / "example.py").write_text("""
import numpy as np
import animated_mesh_features as amf

def example(frames: np.ndarray, faces: np.ndarray) -> float:
    r = amf.detect(frames, faces, frame_duration=1/30, rest="average", sigma_range=("3%", None), visitor=print)
    r.write("features.json", html="view.html")
    t = amf.align(r, r, max_slope=2).to_b(0.5)
    matrix: np.ndarray = amf.distance_matrix([r, r])
    level = amf.simplify(frames, faces, ratio=0.1).levels[0]
    return t + float(matrix[0, 1]) + len(level.positions(frames)) + len(amf.select_views(r).azimuth)
""", encoding="utf-8")
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--allow-any-generics", "example.py"], cwd=tmp_path,
                          env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_welded_vertices(cylinder):
    """a seam is closed, and what was given can be told from what is left"""
    n = len(cylinder.rest)
    upper = cylinder.rest[cylinder.faces].mean(axis=1)[:, 2] > np.median(cylinder.rest[:, 2])
    seam = np.intersect1d(cylinder.faces[upper], cylinder.faces[~upper])
    copy_of = np.arange(n)
    copy_of[seam] = n + np.arange(len(seam))
    frames = np.concatenate([cylinder.frames, cylinder.frames[:, seam]], axis=1)
    faces = np.where(upper[:, None], copy_of[cylinder.faces], cylinder.faces)
    assert amf.Animation(frames, faces, rest="first", weld="never").number_of_vertices == n + len(seam)
    a = amf.Animation(frames, faces, rest="first")
    assert a.number_of_vertices == n and len(a.vertex_of_input) == n + len(seam)
    assert np.array_equal(a.frames[:, a.vertex_of_input], frames)
    r = amf.detect(a)
    whole = amf.detect(cylinder.frames, cylinder.faces, rest="first")
    np.testing.assert_allclose(r.features["strength"], whole.features["strength"], rtol=1e-6)
