// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The table of features: sorted by any column, each for itself or those of a place together; and the numbers of the
// selected one.

import { COLUMNS, cellText, groupedByPlace, nextSort, sortKey, sorted } from "./columns.js";
import { css } from "./colors.js";
import { count, seconds, short } from "./format.js";

const MOST_ROWS = 1000; // more are slow to lay out, and nobody reads them

function element(name, properties = {}, ...children) {
  const result = Object.assign(document.createElement(name), properties);
  result.append(...children);
  return result;
}

export class Table {
  constructor({ head, body, note, grouped }, scene, state, onPick) {
    Object.assign(this, { head, body, note, grouped, scene, state, onPick, order: [], rows: new Map() });
    const hasPairs = scene.features.some((f) => f.pair !== undefined);
    this.columns = COLUMNS.filter(({ key }) => key !== (hasPairs ? "place" : "pair")); // there is no room for both
    this.strongest = scene.features[0]?.strength ?? 0;
    head.append(...this.columns.map((column) => this.headCell(column)));
    grouped.disabled = scene.features.every((f) => f.place === undefined);
    grouped.addEventListener("change", () => state.set({ grouped: grouped.checked }));
    state.subscribe((changed) => {
      if (["shown", "sort", "grouped"].some((name) => name in changed)) this.fill();
      if ("selected" in changed) this.select();
    });
    this.fill();
  }

  headCell({ key, head, title }) {
    const button = element("button", { type: "button", className: "sort", title: `${title}: sort` }, head);
    button.setAttribute("aria-label", `${head}, ${title}: sort`);
    button.addEventListener("click", () => this.state.set({ sort: nextSort(this.state.values.sort, key) }));
    const cell = element("th", { scope: "col" }, button);
    cell.dataset.key = key;
    return cell;
  }

  /** The rows that are to be seen, in their order. */
  fill() {
    const { features } = this.scene, { shown, sort, grouped } = this.state.values;
    this.grouped.checked = grouped;
    for (const cell of this.head.children) {
      const isKey = cell.dataset.key === sortKey(sort);
      if (isKey) cell.setAttribute("aria-sort", sort.startsWith("-") ? "descending" : "ascending");
      else cell.removeAttribute("aria-sort");
    }
    const list = sorted(features.map((_, i) => i).filter((i) => shown[i]), features, sort);
    const groups = grouped ? groupedByPlace(list, features) : list.map((i) => ({ members: [i] }));
    this.order = groups.flatMap(({ members }) => members);
    this.rows.clear();
    const rows = [];
    for (const { place, members } of groups) {
      if (rows.length >= MOST_ROWS) break;
      const strongest = Math.min(...members), row = this.row(strongest, members.length > 1 ? "place" : "");
      rows.push(row);
      for (const i of members) this.rows.set(i, [row]);
      if (members.length === 1) continue;
      const times = this.timesRow(place, members);
      rows.push(times);
    }
    this.body.replaceChildren(...rows);
    this.tell(list.length, groups.length, rows.length);
    this.select();
  }

  tell(listed, groups, rows) {
    const { features } = this.scene;
    const notes = [];
    if (features.length === 0) notes.push("No features were found: no response reached the threshold.");
    else if (listed === 0) notes.push("None is within the bounds.");
    if (rows >= MOST_ROWS) notes.push(`The first ${MOST_ROWS} rows; all of them are on the surface and on the timeline.`);
    this.note.hidden = notes.length === 0;
    this.note.textContent = notes.join(" ");
    this.groups = groups;
  }

  row(i, className) {
    const f = this.scene.features[i], color = css(f.color);
    const dot = element("span", { className: f.at_scale_limit ? "dot limit" : "dot" });
    dot.style.setProperty("--dot", color);
    const button = element("button", { type: "button", className: "rank", tabIndex: -1 }, dot, `${f.rank}`);
    const limit = f.at_scale_limit ? ", at a limit of the scales" : "";
    button.setAttribute("aria-label", `${f.rank}: feature of strength ${short(f.strength)}, at ${f.time.toFixed(2)} seconds${limit}: show`);
    if (limit) button.title = "Found at the smallest or largest scale that was searched";
    const cells = this.columns.map((column) => {
      if (column.key === "rank") return element("th", { scope: "row" }, button);
      if (column.key !== "strength") return element("td", {}, cellText(column, f));
      const bar = element("span", { className: "bar" });
      bar.style.setProperty("--share", this.strongest > 0 ? Math.max(f.strength / this.strongest, 0) : 0);
      return element("td", { className: "strength" }, bar, element("span", {}, cellText(column, f)));
    });
    const row = element("tr", { className: `feature ${className}`.trim() }, ...cells);
    row.dataset.index = `${i}`;
    row.addEventListener("click", () => this.onPick(i));
    return row;
  }

