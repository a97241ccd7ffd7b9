# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A loop over a corpus: features of each animation, and a matrix of how many of them each pair has in common.

    python3 compare_corpus.py

The corpus: one tube that bends at several places and times. Two features are the same if they are near in place and
time, so all animations must be of one body; the distance of two is 1 - the share of features that have a partner.
"""

import itertools

import numpy as np

import animated_mesh_features as amf
from tube import bending_tube

CORPUS = {"middle, early": dict(at=0.5, when=0.4), "middle, a little later": dict(at=0.5, when=0.46),
          "middle, late": dict(at=0.5, when=0.9), "below, early": dict(at=0.3, when=0.4),
          "above, late": dict(at=0.7, when=0.9)}


def main():
    results = {}
    for name, motion in CORPUS.items():
        # the straight tube, the first frame, is the common shape at rest
        results[name] = amf.detect(*bending_tube(**motion), rest="first", top=20)
        print(f"{name:24}", results[name])
    diameter = next(iter(results.values())).animation.diameter
    distance = np.zeros((len(results), len(results)))
    chance = []
    for (i, a), (j, b) in itertools.combinations(enumerate(results.values()), 2):
        gates = dict(place=0.05 * diameter, time=0.1)
        distance[i, j] = distance[j, i] = 1 - amf.evaluation.paired_features(a, b, **gates)[0].mean()
        shifted = amf.evaluation.shifted_in_time(b, 0.29 * 40 / 30, 40 / 30)
        chance.append(1 - amf.evaluation.paired_features(a, shifted, **gates)[0].mean())
    print("\ndistances (of the same moved in time: %.2f in the mean)" % np.mean(chance))
    for name, row in zip(results, distance):
        print(f"{name:24}", " ".join(f"{d:.2f}" for d in row))
    return distance


if __name__ == "__main__":
    main()
