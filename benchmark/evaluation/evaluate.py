#!/usr/bin/env python3
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the programs on animations whose events are known and on twins of animations, and writes the tables and curves
of the manual's page Does It Find What It Should. What is there already is not computed again: an interrupted run goes
on where it was. Called by scripts/evaluate.sh, which tells the options.
"""

import argparse
import functools
import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

import numpy

import tables
import twins

PRESETS = ["calibrated", "published"]
STATIC = {"saliency": "mesh saliency", "mesh-dog": "MeshDOG", "harris": "Harris 3D",
          "one-ring": "one-ring scale space", "hks": "heat kernel signature"}
BODIES = ["child", "man_muscular", "man_old", "woman_heavy", "woman_slim"]
MOTIONS = ["walk", "walkwhirl", "run", "squat", "kick", "wave", "bow", "cheer", "face", "jump", "pickup", "turnhead"]
PARTS = ["rig", "twins", "noise", "bodies", "static", "sheets"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", required=True, type=pathlib.Path, help="the folder of detect_features")
    parser.add_argument("--static", type=pathlib.Path, help="the program static_features; without: no static detectors")
    parser.add_argument("--work", required=True, type=pathlib.Path, help="where everything is kept")
    parser.add_argument("--page", type=pathlib.Path, help="the page whose tables are brought up to date")
    parser.add_argument("--figures", type=pathlib.Path, help="the folder of the page's curves")
    parser.add_argument("--data", type=pathlib.Path, help="the evaluation data")
    parser.add_argument("--bodies", default=",".join(BODIES), help="which of the data's bodies")
    parser.add_argument("--motions", default=",".join(MOTIONS), help="which of their motions")
    parser.add_argument("--parts", default=",".join(PARTS), help="which tables")
    parser.add_argument("--static-clips", default="child.kick,woman_slim.walk,man_muscular.squat",
                        help="the data's clips for static detectors, if they are among the chosen ones")
    parser.add_argument("--run-with", default="", help="what every command is run with, such as nice")
    parser.add_argument("--threads", type=int, default=0, help="threads of each command; 0: all")
    parser.add_argument("--quick", action="store_true", help="the figure alone, of half of the vertices")
    parser.add_argument("--time", type=float, default=1e9, help="start no command after so many seconds")
    return parser.parse_args()


class Out_of_time(Exception):
    """No time is left for another command; what depends on it is not in the tables."""


class Refused(Exception):
    """The program calls its input unusable; that is a result, too."""


class Commands:
    """Runs commands whose outputs are not there yet."""

    unusable_input = 3  # exit code

    def __init__(self, options):
        self.options = options
        self.started = time.monotonic()
        self.run = 0

    def __call__(self, command, outputs, folder):
        if all((folder / o).exists() for o in outputs):
            return
        seconds = time.monotonic() - self.started
        if seconds > self.options.time:
            raise Out_of_time
        print(f"{seconds:6.0f} s  {folder.name}: {' '.join(map(str, command[1:]))}"[:150], flush=True)
        command = shlex.split(self.options.run_with) + [str(c) for c in command]
        done = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              check=False)
        self.run += 1
        if done.returncode == self.unusable_input:
            raise Refused(done.stderr)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}\nin {folder} failed with {done.returncode}:\n{done.stderr}")


class Subject:
    """An animation in a folder of its own: mesh.obj, the shape at rest, frames.pc2, and events.json if they are
    known."""

    def __init__(self, lab, name, fps=30.):
        self.lab, self.name, self.fps = lab, name, fps
        self.folder = lab.options.work / name
        self.folder.mkdir(parents=True, exist_ok=True)

    def has_events(self):
        return (self.folder / "events.json").exists()

    def mesh(self):
        return self.folder / "mesh.obj"

    def arrays(self):
        return (*twins.read_obj(self.mesh()), twins.read_pc2(self.folder / "frames.pc2"))

    def write(self, rest, triangles, frames):
        if not (self.folder / "frames.pc2").exists():
            twins.write_obj(self.mesh(), rest, triangles)
            twins.write_pc2(self.folder / "part", frames)
            (self.folder / "part").rename(self.folder / "frames.pc2")

    def twin(self, name, make, *values, fps=None, keeps_events=False):
        twin = Subject(self.lab, f"{self.name}.{name}", fps or self.fps)
        if not (twin.folder / "frames.pc2").exists():
            twin.write(*make(*self.arrays(), *values))
            if keeps_events:  # the rest shape beside the noise looks like another mesh; the first frame does not
                _, triangles, frames = twin.arrays()
                twins.write_obj(twin.folder / "first.obj", frames[0], triangles)
        if keeps_events and self.has_events():
            shutil.copyfile(self.folder / "events.json", twin.folder / "events.json")
        return twin

    def features(self, detector, *options):
        """The file of what a detector finds: a preset, or a static detector, "+field" if it makes the field of ours."""
        lab = self.lab
        tag = "".join(o for o in options if o[0] != "-").replace(":", "_").replace(".", "").replace("%", "")
        file = self.folder / (detector + ("." + tag if tag else "") + ".json")
        mesh = "first.obj" if (self.folder / "first.obj").exists() else "mesh.obj"
        common = [mesh, "frames.pc2", "--fps", self.fps, "--rest", "mesh.obj", "--quiet"]
        if lab.options.threads:
            common += ["--threads", lab.options.threads]
        if detector in PRESETS:
            command = [lab.options.programs / "detect_features", *common, "-o", file.name, "--preset", detector,
                       *options]
            lab.commands(command, [file.name], self.folder)
        else:  # both at once
            name = detector.partition("+")[0]
            files = [f"{name}.json", f"{name}+field.json"]
            command = [lab.options.static, name, *common, "--points", files[0], "--field", files[1]]
            lab.commands(command, files, self.folder)
        return file

    def rig(self, file, top=None):
        """Recall and precision, with chance."""
        out = file.with_suffix(f".rig{top or ''}.json").name
        command = [self.lab.options.programs / "evaluate_features", "rig", file.name, "--events", "events.json",
                   "--rest", "mesh.obj", "-q", "-o", out]
        self.lab.commands(command + (["--top", top] if top else []), [out], self.folder)
        figures = load(self.folder / out)["figures"]["all"]
        return {key: (figures[key]["value"], figures[key]["chance"]) for key in ("recall", "precision")} | {
            "features": figures["precision"]["sample"], "events": figures["recall"]["sample"]}


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def repeatability(a, b, file_a, file_b, vertex_map="nearest", top=50):
    """Shares of the strongest that are found again, each with chance: keys are those of the program's JSON file."""
    lab = a.lab
    out = f"{file_a.stem}-{b.name}-{file_b.stem}.{top}.json"
    command = [lab.options.programs / "evaluate_features", "repeatability", file_a, file_b, "--rest-a", a.mesh(),
               "--rest-b", b.mesh(), "--map", vertex_map, "--top", top, "-q", "-o", out]
    lab.commands(command, [out], a.folder)
    figures = load(a.folder / out)["figures"]
    return {(t, k): (f["value"], f["chance"]) for t, fs in figures.items() for k, f in fs.items()}


