#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# evaluate_features on generated animations: figures that must be what they are, against a plain computation where there is
# one; files and exit codes. What is measured is tested by test_evaluation.cpp.
# DETECT_FEATURES, MAKE_ANIMATION and EVALUATE_FEATURES are the programs; without them, or without python3, the test is
# skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation evaluate_features python3
enter_empty_folder

"$generator" figure --vertices 1500 -o a --events rig.json >/dev/null || fail "make_animation"
"$generator" figure --vertices 1100 --fps 24 -o b >/dev/null || fail "make_animation"
for base in a b; do
  rate=30
  [[ $base == b ]] && rate=24
  "$program" $base.obj $base.pc2 --fps $rate --rest $base.obj --threshold 0.05 --quiet -o $base.json \
    --write-field deformation:$base.npy || fail "detect_features"
done
detector="$program"
program="$evaluator"

cat >tool.py <<'PYTHON'
import json, math, statistics, struct, sys


def load(name):
    with open(name + ".json") as file:
        return json.load(file, parse_constant=lambda c: sys.exit(name + ".json contains " + c))


def points(name):
    return [tuple(float(x) for x in line.split()[1:4]) for line in open(name) if line.startswith("v ")]


def npy(path):
    data = open(path, "rb").read()
    length = struct.unpack("<H", data[8:10])[0]
    n, f = eval(data[10:10 + length])["shape"]
    values = struct.unpack("<%df" % (n * f), data[10 + length:])
    return [values[i * f:(i + 1) * f] for i in range(n)]


def diagonal(p):
    return math.dist([min(x) for x in zip(*p)], [max(x) for x in zip(*p)])


def nearest(p, others):
    return min(range(len(others)), key=lambda i: math.dist(p, others[i]))


def found_again(a, b):
    """The share of the strongest 50 of a.json that have one of the strongest 150 of b.json nearby."""
    pa, pb = points("a.obj"), points("b.obj")
    place, time = 0.03 * diagonal(pb), 1.5 / 24 + 1e-9

    def is_found(f):
        p = pb[nearest(pa[f["vertex"]], pb)]
        return any(math.dist(p, pb[g["vertex"]]) <= place and abs(f["time"] - g["time"]) <= time
                   for g in b["features"][:150])
    return sum(is_found(f) for f in a["features"][:50]) / 50


def rig_scores(features, rig):
    """Recall, precision, and how many events should be found."""
    p = points("a.obj")
    dt, frames = rig["animation"]["frame_duration"], rig["animation"]["frames"]
    events = [(j, m) for j in rig["joints"] for m in j["maxima"]
              if j["region"] and m["prominence_deg"] >= 10 and m["angle_deg"] >= 10
              and dt < m["time"] < (frames - 2) * dt]

    size = 0.02 * diagonal(p)

    def is_at(f, joint, maximum):
        if abs(f["time"] - maximum["time"]) > max(1.5 * dt, f["tau"] / 2):
            return False
        limit = min(f["sigma"], size)
        return any(math.dist(p[f["vertex"]], p[v]) <= limit for v in joint["region"])
    large = [e for e in events if e[1]["angle_deg"] >= 20]
    return (sum(any(is_at(f, *e) for f in features) for e in large) / len(large),
            sum(any(is_at(f, *e) for e in events) for f in features) / len(features), len(large))


def near(x, y, tolerance=1e-9):
    return abs(x - y) <= tolerance


def first_maximum(rig, name):
    return next(j for j in rig["joints"] if j["name"] == name)["maxima"][0]


def stands(figure):
    """Whether a figure has what belongs beside it."""
    low, high = figure["interval"]
    return low <= figure["value"] <= high and figure["chance"] is not None and figure["sample"] > 0


if len(sys.argv) > 1:
    names = dict(globals(), **{n: load(n) for n in sys.argv[2:]})
    sys.exit(0 if eval("(" + sys.argv[1] + ")", names) else 1)
PYTHON

# check <python expression> <JSON files without ending...>
check() {
  checks=$((checks + 1))
  python3 tool.py "$@" || fail "$1"
}

# ------------------------------------------------------------------------------------------------------- repeatability

expect 0 "" repeatability a.json a.json --rest-a a.obj --rest-b a.obj --map same -o same.json
check "all(near(g['value'], 1) and g['interval'] == [1, 1] and g['chance'] < 0.9
           for t in same['figures'].values() for g in t.values())" same
grep -q "one-to-one" out || fail "no table"
expect 0 "" repeatability a.json a.json -o places.json # without meshes
check "all(near(g['value'], 1) for t in places['figures'].values() for g in t.values())" places
check "places['figures']['one_to_one']['place_time']['chance'] is None" places

