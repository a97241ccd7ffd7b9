# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Blender add-on (3.4 and later): features of an animated mesh, as detect_features writes them.

Install it in Edit > Preferences > Add-ons; then File > Import > Animated mesh features (.json).

With the animated mesh selected, in the vertex order of the file that was detected on, features follow its surface, whatever
moves it (a mesh cache, shape keys, an armature). Without one, they stand at the place of their time, in the coordinates of
the file. Each feature is a sphere of radius sqrt(2) sigma with its numbers as custom properties, that is there from 2 tau
before its time to 2 tau after, in the frame rate of the scene; short ones are red, long ones blue.

A NumPy array of detect_features --write-field becomes the colour attribute "deformation" of the mesh, which follows the
frame; to render it, the add-on gives a mesh without material one that shows it.
"""

bl_info = {
    "name": "Animated mesh features",
    "author": "The Animated_mesh_features authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Animated mesh features (.json)",
    "description": "Spatio-temporal features of an animated mesh, as detect_features writes them",
    "category": "Import-Export",
}

import json
import math
import os

import bpy
import numpy as np
from bpy.app.handlers import persistent
from bpy.props import BoolProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

FORMAT, VERSION = "animated-mesh-features", 1
LIFE = 2  # taus before and after a feature's time in which it is there, as in all outputs of detect_features
DURATION_STEPS = 17  # materials
OPACITY = 0.6
ATTRIBUTE = "deformation"
FIELD_SHARE = 0.99  # of the values are below the end of the colours, so that a few spikes do not take all of them

# The package's own maps, at equal distances, as sRGB: durations from short to long, fields from 0 up.
DURATION_COLOURS = "f7493e f14658 ea4470 de4587 cb499c b44eaf 9652c2 6c55d2 0858e3"
FIELD_COLOURS = "f6eddb d0dcc4 a9cab0 80b8a2 54a596 2d8f8c 097982 016274 074d65"

# ------------------------------------------------------------------------------------------------------- files and numbers


class FileError(Exception):
    """What is wrong with a file, in a sentence."""


def read_features(path):
    """The features of a JSON file and what it says of the animation: a dictionary, checked as far as it is used."""
    name = os.path.basename(path)
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
    except (OSError, ValueError) as error:
        raise FileError("%s: %s" % (name, error))
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise FileError('%s is no file of features: it has no "format": "%s"' % (name, FORMAT))
    if data.get("version") != VERSION:
        raise FileError("%s has version %s of the format; known is %d only" % (name, data.get("version"), VERSION))
    for member in ("animation", "features"):
        if member not in data:
            raise FileError("%s: %s is missing" % (name, member))
    for member in ("vertices", "frame_duration", "mean_edge_length"):
        if not is_number(data["animation"].get(member)):
            raise FileError("%s: animation.%s is no finite number" % (name, member))
    for i, feature in enumerate(data["features"]):
        for member in ("vertex", "time", "sigma", "tau", "strength"):
            if not is_number(feature.get(member)):
                raise FileError("%s: features[%d].%s is no finite number" % (name, i, member))
        for member in ("position", "triangle", "barycentric_coordinates"):
            values = feature.get(member)
            if not isinstance(values, list) or len(values) != 3 or not all(is_number(x) for x in values):
                raise FileError("%s: features[%d].%s is not three numbers" % (name, i, member))
        for v in feature["triangle"]:
            if not 0 <= v < data["animation"]["vertices"]:
                raise FileError("%s: features[%d].triangle: there is no vertex %d" % (name, i, v))
        feature.setdefault("rank", i + 1)
    return data


def is_number(x):
    return isinstance(x, (int, float)) and not isinstance(x, bool) and math.isfinite(x)


def read_npy(path):
    """Vertices times frames, of NumPy's format, not read into memory."""
    name = os.path.basename(path)
    try:
        values = np.load(path, mmap_mode="r", allow_pickle=False)
    except (OSError, ValueError) as error:
        raise FileError("%s: %s" % (name, error))
    if getattr(values, "ndim", 0) != 2 or values.dtype.kind != "f" or 0 in values.shape:
        raise FileError("%s: an array of numbers, vertices times frames, is expected, as detect_features --write-field writes it" % name)
    return values


def colour_table(text):
    """Colours in linear light, as Blender has them."""
    def linear(byte):
        x = byte / 255
        return x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4
    return [tuple(linear(int(c[i:i + 2], 16)) for i in (0, 2, 4)) for c in text.split()]


