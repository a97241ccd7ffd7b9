// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Two animations in one page: PAIR.html and PAIR.json were written by the same run of compare_animations.

import { readFileSync } from "node:fs";

export async function testPair({ open, check, near, set, state, pair }) {
  const page = await open(`${pair}.html`), { a, b, matches, alignment } = JSON.parse(readFileSync(`${pair}.json`, "utf8"));
  check(matches.length >= 5, `${matches.length} pairs are enough to test with`);
  const second = () => page.evaluate(() => viewer.companion.state.values);
  const sizes = await page.evaluate(() => [viewer.scene, viewer.companion.scene].map(({ vertices, frames }) => [vertices, frames]));
  check(JSON.stringify(sizes) === JSON.stringify([[a.vertices, a.frames], [b.vertices, b.frames]]), `two scenes: ${JSON.stringify(sizes)}`);
  check((await page.title()).includes(`${a.name} and ${b.name}`), "both names are told");

  // one slider, two times
  for (const k of [0, Math.floor(alignment.times_a.length / 2), alignment.times_a.length - 1]) {
    await page.locator("#time").evaluate((element, time) => {
      element.value = `${time}`;
      element.dispatchEvent(new Event("input"));
    }, alignment.times_a[k]);
    const end = (b.frames - 1) * b.frame_duration;
    near((await second()).time, Math.min(alignment.times_b[k], end), 1e-3, `the time of the second animation at ${alignment.times_a[k]} s`);
  }

  // pairs have a number and a colour of their own, in both scenes
  const features = await page.evaluate(() => [viewer.scene, viewer.companion.scene].map((scene) => scene.features.map(({ rank, label, color, pair }) => ({ rank, label, color: `${color}`, pair }))));
  matches.forEach((match, i) => {
    const f = features[0][match.a], g = features[1][match.b];
    check(f.label === `${i + 1}` && g.label === f.label && f.color === g.color, `pair ${i + 1}: ${JSON.stringify(f)} and ${JSON.stringify(g)}`);
  });
  check(new Set(matches.map((match) => features[0][match.a].color)).size === matches.length, "no two pairs have the same colour");
  for (const [list, side] of [[features[0], "a"], [features[1], "b"]]) {
    const rest = list.filter((_, i) => !matches.some((match) => match[side] === i));
    check(rest.every(({ label, pair }) => label === "×" && pair === null), `${rest.length} features of ${side} are marked as those without partner`);
  }

  // the partner is selected, too, whoever is clicked
  const { a: i, b: j } = matches[0];
  await page.locator(`#rows tr[data-index="${i}"]`).click();
  check((await second()).selected === j, `the partner of feature ${i} is selected: ${(await second()).selected}, not ${j}`);
  // a click on the other surface, on the first partner that the body does not hide when its own feature is shown
  let at;
  for (const match of matches) {
    await page.locator(`#rows tr[data-index="${match.a}"]`).click();
    await set(page, { selected: -1 });
    at = await page.evaluate((k) => {
      const { stage, scene } = viewer.companion;
      stage.draw(0, false);
      const { x, y } = stage.project(scene.features[k]);
      return { x, y, hit: stage.featureAt(x, y) };
    }, match.b);
    if (at.hit >= 0) break;
  }
  await page.locator("#canvas-b").click({ position: { x: at.x, y: at.y } });
  const hit = matches.find((match) => match.b === at.hit);
  check(at.hit >= 0 && (await second()).selected === at.hit && (await state(page)).selected === (hit?.a ?? -1), `a click on the second surface selects ${at.hit} and its partner`);
  await page.keyboard.press("Escape");
  check((await second()).selected === -1 && (await state(page)).selected === -1, "nothing is selected any more");
  await page.locator("#unmatched").uncheck();
  const shown = [(await state(page)).shown, (await second()).shown].map((list) => list.filter(Boolean).length);
  check(shown.every((n) => n === matches.length), `only pairs are shown: ${shown}, ${matches.length}`);

  // both cameras go together, whichever is turned
  const views = () => page.evaluate(() => [viewer.stage, viewer.companion.stage].map((stage) => { const { direction, moved, distance } = stage.relativeView(); return [...direction, ...moved, distance]; }));
  const before = await views();
  for (const turn of [() => viewer.stage.turn(0.7, 0.2), () => viewer.companion.stage.turn(-0.3, 0.1), () => viewer.companion.stage.zoom(0.8)]) {
    const from = await views();
    await page.evaluate(turn);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const [first, other] = await views();
    check(first.every((x, k) => Math.abs(x - other[k]) < 1e-4), `the views are the same: ${first} and ${other}`);
    check(first.some((x, k) => Math.abs(x - from[0][k]) > 0.05), "they have changed");
  }
  await page.keyboard.press("r");
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  check((await views()).every((view) => view.every((x, k) => Math.abs(x - before[0][k]) < 1e-4)), "both show the whole body again");
  // another body: twice as large, turned, with another axis upright; of nine pairs two are wrong
  const bearing = await page.evaluate(() => {
    const places = [...Array(9).keys()].map((i) => [Math.sin(3 * i), Math.cos(5 * i + 1), Math.sin(7 * i + 2)]), angle = 1.7;
    const there = ([x, y, z]) => [Math.cos(angle) * x - Math.sin(angle) * y, z, -Math.sin(angle) * x - Math.cos(angle) * y];
    const partners = places.map((place) => there(place).map((x) => 2 * x));
    partners.splice(3, 2, [9, 9, 9], [-8, 5, 0]);
    const found = new viewer.companion.bearing.constructor(places, partners), up = found.upOfSecond("z", "z");
    return { up, direction: found.toSecond([0.6, 0, 0.8], "z", up), expected: there([0.6, 0, 0.8]), back: found.toFirst(there([0.6, 0, 0.8]), "z", up) };
  });
  check(bearing.up === "y", "the other axis points up");
  bearing.expected.forEach((x, k) => near(bearing.direction[k], x, 1e-9, "a direction at the other body, whatever two of the pairs say"));
  [0.6, 0, 0.8].forEach((x, k) => near(bearing.back[k], x, 1e-9, "and back"));
  await page.screenshot({ path: "pair.png" });
  const [inner, outer] = await page.evaluate(() => [viewer.companion.stage.canvas, document.querySelector(".stage")].map((element) => element.clientWidth));
  check(inner > 0.4 * outer && inner < 0.6 * outer, `the second view is ${inner} of ${outer} pixels wide`);
  await page.context().close();
}

