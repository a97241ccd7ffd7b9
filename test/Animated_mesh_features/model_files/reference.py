# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Where the vertices of a glTF 2.0 file are at a time, written from the formulas of the specification alone: it shares
neither code nor a library with the package. Slow and simple."""

import base64
import json
import math
import os
import struct
import urllib.parse

COMPONENTS = {5120: ("b", 127.0), 5121: ("B", 255.0), 5122: ("h", 32767.0), 5123: ("H", 65535.0), 5125: ("I", None),
              5126: ("f", None)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def apply(m, p):
    return [m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3] for i in range(3)]


def from_columns(c):
    return [[c[4 * j + i] for j in range(4)] for i in range(4)]


def unit(q):
    n = math.sqrt(sum(x * x for x in q))
    return [x / n for x in q]


def matrix(t, r, s):
    x, y, z, w = unit(r)
    rotation = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[rotation[i][j] * s[j] for j in range(3)] + [t[i]] for i in range(3)] + [[0, 0, 0, 1]]


class File:
    def __init__(self, path):
        data = open(path, "rb").read()
        binary = None
        if data[:4] == b"glTF":
            offset, chunks = 12, []
            while offset < len(data):
                length, kind = struct.unpack_from("<II", data, offset)
                chunks.append((kind, data[offset + 8:offset + 8 + length]))
                offset += 8 + length
            text = chunks[0][1]
            binary = next((c for k, c in chunks[1:] if k == 0x004E4942), None)
        else:
            text = data
        self.json = json.loads(text.decode("utf-8"))
        self.buffers = []
        for buffer in self.json.get("buffers", []):
            uri = buffer.get("uri")
            if uri is None:
                self.buffers.append(binary)
            elif uri.startswith("data:"):
                self.buffers.append(base64.b64decode(uri.split(",", 1)[1]))
            else:
                name = os.path.join(os.path.dirname(path), urllib.parse.unquote(uri))
                self.buffers.append(open(name, "rb").read())
        self.cache = {}

    def elements(self, view, offset, component, width, count, normalized):
        v = self.json["bufferViews"][view]
        letter, largest = COMPONENTS[component]
        size = struct.calcsize("<" + letter) * width
        stride = v.get("byteStride", size)
        start = v.get("byteOffset", 0) + offset
        result = []
        for i in range(count):
            e = struct.unpack_from("<%d%s" % (width, letter), self.buffers[v["buffer"]], start + i * stride)
            result.append([max(x / largest, -1.0) for x in e] if normalized else list(e))
        return result

    def accessor(self, index):
        if index in self.cache:
            return self.cache[index]
        a = self.json["accessors"][index]
        width, n = WIDTHS[a["type"]], a.get("normalized", False)
        if "bufferView" in a:
            e = self.elements(a["bufferView"], a.get("byteOffset", 0), a["componentType"], width, a["count"], n)
        else:
            e = [[0.0] * width for _ in range(a["count"])]
        if "sparse" in a:
            s = a["sparse"]
            where = self.elements(s["indices"]["bufferView"], s["indices"].get("byteOffset", 0),
                                  s["indices"]["componentType"], 1, s["count"], False)
            what = self.elements(s["values"]["bufferView"], s["values"].get("byteOffset", 0), a["componentType"], width,
                                 s["count"], n)
            for i, x in zip(where, what):
                e[i[0]] = x
        self.cache[index] = e
        return e

    def clip_range(self, clip):
        times = [t[0] for s in self.json["animations"][clip]["samplers"] for t in self.accessor(s["input"])]
        return min(times), max(times)

    def sample(self, sampler, t, path):
        times = [x[0] for x in self.accessor(sampler["input"])]
        values = self.accessor(sampler["output"])
        if path == "weights":  # a list of scalars, several to a key
            width = len(values) // len(times)
            if sampler.get("interpolation") == "CUBICSPLINE":
                width //= 3
            values = [[x[0] for x in values[i:i + width]] for i in range(0, len(values), width)]
        kind = sampler.get("interpolation", "LINEAR")
        spline = kind == "CUBICSPLINE"

        def value(k):
            return values[3 * k + 1] if spline else values[k]

        if t <= times[0]:
            return value(0)
        if t >= times[-1]:
            return value(len(times) - 1)
        k = max(i for i in range(len(times)) if times[i] <= t)
        if kind == "STEP":
            return value(k)
        d = times[k + 1] - times[k]
        u = (t - times[k]) / d
        a, b = value(k), value(k + 1)
        if spline:
            out, into = values[3 * k + 2], values[3 * k + 3]
            return [(2 * u**3 - 3 * u**2 + 1) * a[i] + d * (u**3 - 2 * u**2 + u) * out[i] +
                    (-2 * u**3 + 3 * u**2) * b[i] + d * (u**3 - u**2) * into[i] for i in range(len(a))]
        if path == "rotation":
            a, b = unit(a), unit(b)
            dot = sum(x * y for x, y in zip(a, b))
            angle = math.acos(min(1.0, abs(dot)))
            if angle > 1e-6:
                sign = 1 if dot >= 0 else -1
                return [math.sin(angle * (1 - u)) / math.sin(angle) * x +
                        sign * math.sin(angle * u) / math.sin(angle) * y for x, y in zip(a, b)]
            if dot < 0:
                b = [-x for x in b]
        return [(1 - u) * x + u * y for x, y in zip(a, b)]

    def positions(self, clip, t):
        """All vertices: of the scene's nodes by number, of their primitives in order."""
        nodes = self.json["nodes"]
        moved = {}
        animation = self.json["animations"][clip]
        for channel in animation["channels"]:
            target = channel["target"]
            if "node" in target:
                moved[target["node"], target["path"]] = self.sample(animation["samplers"][channel["sampler"]], t,
                                                                    target["path"])
        parent = {c: i for i, n in enumerate(nodes) for c in n.get("children", [])}

        def of(i, path, default):
            return moved.get((i, path), nodes[i].get(path, default))

        def world(i):
            if "matrix" in nodes[i]:
                local = from_columns(nodes[i]["matrix"])
            else:
                local = matrix(of(i, "translation", [0, 0, 0]), of(i, "rotation", [0, 0, 0, 1]),
                               of(i, "scale", [1, 1, 1]))
            return multiply(world(parent[i]), local) if i in parent else local

        drawn = set()

        def visit(i):
            drawn.add(i)
            for c in nodes[i].get("children", []):
                visit(c)

        for root in self.json["scenes"][self.json.get("scene", 0)]["nodes"]:
            visit(root)
        result = []
        for i in sorted(drawn):
            if "mesh" not in nodes[i]:
                continue
            mesh = self.json["meshes"][nodes[i]["mesh"]]
            joints = None
            if "skin" in nodes[i]:
                skin = self.json["skins"][nodes[i]["skin"]]
                joints = [world(j) for j in skin["joints"]]
                if "inverseBindMatrices" in skin:
                    binds = self.accessor(skin["inverseBindMatrices"])
                    joints = [multiply(m, from_columns(b)) for m, b in zip(joints, binds)]
            place = world(i)
            for primitive in mesh["primitives"]:
                if primitive.get("mode", 4) < 4:
                    continue
                attributes = primitive["attributes"]
                points = [list(p) for p in self.accessor(attributes["POSITION"])]
                weights = of(i, "weights", mesh.get("weights", [0] * len(primitive.get("targets", []))))
                for w, target in zip(weights, primitive.get("targets", [])):
                    if "POSITION" in target:
                        for p, d in zip(points, self.accessor(target["POSITION"])):
                            for c in range(3):
                                p[c] += w * d[c]
                if joints is None:
                    result += [apply(place, p) for p in points]
                    continue
                sets = range(sum(1 for a in attributes if a.startswith("JOINTS_")))
                for v, p in enumerate(points):
                    total = [0.0, 0.0, 0.0]
                    for s in sets:
                        for j, w in zip(self.accessor(attributes["JOINTS_%d" % s])[v],
                                        self.accessor(attributes["WEIGHTS_%d" % s])[v]):
                            if w != 0:
                                q = apply(joints[j], p)
                                total = [a + w * b for a, b in zip(total, q)]
                    result.append(total)
        return result
