// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The viewer in a browser: node browser_test.mjs CHROMIUM BASE [LARGE] [PAIR] [CYCLIC]
// BASE.html, BASE.json and, if there is one, BASE.glb were written by the same run of detect_features, on BASE.pc2; LARGE.html is a page of the size that
// has a limit. PAIR.html and PAIR.json were written by the same run of compare_animations,
// LOOPS.html and LOOPS.json likewise, with --cyclic; CYCLIC.html as BASE.html, but with --cyclic. Pictures are left in the current folder. Fails if any check fails; times are reported, never judged.

import { existsSync, readFileSync, statSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { testCyclic } from "./cyclic_test.mjs";
import { testInteraction } from "./interaction_test.mjs";
import { testLoops, testPair } from "./pair_test.mjs";
import { testPainting } from "./painting_test.mjs";

const [browserPath, base, large, pair, cyclic, loops] = process.argv.slice(2);
const result = JSON.parse(readFileSync(`${base}.json`, "utf8"));
const features = result.features;

let checks = 0, failures = 0;
function check(condition, what) {
  ++checks;
  if (condition) return;
  ++failures;
  console.log(`failed: ${what}`);
}
const near = (a, b, tolerance, what) => check(Math.abs(a - b) <= tolerance, `${what}: ${a} against ${b}, tolerance ${tolerance}`);
const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

// A software renderer, which every machine has.
const browser = await chromium.launch({
  executablePath: browserPath,
  args: ["--no-sandbox", "--enable-unsafe-swiftshader"],
});

/** Opens a page from the disk; nothing may go wrong in it, and nothing be fetched. */
async function open(path, { before, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1100, height: 720 }, colorScheme: "light", reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/GPU stall|willReadFrequently/.test(message.text())) check(false, `${path}: console: ${message.text()}`);
  });
  page.on("pageerror", (error) => check(false, `${path}: ${error.message}`));
  page.on("request", (request) => check(/^(file|data|blob):/.test(request.url()), `${path} asks for ${request.url().slice(0, 100)}`));
  if (before) await page.addInitScript(before);
  await page.goto(pathToFileURL(resolve(path)).href);
  await page.waitForSelector("html[data-ready]", { timeout: 60000 });
  await page.evaluate(async () => {
    window.viewer = await animatedMeshFeatures.ready;
  });
  return page;
}

const state = (page) => page.evaluate(() => viewer.state.values);
const set = (page, values) => page.evaluate((v) => viewer.state.set(v), values);
const place = (page, i) => page.evaluate((k) => viewer.scene.place(viewer.scene.features[k], viewer.state.values.time), i);
/** The numbers that are shown for the selected feature, by name; undefined if there are none. */
const shownNumbers = (page) =>
  page.evaluate(() => {
    const panel = document.getElementById("details");
    if (panel.hidden) return undefined;
    return Object.fromEntries([...panel.querySelectorAll("dd")].map((d) => [d.dataset.key, { value: JSON.parse(d.dataset.value), text: d.textContent }]));
  });

/** What is shown is the i-th feature of the JSON file. */
async function checkNumbers(page, i, how) {
  const shown = await shownNumbers(page);
  check(shown !== undefined, `${how}: the numbers of feature ${i} are shown`);
  if (shown === undefined) return;
  for (const key of ["vertex", "frame", "time", "sigma", "tau", "radius", "strength", "amplitude", "fit", "place", "parent", "position"])
    check(JSON.stringify(shown[key]?.value) === JSON.stringify(features[i][key]), `${how}: ${key} of feature ${i}: ${JSON.stringify(shown[key])} against ${JSON.stringify(features[i][key])}`);
  check(shown.vertex.text === `${features[i].vertex}`, `${how}: text of the vertex, ${shown.vertex.text}`);
  near(parseFloat(shown.strength.text), features[i].strength, 1e-3 * features[i].strength, `${how}: text of the strength`);
  near(parseFloat(shown.time.text), features[i].time, 6e-4, `${how}: text of the time`);
}

