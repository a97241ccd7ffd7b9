# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""blender --background --factory-startup --python-exit-code 1 --python check_in_blender.py -- ADDON.py ANIMATION FEATURES.json FIELD.npy [PICTURE.png]

The add-on in Blender, on a mesh that a cache moves (ANIMATION.obj, ANIMATION.pc2): its spheres are where, when and as large
as the file says.
"""

import importlib.util
import json
import math
import struct
import sys

import bpy
import numpy as np

checks = 0


def check(condition, what):
    global checks
    checks += 1
    if not condition:
        raise SystemExit("failed: " + what)


def near(a, b, tolerance):
    return abs(a - b) <= tolerance


addon_path, animation, features_path, field_path, *picture = sys.argv[sys.argv.index("--") + 1:]
spec = importlib.util.spec_from_file_location("animated_mesh_features_addon", addon_path)
addon = importlib.util.module_from_spec(spec)
spec.loader.exec_module(addon)
addon.register()

for thing in list(bpy.data.objects):
    if thing.type == "MESH":
        bpy.data.objects.remove(thing)
rows = [line.split() for line in open(animation + ".obj")]
points = [tuple(map(float, row[1:4])) for row in rows if row and row[0] == "v"]
faces = [tuple(int(corner.split("/")[0]) - 1 for corner in row[1:]) for row in rows if row and row[0] == "f"]
data = open(animation + ".pc2", "rb").read()
n, frames = struct.unpack("<i", data[16:20])[0], struct.unpack("<i", data[28:32])[0]
cache = np.frombuffer(data, "<f4", 3 * n * frames, 32).reshape(frames, n, 3)
features = json.load(open(features_path))
d, diagonal = features["animation"]["frame_duration"], features["animation"]["bounding_box_diagonal"]
features = features["features"]
check(len(features) > 3, "there are features")

# the mesh is twice as large in the scene, and turned, as importers do it
scene = bpy.context.scene
rate = scene.render.fps = round(1 / d)
check(near(rate * d, 1, 1e-9), "whole frames a second")
mesh = bpy.data.meshes.new("body")
mesh.from_pydata(points, [], faces)
body = bpy.data.objects.new("body", mesh)
scene.collection.objects.link(body)
body.scale, body.rotation_euler, body.location = (2, 2, 2), (math.pi / 2, 0, 0), (1, 2, 3)
modifier = body.modifiers.new("cache", "MESH_CACHE")
modifier.cache_format, modifier.filepath = "PC2", bpy.path.abspath(animation + ".pc2")
modifier.forward_axis, modifier.up_axis = "POS_Y", "POS_Z"
modifier.frame_start = scene.frame_start
scene.frame_end = scene.frame_start + frames - 1
bpy.context.view_layer.objects.active = body
bpy.context.view_layer.update()


def in_world(p):
    """2 Rx(90 degrees) p + (1, 2, 3)"""
    x, y, z = p
    return (2 * x + 1, -2 * z + 2, 2 * y + 3)


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


result = bpy.ops.import_scene.animated_mesh_features(filepath=features_path, field=field_path)
check(result == {"FINISHED"}, "the operator has finished")
collection = next(c for c in bpy.data.collections if c.name.startswith("Features of "))
check(len(collection.objects) == len(features), "an object for each feature")
spheres = {thing["rank"]: thing for thing in collection.objects}
field = np.load(field_path)
wrong_side = 0
for i, feature in enumerate(features):
    thing = spheres[i + 1]
    for name in ("vertex", "frame", "time", "sigma", "tau", "strength", "amplitude", "fit", "place", "at_scale_limit"):
        check(near(float(thing[name]), float(feature[name]), 1e-6 * (1 + abs(feature[name]))), "%s of feature %d" % (name, i + 1))
    check(thing.parent == body, "feature %d is parented" % (i + 1))
    check(thing.material_slots[0].material is not None, "feature %d has a material" % (i + 1))
for frame in range(0, frames, 3):
    scene.frame_set(scene.frame_start + frame)
    graph = bpy.context.evaluated_depsgraph_get()
    for i, feature in enumerate(features):
        thing = spheres[i + 1].evaluated_get(graph)
        expected = abs(frame * d - feature["time"]) <= 2 * feature["tau"] + 1e-9 or frame == round(feature["time"] / d)
        on_edge = near(abs(frame * d - feature["time"]), 2 * feature["tau"], 1e-6)
        check(on_edge or thing.hide_render != expected, "feature %d in frame %d is %s" % (i + 1, frame, "there" if thing.hide_render else "hidden"))
        if thing.hide_render:
            continue
        place = sum(b * cache[frame][v] for b, v in zip(feature["barycentric_coordinates"], feature["triangle"]))
        check(distance(thing.matrix_world.translation, in_world(place)) <= 1e-4 * diagonal, "the place of feature %d in frame %d" % (i + 1, frame))
    colours = np.empty(4 * n, dtype=np.float32)
    body.data.color_attributes["deformation"].data.foreach_get("color", colours)
    luminance = colours.reshape(n, 4)[:, :3] @ (0.2126, 0.7152, 0.0722)
    order = np.argsort(field[:, frame])
    check(np.all(np.diff(luminance[order]) <= 2e-2), "the more deformed, the darker, in frame %d" % frame)
for i, feature in enumerate(features):
    scene.frame_set(scene.frame_start + round(feature["time"] / d))
    thing = spheres[i + 1].evaluated_get(bpy.context.evaluated_depsgraph_get())
    place = sum(b * cache[round(feature["time"] / d)][v] for b, v in zip(feature["barycentric_coordinates"], feature["triangle"]))
    check(distance(thing.matrix_world.translation, in_world(place)) <= 1e-4 * diagonal, "the place of feature %d at its time" % (i + 1))
    corners = np.array([thing.matrix_world @ v.co for v in thing.data.vertices])
    middle = np.array(thing.matrix_world.translation)
    radii = np.linalg.norm(corners - middle, axis=1)
    check(np.allclose(radii, 2 * feature["radius"], rtol=2e-3), "the radius of feature %d: %g, not %g" % (i + 1, radii.mean(), 2 * feature["radius"]))
    taus = [f["tau"] for f in features]
    if feature["tau"] in (min(taus), max(taus)):
        red, _, blue, _ = thing.material_slots[0].material.diffuse_color
        check((red > blue) == (feature["tau"] == min(taus)), "short is red, long is blue")

# without a mesh, at the place of the file
bpy.context.view_layer.objects.active = None
bpy.ops.import_scene.animated_mesh_features(filepath=features_path)
loose = [c for c in bpy.data.collections if c.name.startswith("Features of ") and c != collection][0]
for thing in loose.objects:
    feature = features[thing["rank"] - 1]
    check(thing.parent is None and distance(thing.location, feature["position"]) <= 1e-5 * diagonal, "the place without a mesh")
    check(near(thing.scale.x, feature["radius"], 1e-5 * diagonal), "the radius without a mesh")
for thing in list(loose.objects):
    bpy.data.objects.remove(thing)

# another mesh is refused
other = bpy.data.objects.new("other", bpy.data.meshes.new("other"))
other.data.from_pydata(points[:3], [], [(0, 1, 2)])
scene.collection.objects.link(other)
bpy.context.view_layer.objects.active = other
try:
    outcome = bpy.ops.import_scene.animated_mesh_features(filepath=features_path)
    message = ""
except RuntimeError as error:  # as Blender tells of errors in the background
    outcome, message = {"CANCELLED"}, str(error)
check(outcome == {"CANCELLED"} and "3 vertices" in message, "another mesh is refused: " + message)
bpy.data.objects.remove(other)

if picture:
    scene.frame_set(scene.frame_start + round(features[0]["time"] / d))
    low, high = cache.min(axis=(0, 1)), cache.max(axis=(0, 1))
    middle = in_world((low + high) / 2)
    camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    scene.collection.objects.link(camera)
    camera.location = (middle[0] + 1.2 * diagonal, middle[1] - 3.4 * diagonal, middle[2] + 1.2 * diagonal)
    aim = camera.constraints.new("TRACK_TO")
    target = bpy.data.objects.new("target", None)
    target.location = middle
    scene.collection.objects.link(target)
    aim.target = target
    scene.camera = camera
    scene.render.engine, scene.render.filepath = "CYCLES", picture[0]
    scene.cycles.samples, scene.cycles.use_denoising = 12, False
    scene.render.resolution_x, scene.render.resolution_y = 640, 480
    scene.view_settings.view_transform = "Standard"
    world = scene.world or bpy.data.worlds.new("world")
    scene.world = world
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.8, 0.8, 0.8, 1)
    bpy.ops.render.render(write_still=True)

addon.unregister()
print("Blender %s: %d features on %d frames: %d checks, all as expected" % (bpy.app.version_string, len(features), frames, checks))
