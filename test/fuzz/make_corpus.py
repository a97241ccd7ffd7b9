# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes the bytes that fuzzing starts from: small files of each format, as text where the format is text.

make_corpus.py FOLDER
"""

import base64
import json
import math
import pathlib
import struct
import sys

# A square of two triangles, and a fan.
POINTS = [(0, 0, 0), (1, 0, 0.5), (1, 1, 0), (0, 1e-3, -2.25)]
TRIANGLES = [(0, 1, 2), (0, 2, 3)]


def ply_header(form, index="int"):
    return (f"ply\nformat {form} 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
            f"property float z\nelement face 2\nproperty list uchar {index} vertex_indices\nend_header\n")


def text_of(points, prefix=""):
    return "".join(prefix + " ".join(map(str, p)) + "\n" for p in points)


def ascii_stl():
    facets = "".join("facet normal 0 0 1\nouter loop\n" + text_of([POINTS[v] for v in t], "vertex ") +
                     "endloop\nendfacet\n" for t in TRIANGLES)
    return "solid square\n" + facets + "endsolid square\n"


def binary_stl():
    records = b"".join(struct.pack("<12fH", 0, 0, 1, *[x for v in t for x in POINTS[v]], 0) for t in TRIANGLES)
    return b"binary".ljust(80) + struct.pack("<I", len(TRIANGLES)) + records


def binary_ply(order):
    form = "binary_little_endian" if order == "<" else "binary_big_endian"
    return (ply_header(form).encode() + b"".join(struct.pack(order + "3f", *p) for p in POINTS) +
            b"".join(struct.pack(order + "B3i", 3, *t) for t in TRIANGLES))


def meshes():
    """Each with the digit that tells the target what it is."""
    obj = "# square\no s\n" + text_of(POINTS, "v ") + "vt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3\nf -4 \\\n -2 -1\n"
    off = "OFF\n4 2 0\n" + text_of(POINTS) + text_of([(3,) + t for t in TRIANGLES])
    yield "square.obj", "0" + obj
    yield "quad.obj", "4" + text_of(POINTS, "v ") + "f 1 2 3 4\n"
    yield "square.off", "1" + off
    coloured = text_of([p + (0, 0, 1, 255, 0, 0, 255) for p in POINTS])
    yield "coloured.off", "5NCOFF # a quad\n4 1 4\n" + coloured + "4 0 1 2 3\n"
    yield "ascii.ply", "2" + ply_header("ascii") + text_of(POINTS) + text_of([(3,) + t for t in TRIANGLES])
    yield "little.ply", b"2" + binary_ply("<")
    yield "big.ply", b"6" + binary_ply(">")
    yield "ascii.stl", "3" + ascii_stl()
    yield "binary.stl", b"3" + binary_stl()
    for i, number in enumerate(["1", "-.5", "+1e3", "123456789012345678901e-30", "2.2250738585072011e-308", "4.9e-324"]):
        yield f"number{i}", "8" + number


def caches():
    xyz = [x for p in POINTS for x in p]
    yield "a.pc2", b"P" + struct.pack("<12siiffi", b"POINTCACHE2", 1, 4, 0, 1, 2) + struct.pack("<24f", *xyz, *xyz)
    yield "a.mdd", b"M" + struct.pack(">ii2f", 2, 4, 0, 0.5) + struct.pack(">24f", *xyz, *xyz)


def features():
    feature = {"vertex": 2, "frame": 1, "time": 0.04, "position": [0, 0.5, 1], "sigma": 0.25, "tau": 0.125,
               "radius": 0.35, "response": -0.5, "strength": 0.5, "rest_position": [0, 0.5, 1], "triangle": [0, 1, 2],
               "barycentric_coordinates": [0, 0, 1], "at_scale_limit": False}
    animation = {"vertices": 4, "faces": 2, "frames": 3, "frame_duration": 0.04, "bounding_box_diagonal": 1.5,
                 "mean_edge_length": 1}
    file = {"format": "animated-mesh-features", "version": 1, "animation": animation,
            "parameters": {"preset": "calibrated", "range": [0.5, None], "inputs": ["a.obj", "a.pc2"], "on": True,
                           "n": 7, "nothing": None},
            "features": [feature]}
    yield "plain.json", json.dumps(file, indent=1)
    animation["parts"] = [{"name": "body", "first_vertex": 0, "vertices": 5}]
    feature["file_vertices"] = [2, 4]
    yield "parts.json", json.dumps(file)
    animation = {"vertices": 4, "frames": 3, "frame_duration": 0.04}
    yield "painting.json", json.dumps({"format": "animated-mesh-features-painting", "version": 1, "animation": animation,
                                       "painter": "A", "strokes": [{"frame": 1, "frames": [0, 1], "vertices": [3, 0]}]})
    maximum = {"time": 0.04, "angle_deg": 45.5, "prominence_deg": 30}
    yield "rig.json", json.dumps({"format": "animated-mesh-features-rig-events", "version": 1, "animation": animation,
                                  "joints": [{"name": "knee", "region": [1, 2], "maxima": [maximum]}]})


def gltf_data(morph):
    """The buffer of a model and its accessors, as the JSON has them."""
    pieces, views, accessors = b"", [], []

    def add(data, component, kind, count, **more):
        nonlocal pieces
        pieces += b"\0" * (-len(pieces) % 4)
        views.append({"buffer": 0, "byteOffset": len(pieces), "byteLength": len(data)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": count, "type": kind, **more})
        pieces += data

    xyz = [x for p in POINTS for x in p]
    add(struct.pack("<12f", *xyz), 5126, "VEC3", 4, min=[0, 0, -2.25], max=[1, 1, 0.5])
    add(struct.pack("<6H", *[v for t in TRIANGLES for v in t]), 5123, "SCALAR", 6)
    add(struct.pack("<3f", 0, 0.5, 1), 5126, "SCALAR", 3, min=[0], max=[1])
    if morph:
        add(struct.pack("<12f", *[0] * 10, 1, 0), 5126, "VEC3", 4)
        add(struct.pack("<3f", 0, 1, 0.25), 5126, "SCALAR", 3)
    else:
        add(struct.pack("<12f", *[0, 0, 0, 1, 0, 0, 0.6, 0.8, 0, 0, 0, 1]), 5126, "VEC4", 3)
        add(struct.pack("<16B", *[0, 1, 0, 0] * 4), 5121, "VEC4", 4)
        add(struct.pack("<16f", *[0.5, 0.5, 0, 0] * 4), 5126, "VEC4", 4)
        matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
        add(struct.pack("<32f", *matrix, *matrix), 5126, "MAT4", 2)
    return pieces, views, accessors


def gltf(morph, uri):
    data, views, accessors = gltf_data(morph)
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}
    nodes = [{"mesh": 0}]
    if morph:
        primitive["targets"] = [{"POSITION": 3}]
        target, output, interpolation = {"node": 0, "path": "weights"}, 4, "LINEAR"
    else:
        primitive["attributes"].update(JOINTS_0=4, WEIGHTS_0=5)
        nodes = [{"mesh": 0, "skin": 0}, {"children": [2], "translation": [0, 0, 1]}, {"scale": [1, 2, 1]}]
        target, output, interpolation = {"node": 2, "path": "rotation"}, 3, "STEP"
    model = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0] if morph else [0, 1]}], "nodes": nodes,
             "meshes": [{"primitives": [primitive]}],
             "animations": [{"name": "a", "channels": [{"sampler": 0, "target": target}],
                             "samplers": [{"input": 2, "output": output, "interpolation": interpolation}]}],
             "buffers": [{"byteLength": len(data)}], "bufferViews": views, "accessors": accessors}
    if not morph:
        model["skins"] = [{"joints": [1, 2], "inverseBindMatrices": 6}]
    if uri:
        model["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps(model), data


def sparse():
    """The morph target's displacements as a sparse accessor."""
    model = json.loads(gltf(True, True)[0])
    model["accessors"][3] = {"componentType": 5126, "type": "VEC3", "count": 4, "sparse": {
        "count": 1, "indices": {"bufferView": 1, "byteOffset": 2, "componentType": 5123}, "values": {"bufferView": 0}}}
    return json.dumps(model)


