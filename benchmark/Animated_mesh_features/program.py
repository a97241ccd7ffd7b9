#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The command-line program from files to files: time of each stage as it tells itself, peak memory as the system tells.

program.py DETECT_FEATURES MAKE_ANIMATION [--quick] [--data DIR] [--json FILE]
"""

import argparse
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import time

STAGES = ["reading", "geodesic balls", "curvature", "strain", "scale space", "extrema", "writing"]


def run(command):
    """The stages of a detection in s, its wall time in s and its peak memory in bytes."""
    with tempfile.TemporaryFile("w+") as log:
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read()
    if process.returncode != 0:
        sys.exit(" ".join(command) + " failed:\n" + text)
    stages = {}
    for line in text.splitlines():
        match = re.match(r"(\S.*?) +([0-9.]+) s( +[0-9]+ MB)?$", line)
        if match and match.group(1) in STAGES:
            stages[match.group(1)] = float(match.group(2))
    if "reading" not in stages:
        sys.exit(" ".join(command) + " --verbose tells no stages:\n" + text)
    features = re.search(r"(\d+) features?,", text)
    unit = 1 if sys.platform == "darwin" else 1024
    return {"stages": stages, "seconds": seconds, "memory": usage.ru_maxrss * unit,
            "features": int(features.group(1)) if features else None}


def thread_counts():
    cores = os.cpu_count() or 1
    return [1, cores] if cores > 1 else [1]


class Table:
    def __init__(self, title, note, columns):
        self.value = {"title": title, "note": note, "columns": columns, "rows": []}

    def add(self, *row):
        assert len(row) == len(self.value["columns"])
        self.value["rows"].append(list(row))
        print(".", end="", file=sys.stderr, flush=True)

    def print(self):
        def shown(cell):
            if cell is None:
                return ""
            if isinstance(cell, float):
                return "%.0f" % cell if abs(cell) >= 100 else "%.3g" % cell
            return str(cell)

        rows = [self.value["columns"]] + [[shown(c) for c in row] for row in self.value["rows"]]
        widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
        print("\n== " + self.value["title"] + "\n" + self.value["note"] + "\n")
        for row in rows:
            print("  " + "  ".join(c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(row, widths))))
        sys.stdout.flush()


def add_detection(table, arguments, label, inputs, options, threads, repetitions):
    """A row with the run that took the least time."""
    with tempfile.TemporaryDirectory() as folder:
        command = [arguments.detect_features, *inputs, *options, "--verbose", "--threads", str(threads),
                   "-o", os.path.join(folder, "features.json"), "-o", os.path.join(folder, "features.csv")]
        best = min((run(command) for _ in range(repetitions)), key=lambda r: r["seconds"])
    stages = best["stages"]
    table.add(label, threads, *[stages.get(s) for s in STAGES], best["seconds"], best["memory"] / 1e6, best["features"])
    return best


def detection_table(title, note):
    return Table(title, note, ["input, preset", "threads"] + [s + " s" for s in STAGES]
                 + ["wall s", "peak MB", "features"])


def frames_of(pc2):
    with open(pc2, "rb") as file:
        magic, _, points, _, _, frames = struct.unpack("<12siiffi", file.read(32))
        assert magic == b"POINTCACHE2\0", pc2
        for _ in range(frames):
            yield struct.unpack("<%df" % (3 * points), file.read(12 * points))


def write_obj_frames(obj, pc2, folder):
    with open(obj) as file:
        faces = "".join(line for line in file if line.startswith("f "))
    for number, xyz in enumerate(frames_of(pc2)):
        points = iter(xyz)
        with open(os.path.join(folder, "frame%03d.obj" % number), "w") as file:
            file.writelines("v %.7g %.7g %.7g\n" % point for point in zip(points, points, points))
            file.write(faces)


def seconds_to_read(paths):
    """All bytes of some files, from the system's cache; nothing is done with them."""
    best = float("inf")
    for _ in range(3):
        start = time.perf_counter()
        for path in paths:
            with open(path, "rb", buffering=0) as file:
                buffer = bytearray(1 << 20)
                while file.readinto(buffer):
                    pass
        best = min(best, time.perf_counter() - start)
    return best


