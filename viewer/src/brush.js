// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The brush: from the pointer to strokes that are under way, and to what the surface shows of them.

import { EdgeGraph } from "./geodesic.js";

const STEP = 0.25; // of the radius, between two places of the brush on a quick stroke, so that its edge is smooth
const LEAST_STEP = 3; // pixels
const MOST_STEPS = 64; // of them for each picture that is drawn

export class Brush {
  constructor(scene, state, stage, painting) {
    Object.assign(this, { scene, state, stage, painting });
    this.pointer = null; // where it hovers, in pixels of the canvas
    this.stroke = null; // that is under way: { id, path, isErasing, strokes, parts }
    this.isStale = true;
    state.subscribe((changed) => {
      if ("painting" in changed || "tool" in changed) this.cancel();
      if (state.values.painting && ["strokes", "time", "brush"].some((name) => name in changed)) this.isStale = true;
    });
    this.listen(stage.canvas);
  }

  get frame() {
    return this.scene.frameAt(this.state.values.time);
  }

  /** Of the mesh's unit. */
  get radius() {
    return this.state.values.brush * this.scene.bounding_box_diagonal;
  }

  /** Whether the pointer paints, and does not turn. */
  get isActive() {
    return this.state.values.painting && this.state.values.tool !== "turn";
  }

  /** Before the camera's controls, which then do not hear of strokes. */
  listen(canvas) {
    const on = (type, act) =>
      canvas.parentElement.addEventListener(type, (event) => {
        if (event.target === canvas && act(event)) event.stopPropagation();
      }, true);
    const at = ({ offsetX: x, offsetY: y }) => ({ x, y });
    on("pointerdown", (event) => {
      if (this.stroke) return true;
      if (!this.isActive || event.button !== 0 || !event.isPrimary) return false;
      if (!this.begin(event.pointerId, at(event))) return false;
      canvas.setPointerCapture(event.pointerId);
      return true;
    });
    on("pointermove", (event) => {
      this.pointer = event.pointerType === "touch" ? null : at(event);
      this.isStale ||= this.isActive;
      if (this.stroke?.id !== event.pointerId) return false;
      this.stroke.path.push(at(event));
      return true;
    });
    on("pointerup", (event) => {
      if (this.stroke?.id !== event.pointerId) return false;
      this.finish();
      return true;
    });
    on("pointercancel", () => this.cancel());
    canvas.addEventListener("pointerleave", () => {
      this.pointer = null;
      this.isStale = true;
    });
    on("dblclick", (event) => this.isActive && this.stage.surfaceAt(event.offsetX, event.offsetY) !== null);
  }

  /** Whether there is surface to begin on. */
  begin(id, place) {
    if (!this.stage.surfaceAt(place.x, place.y)) return false;
    const isErasing = this.state.values.tool === "erase";
    this.stroke = { id, path: [place], isErasing, strokes: this.painting.strokes, parts: [] };
    this.extend();
    return true;
  }

  /** Along the path of the pointer since the last time, on the surface as it is now. */
  extend() {
    const { stroke } = this;
    const [from, ...others] = stroke.path;
    const first = this.stage.surfaceAt(from.x, from.y), pixels = first ? this.stage.pixelsAt(first.distance) * this.radius : 0;
    const step = Math.max(STEP * pixels, LEAST_STEP);
    let places = [from], last = from;
    for (const to of others) {
      const steps = Math.ceil(Math.hypot(to.x - last.x, to.y - last.y) / step);
      for (let i = 1; i <= steps; ++i)
        places.push({ x: last.x + ((to.x - last.x) * i) / steps, y: last.y + ((to.y - last.y) * i) / steps });
      last = to;
    }
    const every = Math.ceil(places.length / MOST_STEPS);
    places = places.filter((_, i) => i % every === 0 || i === places.length - 1);
    stroke.path = [last];
    const vertices = new Set();
    for (const { x, y } of places) {
      const hit = this.stage.surfaceAt(x, y);
      if (hit) for (const v of this.reach(hit)) vertices.add(v);
    }
    this.isStale = true;
    if (stroke.isErasing) return this.erase(vertices);
    const part = this.part();
    for (const v of vertices) part.vertices.add(v);
  }

  reach(hit) {
    this.graph ??= new EdgeGraph(this.scene.faces, this.scene.rest);
    return this.graph.ball(hit, this.radius);
  }

  /**
   * What is painted now belongs to. While time stands still, it holds for as long as the painter wants; while time goes on,
   * for the frames that have passed, and if it has begun again, it is painted apart.
   */
  part() {
    const { parts } = this.stroke, { frame } = this, { playing, span } = this.state.values;
    const end = this.scene.frames - 1, now = parts.at(-1);
    if (playing && now?.isPlaying) {
      if (frame >= now.last) {
        now.last = frame;
        return now;
      }
      now.last = end;
      parts.push({ frame: 0, first: 0, last: frame, vertices: new Set(), isPlaying: true });
    } else if (playing) {
      parts.push({ frame, first: frame, last: frame, vertices: new Set(), isPlaying: true });
    } else if (now === undefined || now.isPlaying || now.frame !== frame) {
      const half = Math.floor(span / 2 / this.scene.frame_duration + 1e-6);
      parts.push({ frame, first: Math.max(frame - half, 0), last: Math.min(frame + half, end), vertices: new Set(), isPlaying: false });
    }
    return parts.at(-1);
  }

  /** From all strokes that are seen at the moment, in all of their frames. */
  erase(vertices) {
    const { stroke, frame } = this;
    const isHit = (s) => s.first <= frame && frame <= s.last && s.vertices.some((v) => vertices.has(v));
    if (!stroke.strokes.some(isHit)) return;
    stroke.strokes = stroke.strokes
      .map((s) => (isHit(s) ? { ...s, vertices: s.vertices.filter((v) => !vertices.has(v)) } : s))
      .filter((s) => s.vertices.length > 0);
  }

  finish() {
    this.extend();
    const { strokes, parts } = this.stroke;
    this.stroke = null;
    const painted = parts
      .filter(({ vertices }) => vertices.size > 0)
      .map(({ frame, first, last, vertices }) => ({ frame, first, last, vertices: [...vertices].sort((a, b) => a - b) }));
    if (painted.length > 0 || strokes !== this.painting.strokes) this.painting.change([...strokes, ...painted]);
  }

  cancel() {
    this.stroke = null;
    this.isStale = true;
  }

  /** The vertices that are painted in the frame that is shown. */
  painted() {
    const strokes = this.stroke ? [...this.stroke.strokes, ...this.stroke.parts] : this.painting.strokes, { frame } = this;
    const result = new Set();
    for (const { first, last, vertices } of strokes) if (first <= frame && frame <= last) for (const v of vertices) result.add(v);
    return result;
  }

  /** To be called in every animation frame, before it is drawn. */
  update() {
    if (this.stroke && (this.state.values.playing || this.stroke.path.length > 1)) this.extend();
    if (!this.isStale && !(this.isActive && this.pointer && this.stage.isStale)) return;
    this.isStale = false;
    const { painting } = this.state.values;
    const hit = this.isActive && this.pointer ? this.stage.surfaceAt(this.pointer.x, this.pointer.y) : null;
    this.stage.surface.setPaint(painting ? this.painted() : [], hit ? this.reach(hit) : []);
    this.stage.invalidate();
  }
}