  /** The times of a place, each to be chosen. */
  timesRow(place, members) {
    const buttons = members.map((i) => {
      const f = this.scene.features[i], button = element("button", { type: "button", className: "chip" }, `${f.time.toFixed(2)} s`);
      button.style.setProperty("--dot", css(f.color));
      button.setAttribute("aria-label", `${f.time.toFixed(2)} s: feature ${f.rank} at place ${place}: show`);
      button.addEventListener("click", () => this.onPick(i));
      button.dataset.index = `${i}`;
      this.rows.get(i).push(button);
      return button;
    });
    const cell = element("td", { colSpan: this.columns.length }, element("div", { className: "chips" }, `${members.length} times`, ...buttons));
    return element("tr", { className: "times" }, cell);
  }

  select() {
    const { selected } = this.state.values;
    for (const marked of this.body.querySelectorAll("[aria-current]")) marked.removeAttribute("aria-current");
    for (const button of this.body.querySelectorAll(".rank")) button.tabIndex = -1;
    const [row, chip] = this.rows.get(selected) ?? [];
    row?.setAttribute("aria-current", "true");
    chip?.setAttribute("aria-current", "true");
    const first = row ?? this.body.querySelector("tr");
    if (first) first.querySelector(".rank").tabIndex = 0;
    if (row) this.reveal(row);
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
  /** `name`: which animation it is of, if there are several. */
  constructor(panel, scene, state, onPick, name = "") {
    Object.assign(this, { panel, scene, state, onPick, name });
    state.subscribe((changed) => {
      if ("selected" in changed) this.show();
    });
    this.show();
  }

  show() {
    const i = this.state.values.selected, f = this.scene.features[i];
    this.panel.hidden = f === undefined;
    if (f === undefined) return;
    this.panel.querySelector("h2").textContent = `${this.name ? `${this.name}, feature` : "Feature"} ${f.rank}`;
    const numbers = [
      ["Strength", short(f.strength, 4), "strength", "amplitude times fit, less where the ranges of σ and τ begin"],
      ["Amplitude", short(f.amplitude ?? NaN, 4), "amplitude", "how much more than at its least the surface is deformed"],
      ["Fit", short(f.fit ?? NaN, 3), "fit", "correlation of the deformation with the feature's Gaussian"],
      ["Time", seconds(f.time), "time"],
      ["Frame", `${f.frame}`, "frame"],
      ["Vertex", `${f.vertex}`, "vertex"],
      ["σ", short(f.sigma, 4), "sigma", "spatial scale, in the unit of the mesh"],
      ["τ", `${short(f.tau, 4)} s`, "tau", "temporal scale"],
      ["Radius √2 σ", short(f.radius, 4), "radius"],
      ["Place", this.placeText(f), "place", "features at one place at different times"],
      ["Part of", this.parentCell(f), "parent", "the strongest feature of another scale in which this one lies"],
      ...(f.pair === undefined ? [] : [["Pair", `${f.pair ?? "none"}`, "pair", "features of both animations that show the same event"]]),
      ["Position", f.position.map((x) => short(x)).join(", "), "position", "on the surface at its time"],
    ];
    this.panel.querySelector("dl").replaceChildren(
      ...numbers.map(([name, content, key, title = ""]) => {
        const value = element("dd", {}, content);
        value.dataset.key = key;
        value.dataset.value = JSON.stringify(f[key] ?? null);
        const item = element("div", { title }, element("dt", { textContent: name }), value);
        item.dataset.item = key;
        return item;
      }),
    );
    this.panel.querySelector(".warning").hidden = !f.at_scale_limit;
  }

  placeText({ place }) {
    if (place === undefined) return "–";
    const n = this.scene.features.filter((f) => f.place === place).length;
    return n > 1 ? `${place}, ${count(n, "time")}` : `${place}`;
  }

  parentCell({ parent }) {
    const i = this.scene.features.findIndex((f) => f.rank === parent);
    if (parent === undefined || parent === null || i < 0) return "–";
    const button = element("button", { type: "button", className: "link" }, `#${parent}`);
    button.setAttribute("aria-label", `#${parent}: feature ${parent}, in which this one lies: show`);
    button.addEventListener("click", () => this.onPick(i));
    return button;
  }
}
