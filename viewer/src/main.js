// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The page: reads the scene, puts the parts together, and lets time pass.

import { Address } from "./address.js";
import { MAPS, durationColor, durationScale, gradient, mapColor, useColors } from "./colors.js";
import { Companion, joinPairs, readComparison } from "./companion.js";
import { Curve } from "./curve.js";
import { Filter, FilterForm, NO_BOUNDS } from "./filters.js";
import { count, seconds, short } from "./format.js";
import { Hover, nearestCorner } from "./hover.js";
import { listen } from "./keyboard.js";
import { Measure } from "./measure.js";
import { Overlay } from "./overlay.js";
import { Painter } from "./painter.js";
import { caption, composed } from "./picture.js";
import { Player } from "./player.js";
import { csvText, fileName, jsonText, save } from "./saving.js";
import { Scene } from "./scene.js";
import { Stage } from "./stage.js";
import { State } from "./state.js";
import { Details, Table } from "./table.js";
import { Timeline } from "./timeline.js";

const CLEAR_SURFACES = [1, 0.6, 0.3];

const LONGEST_STEP = 0.25; // s; a page in the background gets no animation frames, and goes on where it was

/** Members of the state that a check box of the same name shows. */
const TOGGLES = ["hidden", "wires", "follow", "loop", "features", "labels", "trail", "unmatched"];

const $ = (id) => document.getElementById(id);

