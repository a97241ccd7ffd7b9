#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes a page for the manual from what the benchmarks wrote.

write_page.py BUILD_FOLDER FILE
"""

import datetime
import glob
import json
import os
import re
import subprocess
import sys

ORDER = ["engine", "program", "balls", "measures", "cholesky", "growth", "roofline", "viewpoints"]

INTRODUCTION = """\
What the package takes in time and memory, each figure beside that of what it competes with, from the same run of the
same program on the same machine. `scripts/benchmark.sh` builds and runs the benchmarks and writes this page; nothing
here is written by hand, and nothing is asserted on times. Ratios carry over to other machines better than times do.

Times are the least of several runs where a run is short; what is compared runs in turn. \"Threads\" are those that the
package may use; what it computes is the same, bit for bit, whatever their number.
"""


def first_line(path):
    try:
        with open(path) as file:
            return file.readline().strip()
    except OSError:
        return ""


def processor():
    model, features = "unknown processor", ""
    try:
        with open("/proc/cpuinfo") as file:
            for line in file:
                key, _, value = line.partition(":")
                if key.strip() == "model name" and model == "unknown processor":
                    model = value.strip()
                if key.strip() == "flags" and not features:
                    widest = [f for f in ["avx512f", "avx2", "sse4_2"] if f in value.split()]
                    features = ", " + widest[0].upper() if widest else ""
    except OSError:
        pass
    return "%s%s, %d cores" % (model, features, os.cpu_count() or 1)


def caches():
    result = []
    for folder in sorted(glob.glob("/sys/devices/system/cpu/cpu0/cache/index*")):
        kind, level, size = (first_line(os.path.join(folder, f)) for f in ["type", "level", "size"])
        if kind != "Instruction" and size:
            shared = first_line(os.path.join(folder, "shared_cpu_list"))
            result.append("L%s %s%s" % (level, size, " shared" if re.search("[,-]", shared) else " a core"))
    return ", ".join(result) or "unknown"


def memory():
    match = re.search(r"(\d+) kB", first_line("/proc/meminfo"))
    return "%.0f GB" % (int(match.group(1)) / 1e6) if match else "unknown"


def flags(build_folder):
    """Those of the benchmarks that decide on speed."""
    try:
        with open(os.path.join(build_folder, "compile_commands.json")) as file:
            for entry in json.load(file):
                if entry["file"].endswith("benchmark/Animated_mesh_features/engine.cpp"):
                    return " ".join(a for a in entry["command"].split()
                                    if re.match("-(O|f|m|std=|DNDEBUG)", a) and a != "-fPIE")
    except (OSError, KeyError, ValueError):
        pass
    return "unknown"


def version(root):
    with open(os.path.join(root, "CMakeLists.txt")) as file:
        found = re.search(r"^\s*VERSION\s+([0-9.]+)", file.read(), re.MULTILINE)
    result = found.group(1) if found else "unknown"
    try:
        commit = subprocess.run(["git", "-C", root, "describe", "--always"], capture_output=True, text=True, check=True)
        result += ", commit " + commit.stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        pass
    return result


def shown(cell):
    if cell is None:
        return ""
    if isinstance(cell, float):
        if cell == 0:
            return "0"
        if 100 <= abs(cell) < 1e7:
            return "%.0f" % cell
        return "%.3g" % cell
    return str(cell)


def escaped(text):
    return re.sub(r"([\\|<>#@&])", r"\\\1", text)


def table(value):
    columns, rows = value["columns"], value["rows"]
    is_text = [any(isinstance(row[i], str) for row in rows) for i in range(len(columns))]
    lines = ["| " + " | ".join(escaped(c) for c in columns) + " |",
             "| " + " | ".join(":---" if t else "---:" for t in is_text) + " |"]
    lines += ["| " + " | ".join(escaped(shown(c)) or " " for c in row) + " |" for row in rows]
    return "\n".join(lines)


def wrapped(text):
    lines, line = [], ""
    for word in text.split():
        if line and len(line) + 1 + len(word) > 120:
            lines.append(line)
            line = word
        else:
            line = (line + " " + word).strip()
    return "\n".join(lines + [line])


def main():
    build_folder, page = sys.argv[1:]
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    reports = []
    for name in ORDER:
        try:
            with open(os.path.join(build_folder, name + ".json")) as file:
                reports.append(json.load(file))
        except OSError:
            print("write_page.py: there is no %s.json: the page goes without" % name, file=sys.stderr)
    if not reports:
        sys.exit("write_page.py: nothing to write")
    built = next((r for r in reports if "compiler" in r), {})
    machine = [
        ("Date", datetime.date.today().isoformat()),
        ("Package", version(root)),
        ("Processor", processor()),
        ("Caches, data", caches()),
        ("Memory", memory()),
        ("Compiler", built.get("compiler", "unknown")),
        ("Flags", "`" + flags(build_folder) + "`"),
        ("Libraries", ", ".join(n + " " + built.get(n.lower(), "unknown") for n in ["CGAL", "Eigen", "TBB"])),
    ]
    out = ["/*!", "\\page PkgAnimatedMeshFeaturesPerformance Performance", "", INTRODUCTION]
    if any(r["quick"] for r in reports):
        out += ["<b>A quick run: it shows that the programs work; the figures are worth nothing.</b>", ""]
    out += ["| | |", "| :--- | :--- |"] + ["| %s | %s |" % row for row in machine] + [""]
    for report in reports:
        for i, value in enumerate(report["tables"]):
            anchor = "PkgAnimatedMeshFeaturesPerformance_%s_%d" % (report["program"], i + 1)
            out += ["\\section %s %s" % (anchor, escaped(value["title"])), "", wrapped(escaped(value["note"])), "",
                    table(value), ""]
    out += ["*/", ""]
    with open(page, "w") as file:
        file.write("\n".join(out))
    print("written: " + page)


main()
