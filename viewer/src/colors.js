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
const gamma = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** sRGB, 0 to 1, from Oklab, in which equal distances look equal (B. Ottosson, 2020). */
function rgbOfOklab([L, a, b]) {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((x) => clamp(gamma(clamp(x))));
}

export function oklabOfRgb(rgb) {
  const [r, g, b] = rgb.map(linear);
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

/** Ours: from the colour of sand to a deep blue-green, lightness linear, so that what does not deform looks like clay. */
function sand(t) {
  const chroma = 0.022 + 0.068 * t, hue = ((85 + 165 * t ** 0.8) * Math.PI) / 180;
  return rgbOfOklab([0.9 - 0.52 * t, chroma * Math.cos(hue), chroma * Math.sin(hue)]);
}

const hexColor = (hex) => [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

/** The colour at `t` from 0 to 1: red, green, blue from 0 to 1. */
export function mapColor(name, t) {
  if (name === "sand") return sand(t);
  const table = TABLES[name].split(" ").map(hexColor);
  const x = clamp(t) * (table.length - 1), i = Math.min(Math.floor(x), table.length - 2);
  return table[i].map((c, k) => c + (x - i) * (table[i + 1][k] - c));
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

const SHORT = oklabOfRgb(hexColor("e8352c")), MIDDLE = oklabOfRgb(hexColor("c04fb4")), LONG = oklabOfRgb(hexColor("2b66f0"));

/** Red for short events (0), blue for long ones (1), as in the paper. */
export function durationColor(t) {
  const x = 2 * clamp(t), [a, b] = x < 1 ? [SHORT, MIDDLE] : [MIDDLE, LONG], s = x < 1 ? x : x - 1;
  return rgbOfOklab(a.map((c, k) => c + s * (b[k] - c)));
}

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
