#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_plot.py PLOT.svg FEATURES.json

Reads the numbers off the plot that detect_features --plot has written, as a reader would: by the ticks of its axes.
"""

import json
import math
import sys
import xml.etree.ElementTree

from scene_data import check, count, near

SVG = "{http://www.w3.org/2000/svg}"
root = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
result = json.load(open(sys.argv[2]))
features = result["features"]
duration = (result["animation"]["frames"] - 1) * result["animation"]["frame_duration"]
check(root.tag == SVG + "svg" and "prefers-color-scheme: dark" in root.find(SVG + "style").text, "light and dark")
width, height = (float(root.get(name)) for name in ("width", "height"))
groups = {g.get("id"): g for g in root.iter(SVG + "g")}

for element in root.iter():
    for name, value in element.attrib.items():
        check("nan" not in value and "inf" not in value, "%s=%s is a number" % (name, value))
    for name, most in (("x", width), ("y", height), ("cx", width), ("cy", height), ("x1", width), ("x2", width)):
        if name in element.attrib:
            check(0 <= float(element.get(name)) <= most, "%s is within the drawing" % element.get(name))


def scale(group, axis, logarithm=False):
    """The value at a place, by the first and the last tick."""
    kind = {"x": "middle dim", "y": "end dim"}[axis]
    ticks = [t for t in groups[group].iter(SVG + "text") if t.get("class") == kind]
    check(2 <= len(ticks) <= 12, "%d ticks on the axis of %s" % (len(ticks), group))
    # text is a little below its line
    places = [float(t.get(axis)) - (4 if axis == "y" else 0) for t in ticks]
    values = [float(t.text) for t in ticks]
    if logarithm:
        values = [math.log(v) for v in values]
    slope = (values[-1] - values[0]) / (places[-1] - places[0])
    for p, v in zip(places, values):
        check(near(values[0] + slope * (p - places[0]), v, 0.01 * abs(slope)), "ticks of %s are where they are" % group)
    value = lambda place: values[0] + slope * (place - places[0])
    return (lambda place: math.exp(value(place))) if logarithm else value, abs(slope)


def size(x):
    return float(x.get("r"))


texts = [t.text for t in root.iter(SVG + "text")]
for text in ["time (s)", "strength"] + ["features"] * bool(features):
    check(text in texts, "the label " + text)
check("%d feature%s in" % (len(features), "" if len(features) == 1 else "s") in " ".join(t or "" for t in texts), "how many")

time, second = scale("time", "x")
strength, unit = scale("strength", "y")
drawn = {}
for g in root.iter(SVG + "g"):
    if g.get("class") == "feature":
        drawn[int(g.find(SVG + "title").text.split(":")[0].split()[1])] = g
check(sorted(drawn) == list(range(len(features))), "every feature is drawn")
if features:
    most = max(f["sigma"] for f in features)
    largest = max(size(g.find(SVG + "circle")) for g in drawn.values())
for i, f in enumerate(features):
    circle, bar = drawn[i].find(SVG + "circle"), drawn[i].find(SVG + "line")
    check(near(time(float(circle.get("cx"))), f["time"], 0.02 * second), "the time of feature %d" % i)
    check(near(strength(float(circle.get("cy"))), f["strength"], 0.02 * unit), "the strength of feature %d" % i)
    begin, end = (time(float(bar.get(name))) for name in ("x1", "x2"))
    check(near(begin, max(0, f["time"] - f["tau"] / 2), 0.02 * second), "the begin of the bar of feature %d" % i)
    check(near(end, min(duration, f["time"] + f["tau"] / 2), 0.02 * second), "the end of the bar of feature %d" % i)
    check(near(size(circle), max(2, largest * f["sigma"] / most), 0.02), "the size of feature %d" % i)
    title = drawn[i].find(SVG + "title").text
    check("vertex %d," % f["vertex"] in title, "the tooltip of feature %d" % i)

for group, name in (("sigmas", "sigma"), ("taus", "tau")):
    bars = [b for b in groups[group].iter(SVG + "rect")] if features else []
    check(bool(bars) == bool(features), "a histogram of " + name)
    if not bars:
        continue
    value, _ = scale(group, "x", True)
    number, one = scale(group, "y")
    bottom = max(float(b.get("y")) + float(b.get("height")) for b in bars)
    total = 0
    for b in bars:
        begin = value(float(b.get("x")) - 1)
        end = value(float(b.get("x")) + float(b.get("width")) + 1)
        inside = sum(begin * 0.9999 <= f[name] <= end * 1.0001 for f in features)
        height = number(float(b.get("y")))
        check(near(height, round(height), 0.05 * one) and round(height) == inside, "%s from %g to %g" % (name, begin, end))
        total += round(height)
        check(near(float(b.get("y")) + float(b.get("height")), bottom, 0.02), "columns stand on the axis")
    check(total == len(features), "every feature is in the histogram of " + name)

print("SVG: %d features: %d checks, all as expected" % (len(features), count()))
