// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Painting in the viewer: what a brush marks is what lies under it, computed here from the files alone.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";

const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));
const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** What was written to BASE.obj and BASE.pc2. */
function readFiles(base) {
  const lines = readFileSync(`${base}.obj`, "utf8").split("\n").map((line) => line.split(/\s+/));
  const rest = lines.filter(([kind]) => kind === "v").map((words) => words.slice(1, 4).map(Number));
  const faces = lines.filter(([kind]) => kind === "f").map((words) => words.slice(1, 4).map((word) => parseInt(word, 10) - 1));
  const cache = readFileSync(`${base}.pc2`), n = cache.readInt32LE(16);
  const position = (v, f) => [0, 1, 2].map((c) => cache.readFloatLE(32 + 4 * (3 * (n * f + v) + c)));
  return { rest, faces, position };
}

/** Where the ray from the eye through a point of the canvas first meets the surface in a frame: triangle and shares. */
async function firstHit(page, files, frame, { x, y }) {
  const { world, inverse, centre, width, height } = await page.evaluate(() => {
    const { camera, canvas } = viewer.stage;
    camera.updateMatrixWorld();
    return { world: camera.matrixWorld.elements, inverse: camera.projectionMatrixInverse.elements, centre: viewer.scene.centre, width: canvas.clientWidth, height: canvas.clientHeight };
  });
  const times = (m, p) => {
    const q = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].reduce((sum, j) => sum + m[4 * j + i] * p[j], 0));
    return q.slice(0, 3).map((c) => c / q[3]).concat(1);
  };
  const onto = (p) => p.slice(0, 3).map((c, i) => c + centre[i]);
  const eye = onto(world.slice(12, 16)), far = onto(times(world, times(inverse, [(2 * x) / width - 1, 1 - (2 * y) / height, 0.5, 1])));
  const ray = minus(far, eye);
  let nearest = null;
  for (const face of files.faces) {
    // Cramer's rule for eye + t ray = a + u (b - a) + v (c - a)
    const [a, b, c] = face.map((v) => files.position(v, frame)), p = minus(b, a), q = minus(c, a), o = minus(eye, a);
    const h = cross(ray, q), k = cross(o, p), scale = dot(p, h);
    if (scale === 0) continue;
    const u = dot(o, h) / scale, v = dot(ray, k) / scale, t = dot(q, k) / scale;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && !(t >= nearest?.t)) nearest = { t, face, shares: [1 - u - v, u, v] };
  }
  return nearest;
}

/** The distance of each vertex from a point of a triangle at rest: to its corners, and along edges (Bellman and Ford). */
function distancesAtRest({ rest, faces }, { face, shares }) {
  const point = [0, 1, 2].map((c) => face.reduce((sum, v, i) => sum + shares[i] * rest[v][c], 0));
  const result = rest.map(() => Infinity);
  for (const v of face) result[v] = distance(rest[v], point);
  for (let hasChanged = true; hasChanged; ) {
    hasChanged = false;
    for (const face of faces)
      for (const v of face)
        for (const w of face) {
          const far = result[v] + distance(rest[v], rest[w]);
          if (far < result[w] - 1e-12) [result[w], hasChanged] = [far, true];
        }
  }
  return result;
}

const strokesOf = (page) => page.evaluate(() => viewer.state.values.strokes);
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
/** The vertices that the surface shows as painted. */
const shownPaint = (page) =>
  page.evaluate(() => {
    viewer.painter.update();
    return Array.from(viewer.stage.surface.paint.array).flatMap((x, i) => (i % 4 === 0 && x > 0 ? [i / 4] : []));
  });

/** Places of the canvas that show the surface, from the middle of the body outwards. */
const placesOnSurface = (page) =>
  page.evaluate(() => {
    const { clientWidth: width, clientHeight: height } = viewer.stage.canvas, places = [];
    for (let y = 80; y < height - 20; y += 20)
      for (let x = 80; x < width - 80; x += 20) if (viewer.stage.surfaceAt(x, y)) places.push({ x, y });
    const far = ({ x, y }) => Math.hypot(x - width / 2, y - height / 2);
    return places.sort((a, b) => far(a) - far(b));
  });

async function drag(page, places, { button = "left" } = {}) {
  const { x, y } = await page.locator("#canvas").boundingBox();
  await page.mouse.move(x + places[0].x, y + places[0].y);
  await page.mouse.down({ button });
  for (const place of places.slice(1)) await page.mouse.move(x + place.x, y + place.y, { steps: 4 });
  await page.mouse.up({ button });
}

