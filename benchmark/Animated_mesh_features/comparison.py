#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""How well animations are compared, on animations whose events, times and names are known: a figure a row, with what it is
by chance and by plainer ways.

comparison.py COMPARE_ANIMATIONS DATA [--work DIR] [--only NAME]... [--json FILE]

DATA is a folder of evaluation animations (horse, camel, twins_in_time, bodies, actions, clips); with NumPy. DIR keeps what
is expanded and computed. Bodies are taken on their coarse mesh, from the folder DIR/bodies, which is made by
DATA/bodies/expand.py DIR/bodies --low.
"""

import argparse
import json
import pathlib
import subprocess
import sys

import numpy as np

TWINS = ["horse-gallop-dec4200", "horse-gallop-irregular", "horse-gallop-half"]
FEW = ["--threshold", "0.03", "--min-fit", "0.3"]  # long lists, of which the strongest count


class Comparer:
    """Runs the program, with a cache."""

    def __init__(self, program, work):
        self.program, self.work = program, pathlib.Path(work)
        (self.work / "cache").mkdir(parents=True, exist_ok=True)

    def __call__(self, *arguments, keep=None, incomplete=False):
        output = self.work / (keep or "last.json")
        command = [self.program, *map(str, arguments), "--cache", str(self.work / "cache"), "--quiet", "-o", str(output)]
        code = subprocess.run(command, stderr=subprocess.DEVNULL if incomplete else None).returncode
        if code not in ((0, 3) if incomplete else (0,)):
            raise subprocess.CalledProcessError(code, command)
        return json.loads(output.read_text())


def points(path):
    return np.array([line.split()[1:4] for line in open(path) if line.startswith("v ")], float)


def frames(path):
    data = open(path, "rb").read()
    n, f = np.frombuffer(data, "<i4", 1, 16)[0], np.frombuffer(data, "<i4", 1, 28)[0]
    return np.frombuffer(data, "<f4", n * f * 3, 32).reshape(f, n, 3)


def diagonal(p):
    return float(np.linalg.norm(p.max(0) - p.min(0)))


def auc(same, different):
    """The share of pairs of which the distance of the same event is the smaller one: the area below the ROC."""
    all_ = np.r_[same, different]
    rank = np.empty(len(all_))
    rank[np.argsort(all_, kind="stable")] = np.arange(len(all_))
    n, m = len(same), len(different)
    return float(1 - (rank[:n].sum() - n * (n - 1) / 2) / (n * m))


def retrieval(distances, bodies, motions):
    """Nearest neighbour and mean average precision among other bodies, of those that have the motion."""
    nearest, precisions = [], []
    for q in range(len(distances)):
        others = [j for j in range(len(distances)) if bodies[j] != bodies[q]]
        relevant = sum(motions[j] == motions[q] for j in others)
        if relevant == 0:
            continue
        hits = np.array([motions[j] == motions[q] for j in sorted(others, key=lambda j: distances[q][j])])
        nearest.append(hits[0])
        precisions.append((np.cumsum(hits) / np.arange(1, len(hits) + 1))[hits].sum() / relevant)
    return float(np.mean(nearest)), float(np.mean(precisions))


def warped(sequences):
    """Distances of sequences of vectors by dynamic time warping in steps of (1, 1), (1, 2) and (2, 1)."""
    n = len(sequences)
    result = np.zeros((n, n))
    for i in range(n):
        for j in range(i):
            a, b = sequences[i], sequences[j]
            c = np.sqrt(((a[:, None] - b[None]) ** 2).sum(-1))
            best = np.full((len(a) + 2, len(b) + 2), np.inf)
            best[2, 2:] = np.cumsum(c[0])
            best[2:, 2] = np.cumsum(c[:, 0])
            for x in range(1, len(a)):
                for y in range(1, len(b)):
                    best[x + 2, y + 2] = min(best[x + 1, y + 1] + 2 * c[x, y],
                                             best[x + 1, y] + 2 * c[x, y - 1] + c[x, y],
                                             best[x, y + 1] + 2 * c[x - 1, y] + c[x, y])
            ends = [best[-1, y + 2] + c[-1, y + 1:].sum() for y in range(len(b))]
            ends += [best[x + 2, -1] + c[x + 1:, -1].sum() for x in range(len(a))]
            result[i, j] = result[j, i] = min(ends) / (len(a) + len(b))
    return result


def shape_distributions(paths, rates):
    """For each animation the histogram of distances between two points, frame by frame (Osada et al. 2002)."""
    random = np.random.default_rng(0)
    result = []
    for path, rate in zip(paths, rates):
        p = frames(path)[::max(1, round(rate / 10))]
        i, j = random.integers(p.shape[1], size=(2, 2000))
        d = np.linalg.norm(p[:, i] - p[:, j], axis=2)
        d /= d.mean()
        result.append(np.array([np.histogram(x, 16, (0, 2.5))[0] / 2000 for x in d]))
    return result


def descriptor_distances(compare, data, twin, descriptor="rotation-free", most=150):
    """Distances of the descriptors of the horse and a twin, of their strongest features; whether they are at the same place
    and time, in either of the two cycles; whether in the same one; and whether their scales are the same, within a factor
    of 1.5. All `most x most`, or as many as there are."""
    kept = data / (twin + "_kept_ids.txt")
    vertices, rest = (np.loadtxt(kept, dtype=int), twin.replace("gallop", "rest") + ".obj") if kept.exists() else (
        np.arange(8431), "horse-rest.obj")
    place, p = points(data / "horse-rest.obj"), diagonal(points(data / "horse-rest.obj"))
    d = {}
    for name, rest_file in (("horse-gallop", "horse-rest.obj"), (twin, rest)):
        found = compare("describe", data / (name + ".pc2"), "--rest", data / rest_file, "--rescale-rest", *FEW,
                        *(["--fps", "15"] if name.endswith("half") else []), "--descriptor", descriptor)
        d[name] = found["features"][:most]
    a, b = d["horse-gallop"], d[twin]
    x, y = (np.array([f["descriptor"] for f in s]) for s in (a, b))
    distance = np.linalg.norm(x[:, None] - y[None], axis=2)
    in_space = np.linalg.norm(place[[f["vertex"] for f in a]][:, None] - place[vertices[[f["vertex"] for f in b]]][None],
                              axis=2)
    late = np.abs(np.array([f["time"] for f in a])[:, None] - np.array([f["time"] for f in b])[None]) * 30
    in_cycle, late = late, np.minimum(late, np.abs(late - 24))  # the cycle is played twice, exactly
    ratios = [np.abs(np.log(np.array([f[s] for f in a])[:, None] / np.array([f[s] for f in b])[None]))
              for s in ("sigma", "tau")]
    near = in_space <= 0.05 * p
    return distance, near & (late <= 1.5 + 1e-9), near & (in_cycle <= 1.5 + 1e-9), np.maximum(*ratios) <= np.log(1.5)


def descriptor_rows(compare, data, twin):
    """Mutual nearest neighbours of the descriptors of the horse and a twin. `possible`: of how many of these features of the
    horse the twin has the event at all; at half the rate it does not have those of less than two frames."""
    for descriptor, most in (("rotation-free", 150), ("rotation-free", 1000), ("oriented", 150), ("oriented", 1000)):
        distance, same, in_cycle, of_one_scale = descriptor_distances(compare, data, twin, descriptor, most)
        for which, allowed in (("", same | True), (", like scales", of_one_scale)):
            d = np.where(allowed, distance, np.inf)
            first, second = d.argmin(1), d.argmin(0)
            mutual = [i for i in range(len(d)) if second[first[i]] == i and np.isfinite(d[i, first[i]])]
            of = lambda pairs: float(np.mean([pairs[i, first[i]] for i in mutual]))
            possible = np.mean((same & allowed)[mutual].any(1))
            yield (f"{descriptor}, {twin}, {'150' if most == 150 else 'all'}{which}: true", of(same), same[allowed].mean(),
                   f"{len(mutual)} mutual nearest; possible {possible:.3f}; in the same cycle {of(in_cycle):.3f}; area "
                   f"below the ROC {auc(d[allowed & same], d[allowed & ~same]):.3f}")


def descriptors(compare, data, _):
    for twin in TWINS:
        yield from descriptor_rows(compare, data, twin)


def moves(cache, times):
    """Whether a body of 30 frames a second moves at some times: by more than 2 % of its largest speed, the root mean square
    over the vertices. Where it does not, no warp of time can be seen."""
    p = frames(cache)
    p = p - p.mean(1, keepdims=True)
    speed = np.sqrt((np.diff(p, axis=0) ** 2).sum(2).mean(1))
    k = np.clip(np.floor(times * 30).astype(int), 0, len(speed) - 1)
    return speed[k] > 0.02 * speed.max()


def alignment(compare, data, _):
    camel = f"{data}/camel-gallop-manifold.obj,{data}/camel-gallop-manifold.pc2"
    pair = compare(data / "horse-gallop.pc2", camel)
    t = np.arange(48) / 30
    error = np.abs(mapped(pair, t) - t) * 30
    yield "alignment, horse and camel: median error (frames)", float(np.median(error)), None, \
        f"95 %: {np.quantile(error, 0.95):.2f}, confidence {pair['alignment']['confidence']:.2f}"
    truth = json.loads((data / "twins_in_time/twins_low.json").read_text())
    folder = data / "twins_in_time"
    for clip, twins in truth.items():
        mesh = folder / (clip.split("__")[0] + "_low.obj")
        original = f"{mesh},{folder / twins['original']['file']}"
        for name, twin in twins.items():
            if name == "original":
                continue
            pair = compare(f"{mesh},{folder / twin['file']}", original) if twin["fps"] == 30 else None
            if pair and "u" in twin:
                t = np.arange(pair["a"]["frames"]) / 30
                truth_b = np.interp(t, twin["u"], twin["t"])
                error, unmoved = np.abs(mapped(pair, t) - truth_b) * 30, np.abs(t - truth_b) * 30
                seen = moves(folder / twins["original"]["file"], truth_b)
                yield f"alignment, {clip} {name}: median error (frames)", float(np.median(error)), \
                    float(np.median(unmoved)), \
                    f"95 %: {np.quantile(error, 0.95):.2f}; where it moves, {np.mean(seen):.2f} of the time: " \
                    f"{np.median(error[seen]):.2f}, 95 %: {np.quantile(error[seen], 0.95):.2f}; beside: without alignment"
            elif pair:
                yield f"confidence, {clip} {name}", pair["alignment"]["confidence"], None, \
                    f"distance {pair['distance']:.3f}"


WARPS = {"early": (0.3, 0, 1), "late": (-0.3, 0, 1), "slower": (0.15, -0.2, 1.2), "faster": (-0.2, 0.25, 0.8),
         "uneven": (0.5, -0.2, 1)}  # a and b of t = D (x + a sin(2 pi x) / (2 pi) + b sin(4 pi x) / (4 pi)); duration


def warped_twins(data, work):
    """Two of the bodies in each motion, in five warps of time: rotations of joints are linear between frames. For each
    the motion, its clip, its times, the original's times, and the original clips of this and of another body."""
    sys.path.insert(0, str(data / "bodies"))
    import expand

    bodies, motions = (sorted({c[k] for c in clips_of_bodies(work)}) for k in (0, 1))
    folder = work / "warps"
    folder.mkdir(exist_ok=True)
    for k, motion in enumerate(motions):
        for body in (bodies[k % 5], bodies[(k + 2) % 5]):
            rig, shape, keys = expand.load(body, motion)
            keys, n = dict(keys), len(keys["root"])
            rotations, roots = keys["rotvec"].astype(float), keys["root"].astype(float)
            for warp, (a, b, stretch) in WARPS.items():
                x = np.linspace(0, 1, round((n - 1) * stretch) + 1)
                times = np.clip(x + a * np.sin(2 * np.pi * x) / (2 * np.pi) + b * np.sin(4 * np.pi * x) / (4 * np.pi), 0, 1)
                i = np.minimum((times * (n - 1)).astype(int), n - 2)
                f = times * (n - 1) - i
                keys["rotvec"] = rotations[i] * (1 - f)[:, None, None] + rotations[i + 1] * f[:, None, None]
                keys["root"] = roots[i] * (1 - f)[:, None] + roots[i + 1] * f[:, None]
                cache = folder / f"{body}__{motion}_{warp}.pc2"
                if not cache.exists():
                    expand.write_pc2(cache, expand.frames(rig, shape, keys, True))
                clips = [f"{work}/bodies/{o}_low.obj,{work}/bodies/{o}__{motion}_low.pc2"
                         for o in (body, bodies[(bodies.index(body) + 1) % 5])]
                yield motion, f"{work}/bodies/{body}_low.obj,{cache}", np.arange(len(x)) / 30, times * (n - 1) / 30, clips


