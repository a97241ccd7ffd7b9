# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""check_plot.py PLOT.svg PLOT.pdf FEATURES.json TITLE DEFORMATION.npy [PLOT.png]

Reads the numbers off the plots that detect_features --plot has written, as a reader would: by the ticks of their axes. The
formats show the same; texts are read from the PDF, where they are texts.
"""

import json
import math
import struct
import sys

from plot_files import read_pdf, read_svg
from png_file import read_png
from scene_data import check, count, near

svg, width, height = read_svg(sys.argv[1])
pdf, pdf_width, pdf_height = read_pdf(sys.argv[2])
result = json.load(open(sys.argv[3]))
features = result["features"]
duration = (result["animation"]["frames"] - 1) * result["animation"]["frame_duration"]
check((width, height) == (960, 992 if features else 760), "the size of the SVG")
check(near(pdf_width, width) and near(pdf_height, height), "the size of the PDF")

WHITE, DIM, GRID = (1, 1, 1), (89 / 255, 99 / 255, 110 / 255), (209 / 255, 217 / 255, 224 / 255)
ROUNDING = 0.02  # pixels


def same_colour(a, b, tolerance=0.003):
    return a == b or (a is not None and b is not None and all(abs(x - y) < tolerance for x, y in zip(a, b)))


def same(a, b):
    """Whether two shapes are, to within the digits that are written."""
    return all(same_colour(x, y) if isinstance(x or y, tuple) else x == y or abs(x - y) < ROUNDING for x, y in zip(a, b))


paper = pdf.rectangles.pop(0)
check(same(paper, (0, 0, width, height, WHITE)), "white paper")
for kind in ("circles", "lines", "rectangles"):
    a, b = getattr(svg, kind), getattr(pdf, kind)
    check(len(a) == len(b) and all(same(x, y) for x, y in zip(a, b)), "the %s of SVG and PDF" % kind)
for a, b in zip(svg.curves, pdf.curves):
    check(same_colour(a.stroke, b.stroke) and len(a.points) == len(b.points) and
          all(abs(p - q) < ROUNDING for x, y in zip(a.points, b.points) for p, q in zip(x, y)), "a curve of SVG and PDF")

for c in svg.circles:
    check(0 <= c.x - c.r and c.x + c.r <= width and 0 <= c.y - c.r and c.y + c.r <= height, "%s is within" % (c,))
for line in svg.lines:
    check(0 <= min(line.x0, line.x1) and max(line.x0, line.x1) <= width, "%s is within the drawing" % (line,))
    check(0 <= min(line.y0, line.y1) and max(line.y0, line.y1) <= height, "%s is within the drawing" % (line,))
for t in pdf.texts:
    right, bottom = (width, height) if not t.is_upward else (height, width)
    check(0 <= min(t.begin, t.end) and max(t.begin, t.end) <= right and 0 < t.along < bottom, "%s is within" % (t,))

texts = [t.text for t in pdf.texts]
for text in [sys.argv[4], "time (s)", "strength"] + (["features"] * 2 if features else ["no features"]):
    check(texts.count(text) >= 1, "the label %s among %s" % (text, texts))
plural = "" if len(features) == 1 else "s"
check(any(t.startswith("%d feature%s in" % (len(features), plural)) for t in texts), "how many")

axes = sorted((line for line in svg.lines if same_colour(line.stroke, DIM) and line.x1 - line.x0 > 100),
              key=lambda line: (line.y0, line.x0))
check(len(axes) == (4 if features else 1), "%d horizontal axes" % len(axes))


def scale(places, texts, logarithm, what):
    """The value at a place, and what a pixel is, by all ticks of an axis."""
    check(2 <= len(places) <= 12 and len(places) == len(texts), "%d ticks of %s" % (len(places), what))
    values = [math.log(float(t.text)) if logarithm else float(t.text) for t in texts]
    slope = (values[-1] - values[0]) / (places[-1] - places[0])
    value = lambda place: values[0] + slope * (place - places[0])
    for p, v in zip(places, values):
        check(near(value(p), v, 0.01 * abs(slope)), "ticks of %s are where they are" % what)
    return (lambda place: math.exp(value(place))) if logarithm else value, abs(slope)


def scale_x(axis, logarithm=False):
    ticks = sorted(line.x0 for line in svg.lines if line.x0 == line.x1 and line.y0 == axis.y0
                   and axis.x0 <= line.x0 <= axis.x1 and same_colour(line.stroke, DIM))
    labels = sorted((t for t in pdf.texts if not t.is_upward and abs(t.along - axis.y0 - 20) < 0.1
                     and axis.x0 - 20 < (t.begin + t.end) / 2 < axis.x1 + 20), key=lambda t: t.begin)
    for tick, label in zip(ticks, labels):
        check(abs((label.begin + label.end) / 2 - tick) < 0.5, "%s is below its tick" % label.text)
    return scale(ticks, labels, logarithm, "a horizontal axis")


def scale_y(axis, top):
    labels = [t for t in pdf.texts if not t.is_upward and abs(t.end - axis.x0 + 8) < 0.5 and top < t.along < axis.y0 + 8]
    places = [t.along - 0.73 * t.size / 2 for t in labels]  # text stands below its line
    grid = [line.y0 for line in svg.lines if same_colour(line.stroke, GRID) and line.x0 == axis.x0 and line.x1 == axis.x1
            and top < line.y0 < axis.y0]
    check(len(grid) == len(labels) - 1 and all(abs(g - p) < ROUNDING for g, p in zip(grid, places[1:])), "lines of a grid")
    check(abs(places[0] - axis.y0) < ROUNDING, "the axis is at 0")
    return scale(places, labels, False, "a vertical axis")


time, second = scale_x(axes[0])
strength, unit = scale_y(axes[0], 70)
circles = [c for c in svg.circles if c.fill and c.opacity < 1]
bars = [line for line in svg.lines if abs(line.width - 2.5) < 0.01]
check(len(circles) == len(bars) == len(features), "every feature is drawn")
largest_first = sorted(range(len(features)), key=lambda i: -features[i]["sigma"])
if features:
    most = max(f["sigma"] for f in features)
    largest = max(c.r for c in circles)
for i, circle, bar in zip(largest_first, circles, bars):
    f = features[i]
    check(near(time(circle.x), f["time"], ROUNDING * second), "the time of feature %d" % i)
    check(near(strength(circle.y), f["strength"], ROUNDING * unit), "the strength of feature %d" % i)
    check(near(time(bar.x0), max(0, f["time"] - f["tau"] / 2), ROUNDING * second), "the begin of the bar of feature %d" % i)
    check(near(time(bar.x1), min(duration, f["time"] + f["tau"] / 2), ROUNDING * second), "the end of the bar of feature %d" % i)
    check(bar.y0 == bar.y1 and abs(bar.y0 - circle.y) < ROUNDING, "the height of the bar of feature %d" % i)
    check(near(circle.r, max(2, largest * f["sigma"] / most), ROUNDING), "the size of feature %d" % i)
    check(circle.opacity == 0.35 and circle.fill == circle.stroke == bar.stroke, "the colour of feature %d" % i)
if features and max(f["tau"] for f in features) > min(f["tau"] for f in features):
    by_tau = sorted(range(len(features)), key=lambda k: features[largest_first[k]]["tau"])
    red, blue = circles[by_tau[0]].fill, circles[by_tau[-1]].fill
    check(red[0] > 3 * red[2] and blue[2] > 3 * blue[0], "red is short, blue is long")

# The curves are the deformation at the strongest feature of each of the strongest places, in its colour.
places = {}
for i, f in enumerate(features):
    places.setdefault(f["place"], i)
strongest = sorted(places.values())[:6]
check(len(svg.curves) == len(pdf.curves) == len(strongest), "%d curves" % len(svg.curves))
drawn = dict(zip(largest_first, circles))
if features:
    second_of, pixel_of_time = scale_x(axes[1])
    value_of, pixel_of_value = scale_y(axes[1], 500)
    with open(sys.argv[5], "rb") as file:
        data = file.read()
    length = struct.unpack("<H", data[8:10])[0]
    frames = result["animation"]["frames"]
    for i, curve in zip(strongest, svg.curves):
        v = features[i]["vertex"]
        row = struct.unpack_from("<%df" % frames, data, 10 + length + 4 * frames * v)
        check(same_colour(curve.stroke, drawn[i].stroke), "the colour of the curve of feature %d" % i)
        # cairo leaves out points that are on the line between their neighbours
        line = [(second_of(x), value_of(y)) for x, y in curve.points]
        tolerance = 2 * ROUNDING * pixel_of_value + 1e-6 * max(row)
        check(near(line[0][0], 0, ROUNDING * pixel_of_time) and near(line[-1][0], duration, ROUNDING * pixel_of_time),
              "the ends of the curve of feature %d" % i)
        for k in range(frames):
            t = k * result["animation"]["frame_duration"]
            j = min(max(1, sum(p[0] < t for p in line)), len(line) - 1)
            (t0, y0), (t1, y1) = line[j - 1], line[j]
            slope = abs((y1 - y0) / (t1 - t0))
            check(near(y0 + (y1 - y0) * (t - t0) / (t1 - t0), row[k], tolerance + 2 * ROUNDING * pixel_of_time * slope),
                  "the curve of feature %d in frame %d" % (i, k))
        check(texts.count("%d, %d" % (i + 1, v)) == 1, "the key of its curve")
    # its dots: the features of the same places, on the curve of the strongest
    dots = [c for c in svg.circles if c.fill and c.opacity == 1]
    at = [features[k]["time"] for i in strongest for k in range(len(features))
          if features[k]["place"] == features[i]["place"]]
    check(len(dots) == len(at) and all(near(second_of(c.x), min(duration, max(0, t)), ROUNDING * pixel_of_time)
                                       for c, t in zip(sorted(dots, key=lambda c: c.x), sorted(at))), "the times of dots")

samples = [c for c in svg.circles if not c.fill]
check(len(samples) == (3 if features else 0), "%d circles in the key" % len(samples))
for c in samples:
    label = [t for t in pdf.texts if abs(t.along - 0.73 * t.size / 2 - c.y) < 0.1 and t.begin > c.x + c.r]
    check(len(label) == 1, "a circle of the key has one label")
    check(c.r <= 2.01 or abs(float(label[0].text) / (c.r / largest * most) - 1) < 0.06, "the key says " + label[0].text)

for axis, name in zip(axes[2:], ("sigma", "tau")):
    value, _ = scale_x(axis, True)
    number, one = scale_y(axis, 740)
    columns = [r for r in svg.rectangles if axis.x0 <= r.x and r.x + r.width <= axis.x1 + 1]
    total = 0
    for r in columns:
        begin, end = value(r.x - 1), value(r.x + r.width + 1)
        # ends are known as well as they are drawn: what lies on one may be in either column
        surely = sum(begin * 1.0001 < f[name] < end * 0.9999 for f in features)
        perhaps = sum(begin * 0.9999 <= f[name] <= end * 1.0001 for f in features)
        n = number(r.y)
        check(near(n, round(n), 0.05 * one) and surely <= round(n) <= perhaps, "%s from %g to %g" % (name, begin, end))
        total += round(n)
        check(abs(r.y + r.height - axis.y0) < ROUNDING, "columns stand on the axis")
    check(total == len(features), "every feature is in the histogram of " + name)

if len(sys.argv) > 6:
    pixels = read_png(sys.argv[6])
    check((len(pixels[0]), len(pixels)) == (2 * width, 2 * height), "the size of the PNG")

    def pixel(x, y):
        return tuple(p / 255 for p in pixels[int(2 * y)][int(2 * x)])

    check(all(pixel(x, y) == WHITE for x in (0, width - 1) for y in (0, height - 1)), "the paper of the PNG")
    for r in svg.rectangles:
        check(same_colour(pixel(r.x + r.width / 2, r.y + r.height / 2), r.fill), "a column of the PNG")
    for axis in axes[:1] + axes[2:]:  # curves lie on the other one
        x = next(axis.x0 + i for i in range(2, 100) if all(abs(axis.x0 + i - line.x0) > 2 for line in svg.lines))  # no tick
        check(same_colour(pixel(x, axis.y0), DIM) and pixel(x, axis.y0 + 3) == WHITE, "an axis of the PNG")
    # on its bar, of the same colour: two roundings
    check(same_colour(pixel(circles[-1].x, circles[-1].y), circles[-1].fill, 0.006), "the last circle of the PNG")

print("SVG, PDF%s: %d features: %d checks, all as expected" % (", PNG" * (len(sys.argv) > 6), len(features), count()))
