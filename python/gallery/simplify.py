# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Fewer vertices for all frames: levels of detail of an animation, and how far they are from it.

    python3 simplify.py [OUTPUT.obj] [MESH CACHE]

Without files, a tube that bends. Writes the coarsest level, OUTPUT.obj and OUTPUT.pc2.
"""

import sys

import animated_mesh_features as amf
from tube import bending_tube


def main(path="coarse.obj", *files):
    animation = amf.read_animation(*files) if files else amf.Animation(*bending_tube(), rest="first")
    found = amf.detect(animation)
    # where features are while they last counts five times as much
    simplified = amf.simplify(animation, lods=(0.5, 0.25, 0.1), features=found, guidance=4)
    print(simplified)
    coarse = simplified.levels[-1]
    # Each vertex follows a few of the original: in this animation and in any other of the same mesh.
    # scipy.sparse.csr_matrix((coarse.data, coarse.indices, coarse.indptr), coarse.shape) @ frame
    positions = coarse.positions(animation)
    amf.write_animation(path, path.replace(".obj", ".pc2"), positions, coarse.faces, rest=coarse.vertices,
                        fps=animation.fps)
    print("positions:", " x ".join(map(str, positions.shape)), "written:", path)
    return positions


if __name__ == "__main__":
    main(*sys.argv[1:])