def warps(compare, data, work):
    """Alignment of warped twins of all motions: medians over ten twins each of the median and the 95 % error; the largest."""
    errors = {}
    for motion, twin, t, truth, clips in warped_twins(data, work):
        for whose, clip in zip(("", ", other body"), clips):
            error = np.abs(mapped(compare(twin, clip), t) - truth) * 30
            both = np.median(error), np.quantile(error, 0.95), np.median(np.abs(t - truth) * 30)
            errors.setdefault((whose, motion), []).append(both)
            errors.setdefault((whose, "all"), []).append(both)
    for (whose, motion), e in sorted(errors.items()):
        e = np.array(e)
        yield f"alignment, warped {motion}{whose}: median error (frames)", float(np.median(e[:, 0])), \
            float(np.median(e[:, 2])), f"largest {e[:, 0].max():.2f}; 95 %: {np.median(e[:, 1]):.2f}, largest " \
            f"{e[:, 1].max():.2f}; at most 1 / 3 frames: {np.mean((e[:, 0] <= 1) & (e[:, 1] <= 3)):.2f}, .5 / 1.5: " \
            f"{np.mean((e[:, 0] <= 0.5) & (e[:, 1] <= 1.5)):.2f}; beside: without alignment"


def mapped(pair, t):
    a, b = np.array(pair["alignment"]["times_a"]), np.array(pair["alignment"]["times_b"])
    return np.where(t < a[0], b[0] + t - a[0], np.where(t > a[-1], b[-1] + t - a[-1], np.interp(t, a, b)))