/** Takes a picture of the canvas, in CSS pixels, and keeps it in the page under a name. */
async function take(page, name) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const picture = await page.locator("#canvas").screenshot({ path: `${name}.png` });
  await page.evaluate(async ([name, base64]) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const g = canvas.getContext("2d");
    g.drawImage(image, 0, 0);
    (window.pictures ??= {})[name] = g.getImageData(0, 0, image.width, image.height);
  }, [name, picture.toString("base64")]);
}

/** How many pixels of two pictures differ by more than `least`, in the sum of their colours. */
const differentPixels = (page, a, b, least) =>
  page.evaluate(([a, b, least]) => {
    const p = pictures[a].data, q = pictures[b].data;
    let n = 0;
    for (let k = 0; k < p.length; k += 4)
      if (Math.abs(p[k] - q[k]) + Math.abs(p[k + 1] - q[k + 1]) + Math.abs(p[k + 2] - q[k + 2]) > least) ++n;
    return n;
  }, [a, b, least]);

// ------------------------------------------------------------------------------------------------------------ the tests

async function testData(page) {
  check(features.length >= 5, `${features.length} features are enough to test with`);
  await set(page, { grouped: false, labels: false });
  const rows = await page.locator("#rows tr").count();
  check(rows === features.length, `${rows} rows for ${features.length} features`);
  const strengths = await page.evaluate(() => viewer.scene.features.map((f) => f.strength));
  check(strengths.every((s, i) => i === 0 || s <= strengths[i - 1]), "the table is sorted by strength");

  // PC2: 32 bytes of header; the number of points at 16, of frames at 28
  const cache = readFileSync(`${base}.pc2`);
  const n = cache.readInt32LE(16), frames = cache.readInt32LE(28);
  const error = await page.evaluate(
    ([base64, n, frames]) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)), xyz = new Float32Array(bytes.buffer);
      const { scene } = viewer;
      if (scene.vertices !== n || scene.kept_frames.length !== frames) return Infinity;
      let largest = 0;
      for (let f = 0; f < frames; ++f)
        for (let v = 0; v < n; ++v) {
          const p = scene.position(v, f), at = 3 * (f * n + v);
          largest = Math.max(largest, Math.hypot(p[0] - xyz[at], p[1] - xyz[at + 1], p[2] - xyz[at + 2]));
        }
      return largest / scene.bounding_box_diagonal;
    },
    [cache.subarray(32).toString("base64"), n, frames],
  );
  const stated = await page.evaluate(() => viewer.scene.largest_error);
  check(stated < 1e-4, `the stated error, ${stated}`);
  check(error <= stated * 1.001 && error > 0, `the error of positions, ${error}, is below the stated one, ${stated}`);
  check((await page.locator("#precision").textContent()).includes("of the bounding-box diagonal"), "the error is stated in the page");
  console.log(`positions: largest error ${error.toExponential(2)}, stated ${stated.toExponential(2)} of the diagonal`);
}

async function testTime(page) {
  await set(page, { playing: false, time: 0 });
  await page.locator("#play").click();
  await page.waitForFunction(() => viewer.state.values.time > 0.1, null, { timeout: 20000 });
  check((await state(page)).playing, "it plays");
  const drawn = await page.evaluate(() => viewer.drawn);
  await page.locator("#play").click();
  check(!(await state(page)).playing && drawn > 1, "it pauses");

  // the slider moves the features, to where the detector says they are
  const slider = page.locator("#time"), places = [];
  for (const i of [0, 1, 2]) {
    await slider.evaluate((element, time) => {
      element.value = `${time}`;
      element.dispatchEvent(new Event("input"));
    }, features[i].time);
    near((await state(page)).time, features[i].time, 1e-9, "the slider sets the time");
    const p = await place(page, i);
    near(distance(p, features[i].position), 0, 1e-4 * result.animation.bounding_box_diagonal, `place of feature ${i} at its time`);
  }
  for (const share of [0.2, 0.8]) {
    await slider.fill(`${share * (result.animation.frames - 1) * result.animation.frame_duration}`);
    places.push(await page.evaluate(() => viewer.scene.features.map((f) => viewer.stage.project(f))));
  }
  const moved = places[0].filter((p, i) => Math.hypot(p.x - places[1][i].x, p.y - places[1][i].y) > 2).length;
  check(moved > 0, "features move on the screen with the slider");
  check((await page.locator("#clock").textContent()).includes("frame"), "the clock is shown");
}