expect 0 "" repeatability a.json b.json --rest-a a.obj --rest-b b.obj -o ab.json --quiet
[[ ! -s out ]] || fail "--quiet prints"
check "all(stands(g) for t in ab['figures'].values() for g in t.values())" ab
check "near(ab['figures']['a_in_b']['place_time']['value'], found_again(a, b))" ab a b
check "all(c['y'] == sorted(c['y']) for c in ab['curves']['of'] if not c['is_chance'])" ab # wider gates find more
check "all(t['place_time_scales']['value'] <= t['place_time']['value'] for t in ab['figures'].values())" ab
# the same map as a file, and the same figures again
python3 -c "
from tool import *
pa, pb = points('a.obj'), points('b.obj')
print(*(nearest(p, pb) for p in pa), sep='\n')" >map.txt
expect 0 "" repeatability a.json b.json --rest-a a.obj --rest-b b.obj --map map.txt -o mapped.json --quiet
check "mapped['figures'] == ab['figures']" mapped ab
expect 0 "" repeatability a.json b.json --rest-a a.obj --rest-b b.obj --seed 7 -o seed.json --quiet
check "seed['figures'] != ab['figures'] and near(seed['figures']['a_in_b']['place_time']['value'],
       ab['figures']['a_in_b']['place_time']['value'])" seed ab

# ------------------------------------------------------------------------------------------------------ matching error

expect 0 "" matching-error a.json b.json --rest-a a.obj --rest-b b.obj -o error.json
check "all(stands(g) for t in error['figures'].values() for g in t.values())" error
check "all(x <= y * (1 + 1e-12) for x, y in zip(error['errors']['a_to_b_place'],
           [math.inf if e is None else e for e in error['errors']['a_to_b_place_time']]))" error
check "error['figures']['a_to_b_place']['within_2_percent']['value'] ==
       sum(e <= 2 for e in error['errors']['a_to_b_place']) / len(a['features'])" error a
expect 0 "" matching-error a.json a.json --rest-b a.obj --map same -o zero.json
check "all(e == 0 for list in zero['errors'].values() for e in list)" zero

# ----------------------------------------------------------------------------------------------------------------- rig

expect 0 "" rig a.json --events rig.json --rest a.obj -o rigged.json
check "all(stands(g) for g in rigged['figures']['all'].values())" rigged
check "all(near(x, y) for x, y in zip(rig_scores(a['features'], rig), [rigged['figures']['all']['recall']['value'],
       rigged['figures']['all']['precision']['value'], rigged['figures']['all']['recall']['sample']]))" rigged rig a
check "sum(j['events'] for j in rigged['joints']['all']) == rigged['figures']['all']['recall']['sample']" rigged
check "rigged['figures']['all']['recall']['value'] > 0.8" rigged
check "all(g['value'] > 1.5 * g['chance'] for g in rigged['figures']['all'].values())" rigged
# the knees bend most a quarter before the thighs are foremost, and a little earlier: a known function of the time
check "near(first_maximum(rig, 'left shin')['time'], 0.8 * (0.75 - 0.3 / (2 * math.pi)), 1 / 30 / 16) and
       near(first_maximum(rig, 'left shin')['angle_deg'], math.degrees(0.35 + 1.1), 0.02)" rig
expect 0 "" rig a.json a.json --top 5 --events rig.json --rest a.obj -o two.json
check "two['figures']['0'] == two['figures']['1'] and two['figures']['0']['precision']['sample'] == 5" two

# a character with a skeleton, if there is one: vertices that the format split are welded by the detector
character="${ANIMATED_MESH_FEATURES_TEST_DATA:-}/clips/Knight.glb"
if [[ -f "$character" ]] && "$detector" "$character" --clip Walking_A --quiet -o knight.json 2>err; then
  expect 0 "" rig knight.json --model "$character" --clip Walking_A -o walking.json
  check "walking['figures']['all']['recall']['sample'] > 5 and all(stands(g) for g in walking['figures']['all'].values())" \
    walking
  check "{'lowerleg.l', 'lowerleg.r'} <= {j['name'] for j in walking['joints']['all']}" walking
  expect 3 "was it another clip" rig knight.json --model "$character" --clip 1H_Melee_Attack_Stab
  expect 2 "there is no clip" rig knight.json --model "$character" --clip Nothing
else
  echo "left out: a character with a skeleton"
fi

# ----------------------------------------------------------------------------------------------------------------- fit

expect 0 "" fit a.json a.npy a.obj -o fit.json
check "len(fit['features']) == len(a['features']) and fit['figures']['all']['median']['value'] > 0.4" fit a
check "stands(fit['figures']['all']['median']) and fit['figures']['all']['median']['chance'] < 0.3" fit
check "near(statistics.median(f['fit'] for f in fit['features']), fit['figures']['all']['median']['value'])" fit

# ------------------------------------------------------------------------------------------------------------- regions

expect 0 "" regions a.json a.obj a.pc2 --rest a.obj --top 10 --write-map map.npy --write-weighted-map weighted.npy \
  --write-mesh regions.ply
