# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Features of a sequence of an HDF5 file as D-FAUST has it: vertices x 3 x frames, read by h5py.

    python3 read_hdf5.py [FILE SEQUENCE]

Without a file, one is made. transpose() turns the array round without a copy, and it is read where it is. (The module
reads such files itself, too: amf.read_animation("file.h5", clip="SEQUENCE").)
"""

import os
import sys
import tempfile

import h5py
import numpy as np

import animated_mesh_features as amf
from tube import bending_tube


def detect_in(path, sequence):
    with h5py.File(path, "r") as file:
        positions = file[sequence][()]  # N x 3 x F
        faces = file["faces"][()]
    return amf.detect(positions.transpose(2, 0, 1), faces, fps=60)


def main(path=None, sequence="tube_bends"):
    if path is not None:
        print(sequence, detect_in(path, sequence))
        return None
    frames, faces = bending_tube(frames=60, frame_duration=1 / 60, when=0.5)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "tubes.h5")
        with h5py.File(path, "w") as file:
            file[sequence] = frames.astype(np.float32).transpose(1, 2, 0)
            file["faces"] = faces.astype(np.uint32)
        result = detect_in(path, sequence)
    print(sequence, result)
    best = result.features[0]
    print(f"at {best['time']:.3f} s, at {np.round(best['position'], 3)}, sigma {best['sigma']:.3f}, "
          f"tau {best['tau']:.3f} s")
    return result


if __name__ == "__main__":
    main(*sys.argv[1:])
