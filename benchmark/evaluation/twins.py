# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Twins of an animation: the same motion, sampled otherwise. A mesh is an array of points and one of triangles, its
frames an array of frames x vertices x 3, as OBJ and PC2 hold them. Deterministic; needs numpy."""

import heapq
import struct

import numpy


def read_obj(path):
    points, triangles = [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if words and words[0] == "v":
                points.append([float(w) for w in words[1:4]])
            elif words and words[0] == "f":
                corners = [int(w.split("/")[0]) - 1 for w in words[1:]]
                if len(corners) != 3:
                    raise ValueError(f"{path}: a face has {len(corners)} corners, not 3")
                triangles.append(corners)
    return numpy.array(points), numpy.array(triangles)


def read_pc2(path):
    with open(path, "rb") as file:
        magic, version, vertices, _, _, frames = struct.unpack("<12siiffi", file.read(32))
        if magic != b"POINTCACHE2\0" or version != 1:
            raise ValueError(f"{path}: no PointCache2 file of version 1")
        return numpy.fromfile(file, "<f4", 3 * vertices * frames).reshape(frames, vertices, 3).astype(float)


def write_obj(path, points, triangles):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines("v %.9g %.9g %.9g\n" % tuple(p) for p in points)
        file.writelines("f %d %d %d\n" % tuple(t + 1) for t in triangles)


def write_pc2(path, frames):
    with open(path, "wb") as file:
        file.write(struct.pack("<12siiffi", b"POINTCACHE2\0", 1, frames.shape[1], 0, 1, frames.shape[0]))
        frames.astype("<f4").tofile(file)


def diagonal(points):
    return float(numpy.linalg.norm(points.max(0) - points.min(0)))


def with_noise(rest, triangles, frames, share):
    """Every coordinate of every frame moved by Gaussian noise; `share`: its standard deviation, of the diagonal."""
    noise = numpy.random.default_rng(1).normal(0, share * diagonal(rest), frames.shape)
    return rest, triangles, frames + noise


def at_half_rate(rest, triangles, frames):
    return rest, triangles, frames[::2]


def at_double_rate(rest, triangles, frames):
    """Midpoints between the frames."""
    result = numpy.empty((2 * len(frames) - 1, *frames.shape[1:]))
    result[::2] = frames
    result[1::2] = (frames[:-1] + frames[1:]) / 2
    return rest, triangles, result


def turned(rest, triangles, frames):
    """By 50 degrees about (1, 2, 3) (Rodrigues' formula)."""
    x, y, z = numpy.array([1, 2, 3]) / numpy.sqrt(14)
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = numpy.radians(50)
    matrix = numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross
    return rest @ matrix.T, triangles, frames @ matrix.T


def scaled(rest, triangles, frames, factor):
    return rest * factor, triangles, frames * factor


def subdivided(rest, triangles, frames):
    """Each triangle cut into four at the midpoints of its edges; the old vertices come first."""
    edges = numpy.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    edges, index = numpy.unique(edges, axis=0, return_inverse=True)
    middle = (len(rest) + index.reshape(-1)).reshape(-1, 3)
    a, b, c = triangles.T
    ab, bc, ca = middle.T
    finer = numpy.concatenate([numpy.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])

    def refine(points):
        return numpy.concatenate([points, points[..., edges, :].mean(-2)], axis=-2)
    return refine(rest), finer, refine(frames)


class Decimation:
    """Half-edge collapses, the shortest edge first: what is left are vertices of the mesh, so that the motion is exact.
    A collapse must keep the surface a manifold and turn no triangle round; vertices at borders stay."""

    def __init__(self, points, triangles):
        self.points = points
        self.triangles = [tuple(t) for t in triangles.tolist()]
        self.around = [set() for _ in points]
        for number, t in enumerate(self.triangles):
            for v in t:
                self.around[v].add(number)
        self.left = int(sum(1 for a in self.around if a))

    def neighbours(self, v):
        return {w for t in self.around[v] for w in self.triangles[t]} - {v}

    def length(self, a, b):
        return float(numpy.linalg.norm(self.points[a] - self.points[b]))

    def normal(self, t):
        p, q, r = (self.points[v] for v in t)
        n = numpy.cross(q - p, r - p)
        return n, float(numpy.linalg.norm(n))

    def can_collapse(self, gone, kept):
        ring = self.neighbours(gone)
        if len(ring) != len(self.around[gone]) or kept not in ring:
            return False  # at a border, or not there any more
        if len(ring & self.neighbours(kept)) != 2 or len(ring) < 4:
            return False  # it would be no manifold
        for t in self.around[gone]:
            corners = self.triangles[t]
            if kept in corners:
                continue
            before, area_before = self.normal(corners)
            after, area_after = self.normal([kept if v == gone else v for v in corners])
            if not before @ after > 0.5 * area_before * area_after:
                return False
            longest = max(self.length(kept, v) for v in corners if v != gone)
            if area_after < 0.15 * longest * longest:
                return False  # a sliver
        return True

    def collapse(self, gone, kept):
        for t in list(self.around[gone]):
            corners = self.triangles[t]
            if kept in corners:
                for v in corners:
                    self.around[v].discard(t)
                self.triangles[t] = None
            else:
                self.triangles[t] = tuple(kept if v == gone else v for v in corners)
                self.around[kept].add(t)
        self.around[gone] = set()
        self.left -= 1

    def reduce(self, target, may_go):
        """Until `target` vertices are left, or none of those that may go can."""
        heap = [(self.length(v, w), v, w) for v in range(len(self.points)) if may_go[v] for w in self.neighbours(v)]
        heapq.heapify(heap)
        while heap and self.left > target:
            _, gone, kept = heapq.heappop(heap)
            if not self.around[gone] or not self.around[kept] or not self.can_collapse(gone, kept):
                continue
            ring = self.neighbours(gone)
            self.collapse(gone, kept)
            for v in ring - {kept}:
                for a, b in ((v, kept), (kept, v)):
                    if may_go[a]:
                        heapq.heappush(heap, (self.length(a, b), a, b))

    def result(self, rest, frames):
        kept = numpy.array([v for v, a in enumerate(self.around) if a])
        number = numpy.full(len(self.points), -1)
        number[kept] = numpy.arange(len(kept))
        triangles = numpy.array([number[list(t)] for t in self.triangles if t])
        return rest[kept], triangles, frames[:, kept]


def with_fewer_vertices(rest, triangles, frames, share):
    decimation = Decimation(rest, triangles)
    decimation.reduce(int(share * len(rest)), numpy.ones(len(rest), bool))
    return decimation.result(rest, frames)


def with_irregular_density(rest, triangles, frames):
    """A third of the vertices left on one half, the one of greater coordinates along the body's longest axis."""
    axis = int(numpy.argmax(rest.max(0) - rest.min(0)))
    may_go = rest[:, axis] > numpy.median(rest[:, axis])
    decimation = Decimation(rest, triangles)
    decimation.reduce(len(rest) - int(may_go.sum()) * 2 // 3, may_go)
    return decimation.result(rest, frames)
