// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is painted: strokes, the way back to what was painted before, and the file that they are saved in.

const FORMAT = "animated-mesh-features-painting", VERSION = 1;
const TIME_TOLERANCE = 1e-6; // of a frame, which files round

/**
 * Strokes are { frame, first, last, vertices }: painted in `frame`, they hold from frame `first` to `last`, themselves
 * included. Strokes and lists of them are never changed once they are here, so that going back is to take an older list.
 */
export class Painting {
  constructor(scene, state) {
    Object.assign(this, { scene, state, undone: [], done: [], saved: state.values.strokes });
  }

  get strokes() {
    return this.state.values.strokes;
  }

  /** Something new is painted, erased or loaded. */
  change(strokes) {
    this.done.push(this.strokes);
    this.undone = [];
    this.state.set({ strokes });
  }

  undo() {
    if (this.done.length === 0) return;
    this.undone.push(this.strokes);
    this.state.set({ strokes: this.done.pop() });
  }

  redo() {
    if (this.undone.length === 0) return;
    this.done.push(this.strokes);
    this.state.set({ strokes: this.undone.pop() });
  }

  get isSaved() {
    return this.strokes === this.saved || this.strokes.length === 0;
  }

  /** The text of the file. */
  text(painter) {
    const { vertices, frames, frame_duration } = this.scene;
    const head = { format: FORMAT, version: VERSION, animation: { vertices, frames, frame_duration }, painter };
    const strokes = this.strokes.map(({ frame, first, last, vertices }) => JSON.stringify({ frame, frames: [first, last], vertices }));
    return `${JSON.stringify(head).slice(0, -1)},\n"strokes":[\n${strokes.join(",\n")}]}\n`;
  }

  /** Takes the strokes of a file in place of those that are here; gives the painter. Throws an Error that says what is wrong. */
  load(text) {
    const { painter, strokes } = readPainting(text, this.scene);
    this.change(strokes);
    this.saved = this.strokes;
    return painter;
  }
}

function expect(condition, what) {
  if (!condition) throw new Error(what);
}

function parsed(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(`This is no JSON file: ${error.message}`);
  }
}

/** What a file says, or an Error. */
export function readPainting(text, scene) {
  const file = parsed(text);
  expect(file?.format === FORMAT, `This is no painting: it has no "format": "${FORMAT}".`);
  expect(file.version === VERSION, `This painting has version ${file.version} of the format; known is ${VERSION} only.`);
  const { vertices, frames, frame_duration } = file.animation ?? {};
  expect(
    vertices === scene.vertices && frames === scene.frames && Math.abs(frame_duration - scene.frame_duration) <= TIME_TOLERANCE * scene.frame_duration,
    `This was painted on another animation: ${vertices} vertices, ${frames} frames of ${frame_duration} s; here are ${scene.vertices} vertices, ${scene.frames} frames of ${scene.frame_duration} s.`,
  );
  expect(typeof file.painter === "string", "The painting does not say who painted it.");
  expect(Array.isArray(file.strokes), "The painting has no strokes.");
  return { painter: file.painter, strokes: file.strokes.map((stroke, i) => readStroke(stroke, `strokes[${i}]`, scene)) };
}

function readStroke(stroke, name, scene) {
  const isIndex = (x, n) => Number.isInteger(x) && x >= 0 && x < n;
  const [first, last, ...more] = Array.isArray(stroke?.frames) ? stroke.frames : [];
  expect(isIndex(first, scene.frames) && isIndex(last, scene.frames) && first <= last && more.length === 0, `${name}.frames: the first and the last frame are expected.`);
  const frame = stroke.frame ?? first;
  expect(isIndex(frame, scene.frames) && first <= frame && frame <= last, `${name}.frame is not within frames.`);
  expect(Array.isArray(stroke.vertices), `${name} has no vertices.`);
  const bad = stroke.vertices.findIndex((v) => !isIndex(v, scene.vertices));
  expect(bad < 0, `${name}.vertices[${bad}] is not a vertex of the animation.`);
  return { frame, first, last, vertices: stroke.vertices };
}
