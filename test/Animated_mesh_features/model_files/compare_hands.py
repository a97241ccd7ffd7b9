#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""mirror IN.glb OUT.glb: the same model, mirrored by its root node.
exact A.json B.json: are the features of mirror images the same?
alike A.json B.json ALL_A.json ALL_B.json FILE.glb CLIP: do the three strongest features of A and of B, and at least half
of all, have their like among all of the other one's? FILE.glb gives the places where they are compared, by the vertices of
the file.
"""

import json
import math
import struct
import sys

import reference


def load(name):
    with open(name) as file:
        return json.load(file)


def mirror(source, target):
    data = open(source, "rb").read()
    length = struct.unpack_from("<I", data, 12)[0]
    model = json.loads(data[20:20 + length])
    for root in model["scenes"][0]["nodes"]:
        model["nodes"][root]["scale"] = [-1, 1, 1]
    text = json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length:]
    with open(target, "wb") as file:
        file.write(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest)


def exact(a, b):
    a, b = load(a)["features"], load(b)["features"]
    assert len(a) == len(b) and len(a) > 3, "%d and %d features" % (len(a), len(b))
    worst = 0
    for f, g in zip(a, b):
        assert (f["vertex"], f["frame"], f["file_vertices"]) == (g["vertex"], g["frame"], g["file_vertices"])
        worst = max(worst, *(abs(g[k] / f[k] - 1) for k in ("strength", "sigma", "tau", "time")))
        assert math.dist([-f["position"][0]] + f["position"][1:], g["position"]) < 1e-5 * f["sigma"]
    print("mirrored: %d features, the same to %.1e" % (len(a), worst))
    assert worst < 1e-5, "strengths or scales differ by %g" % worst


def alike(a, b, all_a, all_b, path, clip):
    a, b, all_a, all_b = (load(name)["features"] for name in (a, b, all_a, all_b))
    file = reference.File(path)
    index = [c["name"] for c in file.json["animations"]].index(clip)
    places = file.positions(index, file.clip_range(index)[0])

    def apart(f, g):
        """in their own scales"""
        return math.hypot(math.dist(places[f["file_vertices"][0]], places[g["file_vertices"][0]]) /
                          max(f["sigma"], g["sigma"]), (f["time"] - g["time"]) / max(f["tau"], g["tau"]))

    found = 0
    for mine, others in (a, all_b), (b, all_a):
        for rank, f in enumerate(mine):
            like = min(others, key=lambda g: apart(f, g))
            is_found = apart(f, like) < 1.5 and 0.5 < like["amplitude"] / f["amplitude"] < 2
            found += is_found
            print("vertex %4d amplitude %.3f: vertex %4d amplitude %.3f, %.2f scales apart%s" % (
                f["vertex"], f["amplitude"], like["vertex"], like["amplitude"], apart(f, like),
                "" if is_found else ": another one"))
            assert is_found or rank >= 3, "one of the three strongest has no like"
    print("%d of %d features of either hand have their like on the other" % (found, len(a) + len(b)))
    assert len(a) > 3 and len(b) > 3 and found >= 0.5 * (len(a) + len(b))


globals()[sys.argv[1]](*sys.argv[2:])
