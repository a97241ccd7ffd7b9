// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers as people read them.

const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Three significant digits, or as many as are asked for; powers of ten only for what is very small or large. */
export function short(x, digits = 3) {
  if (!Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e-3 && size < 1e5) {
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    return x.toFixed(Math.min(decimals, 8)).replace("-", "−");
  }
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  const power = exponent.replace("+", "").replace("-", "⁻").replace(/\d/g, (d) => SUPERSCRIPTS[d]);
  return `${mantissa.replace("-", "−")}·10${power}`;
}

/** Of two animations: which pair a feature is of. Nothing on the page of a single one. */
export const pairText = ({ pair }) => (pair === undefined ? "" : pair === null ? "Without a partner. " : `Pair ${pair}. `);

export const seconds = (x) => `${x.toFixed(3)} s`;

export const count = (n, singular, plural = `${singular}s`) => `${n.toLocaleString("en")} ${n === 1 ? singular : plural}`;