export async function testPainting({ open, check, near, set, state, take, differentPixels, base, result }) {
  const page = await open(`${base}.html`);
  const files = readFiles(base), { frames, frame_duration: d, bounding_box_diagonal: diagonal } = result.animation;
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  const frame = 9;
  await set(page, { playing: false, time: frame * d, field: 0 });
  const field = (await state(page)).field;

  // ------------------------------------------------------------------------------------------------- the mode itself
  check(!(await page.locator("#painting").isVisible()), "painting is off at first");
  const before = await page.evaluate(() => viewer.stage.camera.position.toArray());
  await page.keyboard.press("b");
  check(await page.locator("#painting").isVisible(), "b begins to paint");
  check((await page.locator("#paint").getAttribute("aria-pressed")) === "true", "the button is pressed");
  await settled(page);
  const spheres = () => page.evaluate(() => {
    viewer.stage.draw(0, false);
    return viewer.stage.spheres.shown.length;
  });
  check((await spheres()) === 0 && (await state(page)).field === -1, "features and fields are hidden from painters");
  check(!(await page.locator("#rows").isVisible()) && !(await page.locator("#facts").textContent()).includes("feature"), "neither the table nor the number of features is shown");
  await page.locator("#features").check();
  check(await page.locator("#rows").isVisible(), "features can be shown");
  await set(page, { time: result.features[0].time });
  check((await spheres()) > 0, "their spheres too");
  await page.locator("#features").uncheck();
  check(await page.locator("#save-painting").isDisabled(), "there is nothing to save");

  // --------------------------------------------------------------------------------- a point: what lies under the brush
  await set(page, { time: frame * d, brush: 0.06, span: 4 * d });
  const places = await placesOnSurface(page);
  check(places.length > 20, `${places.length} places of the canvas show the surface`);
  let sizes = 0;
  for (const place of [places[0], places[Math.floor(places.length / 2)], places.at(-1)]) {
    await drag(page, [place]);
    const strokes = await strokesOf(page), stroke = strokes.at(-1), painted = new Set(stroke.vertices);
    const hit = await firstHit(page, files, frame, place), distances = distancesAtRest(files, hit);
    const radius = 0.06 * diagonal, slack = 1e-3 * diagonal, nearest = distances.indexOf(Math.min(...distances));
    const wrong = distances.flatMap((far, v) => (painted.has(v) !== far <= radius && Math.abs(far - radius) > slack && v !== nearest ? [v] : []));
    check(wrong.length === 0, `at ${place.x}, ${place.y}: wrong are the vertices ${wrong.slice(0, 9)} of ${painted.size}`);
    check(stroke.vertices.length === painted.size && stroke.vertices.every((v, i) => i === 0 || v > stroke.vertices[i - 1]), "vertices are in order, each once");
    check(stroke.frame === frame && stroke.first === frame - 2 && stroke.last === frame + 2, `frames ${stroke.first} to ${stroke.last} for ${frame}`);
    sizes += painted.size;
  }
  check(sizes > 15, `${sizes} vertices in three strokes`);
  const three = await strokesOf(page), union = [...new Set(three.flatMap((s) => s.vertices))].sort((a, b) => a - b);
  check(three.length === 3 && same(await shownPaint(page), union), "all are shown as painted");
  for (const [f, expected] of [[frame - 2, union], [frame + 2, union], [frame - 3, []], [frame + 3, []]]) {
    await set(page, { time: f * d });
    check(same(await shownPaint(page), expected), `frame ${f} shows ${(await shownPaint(page)).length} vertices, not ${expected.length}`);
  }
  await set(page, { time: frame * d, brush: 0.0001 });
  await drag(page, [places[0]]);
  const one = (await strokesOf(page)).at(-1).vertices, middle = distancesAtRest(files, await firstHit(page, files, frame, places[0]));
  check(one.length === 1 && middle[one[0]] < Math.min(...middle) + 1e-4 * diagonal, "the smallest brush takes the nearest vertex");
  await page.keyboard.press("z");
  near(distance(await page.evaluate(() => viewer.stage.camera.position.toArray()), before), 0, 1e-9 * diagonal, "painting does not turn");

  // ------------------------------------------------------------------------------------------------------- what is seen
  await set(page, { brush: 0.06, field });
  await page.mouse.move(5, 5);
  await take(page, "painted");
  await set(page, { strokes: [] });
  await take(page, "unpainted");
  const colored = await differentPixels(page, "painted", "unpainted", 60);
  check(colored > 200, `paint covers the field in ${colored} pixels`);
  await set(page, { strokes: three, field: -1 });

  // ---------------------------------------------------------------------------------------------- undo, redo, and erasing
  const press = async (key) => {
    await page.keyboard.press(key);
    return strokesOf(page);
  };
  check((await press("z")).length === 2 && (await press("Control+z")).length === 1, "z undoes");
  check((await press("y")).length === 2 && same(await press("Control+Shift+z"), three), "y does it again");
  await page.keyboard.press("2");
  check((await state(page)).tool === "erase" && (await page.locator("input[value=erase]").isChecked()), "2 erases");
  await drag(page, [places[0]]);
  const erased = await strokesOf(page), ball = new Set(three[0].vertices);
  check(same(erased, three.map((s) => ({ ...s, vertices: s.vertices.filter((v) => !ball.has(v)) })).filter((s) => s.vertices.length > 0)), "erased at the same place, a stroke is gone");
  check(!(await shownPaint(page)).some((v) => ball.has(v)), "and not shown");
  check(same(await press("z"), three), "erasing can be undone");
  await set(page, { time: (frame + 4) * d });
  await drag(page, [(await placesOnSurface(page))[0]]);
  check(same(await strokesOf(page), three), "what is not seen is not erased");

  // -------------------------------------------------------------------------------------------- a line, and turning
  await page.keyboard.press("1");
  await set(page, { time: frame * d });
  const line = [places[0], places.find((p) => p.y === places[0].y && p !== places[0]) ?? places[1]];
  await drag(page, line);
  const along = (await strokesOf(page)).at(-1).vertices;
  for (const place of line) {
    const far = distancesAtRest(files, await firstHit(page, files, frame, place));
    check(far.every((x, v) => x > 0.059 * diagonal || along.includes(v)), "a line paints its ends");
  }
  await page.keyboard.press("z");
  await page.keyboard.press("3");
  await drag(page, [places[0], { x: places[0].x + 90, y: places[0].y + 20 }]);
  await settled(page);
  check(same(await strokesOf(page), three) && distance(await page.evaluate(() => viewer.stage.camera.position.toArray()), before) > 1e-3, "3 turns");
  await page.keyboard.press("1");
  const turned = await page.evaluate(() => viewer.stage.camera.position.toArray());
  await drag(page, [places[0], { x: places[0].x + 90, y: places[0].y + 20 }], { button: "right" });
  await settled(page);
  check(same(await strokesOf(page), three) && distance(await page.evaluate(() => viewer.stage.camera.position.toArray()), turned) > 1e-3, "the right button turns");
  await page.keyboard.press("r");

  await testWhilePlaying({ page, check, set, state, frames, d });
  await set(page, { strokes: three });
  await testFiles({ page, open, check, near, set, base, result, three });

  await page.keyboard.press("b");
  check(!(await page.locator("#painting").isVisible()) && (await state(page)).features && (await state(page)).field === field, "done: features and field are back");
  check((await shownPaint(page)).length === 0, "done: no paint is shown");
  await page.context().close();
  await testTouch({ open, check, base });
}