def models():
    yield "morph.gltf", gltf(True, True)[0]
    yield "skin.gltf", gltf(False, True)[0]
    yield "sparse.gltf", sparse()
    text, data = gltf(True, False)
    text, data = text.encode(), data + b"\0" * (-len(data) % 4)
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    yield "morph.glb", b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


# Targets that make something of the bytes take numbers from their end.

def bump(options):
    """A bump that comes and goes on a grid of 5 x 5 vertices, in 9 frames; before it the options."""
    mesh = [3, 3, 0, 0, 0, 0, 0, 0]  # 2 + 3 vertices either way; no tube; no holes; no odd triangle
    timing = [7, 1, 1, 255, 255]  # 2 + 7 frames; as they are; nothing odd
    motion = []
    for f in range(9):
        for v in range(25):
            height = 60 * math.exp(-((v % 5 - 2) ** 2 + (v // 5 - 2) ** 2) / 1.5 - (f - 4) ** 2 / 3)
            motion += [128 + v % 3, 128 + 2 * v % 3, 128 + round(height)]  # from -128 on; without symmetries
    return bytes(reversed(options + mesh + timing + motion))


def detector():
    usual = 0
    yield "calibrated", bump([1] + [usual] * 2 + [0] + [usual] * 2 + [0, 1] + [usual] * 2 + [128, 60, 128, 90] + [usual] * 2)
    yield "published", bump([0, 2] + [usual] * 2 + [0] + [usual] * 2 + [0, 1] + [8, 8])


def hdf5():
    faces = [0, 2, 2, 3, 4, 0] + list(struct.pack("<6q", *[v for t in TRIANGLES for v in t]))  # 2 x 3, 64 bits
    numbers = struct.pack("<36f", *[x + f for p in POINTS for x in p for f in range(3)])
    walk = [1, 3, 4, 3, 3, 6, 0] + list(numbers) + [0] * 144
    yield "walk", bytes(reversed([1, 1, 1] + faces + walk))


def main():
    folder = pathlib.Path(sys.argv[1])
    for target, files in {"meshes": meshes, "caches": caches, "features": features, "gltf": models, "hdf5": hdf5,
                          "detector": detector}.items():
        (folder / target).mkdir(parents=True, exist_ok=True)
        for name, content in files():
            (folder / target / name).write_bytes(content if isinstance(content, bytes) else content.encode())


if __name__ == "__main__":
    main()
