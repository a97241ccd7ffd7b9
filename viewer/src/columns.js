// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a table of features has: its columns, how they are read and sorted. The names are those of the files.

import { short } from "./format.js";

/**
 * `first`: whether sorting begins with the smallest (1) or the largest (-1). `text` is what the table shows. A column
 * without `head` is in files only.
 */
export const COLUMNS = [
  { key: "pair", head: "Pair", title: "features of both animations that show the same event share a number", first: 1, text: String },
  { key: "rank", head: "#", title: "rank by strength", first: 1, text: String },
  { key: "place", head: "Place", title: "features at one place at different times share a number", first: 1, text: String },
  { key: "time", head: "Time", title: "seconds", first: 1, text: (x) => x.toFixed(2) },
  { key: "strength", head: "Strength", title: "amplitude times fit, less where the ranges of σ and τ begin", first: -1, text: (x) => short(x) },
  { key: "amplitude", head: "Ampl.", title: "amplitude: how much more than at its least the surface is deformed", first: -1, text: (x) => short(x, 2) },
  { key: "fit", head: "Fit", title: "correlation of the deformation with the feature's Gaussian", first: -1, text: (x) => x.toFixed(2) },
  { key: "sigma", head: "σ", title: "spatial scale, in the unit of the mesh", first: -1, text: (x) => short(x, 2) },
  { key: "tau", head: "τ", title: "temporal scale, seconds", first: -1, text: (x) => short(x, 2) },
  { key: "vertex", head: "Vertex", title: "vertex of the file, from 0", first: 1, text: String },
];

const byKey = Object.fromEntries(COLUMNS.map((column) => [column.key, column]));

/** What a cell shows; numbers that a file does not have are a dash. */
export const cellText = (column, feature) => ((feature[column.key] ?? undefined) === undefined ? "–" : column.text(feature[column.key]));

/** Sorting is told by a text: the column's key, after a minus if the largest come first. */
export const sortKey = (sort) => sort.replace("-", "");
export const isSort = (sort) => sortKey(sort) in byKey;

/** The order after a click on a column's head. */
export function nextSort(sort, key) {
  const natural = byKey[key].first > 0 ? key : `-${key}`, other = byKey[key].first > 0 ? `-${key}` : key;
  return sort === natural ? other : natural;
}

/** Indices of features in order; equal ones by rank. */
export function sorted(indices, features, sort) {
  const key = sortKey(sort), sign = sort.startsWith("-") ? -1 : 1;
  const value = (i) => features[i][key] ?? -Infinity;
  return [...indices].sort((i, j) => (value(i) === value(j) ? i - j : sign * (value(i) < value(j) ? -1 : 1)));
}

/**
 * Features of a sorted list by place: [{ place, members }], in the order in which places occur; the members by time.
 * Without places, each feature is one of its own.
 */
export function groupedByPlace(indices, features) {
  const groups = new Map();
  for (const i of indices) {
    const place = features[i].place ?? `feature ${i}`;
    if (!groups.has(place)) groups.set(place, []);
    groups.get(place).push(i);
  }
  return [...groups].map(([place, members]) => ({ place, members: members.sort((i, j) => features[i].time - features[j].time) }));
}
