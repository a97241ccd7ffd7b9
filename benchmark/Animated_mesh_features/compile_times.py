#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What it costs to compile with this package: for whoever includes it, beside CGAL's remeshing, and for its own programs.

compile_times.py [BUILD_FOLDER] [--repeat N] [--include FOLDER] [--launcher COMMAND]

BUILD_FOLDER has been configured with Ninja and -DCMAKE_EXPORT_COMPILE_COMMANDS=ON, for instance as scripts/demo.sh does:
its compiler, its options and the units of which it is built are measured. Without it, only what users compile is, with
g++. Times are those of the processor (user),
medians of N runs, one after the other; memory is the largest resident set. Nothing is asserted.
"""

import argparse
import json
import os
import resource
import shlex
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

REMESHING_HEADER = "CGAL/Polygon_mesh_processing/remesh.h"
MESH_HEADER = "CGAL/Surface_mesh.h"
DOOR_HEADER = "CGAL/detect_spatio_temporal_features.h"
SEQUENCE_HEADER = "CGAL/Animated_mesh_features/Animation/Frame_sequence.h"

REMESHING_PROGRAM = """#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

void remesh(Mesh& mesh, double length)
{
  CGAL::Polygon_mesh_processing::isotropic_remeshing(mesh.faces(), length, mesh);
}
"""


def readme_program():
    """The first C++ program of README.md."""
    with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
        return file.read().split("```cpp\n", 1)[1].split("```", 1)[0]


class Compiler:
    def __init__(self, launcher, repeat):
        self.launcher = shlex.split(launcher)
        self.repeat = repeat

    def run(self, command, directory):
        """User time in seconds and peak memory in MB, of the command and its children."""
        times, memory = [], 0
        for _ in range(self.repeat):
            read, write = os.pipe()
            child = os.fork()
            if child == 0:  # a process of its own, as resources of children are counted together
                os.close(read)
                done = subprocess.run(self.launcher + command, cwd=directory, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.PIPE, check=False)
                usage = resource.getrusage(resource.RUSAGE_CHILDREN)
                result = {"code": done.returncode, "time": usage.ru_utime, "memory": usage.ru_maxrss / 1024,
                          "errors": done.stderr.decode(errors="replace")[-2000:]}
                with os.fdopen(write, "w") as pipe:
                    json.dump(result, pipe)
                os._exit(0)
            os.close(write)
            with os.fdopen(read) as pipe:
                result = json.load(pipe)
            os.waitpid(child, 0)
            if result["code"] != 0:
                sys.exit(f"failed: {shlex.join(command)}\n{result['errors']}")
            times.append(result["time"])
            memory = max(memory, result["memory"])
        return statistics.median(times), memory


def without_cache(command):
    """The words of a command that begin with the compiler, and no output."""
    words = shlex.split(command)
    while "=" in words[0] or os.path.basename(words[0]) in ("ccache", "slot", "sccache", "distcc"):
        words = words[1:]
    if "-o" in words:
        at = words.index("-o")
        words = words[:at] + words[at + 2:]
    return words


def built_units(folder):
    """Those entries of compile_commands.json that are built if nobody names a target."""
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    commands = subprocess.run(["ninja", "-C", folder, "-t", "commands", "all"], stdout=subprocess.PIPE, text=True,
                              check=True).stdout
    sources = {words[words.index("-c") + 1] for words in map(str.split, commands.splitlines()) if "-c" in words[:-1]}
    return [entry for entry in entries if entry["file"] in sources]


def user_options(entries, include):
    """The compiler and the options that a program of a user's has: those of a unit of ours, without what is its own."""
    flags = ["-O2", "-std=c++17", "-DNDEBUG"]
    if not entries:
        return "g++", [*flags, "-DCGAL_EIGEN3_ENABLED", "-fno-math-errno", "-frounding-math", "-I" + include,
                       "-isystem", "/usr/include/eigen3"]
    words = without_cache(entries[0]["command"])
    kept, i = [], 1
    while i < len(words):
        word = words[i]
        if word == "-isystem":
            kept += words[i:i + 2]
            i += 1
        elif word.startswith(("-DCGAL_", "-DNOMINMAX", "-fno-math", "-frounding")) and "CGAL_ANIMATED" not in word:
            kept.append(word)
        i += 1
    return words[0], [*flags, *kept, "-I" + include]


def print_row(name, time, memory, note=""):
    print(f"| {name} | {time:.1f} | {memory:.0f} | {note} |", flush=True)


def print_users(compiler, entries, include):
    program, options = user_options(entries, include)
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "unit.cpp")

        def measure(text, extra):
            with open(source, "w", encoding="utf-8") as file:
                file.write(text)
            return compiler.run([program, *options, *extra, source], folder)

        def header(*names):
            return measure("".join(f"#include <{name}>\n" for name in names), ["-fsyntax-only"])

        print("## An include\n\n| -fsyntax-only | s | MB | |\n|---|---|---|---|")
        remeshing, mesh = header(REMESHING_HEADER), header(MESH_HEADER)
        print_row(REMESHING_HEADER, *remeshing)
        print_row(MESH_HEADER, *mesh)
        for names in ([DOOR_HEADER], [MESH_HEADER, DOOR_HEADER]):
            cost = header(*names)
            print_row(" and ".join(names), *cost, f"{cost[0] / remeshing[0]:.2f} x remesh.h")
        cost = header(SEQUENCE_HEADER)
        print_row(SEQUENCE_HEADER, *cost, f"{cost[0] / mesh[0]:.2f} x Surface_mesh.h")

        print("\n## A program\n\n| -O2 | s | MB | |\n|---|---|---|---|")
        code = ["-c", "-o", os.path.join(folder, "unit.o")]
        remeshing = measure(REMESHING_PROGRAM, code)
        print_row("isotropic remeshing", *remeshing)
        for name, extra in (("README's", []), ("README's, compiled library", ["-DCGAL_ANIMATED_MESH_FEATURES_COMPILED"])):
            cost = measure(readme_program(), [*code, *extra])
            print_row(name, *cost, f"{cost[0] / remeshing[0]:.2f} x remeshing")


def print_build(compiler, entries):
    print("\n## The programs' build\n\n| unit | s | MB | |\n|---|---|---|---|")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for entry in entries:
            command = without_cache(entry["command"]) + ["-o", os.path.join(folder, "unit.o")]
            time, memory = compiler.run(command, entry["directory"])
            rows.append((time, memory, os.path.relpath(entry["file"], ROOT)))
    total = sum(time for time, _, _ in rows)
    for time, memory, name in sorted(rows, reverse=True):
        print_row(name, time, memory, f"{100 * time / total:.0f} %")
    print_row(f"all {len(rows)}", total, max(memory for _, memory, _ in rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build_folder", nargs="?")
    parser.add_argument("--repeat", type=int, default=3, help="runs of each compilation of a user's (3)")
    parser.add_argument("--include", default=os.path.join(ROOT, "include"), help="where the package's headers are")
    parser.add_argument("--launcher", default="", help="a command before each of the compiler's")
    arguments = parser.parse_args()
    entries = built_units(arguments.build_folder) if arguments.build_folder else []
    print_users(Compiler(arguments.launcher, arguments.repeat), entries, os.path.abspath(arguments.include))
    if entries:
        print_build(Compiler(arguments.launcher, 1), entries)


if __name__ == "__main__":
    main()