check "len(npy('map.npy')) == len(npy('weighted.npy')) == len(points('a.obj'))"
check "all({0, 1} >= set(row) for row in npy('map.npy')) and all(0 <= x <= 1 for row in npy('weighted.npy') for x in row)"
# a feature is in its own region
check "all(npy('map.npy')[f['vertex']][f['frame']] == 1 for f in a['features'][:10] if f['tau'] > 0.02)" a
check "all(npy('weighted.npy')[f['vertex']][f['frame']] > 0.7 for f in a['features'][:10] if f['tau'] > 0.02)" a
head -c 300 regions.ply | grep -aq "element vertex $(grep -c '^v ' a.obj)" || fail "regions.ply"
# Painters who see what the map shows, one of them some of it only; in two files.
python3 - <<'PYTHON' || fail "paintings"
import json
from tool import load, npy
m, animation = npy("map.npy"), load("a")["animation"]
for name, painter, vertices in (("anna1", "Anna", range(0, len(m), 2)), ("anna2", "Anna", range(1, len(m), 2)),
                                ("ben", "Ben", range(0, len(m), 3))):
    strokes = []
    for f in range(animation["frames"]):
        strokes.append({"frame": f, "frames": [f, f], "vertices": [v for v in vertices if m[v][f] > 0]})
    with open(name + ".json", "w") as file:
        json.dump({"format": "animated-mesh-features-painting", "version": 1, "painter": painter, "strokes": strokes,
                   "animation": {k: animation[k] for k in ("vertices", "frames", "frame_duration")}}, file)
PYTHON
expect 0 "" regions a.json a.obj a.pc2 --rest a.obj --top 10 --truth anna1.json --truth anna2.json -o anna.json
check "all(near(anna['figures']['space_time'][k]['value'], 1) for k in ('auc', 'correlation'))" anna
check "anna['painters'] == 1 and abs(anna['figures']['space_time']['auc']['chance'] - 0.5) < 0.1" anna
check "anna['figures']['space_time']['nss']['value'] > 1 and anna['figures']['space']['auc']['value'] > 0.999" anna
expect 0 "" regions a.json a.obj a.pc2 --rest a.obj --top 10 --truth anna1.json --truth anna2.json --truth ben.json -o both.json
check "both['painters'] == 2 and 0.5 < both['figures']['space_time']['auc']['value'] < 1 and
       both['figures']['space_time']['auc_split_half']['value'] > 0.6" both

# ------------------------------------------------------------------------------------------------------- files, errors

if "$program" repeatability a.json b.json -q --plot curves.svg 2>err; then
  grep -q "by chance" curves.svg || grep -q "<path\|<g" curves.svg || fail "curves.svg"
  for format in pdf png; do
    "$program" rig a.json -q --events rig.json --rest a.obj --plot curves.$format || fail "--plot curves.$format"
    [[ -s curves.$format ]] || fail "curves.$format is empty"
  done
  expect 2 ".svg, .pdf, .png" repeatability a.json b.json --plot curves.jpg
else
  grep -q "built without pictures" err || fail "--plot: $(head -c 300 err)"
fi
expect 0 "" repeatability a.json b.json -o -
python3 -c "import json; json.load(open('out'))" || fail "-o - is no JSON alone"

expect 2 "evaluate_features regions" # tells all measures
expect 0 "" --help
expect 0 "" --version
for measure in repeatability matching-error regions rig fit; do
  expect 0 "" $measure --help
  grep -q -- "--resamples" out || fail "$measure --help"
  expect 2 "" $measure
done
expect 2 "no measure \"recall\"" recall a.json
expect 2 "two files" repeatability a.json
expect 2 "--rest-b" matching-error a.json b.json --rest-a a.obj
expect 2 "--rest-a" repeatability a.json b.json --rest-b b.obj
expect 2 "go with --rest-b" repeatability a.json b.json --rest-a a.obj
expect 2 "either --events or --model" rig a.json
expect 2 "go together" rig a.json --events rig.json
expect 2 "is the input" fit a.json a.npy a.obj -o a.json
expect 2 "--factor" repeatability a.json b.json --factor 0.5
expect 2 "not positive" repeatability a.json b.json --draws 0
expect 3 "b.obj: has" repeatability a.json b.json --rest-a b.obj --rest-b b.obj
expect 3 "they are not the same" repeatability a.json b.json --rest-b b.obj --map same
echo 5 >short.txt
expect 3 "short.txt: has 1 lines" repeatability a.json b.json --rest-b b.obj --map short.txt
echo -5 >minus.txt
expect 3 "minus.txt: line 1" repeatability a.json b.json --rest-b b.obj --map minus.txt
expect 3 "rig.json: is about" rig b.json --events rig.json --rest b.obj
expect 3 "a.json: holds no events" rig a.json --events a.json --rest a.obj
expect 3 "b.npy: is" fit a.json b.npy a.obj
expect 3 "a.obj: is no NumPy file" fit a.json a.obj a.obj
expect 3 "is no painting" regions a.json a.obj a.pc2 --truth rig.json
expect 3 "was painted on" regions b.json b.obj b.pc2 --truth ben.json
expect 3 "the animation has" regions a.json b.obj b.pc2
sed 's/"vertices": \[[^]]*\]/"vertices": []/g' ben.json >blank.json
expect 3 "has painted nothing" regions a.json a.obj a.pc2 --truth blank.json
expect 4 "cannot write" repeatability a.json b.json -o nowhere/x.json
[[ -z "$(find . -name '*.tmp')" ]] || fail "temporary files are left"

echo "$checks checks"
exit "$failed"