class Lab:
    """All subjects."""

    def __init__(self, options):
        self.options = options
        self.commands = Commands(options)
        self.is_complete = True  # no rows are missing

    @functools.cached_property
    def figure(self):
        subject = Subject(self, "figure")
        self.generate(subject)
        return subject

    def generate(self, subject, vertices=None):
        if vertices is None and self.options.quick:
            vertices = 4200
        command = [self.options.programs / "make_animation", "figure", "--fps", subject.fps, "-o", "frames", "--events",
                   "events.json"] + (["--vertices", vertices] if vertices else [])
        self.commands(command, ["frames.obj", "frames.pc2"], subject.folder)
        shutil.copyfile(subject.folder / "frames.obj", subject.mesh())

    def other_figure(self, name, fps=30., vertices=None):
        """Of the figure, other meshes and frames are made anew, not from the ones that are there."""
        subject = Subject(self, "figure." + name, fps)
        self.generate(subject, vertices)
        return subject

    def horse(self, twin=""):
        """From the data; None where it is not at hand."""
        data = self.options.data
        if self.options.quick or not data or not (data / f"horse-gallop{twin}.pc2").exists():
            return None
        rates = {"-half": 15., "-double": 60.}
        subject = Subject(self, "horse" + twin, rates.get(twin, 30.))
        rest = "horse-rest" + ("" if twin in rates else twin) + ".obj"
        if not (subject.folder / "frames.pc2").exists():
            shutil.copyfile(data / rest, subject.mesh())
            shutil.copyfile(data / f"horse-gallop{twin}.pc2", subject.folder / "frames.pc2")
        return subject

    @functools.cached_property
    def bodies(self):
        """{(body, motion): Subject} of the data's bodies that were chosen."""
        o = self.options
        if o.quick or not o.data or not (o.data / "bodies" / "expand.py").exists():
            return {}
        made = o.work / "bodies"
        made.mkdir(exist_ok=True)
        chosen = [(b, m) for b in o.bodies.split(",") for m in o.motions.split(",")]
        missing = [f"{b}__{m}" for b, m in chosen if not (o.work / f"{b}.{m}" / "frames.pc2").exists()]
        if missing:
            self.commands([sys.executable, o.data / "bodies" / "expand.py", ".", *missing],
                          [f"{m}.pc2" for m in missing], made)
        result = {}
        for b, m in chosen:
            subject = Subject(self, f"{b}.{m}")
            if not (subject.folder / "frames.pc2").exists():
                shutil.copyfile(made / f"{b}.obj", subject.mesh())
                write_events(o.data / "bodies", b, m, subject.folder / "events.json")
                (made / f"{b}__{m}.pc2").rename(subject.folder / "frames.pc2")
            result[b, m] = subject
        return result