def clips_of_bodies(work):
    for cache in sorted((work / "bodies").glob("*_low.pc2")):
        body, motion = cache.name[:-len("_low.pc2")].split("__")
        yield body, motion, work / "bodies" / (body + "_low.obj"), cache


def matching(compare, _, work):
    clips = {(b, m): (mesh, cache) for b, m, mesh, cache in clips_of_bodies(work)}
    pairs = [("child", "man_muscular"), ("woman_slim", "woman_heavy"), ("man_old", "child"), ("woman_heavy", "man_old")]
    rights, numbers, guesses = [], [], []
    for motion in sorted({m for _, m in clips}):
        for a, b in pairs:
            if (a, motion) not in clips or (b, motion) not in clips:
                continue
            found = compare(*(f"{clips[c, motion][0]},{clips[c, motion][1]}" for c in (a, b)), "--matched", "50", *FEW)
            p = points(clips[b, motion][0])
            is_right = [np.linalg.norm(p[m["vertex_a"]] - p[m["vertex_b"]]) <= 0.05 * diagonal(p) and
                        abs(m["time_a"] - m["time_b"]) <= 1.5 / 30 + 1e-9 for m in found["matches"]]
            numbers.append(len(is_right))
            if is_right:
                rights.append(np.mean(is_right))
                guesses += [np.linalg.norm(p[m["vertex_a"]] - p[n["vertex_b"]]) <= 0.05 * diagonal(p) and
                            abs(m["time_a"] - n["time_b"]) <= 1.5 / 30 + 1e-9
                            for m in found["matches"] for n in found["matches"]]
    yield "matching, same motion on another body: right", float(np.mean(rights)), float(np.mean(guesses)), \
        f"{len(numbers)} pairs of clips"
    yield "matching, same motion on another body: number", float(np.mean(numbers)), None, \
        f"least {min(numbers)}, {np.mean(np.array(numbers) >= 15):.2f} of the clips have 15"


