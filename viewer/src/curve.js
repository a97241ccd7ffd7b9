// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The field of one vertex over time, as a curve above the timeline, with the features of its neighbourhood.

import { css } from "./colors.js";
import { short } from "./format.js";
import { MARGIN } from "./timeline.js";

const TOP = 8, BOTTOM = 6; // pixels
const MOST_LINKS = 12; // to features; the nearest ones

export class Curve {
  constructor(elements, scene, state, onPick) {
    Object.assign(this, { ...elements, scene, state, onPick });
    const { canvas, input, close, section } = elements;
    input.max = `${scene.all_vertices - 1}`;
    input.addEventListener("change", () => this.choose(Number(input.value)));
    close.addEventListener("click", () => state.set({ probe: -1 }));
    canvas.addEventListener("pointerdown", (event) => {
      const share = (event.offsetX - MARGIN) / (canvas.clientWidth - 2 * MARGIN);
      state.set({ time: Math.min(Math.max(share, 0), 1) * scene.duration, playing: false });
    });
    new ResizeObserver(() => this.draw()).observe(canvas);
    state.subscribe((changed) => {
      if ("probe" in changed || "field" in changed || "shown" in changed) this.update();
      if (!section.hidden) this.draw();
      if ("time" in changed) this.tell();
    });
    this.update();
  }

  /** By its number in the file. */
  choose(name) {
    const v = this.scene.vertexOf(name);
    if (v >= 0) return this.state.set({ probe: v });
    this.input.value = `${this.scene.vertexName(this.state.values.probe)}`;
    this.text.textContent = `There is no vertex ${name} ${this.scene.isThinned && name < this.scene.all_vertices ? "on this page, which has fewer" : "here"}.`;
  }

  /** The field that is shown, or the first one while none is. */
  get field() {
    return this.scene.fields[Math.max(this.state.values.field, 0)];
  }

  /** Shown features whose sphere, at rest, has the vertex in it: the nearest in its own radius first. */
  neighbours(v) {
    const { scene } = this, { shown } = this.state.values, place = scene.restPoint([v, v, v], [1, 0, 0]);
    return scene.features
      .map((f, i) => ({ i, off: Math.hypot(...scene.restPoint(f.on.triangle, f.on.barycentric_coordinates).map((x, c) => x - place[c])) / f.radius }))
      .filter(({ i, off }) => off <= 1 && shown[i])
      .sort((a, b) => a.off - b.off);
  }

  update() {
    const { probe, painting } = this.state.values;
    this.section.hidden = probe < 0 || painting;
    if (this.section.hidden) return;
    const { scene, field } = this;
    this.input.value = `${scene.vertexName(probe)}`;
    this.values = field === undefined ? [] : scene.kept_frames.map((_, k) => scene.value(field, probe, k));
    this.near = this.neighbours(probe);
    const most = Math.max(...this.values);
    this.top = Math.max(most, field?.max ?? 0); // as high as the colours reach, or higher
    const at = scene.kept_frames[this.values.indexOf(most)] * scene.frame_duration;
    const name = field?.name ?? "";
    this.about = field === undefined
      ? "No field was written with this animation."
      : `${name} at most ${short(most)}, at ${at.toFixed(2)} s`;
    this.canvas.setAttribute("aria-label", `Vertex ${scene.vertexName(probe)} over time: ${this.about}; ${this.near.length} features have it in their sphere`);
    this.links.replaceChildren(...this.near.slice(0, MOST_LINKS).map(({ i }) => this.link(i)));
    this.linksLabel.hidden = this.near.length === 0;
    this.tell();
  }

  link(i) {
    const f = this.scene.features[i], button = document.createElement("button");
    Object.assign(button, { type: "button", className: "chip", textContent: `#${f.rank}` });
    button.style.setProperty("--dot", css(f.color));
    button.setAttribute("aria-label", `#${f.rank}: feature ${f.rank}, at ${f.time.toFixed(2)} seconds: show`);
    button.addEventListener("click", () => this.onPick(i));
    return button;
  }

  tell() {
    if (this.section.hidden) return;
    const { field } = this, { probe, time } = this.state.values;
    this.text.textContent = field === undefined ? this.about : `${short(this.scene.valueAt(field, probe, time))} now; ${this.about}`;
  }

  x(time) {
    return MARGIN + (time / Math.max(this.scene.duration, 1e-12)) * (this.canvas.clientWidth - 2 * MARGIN);
  }

  y(value) {
    const { min } = this.field, height = this.canvas.clientHeight;
    return height - BOTTOM - ((value - min) / (this.top > min ? this.top - min : 1)) * (height - TOP - BOTTOM);
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas, ratio = window.devicePixelRatio;
    if (width === 0 || this.section.hidden) return;
    if (this.canvas.width !== Math.round(width * ratio)) this.canvas.width = Math.round(width * ratio);
    if (this.canvas.height !== Math.round(height * ratio)) this.canvas.height = Math.round(height * ratio);
    const g = this.canvas.getContext("2d"), style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    for (const { i } of this.near) this.drawSpan(g, i, height);
    if (this.values.length > 0) this.drawCurve(g, height, color);
    g.strokeStyle = color("--ink");
    g.lineWidth = 2;
    g.beginPath();
    g.moveTo(this.x(this.state.values.time), 0);
    g.lineTo(this.x(this.state.values.time), height);
    g.stroke();
  }

  /** When a feature lives. */
  drawSpan(g, i, height) {
    const f = this.scene.features[i], rgb = f.color;
    g.fillStyle = css(rgb, i === this.state.values.selected ? 0.4 : 0.18);
    for (const [from, to] of this.scene.spans(f)) g.fillRect(this.x(from), 0, this.x(to) - this.x(from), height);
    g.fillStyle = css(rgb);
    g.fillRect(this.x(f.time) - 1, 0, 2, height);
  }

  drawCurve(g, height, color) {
    const d = this.scene.frame_duration, { field } = this;
    g.beginPath();
    this.values.forEach((value, k) => g.lineTo(this.x(this.scene.kept_frames[k] * d), this.y(value)));
    if (this.scene.cyclic) g.lineTo(this.x(this.scene.duration), this.y(this.values[0]));
    g.strokeStyle = color("--panel");
    g.lineWidth = 5;
    g.stroke();
    g.strokeStyle = color("--accent");
    g.lineWidth = 2;
    g.stroke();
    g.fillStyle = color("--muted");
    g.font = "10px system-ui, sans-serif";
    g.textBaseline = "top";
    g.fillText(short(this.top, 2), MARGIN, 1);
    g.textBaseline = "bottom";
    g.fillText(Math.abs(field.min) < 1e-3 * field.max ? "0" : short(field.min, 2), MARGIN, height);
    g.textBaseline = "alphabetic";
  }
}
