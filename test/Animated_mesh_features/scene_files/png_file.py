# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Pixels of a PNG."""

import struct
import zlib


def read_png(path):
    """The pixels of a PNG, 8 bits RGB without interlace: a list of rows, each a list of (r, g, b)."""
    data = open(path, "rb").read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    position, chunks = 8, []
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        content = data[position + 8:position + 8 + length]
        assert struct.unpack(">I", data[position + 8 + length:position + 12 + length])[0] == zlib.crc32(kind + content)
        chunks.append((kind, content))
        position += 12 + length
    kinds = [k for k, _ in chunks]
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND" and set(kinds) <= {b"IHDR", b"bKGD", b"IDAT", b"IEND"}
    width, height, *kind = struct.unpack(">IIBBBBB", chunks[0][1])
    assert kind == [8, 2, 0, 0, 0]
    raw, n = zlib.decompress(b"".join(c for k, c in chunks if k == b"IDAT")), 3 * width
    assert len(raw) == height * (n + 1)
    above, result = bytearray(n + 3), []
    for y in range(height):
        line, row, method = raw[y * (n + 1) + 1:(y + 1) * (n + 1)], bytearray(n + 3), raw[y * (n + 1)]
        assert method <= 4
        if method == 0:
            row[3:] = line
        for i in range(n if method else 0):
            a, b, c = row[i], above[i + 3], above[i]
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2] if method == 4 else 0
            row[i + 3] = (line[i] + (0, a, b, (a + b) // 2, paeth)[method]) & 255
        above = row
        result.append([tuple(row[i:i + 3]) for i in range(3, n + 3, 3)])
    return result
