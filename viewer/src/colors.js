// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Colours of the field, and of the time scale of features.

// Viridis and cividis at 17 equidistant places, sampled from matplotlib 3.6; both are in the public domain (CC0).
// Viridis: N. Smith, S. van der Walt, 2015. Cividis: J. Nunez, C. Anderton, R. Renslow, PLOS ONE 13(7), 2018. Both are
// perceptually uniform, and read alike with and without colour blindness.
const TABLES = {
  viridis:
    "440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c 1fa088 28ae80 3fbc73 5ec962 84d44b addc30 d8e219 fde725",
  cividis:
    "00224e 002e6a 1a386f 32436d 434e6c 535a6d 61656f 6f7073 7d7c78 8c8878 9b9476 aba072 bcae6c cdbb63 dec958 f0d846 fee838",
};

export const MAPS = ["sand", "viridis", "cividis"];
export const MAP_SIZE = 256;

const clamp = (x) => Math.min(Math.max(x, 0), 1);

/** Red, green and blue, 0 to 1, from "#rrggbb" or "rrggbb". */
const hexColor = (hex) => [0, 2, 4].map((i) => parseInt(hex.replace("#", "").slice(i, i + 2), 16) / 255);

const maps = Object.fromEntries(Object.entries(TABLES).map(([name, table]) => [name, table.split(" ").map(hexColor)]));

/** Takes the package's own maps, which are defined in Rendering/Palette.h, from the scene: colours at equal distances. */
export function useColors({ field, duration }) {
  maps.sand = field.map(hexColor);
  maps.duration = duration.map(hexColor);
}

/** The colour at `t` from 0 to 1: red, green, blue from 0 to 1. */
export function mapColor(name, t) {
  const map = maps[name];
  const x = clamp(t) * (map.length - 1), i = Math.min(Math.floor(x), map.length - 2);
  return map[i].map((c, k) => c + (x - i) * (map[i + 1][k] - c));
}

/** MAP_SIZE colours, four bytes each. */
export function mapBytes(name) {
  const bytes = new Uint8Array(4 * MAP_SIZE);
  for (let i = 0; i < MAP_SIZE; ++i) {
    const color = mapColor(name, i / (MAP_SIZE - 1));
    bytes.set([...color.map((c) => Math.round(255 * c)), 255], 4 * i);
  }
  return bytes;
}

export const css = (rgb, alpha = 1) => `rgb(${rgb.map((c) => Math.round(255 * c)).join(" ")} / ${alpha})`;

/** Red for short events (0), blue for long ones (1), as in the paper. */
export const durationColor = (t) => mapColor("duration", t);

/** A function that gives the place of a feature's tau among all, in logarithms, from 0 to 1. */
export function durationScale(features) {
  const taus = features.map((f) => f.tau).filter((t) => t > 0);
  const min = Math.min(...taus), max = Math.max(...taus);
  const scale = (tau) => (max > min ? clamp(Math.log(tau / min) / Math.log(max / min)) : 0.5);
  return Object.assign(scale, { min, max });
}

/** A gradient for style sheets. */
export function gradient(color, steps = 16) {
  return `linear-gradient(to right, ${Array.from({ length: steps + 1 }, (_, i) => css(color(i / steps))).join(", ")})`;
}
