#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Animated models from files: what the package reads from glTF against an independent evaluation, on made files and on real
# ones; detect_features with models.
# DETECT_FEATURES is the program and TEST_ANIMATED_MODELS the test that writes what is read, WITH_FORMATS says which
# libraries they were built with. Real files are fetched to ASSETS; a part that cannot run here is told as SKIPPED.

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
dump="${TEST_ANIMATED_MODELS:-}"
formats="${WITH_FORMATS:-}"
needs detect_features python3
[[ -n "$dump" && " $formats " == *" tinygltf "* ]] || skip "needs TEST_ANIMATED_MODELS and tinygltf"
assets="${ASSETS:-$PWD/assets}"
enter_empty_folder

python3 "$tests/model_files/check_gltf.py" "$dump" || fail "made files"

cube=/usr/share/assimp/models/glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf
if [[ -f "$cube" ]]; then
  python3 "$tests/model_files/check_gltf.py" "$dump" "$cube" Square 127 8 || fail "AnimatedMorphCube"
else
  echo "SKIPPED: AnimatedMorphCube, since Debian's package assimp-testmodels is not here"
fi

# The program: a buffer of a model is an input that no output replaces; names do not reach the terminal as they are.
python3 - <<'PYTHON'
import json, struct
floats = [0, 0, 0, 1, 0, 0, 0, 1, 0] + [0, 1, 2] + [0, 0, 0, 0, 0, 1, 0, 0, 0]
open("linked.bin", "wb").write(struct.pack("<21f", *floats))
views = [dict(buffer=0, byteOffset=o, byteLength=n) for o, n in ((0, 36), (36, 12), (48, 36))]
accessors = [dict(bufferView=i, componentType=5126, count=3, type=t) for i, t in enumerate(("VEC3", "SCALAR", "VEC3"))]
json.dump(dict(asset=dict(version="2.0"), buffers=[dict(uri="linked.bin", byteLength=84)], bufferViews=views,
               accessors=accessors, nodes=[dict(mesh=0)], meshes=[dict(primitives=[dict(attributes=dict(POSITION=0))])],
               animations=[dict(name="a\x1b[31mred\n", samplers=[dict(input=1, output=2)],
                                channels=[dict(sampler=0, target=dict(node=0, path="translation"))])]),
          open("linked.gltf", "w"))
PYTHON
expect 2 "is the input" linked.gltf -o json:linked.bin
[[ "$(wc -c <linked.bin)" -eq 84 ]] || fail "a buffer of the model was overwritten"
expect 2 "clips are 0 \"a" linked.gltf --clip none
LC_ALL=C grep -q $'\x1b' err && fail "a command for the terminal, from the name of a clip"
mkdir elsewhere
mv linked.bin elsewhere
sed -i 's,linked.bin,../elsewhere/linked.bin,' linked.gltf
mkdir model
mv linked.gltf model
expect 3 "is not in the model's folder" model/linked.gltf
expect 2 "there is no clip" model/linked.gltf --allow-outside --clip none

# All clips of a model, each by itself: two sheets with a bump that rises and falls, once, twice, or not at all.
python3 - <<'PYTHON'
import base64, json, math, struct
n, keys = 14, 25
grid = [(x / n, y / n) for y in range(n + 1) for x in range(n + 1)]
points = [c for x, y in grid for c in (x, y, 0)]
bump = [c for x, y in grid for c in (0, 0, 0.3 * math.exp(-((x - 0.5) ** 2 + (y - 0.4) ** 2) / 0.02))]
corners = [y * (n + 1) + x + d for y in range(n) for x in range(n) for d in (0, 1, n + 1, 1, n + 2, n + 1)]
data, views, accessors = b"", [], []