/** Two loops: LOOPS.html and LOOPS.json were written by the same run of compare_animations. */
export async function testLoops({ open, check, near, set, loops }) {
  const page = await open(`${loops}.html`), { a, b, alignment } = JSON.parse(readFileSync(`${loops}.json`, "utf8"));
  check(a.cyclic && b.cyclic && a.frames !== b.frames, `two loops: ${JSON.stringify([a, b])}`);
  near(alignment.loops[1], b.frames * b.frame_duration, 1e-9, "as long as all frames of the second one");
  const within = (time, period) => time - Math.floor(time / period) * period;
  // once around the first one, which may be played several times beside the second one
  const once = alignment.times_a.filter((time) => time < alignment.times_a[0] + alignment.loops[0]).length;
  check(once > 10, `${once} samples of the map`);
  for (let k = 0; k < once; k += 3) {
    await set(page, { time: within(alignment.times_a[k], alignment.loops[0]) });
    const time = await page.evaluate(() => viewer.companion.state.values.time), late = time - alignment.times_b[k];
    check(time >= 0 && time <= alignment.loops[1], `a time of the second loop: ${time}`);
    near(late - Math.round(late / alignment.loops[1]) * alignment.loops[1], 0, 1e-3, `the time of the second loop at ${alignment.times_a[k]} s`);
  }
  // all of its features are along the axis of the first one, those that live across its end on both sides
  const { xs, ends } = await page.evaluate(() => {
    const { timeline, scene } = viewer.companion;
    return { xs: scene.features.map((f) => timeline.x(f.time)), ends: [0, viewer.scene.duration].map((t) => timeline.along(t)) };
  });
  check(xs.length > 3 && xs.every((x) => x >= ends[0] && x <= ends[1]), `${xs} from ${ends[0]} to ${ends[1]}`);
  check((await page.locator("#missed").textContent()) === "", "nothing of a loop is before or after");
  await page.screenshot({ path: "loops.png" });
  await page.context().close();
}
