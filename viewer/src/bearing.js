// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How one body stands against another one, whose coordinates are others: which of its axes points up, and by how much it is
// turned around that. Pairs of places on both tell it.

const FEWEST = 4; // pairs; with fewer, both are taken to stand alike
const LEAST_ANGLE = Math.PI / 10; // less comes from how bodies differ, and is taken for none
const ERRORS = 3; // so many standard errors of the angle, too

/** The same direction where another axis points up, y or z. */
export const upright = ([x, y, z], from, to) => (from === to ? [x, y, z] : from === "y" ? [x, -z, y] : [x, z, -y]);

/** A vector turned by an angle around an axis. */
function around(v, axis, angle) {
  const up = axis === "y" ? 1 : 2, [a, b] = up === 1 ? [2, 0] : [0, 1], result = [...v], c = Math.cos(angle), s = Math.sin(angle);
  result[a] = c * v[a] - s * v[b];
  result[b] = s * v[a] + c * v[b];
  return result;
}

const KEPT = 3 / 4; // of the pairs; single ones join a foot to a head
const STEPS = 20;

const middle = (points) => [0, 1, 2].map((c) => points.reduce((sum, p) => sum + p[c], 0) / points.length);
const square = (v) => v.reduce((sum, x) => sum + x * x, 0);

/** Of the pairs `kept`, the rotation around the upright, and the scale, that bring places nearest to their partners. */
function fit(places, partners, kept, up) {
  const [a, b] = up === "y" ? [2, 0] : [0, 1], [o, m] = [places, partners].map((points) => middle(kept.map((k) => points[k])));
  const from = (points, origin) => points.map((x) => x.map((value, c) => value - origin[c]));
  const p = from(places, o), q = from(partners, m);
  let along = 0, across = 0, own = 0, other = 0, lever = 0;
  for (const k of kept) {
    along += p[k][a] * q[k][a] + p[k][b] * q[k][b];
    across += p[k][a] * q[k][b] - p[k][b] * q[k][a];
    own += square(p[k]);
    other += square(q[k]);
    lever += q[k][a] ** 2 + q[k][b] ** 2;
  }
  const angle = Math.atan2(across, along), scale = own > 0 ? Math.sqrt(other / own) : 1;
  const misses = p.map((x, k) => square(around(x, up, angle).map((value, c) => scale * value - q[k][c])));
  return { angle, misses, lever };
}

/**
 * What brings directions at one body to another one, `from` and `to` being the axes that point up: the rotation around the
 * upright that brings places nearest to their partners, but for a quarter of the pairs, those that fit least (least trimmed
 * squares by concentration, Rousseeuw and Van Driessen 2006). `miss`, the sum of squares that is left, is for the choice of
 * an axis. An angle that may be an error of few and rough pairs is none: its standard error is that of a coordinate over the
 * root of the sum of squares of horizontal distances.
 */
function turnBetween(places, partners, from, to) {
  const p = places.map((x) => upright(x, from, to)), all = [...places.keys()], fewer = Math.ceil(KEPT * all.length);
  let kept = all, found;
  for (let step = 0; step < STEPS; ++step) {
    found = fit(p, partners, kept, to);
    const { misses } = found, next = [...all].sort((i, k) => misses[i] - misses[k] || i - k).slice(0, fewer);
    const isSame = next.length === kept.length && next.every((k) => kept.includes(k));
    kept = next;
    if (isSame) break;
  }
  const miss = kept.reduce((sum, k) => sum + found.misses[k], 0);
  const unknowns = 5; // a place, an angle and a scale
  const error = Math.sqrt(miss / (3 * kept.length - unknowns) / found.lever);
  return { angle: Math.abs(found.angle) > Math.max(LEAST_ANGLE, ERRORS * error) ? found.angle : 0, miss };
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
    const miss = (axis) => turnBetween(this.places, this.partners, upOfFirst, axis).miss;
    return miss("z") < miss("y") ? "z" : "y";
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