def add(values, code, kind, components):
    global data
    part = struct.pack("<%d%s" % (len(values), code), *values)
    views.append(dict(buffer=0, byteOffset=len(data), byteLength=len(part)))
    accessors.append(dict(bufferView=len(views) - 1, componentType=5126 if code == "f" else 5125, type=kind,
                          count=len(values) // components))
    data += part
    return len(views) - 1


mesh = dict(name="sheet", primitives=[dict(attributes=dict(POSITION=add(points, "f", "VEC3", 3)),
                                           indices=add(corners, "I", "SCALAR", 1),
                                           targets=[dict(POSITION=add(bump, "f", "VEC3", 3))])])
times = add([i / (keys - 1) for i in range(keys)], "f", "SCALAR", 1)


def animation(name, weight):
    weights = add([weight(i / (keys - 1)) for i in range(keys)], "f", "SCALAR", 1)
    return dict(name=name, samplers=[dict(input=times, output=weights)],
                channels=[dict(sampler=0, target=dict(node=node, path="weights")) for node in (1, 2)])


clips = [animation("Rise", lambda t: math.exp(-((t - 0.5) / 0.15) ** 2)),
         animation("rise", lambda t: math.exp(-((t - 0.3) / 0.1) ** 2) + math.exp(-((t - 0.7) / 0.1) ** 2)),
         animation("up/down", lambda t: math.exp(-((t - 0.4) / 0.12) ** 2)), animation("Still", lambda t: 0.)]
clips.append(dict(name="Empty", samplers=[], channels=[]))
json.dump(dict(asset=dict(version="2.0"), scene=0, scenes=[dict(nodes=[0])], meshes=[mesh], accessors=accessors,
               nodes=[dict(name="all", children=[1, 2]), dict(name="left", mesh=0, weights=[0]),
                      dict(name="right", mesh=0, weights=[0], translation=[2, 0, 0])],
               animations=clips, bufferViews=views,
               buffers=[dict(byteLength=len(data), uri="data:application/octet-stream;base64," +
                             base64.b64encode(data).decode())]), open("sheets.gltf", "w"))
PYTHON
expect 3 "1 of 5 clips left out: Empty" sheets.gltf --clip all -o results/ -o csv:results/ --vtk 'scenes/{clip}' --part right
grep -q "detect_features: Empty is left out: sheets.gltf: clip \"Empty\" has no duration" err || fail "Empty: $(cat err)"
grep -q "^5 clips, .*; written to results/, results/, scenes/{clip}$" err || fail "no last line: $(cat err)"
got="$(LC_ALL=C ls results | tr '\n' ' ')"
[[ "$got" == "Rise.csv Rise.json Still.csv Still.json rise_1.csv rise_1.json up_down.csv up_down.json " ]] || fail "files: $got"
[[ -f scenes/up_down/surface.pvd && ! -e scenes/Empty ]] || fail "folders: $(ls scenes)"
cp out table
for clip in Rise rise up/down; do
  name="${clip/\//_}"
  [[ "$clip" != rise ]] || name=rise_1
  expect 0 "" sheets.gltf --clip "$clip" --part right -o one.json
  cmp -s one.json "results/$name.json" || fail "$clip among all is another than alone"
  # a line of the table, by the same numbers
  python3 - "$clip" <<'PYTHON' || fail "the table: $(cat table)"
import json, sys
line = next(l for l in open("table") if l.startswith(sys.argv[1] + " ")).split()
x = json.load(open("one.json"))
best = x["features"][0]
assert all(f["file_vertices"] == [f["vertex"] + 225] for f in x["features"]) and x["animation"]["vertices"] == 225
assert (int(line[1]), int(line[3]), int(line[5])) == (x["animation"]["frames"], len(x["features"]), best["vertex"])
assert abs(float(line[4]) - best["time"]) < 1e-3 and abs(float(line[8]) - best["strength"]) < 1e-2 * best["strength"]
PYTHON
done
grep -q "^Still .* 0  nothing deforms" table && grep -q "^Empty .*left out: " table || fail "the table: $(cat table)"
mkdir few
sed 's/"animations"/"others"/' sheets.gltf >nothing.gltf
expect 3 "nothing.gltf: holds no animation" nothing.gltf --clip all
expect 2 "each clip has files of its own; name a folder, x.json/, or write {clip}" sheets.gltf --clip all -o x.json
expect 2 "cannot all go to the standard output" sheets.gltf --clip all -o -
expect 2 "a folder goes with --clip all" sheets.gltf -o few/
expect 3 "there is no part" sheets.gltf --clip all --part middle -o few/
[[ -z "$(ls few)" ]] || fail "files of clips that were left out: $(ls few)"

# Other formats: that the program knows them, or says what it lacks.
fbx=/usr/share/assimp/models/FBX/animation_with_skeleton.fbx
echo text >text.fbx
if [[ " $formats " != *" assimp "* ]]; then
  expect 3 "text.fbx: this program was built without assimp" text.fbx
else
  expect 3 "text.fbx: cannot be read through assimp" text.fbx
  if [[ -f "$fbx" ]]; then
    expect 0 "best effort" "$fbx" --verbose -o fbx.json
    grep -qF "1058 vertices, 2112 triangles, 61 frames" err || fail "FBX: $(cat err)"
    models=/usr/share/assimp/models
    python3 "$tests/model_files/check_assimp.py" "$dump" "$fbx" 9 $models/FBX/huesitos.fbx 9 $models/X/BCN_Epileptic.X 5 \
      $models/Collada/box_nested_animation.dae 5 ||
      fail "FBX, X and Collada in motion"
  else
    echo "SKIPPED: FBX, since Debian's package assimp-testmodels is not here"
  fi
  python3 "$tests/model_files/check_assimp.py" "$dump" || fail "Collada"
fi
echo text >text.h5
if [[ " $formats " != *" HDF5 "* ]]; then
  expect 3 "text.h5: this program was built without HDF5" text.h5
else
  "$dump" sheet sheet.h5 || fail "cannot write an HDF5 file"
  cp sheet.h5 sheet
  expect 3 "has no dataset \"faces\"" sheet.h5
  expect 2 'there is no clip "walk"; clips are 0 "50002_sheet"' sheet.h5 --faces triangles --clip walk
  expect 2 "--frames goes with" sheet.h5 --faces triangles --frames 9
  expect 0 "" sheet --faces triangles --clip 50002_sheet -o sheet.json
  python3 - <<'PYTHON' || fail "HDF5"
import json
x = json.load(open("sheet.json"))
a, p = x["animation"], x["parameters"]
assert (a["vertices"], a["faces"], a["frames"]) == (400, 722, 30) and abs(p["fps"] - 60) < 1e-9
assert (p["clip"], p["faces"], p["frames"]) == ("50002_sheet", "triangles", None) and "parts" not in a
PYTHON
fi

hands=true
"$tests/../../scripts/fetch_hands.sh" "$assets"
case $? in
  0) ;;
  77) hands=false ;;
  *) fail "the hands" ;;