class Viewer {
  /** `pair`, if there are two animations: the second scene, and how they are compared. */
  constructor(scene, pair = null) {
    this.scene = scene;
    useColors(scene.colours);
    this.scale = durationScale(scene.features);
    if (pair) joinPairs(pair.comparison, scene, pair.scene);
    else for (const f of scene.features) f.color = durationColor(this.scale(f.tau));
    const strengths = scene.features.map((f) => f.strength);
    this.weakest = strengths.length > 0 ? Math.min(...strengths) : 0;
    this.strongest = strengths.length > 0 ? Math.max(...strengths) : 0;
    const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.state = new State({
      time: 0, playing: !isStill, speed: 1, loop: true, threshold: this.weakest, selected: -1,
      field: scene.fields.length > 0 ? 0 : -1, map: MAPS[0], theme: "", hidden: true, wires: false, follow: true, up: "y",
      shown: [], bounds: NO_BOUNDS, limits: "all", sort: "rank", grouped: !pair && this.hasPlaces(), probe: -1, labels: true, trail: true,
      opacity: 1, measuring: false, measureFrom: -1, measureTo: -1,
      features: true, unmatched: true, painting: false, tool: "paint", brush: 0.04, span: 0.5, strokes: [],
    });
    this.setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    this.drawn = 0;
    this.filter = new Filter(scene, this.state);
    this.makeStage();
    this.measure = new Measure({
      section: $("measuring"), inputs: [$("measure-from"), $("measure-to")], result: $("measured"), button: $("measure"), close: $("close-measuring"),
    }, scene, this.state);
    this.player = new Player({ play: $("play"), slider: $("time"), speed: $("speed"), clock: $("clock") }, scene, this.state);
    this.timeline = new Timeline($("timeline"), scene, this.state, (i) => this.go(i));
    this.curve = new Curve({
      section: $("probe"), canvas: $("curve"), input: $("probe-vertex"), text: $("probe-text"), links: $("probe-links"), linksLabel: $("probe-near"),
      close: $("close-probe"),
    }, scene, this.state, (i) => this.go(i));
    new FilterForm({ rows: $("bounds"), limits: $("limits"), clear: $("clear-filters"), summary: $("filters-active") }, scene, this.state);
    this.table = new Table({ head: $("heads"), body: $("rows"), note: $("note"), grouped: $("grouped") }, scene, this.state, (i) => this.go(i));
    new Details($("details"), scene, this.state, (i) => this.go(i), pair ? "A" : "");
    this.painter = new Painter(scene, this.state, this.stage);
    this.describe();
    this.companion = pair ? new Companion(this, pair.scene, pair.comparison) : null;
    this.connect();
    listen(this, $("shortcuts"));
    if (this.stage) this.addPointer();
    this.address = new Address(this);
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  makeStage() {
    try {
      this.stage = new Stage($("canvas"), this.scene, this.state);
    } catch (error) {
      this.stage = null;
      $("message").textContent = `This browser cannot draw in three dimensions (WebGL 2): ${error.message}. The features are in the table and on the timeline.`;
      $("message").hidden = false;
    }
  }

  /** Whether some features are at the same place. */
  hasPlaces() {
    const places = this.scene.features.map((f) => f.place).filter((place) => place !== undefined);
    return new Set(places).size < places.length;
  }

  /** What the pointer does on the stage, besides turning and painting. */
  addPointer() {
    const { stage, state } = this;
    this.hover = new Hover($("tip"), this.scene, state, stage);
    this.overlay = new Overlay($("overlay"), this);
    stage.onDrawn = () => this.overlay.draw();
    stage.onClick = (x, y, isShifted) => this.click(x, y, isShifted);
  }

  /** A sphere is selected; the surface, or with the shift key what is within a sphere, shows its curve. */
  click(x, y, isShifted) {
    const { stage, state } = this, { painting, measuring } = state.values;
    if (painting) return;
    const hit = stage.surfaceAt(x, y);
    if (measuring) {
      if (hit) this.measure.take(hit);
      return;
    }
    const i = isShifted ? -1 : stage.featureAt(x, y);
    if (i >= 0) return state.set({ selected: i });
    this.selectNone();
    state.set({ probe: hit ? nearestCorner(hit) : -1 });
  }

  selectNone() {
    this.state.set({ selected: -1 });
    this.companion?.select(-1);
  }

  /** All that is said about the scene once. */
  describe() {
    const { scene } = this;
    document.title = scene.title ? `${scene.title} – features` : "Features of an animated mesh";
    $("title").textContent = scene.title || "Animated mesh";
    const thinned = this.thinning();
    $("precision").textContent = [`Positions are rounded by at most ${short(scene.largest_error, 2)} of the bounding-box diagonal.`, ...thinned.map(({ sentence }) => sentence)].join(" ");
    $("thinned").hidden = thinned.length === 0;
    $("thinned").textContent = thinned.map(({ badge }) => badge).join(", ");
    $("thinned").title = thinned.map(({ sentence }) => sentence).join(" ");
    for (const [i, field] of scene.fields.entries()) $("field").append(new Option(field.name[0].toUpperCase() + field.name.slice(1), `${i}`));
    $("field").append(new Option("None", "-1"));
    for (const map of MAPS) $("map").append(new Option(map[0].toUpperCase() + map.slice(1), map));
    $("duration-ramp").style.background = gradient(durationColor);
    const { min, max } = this.scale;
    if (!(max > 0)) $("duration-legend").hidden = true;
    $("shortest").textContent = `${short(min, 2)} s`;
    $("longest").textContent = `${short(max, 2)} s`;
  }

  /** What of the animation is not here: in a badge, and in a sentence. */
  thinning() {
    const { scene } = this, kept = scene.kept_frames.length, result = [];
    const number = (n) => n.toLocaleString("en");
    if (scene.isThinned)
      result.push({
        badge: `${number(scene.vertices)} of ${number(scene.all_vertices)} vertices`,
        sentence: `Of ${number(scene.all_vertices)} vertices, ${number(scene.vertices)} are here, fewer where the surface is flat; features are those of all of them. Painting needs all of them.`,
      });
    if (kept < scene.frames)
      result.push({
        badge: `1 of ${scene.kept_frames[1]} frames`,
        sentence: `Of ${scene.frames} frames, every ${scene.kept_frames[1]}th is here (${kept}); between them, it is linear.`,
      });
    return result;
  }

  connect() {
    const { state } = this;
    $("threshold").min = `${this.weakest}`;
    $("threshold").max = `${this.strongest}`;
    $("threshold").disabled = !(this.strongest > this.weakest);
    $("threshold").addEventListener("input", () => state.set({ threshold: this.thresholdOf($("threshold")) }));
    $("field").addEventListener("change", () => state.set({ field: Number($("field").value) }));
    $("map").addEventListener("change", () => state.set({ map: $("map").value }));
    for (const name of TOGGLES)
      $(name).addEventListener("change", () => state.set({ [name]: $(name).checked }));
    $("theme").addEventListener("click", () => this.toggleTheme());
    $("help").addEventListener("click", () => this.toggleHelp());
    $("reset").addEventListener("click", () => this.stage?.resetView());
    $("save").addEventListener("click", () => this.savePicture());
    $("opacity").addEventListener("input", () => state.set({ opacity: Number($("opacity").value) }));
    $("save-csv").addEventListener("click", () => this.saveTable("csv"));
    $("save-json").addEventListener("click", () => this.saveTable("json"));
    $("save-feature").addEventListener("click", () => this.saveSelected());
    $("show-curve").addEventListener("click", () => this.probeSelected());
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
      const facts = this.companion?.facts() ?? [count(scene.all_vertices, "vertex", "vertices"), count(scene.frames, "frame"), seconds(scene.duration)];
      if (s.features && !this.companion) facts.push(count(scene.features.length, "feature"));
      $("facts").textContent = facts.join(" · ");
      for (const id of ["features-card", "features-table"]) $(id).hidden = !s.features;
    }
    if ("threshold" in changed || "shown" in changed) {
      const n = s.shown.filter(Boolean).length;
      $("threshold").value = `${s.threshold}`;
      $("threshold-value").textContent = short(s.threshold);
      $("count").textContent = `${n} of ${scene.features.length}`;
      $("threshold").setAttribute("aria-valuetext", `${short(s.threshold)}: ${n} of ${scene.features.length} features shown`);
      for (const id of ["save-csv", "save-json"]) $(id).disabled = n === 0;
    }
    if ("opacity" in changed) {
      $("opacity").value = `${s.opacity}`;
      $("opacity").setAttribute("aria-valuetext", `${Math.round(100 * s.opacity)} percent`);
    }
    if ("field" in changed || "map" in changed) this.showLegend();
    for (const name of TOGGLES) if (name in changed) $(name).checked = s[name];
    if ("selected" in changed) {
      const f = scene.features[s.selected];
      $("announcement").textContent = f ? `Feature ${f.rank} selected: strength ${short(f.strength)}, at ${f.time.toFixed(2)} seconds, vertex ${f.vertex}` : "";
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

  /** Goes on in the order of the table. */
  next(by) {
    const { order } = this.table;
    if (order.length === 0) return;
    const at = order.indexOf(this.state.values.selected);
    this.go(order[at < 0 ? 0 : Math.min(Math.max(at + by, 0), order.length - 1)]);
  }

  /** The curve of the selected feature's vertex; if that is there already, or nothing is selected, none. */
  probeSelected() {
    const f = this.scene.features[this.state.values.selected];
    if (this.state.values.painting) return;
    const v = f === undefined ? -1 : this.scene.vertexOfFeature(f);
    this.state.set({ probe: v === this.state.values.probe ? -1 : v });
  }

  nextOpacity() {
    const i = CLEAR_SURFACES.findIndex((x) => x <= this.state.values.opacity);
    this.state.set({ opacity: CLEAR_SURFACES[(i + 1) % CLEAR_SURFACES.length] });
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
    const views = [[$("canvas"), $("overlay")]];
    const text = caption(this.scene, this.state.values);
    this.stage.drawFully();
    if (this.companion) {
      this.companion.stage.drawFully();
      views.push([$("canvas-b"), $("overlay-b")]);
      text.lines = this.companion.lines();
    }
    const picture = await composed(views, text);
    save(fileName(this.scene, [`${this.state.values.time.toFixed(3)}s`], "png"), picture);
  }

  /** What the table lists, in its order. */
  saveTable(ending) {
    this.saveFeatures(this.table.order, ["features"], ending);
  }

  saveSelected() {
    const { selected } = this.state.values;
    if (selected >= 0) this.saveFeatures([selected], ["feature", `${this.scene.features[selected].rank}`], "json");
  }

  saveFeatures(indices, what, ending) {
    const list = indices.map((i) => this.scene.features[i]), name = fileName(this.scene, what, ending);
    if (ending === "csv") save(name, csvText(list), "text/csv");
    else save(name, jsonText(list, this.scene, this.address.text()), "application/json");
  }

  tick(now) {
    const elapsed = Math.min((now - this.last) / 1000, LONGEST_STEP);
    this.last = now;
    this.player.advance(elapsed);
    this.painter.update();
    if (this.stage?.draw(elapsed, this.state.values.playing)) ++this.drawn;
    this.hover?.update();
    this.companion?.draw(elapsed, this.state.values.playing);
    this.address.update(now);
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
      const comparison = readComparison(document), scene = await Scene.read(document);
      const viewer = new Viewer(scene, comparison && { comparison, scene: await Scene.read(document, "scene-b") });
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
