// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Time: what plays, how fast, and what the transport's controls show of it.

import { seconds } from "./format.js";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2];

export class Player {
  constructor(elements, scene, state) {
    Object.assign(this, { elements, scene, state });
    const { play, slider, speed } = elements;
    play.addEventListener("click", () => this.toggle());
    slider.max = `${scene.duration}`;
    slider.step = "any";
    slider.addEventListener("input", () => state.set({ time: Number(slider.value), playing: false }));
    for (const s of SPEEDS) speed.append(new Option(`${s}×`, `${s}`));
    speed.addEventListener("change", () => state.set({ speed: Number(speed.value) }));
    state.subscribe((changed) => this.show(changed));
    this.show(state.values);
  }

  show(changed) {
    const { play, slider, speed, clock } = this.elements, { time, playing } = this.state.values;
    if ("playing" in changed) {
      play.setAttribute("aria-label", playing ? "Pause" : "Play");
      play.dataset.playing = `${playing}`;
    }
    if ("speed" in changed) speed.value = `${this.state.values.speed}`;
    if ("time" in changed) {
      const frame = this.scene.frameAt(time);
      slider.value = `${time}`;
      slider.setAttribute("aria-valuetext", `${time.toFixed(2)} seconds, frame ${frame}`);
      clock.textContent = `${seconds(time)} · frame ${frame}`;
    }
  }

  toggle() {
    const { playing, time, loop } = this.state.values;
    if (!playing && !loop && time >= this.scene.duration) this.state.set({ time: 0 });
    this.state.set({ playing: !playing });
  }

  /** Goes on by whole frames. */
  step(frames) {
    const { scene } = this, next = scene.frameAt(this.state.values.time) + frames;
    const frame = scene.cyclic ? (next + scene.frames) % scene.frames : Math.min(Math.max(next, 0), scene.frames - 1);
    this.state.set({ time: frame * scene.frame_duration, playing: false });
  }

  faster(by) {
    const i = SPEEDS.indexOf(this.state.values.speed) + by;
    this.state.set({ speed: SPEEDS[Math.min(Math.max(i, 0), SPEEDS.length - 1)] });
  }

  /** Time passes by. */
  advance(elapsed) {
    const { playing, speed, time, loop } = this.state.values, end = this.scene.duration;
    if (!playing) return;
    const next = time + elapsed * speed;
    if (next <= end) this.state.set({ time: next });
    else if (loop) this.state.set({ time: end > 0 ? next % end : 0 });
    else this.state.set({ time: end, playing: false });
  }
}
