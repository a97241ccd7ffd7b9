#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# compare_animations on generated animations: distances and maps that must be what they are, collections with what is broken
# in them, a check of two takes; files and exit codes. What is computed is tested by test_comparison.cpp.
# DETECT_FEATURES, MAKE_ANIMATION and COMPARE_ANIMATIONS are the programs; without them, or without python3, the test is
# skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation compare_animations python3
enter_empty_folder

mkdir set
"$generator" figure --vertices 1000 --frames 36 -o set/a >/dev/null || fail "make_animation"
"$generator" figure --vertices 1300 --frames 18 --fps 15 -o set/b >/dev/null || fail "make_animation"
"$generator" cylinder --vertices 700 --frames 36 -o set/c >/dev/null || fail "make_animation"
"$program" set/a.obj set/a.pc2 --quiet -o a.json || fail "detect_features"
program="$comparer"

cat >tool.py <<'PYTHON'
import json, math, struct, sys


def load(name):
    with open(name + ".json") as file:
        return json.load(file, parse_constant=lambda c: sys.exit(name + ".json contains " + c))


def npy_shape(path):
    data = open(path, "rb").read()
    length = struct.unpack("<H", data[8:10])[0]
    return eval(data[10:10 + length])["shape"]


def late(pair):
    """The largest difference of mapped times, which are the same in both."""
    a = pair["alignment"]
    return max(abs(s - t) for s, t in zip(a["times_a"], a["times_b"]))


names = dict(globals(), **{n: load(n) for n in sys.argv[2:]})
sys.exit(0 if eval("(" + sys.argv[1] + ")", names) else 1)
PYTHON

# check <python expression> <JSON files without ending...>
check() {
  checks=$((checks + 1))
  python3 tool.py "$@" || fail "$1"
}

# --------------------------------------------------------------------------------------------------------- two animations

expect 0 "" set/a.pc2 set/a.pc2 -o same.json --cache . --tolerance 0 --check
check "same['distance'] == 0 and same['alignment']['cost'] == 0 and same['exceeding'] == 0 and late(same) < 1e-9
       and all(m['a'] == m['b'] for m in same['matches']) and len(same['matches']) > 5" same