esac
if ! $hands; then
  echo "SKIPPED: the hands, and with them the program's options for models"
  exit $failed
fi
right="$assets/rightHandHigh.glb"
left="$assets/leftHandHigh.glb"
python3 "$tests/model_files/check_gltf.py" "$dump" "$right" Fist 9 1162 "$left" "Point + Thumb" 4 1162 || fail "the hands"

# ----------------------------------------------------------------------------------------------------- the program

cp "$right" hand.glb
cp "$left" left.glb
expect 0 "" hand.glb --clip Fist --there-and-back --rest first --verbose -o x.json -o x.csv --vertex-map map.csv
grep -qF 'clips: 0 "Grip", 1 "Thumb Up", 2 "Hold", 3 "Point", 4 "Fist"' err || fail "no list of clips: $(cat err)"
grep -qF "1162 vertices, 2320 triangles, 95 frames" err || fail "--verbose: $(cat err)"
grep -qF "1425 vertices of the file became 1162" err || fail "nothing about welding: $(cat err)"
grep -qF "Unboring" err || fail "nothing about the author: $(cat err)"
python3 - <<'PYTHON' || fail "the outputs for a model"
import csv, json
x = json.load(open("x.json"))
a, p = x["animation"], x["parameters"]
assert (a["vertices"], a["faces"], a["frames"]) == (1162, 2320, 95) and abs(a["frame_duration"] * 47 - 0.25) < 1e-6
assert (p["clip"], p["frames"], p["there_and_back"]) == ("Fist", 48, True)
assert a["parts"] == [{"name": "node 16 (handR2320), mesh 0, primitive 0", "first_vertex": 0, "vertices": 1425}]
rows = list(csv.DictReader(open("map.csv")))
assert sorted(int(r["file_vertex"]) for r in rows) == list(range(1425))
assert {int(r["vertex"]) for r in rows} == set(range(1162))
of = {}
for r in rows:
    of.setdefault(int(r["vertex"]), []).append(int(r["file_vertex"]))
