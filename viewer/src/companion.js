// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The second of two animations, beside the first one: it is shown at the time that is aligned with that of the first,
// looked at from the same side, and of features that are pairs, one is selected and shown with the other.

import { Bearing } from "./bearing.js";
import { isWithin } from "./filters.js";
import { count, seconds, short } from "./format.js";
import { Hover } from "./hover.js";
import { Overlay } from "./overlay.js";
import { Stage } from "./stage.js";
import { State } from "./state.js";
import { Details } from "./table.js";
import { Timeline } from "./timeline.js";

const UNMATCHED = [0.55, 0.55, 0.55]; // grey; pairs have hues
const GOLDEN = (3 - Math.sqrt(5)) / 2; // of the circle: hues that follow each other are far apart, however many there are

/** Members of the state that hold for both. */
const SHARED = ["playing", "map", "theme", "hidden", "wires", "follow", "labels", "trail", "opacity", "features"];

const $ = (id) => document.getElementById(id);

/** The colour of a pair: hues around the circle, in two lightnesses. */
export function pairColor(number) {
  const h = 6 * (((number - 1) * GOLDEN) % 1), top = number % 2 ? 0.92 : 0.72, saturation = 0.82;
  return [5, 3, 1].map((n) => {
    const k = (n + h) % 6;
    return top * (1 - saturation * Math.max(0, Math.min(k, 4 - k, 1)));
  });
}

/** What the page knows of two animations, if it has two. */
export function readComparison(document) {
  const element = document.getElementById("comparison");
  return element === null ? null : JSON.parse(element.textContent);
}

/** Gives features of both scenes the numbers and colours of their pairs. */
export function joinPairs({ matches }, a, b) {
  for (const scene of [a, b]) for (const f of scene.features) Object.assign(f, { pair: null, partner: -1, label: "×", color: UNMATCHED });
  matches.forEach((match, i) => {
    for (const [scene, own, other] of [[a, match.a, match.b], [b, match.b, match.a]])
      Object.assign(scene.features[own], { pair: i + 1, partner: other, label: `${i + 1}`, color: pairColor(i + 1) });
  });
}

/** A map of time, linear between its samples; outside of them the clocks run alike. */
export function mapTime(from, to, time) {
  const n = from.length;
  if (n === 0) return time;
  if (time <= from[0]) return to[0] + time - from[0];
  if (time >= from[n - 1]) return to[n - 1] + time - from[n - 1];
  let i = 1;
  while (from[i] < time) ++i;
  const length = from[i] - from[i - 1];
  return to[i - 1] + (length > 0 ? (time - from[i - 1]) / length : 0) * (to[i] - to[i - 1]);
}

/** A time of a loop, from `first` to before a period later; of what ends, the time itself. */
function within(time, first, period) {
  return period > 0 ? time - Math.floor((time - first) / period) * period : time;
}

/** A map of time of loops, whose periods are 0 for what ends. */
export function mapLoop(from, to, time, periodFrom, periodTo) {
  return within(mapTime(from, to, within(time, from[0], periodFrom)), 0, periodTo);
}

/** A view to within what rounding changes of it from picture to picture. */
function viewText(stage) {
  const { direction, moved, distance } = stage.relativeView();
  return [stage.touched, ...[...direction, ...moved, distance].map((x) => x.toFixed(5))].join();
}

export class Companion {
  /** `viewer` shows the first one, `scene` is the second one. */
  constructor(viewer, scene, comparison) {
    Object.assign(this, { viewer, scene, comparison });
    const { values } = viewer.state;
    this.up = values.up;
    this.views = ["", ""];
    this.state = new State({ ...values, ...this.own(), selected: -1, probe: -1, strokes: [], painting: false, measuring: false });
    for (const element of document.querySelectorAll("[data-pair]")) element.hidden = false;
    for (const element of document.querySelectorAll("[data-single]")) element.hidden = true;
    if (viewer.stage) this.makeStage();
    const axis = { duration: viewer.scene.duration, state: viewer.state, of: (time) => this.toFirst(time), name: "B" };
    viewer.timeline.axis.name = "A";
    this.timeline = new Timeline($("timeline-b"), scene, this.state, (i) => this.go(i), axis);
    new Details($("details-b"), scene, this.state, (i) => this.go(i), "B");
    $("close-details-b").addEventListener("click", () => this.select(-1));
    viewer.state.subscribe((changed) => this.follow(changed));
    this.describe();
    this.tell();
  }

  makeStage() {
    this.stage = new Stage($("canvas-b"), this.scene, this.state);
    const places = (scene, side) => this.comparison.matches.map((match) => scene.features[match[side]].rest_position);
    this.bearing = new Bearing(places(this.viewer.scene, "a"), places(this.scene, "b"));
    this.state.set({ up: this.bearing.upOfSecond(this.viewer.state.values.up, this.state.values.up) });
    this.hover = new Hover($("tip-b"), this.scene, this.state, this.stage);
    const overlay = new Overlay($("overlay-b"), this);
    this.stage.onDrawn = () => overlay.draw();
    this.stage.onClick = (x, y) => this.select(this.stage.featureAt(x, y));
  }

  toSecond(time) {
    const { times_a: a, times_b: b, loops } = this.comparison.alignment;
    return mapLoop(a, b, time, loops[0], loops[1]);
  }

