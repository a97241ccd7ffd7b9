#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_glb.py SCENE.glb ANIMATION FEATURES.json DEFORMATION.npy

Plays the file that detect_features --glb has written, and compares what is seen in each frame with the animation
(ANIMATION.obj, ANIMATION.pc2), the features and the deformation.
"""

import json
import math
import struct
import sys

from scene_data import check, count, near, read_npy, read_pc2, read_triangles, turned

data = open(sys.argv[1], "rb").read()
check(struct.unpack("<4sII", data[:12]) == (b"glTF", 2, len(data)), "the header")
length, kind = struct.unpack("<I4s", data[12:20])
check(kind == b"JSON", "the first chunk")
gltf = json.loads(data[20:20 + length])
begin = 20 + length
length, kind = struct.unpack("<I4s", data[begin:begin + 8])
check(kind == b"BIN\0" and begin + 8 + length == len(data), "the second chunk")
binary = data[begin + 8:]
check("extensionsUsed" not in gltf, "no extension is needed")


def read(accessor):
    """The tuples of an accessor."""
    a = gltf["accessors"][accessor]
    view = gltf["bufferViews"][a["bufferView"]]
    code = {5120: "b", 5121: "B", 5125: "I", 5126: "f"}[a["componentType"]]
    size = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
    offset = view["byteOffset"] + a["byteOffset"]
    check(view.get("byteStride", 0) in (0, size * struct.calcsize(code)), "tuples are next to each other")
    values = struct.unpack_from("<%d%s" % (size * a["count"], code), binary, offset)
    if a.get("normalized"):
        values = [x / (127 if code == "b" else 255) for x in values]
    return [values[i:i + size] for i in range(0, len(values), size)]


def play(sampler, time):
    """The value of a sampler at a time."""
    times, values = [t for (t,) in read(sampler["input"])], read(sampler["output"])
    size = len(values) // len(times)
    values = [[x for t in values[i:i + size] for x in t] for i in range(0, len(values), size)]
    if time <= times[0]:
        return values[0]
    if time >= times[-1]:
        return values[-1]
    i = max(k for k in range(len(times)) if times[k] <= time)
    if sampler["interpolation"] == "STEP":
        return values[i]
    u = (time - times[i]) / (times[i + 1] - times[i])
    return [(1 - u) * a + u * b for a, b in zip(values[i], values[i + 1])]


def added(base, target):
    return [tuple(x + d for x, d in zip(a, b)) for a, b in zip(base, target)]


animation, features, field = sys.argv[2], json.load(open(sys.argv[3])), read_npy(sys.argv[4])
positions = read_pc2(animation + ".pc2")
triangles = [turned(t) for t in read_triangles(animation + ".obj")]
frame_duration = features["animation"]["frame_duration"]
size = features["animation"]["bounding_box_diagonal"]
features = features["features"]
frames, vertices = len(positions), len(positions[0])
check(len(features) > 3, "there are features")

scene = gltf["scenes"][gltf["scene"]]
check(scene["extras"]["frames"] == frames and near(scene["extras"]["frame_duration"], frame_duration), "the frame duration in the extras")
nodes = [gltf["nodes"][i] for i in scene["nodes"]]
check([n["name"] for n in nodes] == ["surface"] + ["feature_%d" % (i + 1) for i in range(len(features))], "the nodes")
samplers = {(c["target"]["node"], c["target"]["path"]): gltf["animations"][0]["samplers"][c["sampler"]]
            for c in gltf["animations"][0]["channels"]}
check(len(samplers) == 1 + 2 * len(features), "a channel for each motion")

mesh = gltf["meshes"][nodes[0]["mesh"]]
primitive = mesh["primitives"][0]
corners = [v for (v,) in read(primitive["indices"])]
check([turned(tuple(corners[i:i + 3])) for i in range(0, len(corners), 3)] == triangles, "the triangles")
base = {name: read(accessor) for name, accessor in primitive["attributes"].items()}
targets = [{name: read(accessor) for name, accessor in t.items()} for t in primitive["targets"]]
check(len(targets) == frames == len(mesh["extras"]["targetNames"]), "a target for each frame")
for a in [primitive["attributes"]["POSITION"]] + [t["POSITION"] for t in primitive["targets"]]:
    points = read(a)
    for c in range(3):
        check(gltf["accessors"][a]["min"][c] == min(p[c] for p in points), "the least coordinate")
        check(gltf["accessors"][a]["max"][c] == max(p[c] for p in points), "the greatest coordinate")


def lightness(color):
    return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]


top = scene["extras"]["top_of_scale"]
every = sorted(x for row in field for x in row)
check(every[int(0.985 * len(every))] <= top <= every[int(0.995 * len(every))], "the top of the scale of colours")
check(scene["extras"]["colour"] == "deformation", "the colour is that of the deformation")
for f in range(frames):
    weights = play(samplers[0, "weights"], f * frame_duration)
    check(all(near(w, g == f, 1e-4) for g, w in enumerate(weights)), "the weights in frame %d" % f)
    seen = added(base["POSITION"], targets[f]["POSITION"])
    for v in range(vertices):
        check(all(near(a, b, 1e-6 * size) for a, b in zip(seen[v], positions[f][v])), "vertex %d in frame %d" % (v, f))
    normals = added(base["NORMAL"], targets[f]["NORMAL"])
    check(all(near(math.hypot(*n), 1, 1e-5) for n in normals), "the length of normals in frame %d" % f)
    for a, b, c in triangles[:20]:
        u = [q - p for p, q in zip(seen[a], seen[b])]
        w = [q - p for p, q in zip(seen[a], seen[c])]
        outward = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]]
        check(sum(x * (y + z + t) for x, y, z, t in zip(outward, normals[a], normals[b], normals[c])) > 0,
              "the side to which normals point")
    # the more deformation, the darker, up to the rounding of colours
    colors = added(base["COLOR_0"], targets[f]["COLOR_0"])
    darkest = 2
    for v in sorted(range(vertices), key=lambda v: field[v][f]):
        check(lightness(colors[v]) <= darkest + 0.01, "the colour of vertex %d in frame %d" % (v, f))
        darkest = min(darkest, lightness(colors[v]))
most = max(range(vertices), key=lambda v: max(field[v]))
least = min(range(vertices), key=lambda v: max(field[v]))
check(lightness(base["COLOR_0"][least]) > lightness(base["COLOR_0"][most]) + 0.3, "a range of colours")
half = play(samplers[0, "weights"], 2.5 * frame_duration)
check(near(half[2], 0.5, 1e-4) and near(half[3], 0.5, 1e-4), "positions are linear between frames")

taus = [x["tau"] for x in features]
for i, x in enumerate(features):
    node = nodes[1 + i]
    for name in ("vertex", "frame", "time", "sigma", "tau", "radius", "strength", "amplitude", "fit", "place", "at_scale_limit"):
        check(near(node["extras"][name], x[name]), "%s of feature %d" % (name, i))
    check(node["extras"]["rank"] == x["rank"] == i + 1, "the rank of feature %d" % i)
    check(node["extras"]["parent"] == x["parent"], "the parent of feature %d" % i)
    for f in range(frames):
        alive = f == x["frame"] or abs(f * frame_duration - x["time"]) <= 2 * x["tau"]
        scale = play(samplers[1 + i, "scale"], f * frame_duration)
        check(all(near(s, alive * x["radius"], 1e-6 * size) for s in scale), "feature %d in frame %d" % (i, f))
        if f == 0:
            check(node["scale"] == scale, "the scale before the animation starts")
        if not alive:
            continue
        place = [sum(b * positions[f][v][c] for b, v in zip(x["barycentric_coordinates"], x["triangle"]))
                 for c in range(3)]
        seen = play(samplers[1 + i, "translation"], f * frame_duration)
        # times of frames are rounded to single precision
        check(all(near(a, b, 1e-5 * size) for a, b in zip(seen, place)), "the place of feature %d in frame %d" % (i, f))
    red, _, blue, alpha = gltf["materials"][gltf["meshes"][node["mesh"]]["primitives"][0]["material"]][
        "pbrMetallicRoughness"]["baseColorFactor"]
    if x["tau"] in (min(taus), max(taus)):
        check((red > blue) == (x["tau"] == min(taus)), "short is red, long is blue")
    check(0 < alpha < 1, "spheres are translucent")
sphere = read(gltf["meshes"][nodes[1]["mesh"]]["primitives"][0]["attributes"]["POSITION"])
check(all(near(math.hypot(*p), 1, 1e-6) for p in sphere), "the radius of the sphere")

print("GLB: %d frames, %d features, %d bytes: %d checks, all as expected" % (frames, len(features), len(data), count()))
