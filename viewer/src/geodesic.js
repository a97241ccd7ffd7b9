// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Lengths along the edges of the rest shape: what a brush reaches, and how far two vertices are apart.

/** A binary heap of vertices by distance. */
class Heap {
  constructor() {
    this.items = [];
  }

  push(distance, vertex) {
    const { items } = this;
    let i = items.push([distance, vertex]) - 1;
    while (i > 0) {
      const parent = (i - 1) >> 1;
      if (items[parent][0] <= items[i][0]) break;
      [items[parent], items[i]] = [items[i], items[parent]];
      i = parent;
    }
  }

  pop() {
    const { items } = this, top = items[0], last = items.pop();
    if (items.length === 0) return top;
    items[0] = last;
    for (let i = 0; ; ) {
      let child = 2 * i + 1;
      if (child + 1 < items.length && items[child + 1][0] < items[child][0]) ++child;
      if (child >= items.length || items[i][0] <= items[child][0]) return top;
      [items[child], items[i]] = [items[i], items[child]];
      i = child;
    }
  }
}

export class EdgeGraph {
  /** `faces`: three vertices for each triangle; `points`: three coordinates for each vertex. Linear in both. */
  constructor(faces, points) {
    this.points = points;
    const n = points.length / 3;
    this.starts = new Uint32Array(n + 1);
    for (const v of faces) this.starts[v + 1] += 2;
    for (let v = 0; v < n; ++v) this.starts[v + 1] += this.starts[v];
    // an edge of two triangles is there twice, which does no harm
    this.ends = new Uint32Array(2 * faces.length);
    const next = this.starts.slice(0, n);
    for (let i = 0; i < faces.length; i += 3)
      for (let j = 0; j < 3; ++j) {
        const v = faces[i + j];
        this.ends[next[v]++] = faces[i + ((j + 1) % 3)];
        this.ends[next[v]++] = faces[i + ((j + 2) % 3)];
      }
  }

  length(v, w) {
    const { points } = this;
    return Math.hypot(points[3 * v] - points[3 * w], points[3 * v + 1] - points[3 * w + 1], points[3 * v + 2] - points[3 * w + 2]);
  }

  /**
   * The vertices that are not farther than `radius` from a point of a triangle: straight to its corners, from there along
   * edges. The nearest corner is among them, however small the radius. Local: B log B for B vertices.
   */
  ball({ triangle, barycentric }, radius) {
    const { points } = this, heap = new Heap(), done = new Set();
    const point = [0, 1, 2].map((c) => triangle.reduce((sum, v, i) => sum + barycentric[i] * points[3 * v + c], 0));
    for (const v of triangle) heap.push(Math.hypot(...point.map((x, c) => x - points[3 * v + c])), v);
    while (heap.items.length > 0) {
      const [distance, v] = heap.pop();
      if (distance > radius && done.size > 0) break;
      if (done.has(v)) continue;
      done.add(v);
      for (let i = this.starts[v]; i < this.starts[v + 1]; ++i) {
        const w = this.ends[i], far = distance + this.length(v, w);
        if (far <= radius && !done.has(w)) heap.push(far, w);
      }
    }
    return done;
  }

  /** The length of the shortest path between two vertices, Infinity if there is none. At most N log N. */
  distance(from, to) {
    const heap = new Heap(), done = new Uint8Array(this.points.length / 3);
    heap.push(0, from);
    while (heap.items.length > 0) {
      const [distance, v] = heap.pop();
      if (v === to) return distance;
      if (done[v]) continue;
      done[v] = 1;
      for (let i = this.starts[v]; i < this.starts[v + 1]; ++i) {
        const w = this.ends[i];
        if (!done[w]) heap.push(distance + this.length(v, w), w);
      }
    }
    return Infinity;
  }
}