  toFirst(time) {
    const { times_a: a, times_b: b, loops } = this.comparison.alignment;
    return mapLoop(b, a, time, loops[1], loops[0]);
  }

  /** What of the second one's state follows from the first one's. */
  own() {
    const { values, values: { shown } } = this.viewer.state, name = this.viewer.scene.fields[values.field]?.name;
    return {
      time: Math.min(Math.max(this.toSecond(values.time), 0), this.scene.duration),
      field: this.scene.fields.findIndex((field) => field.name === name),
      shown: this.scene.features.map((f) => (f.partner >= 0 ? shown[f.partner] : isWithin(f, values))),
    };
  }

  follow(changed) {
    const { values } = this.viewer.state, now = {};
    for (const name of SHARED) if (name in changed) now[name] = values[name];
    const { time, field, shown } = this.own();
    if ("time" in changed) now.time = time;
    if ("field" in changed) now.field = field;
    if ("threshold" in changed || "shown" in changed) Object.assign(now, { threshold: values.threshold, shown });
    if ("selected" in changed) now.selected = this.viewer.scene.features[values.selected]?.partner ?? -1;
    else if ("shown" in now && !shown[this.state.values.selected]) now.selected = -1;
    if (this.up !== values.up) now.up = this.state.values.up === "y" ? "z" : "y";
    this.up = values.up;
    this.views = ["", ""];
    this.state.set(now);
    if ("time" in changed) this.tell();
  }

  /** Selects a feature of the second one, and with it its partner. */
  select(i) {
    this.viewer.state.set({ selected: this.scene.features[i]?.partner ?? -1 });
    this.state.set({ selected: i });
  }

  /** The same at its time. */
  go(i) {
    const { state, scene } = this.viewer, f = this.scene.features[i];
    if (f === undefined || !state.values.features) return;
    if (f.partner >= 0) return this.viewer.go(f.partner);
    state.set({ time: Math.min(Math.max(this.toFirst(f.time), 0), scene.duration), playing: false });
    this.select(i);
  }

  /** One line on both. */
  facts() {
    const fact = (name, scene) => `${name}: ${count(scene.all_vertices, "vertex", "vertices")}, ${count(scene.frames, "frame")}`;
    return [fact("A", this.viewer.scene), fact("B", this.scene)];
  }

  describe() {
    const { scene, comparison: { matches, distance, alignment } } = this, first = this.viewer.scene;
    $("title").textContent = `${first.title} and ${scene.title}`;
    document.title = `${first.title} and ${scene.title} – features`;
    $("pairs").textContent = `${count(matches.length, "pair")}`;
    $("only-a").textContent = `${first.features.length - matches.length} of ${first.features.length}`;
    $("only-b").textContent = `${scene.features.length - matches.length} of ${scene.features.length}`;
    $("distance").textContent = distance.toFixed(3);
    $("confidence").textContent = alignment.confidence.toFixed(2);
    const { min, max } = scene.fields[0] ?? { min: 0, max: 0 };
    $("range-b").textContent = scene.fields.length > 0 ? `Of B, the same colours are from ${short(min, 2)} to ${short(max, 2)}.` : "";
    const missed = [];
    const isLoop = alignment.loops[1] > 0;
    if (!isLoop && this.toSecond(0) > 0.05) missed.push(`before ${seconds(this.toSecond(0))}`);
    if (!isLoop && this.toSecond(first.duration) < scene.duration - 0.05) missed.push(`after ${seconds(this.toSecond(first.duration))}`);
    $("missed").textContent = missed.length > 0 ? `What B does ${missed.join(" and ")} is outside of A's time.` : "";
  }

  /** What is shown of either, and when in its own time. */
  names() {
    const text = (name, scene, { time }) => `${name} · ${scene.title} · ${seconds(time)} · frame ${scene.frameAt(time)}`;
    return [text("A", this.viewer.scene, this.viewer.state.values), text("B", this.scene, this.state.values)];
  }

  tell() {
    [$("name-a").textContent, $("name-b").textContent] = this.names();
  }

  /** The caption of a picture. */
  lines() {
    const { matches, distance } = this.comparison;
    return [this.names().join("; "), `${count(matches.length, "pair")} of features with one number and one colour; grey: without a partner; distance ${distance.toFixed(3)}`];
  }

  /** To be called in every animation frame. */
  draw(elapsed, isMoving) {
    if (this.stage) {
      this.coupleViews();
      this.stage.draw(elapsed, isMoving);
    }
    this.hover?.update();
  }

  /** Who has been turned last turns the other one; what shows the whole body shows it from where the first one does. */
  coupleViews() {
    const { stage: first } = this.viewer, second = this.stage, stages = [first, second];
    const turner = stages.find((stage, k) => viewText(stage) !== this.views[k]);
    if (turner === undefined) return;
    if (!turner.touched && turner === second) first.resetView();
    const from = turner.touched ? turner : first, to = from === first ? second : first;
    const { direction, moved, distance } = from.relativeView();
    const there = (vector) => this.bearing[to === second ? "toSecond" : "toFirst"](vector, first.state.values.up, second.state.values.up);
    if (to === second) second.told = there(direction);
    if (from.touched) to.setRelativeView({ direction: there(direction), moved: there(moved), distance });
    else to.resetView();
    this.views = stages.map(viewText); // nothing is to be done until somebody turns one again
  }
}
