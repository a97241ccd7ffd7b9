// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The address: what is shown, as its fragment, so that a link or a reload shows the same again. Only what differs from
// the page as it opens is there.

import { isSort } from "./columns.js";
import { MAPS } from "./colors.js";
import { BOUNDED, LIMITS, NO_BOUNDS } from "./filters.js";

const EVERY = 400; // ms; browsers refuse to take up more than some changes a second
const DIGITS = 6;

const short = (x) => `${+x.toPrecision(DIGITS)}`;

function number(text) {
  const x = Number(text);
  return text.trim() === "" || !Number.isFinite(x) ? undefined : x;
}

const truth = { write: (x) => (x ? "1" : "0"), read: (text) => (text === "1" ? true : text === "0" ? false : undefined) };
const among = (values) => ({ write: String, read: (text) => (values.includes(text) ? text : undefined) });
const bounded = (low, high) => ({
  write: short,
  read: (text) => {
    const x = number(text);
    return x === undefined ? undefined : Math.min(Math.max(x, low), high);
  },
});

/** For each parameter the member of the state, and how it is written and read; what cannot be read is undefined. */
function parameters(scene) {
  const rank = (i) => scene.features[i]?.rank;
  const vertex = {
    write: (v) => `${v < 0 ? "" : scene.vertexName(v)}`,
    read: (text) => {
      const v = /^\d+$/.test(text) ? scene.vertexOf(Number(text)) : -1;
      return v < 0 ? undefined : v;
    },
  };
  return {
    s: {
      key: "selected", write: (i) => `${rank(i)}`,
      read: (text) => {
        const i = scene.features.findIndex((f) => `${f.rank}` === text);
        return i < 0 ? undefined : i;
      },
    },
    v: { key: "probe", ...vertex },
    field: {
      key: "field", write: (i) => scene.fields[i]?.name ?? "none",
      read: (text) => {
        const i = scene.fields.findIndex((f) => f.name === text);
        return i >= 0 || text === "none" ? i : undefined;
      },
    },
    map: { key: "map", ...among(MAPS) },
    theme: { key: "theme", ...among(["light", "dark"]) },
    strength: { key: "threshold", write: String, read: number },
    limits: { key: "limits", ...among(LIMITS) },
    sort: { key: "sort", write: String, read: (text) => (isSort(text) ? text : undefined) },
    grouped: { key: "grouped", ...truth },
    through: { key: "hidden", ...truth },
    edges: { key: "wires", ...truth },
    follow: { key: "follow", ...truth },
    labels: { key: "labels", ...truth },
    trail: { key: "trail", ...truth },
    unmatched: { key: "unmatched", ...truth },
    loop: { key: "loop", ...truth },
    up: { key: "up", ...among(["y", "z"]) },
    opacity: { key: "opacity", ...bounded(0.1, 1) },
    speed: { key: "speed", ...bounded(0.1, 2) },
    from: { key: "measureFrom", ...vertex },
    to: { key: "measureTo", ...vertex },
  };
}

export class Address {
  constructor(viewer) {
    const { scene, state, stage } = viewer;
    Object.assign(this, { viewer, scene, state, stage, known: parameters(scene), written: "", last: 0 });
    this.defaults = { ...state.values };
    if (location.hash.length > 1) this.read();
    window.addEventListener("hashchange", () => {
      if (location.hash.slice(1) !== this.written) this.read();
    });
  }

  text() {
    const { values } = this.state, parts = new URLSearchParams();
    const isAtStart = values.time === this.defaults.time && !this.defaults.playing;
    if (!values.playing && !isAtStart) parts.set("t", short(values.time));
    for (const [name, { key, write }] of Object.entries(this.known))
      if (values[key] !== this.defaults[key]) parts.set(name, write(values[key]));
    for (const [key, bound] of Object.entries(values.bounds)) parts.set(`${key}.in`, bound.map((x) => x ?? "").join(","));
    const view = this.stage?.ownView();
    if (view) parts.set("view", view.map(short).join(","));
    return parts.toString().replaceAll("%2C", ",");
  }

  /** Shows what the address says; what it does not speak of is as at the beginning. */
  read() {
    const parts = new URLSearchParams(location.hash.slice(1)), values = {};
    for (const [name, { key, read }] of Object.entries(this.known))
      values[key] = (parts.has(name) ? read(parts.get(name)) : undefined) ?? this.defaults[key];
    const { selected, theme, ...others } = values, time = number(parts.get("t") ?? "");
    others.bounds = this.readBounds(parts);
    if (time !== undefined) Object.assign(others, { time: Math.min(Math.max(time, 0), this.scene.duration), playing: false });
    this.viewer.setTheme(theme);
    this.state.set(others); // bounds first: what they leave out cannot be selected
    this.state.set({ selected: selected >= 0 && this.state.values.shown[selected] ? selected : -1 });
    const view = (parts.get("view") ?? "").split(",").map(number);
    if (view.length === 6 && view.every((x) => x !== undefined)) this.stage?.setView(view);
    else this.stage?.resetView();
    this.written = location.hash.slice(1);
  }

  readBounds(parts) {
    const bounds = {};
    for (const { key } of BOUNDED) {
      if (!parts.has(`${key}.in`)) continue;
      const [least, most] = parts.get(`${key}.in`).split(",").map((text) => number(text ?? "") ?? null);
      if (least !== null || (most ?? null) !== null) bounds[key] = [least, most ?? null];
    }
    return Object.keys(bounds).length > 0 ? bounds : NO_BOUNDS;
  }

  /** To be called in every animation frame. */
  update(now) {
    if (now - this.last < EVERY || this.state.values.painting) return;
    this.last = now;
    const text = this.text();
    if (text === this.written) return;
    this.written = text;
    try {
      history.replaceState(null, "", `#${text}`);
    } catch {
      // pages without an address of their own
    }
  }
}