async function testSelection(page) {
  // a row of the table
  await page.locator("#rows tr").nth(2).click();
  near((await state(page)).time, features[2].time, 1e-9, "a row jumps to the feature's time");
  await checkNumbers(page, 2, "row");
  check((await page.locator("#announcement").textContent()).startsWith("Feature 3"), "the selection is announced");

  // spheres, each at a time at which it is the one under its own centre
  let clicked = 0;
  for (let i = 0; i < features.length && clicked < 3; ++i) {
    await set(page, { selected: -1, time: features[i].time });
    const p = await page.evaluate((k) => {
      viewer.stage.draw(0, false);
      const at = viewer.stage.project(viewer.scene.features[k]);
      return { ...at, hit: viewer.stage.featureAt(at.x, at.y) };
    }, i);
    if (p.hit !== i) continue;
    await page.locator("#canvas").click({ position: { x: p.x, y: p.y } });
    check((await state(page)).selected === i, `a click on sphere ${i} selects ${(await state(page)).selected}`);
    await checkNumbers(page, i, "sphere");
    ++clicked;
  }
  check(clicked === 3, `${clicked} spheres could be clicked`);
  await page.locator("#canvas").click({ position: { x: 12, y: 300 } });
  check((await shownNumbers(page)) === undefined, "a click on nothing selects nothing");

  // the timeline
  const bar = await page.evaluate(() => ({ x: viewer.timeline.x(viewer.scene.features[0].time), y: viewer.timeline.y(viewer.scene.features[0].strength) }));
  await page.locator("#timeline").click({ position: bar });
  await checkNumbers(page, (await state(page)).selected, "timeline");
  near((await state(page)).time, features[(await state(page)).selected].time, 1e-9, "the timeline jumps");

  // close to it: its sphere is in the picture, and large
  const before = await page.evaluate(() => viewer.stage.project(viewer.scene.features[viewer.state.values.selected]));
  await page.locator("#approach").click();
  const after = await page.evaluate(() => viewer.stage.project(viewer.scene.features[viewer.state.values.selected]));
  const { width, height } = await page.locator("#canvas").boundingBox();
  check(after.radius > before.radius, `going close makes it larger: ${before.radius}, ${after.radius}`);
  check(Math.hypot(after.x - width / 2, after.y - height / 2) < 3, "going close brings it to the middle");
  await page.keyboard.press("r");
}