/** With a finger, on a small screen. */
async function testTouch({ open, check, base }) {
  const page = await open(`${base}.html`, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.locator("#paint").tap();
  const [place] = await placesOnSurface(page), { x, y } = await page.locator("#canvas").boundingBox();
  await page.touchscreen.tap(x + place.x, y + place.y);
  await page.waitForFunction(() => viewer.state.values.strokes.length > 0, null, { timeout: 5000 }).catch(() => {});
  check((await strokesOf(page)).length === 1, "a finger paints");
  const outside = await page.evaluate(() =>
    [...document.querySelectorAll("#painting *, .tools *")]
      .filter((e) => e.offsetParent !== null && (e.getBoundingClientRect().right > innerWidth + 0.5 || e.getBoundingClientRect().left < -0.5))
      .map((e) => e.outerHTML.slice(0, 80)),
  );
  check(outside.length === 0 && (await page.locator("#save-painting").isVisible()), `narrow: outside of the window: ${outside}`);
  await page.context().close();
}

/** The frames that pass while the pointer is down; past the end, it begins again. */
async function testWhilePlaying({ page, check, set, state, frames, d }) {
  await set(page, { strokes: [], time: 2 * d, speed: 1, loop: true, playing: false });
  const [place] = await placesOnSurface(page), { x, y } = await page.locator("#canvas").boundingBox();
  const shownFrame = async () => Math.min(Math.round((await state(page)).time / d), frames - 1);
  // time goes on as the test wants
  const pass = (time) => page.evaluate((t) => {
    viewer.state.set({ time: t });
    viewer.painter.update();
  }, time);
  await page.evaluate(() => (viewer.player.advance = () => {}));
  await set(page, { playing: true });
  await page.mouse.move(x + place.x, y + place.y);
  await page.mouse.down();
  const first = await shownFrame();
  for (const f of [3.2, 5.4, 7]) await pass(f * d);
  await page.mouse.up();
  let strokes = await page.evaluate(() => viewer.state.values.strokes);
  check(strokes.length === 1 && strokes[0].first === first && strokes[0].last === 7 && strokes[0].frame === first, `painted from frame 2 to 7: ${JSON.stringify(strokes.map(({ first, last, frame }) => ({ first, last, frame })))}`);
  check(strokes[0].vertices.length > 0, "it has vertices");

  await pass((frames - 3) * d);
  const [other] = await placesOnSurface(page);
  await page.mouse.move(x + other.x, y + other.y);
  await page.mouse.down();
  for (const f of [frames - 2, 1, 2]) await pass(f * d);
  await page.mouse.up();
  strokes = await page.evaluate(() => viewer.state.values.strokes.slice(1).map(({ first, last }) => [first, last]));
  check(JSON.stringify(strokes) === JSON.stringify([[frames - 3, frames - 1], [0, 2]]), `past the end, it is painted apart: ${JSON.stringify(strokes)}`);
  await page.keyboard.press("z");
  check((await page.evaluate(() => viewer.state.values.strokes.length)) === 1, "and undone at once");
  await set(page, { playing: false });
  await page.evaluate(() => delete viewer.player.advance);
}

/** Saved, read by another page, refused where it does not belong, and read by evaluate_features. */
async function testFiles({ page, open, check, near, set, base, result, three }) {
  await page.locator("#save-painting").click();
  check((await page.locator("#painting-status").textContent()).startsWith("Who paints?"), "a painter has a name");
  await page.locator("#painter").fill("Anna b2");
  check((await page.evaluate(() => viewer.state.values.painting)), "letters in the name are no shortcuts");
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#save-painting").click()]);
  check(/^.*_painting_Anna_b2\.json$/.test(download.suggestedFilename()), `the file is ${download.suggestedFilename()}`);
  await download.saveAs("painting.json");
  const file = JSON.parse(readFileSync("painting.json", "utf8"));
  const { vertices, frames, frame_duration } = result.animation;
  check(file.format === "animated-mesh-features-painting" && file.version === 1 && file.painter === "Anna b2", "format, version and painter");
  check(file.animation.vertices === vertices && file.animation.frames === frames, "the animation");
  near(file.animation.frame_duration, frame_duration, 1e-9, "the duration of a frame");
  const expected = three.map(({ frame, first, last, vertices }) => ({ frame, frames: [first, last], vertices }));
  check(JSON.stringify(file.strokes) === JSON.stringify(expected), "the strokes are saved");

  const other = await open(`${base}.html`);
  await other.locator("#paint").click();
  const load = async (path) => {
    await other.locator("#painting-file").setInputFiles(path);
    await other.waitForFunction(() => document.getElementById("painting-status").textContent.includes(".json"));
    const text = await other.locator("#painting-status").textContent();
    await other.evaluate(() => (document.getElementById("painting-status").textContent = ""));
    return text;
  };
  check((await load("painting.json")).startsWith("Loaded"), "it is loaded again");
  check(JSON.stringify(await strokesOf(other)) === JSON.stringify(three), "with the same strokes");
  check((await other.locator("#painter").inputValue()) === "Anna b2", "and the painter");
  const faults = [
    ["{", "no JSON"], ["{}", "is no painting"], [{ ...file, version: 2 }, "version 2"],
    [{ ...file, animation: { ...file.animation, vertices: 7 } }, "another animation: 7 vertices"],
    [{ ...file, strokes: [{ frames: [3, 2], vertices: [] }] }, "strokes[0].frames"],
    [{ ...file, strokes: [{ frame: 4, frames: [1, 2], vertices: [] }] }, "strokes[0].frame is not within"],
    [{ ...file, strokes: [{ frames: [1, 2], vertices: [0, vertices] }] }, "strokes[0].vertices[1]"],
  ];
  for (const [content, message] of faults) {
    writeFileSync("faulty.json", typeof content === "string" ? content : JSON.stringify(content));
    const text = await load("faulty.json");
    check(text.includes(message), `a faulty file: "${text}" has no "${message}"`);
  }
  check(JSON.stringify(await strokesOf(other)) === JSON.stringify(three), "a faulty file changes nothing");
  await other.context().close();

  const evaluator = process.env.EVALUATE_FEATURES;
  if (!evaluator || !existsSync(evaluator)) return console.log("painting: evaluate_features is not here");
  execFileSync(evaluator, ["regions", `${base}.json`, `${base}.obj`, `${base}.pc2`, "--fps", "15", "--truth", "painting.json", "-o", "regions.json"], { stdio: "pipe" });
  check(JSON.parse(readFileSync("regions.json", "utf8")).painters === 1, "evaluate_features reads it");
}
