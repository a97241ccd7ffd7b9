// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All features over time: a bar from time - tau to time + tau at the height of its strength. While somebody paints, a strip
// at the bottom shows when there is paint.

import { css } from "./colors.js";
import { PAINT } from "./surface.js";
import { pairText, short } from "./format.js";

export const MARGIN = 10; // pixels, left and right, as far as the thumb of the slider beneath needs
const BAR = 5, REACH = 7, STRIP = 6; // pixels

export class Timeline {
  /**
   * `axis` says what is seen along it: how long it is, whose time it is (a state), and which time of it is which of the
   * scene; `name`, if there are several, whose features these are. Default: the scene's own.
   */
  constructor(canvas, scene, state, onPick, axis = { duration: scene.duration, state, of: (time) => time, name: "" }) {
    Object.assign(this, { canvas, scene, state, axis });
    this.strongest = scene.features.reduce((most, f) => Math.max(most, f.strength), 0);
    this.hovered = -1;
    new ResizeObserver(() => this.draw()).observe(canvas);
    state.subscribe(() => this.draw());
    let isDragging = false;
    canvas.addEventListener("pointerdown", (event) => {
      const i = this.featureAt(event.offsetX, event.offsetY);
      if (i >= 0) return onPick(i);
      isDragging = true;
      canvas.setPointerCapture(event.pointerId);
      this.seek(event.offsetX);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (isDragging) return this.seek(event.offsetX);
      const i = this.featureAt(event.offsetX, event.offsetY);
      canvas.style.cursor = i >= 0 ? "pointer" : "crosshair";
      canvas.title = i >= 0 ? this.describe(i) : "";
      if (i !== this.hovered) {
        this.hovered = i;
        this.draw();
      }
    });
    canvas.addEventListener("pointerleave", () => {
      this.hovered = -1;
      this.draw();
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (isDragging = false));
  }

  describe(i) {
    const f = this.scene.features[i];
    const place = f.place === undefined ? "" : `, place ${f.place}`;
    return `${pairText(f)}Feature ${f.rank}: ${f.time.toFixed(3)} s, τ ${short(f.tau)} s, strength ${short(f.strength)}${place}`;
  }

  seek(x) {
    const share = (x - MARGIN) / (this.canvas.clientWidth - 2 * MARGIN);
    this.axis.state.set({ time: Math.min(Math.max(share, 0), 1) * this.axis.duration, playing: false });
  }

  x(time) {
    return this.along(this.axis.of(time));
  }

  along(time) {
    return MARGIN + (time / this.axis.duration) * (this.canvas.clientWidth - 2 * MARGIN);
  }

  y(strength) {
    const height = this.canvas.clientHeight;
    return height - 8 - (this.strongest > 0 ? strength / this.strongest : 0) * (height - 18);
  }

  featureAt(x, y) {
    let best = -1, least = REACH;
    this.scene.features.forEach((f, i) => {
      if (!this.state.values.shown[i] || !this.state.values.features) return;
      const along = Math.min(...this.scene.spans(f).map(([from, to]) => Math.max(this.x(from) - x, x - this.x(to), 0)));
      const distance = Math.hypot(along, y - this.y(f.strength)) + 0.02 * Math.abs(x - this.x(f.time));
      if (distance < least) [best, least] = [i, distance];
    });
    return best;
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.canvas, ratio = window.devicePixelRatio;
    if (width === 0) return;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const g = this.canvas.getContext("2d"), style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    const { features, painting } = this.state.values, now = this.along(this.axis.state.values.time);
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    this.drawSeconds(g, height, color);
    if (features) this.drawFeatures(g, width, color);
    if (painting) this.drawPaint(g, height);
    g.strokeStyle = color("--ink");
    g.lineWidth = 2;
    g.beginPath();
    g.moveTo(now, 0);
    g.lineTo(now, height);
    g.stroke();
  }

  drawPaint(g, height) {
    const d = this.scene.frame_duration, half = d / 2;
    g.fillStyle = css(PAINT);
    for (const { first, last } of this.state.values.strokes) {
      const from = this.x(Math.max(first * d - half, 0)), to = this.x(Math.min(last * d + half, this.scene.duration));
      g.fillRect(from, height - STRIP, Math.max(to - from, 2), STRIP);
    }
  }

  drawFeatures(g, width, color) {
    const { threshold, selected, shown } = this.state.values, place = this.scene.features[selected]?.place;
    g.lineCap = "round";
    const order = this.scene.features.map((_, i) => i).reverse(); // the strongest on top
    for (const i of order) {
      const f = this.scene.features[i], y = this.y(f.strength), rgb = f.color;
      const isMarked = i === selected || i === this.hovered;
      const alpha = shown[i] ? 1 : 0.22;
      const isSibling = place !== undefined && f.place === place && shown[i]; // the selected place at another time
      const stroke = (lineWidth, strokeStyle) => {
        Object.assign(g, { lineWidth, strokeStyle });
        g.beginPath();
        for (const [from, to] of this.scene.spans(f)) {
          const left = this.x(from), right = this.x(to);
          // beside a loop, what goes on across the end of the axis
          const pieces = left <= right ? [[left, right]] : [[left, this.along(this.axis.duration)], [this.along(0), right]];
          for (const [x, end] of pieces) {
            g.moveTo(x, y);
            g.lineTo(end, y);
          }
        }
        g.stroke();
      };
      if (isMarked) stroke(BAR + 5, color("--ink"));
      if (isMarked) stroke(BAR + 2, color("--panel"));
      stroke(BAR, css(rgb, isMarked ? 0.75 : 0.38 * alpha));
      g.fillStyle = css(rgb, alpha);
      g.beginPath();
      g.arc(this.x(f.time), y, isMarked ? 4.2 : 3.2, 0, 2 * Math.PI);
      g.fill();
      if (!isSibling || isMarked) continue;
      g.strokeStyle = color("--ink");
      g.lineWidth = 1.5;
      g.beginPath();
      g.arc(this.x(f.time), y, 5, 0, 2 * Math.PI);
      g.stroke();
    }

    g.lineCap = "butt";
    g.strokeStyle = color("--muted");
    g.lineWidth = 1;
    g.setLineDash([3, 4]);
    g.beginPath();
    g.moveTo(0, this.y(threshold) + 0.5);
    g.lineTo(width, this.y(threshold) + 0.5);
    g.stroke();
    g.setLineDash([]);
  }

  /** Thin lines at whole multiples of a nice step. */
  drawSeconds(g, height, color) {
    const rough = this.scene.duration / Math.max(2, this.canvas.clientWidth / 90);
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough);
    g.strokeStyle = color("--line");
    g.fillStyle = color("--muted");
    g.lineWidth = 1;
    g.font = "10px system-ui, sans-serif";
    g.textBaseline = "top";
    // the end of a loop beside another animation is where it begins
    const end = this.scene.duration * (this.scene.cyclic && this.axis.name ? 1 - 1e-9 : 1 + 1e-9);
    for (let i = 0; i * step <= end; ++i) {
      const x = Math.round(this.x(i * step)) + 0.5;
      g.beginPath();
      g.moveTo(x, 0);
      g.lineTo(x, height);
      g.stroke();
      const text = `${+(i * step).toPrecision(6)} s`;
      if (x + (this.axis.name ? 24 : 4) + g.measureText(text).width < this.canvas.clientWidth) g.fillText(text, x + 3, 1);
    }
    g.font = "600 11px system-ui, sans-serif";
    g.fillText(this.axis.name, this.canvas.clientWidth - 14, 1);
  }
}
