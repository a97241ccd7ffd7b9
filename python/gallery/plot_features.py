# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Detects features and plots them: over time, and the field in which they were found as an image.

    python3 plot_features.py [OUTPUT.png] [MESH CACHE]

Without files, a tube that bends.
"""

import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import animated_mesh_features as amf
from tube import bending_tube


def plot(result, path):
    features, animation = result.features, result.animation
    times = animation.frame_duration * np.arange(animation.number_of_frames)
    figure, (above, below) = plt.subplots(2, 1, figsize=(8, 6), sharex=True, height_ratios=(2, 3), layout="constrained")
    # half of an event lies within 0.7 tau of its time
    half = 0.7 * features["tau"]
    above.hlines(features["strength"], features["time"] - half, features["time"] + half,
                 color="#2b6f8f", linewidth=1.5)
    dots = above.scatter(features["time"], features["strength"], c=features["sigma"], cmap="viridis", zorder=2)
    figure.colorbar(dots, ax=above, label="sigma (length)")
    above.set(ylabel="strength", title=f"{len(result)} features in {animation.number_of_frames} frames")
    # a row for each slice across the longest axis: what is near in space is near in the picture
    height = animation.vertices[:, np.ptp(animation.vertices, axis=0).argmax()]
    edges = np.linspace(height.min(), height.max(), 51)
    slices = np.clip(np.searchsorted(edges, height, side="right") - 1, 0, 49)
    largest = np.zeros((50, len(times)))
    np.maximum.at(largest, slices, result.deformation)
    image = below.pcolormesh(times, (edges[1:] + edges[:-1]) / 2, largest, shading="nearest", cmap="magma",
                             rasterized=True)
    below.scatter(features["time"], height[features["vertex"]], s=24, facecolors="none", edgecolors="#2fd0ff")
    figure.colorbar(image, ax=below, label="largest deformation")
    below.set(xlabel="time (s)", ylabel="longest axis, at rest")
    figure.savefig(path, dpi=120)


def main(path="features.png", *files):
    animation = amf.read_animation(*files) if files else amf.Animation(*bending_tube(), rest="first")
    result = amf.detect(animation)
    print(result)
    plot(result, path)
    print("written:", path)


if __name__ == "__main__":
    main(*sys.argv[1:])
