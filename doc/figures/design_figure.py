# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The drawing of the package's design: what is computed from what, and which concept stands for each step."""

from svg import BLUE, GREEN, GREY, INK, Drawing

# what is computed, its shape, concept, models with the default first
STEPS = [
    ("animation", "mesh, F frames, rest shape, frame rate", "MeshAnimation", ["Frame_sequence"]),
    ("strain", "N × F", "StrainMeasure", ["Hencky_strain", "Green_lagrange_…, Principal_stretch_…,",
                                          "Largest_eigenvalue_strain"]),
    ("geodesic balls", "a list for each vertex", "GeodesicBalls",
     ["Heat_method_geodesic_balls", "CGAL_…, Global_…, Dijkstra_geodesic_balls"]),
    ("change of curvature", "N × F", "CurvatureMeasure", ["Mean_curvature_density", "Mean_dihedral_angle"]),
    ("deformation", "N × F: strain + α · change of curvature", "", ["or any field of yours"]),
    ("levels of σ and τ", "two lists of variances", "ScaleSampling", ["Fixed_ratio_sampling", "Every_smoothing_count"]),
    ("smoothing in space", "K × N × F, a batch of levels at a time", "SpatialFilter",
     ["Heat_diffusion_filter", "One_ring_average_filter"]),
    ("smoothing in time", "K × L × F, a vertex at a time", "TemporalFilter",
     ["Gaussian_temporal_filter", "Box_temporal_filter"]),
    ("response", "differences of neighbouring levels", "SpaceTimeResponse",
     ["Central_difference_of_gaussians", "Forward_difference_of_gaussians"]),
    ("minima", "over place, time, σ and τ", "ExtremumSearch", ["Difference_of_gaussians_minima"]),
    ("features", "thresholds, suppression; refined", "", ["Spatio_temporal_feature"]),
]


def design(path):
    row, top = 62, 56
    d = Drawing(760, top + row * len(STEPS) + 12, "What is computed from what, and what can be replaced")
    d.text(130, 32, "what is computed", 14, "middle", GREY)
    d.text(356, 32, "concept", 14, "middle", GREY)
    d.text(450, 32, "models, the default first", 14, "start", GREY)
    box, height = 226, 44

    def y(i):
        return top + row * i

    def arrow(points):
        d.line(points, GREY, 1.6)
        (ax, ay), (bx, by) = points[-2:]
        size = 5
        if bx == ax:
            tip = [(bx - size, by - 1.6 * size), (bx, by), (bx + size, by - 1.6 * size)]
        else:
            tip = [(bx - 1.6 * size, by - size), (bx, by), (bx - 1.6 * size, by + size)]
        d.line(tip, GREY, 1.6)

    for i, (name, shape, concept, models) in enumerate(STEPS):
        d.add("rect", x=20, y=y(i), width=box, height=height, rx=6, fill="#eef4fa" if concept else "#f4f4f2", stroke=BLUE
              if concept else GREY, stroke_width=1.4)
        d.text(20 + box / 2, y(i) + 19, name, 15, "middle", font_weight="bold")
        d.text(20 + box / 2, y(i) + 36, shape, 12, "middle", GREY)
        if concept:
            d.line([(20 + box, y(i) + height / 2), (290, y(i) + height / 2)], BLUE, 1.2, stroke_dasharray="3 3")
            d.add("rect", x=290, y=y(i) + 8, width=140, height=28, rx=14, fill="#ffffff", stroke=BLUE, stroke_width=1.4)
            d.text(360, y(i) + 27, concept, 13, "middle", BLUE)
        d.text(450, y(i) + (12 if len(models) > 2 else 18), models[0], 13, "start", GREEN if concept else INK)
        for j, words in enumerate(models[1:]):
            d.text(450, y(i) + (27 if len(models) > 2 else 34) + 14 * j, words, 12, "start", GREY)
    middle = 20 + box / 2
    for i in range(len(STEPS) - 1):
        if STEPS[i][0] != "strain":
            arrow([(middle, y(i) + height), (middle, y(i + 1))])
    # the animation is needed again for the curvature, its rest shape for the balls; strain goes past both
    for i in (2, 3):
        arrow([(20, y(0) + height / 2), (8, y(0) + height / 2), (8, y(i) + height / 2), (20, y(i) + height / 2)])
    d.line([(20 + box, y(1) + height / 2 + 12), (264, y(1) + height / 2 + 12), (264, y(4) + height / 2),
            (20 + box, y(4) + height / 2)], GREY, 1.6)
    d.line([(20 + box + 8, y(4) + height / 2 - 5), (20 + box, y(4) + height / 2), (20 + box + 8, y(4) + height / 2 + 5)],
           GREY, 1.6)
    d.write(path)