grep -q "matched features" out || fail "no table"
[[ $(ls ./*.signature | wc -l) -eq 1 ]] || fail "no cache"
expect 0 "" set/a.pc2 set/b.obj,set/b.pc2 --fps 15 -o other.json --cache . # a's rate is told wrongly: another signature
expect 0 "" set/a.pc2 set/a.obj,set/a.pc2 -o again.json --cache .
cmp -s same.json again.json || check "{**same, 'differences': 0} == {**again, 'differences': 0}" same again
echo broken >"$(ls ./a.*.signature | head -1)"
expect 0 "" set/a.pc2 a.json -q -o features.json --cache . # a file of features: no descriptors, the same times
check "features['alignment']['confidence'] >= 0 and features['b']['features'] == features['a']['features']" features
expect 0 "" describe set/a.pc2 -o described.json --write-descriptors described.npy
check "npy_shape('described.npy') == (len(described['features']), 100) and described['length'] == 100
       and all(abs(math.hypot(*f['descriptor']) - 1) < 1e-5 for f in described['features'])" described
expect 0 "" describe set/a.pc2 --descriptor oriented -o oriented.json
check "oriented['length'] == 192" oriented

# what is kept is found again, unless a file or an option is another one
mkdir kept changed && cp set/a.obj set/a.pc2 changed
kept() { ls kept | wc -l; }
for number in 1 1; do
  expect 0 "" describe changed/a.pc2 --cache kept -q
  [[ $(kept) -eq $number ]] || fail "$(kept) signatures, not $number"
done
expect 0 "" describe changed/a.pc2 --cache kept -q --threshold 0.2
[[ $(kept) -eq 2 ]] || fail "another threshold, the same signature"
expect 0 "" describe changed/a.pc2 --cache kept -q --cyclic
[[ $(kept) -eq 3 ]] || fail "a loop, the same signature"
python3 - <<'PYTHON'
data = bytearray(open("changed/a.pc2", "rb").read())
data[-2] ^= 1
open("changed/a.pc2", "wb").write(data)
PYTHON
expect 0 "" describe changed/a.pc2 --cache kept -q
[[ $(kept) -eq 4 ]] || fail "another file, the same signature"

# the same as a loop, from its 8th frame on: the same events, features and distance 0
python3 - <<'PYTHON'
import struct
data = open("set/a.pc2", "rb").read()
n, frames = struct.unpack("<I", data[16:20])[0], struct.unpack("<I", data[28:32])[0]
first = 32 + 7 * 12 * n
open("set/rotated.pc2", "wb").write(data[:32] + data[first:] + data[32:first])
PYTHON
expect 0 "" set/a.obj,set/a.pc2 set/a.obj,set/rotated.pc2 --cyclic -o loops.json --cache .
check "loops['distance'] < 1e-5 and loops['alignment']['cost'] < 1e-5 and len(loops['matches']) == loops['a']['features'] > 5
       and abs(loops['alignment']['phase'] - 7 / loops['a']['frames']) < 1e-4 and loops['alignment']['confidence'] > 0.5
       and max(abs((m['time_a'] - m['time_b']) * 30 % loops['a']['frames'] - 7) for m in loops['matches']) < 1e-3
       and len(loops['events']['only_a']) == 0 and max(d['difference'] for d in loops['differences']) < 1e-4" loops
printf '%s\n' 'set/a.obj set/a.pc2 --cyclic' 'set/a.obj set/rotated.pc2 --cyclic' >loops.txt
expect 0 "" matrix loops.txt --cache . -o listed.json
check "listed['distances'][0][1] == loops['distance'] and all(x['cyclic'] for x in listed['animations'])" listed loops
expect 0 "" set/a.obj,set/a.pc2 set/a.obj,set/rotated.pc2 -o ends.json --cache . # not told: another signature, another motion
check "ends['distance'] > 0.05 and not ends['a']['cyclic'] and ends['alignment']['loops'] == [0, 0]" ends

# a take without its strongest event, and one more time
python3 - <<'PYTHON'
import json
take = json.load(open("a.json"))
gone = take["features"].pop(0)
json.dump(take, open("take.json", "w"))
print(gone["amplitude"])
PYTHON
expect 1 "by more than the tolerance" a.json take.json --check --tolerance 0.01 -o differ.json
check "differ['differences'][0]['in'] == 'A only' and differ['exceeding'] == 1" differ
expect 0 "" a.json take.json --check --tolerance 1000

# ------------------------------------------------------------------------------------------------------------ collections

cat >list.txt <<'LIST'
# a comment, and files with their own frame rates
set/a.obj set/a.pc2
set/b.obj set/b.pc2 --fps 15
set/c.obj set/c.pc2
LIST
expect 0 "" matrix list.txt --cache . -o matrix.json --threads 1
check "[x['name'] for x in matrix['animations']] == ['a', 'b', 'c'] and all(x['pose_variation'] > 0.05 for x in matrix['animations'])
       and all(matrix['distances'][i][j] == matrix['distances'][j][i] for i in range(3) for j in range(3))
       and matrix['distances'][0][1] < 0.5 * matrix['distances'][0][2]" matrix
expect 0 "" matrix list.txt -o threads.json # without the cache, on all threads
check "matrix['distances'] == threads['distances']" matrix threads
# a picture: of each pair a field of the matrix, of each animation a place in the plane, and its name in the PDF
if ! "$program" matrix list.txt --cache . -q --plot matrix.svg 2>&1 | grep -q "built without pictures"; then
  expect 0 "" matrix list.txt --cache . --plot matrix.pdf
  expect 0 "" matrix list.txt --cache . --plot again.svg --threads 1
  [[ -s matrix.svg ]] && cmp matrix.svg again.svg || fail "another picture of the same matrix"
  [[ $(head -c 5 matrix.pdf) == "%PDF-" ]] || fail "matrix.pdf is no PDF"
  expect 0 "" matrix list.txt a.json --cache . --plot more.svg
  [[ $(grep -c "<path" more.svg) -gt $(($(grep -c "<path" matrix.svg) + 6)) ]] || fail "four animations have no more fields than three"
  expect 2 ".svg, .pdf, .png" matrix list.txt --plot matrix.txt
  expect 2 "goes with matrix" a.json a.json --plot pair.svg
fi
expect 0 "" query set/a.pc2 list.txt --cache . -o query.json
check "[r['name'] for r in query['ranking']] == ['a', 'b', 'c'] and query['ranking'][0]['distance'] == 0" query
mkdir other && cp a.json other/a.json && echo '{"format": "animated-mesh-features", "version": 99}' >other/z.json
expect 3 "z is left out" matrix other a.json take.json -o left.json
check "left['left_out'] == 1 and len(left['animations']) == 3 and len(set(x['name'] for x in left['animations'])) == 3" left

# ---------------------------------------------------------------------------------------------------------- what is wrong

python3 - <<'PYTHON'
import json


def changed(name, change):
    data = json.load(open("a.json"))
    change(data, data["animation"], data["features"])
    json.dump(data, open(name + ".json", "w"))


def millimetres(data, animation, features):
    animation["bounding_box_diagonal"] *= 1000
    for f in features:
        f.update(sigma=1000 * f["sigma"], radius=1000 * f["radius"])
        f.update({k: [1000 * x for x in f[k]] for k in ("position", "rest_position")})


def milliseconds(data, animation, features):
    animation["frame_duration"] *= 1000
    for f in features:
        f.update(time=1000 * f["time"], tau=1000 * f["tau"])


changed("nothing", lambda data, animation, features: features.clear())
changed("older", lambda data, animation, features: data.update(version=0))
changed("millimetres", millimetres)
changed("mixed_units", lambda data, animation, features: [
    f.update(rest_position=[1000 * x for x in f["rest_position"]]) for f in features])
changed("milliseconds", milliseconds)
changed("cyclic", lambda data, animation, features: data["parameters"].update(cyclic=True))
changed("twice_as_fast", lambda data, animation, features: animation.update(frame_duration=animation["frame_duration"] / 2))
PYTHON
expect 3 "older.json: has version 0" a.json older.json
expect 0 "" a.json millimetres.json -o millimetres_found.json # another unit is no difference
check "millimetres_found['distance'] < 1e-6 and len(millimetres_found['matches']) == millimetres_found['a']['features']" \
  millimetres_found
expect 3 "mixed_units.json: features are" a.json mixed_units.json
expect 3 "milliseconds.json: the animation lasts" a.json milliseconds.json
expect 0 "" cyclic.json cyclic.json -o cyclic_found.json # a loop, as the file says, from one frame to the same again
check "cyclic_found['a']['cyclic'] and cyclic_found['distance'] == 0 and cyclic_found['alignment']['phase'] == 0
       and cyclic_found['alignment']['loops'] == [cyclic_found['a']['frames'] / 30] * 2" cyclic_found
expect 0 "one rate was told wrongly" a.json twice_as_fast.json
expect 0 "of which more is known" set/a.pc2 a.json --cache .
head -c 700 a.json >torn.json
expect 3 "torn is left out: torn.json: is no valid JSON" matrix a.json take.json torn.json
mkdir one two && cp a.json one/x.json && cp take.json two/x.json
expect 0 "" one/x.json two/x.json -o same_name.json
check "same_name['a']['name'] == 'one/x.json' and same_name['b']['name'] == 'two/x.json'" same_name
expect 0 "" matrix one two -o same_names.json
check "[x['name'] for x in same_names['animations']] == ['one/x.json', 'two/x.json']" same_names
expect 0 "" a.json nothing.json -o nothing_found.json
check "nothing_found['matches'] == [] and nothing_found['distance'] <= 1" nothing_found
expect 2 "two animations are compared" a.json
expect 2 "collection" matrix
expect 2 "goes with two animations" matrix list.txt --check
expect 2 "the weights of cycles" matrix list.txt --variation-weight 2
expect 2 "is in the collection twice" matrix a.json a.json
mkdir empty
expect 3 "there are no animations" matrix empty
expect 3 "missing.json" missing.json a.json
expect 2 "goes with two animations" matrix list.txt --html x.html
if "$program" --help | grep -q -- --html && ! "$program" a.json a.json --html x.html 2>&1 | grep -q "built without the viewer"; then
  expect 2 "a file of features alone" set/a.pc2 a.json --html x.html
  [[ ! -e x.html ]] || fail "a page without a surface"
fi
expect 2 "no such folder" a.json a.json --cache nowhere
expect 2 "rotation-free" a.json a.json --descriptor nonsense
cp a.json kept.json
expect 2 "" a.json take.json -o a.json
cmp -s a.json kept.json || fail "an input was overwritten"
expect 4 "nowhere" a.json take.json -o nowhere/x.json

echo "$checks checks"
exit $failed