def make(arguments, folder, what, vertices, frames):
    base = os.path.join(folder, "%s_%d_%d" % (what, vertices, frames))
    subprocess.run([arguments.make_animation, what, "--vertices", str(vertices), "--frames", str(frames),
                    "--fps", "%.6g" % (frames / 1.6), "-o", base], check=True, stdout=subprocess.DEVNULL)
    return base + ".obj", base + ".pc2"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("detect_features")
    parser.add_argument("make_animation")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--data")
    parser.add_argument("--json")
    arguments = parser.parse_args()
    repetitions = 1 if arguments.quick else 5
    tables = []

    reading = Table("Reading", "The stage 'reading' of the program against reading the same bytes from the system's "
                    "cache and doing nothing with them. MB/s: of the files.",
                    ["input", "threads", "MB", "bytes only s", "reading s", "MB/s", "reading / bytes only"])

    def add_reading(label, threads, files, best):
        size = sum(os.path.getsize(f) for f in files) / 1e6
        seconds = best["stages"]["reading"]
        least = seconds_to_read(files)
        reading.add(label, threads, size, least, seconds, size / max(seconds, 1e-9), seconds / least)

    with tempfile.TemporaryDirectory() as folder:
        data = arguments.data
        if data and os.path.exists(os.path.join(data, "horse-gallop.pc2")):
            name = "horse-gallop"
            obj, pc2 = os.path.join(data, name + ".obj"), os.path.join(data, name + ".pc2")
            rest = ["--rest", os.path.join(data, "horse-rest.obj")]
        else:
            name = "figure"
            obj, pc2 = make(arguments, folder, "figure", 1500 if arguments.quick else 8431, 48)
            rest = ["--rest", obj]
        obj_folder = os.path.join(folder, "frames")
        os.mkdir(obj_folder)
        write_obj_frames(obj, pc2, obj_folder)
        obj_files = sorted(os.path.join(obj_folder, f) for f in os.listdir(obj_folder))

        table = detection_table("The whole program: " + name,
                                "detect_features from files to JSON and CSV. Wall: from start to end of the process; "
                                "peak: of its memory. Of %d runs, the one with the least wall time." % repetitions)
        for threads in thread_counts():
            for preset in ["calibrated", "published"]:
                best = add_detection(table, arguments, "PC2, " + preset, [obj, pc2], rest + ["--preset", preset],
                                     threads, repetitions)
            add_reading("PC2, " + name, threads, [obj, pc2], best)
            best = add_detection(table, arguments, "48 OBJ, calibrated", [obj_folder], rest, threads, repetitions)
            add_reading("48 OBJ, " + name, threads, obj_files, best)
        table.print()
        tables.append(table.value)

        vertices, frames = (1200, 40) if arguments.quick else (4250, 100)
        obj, pc2 = make(arguments, folder, "figure", vertices, frames)
        table = detection_table("The whole program: of the size of the paper's woman",
                                "Running figure of about %d vertices in %d frames, preset published with a box of 10 "
                                "frames, which is every smoothing count; rest shape from a file. The paper reports "
                                "about 2 minutes on a processor of four cores of 2011." % (vertices, frames))
        for threads in thread_counts():
            add_detection(table, arguments, "PC2, published", [obj, pc2],
                          ["--rest", obj, "--preset", "published", "--box-width", "10"], threads, repetitions)
        table.print()
        tables.append(table.value)

        vertices, frames = (2000, 30) if arguments.quick else (100000, 300)
        obj, pc2 = make(arguments, folder, "cylinder", vertices, frames)
        table = detection_table("The whole program: a long animation of a large mesh",
                                "Bending cylinder of about %d vertices in %d frames, PC2, preset calibrated, rest "
                                "shape from a file." % (vertices, frames))
        for threads in thread_counts():
            best = add_detection(table, arguments, "PC2, calibrated", [obj, pc2], ["--rest", obj], threads,
                                 1 if arguments.quick else 2)
            add_reading("PC2, cylinder", threads, [obj, pc2], best)
        table.print()
        tables.append(table.value)
        reading.print()
        tables.append(reading.value)

    if arguments.json:
        with open(arguments.json, "w") as file:
            json.dump({"program": "program", "quick": arguments.quick, "tables": tables}, file, indent=1)


main()