/** Pictures with and without spheres differ where the spheres are, and nowhere else. */
async function testSpheres(page) {
  let seen = 0;
  for (const i of [0, 1, Math.floor(features.length / 2)]) {
    await set(page, { selected: -1, time: features[i].time, threshold: 0, playing: false });
    const discs = await page.evaluate(() => {
      viewer.stage.draw(0, false);
      return viewer.stage.spheres.shown.map(({ feature, opacity }) => ({ ...viewer.stage.project(feature), opacity }));
    });
    await take(page, `spheres_${i}`);
    await set(page, { threshold: Infinity });
    await take(page, `no_spheres_${i}`);
    const { width, height, outside, changed, area } = await page.evaluate(([discs, a, b]) => {
      const { width, height, data: p } = pictures[a], q = pictures[b].data;
      let outside = 0;
      const changed = discs.map(() => 0), area = discs.map(() => 0);
      for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x) {
          const k = 4 * (y * width + x);
          const differs = Math.abs(p[k] - q[k]) + Math.abs(p[k + 1] - q[k + 1]) + Math.abs(p[k + 2] - q[k + 2]) > 8;
          let isInside = false;
          discs.forEach((disc, j) => {
            const r = Math.hypot(x + 0.5 - disc.x, y + 0.5 - disc.y);
            // in perspective, a sphere's outline is a little larger than a disc of its radius
            if (r < 1.08 * disc.radius + 2) isInside = true;
            if (r < 0.95 * disc.radius) {
              ++area[j];
              if (differs) ++changed[j];
            }
          });
          if (differs && !isInside) ++outside;
        }
      return { width, height, outside, changed, area };
    }, [discs, `spheres_${i}`, `no_spheres_${i}`]);
    check(outside < 20, `time of feature ${i}: ${outside} pixels differ where no sphere is`);
    discs.forEach((disc, j) => {
      const isInPicture = disc.x > disc.radius && disc.y > disc.radius && disc.x < width - disc.radius && disc.y < height - disc.radius;
      if (disc.opacity < 0.6 || disc.radius < 3 || !isInPicture) return;
      ++seen;
      check(changed[j] > 0.9 * area[j], `time of feature ${i}: of a sphere at ${Math.round(disc.x)}, ${Math.round(disc.y)}, ${changed[j]} of ${area[j]} pixels are drawn`);
    });
  }
  check(seen >= 3, `${seen} spheres were looked for`);
  await set(page, { threshold: features.at(-1).strength });
}

async function testThreshold(page) {
  const slider = page.locator("#threshold");
  for (const share of [0.5, 1, 0]) {
    const weakest = features.at(-1).strength, threshold = weakest + share * (features[0].strength - weakest);
    await slider.evaluate((element, value) => {
      element.value = `${value}`;
      element.dispatchEvent(new Event("input"));
    }, threshold);
    const least = (await state(page)).threshold;
    const expected = features.filter((f) => f.strength >= least);
    const rows = await page.locator("#rows tr:visible").count();
    check(rows === expected.length, `threshold ${threshold}: ${rows} rows for ${expected.length} features`);
    check((await page.locator("#count").textContent()) === `${expected.length} of ${features.length}`, `threshold ${threshold}: ${await page.locator("#count").textContent()}`);
    if (share === 1) check(expected.length === features.filter((f) => f.strength === features[0].strength).length, "at the top, the strongest is left");
    if (share === 0) check(expected.length === features.length, "at the bottom, all are shown");
    // on the surface, those of them that live at that time
    for (const f of [features[0], features.at(-1)]) {
      await set(page, { time: f.time, selected: -1 });
      const spheres = await page.evaluate(() => {
        viewer.stage.draw(0, false);
        return viewer.stage.spheres.shown.map(({ index }) => index).sort((a, b) => a - b);
      });
      const alive = features.map((_, i) => i).filter((i) => expected.includes(features[i]) && Math.abs(f.time - features[i].time) <= 2 * features[i].tau);
      check(JSON.stringify(spheres) === JSON.stringify(alive), `threshold ${threshold}: spheres ${spheres}, not ${alive}`);
    }
  }
}

async function testField(page) {
  await set(page, { time: features[0].time, threshold: features.at(-1).strength, selected: -1 });
  const fields = await page.evaluate(() => viewer.scene.fields.map((f) => f.name));
  check(fields[0] === "deformation", `the fields: ${fields}`);
  check(await page.locator("#legend").isVisible(), "the legend is shown");
  await take(page, "field");
  await page.locator("#field").selectOption("-1");
  check(!(await page.locator("#legend").isVisible()), "no field, no legend");
  await take(page, "no_field");
  const colored = await differentPixels(page, "field", "no_field", 40);
  check(colored > 500, `the field colours ${colored} pixels of the surface`);
  await page.locator("#field").selectOption("0");
  for (const i of [1, 2, 3]) {
    await take(page, `map_${i}`);
    await page.keyboard.press("m");
  }
  for (const [a, b] of [[1, 2], [2, 3], [3, 1]]) {
    const different = await differentPixels(page, `map_${a}`, `map_${b}`, 40);
    check(different > 500, `colour maps ${a} and ${b} differ in ${different} pixels`);
  }
}