def colour_at(table, t):
    t = min(max(t, 0.0), 1.0) * (len(table) - 1)
    i = min(int(t), len(table) - 2)
    return tuple(a + (t - i) * (b - a) for a, b in zip(table[i], table[i + 1]))


def relative_durations(features):
    """Where each tau lies between the shortest and the longest one, by ratio, from 0 to 1."""
    taus = [f["tau"] for f in features if f["tau"] > 0]
    least, most = min(taus, default=1.0), max(taus, default=1.0)
    if most <= least:
        return [0.5 if f["tau"] > 0 else 0.0 for f in features]
    return [math.log(f["tau"] / least) / math.log(most / least) if f["tau"] > 0 else 0.0 for f in features]


def scene_frame(time, rate, first):
    """The frame of a scene, as a number with a fraction, at which `time` seconds of the animation have passed."""
    return first + time * rate


def life(feature, rate, first):
    """The first frame in which a feature is there, and the first one after it; at least one frame, that of its time."""
    begin = math.ceil(scene_frame(feature["time"] - LIFE * feature["tau"], rate, first) - 1e-6)
    end = math.floor(scene_frame(feature["time"] + LIFE * feature["tau"], rate, first) + 1e-6) + 1
    nearest = round(scene_frame(feature["time"], rate, first))
    return min(begin, nearest), max(end, nearest + 1)


def mixed_point(points, weights):
    return [sum(w * p[c] for w, p in zip(weights, points)) for c in range(3)]


