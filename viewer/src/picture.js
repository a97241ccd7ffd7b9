// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A picture of the stage to be kept: what is seen, and a caption that says what it is.

import { css, mapColor } from "./colors.js";
import { short } from "./format.js";

const PADDING = 16, LINE = 20, RAMP_WIDTH = 160, RAMP_HEIGHT = 10; // CSS pixels

/** The lines of the caption, and the field with its map if one is shown. */
export function caption(scene, { time, field: i, map, features, threshold, shown, selected }) {
  const frame = scene.frameAt(time), field = scene.fields[i], f = scene.features[selected];
  const lines = [`${scene.title || "Animated mesh"} – ${time.toFixed(3)} s, frame ${frame}`];
  if (features) {
    const n = shown.filter(Boolean).length;
    lines.push(`${n} of ${scene.features.length} features, strength at least ${short(threshold)}; spheres: radius √2 σ, red short, blue long`);
  }
  if (f) {
    const parts = [`selected: #${f.rank}, σ ${short(f.sigma)}, τ ${short(f.tau)} s, strength ${short(f.strength)}`];
    if (f.fit !== undefined) parts.push(`fit ${f.fit.toFixed(2)}`);
    if (f.place !== undefined) parts.push(`place ${f.place}`);
    lines.push(parts.join(", "));
  }
  return { lines, field, map };
}

function drawRamp(g, field, map, x, y) {
  for (let i = 0; i < RAMP_WIDTH; ++i) {
    g.fillStyle = css(mapColor(map, i / (RAMP_WIDTH - 1)));
    g.fillRect(x + i, y - RAMP_HEIGHT + 1, 1.5, RAMP_HEIGHT);
  }
  const top = `${field.largest > field.max ? "≥ " : ""}${short(field.max, 2)}`;
  return `${field.name} ${Math.abs(field.min) < 1e-3 * field.max ? "0" : short(field.min, 2)} to ${top}`;
}

/** Lines that are no wider than the picture. */
function wrapped(g, lines, width) {
  const result = [];
  for (const line of lines) {
    let now = "";
    for (const word of line.split(" ")) {
      const longer = now === "" ? word : `${now} ${word}`;
      if (now !== "" && g.measureText(longer).width > width) {
        result.push(now);
        now = word;
      } else {
        now = longer;
      }
    }
    result.push(now);
  }
  return result;
}

/** A PNG of views side by side, each of layers one over another, on the page's own ground, with the caption beneath. */
export function composed(views, { lines, field, map }) {
  const [[first]] = views, width = views.reduce((sum, [canvas]) => sum + canvas.clientWidth, 0), ratio = first.width / first.clientWidth, style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(name).trim();
  const canvas = document.createElement("canvas"), g = canvas.getContext("2d"), font = "13px system-ui, sans-serif";
  g.font = font;
  const texts = wrapped(g, lines, width - 2 * PADDING), count = texts.length + (field ? 1 : 0);
  const height = first.clientHeight + 2 * PADDING + count * LINE - 6;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.fillStyle = color("--glow");
  g.fillRect(0, 0, width, height);
  let left = 0;
  for (const layers of views) {
    for (const layer of layers) g.drawImage(layer, left, 0, layers[0].clientWidth, first.clientHeight);
    left += layers[0].clientWidth;
  }
  g.fillStyle = color("--panel");
  g.fillRect(0, first.clientHeight, width, height - first.clientHeight);
  g.font = font;
  g.textBaseline = "alphabetic";
  let y = first.clientHeight + PADDING + 10;
  texts.forEach((text, i) => {
    g.fillStyle = color(i === 0 ? "--ink" : "--muted");
    g.fillText(text, PADDING, y);
    y += LINE;
  });
  if (field) {
    const text = drawRamp(g, field, map, PADDING, y);
    g.fillStyle = color("--muted");
    g.fillText(text, PADDING + RAMP_WIDTH + 10, y);
  }
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}