def write_events(data, body, motion, path):
    """The data's truth as evaluate_features reads it; the region of a joint: vertices whose weights on it and on what
    hangs on it sum to between .1 and .9."""
    rig = numpy.load(data / "rig.npz")
    truth = load(data / "truth" / f"{body}__{motion}.json")
    names, parents = [str(n) for n in rig["names"]], rig["parent"]
    joints = []
    for joint in truth["joints"]:
        maxima = [m for m in joint.get("maxima") or [] if m["prominence_deg"] > 0]
        if not maxima:
            continue
        own = names.index(joint["name"])
        hangs = numpy.zeros(len(names), bool)
        for j in range(len(names)):
            above = j
            while above >= 0 and above != own:
                above = parents[above]
            hangs[j] = above == own
        weight = (rig["weight"].astype(float) * hangs[rig["joint"]]).sum(1)
        region = numpy.flatnonzero((weight > .1) & (weight < .9)).tolist()
        if region:
            joints.append({"name": joint["name"], "region": region, "maxima": [
                {k: m[k] for k in ("time", "angle_deg", "prominence_deg")} for m in maxima]})
    path.write_text(json.dumps({
        "format": "animated-mesh-features-rig-events", "version": 1,
        "animation": {"vertices": truth["vertices"], "frames": truth["frames"], "frame_duration": 1 / truth["fps"]},
        "joints": joints}), encoding="utf-8")


# ---- the tables ------------------------------------------------------------------------------------------------------

def mean_rig(results):
    results = [r for r in results if r["recall"][0] is not None]
    pair = lambda key: tuple(float(numpy.mean([r[key][i] for r in results])) for i in (0, 1))
    return {"recall": pair("recall"), "precision": pair("precision"),
            "features": float(numpy.mean([r["features"] for r in results])),
            "events": float(numpy.mean([r["events"] for r in results])), "clips": len(results)}


