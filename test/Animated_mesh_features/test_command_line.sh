#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The command line of detect_features: every option, every kind of bad input, files and exit codes.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without python3, the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation python3
enter_empty_folder

# usage, input, output <part of the message> <arguments...>: the error of that kind, and nothing written
usage() { expect 2 "$@" && nothing_written; }
input() { expect 3 "$@" && nothing_written; }
output() { expect 4 "$@" && nothing_written; }
nothing_written() {
  [[ ! -s out ]] || fail "something on the standard output in spite of an error"
  [[ ! -e x.json ]] || fail "x.json in spite of an error"
  no_temporaries
}
no_temporaries() { [[ -z "$(find . -name '.*.tmp')" ]] || fail "temporary files are left: $(find . -name '.*.tmp')"; }

# check <python expression>: with a, b... the contents of the JSON files a.json, b.json..., and helpers
check() {
  checks=$((checks + 1))
  python3 tool.py check "$1" || fail "$1"
}

cat >tool.py <<'PYTHON'
import json, math, os, pty, random, re, signal, struct, subprocess, sys, time
from statistics import median


def load(name):
    with open(name + ".json") as file:
        return json.load(file, parse_constant=lambda c: sys.exit(name + ".json contains " + c))


def near(x, y, tolerance=1e-6):
    return abs(x - y) <= tolerance * max(abs(x), abs(y), 1e-300)


def p(d):
    return d["parameters"]


def where(d):
    return [(f["vertex"], f["frame"]) for f in d["features"]]


def npy(path):
    """Shape and values of a little-endian float32 array in C order."""
    data = open(path, "rb").read()
    assert data[:8] == b"\x93NUMPY\x01\x00"
    (length,) = struct.unpack("<H", data[8:10])
    header = eval(data[10:10 + length])
    assert header["descr"] == "<f4" and header["fortran_order"] is False and (10 + length) % 64 == 0
    n, f = header["shape"]
    return (n, f), struct.unpack("<%df" % (n * f), data[10 + length:])


def read_pc2(base):
    data = open(base + ".pc2", "rb").read()
    n, f = struct.unpack("<i", data[16:20])[0], struct.unpack("<i", data[28:32])[0]
    xyz = struct.unpack("<%df" % (3 * n * f), data[32:])
    return n, f, [xyz[3 * n * i:3 * n * (i + 1)] for i in range(f)]


def faces(base):
    return [line for line in open(base + ".obj") if line.startswith("f ")]


def shared(a, b):
    """Pairs of features of two files that are at the same vertex in the same frame."""
    other = {(f["vertex"], f["frame"]): f for f in b["features"]}
    return [(f, other[f["vertex"], f["frame"]]) for f in a["features"] if (f["vertex"], f["frame"]) in other]


def moved(a, b, frames, count):
    """Whether the features of `a` are those of `b`, so many frames earlier in a period of `count` frames."""
    def rows(d, later):
        return sorted([f["vertex"], (f["frame"] + later) % count, f["sigma"], f["tau"], f["strength"], f["fit"]]
                      for f in d["features"])
    pairs = list(zip(rows(a, frames), rows(b, 0)))
    return len(a["features"]) == len(b["features"]) and all(near(x, y, 1e-6) for r, s in pairs for x, y in zip(r, s))


def write_obj(path, xyz, faces):
    with open(path, "w") as file:
        for i in range(0, len(xyz), 3):
            file.write("v %.17g %.17g %.17g\n" % tuple(xyz[i:i + 3]))
        file.writelines(faces)


def again(name):
    """The command line that the parameters of a JSON file stand for."""
    q = load(name)["parameters"]
    options = ["--" + k.replace("_", "-") + "=" + str(q[k])
               for k in ("fps", "rest", "preset", "strain", "alpha", "curvature", "balls", "ball_radius",
                         "spatial_filter", "temporal_filter", "box_width", "space_counts", "time_counts", "sigma_range",
                         "tau_range", "threshold", "relative_threshold",
                         "min_fit", "baseline", "dimension", "denoise") if q[k] is not None]
    options += ["--cyclic"] * q["cyclic"]
    options += ["--triangulate"] * q["triangulate"] + ["--as-given"] * q["as_given"] + ["--rescale-rest"] * q["rescale_rest"]
    options += ["--no-suppression"] * (not q["suppression"])
    return options + q["inputs"]


def interrupt(program, arguments):
    """Sends SIGINT as soon as there is a temporary file; the exit code, or what went wrong."""
    process = subprocess.Popen([program] + arguments, stderr=subprocess.PIPE,
                               preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    while process.poll() is None and not any(re.fullmatch(r"\..*\.tmp", n) for n in os.listdir(".")):
        time.sleep(0.01)
    if process.poll() is not None:
        return "ended before it could be interrupted"
    time.sleep(0.2)
    process.send_signal(signal.SIGINT)
    message = process.communicate()[1].decode()
    if "interrupted" not in message:
        return "message: " + message
    return process.returncode


def on_terminal(program, arguments, stream="stderr"):
    """What the program writes to a terminal as one of its outputs."""
    master, slave = pty.openpty()
    outputs = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, stream: slave}
    process = subprocess.Popen([program] + arguments, **outputs)
    os.close(slave)
    text = b""
    while True:
        try:
            part = os.read(master, 65536)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        text += part
    return process.wait(), text.decode()


command, arguments = sys.argv[1], sys.argv[2:]
if command == "check":
    for name in set(re.findall(r"[A-Za-z_]\w*", arguments[0])):
        if os.path.exists(name + ".json"):
            globals()[name] = load(name)
    sys.exit(0 if eval("(" + arguments[0] + ")") else 1)
elif command == "frames":  # base, names of the frames, separated by commas: a mesh for each of them
    n, f, frames = read_pc2(arguments[0])
    for xyz, name in zip(frames, arguments[1].split(",")):
        write_obj(name, xyz, faces(arguments[0]))
elif command == "table":  # program and its arguments, to somebody at a terminal
    code, text = on_terminal(arguments[0], arguments[1:], "stdout")
    sys.stdout.write(text.replace("\r\n", "\n"))
    sys.exit(code)
elif command == "scaled":  # base, factor, output: the first frame
    n, f, frames = read_pc2(arguments[0])
    write_obj(arguments[2], [float(arguments[1]) * x for x in frames[0]], faces(arguments[0]))
elif command == "part":  # input, first frame, last frame, output: a cache of these frames
    data = open(arguments[0], "rb").read()
    first, last, n = int(arguments[1]), int(arguments[2]), struct.unpack("<i", data[16:20])[0]
    with open(arguments[3], "wb") as file:
        file.write(data[:28] + struct.pack("<i", last - first + 1) + data[32 + 12 * n * first:32 + 12 * n * (last + 1)])
elif command == "slow":  # base, output: a twentieth of the way from the first frame to the second, in 5 frames
    n, f, frames = read_pc2(arguments[0])
    head = open(arguments[0] + ".pc2", "rb").read()[:28]
    with open(arguments[1], "wb") as file:
        file.write(head + struct.pack("<i", 5))
        for i in range(5):
            file.write(struct.pack("<%df" % (3 * n), *(a + 0.0125 * i * (b - a) for a, b in zip(frames[0], frames[1]))))
elif command == "mdd":  # base, time of the frame i as an expression, output
    n, f, frames = read_pc2(arguments[0])
    with open(arguments[2], "wb") as file:
        file.write(struct.pack(">ii", f, n) + struct.pack(">%df" % f, *(eval(arguments[1]) for i in range(f))))
        for xyz in frames:
            file.write(struct.pack(">%df" % (3 * n), *xyz))
elif command == "poke":  # base, frame, vertex, value, output: a PC2 with that x
    data = bytearray(open(arguments[0] + ".pc2", "rb").read())
    n = struct.unpack("<i", data[16:20])[0]
    struct.pack_into("<f", data, 32 + 12 * (n * int(arguments[1]) + int(arguments[2])), float(arguments[3]))
    open(arguments[4], "wb").write(data)
elif command == "zero":  # base, first and last frame, output: a PC2 in which these have no extent
    data = bytearray(open(arguments[0] + ".pc2", "rb").read())
    size = 12 * struct.unpack("<i", data[16:20])[0]
    first, last = 32 + size * int(arguments[1]), 32 + size * (int(arguments[2]) + 1)
    data[first:last] = bytes(last - first)
    open(arguments[3], "wb").write(data)
