// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The page: reads the scene, puts the parts together, and lets time pass.

import { MAPS, durationColor, durationScale, gradient, mapColor, useColors } from "./colors.js";
import { count, seconds, short } from "./format.js";
import { listen } from "./keyboard.js";
import { Painter } from "./painter.js";
import { Player } from "./player.js";
import { Scene } from "./scene.js";
import { Stage } from "./stage.js";
import { State } from "./state.js";
import { Details, Table } from "./table.js";
import { Timeline } from "./timeline.js";

const LONGEST_STEP = 0.25; // s; a page in the background gets no animation frames, and goes on where it was

const $ = (id) => document.getElementById(id);

class Viewer {
  constructor(scene) {
    this.scene = scene;
    useColors(scene.colours);
    const strengths = scene.features.map((f) => f.strength);
    this.weakest = strengths.length > 0 ? Math.min(...strengths) : 0;
    this.strongest = strengths.length > 0 ? Math.max(...strengths) : 0;
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.state = new State({
      time: 0, playing: !isStill, speed: 1, loop: true, threshold: this.weakest, selected: -1,
      field: scene.fields.length > 0 ? 0 : -1, map: MAPS[0], theme: "", hidden: true, wires: false, follow: false, up: "y",
      features: true, painting: false, tool: "paint", brush: 0.04, span: 0.5, strokes: [],
    });
    this.scale = durationScale(scene.features);
    this.setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.drawn = 0;
    this.makeStage();
    this.player = new Player({ play: $("play"), slider: $("time"), speed: $("speed"), clock: $("clock") }, scene, this.state);
    this.timeline = new Timeline($("timeline"), scene, this.state, this.scale, (i) => this.go(i));
    new Table($("rows"), $("note"), scene, this.state, this.scale, (i) => this.go(i));
    new Details($("details"), scene, this.state);
    this.painter = new Painter(scene, this.state, this.stage);
    this.describe();
    this.connect();
    listen(this, $("shortcuts"));
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  makeStage() {
    try {
      this.stage = new Stage($("canvas"), this.scene, this.state, this.scale);
    } catch (error) {
      this.stage = null;
      $("message").textContent = `This browser cannot draw in three dimensions (WebGL 2): ${error.message}. The features are in the table and on the timeline.`;
      $("message").hidden = false;
    }
  }

  /** All that is said about the scene once. */
  describe() {
    const { scene } = this;
    document.title = scene.title ? `${scene.title} – features` : "Features of an animated mesh";
    $("title").textContent = scene.title || "Animated mesh";
    const kept = scene.kept_frames.length;
    const thinned = kept < scene.frames ? ` Of ${scene.frames} frames, every ${scene.kept_frames[1]}th is here (${kept}); between them, it is linear.` : "";
    $("precision").textContent = `Positions are rounded by at most ${short(scene.largest_error, 2)} of the bounding-box diagonal.${thinned}`;
    $("thinned").hidden = thinned === "";
    $("thinned").textContent = `1 of ${scene.kept_frames[1]} frames`;
    $("thinned").title = thinned.trim();
    for (const [i, field] of scene.fields.entries()) $("field").append(new Option(field.name[0].toUpperCase() + field.name.slice(1), `${i}`));
    $("field").append(new Option("None", "-1"));
    for (const map of MAPS) $("map").append(new Option(map[0].toUpperCase() + map.slice(1), map));
    $("duration-ramp").style.background = gradient(durationColor);
    const { min, max } = this.scale;
    $("duration-legend").hidden = !(max > 0);
    $("shortest").textContent = `${short(min, 2)} s`;
    $("longest").textContent = `${short(max, 2)} s`;
  }

  connect() {
    const { state } = this;
    $("threshold").min = `${this.weakest}`;
    $("threshold").max = `${this.strongest}`;
    $("threshold").disabled = !(this.strongest > this.weakest);
    $("threshold").addEventListener("input", () => state.set({ threshold: this.thresholdOf($("threshold")) }));
    $("field").addEventListener("change", () => state.set({ field: Number($("field").value) }));
    $("map").addEventListener("change", () => state.set({ map: $("map").value }));
    for (const name of ["hidden", "wires", "follow", "loop", "features"])
      $(name).addEventListener("change", () => state.set({ [name]: $(name).checked }));
    $("theme").addEventListener("click", () => this.toggleTheme());
    $("help").addEventListener("click", () => this.toggleHelp());
    $("reset").addEventListener("click", () => this.stage?.resetView());
    $("save").addEventListener("click", () => this.savePicture());
    $("close-details").addEventListener("click", () => state.set({ selected: -1 }));
    $("approach").addEventListener("click", () => this.approach());
    $("help-dialog").addEventListener("click", (event) => {
      if (event.target === $("help-dialog")) $("help-dialog").close();
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) => this.setTheme(event.matches ? "dark" : "light"));
    state.subscribe((changed) => this.show(changed));
    this.show(state.values);
  }

  /** The end of a slider is not always exactly its maximum. */
  thresholdOf(slider) {
    const value = Number(slider.value), tolerance = 1e-9 * this.strongest;
    return value >= this.strongest - tolerance ? this.strongest : value <= this.weakest + tolerance ? this.weakest : value;
  }

  show(changed) {
    const { scene } = this, s = this.state.values;
    if ("features" in changed) {
      const facts = [count(scene.vertices, "vertex", "vertices"), count(scene.frames, "frame"), seconds(scene.duration)];
      if (s.features) facts.push(count(scene.features.length, "feature"));
      $("facts").textContent = facts.join(" · ");
      for (const id of ["features-card", "features-table"]) $(id).hidden = !s.features;
    }
    if ("threshold" in changed) {
      const n = scene.features.filter((f) => f.strength >= s.threshold).length;
      $("threshold").value = `${s.threshold}`;
      $("threshold-value").textContent = short(s.threshold);
      $("count").textContent = `${n} of ${scene.features.length}`;
      $("threshold").setAttribute("aria-valuetext", `${short(s.threshold)}: ${n} of ${scene.features.length} features shown`);
      if (s.selected >= 0 && scene.features[s.selected].strength < s.threshold) this.state.set({ selected: -1 });
    }
    if ("field" in changed || "map" in changed) this.showLegend();
    for (const name of ["hidden", "wires", "follow", "loop", "features"]) if (name in changed) $(name).checked = s[name];
    if ("selected" in changed) {
      const f = scene.features[s.selected];
      $("announcement").textContent = f ? `Feature ${s.selected + 1} selected: strength ${short(f.strength)}, at ${f.time.toFixed(2)} seconds, vertex ${f.vertex}` : "";
    }
  }

  showLegend() {
    const { field: i, map } = this.state.values, field = this.scene.fields[i];
    $("field").value = `${i}`;
    $("map").value = map;
    $("legend").hidden = field === undefined;
    $("no-fields").hidden = this.scene.fields.length > 0;
    if (field === undefined) return;
    $("ramp").style.background = gradient((t) => mapColor(map, t));
    const isCut = field.largest > field.max;
    // a rounding error above zero is zero to the reader
    $("least").textContent = Math.abs(field.min) < 1e-3 * (field.max - field.min) ? "0" : short(field.min, 2);
    $("middle").textContent = short((field.min + field.max) / 2, 2);
    $("most").textContent = (isCut ? "≥ " : "") + short(field.max, 2);
    $("legend").title = isCut ? `Half a percent of the values are larger, up to ${short(field.largest)}` : "";
  }

  /** Selects a feature and goes to its time. */
  go(i) {
    const f = this.scene.features[i];
    if (f === undefined || !this.state.values.features) return;
    this.state.set({ time: Math.min(Math.max(f.time, 0), this.scene.duration), playing: false, selected: i });
  }

  next(by) {
    const shown = this.scene.features.map((_, i) => i).filter((i) => this.scene.features[i].strength >= this.state.values.threshold);
    if (shown.length === 0) return;
    const at = shown.indexOf(this.state.values.selected);
    this.go(shown[at < 0 ? 0 : Math.min(Math.max(at + by, 0), shown.length - 1)]);
  }

  approach() {
    const f = this.scene.features[this.state.values.selected];
    if (f === undefined) return;
    this.go(this.state.values.selected);
    this.stage?.approach(f);
  }

  nextField() {
    const n = this.scene.fields.length, i = this.state.values.field;
    this.state.set({ field: i + 1 < n ? i + 1 : -1 });
  }

  nextMap() {
    this.state.set({ map: MAPS[(MAPS.indexOf(this.state.values.map) + 1) % MAPS.length] });
  }

  setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    this.state.set({ theme });
  }

