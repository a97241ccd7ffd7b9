// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which features are shown: by bounds on their numbers, in the surface, on the timeline and in the table alike.

import { short } from "./format.js";

/** What can be bounded, besides the strength, which has a slider of its own. */
export const BOUNDED = [
  { key: "amplitude", name: "Amplitude", title: "how much more than at its least the surface is deformed" },
  { key: "fit", name: "Fit", title: "correlation of the deformation around the feature with its Gaussian, at most 1" },
  { key: "sigma", name: "Size σ", title: "spatial scale, in the unit of the mesh" },
  { key: "tau", name: "Duration τ (s)", title: "temporal scale, in seconds" },
  { key: "time", name: "Time (s)", title: "when, in seconds" },
];

export const LIMITS = ["all", "without", "only"];
export const NO_BOUNDS = Object.freeze({});

/** Whether a feature is within the bounds; `bounds` has [least, most] for some keys, null where there is no bound. */
export function isWithin(feature, { threshold, bounds, limits, unmatched }) {
  if (feature.pair === null && !unmatched) return false;
  if (feature.strength < threshold) return false;
  if (limits !== "all" && feature.at_scale_limit !== (limits === "only")) return false;
  return Object.entries(bounds).every(([key, [least, most]]) => {
    const x = feature[key];
    return (least === null || x >= least) && (most === null || x <= most);
  });
}

/** Keeps `state.shown`, a truth value for each feature, and selects none that is not shown. */
export class Filter {
  constructor(scene, state) {
    Object.assign(this, { scene, state });
    state.subscribe((changed) => {
      if (["threshold", "bounds", "limits", "unmatched"].some((name) => name in changed)) this.apply();
    });
    this.apply();
  }

  apply() {
    const { values } = this.state, shown = this.scene.features.map((f) => isWithin(f, values));
    const { selected } = values;
    this.state.set({ shown, selected: selected >= 0 && shown[selected] ? selected : -1 });
  }
}

/** The controls: two numbers for each quantity, the limits, and a button that takes all bounds away. */
export class FilterForm {
  constructor({ rows, limits, clear, summary }, scene, state) {
    Object.assign(this, { limits, clear, summary, scene, state, inputs: {} });
    for (const quantity of BOUNDED) rows.append(this.row(quantity));
    limits.addEventListener("change", () => state.set({ limits: limits.value }));
    clear.addEventListener("click", () => this.reset());
    state.subscribe((changed) => this.show(changed));
    this.show(state.values);
  }

  row({ key, name, title }) {
    const row = document.createElement("div"), label = document.createElement("span");
    Object.assign(row, { className: "bounds", title });
    label.textContent = name;
    const numbers = this.scene.features.map((f) => f[key]).filter(Number.isFinite);
    const ends = numbers.length > 0 ? [Math.min(...numbers), Math.max(...numbers)] : [0, 0];
    this.inputs[key] = ["at least", "at most"].map((what, i) => {
      const input = Object.assign(document.createElement("input"), {
        type: "number", step: "any", placeholder: short(ends[i]).replace("−", "-"), disabled: numbers.length === 0,
      });
      input.setAttribute("aria-label", `${name}: ${what}`);
      input.addEventListener("change", () => this.bound(key));
      return input;
    });
    row.append(label, ...this.inputs[key]);
    return row;
  }

  bound(key) {
    const bound = this.inputs[key].map((input) => (input.value === "" ? null : Number(input.value)));
    const { [key]: _, ...others } = this.state.values.bounds;
    this.state.set({ bounds: bound.every((x) => x === null) ? others : { ...others, [key]: bound } });
  }

  reset() {
    const weakest = this.scene.features.reduce((least, f) => Math.min(least, f.strength), Infinity);
    this.state.set({ bounds: NO_BOUNDS, limits: "all", threshold: Number.isFinite(weakest) ? weakest : 0 });
  }

  show(changed) {
    const { bounds, limits } = this.state.values;
    if ("bounds" in changed)
      for (const [key, inputs] of Object.entries(this.inputs))
        inputs.forEach((input, i) => (input.value = bounds[key]?.[i] ?? ""));
    if ("limits" in changed) this.limits.value = limits;
    if ("bounds" in changed || "limits" in changed) {
      const n = Object.keys(bounds).length + (limits === "all" ? 0 : 1);
      this.summary.textContent = n === 0 ? "" : `${n} active`;
      this.summary.hidden = n === 0;
    }
  }
}