def top_of_field(values):
    """The value that FIELD_SHARE of the field do not exceed, of about a million of them."""
    step = max(1, values.shape[0] * values.shape[1] // 1000000)
    return float(np.quantile(values[::step], FIELD_SHARE))


def field_at(values, frame):
    """The values of all vertices, linear between frames; before and after, those of the ends."""
    last = values.shape[1] - 1
    frame = min(max(frame, 0.0), float(last))
    i = min(int(frame), max(last - 1, 0))
    share = frame - i
    return (1 - share) * values[:, i] + share * values[:, min(i + 1, last)]


def field_colours(values, top, frame):
    """Four numbers a vertex, in linear light."""
    steps = np.array([(*colour_at(colour_table(FIELD_COLOURS), i / 255), 1.0) for i in range(256)], dtype=np.float32)
    places = field_at(values, frame) * (255 / top if top > 0 else 0.0)
    return steps[np.clip(np.rint(places), 0, 255).astype(int)]


# ------------------------------------------------------------------------------------------------------------ the scene


def sphere_mesh(name, segments=24, rings=12):
    """A sphere of radius 1."""
    points = [(0, 0, 1)]
    for i in range(1, rings):
        a = math.pi * i / rings
        for j in range(segments):
            b = 2 * math.pi * j / segments
            points.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)))
    points.append((0, 0, -1))
    ring = lambda i, j: 1 + (i - 1) * segments + j % segments
    faces = [(0, ring(1, j), ring(1, j + 1)) for j in range(segments)]
    faces += [(ring(i, j), ring(i + 1, j), ring(i + 1, j + 1), ring(i, j + 1))
              for i in range(1, rings - 1) for j in range(segments)]
    faces += [(len(points) - 1, ring(rings - 1, j + 1), ring(rings - 1, j)) for j in range(segments)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    mesh.update()
    return mesh


def make_clear(material):
    if hasattr(material, "surface_render_method"):  # from Blender 4.2 on
        material.surface_render_method = "BLENDED"
    else:
        material.blend_method = "BLEND"
        material.shadow_method = "NONE"
        material.show_transparent_back = False


def duration_material(step):
    name = "Feature tau %d of %d" % (step, DURATION_STEPS - 1)
    material = bpy.data.materials.get(name)
    if material is not None:
        return material
    material = bpy.data.materials.new(name)
    colour = colour_at(colour_table(DURATION_COLOURS), step / (DURATION_STEPS - 1))
    material.diffuse_color = (*colour, OPACITY)
    material.use_nodes = True
    shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Alpha"].default_value = OPACITY
    shader.inputs["Roughness"].default_value = 0.4
    make_clear(material)
    return material


def key_life(thing, feature, rate, first):
    """Hidden before and after; visible from the first to the last frame of its life."""
    begin, end = life(feature, rate, first)
    for path in ("hide_viewport", "hide_render"):
        for frame, is_hidden in ((begin - 1, True), (begin, False), (end, True)):
            setattr(thing, path, is_hidden)
            thing.keyframe_insert(path, frame=frame)
    for curve in curves_of(thing):
        for point in curve.keyframe_points:
            point.interpolation = "CONSTANT" if curve.data_path.startswith("hide") else "LINEAR"


def curves_of(thing):
    """The curves of an object's action; where they are depends on Blender's version."""
    data = thing.animation_data
    if data is None or data.action is None:
        return []
    if hasattr(data.action, "fcurves"):
        return list(data.action.fcurves)
    return [curve for layer in data.action.layers for strip in layer.strips for bag in strip.channelbags for curve in bag.fcurves]


def set_properties(thing, feature, source):
    """The numbers of the file, under the same names."""
    for name, value in feature.items():
        if name == "parent":
            thing[name] = value if value is not None else 0
        elif isinstance(value, (bool, int, float, str, list)):
            thing[name] = value
    thing["source"] = source


def mean_edge(mesh):
    """Of a mesh as it is modelled: its rest shape."""
    total = 0.0
    for edge in mesh.edges:
        a, b = (mesh.vertices[v].co for v in edge.vertices)
        total += (a - b).length
    return total / max(len(mesh.edges), 1)


def scale_of(surface, animation):
    """How much larger the mesh is in the scene than in the file: importers may change the unit."""
    edge = mean_edge(surface.data) * sum(abs(s) for s in surface.matrix_world.to_scale()) / 3
    return edge / animation["mean_edge_length"] if animation["mean_edge_length"] > 0 and edge > 0 else 1.0


def check_modifiers(context, surface):
    evaluated = surface.evaluated_get(context.evaluated_depsgraph_get())
    if len(evaluated.data.vertices) != len(surface.data.vertices):
        raise FileError("%s has modifiers that add or remove vertices: switch them off, import, and switch them on again" % surface.name)


def put_on_surface(context, features, things, surface, rate, first):
    """Keys the place of each sphere on the moving surface in all frames of its life; spheres go where the object goes."""
    scene, frame_before = context.scene, context.scene.frame_current
    scale = sum(abs(s) for s in surface.matrix_world.to_scale()) / 3
    alive = {}
    for thing, feature in zip(things, features):
        thing.parent = surface
        thing.scale = [s / scale for s in thing.scale]
        begin, end = life(feature, rate, first)
        for frame in range(begin, end):
            alive.setdefault(frame, []).append((thing, feature))
    for frame, group in sorted(alive.items()):
        scene.frame_set(frame)
        points = surface.evaluated_get(context.evaluated_depsgraph_get()).data.vertices
        for thing, feature in group:
            corners = [points[v].co for v in feature["triangle"]]
            thing.location = mixed_point(corners, feature["barycentric_coordinates"])
            thing.keyframe_insert("location", frame=frame)
    scene.frame_set(frame_before)


def add_features(context, path, surface=None):
    """Makes a collection of spheres of the features in a file; on `surface`, if there is one. Gives the collection."""
    data = read_features(path)
    features, animation = data["features"], data["animation"]
    if surface is not None and len(surface.data.vertices) != animation["vertices"]:
        raise FileError("%s has %d vertices, the features were found on %d: select the mesh on which they were found, in its "
                        "vertex order (seams may be split by importers), or nothing to place them as the file says"
                        % (surface.name, len(surface.data.vertices), animation["vertices"]))
    if surface is not None:
        check_modifiers(context, surface)
    render = context.scene.render
    rate, first = render.fps / render.fps_base, context.scene.frame_start
    title = os.path.splitext(os.path.basename(path))[0]
    collection = bpy.data.collections.new("Features of %s" % title)
    context.scene.collection.children.link(collection)
    mesh = sphere_mesh("Feature")
    scale = scale_of(surface, animation) if surface is not None else 1.0
    things = []
    for feature, place in zip(features, relative_durations(features)):
        thing = bpy.data.objects.new("Feature %d" % feature["rank"], mesh)
        collection.objects.link(thing)
        if not mesh.materials:
            mesh.materials.append(None)  # a slot, which each object fills by itself
        thing.material_slots[0].link = "OBJECT"
        thing.material_slots[0].material = duration_material(round(place * (DURATION_STEPS - 1)))
        thing.color = (*colour_at(colour_table(DURATION_COLOURS), place), OPACITY)
        size = math.sqrt(2) * feature["sigma"] * scale
        thing.scale = (size, size, size)
        thing.location = feature["position"]
        set_properties(thing, feature, os.path.basename(path))
        things.append(thing)
    if surface is not None:
        context.view_layer.update()
        put_on_surface(context, features, things, surface, rate, first)
    for thing, feature in zip(things, features):
        key_life(thing, feature, rate, first)
    collection["animation"] = {name: value for name, value in animation.items() if is_number(value)}
    context.scene.frame_set(context.scene.frame_current)
    return collection


# ------------------------------------------------------------------------------------------------------------- the field

_fields = {}  # path: values and the top of their colours


def field_of(path):
    if path not in _fields:
        values = read_npy(path)
        _fields[path] = values, top_of_field(values)
    return _fields[path]


def show_field(surface, scene):
    """Colours a mesh as in the frame of the scene."""
    values, top = field_of(surface["amf_field"])
    rate = scene.render.fps / scene.render.fps_base
    frame = (scene.frame_current_final - scene.frame_start) / rate / surface["amf_frame_duration"]
    attribute = surface.data.color_attributes.get(ATTRIBUTE)
    if attribute is None or len(attribute.data) != len(values):
        return
    attribute.data.foreach_set("color", field_colours(values, top, frame).ravel())
    surface.data.update()


@persistent
def show_fields(scene, *_):
    for thing in scene.objects:
        if thing.type == "MESH" and "amf_field" in thing:
            try:
                show_field(thing, scene)
            except FileError:
                del thing["amf_field"]  # the file is gone: once is enough


def field_material():
    name = "Deformation"
    material = bpy.data.materials.get(name)
    if material is not None:
        return material
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    shader = next(node for node in tree.nodes if node.type == "BSDF_PRINCIPLED")
    attribute = tree.nodes.new("ShaderNodeVertexColor")
    attribute.layer_name = ATTRIBUTE
    attribute.location = (-300, 200)
    tree.links.new(attribute.outputs["Color"], shader.inputs["Base Color"])
    return material


def add_field(context, surface, path, frame_duration):
    """A colour attribute of a mesh that follows the frames of a field."""
    rows = len(field_of(path)[0])
    if rows != len(surface.data.vertices):
        raise FileError("%s has values of %d vertices, %s has %d" % (os.path.basename(path), rows, surface.name, len(surface.data.vertices)))
    if surface.data.color_attributes.get(ATTRIBUTE) is None:
        surface.data.color_attributes.new(ATTRIBUTE, "FLOAT_COLOR", "POINT")
    surface["amf_field"] = os.path.abspath(path)
    surface["amf_frame_duration"] = frame_duration
    if not surface.data.materials:
        surface.data.materials.append(field_material())
    show_field(surface, context.scene)


# ------------------------------------------------------------------------------------------------------------- the menu


class IMPORT_SCENE_OT_animated_mesh_features(bpy.types.Operator, ImportHelper):
    """Features of an animated mesh, as detect_features writes them, onto the selected mesh"""

    bl_idname = "import_scene.animated_mesh_features"
    bl_label = "Import features"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})
    on_mesh: BoolProperty(
        name="On the selected mesh", default=True,
        description="Let features follow the surface of the selected mesh; it must have the vertices of the file, in their order")
    field: StringProperty(
        name="Field", subtype="FILE_PATH", default="",
        description="A NumPy array of detect_features --write-field, as colours of the selected mesh; may be empty")

    def execute(self, context):
        active = context.view_layer.objects.active
        surface = active if self.on_mesh and active is not None and active.type == "MESH" else None
        try:
            collection = add_features(context, self.filepath, surface)
            if self.field:
                if surface is None:
                    raise FileError("select the mesh that %s is of" % os.path.basename(self.field))
                add_field(context, surface, bpy.path.abspath(self.field), read_features(self.filepath)["animation"]["frame_duration"])
        except FileError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        where = "on %s" % surface.name if surface is not None else "where the file says"
        self.report({"INFO"}, "%d features, %s" % (len(collection.objects), where))
        return {"FINISHED"}


def menu(self, context):
    self.layout.operator(IMPORT_SCENE_OT_animated_mesh_features.bl_idname, text="Animated mesh features (.json)")


def register():
    bpy.utils.register_class(IMPORT_SCENE_OT_animated_mesh_features)
    bpy.types.TOPBAR_MT_file_import.append(menu)
    bpy.app.handlers.frame_change_post.append(show_fields)


def unregister():
    bpy.app.handlers.frame_change_post.remove(show_fields)
    bpy.types.TOPBAR_MT_file_import.remove(menu)
    bpy.utils.unregister_class(IMPORT_SCENE_OT_animated_mesh_features)


if __name__ == "__main__":
    register()
