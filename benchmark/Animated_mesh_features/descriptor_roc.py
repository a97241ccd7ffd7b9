#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""How well distances of descriptors tell the same event from others, as a drawing: the receiver operating characteristic of
pairs of a horse's features and of those of its twins, on another mesh and at another frame rate.

descriptor_roc.py COMPARE_ANIMATIONS DATA FIGURE.svg [--work DIR]

DATA and DIR as for comparison.py, whose cache is used.
"""

import argparse
import pathlib
import sys

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "doc/figures"))

from comparison import TWINS, Comparer, auc, descriptor_distances
from svg import AMBER, BLUE, GREEN, GREY, INK, Axis, Drawing, Plot

NAMES = {"horse-gallop-dec4200": "half of the vertices", "horse-gallop-irregular": "front decimated to a third",
         "horse-gallop-half": "half of the frames"}


def characteristic(same, different):
    """Shares of different and of same pairs that are nearer than each distance, from (0, 0) to (1, 1)."""
    limits = np.unique(np.r_[same, different])
    share = lambda distances: np.searchsorted(np.sort(distances), limits, "right") / len(distances)
    return np.r_[0, share(different)], np.r_[0, share(same)]


def thinned(x, y, step=0.002):
    """Fewer points, none farther from the last one than what is seen."""
    kept = [0]
    for i in range(1, len(x)):
        if i == len(x) - 1 or abs(x[i] - x[kept[-1]]) + abs(y[i] - y[kept[-1]]) >= step:
            kept.append(i)
    return x[kept], y[kept]


def draw(curves, path):
    d = Drawing(760, 412, "Receiver operating characteristic of descriptor distances")
    plots = [Plot(d, 62, 40, 290, 290, Axis(0, 1, [0, 0.25, 0.5, 0.75, 1]), Axis(0, 1, [0, 0.25, 0.5, 0.75, 1]),
                  "share of different pairs", "share of true pairs", "nearer than some distance"),
             Plot(d, 440, 40, 290, 290, Axis(1e-3, 1, [1e-3, 1e-2, 1e-1, 1], True, ["0.001", "0.01", "0.1", "1"]),
                  Axis(0, 1, [0, 0.25, 0.5, 0.75, 1]), "share of different pairs", "", "the same, few different ones")]
    chance = np.geomspace(1e-3, 1, 60)
    plots[0].curve([0, 1], [0, 1], GREY, 1.2, stroke_dasharray="5 4")
    plots[1].curve(chance, chance, GREY, 1.2, stroke_dasharray="5 4")
    d.add("rect", x=152.0, y=198.0, width=196.0, height=120.0, fill="white", opacity=0.85)
    plots[0].label(0.97, 0.41, "area below the curves", INK, "end")
    for i, (name, same, any_scale, different) in enumerate(curves):
        colour = (BLUE, GREEN, AMBER)[i]
        for true, width in ((same, 2.2), (any_scale, 0.8)):
            x, y = thinned(*characteristic(true, different))
            plots[0].curve(x, y, colour, width)
            seen = x >= 1e-3
            plots[1].curve(np.r_[1e-3, x[seen]], np.r_[np.interp(1e-3, x, y), y[seen]], colour, width)
        areas = "%.2f, %.2f" % (auc(same, different), auc(any_scale, different))
        plots[0].label(0.97, 0.32 - 0.085 * i, NAMES[name] + ": " + areas, colour, "end")
    plots[0].label(0.97, 0.065, "chance: 0.5", GREY, "end")
    d.text(380, 399, "thick: true pairs have the same place, time and scales; thin: the same place and time", 13, "middle",
           GREY)
    for plot in plots:
        plot.frame()
    d.write(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="COMPARE_ANIMATIONS")
    parser.add_argument("data", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("figure")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("comparison"))
    arguments = parser.parse_args()
    compare = Comparer(str(pathlib.Path(arguments.program).resolve()), arguments.work.resolve())
    curves = []
    for twin in TWINS:
        distance, at_once, _, of_scale = descriptor_distances(compare, arguments.data, twin)
        same, different = distance[at_once & of_scale], distance[~at_once]
        curves.append((twin, same, distance[at_once], different))
        print("%-24s area %.3f: %d true pairs of the same scales, %d different ones; %.3f: %d of any scale" % (
            twin, auc(same, different), len(same), len(different), auc(distance[at_once], different), at_once.sum()))
    draw(curves, arguments.figure)
    return 0


if __name__ == "__main__":
    sys.exit(main())