/** Lightness grows or falls evenly along a colour map, also to those who do not tell red from green. */
async function testColors(page) {
  for (const name of ["sand", "viridis", "cividis"]) {
    await set(page, { map: name });
    const lightness = await page.evaluate(() => {
      const bytes = viewer.stage.surface.map.image.data;
      const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
      // CIE L* of what the eye sees as brightness
      return Array.from({ length: 17 }, (_, i) => {
        const [r, g, b] = [0, 1, 2].map((c) => linear(bytes[4 * Math.round((i * 255) / 16) + c] / 255));
        return 116 * Math.cbrt(0.2126 * r + 0.7152 * g + 0.0722 * b) - 16;
      });
    });
    const steps = lightness.slice(1).map((l, i) => l - lightness[i]), mean = (lightness.at(-1) - lightness[0]) / 16;
    check(Math.abs(mean) > 2, `${name}: lightness from ${lightness[0]} to ${lightness.at(-1)}`);
    check(steps.every((s) => s / mean > 0.5 && s / mean < 1.6), `${name}: steps of lightness ${steps.map((s) => (s / mean).toFixed(2))}`);
  }
  await set(page, { map: "sand" });
  const used = await page.evaluate(() => {
    const bytes = viewer.stage.surface.map.image.data, hex = (rgb) => `#${Array.from(rgb, (x) => x.toString(16).padStart(2, "0")).join("")}`;
    const { field } = viewer.scene.colours, last = field.length - 1;
    return field.map((color, i) => [hex(bytes.subarray(4 * Math.round((i * 255) / last), 4 * Math.round((i * 255) / last) + 3)), color]);
  });
  check(used[0][0] === used[0][1] && used.at(-1)[0] === used.at(-1)[1], `the colours of the scene are used: ${used[0]}, ${used.at(-1)}`);
  const ramp = await page.evaluate(() => [getComputedStyle(document.getElementById("duration-ramp")).backgroundImage, viewer.scene.colours.duration]);
  const ends = [ramp[1][0], ramp[1].at(-1)].map((hex) => `rgb(${[1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)).join(", ")})`);
  check(ends.every((rgb) => ramp[0].includes(rgb)), `the legend of durations goes from ${ends[0]} to ${ends[1]}: ${ramp[0]}`);
}

async function testKeyboard(page) {
  const d = result.animation.frame_duration;
  await set(page, { time: 3 * d, playing: false, selected: -1 });
  await page.locator("#canvas").focus();
  const press = async (key) => {
    await page.keyboard.press(key);
    return state(page);
  };
  near((await press("ArrowRight")).time, 4 * d, 1e-9, "→");
  near((await press("ArrowLeft")).time, 3 * d, 1e-9, "←");
  near((await press("End")).time, (result.animation.frames - 1) * d, 1e-9, "End");
  near((await press("Home")).time, 0, 1e-9, "Home");
  check((await press(" ")).playing === true && (await press(" ")).playing === false, "Space");
  check((await press("n")).selected === 0 && (await press("n")).selected === 1 && (await press("p")).selected === 0, "n, p");
  check((await press("Escape")).selected === -1, "Escape");
  check((await press("]")).speed === 2 && (await press("[")).speed === 1, "[ ]");
  const hidden = (await state(page)).hidden;
  check((await press("x")).hidden === !hidden && (await press("x")).hidden === hidden, "x");
  check((await press("e")).wires && !(await press("e")).wires, "e");
  await press("?");
  check(await page.locator("#help-dialog").isVisible(), "? shows the help");
  check((await page.locator("#shortcuts > div").count()) >= 20, "the help lists the keys");
  check((await page.locator("#help-dialog pre").textContent()).includes("three.js authors"), "three.js and its licence are named");
  await press("Escape");
  check(!(await page.locator("#help-dialog").isVisible()), "Escape closes the help");
  const eye = () => page.evaluate(() => viewer.stage.camera.position.toArray());
  const start = await eye();
  await press("a");
  check(distance(await eye(), start) > 0, "a turns");
  await press("r");

  // dragging turns too
  const before = await eye(), box = await page.locator("#canvas").boundingBox();
  await page.mouse.move(box.x + 100, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 260, box.y + 240, { steps: 5 });
  await page.mouse.up();
  await page.waitForTimeout(100);
  check(distance(await eye(), before) > 1e-3, "dragging turns");
  await page.keyboard.press("r");
}

