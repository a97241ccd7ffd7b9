#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_files.py ADDON.py FEATURES.json FIELD.npy

What the add-on for Blender makes of files and numbers, without Blender: its modules are stood in for.
"""

import importlib.util
import json
import math
import os
import sys
import tempfile
import types

import numpy as np

checks = 0


def check(condition, what):
    global checks
    checks += 1
    if not condition:
        sys.exit("failed: " + what)


def module(name, **members):
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(members)
    return sys.modules[name]


class Nothing:
    """Whatever classes of Blender are derived from."""


module("bpy", types=types.SimpleNamespace(Operator=Nothing))
module("bpy.app")
module("bpy.app.handlers", persistent=lambda f: f)
module("bpy.props", BoolProperty=lambda **_: None, StringProperty=lambda **_: None)
module("bpy_extras")
module("bpy_extras.io_utils", ImportHelper=type("ImportHelper", (), {}))

addon_path, features_path, field_path = sys.argv[1:]
spec = importlib.util.spec_from_file_location("addon", addon_path)
addon = importlib.util.module_from_spec(spec)
spec.loader.exec_module(addon)

data = addon.read_features(features_path)
text = open(features_path, encoding="utf-8").read()
check(data == json.loads(text), "the file is read as it is")
features = data["features"]


def refused(change, message):
    """The file with a change is refused with a message."""
    changed = json.loads(text)
    changed = change(changed) or changed
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "x.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(changed if isinstance(changed, str) else json.dumps(changed))
        try:
            addon.read_features(path)
        except addon.FileError as error:
            check(message in str(error), "%s: %s" % (message, error))
        else:
            check(False, "refused: " + message)


refused(lambda d: "[", "x.json: Expecting value")
refused(lambda d: "[]", "is no file of features")
refused(lambda d: d.update(format="other"), "is no file of features")
refused(lambda d: d.update(version=2), "version 2")
refused(lambda d: d.pop("features") and None, "features is missing")
refused(lambda d: d["animation"].update(frame_duration="x"), "animation.frame_duration")
refused(lambda d: d["features"][1].pop("sigma") and None, "features[1].sigma is no finite number")
refused(lambda d: d["features"][1].update(tau=float("nan")), "features[1].tau")
refused(lambda d: d["features"][0].update(position=[0, 1]), "features[0].position is not three numbers")
refused(lambda d: d["features"][0].update(triangle=[0, 1, d["animation"]["vertices"]]), "there is no vertex %d" % data["animation"]["vertices"])

# times: 2 taus before and after, in frames of the scene; at least the one of its time
for time, tau, rate, first, expected in ((1, 0.25, 24, 1, (13, 38)), (0.5, 0.1, 30, 1, (10, 23)), (0, 0.1, 10, 0, (-2, 3)), (0.51, 0.001, 10, 1, (6, 7))):
    check(addon.life({"time": time, "tau": tau}, rate, first) == expected, "a life of %s" % (addon.life({"time": time, "tau": tau}, rate, first),))
check(addon.relative_durations([{"tau": 1}, {"tau": 4}, {"tau": 2}]) == [0, 1, 0.5], "durations by ratio")
check(addon.relative_durations([{"tau": 3}]) == [0.5], "one duration")
table = addon.colour_table("ff0000 000080")
check(table[0] == (1, 0, 0) and abs(table[1][2] - 0.2158605) < 1e-6, "colours in linear light")
check(addon.colour_at(table, 0.5) == (0.5, 0, table[1][2] / 2) and addon.colour_at(table, 7) == table[1], "between colours, and beyond")
for feature in features:
    p = addon.mixed_point(np.eye(3), feature["barycentric_coordinates"])
    check(np.allclose(p, feature["barycentric_coordinates"]), "barycentric coordinates")

# fields
field = addon.read_npy(field_path)
check(len(field) == data["animation"]["vertices"], "a row for each vertex")
check(np.array_equal(addon.field_at(field, 3.0), field[:, 3]), "the values of a frame")
check(np.allclose(addon.field_at(field, 3.25), 0.75 * field[:, 3] + 0.25 * field[:, 4]), "between frames")
check(np.array_equal(addon.field_at(field, 1e9), field[:, -1]) and np.array_equal(addon.field_at(field, -1), field[:, 0]), "at the ends")
top = addon.top_of_field(field)
share = np.mean(np.asarray(field) <= top)
check(0.98 <= share <= 1, "the top of the colours: above %g of the values" % share)
colours = addon.field_colours(field, top, 5.0)
check(colours.shape == (len(field), 4) and np.all(colours[:, 3] == 1), "four numbers a vertex")
luminance = (colours[:, :3] @ (0.2126, 0.7152, 0.0722))[np.argsort(field[:, 5])]
check(np.all(np.diff(luminance) <= 1e-6), "the more deformed, the darker")
with tempfile.TemporaryDirectory() as folder:
    for name, values, message in (("a.npy", np.zeros(3), "vertices times frames"), ("b.npy", np.zeros((2, 2), int), "vertices times frames"),
                                  ("c.npy", None, "c.npy")):
        path = os.path.join(folder, name)
        if values is None:
            open(path, "wb").write(b"nothing")
        else:
            np.save(path, values)
        try:
            addon.read_npy(path)
        except addon.FileError as error:
            check(message in str(error), "%s: %s" % (message, error))
        else:
            check(False, "%s is refused" % name)

# the sphere: closed, of radius 1, and its faces look outward
made = {}


class Mesh:
    def __init__(self):
        self.polygons = types.SimpleNamespace(foreach_set=lambda *_: None, __len__=lambda: 0)
        self.polygons = type("P", (), {"foreach_set": lambda *_: None, "__len__": lambda s: 0})()

    def from_pydata(self, points, edges, faces):
        made.update(points=np.array(points), faces=faces)

    def update(self):
        pass


addon.bpy.data = types.SimpleNamespace(meshes=types.SimpleNamespace(new=lambda name: Mesh()))
addon.sphere_mesh("Feature")
points = made["points"]
check(np.allclose(np.linalg.norm(points, axis=1), 1), "the radius of the sphere")
edges = {}
for face in made["faces"]:
    a, b, c = points[list(face[:3])]
    check(np.dot(np.cross(b - a, c - a), a + b + c) > 0, "a face looks outward")
    for v, w in zip(face, face[1:] + face[:1]):
        edges[v, w] = edges.get((v, w), 0) + 1
check(all(count == 1 and (w, v) in edges for (v, w), count in edges.items()), "the sphere is closed")
check(len(points) - len(edges) // 2 + len(made["faces"]) == 2, "the sphere is a sphere")

print("the add-on without Blender: %d checks, all as expected" % checks)
