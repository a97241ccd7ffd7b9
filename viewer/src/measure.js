// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The distance between two vertices: straight, at the time that is shown, and along the edges of the rest shape.

import { short } from "./format.js";
import { EdgeGraph } from "./geodesic.js";
import { nearestCorner } from "./hover.js";

export class Measure {
  constructor(elements, scene, state) {
    Object.assign(this, { ...elements, scene, state });
    const { inputs, button, close } = elements;
    button.addEventListener("click", () => this.toggle());
    close.addEventListener("click", () => this.toggle());
    inputs.forEach((input, i) => {
      input.max = `${scene.all_vertices - 1}`;
      input.addEventListener("change", () => {
        const v = input.value === "" ? -1 : scene.vertexOf(Number(input.value));
        state.set({ [i === 0 ? "measureFrom" : "measureTo"]: v });
      });
    });
    state.subscribe((changed) => {
      if (["measuring", "measureFrom", "measureTo", "time"].some((name) => name in changed)) this.show();
      if (changed.measureFrom >= 0 || changed.measureTo >= 0) state.set({ measuring: true });
    });
    this.show();
  }

  toggle() {
    const measuring = !this.state.values.measuring;
    this.state.set(measuring ? { measuring } : { measuring, measureFrom: -1, measureTo: -1 });
  }

  /** A click on the surface; the third one begins anew. */
  take(hit) {
    const { measureFrom, measureTo } = this.state.values, v = nearestCorner(hit);
    if (measureFrom < 0 || measureTo >= 0) this.state.set({ measureFrom: v, measureTo: -1 });
    else this.state.set({ measureTo: v });
  }

  /** Where the ends are at a time: none, one, or two. */
  ends(time) {
    const { measureFrom, measureTo } = this.state.values;
    return [measureFrom, measureTo].filter((v) => v >= 0)
      .map((v) => this.scene.vertexPlace(v, time));
  }

  straight(time) {
    const [a, b] = this.ends(time);
    return b === undefined ? NaN : Math.hypot(...a.map((x, c) => x - b[c]));
  }

  /** The length of the shortest path of edges, Infinity if there is none. */
  alongEdges() {
    const { measureFrom: from, measureTo: to } = this.state.values;
    if (this.path?.from !== from || this.path?.to !== to) {
      this.graph ??= new EdgeGraph(this.scene.faces, this.scene.rest);
      this.path = { from, to, length: this.graph.distance(from, to) };
    }
    return this.path.length;
  }

  show() {
    const { measuring, measureFrom, measureTo, time } = this.state.values;
    this.section.hidden = !measuring;
    this.button.setAttribute("aria-pressed", `${measuring}`);
    if (!measuring) return;
    [measureFrom, measureTo].forEach((v, i) => (this.inputs[i].value = v >= 0 ? `${this.scene.vertexName(v)}` : ""));
    if (measureFrom < 0 || measureTo < 0) {
      this.result.textContent = `Click the ${measureFrom < 0 ? "first" : "second"} point on the surface, or type the numbers of two vertices.`;
      return;
    }
    const straight = this.straight(time), along = this.alongEdges(), diagonal = this.scene.bounding_box_diagonal;
    const share = (x) => `${short((100 * x) / diagonal, 2)} % of the diagonal`;
    this.result.textContent = `${short(straight, 4)} straight now (${share(straight)}); ` +
      (Number.isFinite(along) ? `${short(along, 4)} along the edges of the rest shape (${share(along)}).` : "no way along edges: they are in different components.");
  }
}