/** Every control has a name for those who do not see it. */
async function testNames(page) {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, canvas:not([aria-hidden])")]
      .filter((e) => !(e.getAttribute("aria-label") || e.labels?.[0]?.textContent.trim() || e.textContent.trim()))
      .map((e) => e.outerHTML.slice(0, 80)),
  );
  check(nameless.length === 0, `controls without a name: ${nameless}`);
}

async function testDark(page) {
  const brightness = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0) / 3);
  const light = await brightness();
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForFunction(() => viewer.state.values.theme === "dark", null, { timeout: 5000 }).catch(() => {});
  check((await state(page)).theme === "dark", "it follows the system's choice");
  const dark = await brightness();
  check(light > 200 && dark < 60, `light ${light}, dark ${dark}`);
  // contrast of text with what is behind it (WCAG 2: at least 4.5)
  for (const theme of ["dark", "light"]) {
    await page.evaluate((t) => viewer.setTheme(t), theme);
    const ratio = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      const luminance = (name) => {
        const hex = style.getPropertyValue(name).trim().slice(1), full = hex.length === 3 ? [...hex].map((c) => c + c).join("") : hex;
        const [r, g, b] = [0, 2, 4].map((i) => parseInt(full.slice(i, i + 2), 16) / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      return Math.min(...["--ink", "--muted"].flatMap((text) => ["--panel", "--well", "--chosen"].map((back) => {
        const [a, b] = [luminance(text), luminance(back)].sort((x, y) => y - x);
        return (a + 0.05) / (b + 0.05);
      })));
    });
    check(ratio >= 4.5, `${theme}: least contrast ${ratio.toFixed(2)}`);
  }
  await page.locator("#theme").click();
  check((await state(page)).theme === "dark", "the button switches");
  await page.screenshot({ path: "dark.png" });
  await page.emulateMedia({ colorScheme: "light" });
}

async function testNarrow() {
  const page = await open(`${base}.html`, { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true });
  await page.evaluate(() => viewer.go(0));
  const widths = await page.evaluate(() => ({
    scroll: document.documentElement.scrollWidth,
    window: innerWidth,
    out: [...document.querySelectorAll("button, select, input, canvas, td, dd, h1, p")]
      .filter((e) => e.offsetParent !== null && !e.closest(".spoken"))
      .filter((e) => {
        const r = e.getBoundingClientRect();
        return r.left < -0.5 || r.right > innerWidth + 0.5;
      })
      .map((e) => e.outerHTML.slice(0, 80)),
  }));
  check(widths.window === 390, `the window is ${widths.window} wide`);
  check(widths.scroll <= 390, `narrow: the page is ${widths.scroll} wide`);
  check(widths.out.length === 0, `narrow: outside of the window: ${widths.out}`);
  const canvas = await page.locator("#canvas").boundingBox();
  check(canvas.height >= 280 && canvas.width === 390, "narrow: the surface has room");
  await checkNumbers(page, 0, "narrow");
  await page.screenshot({ path: "narrow.png", fullPage: true });
  await page.context().close();
}

/** Browsers without a decompressor get the same numbers from ours. */
async function testOwnDecompression(page) {
  const sum = (p) => p.evaluate(() => {
    const { scene } = viewer;
    const arrays = [scene.faces, ...scene.positions.map((q) => q.filter((_, i) => i % 4 < 3)), ...scene.fields.flatMap((f) => f.values)];
    return arrays.reduce((h, a) => a.reduce((x, y) => (Math.imul(x, 31) + y) | 0, h), 7);
  });
  const other = await open(`${base}.html`, { before: () => delete window.DecompressionStream });
  check(await other.evaluate(() => typeof DecompressionStream === "undefined"), "the decompressor is gone");
  check((await sum(other)) === (await sum(page)), "both decompressors give the same");
  await other.context().close();
}

