// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mode in which somebody paints: its controls, and its files.

import { Brush } from "./brush.js";
import { count, short } from "./format.js";
import { Painting } from "./painting.js";
import { fileName, save } from "./saving.js";

const TOOLS = ["paint", "erase", "turn"];
const LEAST_BRUSH = 0.005, MOST_BRUSH = 0.25; // of the bounding-box diagonal

const PAINTING_LABEL = "The surface, to be painted on. Drag over it to paint or erase, beside it to turn; keys 1, 2, 3 choose between paint, erase and turn, comma and full stop change the brush, z and y undo and redo.";

const $ = (id) => document.getElementById(id);

/** The slider's place, from 0 to 1, is the logarithm of the brush. */
const brushAt = (x) => LEAST_BRUSH * (MOST_BRUSH / LEAST_BRUSH) ** x;
const placeOf = (brush) => Math.log(brush / LEAST_BRUSH) / Math.log(MOST_BRUSH / LEAST_BRUSH);

export class Painter {
  /** Without a stage there is nothing to paint on. */
  constructor(scene, state, stage) {
    Object.assign(this, { scene, state, stage, hiddenField: null, label: $("canvas").getAttribute("aria-label") });
    this.painting = new Painting(scene, state);
    this.brush = stage ? new Brush(scene, state, stage, this.painting) : null;
    // strokes are lists of the file's vertices, and not all of them are here
    $("paint").hidden = !stage || scene.isThinned;
    state.set({ span: Math.min(state.values.span, scene.duration) });
    this.connect();
    state.subscribe((changed) => this.show(changed));
    this.show(state.values);
  }

  connect() {
    const { state, painting } = this;
    for (const id of ["paint", "close-painting"]) $(id).addEventListener("click", () => this.toggle());
    for (const radio of document.getElementsByName("tool")) radio.addEventListener("change", () => state.set({ tool: radio.value }));
    $("brush").addEventListener("input", () => state.set({ brush: brushAt(Number($("brush").value)) }));
    $("span").max = `${this.scene.duration}`;
    $("span").addEventListener("change", () => this.setSpan(Number($("span").value)));
    $("undo").addEventListener("click", () => this.back(-1));
    $("redo").addEventListener("click", () => this.back(1));
    $("save-painting").addEventListener("click", () => this.save());
    $("load-painting").addEventListener("click", () => $("painting-file").click());
    $("painting-file").addEventListener("change", () => this.load());
    window.addEventListener("beforeunload", (event) => {
      if (!painting.isSaved) event.preventDefault();
    });
  }

  setSpan(span) {
    this.state.set({ span: Math.min(Math.max(Number.isFinite(span) ? span : 0, 0), this.scene.duration) });
    $("span").value = `${+this.state.values.span.toFixed(3)}`;
  }

  /** Painters are not to see what was found, unless they ask. */
  toggle() {
    if ($("paint").hidden) return;
    const { painting, field } = this.state.values;
    if (!painting) {
      this.hiddenField = field;
      this.state.set({ painting: true, features: false, selected: -1, field: -1, probe: -1, measuring: false });
    } else {
      this.state.set({ painting: false, features: true, field: field < 0 ? this.hiddenField : field });
    }
  }

  choose(i) {
    if (this.state.values.painting) this.state.set({ tool: TOOLS[i] });
  }

  resize(by) {
    if (this.state.values.painting) this.state.set({ brush: brushAt(Math.min(Math.max(placeOf(this.state.values.brush) + by / 20, 0), 1)) });
  }

  /** Undoes (-1) or does again what was undone (1). Whether that was the thing to do now. */
  back(by) {
    if (!this.state.values.painting || this.brush.stroke) return false;
    if (by < 0) this.painting.undo();
    else this.painting.redo();
    return true;
  }

  /** Says something about files; a whole sentence. */
  say(text, isWrong = false) {
    $("painting-status").textContent = text;
    $("painting-status").toggleAttribute("data-wrong", isWrong);
  }

  save() {
    const painter = $("painter").value.trim();
    if (painter === "") {
      this.say("Who paints? A name or any word that tells painters apart is needed in the file.", true);
      return $("painter").focus();
    }
    const name = fileName(this.scene, ["painting", painter], "json");
    save(name, this.painting.text(painter), "application/json");
    this.painting.saved = this.painting.strokes;
    this.say(`Saved as ${name}.`);
  }

  async load() {
    const [file] = $("painting-file").files;
    $("painting-file").value = ""; // the same one can be chosen again
    if (file === undefined) return;
    try {
      $("painter").value = this.painting.load(await file.text());
      this.say(`Loaded ${file.name}: ${count(this.painting.strokes.length, "stroke")}.`);
    } catch (error) {
      this.say(`${file.name}: ${error.message}`, true);
    }
  }

  show(changed) {
    const s = this.state.values;
    if ("painting" in changed) {
      $("painting").hidden = !s.painting;
      $("paint").setAttribute("aria-pressed", `${s.painting}`);
      $("painting").parentElement.scrollTop = 0;
      $("canvas").setAttribute("aria-label", s.painting ? PAINTING_LABEL : this.label);
    }
    if ("painting" in changed || "tool" in changed) {
      $("canvas").dataset.tool = s.painting ? s.tool : "turn";
      for (const radio of document.getElementsByName("tool")) radio.checked = radio.value === s.tool;
    }
    if ("brush" in changed) {
      const text = `${short(100 * s.brush, 2)} % of the diagonal, ${short(s.brush * this.scene.bounding_box_diagonal)}`;
      $("brush").value = `${placeOf(s.brush)}`;
      $("brush").setAttribute("aria-valuetext", text);
      $("brush-value").textContent = text;
    }
    if ("span" in changed) $("span").value = `${+s.span.toFixed(3)}`;
    if ("strokes" in changed) {
      $("undo").disabled = this.painting.done.length === 0;
      $("redo").disabled = this.painting.undone.length === 0;
      $("save-painting").disabled = s.strokes.length === 0;
      this.say(s.strokes.length === 0 ? "Nothing is painted yet." : `${count(s.strokes.length, "stroke")}.`);
    }
  }

  /** To be called in every animation frame. */
  update() {
    this.brush?.update();
  }
}
