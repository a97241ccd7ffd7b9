// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is drawn flat over the stage: ranks on spheres, trajectories, and the line that is measured.

import { css } from "./colors.js";
import { short } from "./format.js";

const LEAST_OPACITY = 0.3; // of a sphere that has its rank on it
const FONT = "600 12px system-ui, sans-serif";

export class Overlay {
  constructor(canvas, { scene, state, stage, measure = null }) {
    Object.assign(this, { canvas, scene, state, stage, measure });
  }

  /** After each picture of the stage. */
  draw() {
    const { clientWidth: width, clientHeight: height } = this.stage.canvas, ratio = Math.min(window.devicePixelRatio, 2);
    if (width === 0) return;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const g = this.canvas.getContext("2d");
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.clearRect(0, 0, width, height);
    g.font = FONT;
    g.textAlign = "center";
    g.textBaseline = "middle";
    const { features, painting, trail, labels } = this.state.values;
    if (painting) return;
    if (trail && features) this.drawTrails(g);
    this.drawProbe(g);
    this.drawMeasure(g);
    if (labels && features) this.drawLabels(g, width, height);
  }

  /** A text that is read on anything. */
  write(g, text, x, y) {
    const style = getComputedStyle(document.documentElement);
    g.lineJoin = "round";
    g.lineWidth = 3.5;
    g.strokeStyle = style.getPropertyValue("--glow").trim();
    g.strokeText(text, x, y);
    g.fillStyle = style.getPropertyValue("--ink").trim();
    g.fillText(text, x, y);
  }

  /** The strongest first; what would lie over another one is left out. */
  drawLabels(g, width, height) {
    const taken = [], { selected } = this.state.values;
    const labels = this.stage.spheres.shown.filter(({ opacity, index }) => opacity >= LEAST_OPACITY || index === selected);
    labels.sort((a, b) => (b.index === selected) - (a.index === selected) || a.index - b.index);
    for (const { feature, index } of labels) {
      const { x, y, isInFront } = this.stage.project(feature), text = feature.label, half = g.measureText(text).width / 2 + 3;
      if (!isInFront || x < 0 || y < 0 || x > width || y > height) continue;
      if (!this.state.values.hidden && index !== selected && this.stage.isCovered(feature)) continue;
      if (taken.some((t) => Math.abs(t.x - x) < t.half + half && Math.abs(t.y - y) < 15)) continue;
      taken.push({ x, y, half });
      this.write(g, text, x, y);
    }
    this.labelled = taken.length;
  }

  /** The way of the selected place through all frames, each feature's own; bright around the present. */
  drawTrails(g) {
    const { selected, time, follow } = this.state.values, f = this.scene.features[selected];
    if (f === undefined) return;
    const rgb = f.color, d = this.scene.frame_duration;
    const times = this.scene.kept_frames.map((frame) => frame * d);
    if (this.scene.cyclic) times.push(this.scene.duration);
    let last = null;
    g.lineCap = "round";
    for (const [k, t] of times.entries()) {
      // where it is against the body, while that is followed
      const p = this.stage.projectPlace(this.scene.place(f, t), follow ? { from: t, to: time } : null);
      if (last?.isInFront && p.isInFront) {
        const far = this.scene.timeBetween(t, time) / Math.max(2 * f.tau, d);
        g.strokeStyle = css(rgb, 0.3 + 0.65 * Math.exp(-far * far));
        g.lineWidth = far < 1 ? 3 : 2;
        g.beginPath();
        g.moveTo(last.x, last.y);
        g.lineTo(p.x, p.y);
        g.stroke();
      }
      last = p;
      this.trailPoints = k + 1;
    }
  }

  drawProbe(g) {
    const { probe } = this.state.values;
    if (probe < 0) return;
    const p = this.stage.projectPlace(this.scene.vertexPlace(probe, this.state.values.time));
    if (!p.isInFront) return;
    for (const [radius, name] of [[6, "--panel"], [4, "--accent"]]) {
      g.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
      g.beginPath();
      g.arc(p.x, p.y, radius, 0, 2 * Math.PI);
      g.fill();
    }
  }

  drawMeasure(g) {
    const ends = (this.measure?.ends(this.state.values.time) ?? []).map((p) => this.stage.projectPlace(p));
    if (ends.length === 0 || ends.some((p) => !p.isInFront)) return;
    const style = getComputedStyle(document.documentElement);
    for (const [width, name] of [[5, "--panel"], [2.5, "--ink"]]) {
      g.strokeStyle = g.fillStyle = style.getPropertyValue(name).trim();
      g.lineWidth = width;
      g.beginPath();
      ends.forEach((p) => g.lineTo(p.x, p.y));
      g.stroke();
      for (const p of ends) {
        g.beginPath();
        g.arc(p.x, p.y, width, 0, 2 * Math.PI);
        g.fill();
      }
    }
    if (ends.length === 2) this.write(g, short(this.measure.straight(this.state.values.time)), (ends[0].x + ends[1].x) / 2, (ends[0].y + ends[1].y) / 2 - 12);
  }
}
