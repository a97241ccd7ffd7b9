#!/usr/bin/env python3
"""Checks that everything in a build folder compiles, without generating code.

compile_only.py BUILD_FOLDER JOBS [--without REGEX] [OPTION...]: runs the commands of compile_commands.json with
-fsyntax-only and the given compiler options added, but for those of files whose paths match. Prints what fails, and fails
if anything does, or if there is nothing to compile.
"""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys


def compile_only(entry, options):
    command = shlex.split(entry["command"])
    if os.path.basename(command[0]) == "ccache":
        command = command[1:]
    where = command.index("-o")
    del command[where:where + 2]
    command += ["-fsyntax-only", *options]
    done = subprocess.run(command, cwd=entry["directory"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return entry["file"], done.returncode, done.stdout


def main():
    folder, jobs, options = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    without = None
    if options[:1] == ["--without"]:
        without, options = re.compile(options[1]), options[2:]
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        entries = [entry for entry in json.load(file) if without is None or not without.search(entry["file"])]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for file, result, output in pool.map(lambda entry: compile_only(entry, options), entries):
            if result != 0:
                failed += 1
                print(f"FAILED: {file}")
            if output:
                print(output, end="")
    print(f"{len(entries)} files compiled, {failed} of them failed")
    return 1 if failed or not entries else 0


if __name__ == "__main__":
    sys.exit(main())
