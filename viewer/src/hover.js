// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is under the pointer: a feature's numbers, or a vertex and its value.

import { pairText, short } from "./format.js";

const OFFSET = 14; // pixels from the pointer

export class Hover {
  constructor(tip, scene, state, stage) {
    Object.assign(this, { tip, scene, state, stage, pointer: null, isStale: false });
    const { canvas } = stage;
    canvas.addEventListener("pointermove", (event) => {
      this.pointer = event.pointerType === "mouse" && event.buttons === 0 ? { x: event.offsetX, y: event.offsetY } : null;
      this.isStale = true;
    });
    for (const type of ["pointerleave", "pointerdown", "wheel"])
      canvas.addEventListener(type, () => {
        this.pointer = null;
        this.isStale = true;
      }, { passive: true });
    state.subscribe(() => (this.isStale = true));
  }

  /** To be called in every animation frame. */
  update() {
    if (!this.isStale) return;
    this.isStale = false;
    const { playing, painting } = this.state.values;
    const text = this.pointer && !playing && !painting ? this.text(this.pointer) : "";
    this.tip.hidden = text === "";
    if (text === "") return;
    this.tip.textContent = text;
    const { x, y } = this.pointer, { clientWidth: width, clientHeight: height } = this.stage.canvas;
    const left = x + OFFSET + this.tip.offsetWidth > width ? x - OFFSET - this.tip.offsetWidth : x + OFFSET;
    const top = Math.min(y + OFFSET, height - this.tip.offsetHeight - 4);
    this.tip.style.transform = `translate(${Math.max(left, 4)}px, ${Math.max(top, 4)}px)`;
  }

  text({ x, y }) {
    const i = this.stage.featureAt(x, y);
    if (i >= 0) return this.describe(this.scene.features[i]);
    const hit = this.stage.surfaceAt(x, y);
    if (!hit) return "";
    const v = nearestCorner(hit), field = this.scene.fields[this.state.values.field];
    const value = field ? `\n${field.name} ${short(this.scene.valueAt(field, v, this.state.values.time))}` : "";
    return `vertex ${this.scene.vertexName(v)}${value}`;
  }

  describe(f) {
    const lines = [`${pairText(f)}#${f.rank} · ${f.time.toFixed(2)} s`, `σ ${short(f.sigma)} · τ ${short(f.tau)} s`];
    lines.push([["strength", f.strength], ["amplitude", f.amplitude], ["fit", f.fit]]
      .filter(([, x]) => x !== undefined).map(([name, x]) => `${name} ${short(x, 2)}`).join(" · "));
    if (f.place !== undefined) lines.push(`place ${f.place}${f.parent ? ` · part of #${f.parent}` : ""}`);
    if (f.at_scale_limit) lines.push("at a limit of the scales");
    return lines.join("\n");
  }
}

/** The vertex of a triangle that is nearest to a point in it, as Surface.hit() gives it. */
export function nearestCorner({ triangle, barycentric }) {
  return triangle[barycentric.indexOf(Math.max(...barycentric))];
}