elif command == "seam":  # base, output: cut open between the first triangle and its neighbours
    n, f, frames = read_pc2(arguments[0])
    lines = open(arguments[0] + ".obj").readlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("f "))
    corners = [int(c) for c in lines[first].split()[1:]]
    new = "f %d %d %d\n" % tuple(n + 1 + k for k in range(3))
    vertices = [line for line in lines if line.startswith("v ")]
    with open(arguments[1] + ".obj", "w") as file:
        file.writelines(vertices + [vertices[c - 1] for c in corners] + [new] + lines[first + 1:])
    with open(arguments[1] + ".pc2", "wb") as file:
        header = bytearray(open(arguments[0] + ".pc2", "rb").read(32))
        struct.pack_into("<i", header, 16, n + 3)
        file.write(header)
        for xyz in frames:
            more = [x for c in corners for x in xyz[3 * (c - 1):3 * c]]
            file.write(struct.pack("<%df" % (3 * n + 9), *xyz, *more))
elif command == "pair":  # base, output: the body after a copy of it, 8 units away; one triangle of it is an arm
    n, f, frames = read_pc2(arguments[0])
    lines = open(arguments[0] + ".obj").readlines()
    vertices = [line.split() for line in lines if line.startswith("v ")]
    corners = [[int(c) for c in line.split()[1:]] for line in lines if line.startswith("f ")]
    with open(arguments[1] + ".obj", "w") as file:
        for v in vertices:
            file.write("v %.9g %s %s\n" % (float(v[1]) + 8, v[2], v[3]))
        file.writelines(" ".join(v) + "\n" for v in vertices)
        for i, names in ((0, "o copy\n"), (n, "o the  body\ng arm\n")):
            file.write(names)
            for j, t in enumerate(corners):
                file.write("g legs\n" * (i > 0 and j == 1) + "f %d %d %d\n" % tuple(c + i for c in t))
    with open(arguments[1] + ".pc2", "wb") as file:
        header = bytearray(open(arguments[0] + ".pc2", "rb").read(32))
        struct.pack_into("<i", header, 16, 2 * n)
        file.write(header)
        for xyz in frames:
            moved = [x + 8 * (i % 3 == 0) for i, x in enumerate(xyz)]
            file.write(struct.pack("<%df" % (6 * n), *moved, *xyz))
elif command == "cut":  # base, number of frames, output: a PC2 of the first frames
    data = bytearray(open(arguments[0] + ".pc2", "rb").read())
    n = struct.unpack("<i", data[16:20])[0]
    struct.pack_into("<i", data, 28, int(arguments[1]))
    open(arguments[2], "wb").write(data[:32 + 12 * n * int(arguments[1])])
elif command == "noisy":  # BASE SHARE TO: normal noise of this share of the mean edge, TO.pc2 and its first frame, TO.obj
    n, f, frames = read_pc2(arguments[0])
    edges = [(int(c[i]) - 1, int(c[(i + 1) % 3]) - 1)
             for c in ([k.split("/")[0] for k in line.split()[1:]] for line in faces(arguments[0])) for i in range(3)]
    at = lambda v: frames[0][3 * v:3 * v + 3]
    deviation = float(arguments[1]) * sum(math.dist(at(v), at(w)) for v, w in edges) / len(edges)
    generator = random.Random(3)
    frames = [[x + generator.gauss(0, deviation) for x in frame] for frame in frames]
    head = open(arguments[0] + ".pc2", "rb").read()[:32]
    with open(arguments[2] + ".pc2", "wb") as file:
        file.write(head + b"".join(struct.pack("<%df" % len(frame), *frame) for frame in frames))
    rounded = [struct.unpack("<f", struct.pack("<f", x))[0] for x in frames[0]]
    write_obj(arguments[2] + ".obj", rounded, faces(arguments[0]))
    json.dump({"deviation": deviation}, open(arguments[2] + "_noise.json", "w"))
elif command == "begun":  # base, first frame, how many, output: a PC2 of frames that go round
    n, f, frames = read_pc2(arguments[0])
    first, count = int(arguments[1]), int(arguments[2])
    with open(arguments[3], "wb") as file:
        file.write(open(arguments[0] + ".pc2", "rb").read()[:28] + struct.pack("<i", count))
        for i in range(count):
            file.write(struct.pack("<%df" % (3 * n), *frames[(first + i) % f]))
elif command == "again":
    print("\n".join(again(arguments[0])))
elif command == "interrupt":
    print(interrupt(arguments[0], arguments[1:]))
elif command == "terminal":
    code, text = on_terminal(arguments[0], arguments[1:])
    sys.stdout.write(text)
    sys.exit(code)
PYTHON

# ------------------------------------------------------------------------------------------------------ the animation

"$generator" figure --vertices 2000 --fps 10 -o c >/dev/null || fail "make_animation"
frames=$(python3 -c 'import struct; print(struct.unpack("<i", open("c.pc2", "rb").read()[28:32])[0])')
vertices=$(grep -c '^v ' c.obj)
[[ $frames -eq 16 ]] || fail "the animation has $frames frames, the test expects 16"

# find <options...>: a successful run on the animation, into x.json
find_features() {
  rm -f x.json
  expect 0 "" c.obj c.pc2 --fps 10 -o x.json "$@"
}
# differs <options...>: they have an effect on the features
differs() {
  find_features "$@"
  check 'x["features"] != base["features"] and len(x["features"]) > 0'
}

expect 0 "feature" c.obj c.pc2 --fps 10 -o base.json
check 'base["format"] == "animated-mesh-features" and base["version"] == 1'
check "base['animation']['vertices'] == $vertices and base['animation']['frames'] == $frames"
check 'near(base["animation"]["frame_duration"], 0.1)'
check 'len(base["features"]) >= 3'
check 'all(f["strength"] > 0 and f["sigma"] > 0 and f["tau"] > 0 for f in base["features"])'
check 'sorted((-f["strength"] for f in base["features"])) == [-f["strength"] for f in base["features"]]'
check 'p(base)["preset"] == "calibrated" and p(base)["program"].startswith("detect_features ")'
[[ "$(grep -vc '^note: ' err)" -eq 1 ]] || fail "the summary is not one line: $(cat err)"
# somebody at a terminal, who asks for no file, gets the strongest as a table, and no JSON
python3 tool.py table "$program" c.obj c.pc2 --fps 10 >table || fail "a table: exit code $?"
[[ "$(head -n 1 table)" == rank*time*size*duration*amplitude*fit*place ]] || fail "no table: $(head -n 3 table)"
check 'open("table").read().split("\n")[1].split()[:4] == [
         "1", "%.4g" % base["features"][0]["time"], str(base["features"][0]["frame"]), str(base["features"][0]["vertex"])]'
! grep -q "[{}]" table || fail "JSON at a terminal"
python3 tool.py table "$program" c.obj c.pc2 --fps 10 -o - | python3 -m json.tool >/dev/null || fail "-o - is no JSON at a terminal"
python3 tool.py table "$program" c.obj c.pc2 --fps 10 --top 1 >table
[[ "$(grep -c '^ *[0-9]' table)" -eq 1 ]] || fail "--top 1 gives another table: $(cat table)"

# nothing but the message, and no control characters, where there is no terminal
if LC_ALL=C grep -q "[^[:print:]]" err; then fail "control characters without a terminal"; fi
no_temporaries

# ------------------------------------------------------------------------------------------------------- usage, version

# without arguments: what it is for, three commands, where the rest is; which parts it has, as it turns out to have them
expect 2 "detect_features finds where, when, how large and how long"
[[ ! -s out ]] || fail "the short usage goes to the standard output"
[[ $(grep -c "^  detect_features [a-z]" err) -eq 3 ]] || fail "the short usage has not three commands: $(cat err)"
[[ $(wc -l <err) -le 12 && $(wc -L <err) -le 120 ]] || fail "the short usage is long"
grep -qF "detect_features --help" err || fail "the short usage does not name --help"
cp err short_usage
for part in "glTF|x.glb" "FBX|x.fbx" "HDF5|x.h5" "--html|c.obj c.pc2 --html x.html" "--png|c.obj c.pc2 --png x.png --png-size 100x100" \
  "--plot|c.obj c.pc2 --plot x.svg"; do
  IFS='|' read -r name arguments <<<"$part"
  echo text | tee x.glb x.fbx >x.h5
  # shellcheck disable=SC2086
  "$program" $arguments -q >out 2>err </dev/null
  list="This program was built with:"
  if grep -qF "was built without" err; then list="and without:"; fi
  checks=$((checks + 1))
  grep -F -- "$name" short_usage | grep -qF "$list" || fail "the short usage is wrong about $name: $(cat short_usage err)"
  rm -f x.*