def retrieval_rows(compare, name, collection, bodies_and_motions, paths=(), rates=()):
    """`bodies_and_motions`: of an animation's name; `paths`: point caches, if there are any."""
    without = {"recurrence": ["--distance-recurrence-weight", "0"], "cycles": ["--cycle-weight", "0"],
               "pose variation": ["--variation-weight", "0"], "durations": ["--duration-weight", "0"]}
    matrix = lambda *options: compare("matrix", *collection, *options, incomplete=True)
    found = matrix()
    bodies, motions = zip(*(bodies_and_motions(a["name"]) for a in found["animations"]))
    ways = [("retrieval", found["distances"])]
    ways += [(f"without {part}", matrix(*options)["distances"]) for part, options in without.items()]
    ways.append(("time warping of the mean deformation", matrix(*sum(without.values(), []))["distances"]))
    if paths:
        ways.append(("time warping of shape distributions", warped(shape_distributions(paths, rates))))
    ways.append(("random", np.random.default_rng(1).random((len(bodies), len(bodies)))))
    for way, distances in ways:
        nearest, precision = retrieval(distances, bodies, motions)
        yield f"{name}, {way}: nearest neighbour", nearest, None, f"mean average precision {precision:.3f}"


def retrieval_bodies(compare, _, work):
    clips = list(clips_of_bodies(work))
    listed = work / "bodies.txt"
    listed.write_text("".join(f'"{mesh}" "{cache}"\n' for _, _, mesh, cache in clips))
    yield from retrieval_rows(compare, "bodies", [listed], lambda name: name[:-len("_low")].split("__"),
                              [c[3] for c in clips], [30] * len(clips))


