#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures of the manual from what the programs of the package computed; see doc/make_figures.sh.

draw_figures.py DATA_FOLDER FIGURE_FOLDER
"""

import json
import math
import os
import sys

from design_figure import design
from svg import (AMBER, BLUE, FAINT, GREEN, GREY, INK, RED, VIOLET, Axis, Drawing, Plot, colour_map, number, png,
                 size_of_png)

ROOT2 = math.sqrt(2)


class Folder:
    def __init__(self, data, figures):
        self.data, self.figures = data, figures

    def json(self, name):
        with open(os.path.join(self.data, name), encoding="utf-8") as file:
            return json.load(file)

    def bytes(self, name):
        with open(os.path.join(self.data, name), "rb") as file:
            return file.read()

    def write(self, drawing, name):
        drawing.write(os.path.join(self.figures, name))

    def field_colours(self):
        return colour_map([tuple(c) for c in self.json("colours.json")["field"]])


# The response: below 0, where features are, brown; above, a bluish grey. Not the colours of fields.
RESPONSE_COLOURS = colour_map([(92, 42, 6), (186, 100, 28), (240, 200, 150), (255, 255, 255), (208, 214, 225),
                               (152, 164, 186), (96, 112, 140)])


def gaussian(x, middle, width):
    return math.exp(-((x - middle) / width)**2 / 2)


def anatomy(folder):
    """A feature along time and along the surface, with the Gaussians of its tau and sigma."""
    data = folder.json("cylinder.json")
    feature = max((f for f in data["found"] if f[0] > 0), key=lambda f: f[5])
    _, height, time, sigma, tau, _ = feature
    field, heights, step = data["deformation"], data["height"], data["step"]
    row = min(range(len(heights)), key=lambda i: abs(heights[i] - height))
    frame = int(round(time / step))
    times = [f * step for f in range(len(field[row]))]
    column = [field[i][frame] for i in range(len(heights))]
    top = 1.25 * max(field[row])
    ticks = Axis(0, top, [0, 0.5, 1])
    d = Drawing(760, 330, "One feature: its deformation over time and along the surface")

    p = Plot(d, 62, 40, 300, 225, Axis(0.1, 0.9, [0.1, 0.3, 0.5, 0.7, 0.9]), ticks, "time (s)", "deformation",
             "at the feature's place")
    shown = [i for i, t in enumerate(times) if 0.1 <= t <= 0.9]
    p.band(time - tau, time + tau, BLUE)
    fine = [0.1 + 0.8 * i / 200 for i in range(201)]
    p.curve(fine, [field[row][frame] * gaussian(t, time, tau) for t in fine], BLUE, 1.8, stroke_dasharray="6 4")
    p.curve([times[i] for i in shown], [field[row][i] for i in shown], INK, 1.5)
    p.dots([times[i] for i in shown], [field[row][i] for i in shown], INK, 2.6)
    p.label(time, top, "time ± τ", BLUE, "middle", dy=17)
    p.frame()

    low, high = height - 1.6, height + 1.6
    p = Plot(d, 440, 40, 300, 225, Axis(low, high, [4, 5, 6]), ticks, "height on the cylinder", "", "at the feature's time")
    p.band(height - sigma, height + sigma, RED)
    fine = [low + (high - low) * i / 200 for i in range(201)]
    p.curve(fine, [column[row] * gaussian(z, height, sigma) for z in fine], RED, 1.8, stroke_dasharray="6 4")
    shown = [i for i, z in enumerate(heights) if low <= z <= high]
    p.curve([heights[i] for i in shown], [column[i] for i in shown], INK, 1.5)
    p.dots([heights[i] for i in shown], [column[i] for i in shown], INK, 2.6)
    p.label(height, top, "place ± σ", RED, "middle", dy=17)
    p.frame()
    d.text(380, 322, "dots: deformation, as computed; dashed: Gaussians with the τ and the σ of the feature", 13, "middle",
           GREY)
    folder.write(d, "anatomy_of_a_feature.svg")


def gaussians_in_time(folder):
    """What makes the scale of an event a minimum."""
    data = folder.json("gaussians_in_time.json")
    colours = [RED, BLUE, GREEN]
    d = Drawing(760, 340, "The temporal term of the response of Gaussians of three widths, against tau")
    middle = (len(data["signals"][0]) - 1) / 2
    times = [(f - middle) * data["step"] for f in range(len(data["signals"][0]))]
    p = Plot(d, 62, 40, 300, 235, Axis(-0.8, 0.8, [-0.8, -0.4, 0, 0.4, 0.8]), Axis(0, 1.1, [0, 0.5, 1]), "time (s)", "",
             "an event, and its levels in time")
    shown = [i for i, t in enumerate(times) if abs(t) <= 0.8]
    p.curve([times[i] for i in shown], [data["signals"][1][i] for i in shown], BLUE, 2.6)
    for tau, row, shade in zip(data["smoothed_tau"], data["smoothed"], ["#4d5259", "#83888f", "#b0b4ba"]):
        p.curve([times[i] for i in shown], [row[i] for i in shown], shade, 1.8)
        p.label(0.02 + tau, row[int(middle + tau / data["step"])], "τ = %.2f" % tau, shade, dx=8, dy=-4)
    p.label(0, 1, "the event, %g s" % data["widths"][1], BLUE, dx=14, dy=-2)
    p.frame()

    # of each Gaussian relative to its own depth: what matters is where the minimum is
    p = Plot(d, 440, 40, 300, 235, Axis(0.02, 0.8, [0.03, 0.06, 0.12, 0.24, 0.5], True), Axis(-1.08, 0.0, [-1, -0.5, 0]),
             "temporal scale τ (s)", "", "response in the middle of the event")
    for width, row, colour in zip(data["widths"], data["responses"], colours):
        deepest = -min(row)
        shown = [i for i, t in enumerate(data["tau"]) if 0.02 <= t <= 0.8]
        p.curve([data["tau"][i] for i in shown], [row[i] / deepest for i in shown], colour)
        p.curve([width, width], [-1.08, 0], colour, 1.2, stroke_dasharray="3 4")
        p.label(width, 0, "%g s" % width, colour, "middle", dy=17)
    p.frame()
    folder.write(d, "gaussians_in_time.svg")


def blob(folder):
    """The response of a blob against both scales."""
    data = folder.json("blob.json")
    sigma, tau, values = data["sigma"], data["tau"], data["response"]
    low = min(min(row) for row in values)
    d = Drawing(760, 400, "The response at the centre of a blob, against sigma and tau")
    # pixels are levels: half a step of the logarithm beyond the first and the last
    half = math.sqrt(sigma[1] / sigma[0])
    x = Axis(tau[0] / half, tau[-1] * half, [0.025, 0.05, 0.1, 0.2, 0.4], True)
    y = Axis(sigma[0] / half, sigma[-1] * half, [0.05, 0.1, 0.2, 0.4, 0.8], True)
    p = Plot(d, 70, 40, 290, 290, x, y, "temporal scale τ (s)", "spatial scale σ", "response at the blob's centre")
    p.picture(values, lambda t: RESPONSE_COLOURS((t - 1) / 2 + 0.5), low, 0)
    p.cross(data["duration"], data["size"], "#ffffff", 6)
    for s, t, _ in data["found"]:
        p.dots([t], [s], "#8fd3ff", 11, "none")
    p.frame()
    d.image(70, 382, 290, 9, png([[RESPONSE_COLOURS((i / 99 - 1) / 2 + 0.5) for i in range(100)]]))
    d.text(66, 391, "%.2f" % low, 12, "end", GREY)
    d.text(366, 391, "0", 12, "start", GREY)

    p = Plot(d, 450, 40, 285, 115, Axis(y.low, y.high, y.ticks, True), Axis(1.1 * low, 0.0, [-0.4, -0.2, 0]),
             "σ, at τ = %g s" % data["duration"])
    middle = min(range(len(tau)), key=lambda i: abs(tau[i] - data["duration"]))
    p.curve(sigma, [row[middle] for row in values], RED)
    p.dots(sigma, [row[middle] for row in values], RED, 2.2)
    p.curve([data["size"]] * 2, [1.1 * low, 0], INK, 1.2, stroke_dasharray="3 4")
    p.frame()
    p = Plot(d, 450, 230, 285, 115, Axis(x.low, x.high, x.ticks, True), Axis(1.1 * low, 0.0, [-0.4, -0.2, 0]),
             "τ (s), at σ = %g" % data["size"])
    middle = min(range(len(sigma)), key=lambda i: abs(sigma[i] - data["size"]))
    p.curve(tau, values[middle], BLUE)
    p.dots(tau, values[middle], BLUE, 2.2)
    p.curve([data["duration"]] * 2, [1.1 * low, 0], INK, 1.2, stroke_dasharray="3 4")
    p.frame()
    folder.write(d, "response_of_a_blob.svg")


def axes_of_map(data, times, heights, last_row=True, first_column=True):
    """Of time and height; each sample is in the middle of its pixel."""
    step, frames, rows = data["step"], len(data["deformation"][0]), len(data["height"])
    half = (data["height"][-1] - data["height"][0]) / (rows - 1) / 2
    return (Axis(-step / 2, (frames - 0.5) * step, times, labels=None if last_row else [""] * len(times)),
            Axis(data["height"][0] - half, data["height"][-1] + half, heights,
                 labels=None if first_column else [""] * len(heights)))


def cylinder_map(folder):
    """Where and when the bending cylinder is deformed, what is known of that, and what is found."""
    data = folder.json("cylinder.json")
    d = Drawing(760, 400, "Deformation of the bending cylinder over time and height, with known and found features")
    most = max(max(row) for row in data["deformation"])
    colours = folder.field_colours()
    x, y = axes_of_map(data, [0, 0.5, 1, 1.5], [0, 1, 2, 3, 4, 5, 6, 7])
    p = Plot(d, 62, 40, 500, 300, x, y, "time (s)", "height on the cylinder", "deformation along one side")
    p.picture(data["deformation"], colours, 0, most)
    for _, height, time, sigma, tau in data["known"]:
        p.cross(time, height, INK, 6)
        p.ellipse(time, height, tau, sigma, INK, 1.6, stroke_dasharray="4 3")
    for x, height, time, sigma, tau, _ in data["found"]:
        if x > 0:
            p.dots([time], [height], RED, 4, "#ffffff")
            p.ellipse(time, height, tau, sigma, RED, 2.2)
    p.frame()
    d.image(590, 100, 14, 240, png([[colours(1 - i / 99)] for i in range(100)]))
    for value in [0, most / 2, most]:
        d.text(610, 344 - 240 * value / most, "%.2f" % value, 13, "start", GREY)
    d.text(590, 62, "deformation", 13)
    d.line([(600, 366), (630, 366)], INK, 1.6, stroke_dasharray="4 3")
    d.text(638, 371, "known: ± σ, τ", 13)
    d.line([(600, 388), (630, 388)], RED, 2.2)
    d.text(638, 393, "found: ± σ, τ", 13)
    folder.write(d, "bending_cylinder_map.svg")


def levels(folder, name, title, colours, low, high, file, marks):
    data = folder.json("cylinder.json")
    sigma, tau = data["sigma"], data["tau"]
    d = Drawing(760, 560, title)
    for i, s in enumerate(reversed(sigma)):
        k = len(sigma) - 1 - i
        for l, t in enumerate(tau):
            left, top = 100 + 220 * l, 52 + 158 * i
            x, y = axes_of_map(data, [0, 0.5, 1, 1.5], [0, 3, 5.2], i == 2, l == 0)
            p = Plot(d, left, top, 205, 143, x, y)
            p.picture(data["%s_%d_%d" % (name, k, l)], colours, low, high)
            if marks:
                for side, height, time, found_sigma, found_tau, _ in data["found"]:
                    nearest_sigma = min(range(3), key=lambda j: abs(math.log(sigma[j] / found_sigma)))
                    nearest_tau = min(range(3), key=lambda j: abs(math.log(tau[j] / found_tau)))
                    if side > 0 and (nearest_sigma, nearest_tau) == (k, l):
                        p.dots([time], [height], BLUE, 9, "none")
            p.frame()
            if i == 0:
                d.text(left + 102, 30, "τ = %.2f s" % t, 15, "middle")
        d.text(0, 0, "σ = %.2f" % s, 15, "middle", transform="translate(38 %d) rotate(-90)" % (52 + 158 * i + 72))
    d.text(100 + 320, 552, "in each picture: time (s) →, height on the cylinder ↑", 13, "middle", GREY)
    folder.write(d, file)


def scale_space(folder):
    data = folder.json("cylinder.json")
    most = max(max(row) for row in data["smoothed_0_0"])
    levels(folder, "smoothed", "Levels of the scale space of the bending cylinder", folder.field_colours(), 0, most,
           "scale_space.svg", False)
    low = min(min(min(row) for row in data["response_%d_%d" % (k, l)]) for k in range(3) for l in range(3))
    levels(folder, "response", "The response at the same levels", RESPONSE_COLOURS, low, -low, "response_levels.svg", True)


def frame_rate(folder):
    """The same motion, filmed at several rates, in both presets."""
    rates = [15, 30, 60, 120]
    colours = [AMBER, RED, VIOLET, BLUE]
    d = Drawing(760, 350, "Features of one motion that was sampled at four rates")
    p = Plot(d, 62, 40, 300, 235, Axis(0.3, 1.2, [0.4, 0.6, 0.8, 1, 1.2]), Axis(0.04, 0.4, [0.05, 0.1, 0.2, 0.4], True),
             "time (s)", "τ (s)", "where in time, and how long")
    for i, (rate, colour) in enumerate(zip(rates, colours)):
        found = folder.json("rate_calibrated_%d.json" % rate)["features"]
        p.dots([f["time"] for f in found], [f["tau"] for f in found], colour, 11 - 2.6 * i, "none")
        p.label(0.32, 0.4, "%d frames in a second" % rate, colour, dx=18, dy=20 + 19 * i)
        p.drawing.add("circle", cx=p.at(0.32, 0.4)[0] + 6.0, cy=p.at(0.32, 0.4)[1] + 15.5 + 19.0 * i, r=5.0, fill="none",
                      stroke=colour, stroke_width=1.8)
    p.frame()
    p = Plot(d, 440, 40, 300, 235, Axis(12, 150, rates, True), Axis(0.2, 40, [0.3, 1, 3, 10, 30], True),
             "frames in a second", "strength", "strength of the strongest")
    for preset, words, colour, dy in [("published", "published", AMBER, -28), ("calibrated", "calibrated", GREEN, -12),
                                      ("range", "calibrated, range of τ given", BLUE, 22)]:
        strength = [folder.json("rate_%s_%d.json" % (preset, rate))["features"][0]["strength"] for rate in rates]
        p.curve(rates, strength, colour)
        p.dots(rates, strength, colour, 3.5)
        p.label(rates[0], strength[0], words, colour, dx=0, dy=dy)
    p.frame()
    folder.write(d, "frame_rate.svg")


def strain_measures(folder):
    data = folder.json("strain_measures.json")
    d = Drawing(760, 360, "Strain measures against the stretch of a triangle in one direction")
    p = Plot(d, 62, 30, 440, 270, Axis(0.25, 4, [0.25, 0.5, 1, 2, 4], True, ["¼", "½", "1", "2", "4"]),
             Axis(0, 4, [0, 1, 2, 3, 4]), "stretch in one direction", "strain")
    shown = [("hencky", "hencky (default)", GREEN, 3.2), ("green-lagrange", "green-lagrange", BLUE, 2),
             ("stretch-measure", "stretch", VIOLET, 2), ("largest-eigenvalue", "largest-eigenvalue (published)", AMBER, 2)]
    for i, (name, words, colour, width) in enumerate(shown):
        points = [(x, y) for x, y in zip(data["stretch"], data[name]) if y <= 4]
        p.curve([x for x, _ in points], [y for _, y in points], colour, width)
        d.line([(522, 62 + 26 * i), (548, 62 + 26 * i)], colour, width)
        d.text(556, 67 + 26 * i, words, 14)
    p.frame()
    folder.write(d, "strain_measures.svg")


def refinement(folder):
    data = folder.json("refinement.json")
    d = Drawing(760, 330, "Two curvature measures of a unit sphere that is meshed ever finer")
    edges = data["edge"]
    p = Plot(d, 70, 30, 420, 240, Axis(0.03, 0.4, [0.04, 0.08, 0.15, 0.3], True), Axis(-0.05, 1.2, [0, 0.25, 0.5, 0.75, 1]),
             "mean edge length of a sphere of radius 1", "measure")
    for name, words, colour in [("density", "density (default)", GREEN), ("dihedral", "mean dihedral angle", AMBER)]:
        p.curve(edges, data[name], colour)
        p.dots(edges, data[name], colour, 4)
        for i, value in enumerate(data[name]):
            p.label(edges[i], value, "%.3f" % value, colour, "middle", dy=-9)
    p.frame()
    for i, (words, colour) in enumerate([("density of mean curvature", GREEN), ("(default)", None),
                                         ("mean dihedral angle, rad", AMBER), ("(published)", None)]):
        if colour:
            d.line([(510, 62 + 24 * i), (536, 62 + 24 * i)], colour, 2.2)
        d.text(544, 67 + 24 * i, words, 14)
    folder.write(d, "curvature_under_refinement.svg")


def varying_density(folder):
    data = folder.json("varying_density.json")
    d = Drawing(760, 430, "Scales that are found of one blob on a mesh of varying density")
    strip, size = 0.3, data["size"]
    x = Axis(-1, 1, [])
    p = Plot(d, 62, 40, 660, 99, x, Axis(-strip / 2, strip / 2, []), "", "",
             "a part of the mesh (%d vertices), and the blob at nine places, σ = %g" % (data["vertices"], size))
    path = "".join("M%.1f %.1fL%.1f %.1f" % (p.at(e[0], e[1]) + p.at(e[2], e[3]))
                   for e in data["edges"] if max(abs(e[1]), abs(e[3])) < strip / 2)
    d.add("path", d=path, stroke=GREY, stroke_width=0.6, fill="none")
    for place in data["places"]:
        p.ellipse(place, 0, size, size, RED, 1.4)
    p.frame()
    q = Plot(d, 62, 160, 660, 210, Axis(-1, 1, data["places"]), Axis(0.7, 1.35, [0.8, 1, 1.2]), "place",
             "σ found over σ")
    for i, (name, words, colour) in enumerate([("heat", "heat diffusion (default)", GREEN),
                                               ("one_ring_per_vertex", "one-ring averages, σ at each vertex", BLUE),
                                               ("one_ring", "one-ring averages, one σ for all vertices", AMBER)]):
        q.curve(data["places"], data[name], colour)
        q.dots(data["places"], data[name], colour, 3.2)
        q.label(-0.98, 1.35, words, colour, dy=20 + 19 * i)
    q.frame()
    folder.write(d, "varying_density.svg")


def bands(folder):
    data = folder.json("bands.json")
    widths = data["widths"]
    d = Drawing(760, 330, "Scales that are found of bands around a tube")
    p = Plot(d, 70, 30, 400, 240, Axis(0.08, 0.7, widths, True), Axis(0.08, 1.5, [0.1, 0.2, 0.4, 0.8], True),
             "width of the band: standard deviation along the tube", "σ found")
    ends = [0.08, 0.7]
    p.curve(ends, ends, INK, 1.2, stroke_dasharray="3 4")
    pairs = [(w, f[0], f[1]) for w, f in zip(widths, data["found"]) if f]
    p.curve([w for w, _, _ in pairs], [s for _, s, _ in pairs], BLUE)
    for w, s, limited in pairs:
        p.dots([w], [s], RED if limited else BLUE, 4.5, "#ffffff" if limited else None)
        p.label(w, s, "%.2f" % (s / w), GREY, "middle", dy=-11)
    p.curve([data["radius"]] * 2, [0.08, 1.5], GREY, 1.2)
    p.label(data["radius"], 0.08, "radius of the tube", GREY, "end", dx=-6, dy=-8)
    p.frame()
    d.line([(500, 62), (526, 62)], BLUE, 2.2)
    d.text(534, 67, "σ of the feature; above it,", 13)
    d.text(534, 84, "its ratio to the width", 13)
    d.add("circle", cx=513.0, cy=107.0, r=4.5, fill="#ffffff", stroke=RED, stroke_width=1.8)
    d.text(534, 112, "at the limit of the scales", 13)
    d.line([(500, 134), (526, 134)], INK, 1.2, stroke_dasharray="3 4")
    d.text(534, 139, "the width itself", 13)
    folder.write(d, "bands.svg")


def noise(folder):
    data = folder.json("noise.json")
    d = Drawing(760, 330, "Strengths of known features and of those that noise makes")
    p = Plot(d, 70, 30, 660, 235, Axis(-0.5, len(data["levels"]) - 0.5, range(len(data["levels"])),
                                       labels=["%g %%" % (100 * x) for x in data["levels"]]),
             Axis(0.005, 3, [0.01, 0.03, 0.1, 0.3, 1], True), "standard deviation of the noise, of the mean edge length",
             "strength")
    for i, strengths in enumerate(data["strengths"]):
        false = [-s for s in strengths if s < 0]
        p.dots([i + 0.16] * len(false), false, AMBER, 3, "none")
        known = [s for s in strengths if s > 0]
        p.dots([i - 0.16] * len(known), known, GREEN, 5)
        p.label(i + 0.25, 0.005, "%d" % len(false), AMBER, dy=-6)
    p.frame()
    d.add("circle", cx=90.0, cy=318.0, r=5.0, fill=GREEN)
    d.text(101, 323, "at the known bends", 13)
    d.add("circle", cx=250.0, cy=318.0, r=3.5, fill="none", stroke=AMBER, stroke_width=1.8)
    d.text(260, 323, "elsewhere, and how many", 13)
    folder.write(d, "noise.svg")


def scales_of_features(folder):
    """sigma and tau of all features of the figure, and the ranges in which they were searched."""
    result = folder.json("figure.json")
    sigma, tau = result["parameters"]["sigma_levels"][2:-2], result["parameters"]["tau_levels"][2:-2]
    d = Drawing(760, 360, "Scales of the features of the running figure")
    p = Plot(d, 70, 30, 440, 270, Axis(sigma[0] / 1.2, sigma[-1] * 1.2, [0.02, 0.05, 0.1, 0.2, 0.4], True),
             Axis(tau[0] / 1.2, tau[-1] * 1.2, [0.05, 0.1, 0.2, 0.4], True), "σ (the figure is 2 high)", "τ (s)")
    corners = [(sigma[0], tau[0]), (sigma[-1], tau[0]), (sigma[-1], tau[-1]), (sigma[0], tau[-1]), (sigma[0], tau[0])]
    d.line([p.at(x, y) for x, y in corners], GREY, 1.5, stroke_dasharray="6 4")
    for f in result["features"]:
        limited = f["at_scale_limit"]
        p.dots([f["sigma"]], [f["tau"]], RED if limited else BLUE, 2.5 + 5 * f["strength"], "none" if limited else None,
               opacity=0.75)
    p.frame()
    d.add("circle", cx=535.0, cy=62.0, r=6.0, fill=BLUE, opacity=0.75)
    d.text(550, 67, "a feature; the larger, the stronger", 13)
    d.add("circle", cx=535.0, cy=88.0, r=6.0, fill="none", stroke=RED, stroke_width=1.8)
    d.text(550, 93, "at a limit of the scales", 13)
    d.line([(525, 114), (545, 114)], GREY, 1.5, stroke_dasharray="6 4")
    d.text(550, 119, "first and last level", 13)
    d.text(550, 136, "at which features are found", 13)
    folder.write(d, "scales_of_features.svg")


def pictures(folder, name, title, panels, columns, top, bottom):
    """Pictures that detect_features has drawn, with a line of text each; cropped to a part of their height."""
    sizes = [size_of_png(folder.bytes(file)) for file, _ in panels]
    width, height = sizes[0]
    scale = 740 / columns / width
    w, h = width * scale, height * scale * (bottom - top)
    rows = (len(panels) + columns - 1) // columns
    d = Drawing(760, int(10 + rows * (h + 30)), title)
    for i, (file, words) in enumerate(panels):
        x, y = 10 + (i % columns) * w, 8 + (i // columns) * (h + 30)
        d.text(x + w / 2, y + 16, words, 14, "middle")
        d.parts.append('<svg x="%s" y="%s" width="%s" height="%s">' % tuple(number(v) for v in [x, y + 24, w, h]))
        d.image(0, -top * height * scale, w, height * scale, folder.bytes(file))
        d.parts.append("</svg>")
    folder.write(d, name)


def main():
    folder = Folder(*sys.argv[1:])
    design(os.path.join(folder.figures, "design.svg"))
    for draw in [anatomy, gaussians_in_time, blob, cylinder_map, scale_space, frame_rate, strain_measures, refinement,
                 varying_density, bands, noise, scales_of_features]:
        draw(folder)
    pictures(folder, "choices.svg", "The running figure with other parameters",
             [("default.png", "default"), ("threshold.png", "--threshold 0.5"), ("alpha.png", "--alpha 0"),
              ("sigma.png", "--sigma-range :4%"), ("tau.png", "--tau-range 0.08:"),
              ("no_suppression.png", "--no-suppression")], 3, 0, 0.93)
    pictures(folder, "presets.svg", "The two presets", [("calibrated.png", "calibrated"), ("published.png", "published")], 2,
             0, 1)


main()