done
expect 0 "" --help
for word in --sigma-range "0.2)" seconds "Exit codes" "Examples:"; do
  grep -qF -- "$word" out || fail "--help lacks $word"
done
expect 0 "" -h
usage "did you mean --threshold?" c.obj c.pc2 --treshold 0.1
usage "did you mean --sigma-range?" c.obj c.pc2 --sigma 1%:
usage "there is no option --zzz" c.obj c.pc2 --zzz
! grep -q "did you mean" err || fail "a suggestion out of nothing: $(cat err)"
usage "did you mean hencky?" c.obj c.pc2 --strain henky
usage "did you mean average?" c.obj c.pc2 --rest mean
usage "is neither a file nor mesh, bind, first, frame:N or average; did you mean first?" c.obj c.pc2 --rest frist
expect 0 "" --man
[[ "$(head -n 1 out)" == ".TH DETECT_FEATURES 1"* ]] || fail "--man is no manual page"
grep -qF '\fB\-\-threshold\fR \fIT\fR' out || fail "--man lacks --threshold"
if command -v man >/dev/null; then
  man --warnings -E UTF-8 -l -Tutf8 out 2>&1 >page | grep . && fail "man complains of the manual page"
fi
expect 0 "" --completion bash
bash -c '. ./out; COMP_WORDS=(detect_features --thres) COMP_CWORD=1; _detect_features; [[ "${COMPREPLY[*]}" == --threshold ]]' ||
  fail "bash does not complete --thres"
for shell in zsh fish; do
  expect 0 "" --completion $shell
  [[ "$(grep -c -- threshold out)" -ge 2 ]] || fail "the completion for $shell lacks options"
  ! command -v $shell >/dev/null || $shell -n out || fail "$shell does not understand its completion"
done
usage "choose among bash, zsh, fish" --completion tcsh
expect 0 "" --version
grep -qE '^detect_features [0-9]+\.[0-9]+' out || fail "--version: $(cat out)"
version="$(sed -n 's/^version: //p' "$tests/../../CITATION.cff")"
grep -qF "detect_features $version " out || fail "CITATION.cff is about version $version"
grep -qF "edition = {$version}" "$tests/../../README.md" || fail "README.md is to be cited with another version"

usage "--wibble" c.obj c.pc2 --wibble
usage "--thresh" c.obj c.pc2 --thresh 0.5
usage "no input" -o x.json
usage "alpha" c.obj c.pc2 --alpha
usage "alpha" c.obj c.pc2 --alpha 1 --alpha 2
usage "no number" c.obj c.pc2 --alpha much
usage "negative" c.obj c.pc2 --alpha=-1
usage "no number" c.obj c.pc2 --alpha nan
usage "empty" c.obj c.pc2 --strain ""
usage "choose among hencky, green-lagrange, stretch, largest-eigenvalue" c.obj c.pc2 --strain wrong
usage "calibrated, published" c.obj c.pc2 --preset wrong
usage "above 1" c.obj c.pc2 --relative-threshold 1.5
usage "above 1" c.obj c.pc2 --min-fit 1.5
usage "no number" c.obj c.pc2 --threshold 20%
usage "choose among surface, plane" c.obj c.pc2 --dimension 2
usage "choose among least, none" c.obj c.pc2 --baseline mean
usage "not positive" c.obj c.pc2 --fps 0
usage "no animation has that many frames in a second" c.obj c.pc2 --fps 1e-300
usage "no animation has that many frames in a second" c.obj c.pc2 --fps 1e300
usage "the range of tau up to 1e+09 goes beyond 10 times the duration of the animation" c.obj c.pc2 --tau-range :1e9
usage "goes beyond 10 times the diameter" c.obj c.pc2 --sigma-range :1e300
usage "levels; at most 500 are made" c.obj c.pc2 --tau-range 1e-300:
usage "not positive" c.obj c.pc2 --ball-radius 0%
usage "MIN:MAX" c.obj c.pc2 --sigma-range 3
usage "MIN:MAX" c.obj c.pc2 --tau-range :
usage "MIN:MAX" c.obj c.pc2 --tau-range 1:2:3
usage "no number" c.obj c.pc2 --tau-range 10%:20%
usage "sigma" c.obj c.pc2 --sigma-range 10%:1%
usage "can resolve" c.obj c.pc2 --sigma-range 0.0001%:0.0002%
usage "--tau-range does not go with --preset published" c.obj c.pc2 --preset published --tau-range :0.5
usage "--sigma-range does not go with --preset published" c.obj c.pc2 --preset published --sigma-range 1%:
usage "--box-width" c.obj c.pc2 --box-width 5
usage "--box-width" c.obj c.pc2 --preset published --box-width 1
usage "--box-width" c.obj c.pc2 --preset published --temporal-filter gaussian --box-width 5
usage "smaller --box-width" c.obj c.pc2 --preset published --box-width 1000
usage "--space-counts" c.obj c.pc2 --space-counts 5
usage "--time-counts" c.obj c.pc2 --preset published --time-counts 2
usage "--rescale-rest" c.obj c.pc2 --rescale-rest
usage "frames are 0 to 15" c.obj c.pc2 --rest frame:16
usage "--rest" c.obj c.pc2 --rest frame:x
usage "--threads" c.obj c.pc2 --threads=-1
usage "--memory" c.obj c.pc2 --memory lots
usage "--memory" c.obj c.pc2 --memory -1G
usage "--memory" c.obj c.pc2 --memory 9999999T
usage "--scratch goes with --memory" c.obj c.pc2 --scratch .
usage "exclude" c.obj c.pc2 --quiet --verbose
usage "-o json:x.txt" c.obj c.pc2 -o x.txt
usage "strain:FILE" c.obj c.pc2 --write-field pressure:x.npy
usage "same file" c.obj c.pc2 -o x.json -o x.json
usage "standard output" c.obj c.pc2 -o - -o csv:-
usage "no name" c.obj c.pc2 -o csv:
usage "standard output" c.obj c.pc2 --vtk -
usage "same file" c.obj c.pc2 -o json:x --vtk x
usage "same file" c.obj c.pc2 -o x.json --glb x.glb --plot x.glb
usage "standard output" c.obj c.pc2 --glb - --plot -
usage "standard output" c.obj c.pc2 -o - -o csv:/dev/stdout
# The same file by another name: an input, a member of a folder, the rest shape, another output.
ln c.obj hard.obj
ln -s c.pc2 soft.pc2
ln -s away.json dangling.json
mkdir few
for f in 0 1 2; do cp c.obj few/$f.obj; done
for name in c.pc2 ./c.pc2 few/../c.pc2 soft.pc2; do usage "is the input" c.obj c.pc2 -o x.json --glb $name; done
usage "is the input hard.obj" hard.obj c.pc2 -o json:c.obj --rest c.obj
usage "is the input" c.obj c.pc2 -o json:few/1.obj --rest few/1.obj
usage "is the input" few/ -o x.json --vtk few
usage "is the input" few --fps 10 -o x.json -o ply:few/../few/2.obj
usage "same file" c.obj c.pc2 -o x.json -o csv:few/../x.json
usage "same file" c.obj c.pc2 -o json:away.json -o csv:dangling.json
usage "same file" c.obj c.pc2 -o x.json --vtk new --write-field strain:few/../new/
rm -r hard.obj soft.pc2 dangling.json few
usage "goes with --html" c.obj c.pc2 --html-every 2
usage "at least 1" c.obj c.pc2 --html v.html --html-every 0
usage "is no number" c.obj c.pc2 --html v.html --html-every all

# ----------------------------------------------------------------------------------------------------- every option

# The animation's frame rate: everything as before, in half of the time.
find_features --verbose # a reference that shows what --quiet suppresses
find_features --threshold 0
cp x.json slow.json
rm -f x.json
expect 0 "" c.obj c.pc2 --fps 20 --threshold 0 -o x.json
check 'len(shared(x, slow)) > 20 and all(near(f["tau"], g["tau"] / 2, 0.1) for f, g in shared(x, slow))'
rm -f x.json
expect 0 "" c.obj c.pc2 -o x.json
check 'p(x)["fps"] == 30 and near(x["animation"]["frame_duration"], 1 / 30)'

