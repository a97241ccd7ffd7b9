# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A loop over a corpus: a signature of each animation, and a matrix of how unlike each pair is.

    python3 compare_corpus.py

The corpus: tubes of different meshes and frame rates, which bend once or twice. Bodies need not correspond: motions are
compared by how much of the surface deforms when.
"""

import numpy as np

import animated_mesh_features as amf
from tube import bending_tube

CORPUS = {"one bend": dict(bends=[(0.5, 0.6)]),
          "one bend, coarser": dict(bends=[(0.5, 0.6)], around=16, along=40),
          "one bend, 60 a second": dict(bends=[(0.4, 0.6)], frames=80, frame_duration=1 / 60),
          "two bends": dict(bends=[(0.3, 0.3), (0.7, 0.9)]),
          "two bends, coarser": dict(bends=[(0.35, 0.3), (0.65, 0.9)], around=20, along=50)}


def motion(bends, frame_duration=1 / 30, **shape):
    """bends one after the other: those of tubes that bend once, added"""
    tubes = [bending_tube(at=at, when=when, frame_duration=frame_duration, **shape) for at, when in bends]
    still = tubes[0][0][0]
    return still + sum(positions - still for positions, _ in tubes), tubes[0][1], frame_duration


def main():
    signatures = {}
    for name, options in CORPUS.items():
        frames, faces, frame_duration = motion(**options)
        # the straight tube, the first frame, is the shape at rest
        found = amf.detect(frames, faces, frame_duration=frame_duration, rest="first", top=20)
        signatures[name] = amf.signature(found)  # some kilobytes; the animation may go
        print(f"{name:24}", signatures[name])
    distance = amf.distance_matrix(signatures.values())
    print("\ndistances")
    for name, row in zip(signatures, distance):
        print(f"{name:24}", " ".join(f"{d:.2f}" for d in row))
    return distance


if __name__ == "__main__":
    main()
