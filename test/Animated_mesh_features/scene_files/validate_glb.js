// Copyright (c) 2026 The Animated_mesh_features authors.
//
// This file is part of the package Animated_mesh_features for CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// node validate_glb.js MODULES FILE: the verdict of the Khronos validator, which is in the folder MODULES, on a GLB file.
// Any remark is a failure.

const fs = require("fs");
const path = require("path");

const [modules, file] = process.argv.slice(2);
const validator = require(path.resolve(modules, "gltf-validator"));

validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 20 }).then((report) => {
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  for (const m of messages) console.log(`severity ${m.severity}: ${m.code} at ${m.pointer}: ${m.message}`);
  console.log(
    `gltf-validator ${report.validatorVersion}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ` +
      `${numHints} hints; ${report.info.animationCount} animation, ${report.info.totalVertexCount} vertices`,
  );
  process.exit(numErrors + numWarnings + numInfos + numHints === 0 && report.info.animationCount === 1 ? 0 : 1);
});