# What counts as undeformed: by default the mesh of the pair, which is no frame of the run.
check 'p(base)["rest"] == "mesh" and p(base)["rest_factor"] == 1 and p(base)["rescale_rest"] is False'
expect 0 "against the mesh c.obj (given with the frames), computed in" c.obj c.pc2 --fps 10 -o x.json
# some of the frames: the same as of an animation that has no others
find_features --frames 2:13
python3 tool.py part c.pc2 2 13 part.pc2
mv x.json part.json
expect 0 "note: frames 2 to 13 of 16; frames and times count from the first of them" c.obj c.pc2 --frames 2:13 --fps 10 -o x.json
expect 0 "" c.obj part.pc2 --fps 10 -o x.json
check "part['features'] == x['features'] and part['animation']['frames'] == 12 and p(part)['frame_range'] == '2:13'"
rm x.json
usage "there is no such frame; frames are 0 to 15" c.obj c.pc2 --frames 2:16 -o x.json
usage "is empty" c.obj c.pc2 --frames 5:4 -o x.json
input "at least 3 are needed" c.obj c.pc2 --frames 14: -o x.json

find_features --rest mesh
cmp -s x.json base.json || fail "--rest mesh is not the default"
find_features --rest c.obj
check 'x["features"] == base["features"] and p(x)["rest"] == "c.obj"'
differs --rest average
check 'p(x)["rest"] == "average"'
cp x.json averaged.json
differs --rest first
cp x.json begun.json
find_features --rest frame:0
check 'x["features"] == begun["features"] and p(x)["rest"] == "frame:0" == p(begun)["rest"]'
# Only frames: their average. A mesh that is one of them says nothing that they do not.
python3 tool.py frames c "$(seq -s, -f 'f%g.obj' 0 15)"
expect 0 "against the average of all frames (there are only frames)" f{0..15}.obj --fps 10 -o x.json
check 'where(x) == where(averaged) and p(x)["rest"] == "average"'
for f in 0 7; do
  expect 0 "against the average of all frames (the mesh f$f.obj is frame $f)" f$f.obj c.pc2 --fps 10 -o x.json
  check 'where(x) == where(averaged) and p(x)["rest"] == "average"'
done
# But the first frame is undeformed, if the motion begins there from rest.
"$generator" cylinder --vertices 300 --fps 10 -o bend >/dev/null || fail "make_animation"
expect 0 "against frame 0 (the mesh bend.obj, from which the motion begins at rest)" bend.obj bend.pc2 -o x.json
check 'p(x)["rest"] == "frame:0"'
rm x.json
usage "goes with a mesh and a point cache" f{0..15}.obj --rest mesh -o x.json
usage "goes with an animated model" c.obj c.pc2 --rest bind -o x.json
usage "--rescale-rest" c.obj c.pc2 --rest average --rescale-rest
# A mesh in another unit is scaled, of which the user is told, unless it was asked for as it is.
awk '/^v / { printf "v %.9g %.9g %.9g\n", 25.4 * $2, 25.4 * $3, 25.4 * $4; next } 1' c.obj >large.obj
expect 0 "the mesh large.obj, the rest shape, is in another unit: it is scaled by 0.039" large.obj c.pc2 --fps 10 -o x.json
check 'near(p(x)["rest_factor"], 1 / 25.4, 0.02) and p(x)["rescale_rest"] is True and p(x)["rest"] == "mesh"'
cp x.json scaled.json
rm x.json
input "--rescale-rest" large.obj c.pc2 --rest mesh -o x.json
expect 0 "" large.obj c.pc2 --fps 10 --rest mesh --rescale-rest -o x.json
check 'x["features"] == scaled["features"]'
# One that is unlike all frames: a body that is twice as wide.
awk '/^v / { print "v", 2 * $2, $3, $4; next } 1' c.obj >wide.obj
expect 0 "the mesh wide.obj, the rest shape, is unlike all frames: its edges differ by" wide.obj c.pc2 --fps 10 -o x.json
# And one that all frames differ from more than they do from one another: the figure stands, and runs for a moment only.
python3 tool.py slow c slow.pc2
expect 0 "% at most, so that few features may stand out; --rest average takes" c.obj slow.pc2 -o x.json
differs --rest frame:7
# the mesh of frame 7 is frame 7
cp x.json frame7.json
find_features --rest f7.obj
check 'all(near(f[k], g[k], 1e-6) for f, g in zip(x["features"], frame7["features"]) for k in ("sigma", "strength"))'
check 'where(x) == where(frame7) and p(x)["rest_factor"] == 1'
# in another unit
# Noise is measured and taken out, by the mesh that is given; the first frame, if that is the mesh, is as noisy as the others.
check 'p(base)["noise_taken_out"] is None and p(base)["denoise"] == "auto"'
python3 tool.py noisy c 0.25 noisy
expect 0 "taken out, as far as neighbours move alike" c.obj noisy.pc2 --fps 10 -o x.json
check 'near(p(x)["noise_taken_out"], noisy_noise["deviation"], 0.05)'
check 'p(x)["rest"] == "mesh"'
cp x.json without_noise.json
expect 0 "the average of all frames (the mesh noisy.obj is frame 0)" noisy.obj noisy.pc2 --fps 10 -o x.json
check 'p(x)["noise_taken_out"] > 0'
expect 0 "small and short features may be noise" c.obj noisy.pc2 --fps 10 --denoise never -o x.json
check 'p(x)["noise_taken_out"] is None and p(x)["denoise"] == "never" and x["features"] != without_noise["features"]'
# so is a twentieth of an edge and a bit
python3 tool.py noisy c 0.06 noisy
expect 0 "taken out, as far as neighbours move alike" c.obj noisy.pc2 --fps 10 -o x.json
# a little noise stays in, unless it is to be taken out in any case
python3 tool.py noisy c 0.03 noisy
expect 0 "" c.obj noisy.pc2 --fps 10 -o x.json
if grep -q tremble err; then fail "a little noise is told: $(cat err)"; fi
cp x.json as_it_is.json
expect 0 "" c.obj noisy.pc2 --fps 10 --denoise never -o x.json
check 'x["features"] == as_it_is["features"]'
expect 0 "taken out, as far as neighbours move alike" c.obj noisy.pc2 --fps 10 --denoise always -o x.json
check 'p(x)["noise_taken_out"] > 0 and x["features"] != as_it_is["features"]'
rm x.json
usage "sometimes" c.obj c.pc2 --denoise sometimes -o x.json

python3 tool.py scaled c 25.4 inches.obj
rm -f x.json
input "--rescale-rest" c.obj c.pc2 --rest inches.obj -o x.json
grep -q "inches.obj.*0\.0393" err || fail "no ratio or file in: $(cat err)"
find_features --rest inches.obj --rescale-rest
check 'where(x) == where(begun) and near(p(x)["rest_factor"], 1 / 25.4, 1e-4)'

differs --preset published
check '[p(x)[k] for k in ("strain", "curvature", "spatial_filter", "temporal_filter", "suppression")] ==
       ["largest-eigenvalue", "dihedral", "one-ring", "box", False]'
check '[p(x)[k] for k in ("baseline", "dimension", "threshold", "relative_threshold", "min_fit")] ==
       ["none", "plane", 0, 0.2, 0] and all(f["strength"] == -f["response"] for f in x["features"])'
check 'p(x)["box_width"] == 3 and p(x)["triangle_weights"] == "uniform"'
cp x.json published.json
find_features --preset published --box-width 2
check 'x["features"] != published["features"] and p(x)["box_width"] == 2'
find_features --preset published --space-counts 7 --time-counts 5
check 'len(p(x)["sigma_levels"]) == 8 and len(p(x)["tau_levels"]) == 6 and p(x)["space_counts"] == 7'
grep -q "smoothing counts" err && fail "a notice for a short search: $(cat err)"
"$program" c.obj c.pc2 --fps 25 --preset published --space-counts 20000 --time-counts 20000 -o long.json 2>err &
until grep -q "20000 x 20000 smoothing counts" err || ! kill -0 $! 2>/dev/null; do sleep 0.05; done
kill -TERM $! && wait $! || [[ $? -eq 143 ]] || fail "no exit code 143 when terminated: $(cat err)"
grep -q "minutes of processor time" err || fail "no notice of a long search: $(cat err)"
checks=$((checks + 1))
find_features --preset published --strain hencky --temporal-filter gaussian
check 'x["features"] != published["features"] and p(x)["strain"] == "hencky" and p(x)["box_width"] is None'
find_features --preset published --spatial-filter heat
check 'x["features"] != published["features"]'

