#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The command line of simplify_animation: what it writes, and how it fails.
# SIMPLIFY_ANIMATION and MAKE_ANIMATION are the programs; without them the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs simplify_animation make_animation python3
enter_empty_folder
program="$simplifier"

"$generator" cylinder --vertices 600 --frames 9 -o in >/dev/null || fail "no animation to simplify"
"$generator" cylinder --vertices 600 --frames 5 -o other >/dev/null || fail "no other animation"
vertices="$(grep -c '^v ' in.obj)"

# A 32-bit little-endian integer from place $2 of file $1.
word() { echo $((16#$(od -An -v -t x1 -j "$2" -N 4 "$1" | awk '{ print $4 $3 $2 $1 }'))); }

# check_level <base> <vertices> <frames>
check_level() {
  [[ "$(grep -c '^v ' "$1.obj")" -eq $2 ]] || fail "$1.obj: not $2 vertices"
  [[ "$(word "$1.pc2" 16)" -eq $2 ]] || fail "$1.pc2: not $2 points"
  [[ "$(word "$1.pc2" 28)" -eq $3 ]] || fail "$1.pc2: not $3 frames"
}

# The table, and one level; a second run, on one thread, writes the same.
expect 0 "" in.obj in.pc2 --vertices 100 -o one
check_level one 100 9
grep -qF "$vertices vertices" out || fail "no table: $(head -c 300 out)"
expect 0 "" in.obj in.pc2 --vertices 100 -o again --threads 1 --quiet
[[ ! -s out ]] || fail "--quiet prints"
cmp -s one.obj again.obj && cmp -s one.pc2 again.pc2 || fail "a second run writes something else"

# Levels, nested; a further animation; reports.
expect 0 "" in.obj in.pc2 --lods 0.5,0.25,0.1 -o lod --also other.pc2 --report report.json --binding binding.json
for i in 1 2 3; do
  n="$(grep -c '^v ' lod-$i.obj)"
  check_level lod-$i "$n" 9
  [[ "$(word "lod-${i}_other.pc2" 28)" -eq 5 ]] || fail "--also: level $i"
done
python3 - "$vertices" <<'END' || fail "reports"
import json, struct, sys
report, binding = json.load(open("report.json")), json.load(open("binding.json"))
n = int(sys.argv[1])
wanted = [round(n * r) for r in (0.5, 0.25, 0.1)]
sizes = [l["vertices"] for l in report["levels"]]
assert all(abs(a - b) <= 1 for a, b in zip(sizes, wanted)), (sizes, wanted)
worst = [l["worst_mean"] for l in report["levels"]]
assert 0 < worst[0] < worst[1] < worst[2] < 5, worst
for level in report["levels"]:
    assert len(level["frames"]) == 9
    assert level["turned"] == 0
    means = [(f["mean_to_original"] + f["mean_to_coarse"]) / 2 for f in level["frames"]]
    assert abs(max(means) - level["worst_mean"]) < 1e-12 and means.index(max(means)) == level["worst_frame"]
    assert level["hausdorff"] >= level["worst_mean"]

def cache(name):
    data = open(name, "rb").read()
    points, frames = struct.unpack_from("<i", data, 16)[0], struct.unpack_from("<i", data, 28)[0]
    return [[struct.unpack_from("<3f", data, 32 + 12 * (f * points + v)) for v in range(points)] for f in range(frames)]

# what is bound is where the weights say, also in the animation that was never looked at
for name, coarse in (("in.pc2", "lod-3.pc2"), ("other.pc2", "lod-3_other.pc2")):
    fine, level = cache(name), cache(coarse)
    rows = binding["levels"][2]
    for f in (0, len(fine) - 1):
        for v in range(sizes[2]):
            assert abs(sum(rows["weights"][v]) - 1) < 1e-9 and len(rows["weights"][v]) <= 8
            for k in range(3):
                x = sum(w * fine[f][i][k] for i, w in zip(rows["vertices"][v], rows["weights"][v]))
                assert abs(x - level[f][v][k]) < 1e-5, (name, f, v)
END

# As few as an error allows.
expect 0 "" in.obj in.pc2 --error 0.2 -o within --report within.json
python3 - <<'END' || fail "--error"
import json
level = json.load(open("within.json"))["levels"]
assert len(level) == 1 and 0.1 < level[0]["worst_mean"] <= 0.2, level[0]["worst_mean"]
END

expect 0 "" in.obj in.pc2 --ratio 0.2 --format ply -o frames --normals 60 --poses 4
[[ "$(find frames -name 'frame_*.ply' | wc -l)" -eq 9 ]] || fail "not 9 frames"
head -c 3 frames/frame_0008.ply | grep -qF ply || fail "no PLY"

# A skinned model: its skeleton and clips stay, vertices move as their binding says but for what blending does at the joint.
python3 - <<'END'
import json, math, struct
around, rings, length = 16, 33, 4.0
columns = around + 1  # the texture is cut where the last one meets the first
points, joints, weights, triangles, texture = [], [], [], [], []
for k in range(rings):
    for i in range(columns):
        a, z = 2 * math.pi * (i % around) / around, length * k / (rings - 1)
        points += [math.cos(a) / 2, math.sin(a) / 2, z]
        texture += [i / around, k / (rings - 1)]
        w = min(1, max(0, (z - 1.5)))
        joints += [0, 1, 0, 0]
        weights += [1 - w, w, 0, 0]
for k in range(rings - 1):
    for i in range(around):
        a = k * columns + i
        triangles += [a, a + 1, a + columns, a + 1, a + 1 + columns, a + columns]
n = columns * rings
identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
shifted = identity[:14] + [-2, 1]
keys = 9
turns = [x for k in range(keys) for x in (math.sin(0.6 * k / (keys - 1)), 0, 0, math.cos(0.6 * k / (keys - 1)))]
parts = [("<%df" % (3 * n), points, 5126, "VEC3", n), ("<%dH" % (4 * n), joints, 5123, "VEC4", n),
         ("<%df" % (4 * n), weights, 5126, "VEC4", n), ("<%dI" % len(triangles), triangles, 5125, "SCALAR", len(triangles)),
         ("<32f", identity + shifted, 5126, "MAT4", 2), ("<%df" % keys, [k / 10 for k in range(keys)], 5126, "SCALAR", keys),
         ("<%df" % (4 * keys), turns, 5126, "VEC4", keys), ("<%df" % (2 * n), texture, 5126, "VEC2", n)]
data, views, accessors = b"", [], []
for form, values, kind, shape, count in parts:
    bytes_ = struct.pack(form, *values)
    views.append(dict(buffer=0, byteOffset=len(data), byteLength=len(bytes_)))
    accessors.append(dict(bufferView=len(views) - 1, componentType=kind, type=shape, count=count))
    data += bytes_
accessors[0].update(min=[-.5, -.5, 0], max=[.5, .5, length])
accessors[5].update(min=[0], max=[(keys - 1) / 10])
gltf = dict(asset=dict(version="2.0"), scene=0, scenes=[dict(nodes=[0, 2])],
            nodes=[dict(name="root", children=[1]), dict(name="elbow", translation=[0, 0, 2]), dict(mesh=0, skin=0)],
            meshes=[dict(primitives=[dict(attributes=dict(POSITION=0, JOINTS_0=1, WEIGHTS_0=2, TEXCOORD_0=7), indices=3)])],
            skins=[dict(joints=[0, 1], inverseBindMatrices=4)],
            animations=[dict(name="bend", samplers=[dict(input=5, output=6)],
                             channels=[dict(sampler=0, target=dict(node=1, path="rotation"))])],
            accessors=accessors, bufferViews=views, buffers=[dict(byteLength=len(data))])
text = json.dumps(gltf).encode()
text += b" " * (-len(text) % 4)
with open("arm.glb", "wb") as f:
    f.write(b"glTF" + struct.pack("<III", 2, 28 + len(text) + len(data), len(text)) + b"JSON" + text)
    f.write(struct.pack("<I", len(data)) + b"BIN\0" + data)
END
"$program" arm.glb --ratio 0.2 -o coarse --format glb >out 2>err
code=$?
if grep -qF "built without" err; then
  echo "SKIPPED: models, since the program was built without what reads glTF"
elif [[ $code -ne 0 ]]; then
  fail "arm.glb: exit code $code: $(head -c 300 err)"
else
  expect 2 "would be lost" arm.glb --ratio 0.2 -o arm --format glb
  expect 0 "" arm.glb --ratio 0.2 -o coarse
  expect 0 "" coarse.glb --ratio 1 -o read_back
  python3 - <<'END' || fail "what is read from the model that was written"
import json, math, struct
def cache(name):
    data = open(name, "rb").read()
    points, frames = struct.unpack_from("<i", data, 16)[0], struct.unpack_from("<i", data, 28)[0]
    return [[struct.unpack_from("<3f", data, 32 + 12 * (f * points + v)) for v in range(points)] for f in range(frames)]
bound, read = cache("coarse.pc2"), cache("read_back.pc2")
assert len(bound) == len(read) and len(bound[0]) == len(read[0]), (len(bound), len(read))
far = [max(math.dist(p, q) for p, q in zip(bound[f], read[f])) for f in range(len(bound))]
# blending at the joint moves a vertex that stands for several with other weights: by less than half of an edge, and few
rest = [[float(x) for x in row.split()[1:4]] for row in open("coarse.obj") if row.startswith("v ")]
faces = [[int(c.split("/")[0]) - 1 for c in row.split()[1:]] for row in open("coarse.obj") if row.startswith("f ")]
edges = [math.dist(rest[t[i]], rest[t[i - 1]]) for t in faces for i in range(3)]
last = sorted(math.dist(p, q) for p, q in zip(bound[-1], read[-1]))
assert far[0] < 1e-5 and max(far) < 0.5 * sum(edges) / len(edges), (max(far), sum(edges) / len(edges))
assert last[len(last) * 9 // 10] < 0.05, last
data = open("coarse.glb", "rb").read()
gltf = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
assert gltf["animations"][0]["name"] == "bend" and gltf["nodes"][1]["name"] == "elbow"
END
  # The seam stays, and no triangle is drawn across the texture.
  expect 0 "" arm.glb --ratio 0.2 --keep-seams -o seam --format glb
  python3 - <<'END' || fail "--keep-seams"
import json, math, struct
data = open("seam.glb", "rb").read()
size = struct.unpack_from("<I", data, 12)[0]
gltf, binary = json.loads(data[20:20 + size]), 28 + size
def read(i):
    a = gltf["accessors"][i]
    start = binary + gltf["bufferViews"][a["bufferView"]].get("byteOffset", 0) + a.get("byteOffset", 0)
    width, letter = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[a["type"]], {5126: "f", 5125: "I"}[a["componentType"]]
    values = struct.unpack_from("<%d%s" % (width * a["count"], letter), data, start)
    return [values[k:k + width] for k in range(0, len(values), width)]
primitive = gltf["meshes"][0]["primitives"][0]
points, places = read(primitive["attributes"]["POSITION"]), read(primitive["attributes"]["TEXCOORD_0"])
corners = [i for i, in read(primitive["indices"])]
assert len(points) == len(places) and 106 + 30 < len(points) < 106 + 40, len(points)
for (x, y, z), (u, v) in zip(points, places):
    far = u - math.atan2(y, x) / (2 * math.pi)
    assert abs(far - round(far)) < 0.02 and abs(v - z / 4) < 0.02, (x, y, z, u, v)
assert sum(u == 0 for u, v in places) == sum(u == 1 for u, v in places) == 33
for k in range(0, len(corners), 3):
    us = [places[c][0] for c in corners[k:k + 3]]
    assert max(us) - min(us) < 0.5, us
END
  expect 2 "cut along 33" arm.glb --vertices 33 --keep-seams -o x
  expect 3 "no texture coordinates" coarse.glb --ratio 0.5 --keep-seams -o x
fi
expect 2 "--format glb" in.obj in.pc2 --ratio 0.5 --format glb -o x
expect 2 "--keep-seams" in.obj in.pc2 --ratio 0.5 --keep-seams -o x

expect 0 "" --help
grep -qF "Exit codes" out || fail "--help"
expect 0 "" --version
expect 2 "how much is to be left" in.obj in.pc2 -o x
expect 2 "how much is to be left" in.obj in.pc2 --vertices 50 --ratio 0.5 -o x
expect 2 "where to write" in.obj in.pc2 --vertices 50
expect 2 "more than 1" in.obj in.pc2 --ratio 1.5 -o x
expect 2 "--ratio" in.obj in.pc2 --ratio 0 -o x
expect 2 "not fewer" in.obj in.pc2 --lods 0.1,0.5 -o x
expect 2 "the mesh has $vertices" in.obj in.pc2 --vertices 100000 -o x
expect 2 "takes" in.obj in.pc2 --vertices 2 -o x
expect 2 "--guidance" in.obj in.pc2 --ratio 0.5 --guidance 3 -o x
expect 2 "--normals" in.obj in.pc2 --ratio 0.5 --normals 90 -o x
expect 2 "--support" in.obj in.pc2 --ratio 0.5 --support 0 -o x
expect 2 "--refinements" in.obj in.pc2 --ratio 0.5 --refinements -1 -o x
expect 2 "--poses" in.obj in.pc2 --ratio 0.5 --poses 0 -o x
expect 2 "would be lost" in.obj in.pc2 --ratio 0.5 -o in
expect 2 "--also" in.obj in.pc2 --ratio 0.5 --also other.pc2 --format ply -o x
expect 3 "nowhere" in.obj nowhere.pc2 --ratio 0.5 -o x
"$generator" cylinder --vertices 900 --frames 5 -o larger >/dev/null
expect 3 "points" in.obj in.pc2 --ratio 0.5 --also larger.pc2 -o x
expect 4 "cannot write" in.obj in.pc2 --ratio 0.5 -o nowhere/x
[[ -z "$(find . -name 'x*')" && -z "$(find . -name '*.tmp')" ]] || fail "files are left after errors"

[[ $failed -eq 0 ]] && echo "simplify_animation: all as expected"
exit $failed