/** A page without a scene, and one in a browser that cannot draw, say so. */
async function testMessages() {
  const context = await browser.newContext({ reducedMotion: "reduce" });
  const page = await context.newPage();
  const html = readFileSync(`${base}.html`, "utf8").replace(/<script type="application\/json" id="scene">[^]*?<\/script>/, "");
  await page.setContent(html);
  await page.waitForSelector("#message:not([hidden])");
  check((await page.locator("#message").textContent()).includes("no scene in it"), "a page without a scene says so");
  await context.close();
  const flat = await browser.newContext({ reducedMotion: "reduce" });
  const other = await flat.newPage();
  await other.addInitScript(() => (HTMLCanvasElement.prototype.getContext = ((original) => function (kind, ...rest) {
    return kind === "2d" ? original.call(this, kind, ...rest) : null;
  })(HTMLCanvasElement.prototype.getContext)));
  await other.goto(pathToFileURL(resolve(`${base}.html`)).href);
  await other.waitForSelector("html[data-ready]");
  check((await other.locator("#message").textContent()).includes("cannot draw"), "no WebGL: a message");
  await other.evaluate(async () => (await animatedMeshFeatures.ready).state.set({ grouped: false }));
  await other.locator("#rows tr").nth(1).click();
  check((await other.locator("#details h2").textContent()) === "Feature 2", "no WebGL: the table works");
  await flat.close();
}

/** The scene for Blender and others (--glb), read and played by three.js. */
async function testGlb(viewerPage) {
  const { build } = await import("esbuild");
  const bundle = await build({ entryPoints: ["glb_reader.js"], bundle: true, format: "iife", write: false });
  const page = await (await browser.newContext()).newPage();
  page.on("pageerror", (error) => check(false, `GLB: ${error.message}`));
  page.on("console", (message) => check(!["error", "warning"].includes(message.type()), `GLB: console: ${message.text()}`));
  await page.setContent("<html></html>");
  await page.addScriptTag({ content: bundle.outputFiles[0].text });
  await page.evaluate((base64) => readGlb(base64), readFileSync(`${base}.glb`).toString("base64"));
  const glb = await page.evaluate(() => ({ ...glb, at: undefined }));
  const cache = readFileSync(`${base}.pc2`), n = cache.readInt32LE(16), frames = cache.readInt32LE(28);
  const d = result.animation.frame_duration, diagonal = result.animation.bounding_box_diagonal;
  check(glb.vertices === n, `GLB: ${glb.vertices} vertices`);
  near(glb.duration, (frames - 1) * d, 1e-5, "GLB: duration");
  check(glb.features.length === features.length, `GLB: ${glb.features.length} features`);
  for (const f of glb.features)
    for (const key of ["vertex", "frame", "time", "sigma", "tau", "radius", "strength", "amplitude", "fit", "place"])
      near(f[key], features[f.rank - 1][key], 1e-6 * Math.abs(features[f.rank - 1][key]), `GLB: ${key} of ${f.name}`);

  let alive = 0, gone = 0;
  for (const frame of [0, features[0].frame, features.at(-1).frame, frames - 1]) {
    const { points, spheres } = await page.evaluate((t) => glb.at(t), frame * d);
    let error = 0;
    for (let k = 0; k < 3 * n; ++k) error = Math.max(error, Math.abs(points[k] - cache.readFloatLE(32 + 4 * (3 * n * frame + k))));
    check(error < 1e-5 * diagonal, `GLB: frame ${frame} is off by ${error}`);
    await set(viewerPage, { time: frame * d, playing: false });
    for (const [i, { place: there, size }] of spheres.entries()) {
      const rank = glb.features[i].rank - 1, f = features[rank];
      const lives = frame === f.frame || Math.abs(frame * d - f.time) <= 2 * f.tau;
      check(lives === size > 1e-6 * f.radius, `GLB: feature ${rank} in frame ${frame} has size ${size}`);
      if (!lives) ++gone;
      if (!lives) continue;
      ++alive;
      near(distance(there, await place(viewerPage, rank)), 0, 1e-4 * diagonal, `GLB: place of feature ${rank} in frame ${frame}`);
    }
  }
  check(alive > 0 && gone > 0, `GLB: ${alive} times a feature was there, ${gone} times not`);
  console.log(`GLB: ${glb.vertices} vertices, ${glb.targets} morph targets, ${glb.features.length} features, read and played by three.js`);
  await page.context().close();
}