assert len(x["features"]) > 3 and all(f["file_vertices"] == of[f["vertex"]] for f in x["features"])
table = list(csv.DictReader(open("x.csv")))
assert [[int(v) for v in r["file_vertices"].split()] for r in table] == [f["file_vertices"] for f in x["features"]]
PYTHON

# The parameters are all that is needed to do it again; a clip by number is the same, and so is a name without ending.
fps="$(python3 -c 'import json; print(json.load(open("x.json"))["parameters"]["fps"])')"
expect 0 "" hand.glb --clip Fist --frames 48 --there-and-back --rest first --fps "$fps" -o again.json
cmp -s x.json again.json || fail "the parameters give another result"
cp hand.glb hand
expect 0 "" hand --clip 4 --there-and-back --rest first -o number.json
[[ "$(sed 's/.*"inputs".*//' number.json)" == "$(sed 's/.*"inputs".*//' x.json)" ]] || fail "another result by number"
expect 0 'clip Grip, the first of 0 "Grip", 1 "Thumb Up"' hand.glb --frames 12 --tau-range :0.05 -o y.json
expect 0 "" hand.glb --fps 100 --clip Fist --tau-range :0.05 -o y.json
python3 - <<'PYTHON' || fail "a rate"
import json
y = json.load(open("y.json"))
assert y["animation"]["frames"] == 26 and y["animation"]["frame_duration"] == 0.01 and y["parameters"]["frames"] is None
PYTHON

# A mirrored hand has the same features; the left hand is one in its bones and skin, but makes a fist of its own.
compare=(python3 "$tests/model_files/compare_hands.py")
fist=(--clip Fist --there-and-back --quiet)
"${compare[@]}" mirror hand.glb mirrored.glb || fail "mirroring"
expect 0 "" mirrored.glb "${fist[@]}" --rest first -o mirrored.json
"${compare[@]}" exact x.json mirrored.json || fail "a mirror image has other features"
# from scales on at which the meshes of the two hands, which are not the same, resolve the same
fist+=(--sigma-range 1%:)
longer=(--threshold 0.03 --min-fit 0.4)
expect 0 "" hand.glb "${fist[@]}" "${longer[@]}" -o right.json
expect 0 "" left.glb "${fist[@]}" "${longer[@]}" -o left.json
for hand in right left; do
  cp "$assets/${hand}HandHigh.glb" either.glb
  expect 0 "" either.glb "${fist[@]}" --threshold 0.02 --min-fit 0 --no-suppression -o "all_$hand.json"
done
"${compare[@]}" alike right.json left.json all_right.json all_left.json hand.glb Fist || fail "the hands differ"

rm -f x.json
for what in "2|there is no clip \"Wave\"; clips are 0 \"Grip\"|hand.glb --clip Wave" \
  "2|no clip|hand.glb --clip 7" \
  "2|--frames: at least 3|hand.glb --frames 2" \
  "2|shorter than a frame|hand.glb --fps 1" \
  "2|--there-and-back goes with|a.obj b.obj c.obj --there-and-back" \
  "2|--faces goes with|hand.glb --faces f" \
  "3|must be the only input|hand.glb left.glb" \
  "3|missing.glb: cannot read|missing.glb" \
  "3|text.glb: is no readable glTF 2.0|text.glb" \
  "3|cut.glb: is no readable glTF 2.0|cut.glb" \
  "2|--clip goes with|a.obj b.obj c.obj --clip x" \
  "2|--frames goes with|a.obj b.obj c.obj --frames 5" \
  "4|nowhere/map.csv: cannot write|hand.glb --vertex-map nowhere/map.csv"; do
  echo text >text.glb
  head -c 100000 hand.glb >cut.glb
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' | tee a.obj b.obj >c.obj
  IFS='|' read -r code message arguments <<<"$what"
  # shellcheck disable=SC2086
  expect "$code" "$message" $arguments -o x.json
  [[ ! -e x.json ]] || fail "x.json in spite of an error: $arguments"
done

[[ $failed -eq 0 ]] && echo "glTF and detect_features: all as expected"
exit $failed
