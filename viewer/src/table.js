// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of features, strongest first, and the numbers of the selected one.

import { css, durationColor } from "./colors.js";
import { seconds, short } from "./format.js";

const MOST_ROWS = 1000; // more are slow to lay out, and nobody reads them

function element(name, properties = {}, ...children) {
  const result = Object.assign(document.createElement(name), properties);
  result.append(...children);
  return result;
}

export class Table {
  constructor(body, note, scene, state, scale, onPick) {
    Object.assign(this, { body, scene, state });
    const strongest = scene.features[0]?.strength ?? 0;
    this.rows = scene.features.slice(0, MOST_ROWS).map((f, i) => {
      const dot = element("span", { className: "dot" });
      dot.style.background = css(durationColor(scale(f.tau)));
      const bar = element("span", { className: "bar" });
      bar.style.setProperty("--share", strongest > 0 ? f.strength / strongest : 0);
      const button = element("button", { type: "button", className: "rank", tabIndex: i === 0 ? 0 : -1 }, dot, `${i + 1}`);
      button.setAttribute("aria-label", `Feature ${i + 1}, strength ${short(f.strength)}, at ${f.time.toFixed(2)} seconds: show`);
      const row = element(
        "tr",
        {},
        element("th", { scope: "row" }, button),
        element("td", { className: "strength" }, bar, element("span", {}, short(f.strength))),
        element("td", {}, f.time.toFixed(2)),
        element("td", {}, short(f.sigma)),
        element("td", {}, short(f.tau)),
        element("td", {}, `${f.vertex}`),
      );
      row.addEventListener("click", () => onPick(i));
      return row;
    });
    body.append(...this.rows);
    note.hidden = scene.features.length > 0 && scene.features.length <= MOST_ROWS;
    note.textContent = scene.features.length === 0
      ? "No features were found: no response reached the threshold."
      : `The strongest ${MOST_ROWS} of ${scene.features.length}; all of them are on the surface and on the timeline.`;
    state.subscribe((changed) => {
      if ("threshold" in changed) this.hide();
      if ("selected" in changed) this.select();
    });
    this.hide();
  }

  hide() {
    this.rows.forEach((row, i) => (row.hidden = this.scene.features[i].strength < this.state.values.threshold));
  }

  select() {
    this.rows.forEach((row, i) => {
      const isSelected = i === this.state.values.selected;
      row.toggleAttribute("aria-current", isSelected);
      row.querySelector("button").tabIndex = isSelected || (this.state.values.selected < 0 && i === 0) ? 0 : -1;
      if (isSelected) this.reveal(row);
    });
  }

  /** Scrolls the table only, never the page. */
  reveal(row) {
    const frame = this.body.closest(".scroller"), head = 30;
    const top = row.offsetTop - head, bottom = row.offsetTop + row.offsetHeight;
    if (top < frame.scrollTop) frame.scrollTop = top;
    else if (bottom > frame.scrollTop + frame.clientHeight) frame.scrollTop = bottom - frame.clientHeight;
  }
}

export class Details {
  constructor(panel, scene, state) {
    Object.assign(this, { panel, scene, state });
    state.subscribe((changed) => {
      if ("selected" in changed) this.show();
    });
    this.show();
  }

  show() {
    const i = this.state.values.selected, f = this.scene.features[i];
    this.panel.hidden = f === undefined;
    if (f === undefined) return;
    this.panel.querySelector("h2").textContent = `Feature ${i + 1}`;
    const numbers = [
      ["Strength", short(f.strength, 4), "strength"],
      ["Time", seconds(f.time), "time"],
      ["Frame", `${f.frame}`, "frame"],
      ["Vertex", `${f.vertex}`, "vertex"],
      ["σ", short(f.sigma, 4), "sigma", "spatial scale, in the unit of the mesh"],
      ["τ", `${short(f.tau, 4)} s`, "tau", "temporal scale"],
      ["Radius √2 σ", short(f.radius, 4), "radius"],
      ["Position", f.position.map((x) => short(x)).join(", "), "position", "on the surface at its time"],
    ];
    const list = this.panel.querySelector("dl");
    list.replaceChildren(
      ...numbers.map(([name, text, key, title = ""]) => {
        const value = element("dd", { textContent: text });
        value.dataset.key = key;
        value.dataset.value = JSON.stringify(f[key]);
        return element("div", { title }, element("dt", { textContent: name }), value);
      }),
    );
    this.panel.querySelector(".warning").hidden = !f.at_scale_limit;
  }
}
