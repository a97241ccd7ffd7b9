// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The scene in the page: what it says, and its numbers decoded. The encoding is described in programs/page/write_html.h.

import { inflate } from "./inflate.js";

function bytesOfBase64(text) {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

async function decompressed(bytes, size) {
  if (typeof DecompressionStream === "undefined") return inflate(bytes, size);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const result = new Uint8Array(await new Response(stream).arrayBuffer());
  if (result.length !== size) throw new Error(`damaged data: ${result.length} bytes, not ${size}`);
  return result;
}

/** Numbers of `width` bytes from planes of bytes, with their signs unfolded (0, -1, 1, -2, ...). */
function numbersOfPlanes(planes, width) {
  const n = planes.length / width;
  const numbers = new Int32Array(n);
  for (let b = 0; b < width; ++b)
    for (let i = 0, from = b * n; i < n; ++i) numbers[i] |= planes[from + i] << (8 * b);
  for (let i = 0; i < n; ++i) numbers[i] = (numbers[i] >>> 1) ^ -(numbers[i] & 1);
  return numbers;
}

/** Whole numbers that are written as differences, each from the one before. */
function summed(planes) {
  const numbers = Uint32Array.from(numbersOfPlanes(planes, 4));
  for (let i = 1; i < numbers.length; ++i) numbers[i] += numbers[i - 1];
  return numbers;
}

/** For each vertex the neighbour from which it is predicted. */
function parentsOf(faces, n) {
  const parents = new Int32Array(n).fill(-1);
  const offer = (v, w) => {
    if (w < v && w > parents[v]) parents[v] = w;
  };
  for (let i = 0; i < faces.length; i += 3) {
    const a = faces[i], b = faces[i + 1], c = faces[i + 2];
    offer(a, b);
    offer(a, c);
    offer(b, a);
    offer(b, c);
    offer(c, a);
    offer(c, b);
  }
  for (let v = 1; v < n; ++v) if (parents[v] < 0) parents[v] = v - 1;
  return parents;
}

/**
 * Adds the prediction to the residuals of a frame, which start at `from`, and puts the numbers into every `stride`-th
 * element of `now`, from `first` on. `before` is the frame before, or null.
 */
function addPrediction(residuals, from, parents, mask, before, now, stride, first) {
  for (let v = 0; v < parents.length; ++v) {
    const i = stride * v + first;
    let number = residuals[from + v];
    if (before !== null) number += before[i];
    if (v > 0) {
      const p = stride * parents[v] + first;
      number += now[p];
      if (before !== null) number -= before[p];
    }
    now[i] = number & mask;
  }
}

/** The standard deviation of the smoothing of the body's way, seconds. */
const FOLLOWING = 0.2;

/** An array of four 16-bit numbers a vertex for each frame: three coordinates, and room for the value of a field. */
export const VERTEX_STRIDE = 4;

/**
 * What is shown: the description, and
 * - `faces`: three vertices for each triangle,
 * - `rest`: three coordinates of each vertex in the rest shape, up to where that is in space,
 * - `positions[k]`: the grid numbers in the k-th kept frame, VERTEX_STRIDE for each vertex,
 * - `fields[i].values[k]`: 0 to 255 for each vertex; `value()` tells what that is,
 * - `features[i].on`: the place of a feature on the page's surface, which may have fewer vertices than the file's.
 */
export class Scene {
  /** The scene whose scripts have ids that begin with `name`. */
  static async read(document, name = "scene") {
    const text = (id) => {
      const element = document.getElementById(id);
      if (element === null) throw new Error("This page has no scene in it. It is made by: detect_features --html FILE");
      return element.textContent;
    };
    const scene = new Scene();
    Object.assign(scene, JSON.parse(text(name)));
    scene.features.forEach((f, i) => {
      f.rank ??= i + 1;
      f.label = `${f.rank}`; // on its sphere
      f.on = scene.places?.[i] ?? { triangle: f.triangle, barycentric_coordinates: f.barycentric_coordinates };
    });
    for (const field of scene.fields) field.top_level ??= 255;
    const bytes = (id, size) => decompressed(bytesOfBase64(text(id)), size);

    const n = scene.vertices, kept = scene.kept_frames.length;
    const faceBytes = bytes(`${name}-faces`, 12 * scene.faces);
    const positionBytes = bytes(`${name}-positions`, 6 * n * kept);
    const restBytes = bytes(`${name}-rest`, 6 * n);
    const fieldBytes = scene.fields.map((_, i) => bytes(`${name}-field-${i}`, n * kept));

    scene.isThinned = scene.all_vertices !== undefined;
    scene.all_vertices ??= n;
    scene.all_faces ??= scene.faces;
    if (scene.isThinned) scene.names = summed(await bytes(`${name}-vertices`, 4 * n));
    scene.faces = summed(await faceBytes);
    const parents = parentsOf(scene.faces, n);
    const residuals = numbersOfPlanes(await positionBytes, 2);
    scene.positions = [];
    for (let k = 0; k < kept; ++k) {
      const now = new Uint16Array(VERTEX_STRIDE * n);
      for (let c = 0; c < 3; ++c)
        addPrediction(residuals, (3 * k + c) * n, parents, 0xffff, scene.positions[k - 1] ?? null, now, VERTEX_STRIDE, c);
      scene.positions.push(now);
    }
    const restResiduals = numbersOfPlanes(await restBytes, 2), rest = new Uint16Array(3 * n);
    for (let c = 0; c < 3; ++c) addPrediction(restResiduals, c * n, parents, 0xffff, null, rest, 3, c);
    scene.rest = Float32Array.from(rest, (x) => scene.rest_step * x);
    for (let i = 0; i < scene.fields.length; ++i) {
      const field = scene.fields[i];
      const fieldResiduals = numbersOfPlanes(await fieldBytes[i], 1);
      field.values = [];
      for (let k = 0; k < kept; ++k) {
        const now = new Uint8Array(n);
        addPrediction(fieldResiduals, k * n, parents, 0xff, field.values[k - 1] ?? null, now, 1, 0);
        field.values.push(now);
      }
    }
    scene.prepare();
    return scene;
  }

  prepare() {
    // A cyclic animation goes on from the last frame to the first, which is as long as from any other to the next.
    this.duration = (this.cyclic ? this.frames : this.frames - 1) * this.frame_duration;
    // Lengths are measured from the centre of the whole animation: graphics cards count in single precision only.
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    this.boxes = this.positions.map((numbers, k) => {
      const min = [65535, 65535, 65535], max = [0, 0, 0];
      for (let i = 0; i < numbers.length; i += VERTEX_STRIDE)
        for (let c = 0; c < 3; ++c) {
          if (numbers[i + c] < min[c]) min[c] = numbers[i + c];
          if (numbers[i + c] > max[c]) max[c] = numbers[i + c];
        }
      for (let c = 0; c < 3; ++c) {
        min[c] = this.origin[c] + this.step * (this.corners[k][c] + min[c]);
        max[c] = this.origin[c] + this.step * (this.corners[k][c] + max[c]);
        low[c] = Math.min(low[c], min[c]);
        high[c] = Math.max(high[c], max[c]);
      }
      return { min, max };
    });
    this.box = { min: low, max: high };
    this.centre = low.map((x, c) => (x + high[c]) / 2);
    this.centres = this.smoothCentres();
  }

  /**
   * Where the body is in each kept frame: the mean of its vertices, in the coordinates of the stage, smoothed in time, so
   * that what follows it does not tremble with each step.
   */
  smoothCentres() {
    const means = this.positions.map((numbers, k) => {
      const sum = [0, 0, 0];
      for (let i = 0; i < numbers.length; i += VERTEX_STRIDE) for (let c = 0; c < 3; ++c) sum[c] += numbers[i + c];
      return this.offset(k).map((x, c) => x + (this.step * sum[c]) / this.vertices);
    });
    // in a cyclic animation of those before the first frame and after the last, too
    const n = means.length, rank = (j) => (this.cyclic ? j - n * Math.floor(j / n) : j);
    const time = (j) => this.kept_frames[rank(j)] * this.frame_duration + Math.floor(j / n) * this.duration;
    return means.map((_, k) => {
      const total = [0, 0, 0];
      let weights = 0;
      for (const by of [-1, 1])
        for (let j = by > 0 ? k : k - 1; means[rank(j)] !== undefined && Math.abs(time(j) - time(k)) <= 3 * FOLLOWING; j += by) {
          const weight = Math.exp(-0.5 * ((time(j) - time(k)) / FOLLOWING) ** 2);
          weights += weight;
          for (let c = 0; c < 3; ++c) total[c] += weight * means[rank(j)][c];
        }
      return total.map((x) => x / weights);
    });
  }

  /** The smoothed centre at a time. */
  centreAt(time) {
    const { from, to, share } = this.interval(time);
    return this.centres[from].map((x, c) => x + share * (this.centres[to][c] - x));
  }

  /** The value of a field at vertex `v` in the k-th kept frame. */
  value(field, v, k) {
    const level = field.values[k][v], { min, max, largest, top_level: top } = field;
    return level <= top ? min + (level / top) * (max - min) : max + ((level - top) / (255 - top)) * (largest - max);
  }

  /** The same at a time, linear between frames. */
  valueAt(field, v, time) {
    const { from, to, share } = this.interval(time), a = this.value(field, v, from);
    return a + share * (this.value(field, v, to) - a);
  }

  /** A point of a triangle in the rest shape; three coordinates, up to where that is in space. */
  restPoint(triangle, barycentric) {
    return [0, 1, 2].map((c) => triangle.reduce((sum, v, i) => sum + barycentric[i] * this.rest[3 * v + c], 0));
  }

  /** What a vertex of the page is called in the file. */
  vertexName(v) {
    return this.names?.[v] ?? v;
  }

  /** The vertex of the page that has a number in the file, or -1. */
  vertexOf(name) {
    if (!Number.isInteger(name) || name < 0 || name >= this.all_vertices) return -1;
    if (!this.names) return name;
    let low = 0, high = this.names.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.names[middle] < name) low = middle + 1;
      else high = middle;
    }
    return this.names[low] === name ? low : -1;
  }

  /** The vertex of a feature, or the nearest one that is on the page. */
  vertexOfFeature(f) {
    const v = this.vertexOf(f.vertex), { triangle, barycentric_coordinates: weights } = f.on;
    return v >= 0 ? v : triangle[weights.indexOf(Math.max(...weights))];
  }

  /** Where a vertex is at a time, in the input's coordinates. */
  vertexPlace(v, time) {
    return this.placeOn({ triangle: [v, v, v], barycentric_coordinates: [1, 0, 0] }, time);
  }

  /** What has to be added to the step times a number of the k-th kept frame, measured from the centre. */
  offset(k) {
    return this.corners[k].map((corner, c) => this.origin[c] - this.centre[c] + this.step * corner);
  }

  /** The frame that is nearest to a time. */
  frameAt(time) {
    const frame = Math.max(Math.round(time / this.frame_duration), 0);
    return this.cyclic ? frame % this.frames : Math.min(frame, this.frames - 1);
  }

  /** From one time to another; in a cyclic animation the shorter way round. */
  timeBetween(a, b) {
    const away = Math.abs(a - b);
    return this.cyclic ? Math.min(away, this.duration - away) : away;
  }

  /** When a feature lives, [from, to] of what there is of the time; in a cyclic animation perhaps at both ends of it. */
  spans({ time, tau }) {
    const ends = [time - tau, time + tau], { duration } = this, clipped = ([from, to]) => [Math.max(from, 0), Math.min(to, duration)];
    if (!this.cyclic) return [clipped(ends)];
    return [0, -duration, duration].map((shift) => clipped(ends.map((t) => t + shift))).filter(([from, to]) => from < to);
  }

  /** The kept frames around a time, and how far it is from the first to the second one. */
  interval(time) {
    const frame = Math.min(Math.max(time, 0), this.duration) / this.frame_duration;
    const last = this.kept_frames.length - 1, before = this.kept_frames[last];
    if (this.cyclic && frame > before) return { from: last, to: 0, share: (frame - before) / (this.frames - before) };
    const k = last > 0 ? Math.min(Math.floor(frame / this.kept_frames[1]), last - 1) : 0;
    const from = this.kept_frames[k], to = this.kept_frames[Math.min(k + 1, last)];
    return { from: k, to: Math.min(k + 1, last), share: to > from ? Math.min((frame - from) / (to - from), 1) : 0 };
  }

  /** The position of vertex `v` in the k-th kept frame, in the input's coordinates. */
  position(v, k) {
    const i = VERTEX_STRIDE * v;
    return [0, 1, 2].map((c) => this.origin[c] + this.step * (this.corners[k][c] + this.positions[k][i + c]));
  }

  /** The place of a feature on the surface at a time, in the input's coordinates. */
  place(feature, time) {
    return this.placeOn(feature.on, time);
  }

  placeOn({ triangle, barycentric_coordinates: weights }, time) {
    const { from, to, share } = this.interval(time);
    const place = [0, 0, 0];
    triangle.forEach((v, i) => {
      const a = this.position(v, from), b = this.position(v, to);
      for (let c = 0; c < 3; ++c) place[c] += weights[i] * (a[c] + share * (b[c] - a[c]));
    });
    return place;
  }

  /** How much of a feature is seen at a time, from 0 to 1. In a cyclic animation it lives on across the end. */
  opacity(feature, time) {
    const distance = this.timeBetween(time, feature.time) / feature.tau;
    return distance <= 2 ? Math.exp((-distance * distance) / 2) : 0;
  }
}