differs --spatial-filter one-ring
check 'p(x)["spatial_filter"] == "one-ring" and p(base)["spatial_filter"] == "heat"'
differs --temporal-filter box
check 'p(x)["temporal_filter"] == "box" and p(base)["temporal_filter"] == "gaussian"'
# a similar Gaussian: features hardly change
check 'len(shared(x, base)) > 10 and all(near(f["amplitude"], g["amplitude"], 0.05) for f, g in shared(x, base))'
# Of a cyclic animation it does not matter where it begins; the first frame once more at its end is left out.
for filter in "" "--temporal-filter box" "--preset published"; do
  differs --cyclic --rest c.obj --relative-threshold 0 $filter
  check 'p(x)["cyclic"] and not p(base)["cyclic"] and x["animation"]["frames"] == 16'
  check 'all(0 <= f["time"] < 1.6 and abs((f["time"] - f["frame"] / 10 + 0.8) % 1.6 - 0.8) <= 0.05 + 1e-9 for f in x["features"])'
  cp x.json cyclic.json
  python3 tool.py begun c 5 16 begun.pc2
  expect 0 "" c.obj begun.pc2 --fps 10 --cyclic --rest c.obj --relative-threshold 0 $filter -o x.json
  check 'moved(x, cyclic, 5, 16)'
done
python3 tool.py begun c 5 17 begun.pc2
cp x.json once.json
expect 0 "repeats the first and is left out; the period is 16 frames" c.obj begun.pc2 --fps 10 --cyclic --rest c.obj \
  --relative-threshold 0 --preset published -o x.json
check 'x["features"] == once["features"] and x["animation"]["frames"] == 16'
# Nor does it matter for where it is looked at from, by a camera that comes back.
python3 tool.py begun c 0 8 eight.pc2 # as many frames as are looked at
cp c.obj eight.obj
python3 tool.py begun eight 3 8 begun.pc2
for name in eight begun; do
  expect 0 "" c.obj $name.pc2 --fps 10 --cyclic --rest c.obj --threshold 0 --views ${name}_views.json -o x.json
done
check 'all(abs(a - b) < 1e-3 for v, w in zip(eight_views["views"], begun_views["views"])
           for a, b in zip(v["direction"] + [v["covered"]], w["direction"] + [w["covered"]]))'
expect 0 "" c.obj c.pc2 --fps 10 --cyclic --rest c.obj --threshold 0 --views c_views.json -o x.json
check 'c_views["camera"]["keys"][0]["direction"] == c_views["camera"]["keys"][-1]["direction"]'
check 'near(c_views["camera"]["keys"][-1]["time"], 1.6, 1e-6)'
expect 0 "look whether the frames are one whole period" c.obj c.pc2 --fps 10 --frames 0:6 --cyclic -o x.json
for strain in green-lagrange stretch largest-eigenvalue; do
  differs --strain $strain
  check "p(x)['strain'] == '$strain'"
  cp x.json "${strain//-/_}.json"
done
check 'green_lagrange["features"] != stretch["features"] != largest_eigenvalue["features"]'
differs --curvature dihedral
differs --balls dijkstra
for balls in heat-patches heat-global; do
  find_features --balls $balls
  check "p(x)['balls'] == '$balls' and
         len(shared(x, base)) > 10 and
         near(median(f['strength'] / g['strength'] for f, g in shared(x, base)), 1, 0.01)"
done
differs --ball-radius 12%
check 'near(p(x)["ball_radius"], 0.12 * p(x)["diameter"])'
cp x.json percent.json
find_features --ball-radius "$(python3 -c 'import json; print(json.load(open("x.json"))["parameters"]["ball_radius"])')"
check 'x["features"] == percent["features"]'
differs --alpha 2
# Without curvature there are no balls.
differs --alpha 0 --verbose
grep -q "strain" err || fail "--verbose does not tell the stages"
if grep -q "balls" err; then fail "balls with --alpha 0"; fi
check 'p(x)["ball_radius"] is None and p(x)["alpha"] == 0'
differs --sigma-range 3%:20%
check 'near(p(x)["sigma_levels"][2], 0.03 * p(x)["diameter"])'
check 'all(f["sigma"] >= 0.03 * p(x)["diameter"] * (1 - 1e-6) for f in x["features"])'
differs --sigma-range 2.5%:
differs --sigma-range :3%
check 'all(f["sigma"] <= 0.03 * p(x)["diameter"] * (1 + 1e-6) for f in x["features"])'
differs --sigma-range 0.06:0.2
check 'near(p(x)["sigma_levels"][2], 0.06)'
differs --tau-range 0.105:0.42
check 'near(p(x)["tau_levels"][2], 0.105) and near(p(x)["tau_levels"][-3], 0.42)'
check 'all(f["tau"] >= 0.105 * (1 - 1e-6) for f in x["features"])'
differs --tau-range :0.11
find_features --threshold 0
check 'len(x["features"]) > len(base["features"])'
check 'p(x)["threshold"] == 0 == p(x)["relative_threshold"] and p(base)["threshold"] == 0.1'
find_features --relative-threshold 1
check 'len(x["features"]) == 1 and x["features"][0] == base["features"][0] and p(x)["threshold"] == 0'
find_features --threshold 1e6
check 'x["features"] == []'
grep -q "below the threshold, 1e+06" err || fail "no reason for finding nothing: $(cat err)"
find_features --top 2
check 'x["features"] == base["features"][:2] and p(x)["top"] == 2'
find_features --threshold 0 --min-fit 0
cp x.json everything.json
check 'min(f["fit"] for f in base["features"]) >= 0.5 == p(base)["min_fit"] > min(f["fit"] for f in x["features"])'
# the strength is the amplitude times the fit, less where the ranges begin
check 'all(near(f["strength"], f["amplitude"] * max(0, f["fit"]), 1e-12) for f in x["features"]
           if f["tau"] > 0.12 and f["sigma"] > 0.02 * p(x)["diameter"])'
check 'all(f["strength"] <= f["amplitude"] * max(0, f["fit"]) * (1 + 1e-12) for f in x["features"])'
check 'any(f["strength"] < 0.5 * f["amplitude"] * f["fit"] for f in x["features"] if f["fit"] > 0.5)'
check 'all(f["parent"] is None or f["parent"] < i for i, f in enumerate(x["features"]))'
check 'sorted({f["place"] for f in x["features"]}) == list(range(1, 1 + max(f["place"] for f in x["features"])))'
check 'x["features"][0]["place"] == 1'
find_features --threshold 0 --min-fit 1
check 'x["features"] == []'
grep -q -- "--min-fit 1" err || fail "no reason for finding nothing: $(cat err)"
differs --baseline none
check 'p(x)["baseline"] == "none" and p(base)["baseline"] == "least"'
differs --dimension plane
check 'p(x)["dimension"] == "plane" and p(base)["dimension"] == "surface"'
find_features --threshold 0 --no-suppression
check 'len(x["features"]) > len(base["features"]) and p(x)["suppression"] is False'

# The parameters are all that is needed to do it again.
for options in "" "--preset published --box-width 2" \
  "--rest inches.obj --rescale-rest --sigma-range 2%: --tau-range 0.1:0.3 --ball-radius 9% --threshold 0.01" \
  "--rest average --alpha 0 --no-suppression --temporal-filter box --spatial-filter one-ring"; do
  # shellcheck disable=SC2086
  find_features $options
  cp x.json first.json
  mapfile -t arguments < <(python3 tool.py again first)
  expect 0 "" "${arguments[@]}" -o again.json
  cmp -s first.json again.json || fail "the parameters of \"$options\" give another result: ${arguments[*]}"
done

# The number of threads changes no byte.
find_features --threads 1
cp x.json one.json
find_features --threads 2
cmp -s x.json one.json || fail "another result with two threads"
cmp -s x.json base.json || fail "another result with all threads"

# Neither does the memory. Too little is refused with what it takes, before anything is done.
"$generator" cylinder --vertices 1500 --fps 150 -o memory >/dev/null ||
  fail "make_animation cannot make an animation to be computed on a disk"
rm -f x.json
expect 0 "fields in memory" memory.obj memory.pc2 --memory 2G --verbose -o in_memory.json
for tool in "" "--preset published --box-width 100"; do
  # shellcheck disable=SC2086
  expect 0 "" memory.obj memory.pc2 $tool -o in_memory.json
  # shellcheck disable=SC2086
  expect 1 "frames need about" memory.obj memory.pc2 $tool --memory 1M -o x.json
  nothing_written
  least="$(sed -nE 's/.* at least ([0-9]+)M .*/\1/p' err)"
  if [[ "$(uname)" == Linux && "$(stat -f -c %T .)" != tmpfs ]]; then
    # shellcheck disable=SC2086
    expect 0 "fields on ." memory.obj memory.pc2 $tool --memory "$((least + 1))M" --scratch . --verbose -o on_disk.json
    cmp -s in_memory.json on_disk.json || fail "another result on a disk: $tool"
    expect 4 "no such folder" memory.obj memory.pc2 --memory "$((least + 1))M" --scratch "no such folder" -o x.json
    nothing_written
  fi