def rig_table(lab):
    rows = []

    def add(name, subjects):
        rigs = [mean_rig([s.rig(s.features(p)) for s in subjects]) for p in PRESETS]
        row = [name, len(subjects), tables.rounded(rigs[0]["events"])]
        for r in rigs:
            row += (*tables.with_chance(r["recall"], r["precision"]), tables.rounded(r["features"]))
        rows.append(row)
    add("generated figure", [lab.figure])
    for motion in lab.options.motions.split(","):
        subjects = [s for (_, m), s in lab.bodies.items() if m == motion]
        if subjects:
            add(motion, subjects)
    if len(lab.bodies) > 1:
        add("<b>all bodies and motions</b>", list(lab.bodies.values()))
    head = ["motion", "clips", "events", *(f"`{p}`: {x}" if i == 0 else x for p in PRESETS for i, x in
                                           enumerate(("recall", "precision", "features")))]
    plot(lab, lab.figure, "evaluation_rig.svg", "rig", ["calibrated.json", "published.json"])
    return {"rig": tables.markdown(head, rows)}


def plot(lab, subject, name, measure, files, *options):
    """Curves, drawn by evaluate_features; files are named as the key shall name them."""
    extra = ["--events", "events.json", "--rest", "mesh.obj"] if measure == "rig" else []
    lab.commands([lab.options.programs / "evaluate_features", measure, *files, *extra, *options, "-q", "--plot", name],
                 [name], subject.folder)
    if lab.options.figures:
        shutil.copyfile(subject.folder / name, lab.options.figures / name)


def found_again(a, b, detector, options_a, options_b, vertex_map):
    """A row's cells of a detector."""
    r = repeatability(a, b, a.features(detector, *options_a), b.features(detector, *options_b), vertex_map)
    both = lambda key: tables.pair(r["a_in_b", key][0], r["b_in_a", key][0])
    chance = tables.pair(r["a_in_b", "place_time"][1], r["b_in_a", "place_time"][1])
    one = r["one_to_one", "place_time"], r["one_to_one", "place_time_scales"]
    return [both("place_time"), both("place_time_scales"), chance, tables.pair(one[0][0], one[1][0])]


LONG_LIST = ("--threshold", "0.01")  # lists of which the strongest 150 are a part