  toggleTheme() {
    this.setTheme(this.state.values.theme === "dark" ? "light" : "dark");
  }

  toggleHelp() {
    if ($("help-dialog").open) $("help-dialog").close();
    else $("help-dialog").showModal();
  }

  async savePicture() {
    if (!this.stage) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await this.stage.picture());
    link.download = `${(this.scene.title || "features").replace(/[^\w.-]+/g, "_")}_${this.state.values.time.toFixed(3)}s.png`;
    link.click();
    URL.revokeObjectURL(link.href);
  }

  tick(now) {
    const elapsed = Math.min((now - this.last) / 1000, LONGEST_STEP);
    this.last = now;
    this.player.advance(elapsed);
    this.painter.update();
    if (this.stage?.draw(elapsed, this.state.values.playing)) ++this.drawn;
    requestAnimationFrame((next) => this.tick(next));
  }
}

/**
 * For scripts and tests: `await animatedMeshFeatures.ready` gives an object with `scene`, `state`, `stage`, `player`.
 */
window.animatedMeshFeatures = {
  ready: (async () => {
    try {
      // lets the browser show the page before it is busy
      await new Promise((resolve) => setTimeout(resolve));
      const viewer = new Viewer(await Scene.read(document));
      document.documentElement.dataset.ready = "true";
      viewer.secondsToReady = performance.now() / 1000;
      $("loading").hidden = true;
      return viewer;
    } catch (error) {
      $("loading").hidden = true;
      $("message").textContent = error.message;
      $("message").hidden = false;
      throw error;
    }
  })(),
};
