#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The pictures that detect_features writes: every option, decoded by a reader of PNG in Python.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without python3, the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation python3
enter_empty_folder
export SCENE_FILES="$tests/scene_files"

"$generator" cylinder --vertices 1000 --fps 10 -o c >/dev/null || fail "make_animation"

"$program" c.obj c.pc2 --fps 10 --png x.png --png-size 300x200 -q 2>err
if grep -q "built without pictures" err; then
  [[ ! -e x.png ]] || fail "a picture in spite of an error"
  echo "skipped: the program was built without pictures"
  exit $((failed ? 1 : 77))
fi

cat >png.py <<'PYTHON'
import os, sys

sys.path.insert(0, os.environ["SCENE_FILES"])
from png_file import read_png as rows


def body(picture):
    """The bounding box of what is neither white nor a grey shadow, between the label and the legend."""
    h = len(picture)
    inside = [(x, y) for y in range(h // 8, h * 7 // 8) for x, p in enumerate(picture[y]) if max(p) - min(p) > 10]
    return [f(i) for i in zip(*inside) for f in (min, max)]


names = {n: rows(n + ".png") for n in sys.argv[2].split(",")}
ok = eval("(" + sys.argv[1] + ")", {**names, "body": body, "size": lambda p: (len(p[0]), len(p))})
sys.exit(0 if ok else 1)
PYTHON

# check <python expression> <pictures, separated by commas>
check() {
  checks=$((checks + 1))
  python3 png.py "$1" "$2" || fail "$1"
}

# picture <name> <options...>
picture() {
  local name="$1"
  shift
  checks=$((checks + 1))
  rm -f "$name.png"
  "$program" c.obj c.pc2 --fps 10 -q --png "$name.png" "$@" >out 2>err </dev/null || fail "$*: $(cat err)"
  [[ ! -s out ]] || fail "$*: something on the standard output"
}

# refuses <part of the message> <options...>: exit code 2, and no picture
refuses() {
  local message="$1"
  shift
  checks=$((checks + 1))
  rm -f x.png
  "$program" c.obj c.pc2 --fps 10 -q "$@" >out 2>err </dev/null
  local code=$?
  [[ $code -eq 2 ]] || fail "$*: exit code $code, not 2: $(head -c 300 err)"
  grep -qF -- "$message" err || fail "$*: no message \"$message\" but: $(head -c 300 err)"
  [[ ! -e x.png && -z "$(find . -name '.*.tmp')" ]] || fail "$*: files in spite of an error"
}

check 'size(x) == (300, 200)' x

picture one --frame 10 --png-size 200x160
check 'size(one) == (200, 160) and one[0][0] == one[80][3] == one[159][199] == (255, 255, 255)' one
picture again --frame 10 --png-size 200x160 --threads 1
cmp -s one.png again.png || fail "other pixels with one thread"
picture other --frame 12 --png-size 200x160
cmp -s one.png other.png && fail "--frame has no effect"
picture two --frame 10 --frame 12 --png-size 400x160
# a body in each half
check 'all(any(min(p) < 170 for row in two[40:120] for p in row[i:i + 200]) for i in (0, 200))' two
picture night --frame 10 --png-size 200x160 --png-background 10203f
check 'night[0][0] == (16, 32, 63)' night
# The cylinder stands upright along z: lying, it is wider than high.
picture upright --frame 0 --png-size 240x240 --view 0,0
picture same --frame 0 --png-size 240x240 --view 0,0 --up z
cmp -s upright.png same.png || fail "the up axis is not found"
picture lying --frame 0 --png-size 240x240 --view 0,0 --up y
check '(lambda a, b, c, d: d - c > 2 * (b - a))(*body(upright))' upright
check '(lambda a, b, c, d: d - c > 2 * (b - a))(*body(lying)) == False' lying
picture above --frame 0 --png-size 240x240 --view 0,80
cmp -s upright.png above.png && fail "--view has no effect"
picture behind --frame 10 --png-size 200x160 --view=-30,-20
cmp -s one.png behind.png && fail "--view has no effect"

# Views by name are those by angles, the automatic one is the default, and it is told.
picture front --frame 3 --png-size 200x160 --view front
picture told --frame 3 --png-size 200x160 --view=-90,0
cmp -s front.png told.png || fail "the front is not at -y where z points up"
picture left --frame 3 --png-size 200x160 --view left
cmp -s front.png left.png && fail "left is front"
picture auto --frame 10 --png-size 200x160 --view auto
cmp -s one.png auto.png || fail "the default view is not auto"
checks=$((checks + 1))
"$program" c.obj c.pc2 --fps 10 -q --views v.json --view-map map.png --up z || fail "--views"
python3 - <<'PYTHON' || fail "v.json: $(head -c 600 v.json)"
import json, math

d = json.load(open("v.json"))
assert d["format"] == "animated-mesh-features-views" and d["up"] == [0, 0, 1] and d["score"] == "features", d
assert 1 <= len(d["views"]) <= 3 and all(0 <= f < 20 for f in d["frames"])
for i, v in enumerate(d["views"]):
    assert v["rank"] == i + 1 and 0 < v["score"] <= v["covered"] + 0.01 <= 1.02 and 4.99 <= v["elevation"] <= 50.01
    a, e = math.radians(v["azimuth"]), math.radians(v["elevation"])
    there = (math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e))
    assert max(abs(x - y) for x, y in zip(there, v["direction"])) < 1e-3
assert all(a["covered"] <= b["covered"] for a, b in zip(d["views"], d["views"][1:]))
assert d["views"][-1]["covered"] <= d["visible"] <= 1
assert all(abs(v["covered_of_visible"] * d["visible"] - v["covered"]) < 2e-4 for v in d["views"])
keys = d["camera"]["keys"]
for a, b in zip(keys, keys[1:]):
    cosine = sum(x * y for x, y in zip(a["direction"], b["direction"]))
    assert math.degrees(math.acos(min(1, cosine))) <= 45.1 * (b["time"] - a["time"]), (a, b)
PYTHON
check 'size(map) == (1920, 1120)' map

refuses "there is no frame 20 to be shown; frames are 0 to 19" --png x.png --frame 20
refuses "no number" --png x.png --frame last
refuses "--frame goes with --png" --frame 1 -o json:x.png
refuses "--png-size goes with --png" --png-size 100x100 -o json:x.png
refuses "--view goes with --png" --view 1,2 -o json:x.png
refuses "--up goes with --png" --up z -o json:x.png
refuses "--png-background goes with --png" --png-background ffffff -o json:x.png
refuses "64 to 16384" --png x.png --png-size 10x100
refuses "too large" --png x.png --png-size 16384x16384
refuses "no size" --png x.png --png-size 100
refuses "no number" --png x.png --png-size 100xbig
refuses "pair of angles" --png x.png --view 30
refuses "no number" --png x.png --view 30,high
refuses "is no view: auto, front" --png x.png --view sideways
refuses "the ending" --view-map map.doc
refuses "less than 90" --png x.png --view 30,90
refuses "choose among x, y, z" --png x.png --up w
refuses "no colour" --png x.png --png-background white
refuses "same file" --png x.png -o json:x.png

echo "$checks checks"
exit $failed