done

# ----------------------------------------------------------------------------------------------------- output

expect 0 "x.csv" c.obj c.pc2 --fps 10 -o x.json -o x.csv -o x.ply -o csv:table.txt -o ply:cloud
check 'len(open("x.csv").readlines()) == len(base["features"]) + 1'
check '[line.split(",")[1] for line in open("x.csv")][1:] == [str(f["vertex"]) for f in base["features"]]'
cmp -s x.csv table.txt || fail "csv:FILE is another table"
cmp -s x.ply cloud || fail "ply:FILE is another cloud"
check '("element vertex %d\n" % len(base["features"])).encode() in open("x.ply", "rb").read()'
cmp -s x.json base.json || fail "JSON among other outputs is another one"
expect 0 "feature" c.obj c.pc2 --fps 10
cmp -s out base.json || fail "the default is not JSON on the standard output"
expect 0 "feature" c.obj c.pc2 --fps 10 -o -
cmp -s out base.json || fail "-o - is not JSON on the standard output"
expect 0 "feature" c.obj c.pc2 --fps 10 -o csv:-
cmp -s out x.csv || fail "-o csv:- is not the table"
expect 0 "" c.obj c.pc2 --fps 10 -o csv:/dev/stdout
cmp -s out x.csv || fail "-o csv:/dev/stdout is not the table"
"$program" c.obj c.pc2 --fps 10 -q | cmp -s - base.json || fail "JSON through a pipe"
mkfifo pipe
cat pipe >piped &
expect 0 "" c.obj c.pc2 --fps 10 -o json:pipe
wait $!
[[ -p pipe ]] || fail "the pipe was replaced"
cmp -s piped base.json || fail "JSON through a named pipe"
ln -s target.json link.json
expect 0 "" c.obj c.pc2 --fps 10 -o link.json
[[ -L link.json ]] || fail "the link was replaced"
cmp -s target.json base.json || fail "not written through a link"

expect 0 "" c.obj c.pc2 --quiet -o x.json
[[ ! -s err && ! -s out ]] || fail "--quiet is not quiet: $(cat err)"
expect 0 "peak" c.obj c.pc2 --verbose -o x.json
for word in "$vertices vertices" "border edges" "isolated" "degenerate" "minima" "limit" "reading" "geodesic balls" \
  "curvature" "strain" "scale space" "extrema" "writing" "total" " s" " MB"; do
  grep -qF -- "$word" err || fail "--verbose lacks $word"
done
python3 tool.py terminal "$program" c.obj c.pc2 -o x.json >seen || fail "on a terminal"
grep -q '#.*%.*extrema' seen || fail "no progress bar on a terminal"
python3 tool.py terminal "$program" c.obj c.pc2 -o x.json --quiet >seen || fail "quietly on a terminal"
[[ ! -s seen ]] || fail "--quiet is not quiet on a terminal"

expect 0 "" c.obj c.pc2 --fps 10 --rest first -o x.json
cp x.json rest_first.json
expect 0 "d.npy" c.obj c.pc2 --fps 10 --rest first -o x.json --write-field strain:s.npy --write-field curvature:k.npy \
  --write-field deformation:d.npy
cmp -s x.json rest_first.json || fail "other features when fields are written"
check "npy('s.npy')[0] == ($vertices, $frames)"
check 'all(abs(s + 7 * k - d) < 1e-5 for s, k, d in zip(npy("s.npy")[1], npy("k.npy")[1], npy("d.npy")[1]))'
check 'min(npy("k.npy")[1]) >= 0 and max(npy("k.npy")[1]) > 0.001 and max(npy("s.npy")[1]) > 0.01'
# in the first frame, the rest shape, nothing is deformed
check "max(npy('d.npy')[1][::$frames]) < 1e-5"
expect 0 "" c.obj c.pc2 --rest first --alpha 0 --write-field curvature:k0.npy -o x.json
cmp -s k.npy k0.npy || fail "the curvature depends on its weight"

# Scenes; what is in them is tested elsewhere.
expect 0 "written to x.json, scene" c.obj c.pc2 --fps 10 -o x.json --vtk scene/
cmp -s x.json base.json || fail "other features when a scene is written"
[[ -s scene/surface.pvd && -s scene/features_0015.vtp ]] || fail "--vtk: no series"
expect 0 "feature" c.obj c.pc2 --alpha 0 --vtk scene2
[[ ! -s out ]] || fail "JSON on the standard output beside a scene"
grep -q '"strain"' scene2/surface_0000.vtp || fail "--vtk --alpha 0: no strain"
if grep -q '"curvature"' scene2/surface_0000.vtp; then fail "curvature with --alpha 0"; fi
expect 0 "" c.obj c.pc2 --fps 10 -o x.json --glb scene.glb --plot scene.svg
cmp -s x.json base.json || fail "other features when scenes are written"
expect 0 "" c.obj c.pc2 --fps 10 --plot -
cmp -s out scene.svg || fail "--plot - is not the plot"
"$program" c.obj c.pc2 --fps 10 -q --glb - | cmp -s - scene.glb || fail "--glb - is not the scene"
echo mine >scene/notes.txt
expect 0 "" c.obj c.pc2 --vtk scene
[[ "$(cat scene/notes.txt)" == mine ]] || fail "--vtk touches other files of the folder"
! cmp -s scene/surface_0003.vtp scene2/surface_0003.vtp || fail "--vtk does not replace a scene"
# the viewer is an optional component
if "$program" c.obj c.pc2 -q --html v.html 2>err; then
  expect 0 "written to x.json, v.html" c.obj c.pc2 --fps 10 -o x.json --html v.html
  cmp -s x.json base.json || fail "other features when a page is written"
  grep -qE '"title": ?"c"' v.html || fail "--html: no scene in the page"
  [[ $(grep -c 'id="scene-field-' v.html) -eq 1 ]] || fail "--html: more or less than the deformation"
  expect 0 "" c.obj c.pc2 --html w.html --html-every 4 --write-field strain:s.npy -q
  grep -qE '"kept_frames": ?\[0, ?4, ?8, ?12, ?15\]' w.html || fail "--html-every 4: other frames"
  [[ $(grep -c 'id="scene-field-' w.html) -eq 2 ]] || fail "--html: no strain, although it was written"
  rm x.json
  output "nowhere/v.html: cannot write" c.obj c.pc2 --html nowhere/v.html
else
  grep -q "built without the viewer" err || fail "--html: $(cat err)"
fi
no_temporaries

# ----------------------------------------------------------------------------------------------------- kinds of input

# Frames in natural order, in a folder and one by one, are the same animation.
mkdir frames
(cd frames && python3 ../tool.py frames ../c "$(seq -s, -f 'walk%g.obj' 1 16)")
expect 0 "" frames --fps 10 --rest c.obj -o x.json
check 'x["features"] == base["features"]'
expect 0 "" frames/walk*.obj --fps 10 --rest c.obj -o x.json
check 'x["features"] == base["features"]'
expect 0 "" c.pc2 c.obj --fps 10 -o x.json
check 'x["features"] == base["features"]'

# Numbers have signs where some names have none; what does not belong to the series is told.
mkdir signed && (cd signed && python3 ../tool.py frames ../c "$(seq -s, -f 'sim%g.obj' -5 10)")
cp c.obj signed/template.obj
expect 0 "not among the 16 frames, to whose series the name does not belong: template.obj" signed --fps 10 --rest c.obj -o x.json
grep -q "read as numbers with signs, from sim-5.obj to sim10.obj" err || fail "signs in names: $(cat err)"
grep -q " in 16 frames against c.obj, computed in" err || fail "the number of frames is not told: $(cat err)"
check 'x["features"] == base["features"]'
expect 0 "" frames/walk{1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16}.obj --as-given --fps 10 --rest c.obj -o x.json
check 'x["features"] == base["features"] and p(x)["as_given"] is True'
rm x.json
input "walk9.obj: follows walk7.obj, but 1 of the series is missing" frames/walk{1..7}.obj frames/walk{9..16}.obj -o x.json
usage "--as-given goes with" frames --as-given -o x.json

