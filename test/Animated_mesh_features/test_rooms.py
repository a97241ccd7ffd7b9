# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Who may include whom, read from the include lines: a room includes the rooms below it, a room's internal/ is closed to
all others, nothing goes round in a circle, and programs, examples, benchmarks and figures stay outside of internal/.

test_rooms.py SOURCE_FOLDER
"""

import pathlib
import re
import sys
import tempfile

PACKAGE = "CGAL/Animated_mesh_features/"
FEATURE_TYPE = ["Detection/Feature_point.h", "Detection/Spatio_temporal_feature.h"]
STAGES = ["Numerics/", "Animation/", "Geodesic_balls/", "Scale_space/", "Deformation/", "Extrema/", "Detection/"]

# What each room may include apart from itself; the door, which is in no room, is "".
MAY_INCLUDE = {
    "Numerics/": [],
    "Animation/": ["Numerics/"],
    "Geodesic_balls/": ["Numerics/", "Animation/"],
    "Scale_space/": ["Numerics/", "Animation/"],
    "Deformation/": ["Numerics/", "Animation/", "Geodesic_balls/"],
    "Extrema/": ["Numerics/", "Animation/", "Scale_space/"],
    "Detection/": STAGES,
    "Descriptors/": ["Numerics/", "Animation/", "Geodesic_balls/"] + FEATURE_TYPE,
    "Evaluation/": ["Numerics/", "Animation/", "Geodesic_balls/"] + FEATURE_TYPE,
    "Applications/": STAGES + ["Descriptors/", "Evaluation/"],
    "IO/": ["Numerics/", "Animation/"] + FEATURE_TYPE,
    "": STAGES,
}

# What is used from outside nevertheless, by folder.
OPEN = {
    "examples": [],
    # solvers are compared on the very systems that the package solves
    "benchmark": ["Geodesic_balls/internal/Patch_factors.h", "Geodesic_balls/internal/Surface_patch.h",
                  "Geodesic_balls/internal/Vertex_clusters.h", "Scale_space/internal/Heat_system.h"],
    "doc": [],
    "python": [],
}


def include_lines(folder):
    """(file, what it includes) for all headers of CGAL, both as they are written in include lines."""
    for path in sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp")):
        for included in re.findall(r'^\s*#\s*include\s*[<"](CGAL/[^>"]+)[>"]', path.read_text(), re.MULTILINE):
            yield path.relative_to(folder).as_posix(), included


def circle_from(file, graph, way, done):
    """The files of a circle that can be reached from a file, the first one twice; empty if there is none."""
    if file in way:
        return way[way.index(file):] + [file]
    circles = (circle_from(f, graph, way + [file], done) for f in graph.get(file, []) if f not in done)
    circle = next((c for c in circles if c), [])
    done.add(file)
    return circle


def complaints(source):
    """What is wrong with the include lines below a source folder, a sentence each."""
    headers, found, graph = source / "include", [], {}
    for file, included in include_lines(headers):
        if not (headers / included).exists():
            if included.startswith(PACKAGE):
                found.append(f"{file} includes {included}, which there is not")
            continue
        graph.setdefault(file, []).append(included)
        name = included[len(PACKAGE):]
        room = file[len(PACKAGE):].split("/")[0] + "/" if file.startswith(PACKAGE) else ""
        if room not in MAY_INCLUDE:
            found.append(f"{file} is in no room that is known")
        elif not included.startswith(PACKAGE) or not name.startswith(tuple(MAY_INCLUDE[room] + [room or PACKAGE])):
            found.append(f"{file} must not include {included}")
        if "/internal/" in included and not file.startswith(included[:included.index("internal/")]):
            found.append(f"{file} includes {included}, which is closed to it")
    done = set()
    circles = [circle_from(file, graph, [], done) for file in graph if file not in done]
    found += ["a circle: " + " -> ".join(c) for c in circles if c]
    for folder in OPEN:
        found += [f"{folder}/{file} includes {included}, which is internal"
                  for file, included in include_lines(source / folder)
                  if included.startswith(PACKAGE) and "/internal/" in included
                  and included[len(PACKAGE):] not in OPEN[folder]]
    return found


# ------------------------------------------------------------------- the check itself, on trees that are made up for it

SOUND = {
    "include/CGAL/door.h": ["Detection/Detector.h", "Animation/Sequence.h"],
    "Numerics/Rows.h": ["Numerics/internal/sort.h"],
    "Numerics/internal/sort.h": [],
    "Numerics/cholesky/Factor.h": ["Numerics/cholesky/internal/front.h", "Numerics/internal/sort.h"],
    "Numerics/cholesky/internal/front.h": ["Numerics/Rows.h"],
    "Animation/Sequence.h": ["Numerics/Rows.h"],
    "Deformation/strain.h": ["Animation/Sequence.h"],
    "Scale_space/filter.h": ["Animation/Sequence.h", "Numerics/cholesky/Factor.h"],
    "Detection/Detector.h": ["Scale_space/filter.h", "Deformation/strain.h", "Detection/Feature_point.h"],
    "Detection/Feature_point.h": [],
    "IO/write.h": ["Detection/Feature_point.h", "IO/internal/bytes.h"],
    "IO/internal/bytes.h": [],
    "examples/example.cpp": ["Detection/Detector.h", "IO/write.h"],
    "benchmark/benchmark.cpp": ["Numerics/cholesky/Factor.h"],
    "doc/figures/figure.cpp": ["IO/write.h"],
}

# what is included in addition, and what must be said
WRONG = [
    ("Numerics/Rows.h", "Animation/Frame.h", "Animation/Frame.h, which there is not"),
    ("Numerics/Rows.h", "Detection/Feature_point.h", "Numerics/Rows.h must not include"),
    ("Animation/Sequence.h", "IO/internal/bytes.h", "Animation/Sequence.h must not include"),
    ("Scale_space/filter.h", "Deformation/strain.h", "Scale_space/filter.h must not include"),
    ("Deformation/strain.h", "Scale_space/filter.h", "Deformation/strain.h must not include"),
    ("IO/write.h", "Detection/Detector.h", "IO/write.h must not include"),
    ("include/CGAL/door.h", "IO/write.h", "door.h must not include"),
    ("Animation/Sequence.h", "../door.h", "Animation/Sequence.h must not include CGAL/door.h"),
    ("Animation/Sequence.h", "Numerics/internal/sort.h", "which is closed to it"),
    ("Numerics/Rows.h", "Numerics/cholesky/internal/front.h", "which is closed to it"),
    ("Cellar/wine.h", "Numerics/Rows.h", "Cellar/wine.h is in no room"),
    ("Detection/Feature_point.h", "Detection/Detector.h", "a circle: "),
    ("Numerics/internal/sort.h", "Numerics/cholesky/Factor.h", "a circle: "),
    ("examples/example.cpp", "Numerics/internal/sort.h", "examples/example.cpp includes"),
    ("examples/example.cpp", "IO/internal/bytes.h", "examples/example.cpp includes"),
    ("benchmark/benchmark.cpp", "IO/internal/bytes.h", "benchmark/benchmark.cpp includes"),
    ("doc/figures/figure.cpp", "IO/internal/bytes.h", "which is internal"),
]


def complaints_of(tree):
    with tempfile.TemporaryDirectory() as folder:
        for file, includes in tree.items():
            outside = file.startswith(("include/", "examples/", "benchmark/", "doc/"))
            path = pathlib.Path(folder) / (file if outside else "include/" + PACKAGE + file)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("".join(f"#include <{PACKAGE}{i}>\n" for i in includes).replace("Animated_mesh_features/../", ""))
        return complaints(pathlib.Path(folder))


def main():
    failures = [f"of a sound tree: {c}" for c in complaints_of(SOUND)]
    for file, included, expected in WRONG:
        found = complaints_of({**SOUND, file: SOUND.get(file, []) + [included]})
        if not any(expected in c for c in found):
            failures.append(f"{file} with {included}: nothing with \"{expected}\" but {found}")
    source = pathlib.Path(sys.argv[1])
    lines = len(list(include_lines(source / "include")))
    if lines < 100:
        failures.append(f"{source}/include has {lines} include lines; is it the package?")
    failures += complaints(source)
    print(*failures, f"{lines} include lines, {len(WRONG)} wrong trees, {len(failures)} failures", sep="\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
