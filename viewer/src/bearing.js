// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How one body stands against another one, whose coordinates are others: which of its axes points up, and by how much it is
// turned around that. Pairs of places on both tell it.

const FEWEST = 4; // pairs; with fewer, both are taken to stand alike
const LEAST_ANGLE = Math.PI / 10; // less comes from how bodies differ, and is taken for none

/** The same direction where another axis points up, y or z. */
export const upright = ([x, y, z], from, to) => (from === to ? [x, y, z] : from === "y" ? [x, -z, y] : [x, z, -y]);

/** A vector turned by an angle around an axis. */
function around(v, axis, angle) {
  const up = axis === "y" ? 1 : 2, [a, b] = up === 1 ? [2, 0] : [0, 1], result = [...v], c = Math.cos(angle), s = Math.sin(angle);
  result[a] = c * v[a] - s * v[b];
  result[b] = s * v[a] + c * v[b];
  return result;
}

const centred = (points) => {
  const middle = [0, 1, 2].map((c) => points.reduce((sum, p) => sum + p[c], 0) / points.length);
  return points.map((p) => p.map((x, c) => x - middle[c]));
};

/**
 * What brings directions at one body to another one, `from` and `to` being the axes that point up: the rotation around the
 * upright that brings places nearest to their partners. `agreement` tells how well, for the choice of an axis.
 */
function turnBetween(places, partners, from, to) {
  const up = to === "y" ? 1 : 2, [a, b] = up === 1 ? [2, 0] : [0, 1], q = centred(partners);
  let along = 0, across = 0, vertical = 0;
  centred(places).map((x) => upright(x, from, to)).forEach((p, i) => {
    along += p[a] * q[i][a] + p[b] * q[i][b];
    across += p[a] * q[i][b] - p[b] * q[i][a];
    vertical += p[up] * q[i][up];
  });
  const angle = Math.atan2(across, along);
  return { angle: Math.abs(angle) < LEAST_ANGLE ? 0 : angle, agreement: vertical + Math.hypot(along, across) };
}

export class Bearing {
  /** Places of the first body and their partners on the second one. */
  constructor(places, partners) {
    this.places = places;
    this.partners = partners;
  }

  /** The axis that points up at the second body; `own` is what it is by itself. */
  upOfSecond(upOfFirst, own) {
    if (this.places.length < FEWEST) return own;
    const agreement = (axis) => turnBetween(this.places, this.partners, upOfFirst, axis).agreement;
    return agreement("z") > agreement("y") ? "z" : "y";
  }

  angle(upOfFirst, upOfSecond) {
    return this.places.length < FEWEST ? 0 : turnBetween(this.places, this.partners, upOfFirst, upOfSecond).angle;
  }

  toSecond(direction, upOfFirst, upOfSecond) {
    return around(upright(direction, upOfFirst, upOfSecond), upOfSecond, this.angle(upOfFirst, upOfSecond));
  }

  toFirst(direction, upOfFirst, upOfSecond) {
    return upright(around(direction, upOfSecond, -this.angle(upOfFirst, upOfSecond)), upOfSecond, upOfFirst);
  }
}