# A seam, along which the first vertex is there twice, is closed; what is reported are vertices of the file.
python3 tool.py seam c seam
expect 0 "lie where another one does in all frames: welded" seam.obj seam.pc2 --fps 10 -o x.json --vertex-map map.csv
check 'where(x) == where(base) and all(f["file_vertices"][0] == f["vertex"] for f in x["features"])'
check 'x["animation"]["vertices"] == base["animation"]["vertices"] and p(x)["weld"] == "auto"'
check 'any(line.startswith("%d," % base["animation"]["vertices"]) for line in open("map.csv"))'
expect 0 "" seam.obj seam.pc2 --fps 10 --rest seam.obj -o y.json
expect 0 "" c.obj c.pc2 --fps 10 --rest c.obj -o z.json
check 'where(y) == where(z) and len(where(z)) > 0'
expect 0 "" seam.obj seam.pc2 --fps 10 --weld never -o y.json
check 'y["animation"]["vertices"] > base["animation"]["vertices"]'

# Of two bodies in a file, one is taken by its name, or by its number; it is what it is alone, and what is reported are
# vertices of the file, too.
python3 tool.py pair c pair
expect 0 "" pair.obj pair.pc2 --fps 10 --part "the body" -o x.json --vertex-map map.csv
check 'where(x) == where(base) and len(where(x)) > 0 and p(x)["part"] == "the body"'
check '[f["strength"] for f in x["features"]] == [f["strength"] for f in base["features"]]'
n='base["animation"]["vertices"]'
check "x['animation']['vertices'] == $n and all(f['file_vertices'] == [f['vertex'] + $n] for f in x['features'])"
check "open('map.csv').read().split()[1] == '%d,0,%d,0' % ($n, $n)"
expect 0 "" pair.obj pair.pc2 --fps 10 --part 2 --rest pair.obj -o y.json
check 'y["features"] == x["features"]'
expect 0 "" pair.obj pair.pc2 --fps 10 --part legs -o y.json
check 'y["animation"]["faces"] == x["animation"]["faces"] - 1'
expect 0 "parts: \"copy\", \"the body\", \"arm\", \"legs\"; components 1 (" pair.obj pair.pc2 --fps 10 --verbose -o y.json
rm x.json
usage "there is no part \"3\"; parts are \"copy\", \"the body\", \"arm\", \"legs\"; components 1 (" pair.obj pair.pc2 --part 3 -o y2.json
usage "there is no part \"2\"; parts are one component, 1 (" c.obj c.pc2 --part 2 -o y2.json

# MDD files tell the time.
python3 tool.py mdd c "0.5 + 0.1 * i" timed.mdd
expect 0 "" c.obj timed.mdd -o x.json
check 'where(x) == where(base) and near(p(x)["fps"], 10, 1e-5)'
expect 0 "" c.obj timed.mdd --fps 10 -o x.json
check 'x["features"] == base["features"]'
python3 tool.py mdd c "i" numbers.mdd
expect 0 "numbers.mdd: its times tell a frame rate of 1 a second; if they are numbers of frames" c.obj numbers.mdd -o x.json
python3 tool.py mdd c "0.1 * i + (i > 5)" jump.mdd
rm -f x.json
input "frame 6" c.obj jump.mdd -o x.json
grep -q "jump.mdd.*--fps" err || fail "unequal times: no file or remedy in: $(cat err)"
expect 0 "" c.obj jump.mdd --fps 10 -o x.json
check 'x["features"] == base["features"]'

# ----------------------------------------------------------------------------------------------------- bad input

rm -f x.json
input "missing.obj: cannot read" missing.obj c.pc2 -o x.json
input "missing.pc2: cannot read" c.obj missing.pc2 -o x.json
input "missing.obj: cannot read" c.obj c.pc2 --rest missing.obj -o x.json
input "one mesh is no animation" c.obj -o x.json
input "mesh file" c.pc2 -o x.json

head -c 5000 c.pc2 >short.pc2
input "short.pc2" c.obj short.pc2 -o x.json
grep -q "whole frames" err || fail "a truncated PC2: $(cat err)"
head -c 20 c.pc2 >header.pc2
input "header.pc2: ends within the header" c.obj header.pc2 -o x.json
: >empty.pc2
input "empty.pc2: is empty" c.obj empty.pc2 -o x.json

"$generator" cylinder --vertices 300 --fps 10 -o other >/dev/null || fail "make_animation"
input "$vertices vertices" c.obj other.pc2 -o x.json
grep -q "other.pc2: has .* points, but the mesh c.obj" err || fail "another point count: $(cat err)"

for value in nan inf -inf; do
  python3 tool.py poke c 7 123 "$value" bad.pc2
  input "bad.pc2: frame 7, vertex 123" c.obj bad.pc2 -o x.json
  mkdir bad && cp f0.obj f2.obj bad/
  sed "s/^v [^ ]*/v $value/" f1.obj >bad/f1.obj
  input "bad/f1.obj" bad -o x.json
  grep -q "vertex 0" err || fail "$value in OBJ: $(cat err)"
  rm -r bad
done
sed "s/^v [^ ]*/v nan/" f1.obj >nan.obj
input "nan.obj" c.obj c.pc2 --rest nan.obj -o x.json

printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 2 5 3\nf 1 2 3 4\n' >quad0.obj
sed 's/v 1 1 0/v 1 1 0.2/' quad0.obj >quad1.obj
sed 's/v 1 1 0/v 1 1 0.4/' quad0.obj >quad2.obj
input "face 1" quad0.obj quad1.obj quad2.obj -o x.json
grep -q -- "quad0.obj.*--triangulate" err || fail "a quad: no file or remedy in: $(cat err)"
# cut, it is an animation, if too small a one for any feature
expect 0 "" quad0.obj quad1.obj quad2.obj --triangulate --sigma-range 80%:200% -o x.json
check 'x["animation"]["faces"] == 3 and p(x)["triangulate"] is True'
rm x.json

# The last two faces in another order, one less, other corners.
lines=$(wc -l <f1.obj)
{ head -n $((lines - 2)) f1.obj; tail -n 2 f1.obj | tac; } >swapped.obj
head -n -1 f1.obj >fewer.obj
triangles=$(grep -c '^f ' f1.obj)
input "swapped.obj: triangle $((triangles - 2))" --as-given f0.obj swapped.obj f2.obj -o x.json
input "fewer.obj: has $((triangles - 1)) triangles" --as-given f0.obj fewer.obj f2.obj -o x.json
input "swapped.obj: triangle $((triangles - 2))" c.obj c.pc2 --rest swapped.obj -o x.json
input "other.obj: has" c.obj c.pc2 --rest other.obj -o x.json
grep -q "c.obj" err || fail "a rest shape of another size: $(cat err)"

python3 tool.py cut c 1 one.pc2
input "one.pc2: one frame is no animation" c.obj one.pc2 -o x.json
python3 tool.py cut c 2 two.pc2
input "two.pc2: the animation has 2 frames; at least 3" c.obj two.pc2 -o x.json
input "the animation has 2 frames; at least 3" f0.obj f1.obj -o x.json
python3 tool.py cut c 3 three.pc2
expect 0 "" c.obj three.pc2 -o x.json
rm x.json
# Sizes whose squares and products leave the range of numbers.
for size in 1e80 1e-80; do
  for f in 0 1 2; do awk -v s=$size '/^v / { print "v", $2 * s, $3 * s, $4 * s; next } 1' f$f.obj >size$f.obj; done
  input "size0.obj: " size0.obj size1.obj size2.obj -o x.json
  grep -q "another unit of length is needed" err || fail "a size of $size: $(cat err)"
done
# Frames that are broken: refused with a way out, or bridged in time.
python3 tool.py poke c 14 7 1e30 exploded.pc2
input "exploded.pc2, frame 14: vertex 7 is 1e+30 away from the middle of the others" c.obj exploded.pc2 -o x.json
grep -q "command line: --skip-bad-frames" err || fail "no way out is told: $(cat err)"
expect 0 "note: exploded.pc2, frame 14: vertex 7 is 1e+30 away" c.obj exploded.pc2 --fps 10 --skip-bad-frames -o x.json
check 'p(x)["skip_bad_frames"] is True and where(x)[0] == where(base)[0] and p(base)["skip_bad_frames"] is False'
rm x.json
python3 tool.py zero c 0 0 zero.pc2
input "zero.pc2, frame 0: has no extent" c.obj zero.pc2 -o x.json
python3 tool.py zero c 12 13 zero.pc2
input "broken are 2 of 16 frames: 12-13" c.obj zero.pc2 -o x.json
expect 0 "note: zero.pc2, frame 12: has no extent" c.obj zero.pc2 --fps 10 --skip-bad-frames -o x.json
rm x.json
python3 tool.py zero c 14 14 zero.pc2
expect 0 "note: zero.pc2, frame 14: has no extent: all vertices are at one point; it is left out" c.obj zero.pc2 --fps 10 -o x.json
check 'where(x)[0] == where(base)[0]'
rm x.json
printf 'v 1 1 1\n%.0s' $(seq "$vertices") >point.obj
grep '^f ' c.obj >>point.obj
input "point.obj" c.obj c.pc2 --rest point.obj -o x.json

