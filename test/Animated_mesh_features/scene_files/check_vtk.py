#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_vtk.py SCENE ANIMATION FEATURES.json

Reads the folder that detect_features --vtk has written by VTK's own readers, and compares it with the animation
(ANIMATION.obj, ANIMATION.pc2), the features, and the fields (NAME.npy), number by number.
"""

import ast
import json
import math
import os
import sys
import xml.etree.ElementTree

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from scene_data import check, count, near, read_npy, read_pc2, read_triangles, turned


def read_series(name):
    """Time and data of each file of a .pvd file."""
    root = xml.etree.ElementTree.parse(os.path.join(scene, name)).getroot()
    check(root.get("type") == "Collection", name + ": the type")
    series = []
    for entry in root.iter("DataSet"):
        reader = vtkXMLPolyDataReader()
        path = os.path.join(scene, entry.get("file"))
        check(reader.CanReadFile(path) == 1, path + ": VTK reads it")
        reader.SetFileName(path)
        reader.Update()
        check(reader.GetErrorCode() == 0, path + ": without an error")
        series.append((float(entry.get("timestep")), reader.GetOutput()))
        time = series[-1][1].GetFieldData().GetArray("TimeValue")
        check(time.GetNumberOfTuples() == 1 and near(time.GetValue(0), series[-1][0]), path + ": the time")
    return series


def values(data, name):
    array = data.GetPointData().GetArray(name)
    check(array is not None, "there is an array " + name)
    check(array.GetNumberOfTuples() == data.GetNumberOfPoints(), "the size of " + name)
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())]


scene, animation, features = sys.argv[1], sys.argv[2], json.load(open(sys.argv[3]))
positions = read_pc2(animation + ".pc2")
triangles = [turned(t) for t in read_triangles(animation + ".obj")]
frame_duration = features["animation"]["frame_duration"]
fields = {name: read_npy(name + ".npy") for name in ("strain", "curvature", "deformation")}
features = features["features"]
check(len(features) > 3, "there are features")

surface = read_series("surface.pvd")
check(len(surface) == len(positions), "a surface for each frame")
for f, (time, data) in enumerate(surface):
    check(near(time, f * frame_duration), "the time of a frame")
    check(data.GetNumberOfPoints() == len(positions[f]), "the number of vertices")
    for v, p in enumerate(positions[f]):
        check(data.GetPoint(v) == p, "the position of vertex %d in frame %d" % (v, f))
    check(data.GetNumberOfPolys() == data.GetNumberOfCells() == len(triangles), "the number of triangles")
    for t in (range(len(triangles)) if f == 0 else (0, len(triangles) - 1)):
        ids = data.GetCell(t).GetPointIds()
        check(turned(tuple(ids.GetId(i) for i in range(ids.GetNumberOfIds()))) == triangles[t], "triangle %d" % t)
    for name, field in fields.items():
        for v, value in enumerate(values(data, name)):
            check(value == field[v][f], "%s of vertex %d in frame %d" % (name, v, f))
    check(data.GetPointData().GetScalars().GetName() == "deformation", "the deformation is shown first")
    normals = data.GetPointData().GetNormals()
    check(normals is not None and normals.GetNumberOfTuples() == len(positions[f]), "normals")
    for v in range(0, len(positions[f]), 97):
        check(near(math.hypot(*normals.GetTuple3(v)), 1, 1e-6), "the length of a normal")
    for a, b, c in triangles[:20]:
        u, w = ([q - p for p, q in zip(positions[f][a], positions[f][k])] for k in (b, c))
        outward = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]]
        sums = [sum(normals.GetTuple3(v)[k] for v in (a, b, c)) for k in range(3)]
        check(sum(x * y for x, y in zip(outward, sums)) > 0, "the side to which normals point")

series = read_series("features.pvd")
check(len(series) == len(positions), "features for each frame")
seen = set()
empty = 0
for f, (time, data) in enumerate(series):
    alive = [i for i, x in enumerate(features)
             if f == x["frame"] or abs(f * frame_duration - x["time"]) <= 2 * x["tau"]]
    check(values(data, "rank") == [i + 1 for i in alive], "those that live in frame %d" % f)
    check(data.GetNumberOfVerts() == data.GetNumberOfCells() == len(alive), "a vertex for each feature")
    empty += not alive
    seen.update(alive)
    columns = {name: values(data, name)
               for name in ("sigma", "tau", "time", "strength", "amplitude", "fit", "radius", "vertex", "frame", "place", "parent",
                            "at_scale_limit", "opacity")}
    for row, i in enumerate(alive):
        x = features[i]
        for name in ("sigma", "tau", "time", "strength", "amplitude", "fit", "radius", "vertex", "frame", "place", "at_scale_limit"):
            check(near(columns[name][row], x[name]), "%s of feature %d in frame %d" % (name, i, f))
        check(columns["parent"][row] == (x["parent"] or 0), "the parent of feature %d" % i)
        check(near(columns["opacity"][row], math.exp(-((f * frame_duration - x["time"]) / x["tau"]) ** 2 / 2)), "opacity")
        place = [sum(b * positions[f][v][c] for b, v in zip(x["barycentric_coordinates"], x["triangle"]))
                 for c in range(3)]
        check(all(near(a, b) for a, b in zip(data.GetPoint(row), place)), "the place of feature %d in frame %d" % (i, f))
check(seen == set(range(len(features))), "every feature is seen in some frame")
check(empty > 0, "in some frame of this animation no feature lives")

# what the script for ParaView has from the scene
script = ast.parse(open(os.path.join(scene, "show_in_paraview.py"), encoding="utf-8").read())
constants = {node.targets[0].id: ast.literal_eval(node.value) for node in script.body if isinstance(node, ast.Assign)}
every = sorted(x for row in fields["deformation"] for x in row)
check(constants["FIELD"] == "deformation", "the field that the script shows")
check(every[int(0.985 * len(every))] <= constants["FIELD_TOP"] <= every[-1], "the top of its colours")
check(near(constants["TAUS"][0], min(x["tau"] for x in features)), "the shortest tau")
check(near(constants["TAUS"][1], max(x["tau"] for x in features)), "the longest tau")
short, long = constants["TAU_COLOURS"][0], constants["TAU_COLOURS"][-1]
check(short[0] > short[2] and long[2] > long[0], "short is red, long is blue")
check(near(constants["STRONGEST_TIME"], features[0]["frame"] * frame_duration), "the time of the strongest feature")

print("VTK reads %d frames: %d checks, all as expected" % (len(positions), count()))
