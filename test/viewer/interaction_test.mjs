// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a reader does with the page: curves of vertices, the table sorted, bounded, grouped and saved, the address, measuring,
// the keyboard alone; and whether axe-core finds anything that would keep somebody out. Called by browser_test.mjs.

import { createRequire } from "node:module";
import { readFileSync } from "node:fs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const COLUMNS = { rank: 1, place: 1, time: 1, strength: -1, amplitude: -1, fit: -1, sigma: -1, tau: -1, vertex: 1 }; // how each is sorted first

/** A matrix of float32 or float64 in NumPy's format, by rows. */
function readNpy(path) {
  const bytes = readFileSync(path), start = 10 + bytes.readUInt16LE(8), header = bytes.subarray(10, start).toString("latin1");
  const [, type] = /'descr': '<f([48])'/.exec(header), [, rows, columns] = /'shape': \((\d+), (\d+)\)/.exec(header).map(Number);
  const width = Number(type), value = (i) => (width === 4 ? bytes.readFloatLE(start + 4 * i) : bytes.readDoubleLE(start + 8 * i));
  if (/'fortran_order': True/.test(header)) throw new Error(`${path} is by columns`);
  return { rows, columns, at: (i, j) => value(i * columns + j) };
}

export async function testInteraction({ open, check, near, set, state, take, differentPixels, base, result }) {
  const { features, animation } = result;
  const same = (a, b, what) => {
    const [x, y] = [a, b].map((value) => JSON.stringify(value));
    check(x === y, `${what}: ${x.slice(0, 300)} against ${y.slice(0, 300)}`);
  };
  const indices = features.map((_, i) => i), d = animation.frame_duration;
  const listed = (page) => page.locator("#rows tr.feature").evaluateAll((rows) => rows.map((row) => Number(row.dataset.index)));
  const spheres = (page) => page.evaluate(() => {
    viewer.stage.draw(0, false);
    return viewer.stage.spheres.shown.map(({ index }) => index).sort((a, b) => a - b);
  });
  const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

  /** A point of the canvas under which there is surface at the front, next to a vertex, and no sphere. */
  const surfacePoint = (page, from = 0) => page.evaluate((from) => {
    const { scene, stage, state } = viewer;
    stage.draw(0, false);
    for (let v = from; v < scene.vertices; v += 7) {
      const p = stage.projectPlace(scene.vertexPlace(v, state.values.time));
      const [x, y] = [Math.round(p.x), Math.round(p.y)];
      const isFree = document.elementFromPoint(x, y)?.id === "canvas" && stage.featureAt(x, y) < 0;
      const hit = isFree ? stage.surfaceAt(x, y) : null;
      if (!hit || Math.abs(hit.distance - p.distance) > 0.01 * stage.body) continue;
      // the corner that is nearest by barycentric coordinates, clearly
      const [a, b] = [...hit.barycentric].sort((p, q) => q - p);
      if (a - b > 0.1) return { x, y, v: hit.triangle[hit.barycentric.indexOf(a)] };
    }
    return null;
  }, from);

  async function testCurve(page) {
    const strain = readNpy("strain.npy"), field = await page.evaluate(() => viewer.scene.fields.findIndex((f) => f.name === "strain"));
    await set(page, { time: 5 * d, playing: false, selected: -1, field, probe: -1 });
    for (const from of [0, 400]) {
      const p = await surfacePoint(page, from);
      check(p !== null, "there is surface to click on");
      await page.locator("#canvas").click({ position: p });
      check((await state(page)).probe === p.v, `a click on the surface at vertex ${p.v} shows that of ${(await state(page)).probe}`);
      check(await page.locator("#curve").isVisible(), "the curve is shown");
      check((await page.locator("#probe-vertex").inputValue()) === `${p.v}`, "the vertex is told");
      const { values, max, top, largest, min } = await page.evaluate((i) => ({ ...viewer.scene.fields[i], values: viewer.curve.values, top: viewer.scene.fields[i].top_level }), field);
      check(values.length === strain.columns, `${values.length} values for ${strain.columns} frames`);
      values.forEach((x, f) => {
        const exact = strain.at(p.v, f), step = exact <= max ? (max - min) / top : (largest - max) / (255 - top);
        near(x, exact, 0.5001 * step + 1e-6 * largest, `strain of vertex ${p.v} in frame ${f}`);
      });
      // drawn where it should be
      const drawn = await page.evaluate(() => {
        const { curve } = viewer, canvas = curve.canvas, ratio = canvas.width / canvas.clientWidth;
        const { data, width } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        return curve.values.filter((value, k) => {
          const x = Math.round(curve.x(viewer.scene.kept_frames[k] * viewer.scene.frame_duration) * ratio), y = Math.round(curve.y(value) * ratio);
          return [-1, 0, 1].some((dx) => [-1, 0, 1].some((dy) => data[4 * ((y + dy) * width + x + dx) + 3] > 200));
        }).length;
      });
      check(drawn === values.length, `${drawn} of ${values.length} points of the curve are drawn`);
    }
    // the features of the neighbourhood, by what the file says
    const f = features[0], v = f.vertex;
    await set(page, { probe: v });
    const shown = await page.evaluate(() => viewer.curve.near.map(({ i }) => i));
    check(shown.includes(0), "a feature is in the neighbourhood of its own vertex");
    const rest = await page.evaluate((v) => viewer.scene.restPoint([v, v, v], [1, 0, 0]).map((x, c) => x - viewer.scene.restPoint(viewer.scene.features[0].on.triangle, viewer.scene.features[0].on.barycentric_coordinates)[c]), v);
    for (const [i, g] of features.entries()) {
      const off = Math.hypot(...g.rest_position.map((x, c) => f.rest_position[c] + rest[c] - x)) / g.radius;
      if (Math.abs(off - 1) > 1e-3) check(shown.includes(i) === off < 1, `feature ${i} is ${off} radii from vertex ${v}, ${shown.includes(i) ? "" : "not "}among its neighbours`);
    }
    check((await page.locator("#probe-links button").count()) === Math.min(shown.length, 12), "the neighbours can be chosen");
    await page.locator("#probe-links button").first().click();
    check((await state(page)).selected === shown[0], "a neighbour is selected");
    // time by the curve, and no curve any more
    const box = await page.locator("#curve").boundingBox();
    await page.locator("#curve").click({ position: { x: 10 + 0.5 * (box.width - 20), y: 20 } });
    near((await state(page)).time, 0.5 * (animation.frames - 1) * d, 2e-3, "a click on the curve goes to its time");
    await page.locator("#close-probe").click();
    check(!(await page.locator("#curve").isVisible()), "the curve is closed");
    await set(page, { field: 0 });
  }

  async function testHover(page) {
    await set(page, { time: features[0].time, selected: -1, playing: false });
    const p = await surfacePoint(page), tip = page.locator("#tip");
    await page.mouse.move(p.x, p.y);
    await settle(page);
    check((await tip.textContent()).startsWith(`vertex ${p.v}\ndeformation `), `over the surface: ${await tip.textContent()}`);
    const sphere = await page.evaluate(() => {
      for (const { feature, index } of viewer.stage.spheres.shown) {
        const at = viewer.stage.project(feature);
        if (document.elementFromPoint(at.x, at.y)?.id === "canvas" && viewer.stage.featureAt(at.x, at.y) === index) return { x: at.x, y: at.y, index };
      }
      return null;
    });
    await page.mouse.move(sphere.x, sphere.y);
    await settle(page);
    check((await tip.textContent()).startsWith(`#${sphere.index + 1} · ${features[sphere.index].time.toFixed(2)} s`), `over a sphere: ${await tip.textContent()}`);
    await page.mouse.move(3, 300);
    await settle(page);
    check(!(await tip.isVisible()), "over nothing, nothing");
  }

  async function testSorting(page) {
    await set(page, { grouped: false });
    for (const [key, first] of Object.entries(COLUMNS)) {
      if (key === "rank") await set(page, { sort: "time" });
      for (const sign of [first, -first]) {
        await page.locator(`#heads th[data-key=${key}] button`).click();
        const value = (i) => (key === "rank" ? i + 1 : features[i][key]);
        const expected = [...indices].sort((i, j) => sign * (value(i) - value(j)) || i - j);
        same(await listed(page), expected, `sorted by ${key}, ${sign > 0 ? "smallest" : "largest"} first`);
        same(await page.locator("#heads th").evaluateAll((cells) => cells.filter((c) => c.hasAttribute("aria-sort")).map((c) => [c.dataset.key, c.getAttribute("aria-sort")])),
          [[key, sign > 0 ? "ascending" : "descending"]], "what the heads say");
      }
    }
    // n goes on in that order
    await set(page, { sort: "-sigma", selected: -1 });
    const order = await listed(page);
    await page.locator("#canvas").focus();
    await page.keyboard.press("n");
    await page.keyboard.press("n");
    check((await state(page)).selected === order[1], "n goes on in the table's order");
    await set(page, { sort: "rank", selected: -1 });
  }

  async function testFilters(page) {
    await page.locator("#filters summary").click();
    const median = (key) => features.map((f) => f[key]).sort((a, b) => a - b)[Math.floor(features.length / 2)];
    const inputs = { amplitude: "Amplitude", fit: "Fit", sigma: "Size σ", tau: "Duration τ (s)", time: "Time (s)" };
    for (const [key, name] of Object.entries(inputs))
      for (const [end, isIn] of [["at least", (f) => f[key] >= median(key)], ["at most", (f) => f[key] <= median(key)]]) {
        const input = page.getByLabel(`${name}: ${end}`);
        await input.fill(`${median(key)}`);
        await input.press("Enter");
        const expected = indices.filter((i) => isIn(features[i]));
        check(expected.length > 0 && expected.length < features.length, `${name} ${end} ${median(key)} leaves ${expected.length}`);
        same(await listed(page), expected, `${name} ${end} ${median(key)}`);
        check((await page.locator("#count").textContent()) === `${expected.length} of ${features.length}`, "the count");
        check((await page.locator("#filters-active").textContent()) === "1 active", "it says that a bound is active");
        await set(page, { time: features[expected[0]].time });
        const alive = expected.filter((i) => Math.abs(features[i].time - features[expected[0]].time) <= 2 * features[i].tau);
        same(await spheres(page), alive, `${name} ${end}: the spheres`);
        const bar = await page.evaluate((i) => viewer.timeline.featureAt(viewer.timeline.x(viewer.scene.features[i].time), viewer.timeline.y(viewer.scene.features[i].strength)), indices.find((i) => !expected.includes(i)));
        check(expected.includes(bar) || bar < 0, "what is left out cannot be clicked on the timeline");
        await page.locator("#clear-filters").click();
        check((await listed(page)).length === features.length, "show all shows all");
      }
    for (const [choice, isIn] of [["without", (f) => !f.at_scale_limit], ["only", (f) => f.at_scale_limit]]) {
      await page.locator("#limits").selectOption(choice);
      same(await listed(page), indices.filter((i) => isIn(features[i])), `at a limit: ${choice}`);
    }
    await page.locator("#clear-filters").click();
    // what is no longer shown is not selected
    await set(page, { selected: 0 });
    await set(page, { bounds: { sigma: [features[0].sigma * 1.001, null] } });
    check((await state(page)).selected === -1, "what is left out is not selected");
    await page.locator("#clear-filters").click();
    await page.locator("#filters summary").click();
  }

  async function testPlaces(page) {
    await set(page, { grouped: true, sort: "rank", selected: -1 });
    const places = [...new Set(features.map((f) => f.place))];
    same(await listed(page), places.map((place) => features.findIndex((f) => f.place === place)), "one row for each place, its strongest");
    const many = places.filter((place) => features.filter((f) => f.place === place).length > 1);
    check((await page.locator("#rows tr.times").count()) === many.length && many.length > 0, `${many.length} places have several times`);
    for (const place of many.slice(0, 3)) {
      const members = indices.filter((i) => features[i].place === place).sort((i, j) => features[i].time - features[j].time);
      const row = page.locator(`#rows tr.feature[data-index="${Math.min(...members)}"]`), times = row.locator("xpath=following-sibling::tr[1]");
      same(await times.locator("button").evaluateAll((buttons) => buttons.map((b) => Number(b.dataset.index))), members, `the times of place ${place}`);
      same(await times.locator("button").allTextContents(), members.map((i) => `${features[i].time.toFixed(2)} s`), `the texts of place ${place}`);
      await times.locator("button").last().click();
      check((await state(page)).selected === members.at(-1), "one of its times is selected");
      near((await state(page)).time, features[members.at(-1)].time, 1e-9, "and shown");
      check((await row.getAttribute("aria-current")) === "true" && (await times.locator("button").last().getAttribute("aria-current")) === "true", "row and time are marked");
      // its trajectory: bright pixels along the way
      await set(page, { trail: true });
      await take(page, "trail");
      await set(page, { trail: false });
      await take(page, "no_trail");
      check((await differentPixels(page, "trail", "no_trail", 30)) > 20, "the trajectory of the selected place is drawn");
      await set(page, { trail: true });
    }
    const child = features.findIndex((f) => f.parent !== null);
    if (child >= 0) {
      await page.evaluate((i) => viewer.go(i), child);
      await page.locator("#details dd[data-key=parent] button").click();
      check((await state(page)).selected === features[child].parent - 1, "the parent of a feature is a click away");
    }
    await set(page, { grouped: false, selected: -1 });
  }

  async function download(page, act) {
    const [file] = await Promise.all([page.waitForEvent("download"), act()]);
    return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
  }

  async function testSaving(page) {
    await set(page, { grouped: false, sort: "-tau", bounds: { fit: [features.map((f) => f.fit).sort()[2], null] }, selected: -1 });
    const order = await listed(page);
    check(order.length > 0 && order.length < features.length, `${order.length} of ${features.length} are to be saved`);
    const csv = await download(page, () => page.locator("#save-csv").click());
    const lines = csv.bytes.toString("utf8").trim().split("\n").map((line) => line.split(","));
    check(csv.name.endsWith("_features.csv"), `the name ${csv.name}`);
    const head = readFileSync(`${base}.csv`, "utf8").split("\n")[0].split(",");
    same(lines[0], head, "the columns are those of detect_features -o x.csv");
    order.forEach((i, row) => {
      for (const key of ["vertex", "frame", "time", "sigma", "tau", "amplitude", "fit", "strength", "place"])
        check(Number(lines[row + 1][head.indexOf(key)]) === features[i][key], `CSV, line ${row + 1}: ${key}`);
      check(lines[row + 1].length === head.length && Number(lines[row + 1][head.indexOf("rank")]) === i + 1, `CSV, line ${row + 1}: rank`);
      check(Number(lines[row + 1][head.indexOf("y")]) === features[i].position[1], `CSV, line ${row + 1}: y`);
    });
    const json = await download(page, () => page.locator("#save-json").click());
    const saved = JSON.parse(json.bytes.toString("utf8"));
    same(saved.features, order.map((i) => features[i]), "JSON: the features listed, as in the file");
    const { mean_edge_length, ...numbers } = saved.animation;
    for (const [key, x] of Object.entries(numbers)) check(x === animation[key], `JSON: ${key} of the animation: ${x}, not ${animation[key]}`);
    near(mean_edge_length, animation.mean_edge_length, 1e-9, "JSON: mean length of edges");
    await page.locator("#rows tr.feature").first().click();
    const one = await download(page, () => page.locator("#save-feature").click());
    same(JSON.parse(one.bytes.toString("utf8")).features, [features[order[0]]], "the selected one alone");
    await set(page, { bounds: {}, sort: "rank", selected: -1 });

    const picture = await download(page, () => page.locator("#save").click());
    const { width, height, inked } = await page.evaluate(async (base64) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type: "image/png" }));
      const canvas = new OffscreenCanvas(image.width, image.height), g = canvas.getContext("2d");
      g.drawImage(image, 0, 0);
      const top = document.getElementById("canvas").height, { data } = g.getImageData(0, top, image.width, image.height - top);
      let inked = 0;
      for (let k = 0; k < data.length; k += 4) if (data[k] + data[k + 1] + data[k + 2] < 450) ++inked;
      return { width: image.width, height: image.height - top, inked };
    }, picture.bytes.toString("base64"));
    check(width > 500 && height > 40 && inked > 200, `the picture's caption: ${width} x ${height}, ${inked} pixels of ink`);
  }

  async function testAddress() {
    const page = await open(`${base}.html`);
    check(!page.url().includes("#"), `a page that nobody has touched has no fragment: ${page.url()}`);
    const wanted = {
      time: 7 * d, playing: false, threshold: features.at(-2).strength, bounds: { fit: [0.1, null], sigma: [null, features[0].sigma * 3] }, limits: "all",
      sort: "-fit", grouped: false, field: 1, map: "cividis", hidden: false, wires: true, labels: false, trail: false, opacity: 0.55, probe: 123, speed: 0.5,
      measuring: true, measureFrom: 3, measureTo: 77, theme: "dark", selected: 1,
    };
    await page.evaluate((values) => {
      viewer.state.set(values);
      viewer.setTheme("dark");
      viewer.stage.turn(0.7, 0.2);
      viewer.stage.zoom(0.8);
    }, wanted);
    const view = () => page.evaluate(() => [viewer.stage.camera.position.toArray(), viewer.stage.controls.target.toArray()].flat());
    const before = await view(), rows = await listed(page);
    await page.waitForFunction(() => location.hash.includes("view="), null, { timeout: 5000 });
    await page.waitForTimeout(500);
    const url = page.url();
    for (const how of ["a reload", "a link"]) {
      if (how === "a reload") await page.reload();
      else {
        await page.goto("about:blank");
        await page.goto(url);
      }
      await page.waitForSelector("html[data-ready]");
      await page.evaluate(async () => (window.viewer = await animatedMeshFeatures.ready));
      const values = await state(page);
      for (const [name, value] of Object.entries(wanted)) {
        if (typeof value === "number") near(values[name], value, 1e-5 * Math.abs(value), `after ${how}: ${name}`);
        else if (name === "bounds") near(values.bounds.sigma?.[1], value.sigma[1], 1e-5 * value.sigma[1], `after ${how}: the bound of sigma`);
        else check(values[name] === value, `after ${how}: ${name} is ${values[name]}`);
      }
      same(await listed(page), rows, `after ${how}: the rows`);
      (await view()).forEach((x, i) => near(x, before[i], 1e-4, `after ${how}: the view`));
    }
    // nonsense does no harm
    await page.goto("about:blank");
    await page.goto(`${url.split("#")[0]}#s=9999&t=x&map=none&sort=up&v=-3&view=1,2&field=nothing&fit.in=a,b`);
    await page.waitForSelector("html[data-ready]");
    await page.evaluate(async () => (window.viewer = await animatedMeshFeatures.ready));
    const { selected, map, sort, probe, field, bounds } = await state(page);
    same({ selected, map, sort, probe, field, bounds }, { selected: -1, map: "sand", sort: "rank", probe: -1, field: 0, bounds: {} }, "an address that says nothing");
    await page.context().close();
  }

  async function testMeasuring(page) {
    await set(page, { time: 4 * d, selected: -1, features: true });
    await page.locator("#measure").click();
    const [a, b] = [10, Math.floor(animation.vertices / 2)];
    for (const [id, v] of [["#measure-from", a], ["#measure-to", b]]) {
      await page.locator(id).fill(`${v}`);
      await page.locator(id).press("Enter");
    }
    const cache = readFileSync(`${base}.pc2`), n = cache.readInt32LE(16);
    const at = (v) => [0, 1, 2].map((c) => cache.readFloatLE(32 + 4 * (3 * (4 * n + v) + c)));
    const straight = Math.hypot(...at(a).map((x, c) => x - at(b)[c]));
    near(await page.evaluate(() => viewer.measure.straight(viewer.state.values.time)), straight, 1e-4 * animation.bounding_box_diagonal, "the straight distance");
    near(parseFloat(await page.locator("#measured").textContent()), straight, 1e-3 * straight, "what is told of it");
    // along edges: as by relaxing all edges until nothing changes
    const [along, exact] = await page.evaluate(([a, b]) => {
      const { faces, rest, vertices } = viewer.scene, far = new Float64Array(vertices).fill(Infinity);
      far[a] = 0;
      for (let changed = true; changed; ) {
        changed = false;
        for (let i = 0; i < faces.length; ++i) {
          const v = faces[i], w = faces[i - (i % 3) + ((i + 1) % 3)], length = Math.hypot(...[0, 1, 2].map((c) => rest[3 * v + c] - rest[3 * w + c]));
          for (const [p, q] of [[v, w], [w, v]])
            if (far[p] + length < far[q] - 1e-12) {
              far[q] = far[p] + length;
              changed = true;
            }
        }
      }
      return [viewer.measure.alongEdges(), far[b]];
    }, [a, b]);
    near(along, exact, 1e-6 * exact, "the distance along edges");
    check(along >= 0.2 * straight, "it is not much shorter than the straight one of another time");
    // by pointer
    const p = await surfacePoint(page), q = await surfacePoint(page, 600);
    for (const { x, y } of [p, q]) await page.locator("#canvas").click({ position: { x, y } });
    const { measureFrom, measureTo, selected } = await state(page);
    same([measureFrom, measureTo, selected], [p.v, q.v, -1], "two clicks measure between two vertices");
    await page.locator("#close-measuring").click();
    check((await state(page)).measureFrom === -1, "done with measuring");
  }

  async function testView(page) {
    // close to a feature, the eye stays above the ground
    const low = await page.evaluate(() => {
      const { stage, scene, state } = viewer, c = state.values.up === "z" ? 2 : 1, ground = scene.box.min[c] - scene.centre[c];
      return scene.features.map((f, i) => {
        stage.resetView();
        stage.turn(0, -0.5); // from below
        viewer.go(i);
        viewer.approach();
        return (stage.camera.position.getComponent(c) - ground) / stage.body;
      });
    });
    check(low.every((h) => h > 0), `the eye is above the ground: ${Math.min(...low)}`);
    await page.keyboard.press("r");
    // what is selected is seen through the surface, even if others are not
    await set(page, { hidden: false, labels: false, trail: false });
    const i = await page.evaluate(() => {
      const { stage, scene, state } = viewer;
      return scene.features.findIndex((f) => {
        state.set({ time: f.time });
        stage.draw(0, false);
        const p = stage.project(f);
        return p.radius > 4 && (stage.surfaceAt(p.x, p.y)?.distance ?? Infinity) < p.distance - f.radius;
      });
    });
    if (i >= 0) {
      await set(page, { time: features[i].time, selected: -1 });
      await take(page, "not_selected");
      await set(page, { selected: i });
      await take(page, "selected");
      check((await differentPixels(page, "not_selected", "selected", 12)) > 30, `feature ${i}, behind the surface, is seen when selected`);
    }
    await set(page, { hidden: true, selected: -1, opacity: 1 });
    await take(page, "opaque");
    await set(page, { opacity: 0.3 });
    await take(page, "clear");
    check((await differentPixels(page, "opaque", "clear", 40)) > 500, "the surface can be made clear");
    await set(page, { opacity: 1, labels: true, trail: true });
    await settle(page);
    check((await page.evaluate(() => viewer.overlay.labelled)) > 0, "spheres have their ranks on them");
    // the body is followed
    const target = (time) => page.evaluate((t) => {
      viewer.state.set({ time: t });
      return viewer.stage.controls.target.toArray();
    }, time);
    const [one, two] = [await target(0), await target(0.5 * (animation.frames - 1) * d)];
    const moved = await page.evaluate((t) => Math.hypot(...viewer.scene.centreAt(t).map((x, c) => x - viewer.scene.centreAt(0)[c])), 0.5 * (animation.frames - 1) * d);
    near(Math.hypot(...one.map((x, c) => x - two[c])), moved, 1e-6, "the view goes with the body");
  }

  /** With the keyboard alone: every control can be reached, and what matters be done. */
  async function testKeyboardAlone() {
    const page = await open(`${base}.html`, { viewport: { width: 1100, height: 900 } });
    const focused = () => page.evaluate(() => document.activeElement?.id || document.activeElement?.className || document.activeElement?.tagName);
    const tabTo = async (id) => {
      for (let i = 0; i < 80; ++i) {
        if ((await focused()) === id) return true;
        await page.keyboard.press("Tab");
      }
      return false;
    };
    const reached = new Set();
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press("Tab");
      reached.add(await focused());
    }
    const controls = await page.evaluate(() => [...document.querySelectorAll("button[id], input[id], select[id]")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && !e.disabled && e.tabIndex >= 0).map((e) => e.id));
    const missed = controls.filter((id) => !reached.has(id));
    check(missed.length === 0, `not reached with the keyboard: ${missed}`);
    check(reached.has("canvas") && reached.has("sort") && reached.has("rank"), "the surface, the table's heads and rows are reached");
    await tabTo("sort");
    for (let i = 0; i < 2; ++i) await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    check((await state(page)).sort === "time", `Enter on a head sorts: ${(await state(page)).sort}`);
    await page.keyboard.press("ArrowDown");
    const first = (await state(page)).selected;
    check(first >= 0, "the arrow selects");
    await page.keyboard.press("k");
    check((await state(page)).probe === features[first].vertex, "k shows its curve");
    check(await tabTo("probe-vertex"), "the vertex can be typed");
    await page.keyboard.press("Control+a");
    await page.keyboard.type("42");
    await page.keyboard.press("Enter");
    check((await state(page)).probe === 42, "another vertex is typed");
    await tabTo("filters") || (await page.evaluate(() => document.querySelector("#filters summary").focus()));
    await page.keyboard.press("Enter");
    check(await page.locator("#bounds input").first().isVisible(), "the filters open");
    await page.keyboard.press("Tab");
    await page.keyboard.type("0.3");
    await page.keyboard.press("Tab");
    check((await state(page)).bounds.amplitude?.[0] === 0.3, "a bound is typed");
    await page.locator("#canvas").focus();
    for (const [key, name] of [["g", "grouped"], ["l", "labels"], ["j", "trail"], ["q", "measuring"]]) {
      const before = (await state(page))[name];
      await page.keyboard.press(key);
      check((await state(page))[name] === !before, `${key} switches ${name}`);
      await page.keyboard.press(key);
    }
    await page.keyboard.press("o");
    check((await state(page)).opacity === 0.6, "o makes the surface clearer");
    await page.context().close();
  }

  /** No fault for axe-core, with its default rules, in any state of the page. */
  async function testAxe() {
    const sizes = {
      wide: { viewport: { width: 1400, height: 860 } },
      narrow: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
      dark: { viewport: { width: 1100, height: 720 }, colorScheme: "dark" },
    };
    let passed = 0;
    for (const [name, options] of Object.entries(sizes)) {
      const page = await open(`${base}.html`, options);
      await page.evaluate(AXE);
      const states = {
        "as it opens": () => {},
        "with everything open": () => {
          viewer.go(viewer.scene.features.findIndex((f) => f.parent !== null));
          viewer.state.set({ probe: 5, measuring: true, measureFrom: 1, measureTo: 9, bounds: { fit: [0.1, null] } });
          document.getElementById("filters").open = true;
        },
        "ungrouped": () => viewer.state.set({ grouped: false, selected: 0 }),
        "with its help": () => viewer.toggleHelp(),
        "while painting": () => {
          viewer.toggleHelp();
          viewer.painter.toggle();
        },
      };
      for (const [what, act] of Object.entries(states)) {
        await page.evaluate(act);
        await settle(page);
        const { violations, passes } = await page.evaluate(() => axe.run(document));
        passed += passes.length;
        for (const v of violations) check(false, `axe-core, ${name}, ${what}: ${v.id}: ${v.help}: ${v.nodes.slice(0, 2).map((n) => n.html.slice(0, 120))}`);
        check(violations.length === 0 && passes.length > 10, `axe-core, ${name}, ${what}`);
      }
      await page.screenshot({ path: `interaction_${name}.png` });
      await page.context().close();
    }
    console.log(`axe-core: ${passed} rules passed in all states`);
  }

  const page = await open(`${base}.html`);
  await set(page, { grouped: false });
  await testCurve(page);
  await testHover(page);
  await testSorting(page);
  await testFilters(page);
  await testPlaces(page);
  await testSaving(page);
  await testMeasuring(page);
  await testView(page);
  await page.context().close();
  await testAddress();
  await testKeyboardAlone();
  await testAxe();
}