def figure_twins(lab):
    n = 4200 if lab.options.quick else 9000
    f = lab.figure
    return f, {"half the frame rate": (lab.other_figure("half_rate", 15.), "nearest"),
               "double frame rate": (lab.other_figure("double_rate", 60.), "nearest"),
               "half the vertices": (lab.other_figure("half", vertices=n // 2), "nearest"),
               "a quarter of the vertices": (lab.other_figure("quarter", vertices=n // 4), "nearest")
               } | own_twins(f, with_sampling=False)


def own_twins(s, with_sampling=True, with_subdivision=True):
    result = {}
    if with_sampling:
        result["half the frame rate"] = s.twin("half_rate", twins.at_half_rate, fps=s.fps / 2), "same"
        result["double frame rate, midpoints"] = s.twin("double_rate", twins.at_double_rate, fps=2 * s.fps), "same"
        result["half the vertices"] = s.twin("half", twins.with_fewer_vertices, .5), "nearest"
        result["a quarter of the vertices"] = s.twin("quarter", twins.with_fewer_vertices, .25), "nearest"
    result["a third of the vertices on one half"] = s.twin("irregular", twins.with_irregular_density), "nearest"
    if with_subdivision:
        result["four times the triangles"] = s.twin("subdivided", twins.subdivided), "nearest"
    result["turned by 50 degrees"] = s.twin("turned", twins.turned), "same"
    result["ten times as large"] = s.twin("scaled", twins.scaled, 10.), "same"
    return result | noise_twins(s)


def noise_twins(s):
    def twin(percent):
        return s.twin(f"noise{percent}", twins.with_noise, percent / 100, keeps_events=True)
    return {f"noise of {p} % of the diagonal": (twin(p), "same") for p in (.03, .1, .3, 1)}


def horse_twins(lab):
    horse = lab.horse()
    if not horse:
        return None, {}
    own = own_twins(horse)
    of_data = {"half the frame rate": ("-half", "same"), "double frame rate, midpoints": ("-double", "same"),
               "half the vertices": ("-dec4200", "nearest"),
               "a third of the vertices on one half": ("-irregular", "nearest"),
               "four times the triangles": ("-subdiv", "nearest")}
    for name, (twin, vertex_map) in of_data.items():
        if lab.horse(twin):
            own[name] = lab.horse(twin), vertex_map
    return horse, own


def body_twins(lab):
    chosen = lab.bodies.get(("child", "kick")) or next(iter(lab.bodies.values()), None)
    # 53,000 vertices with every smoothing count would take as long as all the rest
    return (chosen, own_twins(chosen, with_subdivision=False)) if chosen else (None, {})


def twin_row(subject, name, twin, vertex_map):
    row = [name]
    for p in PRESETS:
        options = LONG_LIST
        if "rate" in name and p == "calibrated":  # scales that both can have
            options += ("--tau-range", f"{1 / min(subject.fps, twin.fps):.7f}:")
        try:
            cells = found_again(subject, twin, p, options, options, vertex_map)
            if "as large" in name:
                cells[1] = "-"  # sigma is compared as a length there
            row += cells
        except Refused:
            row += ["refused", "", "", ""]
    return row


def twins_tables(lab):
    result = {}
    head = ["sampled otherwise"] + [f"`{p}`: {x}" if i == 0 else x for p in PRESETS for i, x in enumerate(
        ("place and time", "with scales", "chance", "one-to-one / with scales"))]
    for key, make in (("twins_figure", figure_twins), ("twins_horse", horse_twins), ("twins_body", body_twins)):
        subject, others = make(lab)
        if not subject:
            continue
        rows = []
        for name, twin in others.items():
            try:
                rows.append(twin_row(subject, name, *twin))
            except Out_of_time:
                lab.is_complete = False
        result[key] = tables.markdown(head, rows)
    f, half = lab.figure, lab.other_figure("half", vertices=(4200 if lab.options.quick else 9000) // 2)
    files = [s.features("calibrated", *LONG_LIST) for s in (f, half)]
    for name, file in zip(("figure.json", "half_the_vertices.json"), files):
        shutil.copyfile(file, f.folder / name)
    plot(lab, f, "evaluation_repeatability.svg", "repeatability", ["figure.json", "half_the_vertices.json"],
         "--rest-a", "mesh.obj", "--rest-b", half.mesh())
    return result


def noise_table(lab):
    rows = []
    body, _ = body_twins(lab)
    for title, s in (("generated figure", lab.figure), (body.name.replace(".", ", ") if body else "", body)):
        if not s:
            continue
        for name, twin in [("none", s)] + [(n.split(" of ")[1], t) for n, (t, _) in noise_twins(s).items()]:
            row = [title, name]
            for p in PRESETS:
                try:
                    r = twin.rig(twin.features(p))
                    row += (*tables.with_chance(r["recall"], r["precision"]), r["features"])
                except Refused:
                    row += ["refused", "", ""]
            rows.append(row)
    head = ["animation", "noise", *(f"`{p}`: {x}" if i == 0 else x for p in PRESETS for i, x in
                                    enumerate(("recall", "precision", "features")))]
    return {"noise": tables.markdown(head, rows)}


def bodies_table(lab):
    rows, everything = [], []
    for motion in lab.options.motions.split(","):
        subjects = [s for (_, m), s in lab.bodies.items() if m == motion]
        pairs = [(a, b) for i, a in enumerate(subjects) for b in subjects[i + 1:]]
        if not pairs:
            continue
        row = [motion, len(pairs)]
        per_preset = []
        for p in PRESETS:
            found = [repeatability(a, b, a.features(p, *LONG_LIST), b.features(p, *LONG_LIST), "same")
                     for a, b in pairs]
            figures = [tuple(float(numpy.mean([f["one_to_one", k][i] for f in found])) for i in (0, 1))
                       for k in ("place_time", "place_time_scales")]
            row += tables.with_chance(*figures)
            per_preset.append(figures)
        everything.append(per_preset)
        rows.append(row)
    if len(rows) > 1:
        means = numpy.mean(numpy.array(everything), axis=0)
        rows.append(["<b>mean</b>", sum(r[1] for r in rows)] + [c for p in means for c in tables.with_chance(*p)])
    head = ["motion", "pairs", *(f"`{p}`: {x}" if i == 0 else x for p in PRESETS for i, x in
                                 enumerate(("place and time", "with scales")))]
    return {"bodies": tables.markdown(head, rows)} if rows else {}


def static_table(lab):
    if not lab.options.static:
        return {}
    n = 4200 if lab.options.quick else 9000
    half = lab.other_figure("half", vertices=n // 2), "nearest"
    noisy = noise_twins(lab.figure)["noise of 0.1 % of the diagonal"]
    body_clips = [s for s in lab.bodies.values() if s.name in lab.options.static_clips.split(",")]
    rows = []
    detectors = [(p, f"`{p}`") for p in PRESETS]
    for d, t in STATIC.items():
        detectors += [(d, f"{t}, each frame"), (d + "+field", f"{t}, as a field")]
    for detector, title in detectors:
        rows.append([title] + static_cells(lab, detector, body_clips, half, noisy))
    head = ["detector", "features", "recall", "precision", *(["bodies: recall", "precision"] if body_clips else []),
            "half the vertices: found again", "chance", "noise of .1 %: found again", "chance"]
    return {"static": tables.markdown(head, rows)}


def static_cells(lab, detector, body_clips, half, noisy):
    """At as many features as the default finds."""
    def rig(s):
        count = s.rig(s.features("calibrated"))["features"]
        return s.rig(s.features(detector, *((*LONG_LIST,) if detector in PRESETS else ())), top=max(count, 1))

    def of_figure():
        r = rig(lab.figure)
        return [r["features"], *tables.with_chance(r["recall"], r["precision"])]

    def of_bodies():
        mean = mean_rig([rig(s) for s in body_clips])
        return tables.with_chance(mean["recall"], mean["precision"])

    def of_twin(twin, vertex_map):
        options = LONG_LIST if detector in PRESETS else ()
        found = found_again(lab.figure, twin, detector, options, options, vertex_map)
        return [found[0], found[2]]

    cells = []
    makers = [(of_figure, 3), *([(of_bodies, 2)] if body_clips else []), (lambda: of_twin(*half), 2),
              (lambda: of_twin(*noisy), 2)]
    for make, width in makers:
        try:
            cells += make()
        except Out_of_time:
            lab.is_complete = False
            cells += ["-"] * width
    return cells


def sheets(lab):
    """Pictures of what is found, to be looked at."""
    chosen = [lab.figure, lab.horse(), lab.bodies.get(("child", "kick")), lab.bodies.get(("woman_slim", "walk"))]
    for s in filter(None, chosen):
        lab.commands([lab.options.programs / "detect_features", "mesh.obj", "frames.pc2", "--fps", s.fps, "--rest",
                      "mesh.obj", "--quiet", "-o", "sheet.csv", "--png", "sheet.png"], ["sheet.png"], s.folder)
    return {}


def main():
    options = arguments()
    for key in ("programs", "static", "work", "page", "figures", "data"):
        if getattr(options, key):
            setattr(options, key, getattr(options, key).resolve())
    options.work.mkdir(parents=True, exist_ok=True)
    lab = Lab(options)
    make = dict(zip(PARTS, (rig_table, twins_tables, noise_table, bodies_table, static_table, sheets)))
    incomplete = []
    for part in options.parts.split(","):
        if part not in make:
            sys.exit(f"evaluate.py: there is no part \"{part}\"; choose among {', '.join(PARTS)}")
        try:
            for key, text in make[part](lab).items():
                (options.work / f"{key}.md").write_text(text, encoding="utf-8")
                print(f"\n{key}\n{text}", flush=True)
                if options.page and lab.is_complete:
                    tables.put_into(options.page, key, text)
            if not lab.is_complete:
                raise Out_of_time
        except Out_of_time:
            lab.is_complete = True
            incomplete.append(part)
    seconds = time.monotonic() - lab.commands.started
    print(f"{lab.commands.run} commands in {seconds:.0f} s")
    if incomplete:
        sys.exit(f"out of time: {', '.join(incomplete)} not complete; run it again to go on")


if __name__ == "__main__":
    main()
