#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_gltf.py DUMP [FILE CLIP FRAMES VERTICES]...

Without files: makes small glTF files, one for each thing that the format can do, and compares what is read with what
geometry says. With files: compares FRAMES frames of a clip with the evaluation in reference.py, and the number of vertices
after welding. In either case each vertex of the file is compared in each frame, to 1e-6 of the diagonal.

DUMP is the test program that writes what the package reads.
"""

import base64
import json
import math
import os
import struct
import subprocess
import sys

import reference

TOLERANCE = 1e-6
checks = 0


def check(condition, what):
    global checks
    checks += 1
    if not condition:
        sys.exit("failed: " + what)


class Animation:
    """What the package makes of a file: the times, the position of each vertex of the file in each frame, the vertices."""

    def __init__(self, dump, path, clip, frames):
        subprocess.run([dump, "dump", path, clip, str(frames), "dumped"], check=True)
        data = open("dumped.bin", "rb").read()
        count, vertices, triangles = struct.unpack_from("<QQQ", data)
        self.triangles = list(struct.iter_unpack("<3Q", data[24:24 + 24 * triangles]))
        numbers = struct.unpack_from("<%dd" % (count * (1 + 3 * vertices)), data, 24 + 24 * triangles)
        self.times = numbers[:count]
        self.vertices = vertices
        frames = [numbers[count + 3 * vertices * f:count + 3 * vertices * (f + 1)] for f in range(count)]
        self.map = {}
        for line in open("dumped.csv").read().split()[1:]:
            in_file, _, _, vertex = map(int, line.split(","))
            self.map.setdefault(in_file, []).append(vertex)
        self.frames = [{i: [f[3 * v:3 * v + 3] for v in vs] for i, vs in self.map.items()} for f in frames]


def diagonal(frames):
    points = [p for f in frames for p in f]
    return math.dist([min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)])


def compare(name, animation, expected):
    """expected: for each frame the positions of all vertices of the file. Returns the largest error, in diagonals."""
    size = diagonal(expected)
    worst = 0
    for found, right in zip(animation.frames, expected):
        for i, places in found.items():
            for p in places:
                worst = max(worst, math.dist(p, right[i]) / size)
    check(worst <= TOLERANCE, "%s: off by %g of the diagonal" % (name, worst))
    # What was welded coincides; what was not and coincides nevertheless is left to the checks of single files.
    together = {}
    for i, vs in animation.map.items():
        for v in vs:
            together.setdefault(v, []).append(i)
    for members in together.values():
        for f in expected:
            check(all(math.dist(f[members[0]], f[i]) <= TOLERANCE * size for i in members), name + ": welded apart")
    return worst


# ------------------------------------------------------------------------------------------------------ making files

FLOAT, UBYTE, SHORT, USHORT, UINT, BYTE = 5126, 5121, 5122, 5123, 5125, 5120


class Maker:
    def __init__(self):
        self.data = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [], "meshes": [],
                     "accessors": [], "bufferViews": [], "animations": []}

    def view(self, data, **more):
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["bufferViews"].append(dict(buffer=0, byteOffset=len(self.data), byteLength=len(data), **more))
        self.data += data
        return len(self.json["bufferViews"]) - 1

    def pack(self, values, component, padding=0):
        letter = reference.COMPONENTS[component][0]
        return b"".join(struct.pack("<%d%s" % (len(v), letter), *v) + b"\xee" * padding for v in values)

    def array(self, values, kind, component=FLOAT, padding=0, **more):
        values = [v if isinstance(v, (list, tuple)) else [v] for v in values]
        view = {"byteStride": struct.calcsize("<%d%s" % (reference.WIDTHS[kind], reference.COMPONENTS[component][0])) +
                padding} if padding else {}
        accessor = dict(bufferView=self.view(self.pack(values, component, padding), **view), componentType=component,
                        count=len(values), type=kind, **more)
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def sparse(self, count, where, what, kind, base=None, component=USHORT):
        accessor = dict(componentType=FLOAT, count=count, type=kind)
        if base is not None:
            accessor["bufferView"] = self.view(self.pack(base, FLOAT))
        accessor["sparse"] = dict(count=len(where), indices=dict(
            bufferView=self.view(self.pack([[i] for i in where], component)), componentType=component),
            values=dict(bufferView=self.view(self.pack(what, FLOAT))))
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def mesh(self, *primitives, **more):
        self.json["meshes"].append(dict(primitives=list(primitives), **more))
        return len(self.json["meshes"]) - 1

    def node(self, **node):
        self.json["nodes"].append(node)
        return len(self.json["nodes"]) - 1

    def clip(self, name, *channels):
        """channels: node, path, interpolation, times, values (an accessor or floats)."""
        kinds = {"translation": "VEC3", "scale": "VEC3", "rotation": "VEC4", "weights": "SCALAR"}
        animation = dict(name=name, channels=[], samplers=[])
        for node, path, interpolation, times, values in channels:
            output = values if isinstance(values, int) else self.array(values, kinds[path])
            animation["channels"].append(dict(sampler=len(animation["samplers"]), target=dict(node=node, path=path)))
            animation["samplers"].append(dict(input=self.array(times, "SCALAR", min=[min(times)], max=[max(times)]),
                                              output=output, interpolation=interpolation))
        self.json["animations"].append(animation)

    def write(self, path, uri=None):
        """uri: None for a .glb, "data" for base64, else the name of a file beside it."""
        if uri is None:
            self.json["buffers"] = [dict(byteLength=len(self.data))]
        elif uri == "data":
            self.json["buffers"] = [dict(byteLength=len(self.data), uri="data:application/octet-stream;base64," +
                                         base64.b64encode(self.data).decode())]
        else:
            self.json["buffers"] = [dict(byteLength=len(self.data), uri=uri.replace(" ", "%20"))]
            open(os.path.join(os.path.dirname(path), uri), "wb").write(self.data)
        text = json.dumps(self.json).encode()
        if uri is not None:
            open(path, "wb").write(text)
            return
        text += b" " * (-len(text) % 4)
        data = self.data + b"\0" * (-len(self.data) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(data), 0x004E4942) + data
        open(path, "wb").write(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


# A tetrahedron.
POINTS = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]]
TRIANGLES = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]


def tetrahedron(m, component=USHORT, **attributes):
    return dict(attributes=dict(POSITION=m.array(POINTS, "VEC3"), **attributes),
                indices=m.array(TRIANGLES, "SCALAR", component))


def turned(p, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]]


def plus(p, q):
    return [a + b for a, b in zip(p, q)]


def about_z(angle):
    return [0, 0, math.sin(angle / 2), math.cos(angle / 2)]


def simple(*channels):
    m = Maker()
    m.node(mesh=m.mesh(tetrahedron(m)))
    m.clip("move", *channels)
    return m


def cubic(x):
    return x**3 - 2 * x


def spline_of_cubic(times):
    return [v for t in times for x in (3 * t * t - 2, cubic(t), 3 * t * t - 2) for v in [[x, 0, 2 * x]]]


def cases():
    """name, maker, FRAMES, position(point, time) of the vertices POINTS, or of `points`; more."""
    times = [0, 0.5, 2]
    linear = [[0, 0, 0], [1, 2, 0], [4, 2, 0]]

    def at_linear(t):
        return [2 * t, 4 * t, 0] if t < 0.5 else [1 + 2 * (t - 0.5), 2, 0]

    yield "linear", simple((0, "translation", "LINEAR", times, linear)), 9, lambda p, t: plus(p, at_linear(t))
    yield ("step", simple((0, "translation", "STEP", times, linear)), 9,
           lambda p, t: plus(p, linear[0 if t < 0.5 else 1 if t < 2 else 2]))
    yield ("spline", simple((0, "translation", "CUBICSPLINE", [0, 1, 2.5], spline_of_cubic([0, 1, 2.5]))), 16,
           lambda p, t: plus(p, [cubic(t), 0, 2 * cubic(t)]))
    # Hermite splines of the components of a quaternion, normalised: here it passes through (0, 0, u, 1 - u).
    flat = [[0] * 4, about_z(0), [0, 0, 1, -1], [0, 0, 1, -1], [0, 0, 1, 0], [0] * 4]
    yield ("spline of rotations", simple((0, "rotation", "CUBICSPLINE", [0, 1], flat)), 11,
           lambda p, t: turned(p, 2 * math.atan2(t, 1 - t)))
    slerp = [about_z(0), about_z(2.8), about_z(2.8 - 1e-5)]
    yield ("slerp", simple((0, "rotation", "LINEAR", [0, 1, 2], slerp)), 21,
           lambda p, t: turned(p, 2.8 * t if t < 1 else 2.8 - 1e-5 * (t - 1)))
    far = [about_z(0), [-x for x in about_z(1.5)]]
    yield "shorter arc", simple((0, "rotation", "LINEAR", [0, 1], far)), 11, lambda p, t: turned(p, 1.5 * t)
    yield ("step of rotations", simple((0, "rotation", "STEP", [0, 1], far)), 5,
           lambda p, t: turned(p, 1.5 if t >= 1 else 0))
    # 1/sqrt(2) in 15 bits and a sign is 23170/32767; its normalised rotation is by a right angle exactly
    m = Maker()
    m.node(mesh=m.mesh(tetrahedron(m)))
    m.clip("move", (0, "rotation", "LINEAR", [0, 1], m.array([[0, 0, 0, 32767], [0, 0, 23170, 23170]], "VEC4", SHORT,
                                                             normalized=True)))
    yield "rotations in 16 bits", m, 11, lambda p, t: turned(p, math.pi / 2 * t)
    m = Maker()
    m.node(mesh=m.mesh(tetrahedron(m)))
    m.clip("move", (0, "rotation", "LINEAR", [0, 1], m.array([[0, 0, 0, 127], [0, 0, -128, 0]], "VEC4", BYTE,
                                                             normalized=True)))
    yield "rotations in 8 bits", m, 11, lambda p, t: turned(p, -math.pi * t)
    yield ("scale", simple((0, "scale", "LINEAR", [0, 1], [[1, 1, 1], [3, 0.5, 1]])), 6,
           lambda p, t: [p[0] * (1 + 2 * t), p[1] * (1 - 0.5 * t), p[2]])
    # keys that neither start at 0 nor end together
    yield ("constant beyond the keys", simple((0, "translation", "LINEAR", [1, 2], [[0, 0, 0], [1, 0, 0]]),
                                              (0, "scale", "LINEAR", [0.5, 3], [[1, 1, 1], [6, 1, 1]])), 11,
           lambda p, t: [p[0] * (1 + 2 * t) + min(max(t - 0.5, 0), 1), p[1], p[2]])

    # A tree: a parent with a matrix, which turns; its child moves; another scene, and a node outside of both.
    m = Maker()
    m.node(children=[1], matrix=[0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1])
    m.node(mesh=m.mesh(tetrahedron(m)), translation=[1, 0, 0], rotation=about_z(math.pi / 2), scale=[1, 1, 3])
    m.node(mesh=0, translation=[100, 0, 0])
    m.json["scenes"] = [{"nodes": [2]}, {"nodes": [0]}]
    m.json["scene"] = 1
    m.clip("move", (1, "translation", "LINEAR", [0, 1], [[1, 0, 0], [1, 4, 0]]))

    def in_tree(p, t):
        q = plus(turned([p[0], p[1], 3 * p[2]], math.pi / 2), [1, 4 * t, 0])
        return plus([2 * x for x in turned(q, math.pi / 2)], [5, 6, 7])

    yield "tree", m, 5, in_tree

    # Morph targets: dense, sparse without a base, without positions; weights of mesh and node, all interpolations.
    def morphing(interpolation, values, keys, **node):
        m = Maker()
        primitive = tetrahedron(m)
        primitive["targets"] = [dict(POSITION=m.array([[1, 0, 0]] * 4, "VEC3")),
                                dict(POSITION=m.sparse(4, [1, 3], [[0, 1, 0], [0, 2, 0]], "VEC3")),
                                dict(NORMAL=m.array([[9, 9, 9]] * 4, "VEC3"))]
        m.node(mesh=m.mesh(primitive, weights=[0.5, 0.25, 1]), **node)
        m.node(mesh=0, translation=[20, 0, 0], weights=[1, 1, 0])
        m.json["scenes"][0]["nodes"] = [0, 1]
        m.clip("move", (0, "weights", interpolation, keys, values), (1, "scale", "STEP", [0], [[1, 1, 1]]))
        return m

    def morphed(i, a, b):
        return plus(POINTS[i], [a, [0, b, 0, 2 * b][i], 0])

    second = [plus(morphed(i, 1, 1), [20, 0, 0]) for i in range(4)]
    yield ("morph", morphing("LINEAR", [0, 1, 5, 1, 0, 5], [0, 2]), 5,
           lambda t: [morphed(i, t / 2, 1 - t / 2) for i in range(4)] + second)
    yield ("morph in steps", morphing("STEP", [0, 1, 5, 1, 0, 5], [0, 2]), 5,
           lambda t: [morphed(i, 1 if t >= 2 else 0, 0 if t >= 2 else 1) for i in range(4)] + second)
    spline = [x for t in (0, 1, 2) for v in (3 * t * t - 2, cubic(t), 3 * t * t - 2) for x in (v, -v, 0)]
    yield ("morph by spline", morphing("CUBICSPLINE", spline, [0, 1, 2]), 9,
           lambda t: [morphed(i, cubic(t), -cubic(t)) for i in range(4)] + second)
    m = morphing("LINEAR", [0, 0, 0], [0])
    m.json["animations"][0]["channels"] = []
    m.json["animations"][0]["samplers"] = []
    m.clip("other", (0, "translation", "LINEAR", [0, 1], [[0, 0, 0], [1, 0, 0]]))
    yield ("other#weights at rest", m, 3,
           lambda t: [plus(morphed(i, 0.5, 0.25), [t, 0, 0]) for i in range(4)] + second)

    # A skin with morph targets: the node's own place is no part; two sets of joints; a joint outside of the scene's root.
    def skinned(component, largest):
        m = Maker()
        normal = {"normalized": True} if component != FLOAT else {}
        weights = [[1, 0, 0, 0], [0.6, 0.4, 0, 0], [0.2, 0.4, 0, 0], [0, 1, 0, 0]]
        more = [[0, 0, 0, 0], [0, 0, 0, 0], [0.4, 0, 0, 0], [0, 0, 0, 0]]
        scaled = [[[round(x * largest) if largest > 1 else x for x in w] for w in ws] for ws in (weights, more)]
        primitive = tetrahedron(m, UINT, JOINTS_0=m.array([[1, 0, 0, 0]] * 4, "VEC4", UBYTE),
                                WEIGHTS_0=m.array(scaled[0], "VEC4", component, **normal),
                                JOINTS_1=m.array([[1, 0, 0, 0]] * 4, "VEC4", USHORT),
                                WEIGHTS_1=m.array(scaled[1], "VEC4", component, **normal))
        primitive["targets"] = [dict(POSITION=m.array([[0, 0, 1]] * 4, "VEC3", padding=4))]
        m.node(mesh=m.mesh(primitive), skin=0, translation=[50, 60, 70], scale=[7, 7, 7])
        m.node(children=[2], rotation=about_z(math.pi / 2))
        m.node(translation=[0, 1, 0])
        m.json["scenes"][0]["nodes"] = [0, 1]
        # the child's inverse bind matrix takes (0, 1, 0) away again
        binds = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]]
        m.json["skins"] = [dict(joints=[2, 1], inverseBindMatrices=m.array(binds, "MAT4"))]
        m.clip("bend", (2, "rotation", "LINEAR", [0, 1], [about_z(0), about_z(1)]),
               (0, "weights", "LINEAR", [0, 1], [0, 1]), (0, "translation", "LINEAR", [0, 1], [[0, 0, 0], [9, 9, 9]]))
        return m

    def bent(t):
        result = []
        for p, w in zip(POINTS, (0, 0.4, 0.4, 1)):
            q = plus(p, [0, 0, t])
            moved = plus(turned(plus(q, [0, -1, 0]), t), [0, 1, 0])
            result.append(turned([(1 - w) * a + w * b for a, b in zip(q, moved)], math.pi / 2))
        return result

    yield "skin and morph", skinned(FLOAT, 1), 6, bent
    yield "skin and morph, weights in 8 bits", skinned(UBYTE, 255), 6, bent
    yield "skin and morph, weights in 16 bits", skinned(USHORT, 65535), 6, bent

    # The same accessor for two primitives, sparse with a base; a strip, a fan, corners without indices, lines.
    m = Maker()
    grid = [[x, y, 0] for y in range(2) for x in range(4)]
    shifted = [[x, y + 5, 0] for y in range(2) for x in range(4)]
    position = m.sparse(8, [0, 7], [[0, 5, 0], [3, 6, 0]], "VEC3", [[9, 9, 9]] + shifted[1:7] + [[9, 9, 9]], UINT)
    strip = [0, 4, 1, 5, 5, 2, 2, 6, 3, 7]  # two strips, tied by triangles without area
    m.node(mesh=m.mesh(dict(attributes=dict(POSITION=m.array(grid, "VEC3")), mode=5,
                            indices=m.array([0, 4, 1, 5, 2, 6, 3, 7], "SCALAR", UBYTE)),
                       dict(attributes=dict(POSITION=position), mode=6,
                            indices=m.array([0, 1, 2, 3, 7, 6, 5, 4], "SCALAR", UINT)),
                       dict(attributes=dict(POSITION=m.array([[x, y + 10, z] for x, y, z in
                                                              (grid[i] for i in (0, 1, 4, 1, 5, 4))], "VEC3"))),
                       dict(attributes=dict(POSITION=m.array(grid, "VEC3")), mode=1),
                       dict(attributes=dict(POSITION=m.array([[x, y + 20, z] for x, y, z in grid], "VEC3")), mode=5,
                            indices=m.array(strip, "SCALAR", UBYTE))))
    m.clip("move", (0, "translation", "LINEAR", [0, 1], [[0, 0, 0], [0, 0, 1]]))
    pieces = grid + shifted + [plus(grid[i], [0, 10, 0]) for i in (0, 1, 4, 1, 5, 4)] + [plus(p, [0, 20, 0]) for p in grid]
    yield ("modes", m, 3, lambda t: [plus(p, [0, 0, t]) for p in pieces],
           dict(triangles=6 + 6 + 2 + 4, vertices=8 + 8 + 4 + 8))

    # One mesh at two nodes, of which one mirrors: its triangles are turned round.
    m = Maker()
    m.node(mesh=m.mesh(tetrahedron(m)))
    m.node(mesh=0, scale=[-1, 1, 1], translation=[-1, 0, 0])
    m.json["scenes"][0]["nodes"] = [0, 1]
    m.clip("move", (0, "translation", "LINEAR", [0, 1], [[0, 0, 0], [1, 0, 0]]))
    yield ("mirrored instance", m, 3,
           lambda t: [plus(p, [t, 0, 0]) for p in POINTS] + [[-1 - p[0], p[1], p[2]] for p in POINTS],
           dict(vertices=8, outward=True))

    # Split at a seam: a square of two triangles, of which the diagonal is split; the second one moves away or not.
    def seam(moves):
        m = Maker()
        points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [7, 7, 7]]
        primitive = dict(attributes=dict(POSITION=m.array(points, "VEC3", padding=8)),
                         indices=m.array([0, 1, 2, 3, 4, 5], "SCALAR", UBYTE),
                         targets=[dict(POSITION=m.array([[0, 0, i in moves] for i in range(7)], "VEC3"))])
        m.node(mesh=m.mesh(primitive))
        m.clip("move", (0, "weights", "LINEAR", [0, 1, 2], [0, 0, 1]))
        return m, lambda t: [plus(p, [0, 0, max(t - 1, 0) * (i in moves)]) for i, p in enumerate(points)]

    m, f = seam([1, 3])
    yield "seam", m, 7, f, dict(vertices=4, map={0: 0, 1: 1, 3: 1, 2: 2, 5: 2, 4: 3})
    m, f = seam([3])
    yield "seam that opens at one end in the last frame", m, 7, f, dict(vertices=6)
    m, f = seam([4])
    yield "seam that does not move", m, 7, f, dict(vertices=4)

    # Three sheets at one edge, two of them in one piece in the file: the third stays apart.
    m = Maker()
    points = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [-1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 0, 1]]
    m.node(mesh=m.mesh(dict(attributes=dict(POSITION=m.array(points, "VEC3")),
                            indices=m.array([0, 2, 1, 0, 1, 3, 4, 5, 6], "SCALAR", UBYTE))))
    m.clip("move", (0, "translation", "LINEAR", [0, 1], [[0, 0, 0], [0, 0, 1]]))
    yield "three sheets at an edge", m, 3, lambda t: [plus(p, [0, 0, t]) for p in points], dict(vertices=7)


def outward(animation):
    """whether the volume inside of every closed part is positive, in the first frame"""
    place = {v: animation.frames[0][i][k] for i, vs in animation.map.items() for k, v in enumerate(vs)}
    volumes = []
    for t in range(0, len(animation.triangles), 4):
        volume = 0
        for a, b, c in animation.triangles[t:t + 4]:
            a, b, c = place[a], place[b], place[c]
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        volumes.append(volume)
    return all(abs(v - 1) < 1e-9 for v in volumes)


def made_files(dump):
    number = 0
    for name, maker, frames, position, *more in cases():
        more = more[0] if more else {}
        clip = name.split("#")[0] if "#" in name else maker.json["animations"][0]["name"]
        uri = (None, "data", "the data.bin")[number % 3]
        path = "case." + ("glb" if uri is None else "gltf")
        maker.write(path, uri)
        number += 1
        animation = Animation(dump, path, clip, frames)
        check(len(animation.times) == frames, name + ": number of frames")
        if position.__code__.co_argcount == 2:
            expected = [[position(p, t) for p in POINTS] for t in animation.times]
        else:
            expected = [position(t) for t in animation.times]
        worst = compare(name, animation, expected)
        # the reference agrees, too: what it says about real files counts
        file = reference.File(path)
        index = [a["name"] for a in maker.json["animations"]].index(clip)
        start = file.clip_range(index)[0]
        for t, right in zip(animation.times, expected):
            for p, q in zip(file.positions(index, start + t), right):
                check(math.dist(p, q) < 1e-5, name + ": the reference")
        if "vertices" in more:
            check(animation.vertices == more["vertices"], "%s: %d vertices" % (name, animation.vertices))
        if "triangles" in more:
            check(len(animation.triangles) == more["triangles"], "%s: %d triangles" % (name, len(animation.triangles)))
        if "map" in more:
            check({i: v[0] for i, v in animation.map.items()} == more["map"], name + ": the map of vertices")
        if "outward" in more:
            check(outward(animation), name + ": triangles turned inside")
        print("%-45s %.1e of the diagonal" % (name, worst))


def real_file(dump, path, clip, frames, vertices):
    animation = Animation(dump, path, clip, frames)
    file = reference.File(path)
    names = [a.get("name", "") for a in file.json["animations"]]
    index = names.index(clip)
    first, last = file.clip_range(index)
    expected = [file.positions(index, first + (last - first) * f / (frames - 1)) for f in range(frames)]
    worst = compare(path, animation, expected)
    check(animation.vertices == vertices, "%s: %d vertices after welding" % (path, animation.vertices))
    # nothing that coincides in all frames is left apart: these surfaces are closed
    places = {tuple(tuple(round(x, 9) for x in f[i]) for f in expected) for i in animation.map}
    check(len(places) == vertices, "%s: %d different places" % (path, len(places)))
    edges = {}
    for t in animation.triangles:
        for i in range(3):
            edge = t[i], t[(i + 1) % 3]
            check(edge not in edges, path + ": an edge twice in the same direction")
            edges[edge] = True
    check(all((b, a) in edges for a, b in edges), path + ": has a border")
    print("%s, %s: %d vertices, %d frames, %.1e of the diagonal" % (os.path.basename(path), clip, vertices, frames, worst))


if __name__ == "__main__":
    if len(sys.argv) == 2:
        made_files(sys.argv[1])
    for i in range(2, len(sys.argv), 4):
        real_file(sys.argv[1], sys.argv[i], sys.argv[i + 1], int(sys.argv[i + 2]), int(sys.argv[i + 3]))
    print("%d checks" % checks)
