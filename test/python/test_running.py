# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Progress, cancellation, Ctrl-C, threads, memory."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import animated_mesh_features as amf


def test_visitor(cylinder):
    told = []
    amf.detect(cylinder.frames, cylinder.faces, rest="average", visitor=lambda *stage: told.append(stage))
    assert {s for s, _ in told} == {"rest shape", "geodesic balls", "strain", "curvature", "scale space", "extrema"}
    for stage in ("geodesic balls", "strain", "curvature"):
        fractions = [f for s, f in told if s == stage]
        assert fractions[0] == 0 and fractions[-1] == 1 and sorted(fractions) == fractions


@pytest.mark.parametrize("stage", ["rest shape", "geodesic balls", "strain", "curvature", "scale space", "extrema"])
def test_cancellation(cylinder, stage):
    with pytest.raises(amf.Cancelled, match="cancelled by the visitor"):
        amf.detect(cylinder.frames, cylinder.faces, rest="average", visitor=lambda s, _: s != stage)
    error = KeyError("mine")

    def fail(s, _):
        if s == stage:
            raise error

    with pytest.raises(KeyError) as e:
        amf.detect(cylinder.frames, cylinder.faces, rest="average", visitor=fail)
    assert e.value is error
    # None and what else is true or false goes on: False only cancels
    assert len(amf.detect(cylinder.frames, cylinder.faces, rest="average", visitor=lambda *_: 0)) > 0


def test_ctrl_c(cylinder):
    """KeyboardInterrupt soon after the signal, from the middle of a computation"""
    np.save(cylinder.folder / "f.npy", cylinder.frames)
    np.save(cylinder.folder / "t.npy", cylinder.faces)
    code = f"""
import numpy as np, sys, threading, os, signal, time
import animated_mesh_features as amf
a = amf.Animation(np.load({str(cylinder.folder / 'f.npy')!r}), np.load({str(cylinder.folder / 't.npy')!r}), rest=0)
signal.signal(signal.SIGINT, signal.default_int_handler)  # what runs in the background may ignore it
def interrupt():
    time.sleep(0.3)
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=interrupt).start()
try:
    end = time.monotonic() + 20
    while time.monotonic() < end:
        amf.detect(a)
except KeyboardInterrupt:
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout == "interrupted\n", done.stderr


def test_threads(cylinder):
    """the same bits on any number of threads, and in several threads of Python at a time; the lock is released"""
    a = amf.Animation(cylinder.frames, cylinder.faces, rest="average")
    expected = amf.detect(a)
    for threads in (1, 2, 3):
        r = amf.detect(a, threads=threads)
        assert np.array_equal(r.features, expected.features) and np.array_equal(r.deformation, expected.deformation)
    results, ticks = [None] * 4, []

    def work(i):
        results[i] = amf.detect(a, visitor=lambda *_: None)

    workers = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for w in workers:
        w.start()
    while any(w.is_alive() for w in workers):
        ticks.append(time.perf_counter())
        time.sleep(0.001)
    for r in results:
        assert np.array_equal(r.features, expected.features)
    assert len(ticks) > 3  # this thread ran meanwhile


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="memory cannot be told here")
def test_no_leak(cylinder):
    """1,000 calls, of which each would leave at least its fields of 10 kB behind if it left any"""
    keep = (cylinder.faces < 80).all(axis=1)
    frames, faces = cylinder.frames[:16, :80], cylinder.faces[keep]

    def call(i):
        r = amf.detect(frames, faces, rest="first", threads=1, alpha=0, sigma_range=("20%", "21%"),
                       tau_range=(0.1, 0.11), dimension="plane" if i % 10 else "surface", visitor=lambda *_: None)
        assert r.deformation.shape == (80, 16)
        with pytest.raises(amf.InputError):
            amf.detect(frames[:2], faces)
        if i % 20 == 0:
            with pytest.raises(amf.Cancelled):
                amf.detect(frames, faces, rest="first", threads=1, visitor=lambda *_: False)

    for i in range(200):
        call(i)
    before = resident()
    for i in range(800):
        call(i)
    assert resident() - before < 2e6  # one field a call would be 8 MB, all that a call has some 50 MB


def test_views_keep_their_owner(cylinder):
    x = amf.Animation(cylinder.frames, cylinder.faces, rest="first").x
    d = amf.detect(cylinder.frames, cylinder.faces, rest="first").deformation
    s = amf.strain(cylinder.frames, cylinder.faces, rest="first")
    sums = [d.sum(), s.sum()]
    [np.ones(10 ** 6) for _ in range(20)]  # whatever was given back is overwritten
    assert np.array_equal(x, cylinder.frames[:, :, 0].T) and [d.sum(), s.sum()] == sums


def test_scratch_directory(cylinder, tmp_path):
    """what does not fit is computed on a disk, with the same result"""
    expected = amf.detect(cylinder.frames, cylinder.faces, rest="first")
    with pytest.raises(amf.Error, match="memory"):
        amf.Animation(cylinder.frames, cylinder.faces, rest="first", memory="1K", scratch=tmp_path)
    a = amf.Animation(cylinder.frames, cylinder.faces, rest="first", memory=1 << 30, scratch=tmp_path)
    assert np.array_equal(amf.detect(a).features, expected.features)
