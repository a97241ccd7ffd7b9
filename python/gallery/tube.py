# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""An animation to play with, in a few lines of NumPy: a tube that bends."""

import numpy as np


def bending_tube(frames=40, around=24, along=60, frame_duration=1 / 30, at=0.5, when=0.6, lasts=0.12, angle=1.2):
    """F x N x 3, T x 3: a tube of length 1 and radius 0.08 that bends once, about the height `at`, at the time `when`
    (s)."""
    turn, height = np.meshgrid(np.linspace(0, 2 * np.pi, around, endpoint=False), np.linspace(0, 1, along))
    tube = np.stack([0.08 * np.cos(turn), 0.08 * np.sin(turn), height], axis=-1).reshape(-1, 3)
    ring, column = np.meshgrid(np.arange(along - 1), np.arange(around), indexing="ij")
    a, b = ring * around + column, ring * around + (column + 1) % around
    faces = np.concatenate([np.stack([a, b, b + around], -1).reshape(-1, 3),
                            np.stack([a, b + around, a + around], -1).reshape(-1, 3)])
    # What is above the joint turns about it; in a short stretch around it, by a part of the angle.
    share = np.clip((tube[:, 2] - at) / 0.16 + 0.5, 0, 1)
    positions = []
    for f in range(frames):
        bend = angle * np.exp(-(f * frame_duration - when) ** 2 / 2 / lasts ** 2) * share * share * (3 - 2 * share)
        x, z = tube[:, 0], tube[:, 2] - at
        positions.append(np.stack([x * np.cos(bend) + z * np.sin(bend), tube[:, 1],
                                   z * np.cos(bend) - x * np.sin(bend) + at], axis=-1))
    return np.array(positions), faces