def retrieval_actions(compare, data, work):
    meta = json.loads((data / "actions/meta.json").read_text())
    clips = [(c, a, v["fps"]) for c in meta for a, v in meta[c].get("actions", {}).items()]
    folder, listed = data / "actions", work / "actions.txt"
    listed.write_text("".join(f'"{folder}/{c}.obj" "{folder}/{c}__{a}.pc2" --fps {fps} --rest "{folder}/{c}.obj"\n'
                              for c, a, fps in clips))
    # those that are played again and again, as loops
    loops = work / "loops.txt"
    loops.write_text("".join(line + (" --cyclic" if meta[c]["actions"][a]["cycles"] else "") + "\n"
                             for line, (c, a, _) in zip(listed.read_text().splitlines(), clips)))
    for which, collection in (("as loops", loops), ("as they end", listed)):
        found = compare("matrix", collection)
        kept = [i for i, (c, a, _) in enumerate(clips) if meta[c]["actions"][a]["cycles"]]
        distances = np.array(found["distances"])
        names = [found["animations"][i]["name"].split("__") for i in range(len(distances))]
        for of, some in (("", range(len(distances))), (" of those that are loops", kept)):
            nearest, precision = retrieval(distances[np.ix_(some, some)], *zip(*(names[i] for i in some)))
            yield f"actions, {which}{of}: nearest neighbour", nearest, None, f"mean average precision {precision:.3f}"
    yield from retrieval_rows(compare, "actions", [listed], lambda name: name.split("__"),
                              [folder / f"{c}__{a}.pc2" for c, a, _ in clips], [fps for _, _, fps in clips])


def retrieval_clips(compare, data, _):
    models = sorted((data / "clips").glob("*.glb"))
    yield from retrieval_rows(compare, "clips", [*models, "--clip", "all"], lambda name: name.split("/"))


def resampling(compare, data, work):
    listed = work / "twins.txt"
    horse, folder = "horse-gallop", data / "twins_in_time"
    clips = [(horse, horse, "horse-rest", ""), (horse + "-half", horse, "horse-rest", "--fps 15"),
             (horse + "-double", horse, "horse-rest", "--fps 60"),
             (horse + "-dec4200", horse, "horse-rest-dec4200", ""),
             (horse + "-irregular", horse, "horse-rest-irregular", "")]  # name, of which it is a twin, rest, rate
    lines = [f'"{data}/{n}.obj" "{data}/{n}.pc2" --rest "{data}/{r}.obj" --rescale-rest {o}\n' for n, _, r, o in clips]
    lines.append(f'"{data}/pcow.obj" "{data}/pcow.pc2"\n')
    twins = [(n, of) for n, of, _, _ in clips] + [("pcow", "pcow")]
    for clip in ("woman_slim__walkwhirl", "man_muscular__kick"):
        mesh = folder / (clip.split("__")[0] + "_low.obj")
        for kind, rate in (("", 30), ("_half", 15), ("_noise", 30)):
            lines.append(f'"{mesh}" "{folder}/{clip}{kind}_low.pc2" --fps {rate}\n')
            twins.append((clip + kind + "_low", clip + "_low"))
    listed.write_text("".join(lines))
    found = compare("matrix", listed)
    d, index = np.array(found["distances"]), {a["name"]: i for i, a in enumerate(found["animations"])}
    originals = [index[n] for n, of in twins if n == of]
    different = float(np.mean([d[i, j] for i in originals for j in originals if i < j]))
    for name, of in twins:
        if name != of:
            yield f"distance of {name}, share of that of other motions", d[index[of], index[name]] / different, None, ""


TABLES = {"descriptors": descriptors, "matching": matching, "alignment": alignment, "warps": warps, "bodies": retrieval_bodies,
          "actions": retrieval_actions, "clips": retrieval_clips, "resampling": resampling}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", metavar="COMPARE_ANIMATIONS")
    parser.add_argument("data", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("comparison"))
    parser.add_argument("--only", action="append", choices=list(TABLES))
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    work = arguments.work.resolve()
    compare = Comparer(str(pathlib.Path(arguments.program).resolve()), work)
    rows = []
    for name in arguments.only or TABLES:
        for figure, value, beside, remark in TABLES[name](compare, arguments.data, work):
            rows.append({"figure": figure, "value": value, "beside": beside, "remark": remark})
            print(f"{figure:75}{value:8.3f}" + (f"  ({beside:.3f})" if beside is not None else "") + f"  {remark}",
                  flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
