#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_assimp.py DUMP [FILE FRAMES]...

What is read through assimp. Without files: Collada files that are made here, of a box whose node moves and of a skinned
column that bends, against what geometry says; this covers all of the way, assimp's reading, too. With files: FRAMES
frames of the first clip against an evaluation of assimp's own dump of the file as JSON, by the code below; this covers
nodes, keys and skins, but not whether assimp has understood the file.

DUMP is the test program that writes what the package reads.
"""

import ctypes
import ctypes.util
import json
import math
import sys

import check_gltf
from check_gltf import Animation, compare
from reference import apply, matrix, multiply, unit

# assimp computes in single precision, and its JSON has six digits.
check_gltf.TOLERANCE = 2e-5


# ------------------------------------------------------------------------------------------------------ Collada files

def numbers(values):
    return " ".join("%.9g" % x for x in values)


def source(name, values, params):
    """params: names and types of what an element consists of"""
    width = sum(16 if kind == "float4x4" else 1 for _, kind in params)
    of_names = params[0][1] in ("name", "Name")
    text = " ".join(values) if of_names else numbers(values)
    array = "Name_array" if of_names else "float_array"
    return ('<source id="%s"><%s id="%s-array" count="%d">%s</%s><technique_common>'
            '<accessor source="#%s-array" count="%d" stride="%d">%s</accessor></technique_common></source>' % (
                name, array, name, len(values), text, array, name, len(values) // width, width,
                "".join('<param name="%s" type="%s"/>' % p for p in params)))


XYZ = [("X", "float"), ("Y", "float"), ("Z", "float")]


def geometry(points, triangles):
    return ('<library_geometries><geometry id="shape"><mesh>%s'
            '<vertices id="shape-vertices"><input semantic="POSITION" source="#shape-points"/></vertices>'
            '<triangles count="%d"><input semantic="VERTEX" source="#shape-vertices" offset="0"/><p>%s</p></triangles>'
            '</mesh></geometry></library_geometries>' % (
                source("shape-points", [x for p in points for x in p], XYZ), len(triangles),
                " ".join("%d" % v for t in triangles for v in t)))


def curve(target, times, values):
    name = target.replace("/", "-").replace(".", "-")
    return ('<animation id="%s">%s%s%s<sampler id="%s-sampler"><input semantic="INPUT" source="#%s-in"/>'
            '<input semantic="OUTPUT" source="#%s-out"/><input semantic="INTERPOLATION" source="#%s-how"/></sampler>'
            '<channel source="#%s-sampler" target="%s"/></animation>' % (
                name, source(name + "-in", times, [("TIME", "float")]),
                source(name + "-out", values, [("VALUE", "float")]),
                source(name + "-how", ["LINEAR"] * len(times), [("INTERPOLATION", "name")]), name, name, name, name, name,
                target))


def collada(libraries, nodes):
    return ('<?xml version="1.0" encoding="utf-8"?>'
            '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
            '<asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset>%s'
            '<library_visual_scenes><visual_scene id="scene">%s</visual_scene></library_visual_scenes>'
            '<scene><instance_visual_scene url="#scene"/></scene></COLLADA>' % (libraries, nodes))


def box(levels):
    """A closed box of 1 x levels x 1 with its base at y = 0: points and triangles that look outward."""
    points = [[x, y, z] for y in range(levels + 1) for x, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
    triangles = [[0, 1, 2], [0, 2, 3]]
    for y in range(levels):
        for i in range(4):
            a, b = 4 * y + i, 4 * y + (i + 1) % 4
            triangles += [[a, a + 4, b + 4], [a, b + 4, b]]
    top = 4 * levels
    return points, triangles + [[top, top + 2, top + 1], [top, top + 3, top + 2]]


def linear(times, values, t):
    for i in range(len(times) - 1):
        if t <= times[i + 1] or i == len(times) - 2:
            u = min(max((t - times[i]) / (times[i + 1] - times[i]), 0), 1)
            return values[i] + u * (values[i + 1] - values[i])


def about(axis, degrees):
    s = math.sin(math.radians(degrees) / 2)
    return matrix([0, 0, 0], [s * (axis == k) for k in range(3)] + [math.cos(math.radians(degrees) / 2)], [1, 1, 1])


def moved(x, y, z):
    return matrix([x, y, z], [0, 0, 0, 1], [1, 1, 1])


def product(*matrices):
    result = matrices[0]
    for m in matrices[1:]:
        result = multiply(result, m)
    return result


def moving_box():
    """A box that slides along x and turns about z at a changing rate, below a node that is turned, scaled and moved."""
    points, triangles = box(1)
    times, turns, slide_times, slides = [0, 1, 2], [10, 60, 180], [0, 2], [0, 3]
    animations = curve("box/turn.ANGLE", times, turns) + curve("box/slide.X", slide_times, slides)
    text = collada(
        geometry(points, triangles) + "<library_animations>%s</library_animations>" % animations,
        '<node id="above" name="above"><translate>1 2 3</translate><rotate>1 0 0 30</rotate><scale>2 2 2</scale>'
        '<node id="box" name="box"><translate sid="slide">0 0.5 0</translate><rotate sid="turn">0 0 1 10</rotate>'
        '<instance_geometry url="#shape"/></node></node>')
    above = product(moved(1, 2, 3), about(0, 30), matrix([0, 0, 0], [0, 0, 0, 1], [2, 2, 2]))

    def at(t):
        m = product(above, moved(linear(slide_times, slides, t), 0.5, 0), about(2, linear(times, turns, t)))
        return [apply(m, points[v]) for corners in triangles for v in corners]

    return text, 9, at, len(points)


def bending_column():
    """A column of two bones, of which the upper one bends, with weights that pass over evenly; the mesh was moved when it
    was bound (bind_shape_matrix), and its skeleton stands on a node that rises."""
    levels = 4
    points, triangles = box(levels)
    times, turns, rise_times, rises = [0, 0.5, 2], [0, 40, -70], [0, 1], [0, 2]
    share = [min(max((p[1] - 1) / 2, 0), 1) for p in points]  # of the upper bone
    bind_shape = moved(0.25, 0, 0)
    inverse_binds = [moved(0, 0, 0), moved(0, -2, 0)]
    matrices = [x for m in inverse_binds for row in m for x in row]
    skin = ('<library_controllers><controller id="skin"><skin source="#shape"><bind_shape_matrix>%s</bind_shape_matrix>'
            '%s%s%s<joints><input semantic="JOINT" source="#skin-joints"/>'
            '<input semantic="INV_BIND_MATRIX" source="#skin-binds"/></joints>'
            '<vertex_weights count="%d"><input semantic="JOINT" source="#skin-joints" offset="0"/>'
            '<input semantic="WEIGHT" source="#skin-weights" offset="1"/><vcount>%s</vcount><v>%s</v></vertex_weights>'
            '</skin></controller></library_controllers>' % (
                numbers([x for row in bind_shape for x in row]),
                source("skin-joints", ["lower", "upper"], [("JOINT", "Name")]),
                source("skin-binds", matrices, [("TRANSFORM", "float4x4")]),
                source("skin-weights", [w for s in share for w in (1 - s, s)], [("WEIGHT", "float")]), len(points),
                " ".join(["2"] * len(points)), " ".join("0 %d 1 %d" % (2 * i, 2 * i + 1) for i in range(len(points)))))
    animations = curve("upper/turn.ANGLE", times, turns) + curve("base/rise.Y", rise_times, rises)
    text = collada(
        geometry(points, triangles) + skin + "<library_animations>%s</library_animations>" % animations,
        '<node id="base" name="base"><translate sid="rise">0 0 0</translate>'
        '<node id="lower" name="lower" sid="lower" type="JOINT">'
        '<node id="upper" name="upper" sid="upper" type="JOINT"><translate>0 2 0</translate>'
        '<rotate sid="turn">0 0 1 0</rotate></node></node></node>'
        '<node id="body" name="body"><instance_controller url="#skin"><skeleton>#lower</skeleton></instance_controller>'
        '</node>')

    def at(t):
        lower = moved(0, linear(rise_times, rises, t), 0)
        upper = product(lower, moved(0, 2, 0), about(2, linear(times, turns, t)))
        joints = [product(j, b, bind_shape) for j, b in zip((lower, upper), inverse_binds)]
        result = []
        for p, s in zip(points, share):
            places = [apply(j, p) for j in joints]
            result.append([(1 - s) * a + s * b for a, b in zip(*places)])
        return [result[v] for corners in triangles for v in corners]

    return text, 21, at, len(points)


def made_files(dump):
    for make in (moving_box, bending_column):
        text, frames, at, vertices = make()
        with open("case.dae", "w") as file:
            file.write(text)
        animation = Animation(dump, "case.dae", "0", frames)
        check_gltf.check(len(animation.times) == frames and abs(animation.times[-1] - 2) < 1e-6, "times of " + make.__name__)
        check_gltf.check(animation.vertices == vertices, "%s: %d vertices" % (make.__name__, animation.vertices))
        worst = compare(make.__name__, animation, [at(t) for t in animation.times])
        print("%-45s %.1e of the diagonal" % ("Collada, " + make.__name__.replace("_", " "), worst))


# --------------------------------------------------------------------------------------------- assimp's view of a file

def dumped_by_assimp(path):
    library = ctypes.CDLL(ctypes.util.find_library("assimp") or "libassimp.so.5")
    library.aiImportFile.restype = ctypes.c_void_p
    library.aiImportFile.argtypes = [ctypes.c_char_p, ctypes.c_uint]
    library.aiExportScene.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_uint]
    triangulate = 0x8
    scene = library.aiImportFile(path.encode(), triangulate)
    check_gltf.check(scene and library.aiExportScene(scene, b"assjson", b"scene.json", 0) == 0, "assimp's dump of " + path)
    with open("scene.json") as file:
        return json.load(file)


class Evaluation:
    """Where assimp's nodes, and what hangs on them, are at a time."""

    def __init__(self, scene):
        self.scene = scene
        self.animation = scene["animations"][0]
        self.ticks = self.animation["tickspersecond"] or 25
        self.channels = {c["name"]: c for c in self.animation["channels"]}
        keys = [k[0] for c in self.animation["channels"] for path in ("position", "rotation", "scaling")
                for k in c[path + "keys"]]
        self.first, self.last = min(keys) / self.ticks, max(keys) / self.ticks

    @staticmethod
    def between(keys, t, is_rotation=False):
        if t <= keys[0][0]:
            return keys[0][1]
        for (t_0, a), (t_1, b) in zip(keys, keys[1:]):
            if t > t_1:
                continue
            u = (t - t_0) / (t_1 - t_0)
            if not is_rotation:
                return [(1 - u) * x + u * y for x, y in zip(a, b)]
            a, b = unit(a), unit(b)
            dot = sum(x * y for x, y in zip(a, b))
            if dot < 0:
                b, dot = [-x for x in b], -dot
            angle = math.acos(min(1, dot))
            if angle < 1e-4:
                return [(1 - u) * x + u * y for x, y in zip(a, b)]
            return [(math.sin((1 - u) * angle) * x + math.sin(u * angle) * y) / math.sin(angle) for x, y in zip(a, b)]
        return keys[-1][1]

    def positions(self, seconds):
        t = seconds * self.ticks
        world = {}

        def visit(node, above):
            flat = node["transformation"]
            local = [flat[4 * i:4 * i + 4] for i in range(4)]
            channel = self.channels.get(node["name"])
            if channel:
                w, x, y, z = self.between(channel["rotationkeys"], t, True)
                local = matrix(self.between(channel["positionkeys"], t), [x, y, z, w],
                               self.between(channel["scalingkeys"], t))
            world[node["name"]] = multiply(above, local)
            for child in node.get("children", []):
                visit(child, world[node["name"]])

        root = self.scene["rootnode"]
        visit(root, matrix([0, 0, 0], [0, 0, 0, 1], [1, 1, 1]))
        result = []

        def draw(node):
            for index in node.get("meshes", []):
                mesh = self.scene["meshes"][index]
                v = mesh["vertices"]
                points = [v[i:i + 3] for i in range(0, len(v), 3)]
                if "bones" not in mesh:
                    result.extend(apply(world[node["name"]], p) for p in points)
                    continue
                sums, totals = [[0.0] * 3 for _ in points], [0.0] * len(points)
                for bone in mesh["bones"]:
                    o = bone["offsetmatrix"]
                    m = multiply(world[bone["name"]], [o[4 * i:4 * i + 4] for i in range(4)])
                    for i, weight in bone["weights"]:
                        q = apply(m, points[i])
                        sums[i] = [a + weight * b for a, b in zip(sums[i], q)]
                        totals[i] += weight
                result.extend([x / w for x in s] for s, w in zip(sums, totals))
            for child in node.get("children", []):
                draw(child)

        draw(root)
        return result


def real_file(dump, path, frames):
    animation = Animation(dump, path, "0", frames)
    evaluation = Evaluation(dumped_by_assimp(path))
    span = evaluation.last - evaluation.first
    check_gltf.check(abs(animation.times[-1] - span) < 1e-4, "%s lasts %g s, not %g s" % (path, span, animation.times[-1]))
    expected = [evaluation.positions(evaluation.first + span * f / (frames - 1)) for f in range(frames)]
    size = check_gltf.diagonal(expected)
    motion = max(math.dist(p, q) for f in expected for p, q in zip(expected[0], f)) / size
    check_gltf.check(motion > 0.02, "%s hardly moves" % path)
    worst = compare(path, animation, expected)
    print("%s: %d vertices, %d frames, moves by %.2f, off by %.1e of the diagonal" % (
        path.rsplit("/", 1)[-1], animation.vertices, frames, motion, worst))


if __name__ == "__main__":
    if len(sys.argv) == 2:
        made_files(sys.argv[1])
    for i in range(2, len(sys.argv), 2):
        real_file(sys.argv[1], sys.argv[i], int(sys.argv[i + 1]))
    print("%d checks" % check_gltf.checks)