# No features: why.
tells() { grep -q -- "$1" err || fail "not told: $1, but $(cat err)"; }
for f in 0 1 2 3; do
  cp f0.obj still$f.obj
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 %s\nf 1 2 3\nf 2 4 3\n' $f >coarse$f.obj
done
expect 0 ": nothing deforms: " still0.obj still1.obj still2.obj still3.obj -o x.json
expect 0 "is below the threshold, 9 (--threshold)" c.obj c.pc2 --threshold 9 -o x.json
tells ": the strongest, [0-9.]*, is below the threshold"
expect 0 "; --tau-range 1.2:1.3 excludes others" c.obj c.pc2 --fps 10 --tau-range 1.2:1.3 -o x.json
tells ": the response has no minimum at sigma from .* to .*, tau from 1.2 to "
expect 0 "; 4 frames are few" f0.obj f1.obj f2.obj f3.obj -o x.json
tells "; the largest deformation, [0-9.]*, is at vertex [0-9]* in frame 3, the last"
rm x.json
coarse="coarse0.obj coarse1.obj coarse2.obj coarse3.obj"
input "coarse0.obj: the mesh is too coarse: " $coarse -o x.json
tells "its mean edge, [0-9.]*, is [0-9.]* % of the diagonal, so that nothing below sigma .*; subdivide it"
input "coarse0.obj: there are 0 smoothing counts in space" $coarse --preset published -o x.json
tells " % of the diagonal; subdivide it"
input "coarse0.obj: the mesh is too coarse" $coarse --tau-range 0.1: -o x.json
usage "can resolve" $coarse --sigma-range :10% -o x.json
expect 0 "" $coarse --sigma-range "$("$program" $coarse 2>&1 | sed 's/.*--sigma-range //')" -o x.json
rm x.json

mkdir nothing
input "nothing: the folder has no mesh files" nothing -o x.json

touch c.abc c.xyz
input "c.abc: Alembic files (.abc) are not read; known are meshes (.obj, .off, .ply, .stl), point caches" c.abc -o x.json
input "c.xyz: unknown kind of file" c.xyz c.pc2 -o x.json
usage "--weld and --repair go with meshes" c.glb --repair -o x.json
usage "choose among auto, always, never" c.obj c.pc2 --weld sometimes -o x.json
# A face twice, and one that is turned round.
{ cat c.obj; grep '^f ' c.obj | head -n 1; } >repeated.obj
input "repeated.obj: " repeated.obj c.pc2 -o x.json
expect 0 "note: repair: 1 face with the vertices of another face left out" repeated.obj c.pc2 --fps 10 --repair -o x.json
check 'x["features"] == [dict(f, file_vertices=[f["vertex"]]) for f in base["features"]] and p(x)["repair"] is True'
rm x.json
for f in 0 1 2; do printf 'v 0 0 %s\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n' $f >fan$f.obj; done
input "fan0.obj: edge (0, 1)" fan0.obj fan1.obj fan2.obj -o x.json
printf 'no mesh at all' >text.obj
input "text.obj" text.obj c.pc2 -o x.json
printf 'v 0 0 0\n' >text.txt
input "text.txt" text.txt c.pc2 -o x.json

# Allowed, and reported: several components, a degenerate triangle, an isolated vertex.
for f in 0 1 2; do
  { cat f$f.obj; printf 'v 50 0 %s\nv 50 1 0\nv 51 0 0\nv 60 0 0\nv 61 0 0\nv 62 0 0\nv 70 0 0\n' $f
    printf 'f %d %d %d\n' -7 -6 -5 -4 -3 -2; } >odd$f.obj
done
expect 0 "3 components" odd0.obj odd1.obj odd2.obj -v -o x.json
grep -q "1 isolated vertex, 1 degenerate triangle" err || fail "the report of an unusual mesh: $(cat err)"
rm x.json

# ----------------------------------------------------------------------------------------------------- bad output

mkdir folder.json
echo old >file
output "nowhere/x.json: cannot write" c.obj c.pc2 -o nowhere/x.json
output "folder.json: cannot write" c.obj c.pc2 -o folder.json
output "file/x.json: cannot write" c.obj c.pc2 -o file/x.json
output "nowhere/scene: cannot write" c.obj c.pc2 -o x.json --vtk nowhere/scene
output "file: cannot write" c.obj c.pc2 -o x.json --vtk file
output "nowhere/s.npy: cannot write" c.obj c.pc2 -o x.json --write-field strain:nowhere/s.npy
# The limit of the size of a file ends the program as a full disk does.
checks=$((checks + 1))
(ulimit -f 1; "$program" c.obj c.pc2 --fps 10 -q --write-field strain:s.npy -o x.json 2>err)
[[ $? -eq 4 ]] && grep -qF "s.npy: cannot write: File too large" err || fail "a file that becomes too large: $(cat err)"
nothing_written
if [[ -c /dev/full ]]; then
  for format in json csv ply; do output "/dev/full: cannot write" c.obj c.pc2 -o $format:/dev/full; done
  output "/dev/full: cannot write" c.obj c.pc2 -o x.json --glb /dev/full
  ln -s /dev/full full.svg # plots go by the ending
  output "full.svg: cannot write" c.obj c.pc2 -o x.json --plot full.svg
  rm full.svg
  output "/dev/full: cannot write" c.obj c.pc2 -o x.json --write-field deformation:/dev/full
  "$program" c.obj c.pc2 >/dev/full 2>err
  [[ $? -eq 4 ]] || fail "a full disk behind the standard output"
  "$program" --help >/dev/full 2>err
  [[ $? -eq 4 ]] || fail "a full disk behind --help"
  # What stood there stays, if any output fails.
  echo old >old.json
  output "/dev/full" c.obj c.pc2 -o old.json -o csv:/dev/full
  [[ "$(cat old.json)" == old ]] || fail "an old file was replaced although another output failed"
  [[ -c /dev/full ]] || fail "/dev/full was replaced"
fi
echo old >old.json
input "missing" missing.obj c.pc2 -o old.json
usage "resolve" c.obj c.pc2 -o old.json --sigma-range 0.0001%:0.0002%
[[ "$(cat old.json)" == old ]] || fail "an old file was replaced in spite of an error"

"$generator" cylinder --vertices 8000 --fps 10 -o big >/dev/null || fail "make_animation"
# A reader that goes away.
"$program" big.obj big.pc2 --alpha 0 -o x.json --write-field strain:- 2>err | head -c 1 >/dev/null
[[ ${PIPESTATUS[0]} -eq 4 ]] || fail "a reader that goes away"
nothing_written
code="$(python3 tool.py interrupt "$program" big.obj big.pc2 --balls heat-global --threads 1 -o old.json -o x.json \
  --vtk interrupted --glb interrupted.glb)"
[[ "$code" == 130 ]] || fail "SIGINT: $code"
nothing_written
[[ "$(cat old.json)" == old ]] || fail "an old file was replaced in spite of an interruption"
[[ -z "$(find . -name 'interrupted*')" ]] || fail "a scene is there in spite of an interruption"
# What a killed program leaves, the next one removes.
"$program" big.obj big.pc2 -q --balls heat-global --threads 1 -o x.json --vtk killed &
until [[ -n "$(find . -name '.*.tmp')" ]] || ! kill -0 $! 2>/dev/null; do sleep 0.02; done
kill -KILL $! 2>/dev/null
wait $! 2>/dev/null
[[ -n "$(find . -name '.*.tmp')" ]] || fail "a killed program left nothing: this tests nothing"
expect 0 "" c.obj c.pc2 --fps 10 --no-sync -o x.json --vtk killed
no_temporaries
rm -r x.json killed

[[ $failed -eq 0 ]] && echo "detect_features: $checks checks, all as expected"
exit $failed
