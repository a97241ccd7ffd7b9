// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// node build.mjs [OUTPUT]: the viewer's page from its sources, as one file, and its checksum on the standard output.
// The same sources with the packages of package-lock.json give the same bytes everywhere.

import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build, transform } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const read = (path) => readFileSync(join(here, path), "utf8");

// Browsers of 2022 and later: all that have WebGL 2.
const target = ["es2021", "chrome100", "firefox100", "safari15.4"];

const bundle = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.js"],
  bundle: true,
  minify: true,
  format: "iife",
  target,
  legalComments: "inline",
  charset: "ascii",
  write: false,
});
const style = await transform(read("src/style.css"), { loader: "css", minify: true, target });

// A script ends at "</script", wherever that is.
const program = bundle.outputFiles[0].text.replaceAll("</script", "<\\/script");
const parts = {
  "/*style*/": style.code.trim(),
  "<!--three-licence-->": read("node_modules/three/LICENSE").trim().replaceAll("<", "&lt;"),
  "/*program*/": program.trim(),
};
let page = read("src/page.html");
for (const [place, text] of Object.entries(parts)) {
  const pieces = page.split(place);
  if (pieces.length !== 2) throw new Error(`page.html has ${pieces.length - 1} places for ${place}`);
  page = pieces.join(text);
}
if (page.split("<!--scene-->").length !== 2) throw new Error("the page must have exactly one place for a scene");

if (process.argv[2]) writeFileSync(process.argv[2], page);
console.log(createHash("sha256").update(page).digest("hex"));
