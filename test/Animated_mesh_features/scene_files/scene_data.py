# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks, and what the tests of scenes compare with."""

import struct
import sys

_checks = 0


def check(condition, what):
    global _checks
    _checks += 1
    if not condition:
        sys.exit("failed: " + what)


def count():
    return _checks


def near(a, b, tolerance=1e-12):
    return abs(a - b) <= tolerance * max(1, abs(a), abs(b))


def read_npy(path):
    """The rows of a little-endian float32 array."""
    data = open(path, "rb").read()
    (length,) = struct.unpack("<H", data[8:10])
    n, f = eval(data[10:10 + length])["shape"]
    values = struct.unpack("<%df" % (n * f), data[10 + length:])
    return [values[v * f:(v + 1) * f] for v in range(n)]


def read_pc2(path):
    """The points of each frame."""
    data = open(path, "rb").read()
    n, f = struct.unpack("<i", data[16:20])[0], struct.unpack("<i", data[28:32])[0]
    xyz = struct.unpack("<%df" % (3 * n * f), data[32:])
    return [[xyz[3 * i:3 * i + 3] for i in range(k * n, (k + 1) * n)] for k in range(f)]


def read_triangles(path):
    rows = [line.split()[1:] for line in open(path) if line.startswith("f ")]
    return [tuple(int(corner.split("/")[0]) - 1 for corner in row) for row in rows]


def turned(triangle):
    """The same triangle, from its smallest vertex on."""
    i = triangle.index(min(triangle))
    return triangle[i:] + triangle[:i]