async function testMotion() {
  const page = await open(`${base}.html`, { reducedMotion: "no-preference" });
  await page.waitForFunction(() => viewer.state.values.time > 0.05, null, { timeout: 20000 });
  check((await state(page)).playing, "it starts to play by itself");
  await page.context().close();
  const still = await open(`${base}.html`);
  await still.waitForTimeout(300);
  check((await state(still)).time === 0, "not for those who prefer reduced motion");
  await still.context().close();
}

async function testLarge() {
  const bytes = statSync(`${large}.html`).size;
  check(bytes < 4e6, `the page of the large animation has ${bytes} bytes`);
  const page = await open(`${large}.html`);
  const { seconds, vertices, frames, count } = await page.evaluate(() => ({ seconds: viewer.secondsToReady, vertices: viewer.scene.vertices, frames: viewer.scene.frames, count: viewer.scene.features.length }));
  check(vertices * frames > 440000, `the large animation has ${vertices} vertices and ${frames} frames`);
  await page.waitForTimeout(500);
  await page.locator("#play").click();
  await page.waitForTimeout(1500);
  const rate = await page.evaluate(() => new Promise((done) => {
    const drawn = viewer.drawn, start = performance.now();
    setTimeout(() => done(((viewer.drawn - drawn) * 1000) / (performance.now() - start)), 3000);
  }));
  const share = await page.evaluate(() => viewer.stage.pixels);
  console.log(`${vertices} vertices, ${frames} frames, ${count} features: ${(bytes / 1e6).toFixed(2)} MB, interactive after ${seconds.toFixed(2)} s, ` +
    `${rate.toFixed(1)} frames a second in the software renderer at ${(100 * share).toFixed(0)} % of the pixels in each direction`);
  await page.context().close();
}

try {
  const page = await open(`${base}.html`);
  check((await page.title()).length > 0 && (await page.locator("#facts").textContent()).includes(`${features.length} feature`), "title and facts");
  await testData(page);
  await testTime(page);
  await testSelection(page);
  await testSpheres(page);
  await testThreshold(page);
  await testField(page);
  await testColors(page);
  await testKeyboard(page);
  await testNames(page);
  await testDark(page);
  await testOwnDecompression(page);
  await testPainting({ open, check, near, set, state, take, differentPixels, base, result });
  await page.screenshot({ path: "light.png" });
  await testInteraction({ open, check, near, set, state, take, differentPixels, base, result });
  if (existsSync(`${base}.glb`)) await testGlb(page);
  await testNarrow();
  await testMessages();
  await testMotion();
  if (pair && existsSync(`${pair}.html`)) await testPair({ open, check, near, set, state, pair });
  if (loops && existsSync(`${loops}.html`)) await testLoops({ open, check, near, set, loops });
  if (cyclic && existsSync(`${cyclic}.html`)) await testCyclic({ open, check, near, set, state, cyclic, frames: result.animation.frames });
  if (large && existsSync(`${large}.html`)) await testLarge();
} catch (error) {
  check(false, error.stack);
} finally {
  await browser.close();
}
console.log(`${checks} checks, ${failures} failed`);
process.exit(failures === 0 && checks > 0 ? 0 : 1);
