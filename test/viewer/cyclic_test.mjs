// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A cyclic animation in the viewer: time goes on across the end as anywhere else.

/** The page was written with --cyclic, from `frames` frames. */
export async function testCyclic({ open, check, near, set, state, cyclic, frames }) {
  const page = await open(`${cyclic}.html`);
  const { duration, d, seam, home, first, last } = await page.evaluate(() => {
    const { scene } = viewer, d = scene.frame_duration, v = 7;
    return {
      duration: scene.duration, d, seam: scene.vertexPlace(v, scene.duration - d / 4), home: scene.vertexPlace(v, scene.duration),
      first: scene.position(v, 0), last: scene.position(v, scene.kept_frames.length - 1),
    };
  });
  near(duration, frames * d, 1e-12, "it lasts as long as all of its frames");
  const size = Math.hypot(...first.map((x, c) => x - last[c]));
  check(size > 0, "the test's first frame is not its last one");
  for (let c = 0; c < 3; ++c) {
    near(seam[c], last[c] + 0.75 * (first[c] - last[c]), 1e-9 * (1 + size), "between the last frame and the first");
    near(home[c], first[c], 1e-12, "at the end it is where it began");
  }
  const centre = await page.evaluate(() => [0, viewer.scene.duration].map((t) => viewer.scene.centreAt(t)));
  near(Math.hypot(...centre[0].map((x, c) => x - centre[1][c])), 0, 1e-12, "so is what follows it");

  // features live on across the end
  const { spans, whole, opacities } = await page.evaluate(() => {
    const { scene } = viewer, d = scene.frame_duration, f = { time: d / 2, tau: 2 * d };
    return { spans: scene.spans(f), whole: scene.spans({ time: scene.duration / 2, tau: d }), opacities: [scene.opacity(f, scene.duration - d / 2), scene.opacity(f, 1.5 * d)] };
  });
  near(spans.reduce((sum, [from, to]) => sum + to - from, 0), 4 * d, 1e-9, `a feature at the beginning lives on at the end: ${JSON.stringify(spans)}`);
  check(spans.length === 2 && spans.some(([, to]) => Math.abs(to - duration) < 1e-12) && whole.length === 1, "in two parts, others in one");
  near(opacities[0], opacities[1], 1e-12, "as opaque before as after");

  // whole frames, and time that passes
  await set(page, { playing: false, time: (frames - 1) * d });
  await page.keyboard.press("ArrowRight");
  near((await state(page)).time, 0, 1e-12, "the first frame follows the last");
  await page.keyboard.press("ArrowLeft");
  near((await state(page)).time, (frames - 1) * d, 1e-9, "and the other way");
  await set(page, { time: duration - d / 2, loop: true });
  check((await page.locator("#clock").textContent()).includes("frame 0") || d < 1e-3, "half a frame before the end is the first frame's");
  await set(page, { speed: 1, playing: true });
  await page.waitForFunction((end) => viewer.state.values.time < end / 2, duration, { timeout: 20000 });
  check((await state(page)).playing, "it begins again");
  await page.context().close();
}
